// Scripts by which shells complete command lines of the program, made of what it knows of its
// verbs.
//
//     completion_script(program, Shell::zsh);          // begins with "#compdef changeover"
//
// Each knows the verbs, those of groups too, the options, the words that an option takes, and where
// a file or a folder is wanted; zsh and fish show the help of each. Where a number or a name is
// wanted nothing is offered.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/cli.hpp"

namespace changeover::cli {

enum class Shell : std::uint8_t { bash, zsh, fish };

[[nodiscard]] const std::vector<std::string>& shell_names();
[[nodiscard]] std::optional<Shell> shell_from_string(std::string_view name);

[[nodiscard]] std::string completion_script(const Program& program, Shell shell);

}  // namespace changeover::cli
