#include "shell/completion.hpp"

#include <algorithm>

namespace changeover::cli {

const std::vector<std::string>& shell_names() {
  static const std::vector<std::string> names{"bash", "zsh", "fish"};
  return names;
}

std::optional<Shell> shell_from_string(std::string_view name) {
  const auto found = std::ranges::find(shell_names(), name);
  return found == shell_names().end()
             ? std::nullopt
             : std::optional(static_cast<Shell>(found - shell_names().begin()));
}

std::string completion_script(const Program& program, Shell shell) {
  switch (shell) {
    case Shell::bash:
      return bash_completion(program);
    case Shell::zsh:
      return zsh_completion(program);
    case Shell::fish:
      return fish_completion(program);
  }
  return {};
}

std::string shell_quoted(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

std::vector<VerbDescription> first_words(const Program& program) {
  std::vector<VerbDescription> words;
  const std::vector<GroupDescription> groups = program.groups();
  for (VerbDescription& verb : program.verbs()) {
    const std::string group = verb.group();
    if (group.empty()) {
      words.push_back(std::move(verb));
    } else if (std::ranges::find(words, group, &VerbDescription::name) == words.end()) {
      const auto found = std::ranges::find(groups, group, &GroupDescription::name);
      words.push_back({.name = group,
                       .summary = found == groups.end() ? group : found->summary,
                       .options = {},
                       .rules = {},
                       .examples = {}});
    }
  }
  return words;
}

std::vector<VerbDescription> members_of(const Program& program, std::string_view group) {
  std::vector<VerbDescription> members = program.verbs();
  std::erase_if(members, [&](const VerbDescription& verb) { return verb.group() != group; });
  return members;
}

}  // namespace changeover::cli
