// What was meant by a word that is not known.
#pragma once

#include <string>
#include <vector>

namespace changeover::cli {

/// ", did you mean design?" if a known word is near enough; else nothing.
[[nodiscard]] std::string did_you_mean(const std::string& word,
                                       const std::vector<std::string>& known);

/// The message and where help is: "…; see changeover design --help" for " design". There is no
/// semicolon behind a question.
[[nodiscard]] std::string with_help(const std::string& message, const std::string& verb);

/// A verb as it is typed: one of a group, "catalog-show", is two words.
[[nodiscard]] std::string as_typed(std::string name);

}  // namespace changeover::cli
