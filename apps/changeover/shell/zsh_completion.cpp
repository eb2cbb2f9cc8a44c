#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>

#include "core/each.hpp"
#include "shell/completion.hpp"

namespace changeover::cli {
namespace {

std::string without(std::string_view text, std::string_view special) {
  std::string out;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) {
      out += '\\';
    }
    out += c;
  }
  return out;
}

// ":FILE:_files", as _arguments reads it: a message, and what is offered.
std::string value_of(const OptionDescription& each) {
  const std::string message =
      without(each.positional ? each.names.front() + ", " + each.help : each.value, ":\\");
  const std::string action = each.kind == "file"     ? "_files"
                             : each.kind == "folder" ? "_files -/"
                             : !each.words.empty() ? fmt::format("({})", fmt::join(each.words, " "))
                                                   : " ";
  return ":" + (message.empty() ? "word" : message) + ":" + action;
}

std::string spec_of(const OptionDescription& each) {
  if (each.positional) {
    return shell_quoted((each.repeats ? "*" : each.required ? "" : ":") + value_of(each));
  }
  const bool takes_value = each.kind != "flag";
  std::string tail = "[" + without(each.help, "[]\\") + "]";
  if (takes_value) {
    tail += value_of(each);
  }
  // A long option takes its value after = too, a short one in the same word.
  const std::string names = joined(each.names, ",", [&](const std::string& name) {
    return name + (!takes_value ? "" : name.starts_with("--") ? "=" : "+");
  });
  if (each.names.size() == 1) {
    return shell_quoted(names + tail);
  }
  return shell_quoted(fmt::format("({})", fmt::join(each.names, " "))) + "{" + names + "}" +
         shell_quoted(tail);
}

std::string verb_case(const VerbDescription& verb, const std::string& name) {
  std::string text = fmt::format("        {})\n          _arguments -S \\\n", name);
  for (const OptionDescription& each : verb.options) {
    text += "            " + spec_of(each) + " \\\n";
  }
  return text + "            '(- *)'{-h,--help}'[options and examples]' ;;\n";
}

// A list of "name:summary" for _describe.
std::string described(const std::vector<VerbDescription>& verbs) {
  std::string text;
  for (const VerbDescription& verb : verbs) {
    const std::string group = verb.group();
    const std::string name = group.empty() ? verb.name : verb.name.substr(group.size() + 1);
    text += "    " + shell_quoted(without(name, ":\\") + ":" + without(verb.summary, "\\")) + "\n";
  }
  return text;
}

constexpr const char* version_words =
    "  if [[ $CURRENT -eq 3 && $words[2] == --version ]]; then\n"
    "    compadd -- --json\n"
    "    return\n"
    "  fi\n";

// A function that completes one of some verbs, and then its words.
std::string verbs_function(const std::string& name, const std::vector<VerbDescription>& verbs,
                           const std::string& options) {
  std::string cases;
  for (const VerbDescription& verb : verbs) {
    const std::string group = verb.group();
    const std::string typed = group.empty() ? verb.name : verb.name.substr(group.size() + 1);
    cases += verb.options.empty() && group.empty() && name == "_changeover"
                 ? fmt::format("        {0}) _changeover_{0} ;;\n", typed)
                 : verb_case(verb, typed);
  }
  return name + "() {\n" + (name == "_changeover" ? version_words : "") +
         "  local curcontext=$curcontext state line\n"
         "  typeset -A opt_args\n"
         "  local -a verbs=(\n" +
         described(verbs) + "  )\n  _arguments -C " + options +
         " '1: :->verb' '*:: :->rest'\n"
         "  case $state in\n"
         "    verb) _describe -t commands verb verbs ;;\n"
         "    rest)\n"
         "      case $words[1] in\n" +
         cases +
         "      esac ;;\n"
         "  esac\n"
         "}\n";
}

}  // namespace

std::string zsh_completion(const Program& program) {
  std::string text =
      "#compdef changeover\n"
      "# Completion for zsh: put this file into a folder of $fpath as _changeover, or source it.\n";
  for (const GroupDescription& group : program.groups()) {
    text += verbs_function("_changeover_" + group.name, members_of(program, group.name),
                           "'(- *)'{-h,--help}'[the verbs]'");
  }
  return text +
         verbs_function("_changeover", first_words(program),
                        "'(- *)'{-h,--help}'[the verbs]' "
                        "'(- *)--version[the version, and what it was built with]'") +
         "if [[ $funcstack[1] == _changeover ]]; then\n"
         "  _changeover \"$@\"\n"
         "else\n"
         "  compdef _changeover changeover\n"
         "fi\n";
}

}  // namespace changeover::cli
