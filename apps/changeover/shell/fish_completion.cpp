#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>

#include "shell/completion.hpp"

namespace changeover::cli {
namespace {

// In single quotes, where fish knows \\ and \'.
std::string fish_quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    out += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  }
  return out + "'";
}

std::string offer_of(const OptionDescription& each) {
  return !each.words.empty() ? " -xa " + fish_quoted(fmt::format("{}", fmt::join(each.words, " ")))
         : each.kind == "file"   ? " -rF"
         : each.kind == "folder" ? " -xa '(__fish_complete_directories)'"
         : each.kind == "flag"   ? ""
                                 : " -x";
}

std::string verb_lines(const VerbDescription& verb) {
  const std::string begin =
      "complete -c changeover -n " + fish_quoted("__changeover_is " + verb.typed());
  std::string text;
  bool files = false;
  for (const OptionDescription& each : verb.options) {
    if (each.positional) {
      files = files || each.kind == "file";
      if (!each.words.empty()) {
        text += begin + " -a " + fish_quoted(fmt::format("{}", fmt::join(each.words, " "))) +
                " -d " + fish_quoted(each.help) + "\n";
      }
      continue;
    }
    std::string names;
    for (const std::string& name : each.names) {
      names += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    text += begin + names + offer_of(each) + " -d " + fish_quoted(each.help) + "\n";
  }
  if (files) {
    text += begin + " -F\n";
  }
  return text + begin + " -s h -l help -d 'options and examples'\n";
}

}  // namespace

std::string fish_completion(const Program& program) {
  std::string text =
      "# Completion for fish: source this file, or put it into a folder of $fish_complete_path as "
      "changeover.fish.\n"
      "function __changeover_is\n"
      "  set -l words (commandline -opc)\n"
      "  set -l count (math (count $argv) + 1)\n"
      "  test (count $words) -ge $count; and test \"$words[2..$count]\" = \"$argv\"\n"
      "end\n"
      "function __changeover_only\n"
      "  set -l words (commandline -opc)\n"
      "  test \"$words[2..-1]\" = \"$argv\"\n"
      "end\n"
      "complete -c changeover -e\n"
      "complete -c changeover -f\n"
      "complete -c changeover -n '__changeover_only' -s h -l help -d 'the verbs'\n"
      "complete -c changeover -n '__changeover_only' -l version -d 'the version, and what it was "
      "built with'\n"
      "complete -c changeover -n '__changeover_only --version' -l json -d 'the same as JSON'\n";
  for (const VerbDescription& verb : first_words(program)) {
    text += "complete -c changeover -n '__changeover_only' -a " + verb.name + " -d " +
            fish_quoted(verb.summary) + "\n";
  }
  for (const GroupDescription& group : program.groups()) {
    for (const VerbDescription& verb : members_of(program, group.name)) {
      text +=
          fmt::format("complete -c changeover -n '__changeover_only {}' -a {} -d {}\n", group.name,
                      verb.name.substr(group.name.size() + 1), fish_quoted(verb.summary));
    }
    text += fmt::format(
        "complete -c changeover -n '__changeover_only {}' -s h -l help -d 'the verbs'\n",
        group.name);
  }
  for (const VerbDescription& verb : program.verbs()) {
    text += verb_lines(verb);
  }
  return text;
}

}  // namespace changeover::cli
