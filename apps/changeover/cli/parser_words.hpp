// What the parser of options says, in our words.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace changeover::cli {

/// "--change", "-m", … of an option; nothing for a positional.
[[nodiscard]] std::vector<std::string> names_of(const CLI::Option& option);

/// The parser's own words, made to say where help is.
[[nodiscard]] std::string usage_message(const CLI::ParseError& fault, const CLI::App& verb);

/// What is wrong with the first word that is no verb or no option of its verb; "" if none is. The
/// parser complains of what is missing before what is misspelt, and cannot guess what was meant.
[[nodiscard]] std::string misspelt(const CLI::App& program, int argc, char** argv);

}  // namespace changeover::cli
