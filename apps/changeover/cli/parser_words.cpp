#include "cli/parser_words.hpp"

#include <cctype>
#include <map>

#include "cli/spelling.hpp"
#include "core/each.hpp"

namespace changeover::cli {
namespace {

// What is wrong with the values of an option; only the parser's words say it.
std::string mismatch_message(const std::string& words) {
  const auto has = [&](const char* part) { return words.find(part) != std::string::npos; };
  return (words.starts_with('-') ? "" : "--") + words.substr(0, words.find_first_of(": ")) +
         (has("flag override") ? ": it takes no value; leave the value out"
          : has("At Most")     ? ": it is given more than once; give it once"
                               : ": a value is missing; give one");
}

}  // namespace

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names = each_of<std::string>(
      option.get_snames(), [&](const std::string& name) { return "-" + name; });
  for (const std::string& name : option.get_lnames()) {
    names.push_back("--" + name);
  }
  return names;
}

std::string usage_message(const CLI::ParseError& fault, const CLI::App& verb) {
  std::string message = fault.what();
  while (!message.empty() && (message.back() == '\n' || message.back() == '.')) {
    message.pop_back();
  }
  if (dynamic_cast<const CLI::ExtrasError*>(&fault) != nullptr) {
    message = message.substr(message.find(": ") + 2) + ": too many arguments; leave this out";
  } else if (dynamic_cast<const CLI::ArgumentMismatch*>(&fault) != nullptr) {
    message = mismatch_message(message);
  }
  const std::string name = verb.get_parent() == nullptr ? "" : " " + verb.get_name();
  return with_help(message, as_typed(name));
}

std::string misspelt(const CLI::App& program, int argc, char** argv) {
  if (argc < 2) {
    return {};
  }
  const std::string verb_name = argv[1];
  if (verb_name == "-h" || verb_name == "--help") {
    return {};
  }
  if (verb_name.starts_with('-')) {
    return "there is no option " + verb_name + " before a verb; see changeover --help";
  }
  const CLI::App* verb = nullptr;
  std::vector<std::string> verbs;
  for (const CLI::App* each : program.get_subcommands({})) {
    verb = each->get_name() == verb_name ? each : verb;
    verbs.push_back(each->get_name());
  }
  if (verb == nullptr) {
    return with_help("there is no verb '" + verb_name + "'" + did_you_mean(verb_name, verbs), "");
  }
  std::map<std::string, bool> takes_value;
  std::vector<std::string> known;
  for (const CLI::Option* option : verb->get_options()) {
    for (const std::string& name : names_of(*option)) {
      takes_value[name] = option->get_items_expected_max() > 0;
      known.push_back(name);
    }
  }
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--") {
      break;
    }
    const bool is_long = word.size() > 2 && word.starts_with("--");
    const bool is_short =
        !is_long && word.size() > 1 && word[0] == '-' && (std::isalpha(word[1]) != 0);
    if (!is_long && !is_short) {
      continue;
    }
    const std::string name = is_long ? word.substr(0, word.find('=')) : word.substr(0, 2);
    const auto found = takes_value.find(name);
    if (found == takes_value.end()) {
      return with_help(as_typed(verb_name) + " has no option " + name + did_you_mean(name, known),
                       " " + as_typed(verb_name));
    }
    if (found->second && word.size() == name.size()) {
      ++i;  // its value
    }
  }
  return {};
}

}  // namespace changeover::cli
