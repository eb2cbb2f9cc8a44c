// What was meant by a word that is not known.
#pragma once

#include <string>
#include <vector>

namespace changeover::cli {

/// ", did you mean design?" if a known word is near enough; else nothing.
[[nodiscard]] std::string did_you_mean(const std::string& word,
                                       const std::vector<std::string>& known);

/// A verb as it is typed: one of a group, "catalog-show", is two words.
[[nodiscard]] std::string as_typed(std::string name);

}  // namespace changeover::cli
