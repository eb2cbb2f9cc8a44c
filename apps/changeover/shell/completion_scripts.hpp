// What the completion scripts of the shells share; completion.hpp is for everybody else.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/cli.hpp"

namespace changeover::cli {

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
