#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "core/each.hpp"
#include "shell/completion.hpp"

namespace changeover::cli {
namespace {

std::string names_of(const std::vector<VerbDescription>& verbs) {
  return joined(verbs, " ", [](const VerbDescription& verb) {
    return verb.group().empty() ? verb.name : verb.name.substr(verb.group().size() + 1);
  });
}

bool wants_file(const OptionDescription& each) { return each.kind == "file"; }

// What stands after an option that takes a value.
std::string value_case(const VerbDescription& verb, const OptionDescription& each) {
  const std::string patterns =
      joined(each.names, "|", [&](const std::string& name) { return verb.name + ":" + name; });
  const std::string offered = !each.words.empty()
                                  ? fmt::format("-W \"{}\"", fmt::join(each.words, " "))
                              : wants_file(each)      ? "-f"
                              : each.kind == "folder" ? "-d"
                                                      : "";
  return fmt::format("    {}) {}return ;;\n", patterns,
                     offered.empty() ? "" : "__changeover_offer " + offered + "; ");
}

std::string verb_case(const VerbDescription& verb) {
  std::vector<std::string> words;
  std::vector<std::string> options{"--help"};
  bool files = false;
  for (const OptionDescription& each : verb.options) {
    if (each.positional) {
      files = files || wants_file(each);
      words.insert(words.end(), each.words.begin(), each.words.end());
    } else {
      std::ranges::copy_if(each.names, std::back_inserter(options),
                           [](const std::string& name) { return name.starts_with("--"); });
    }
  }
  return fmt::format("    {}) words=\"{}\" files={} options=\"{}\" ;;\n", verb.name,
                     fmt::join(words, " "), files ? "yes" : "no", fmt::join(options, " "));
}

}  // namespace

std::string bash_completion(const Program& program) {
  std::string groups;
  for (const GroupDescription& group : program.groups()) {
    groups += fmt::format(
        "    {0})\n"
        "      if [[ $COMP_CWORD -eq 2 ]]; then\n"
        "        __changeover_offer -W \"{1} --help\"\n"
        "        return\n"
        "      fi\n"
        "      verb+=-${{COMP_WORDS[2]}} ;;\n",
        group.name, names_of(members_of(program, group.name)));
  }
  std::string values;
  std::string verbs;
  for (const VerbDescription& verb : program.verbs()) {
    for (const OptionDescription& each : verb.options) {
      if (!each.positional && each.kind != "flag") {
        values += value_case(verb, each);
      }
    }
    verbs += verb_case(verb);
  }
  return "# Completion for bash: source this file, or put it into "
         "share/bash-completion/completions as changeover.\n"
         "__changeover_offer() {\n"
         "  local offered\n"
         "  mapfile -t offered < <(compgen \"$@\" -- \"$current\")\n"
         "  COMPREPLY+=(\"${offered[@]}\")\n"
         "  [[ $1 == -W ]] || compopt -o filenames 2>/dev/null\n"
         "}\n"
         "_changeover() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} words= "
         "files=no options=\n"
         "  COMPREPLY=()\n"
         "  if [[ $COMP_CWORD -eq 1 ]]; then\n"
         "    __changeover_offer -W \"" +
         names_of(first_words(program)) +
         " --help --version\"\n"
         "    return\n"
         "  fi\n"
         "  # --option=value comes as three words.\n"
         "  if [[ $current == = ]]; then\n"
         "    current=\n"
         "  elif [[ $previous == = ]]; then\n"
         "    previous=${COMP_WORDS[COMP_CWORD-2]}\n"
         "  fi\n"
         "  local verb=${COMP_WORDS[1]}\n"
         "  case $verb in\n"
         "    --version) __changeover_offer -W --json; return ;;\n" +
         groups +
         "  esac\n"
         "  case $verb:$previous in\n" +
         values +
         "  esac\n"
         "  case $verb in\n" +
         verbs +
         "  esac\n"
         "  if [[ $current != -* ]]; then\n"
         "    __changeover_offer -W \"$words\"\n"
         "    [[ $files == no ]] || __changeover_offer -f\n"
         "  fi\n"
         "  if [[ ${#COMPREPLY[@]} -eq 0 && $files == no || $current == -* ]]; then\n"
         "    __changeover_offer -W \"$options\"\n"
         "  fi\n"
         "}\n"
         "complete -F _changeover changeover\n";
}

}  // namespace changeover::cli
