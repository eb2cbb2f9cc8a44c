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

// What the completion scripts of the shells share; completion.hpp is for everybody else.

[[nodiscard]] std::string bash_completion(const Program& program);
[[nodiscard]] std::string zsh_completion(const Program& program);
[[nodiscard]] std::string fish_completion(const Program& program);

/// In single quotes, as bash and zsh read them.
[[nodiscard]] std::string shell_quoted(std::string_view text);

/// What may stand after `changeover`: the verbs that are in no group, and the groups, which have no
/// options.
[[nodiscard]] std::vector<VerbDescription> first_words(const Program& program);

/// The verbs of a group.
[[nodiscard]] std::vector<VerbDescription> members_of(const Program& program,
                                                      std::string_view group);

}  // namespace changeover::cli
