#include "cli.hpp"

#include <CLI/CLI.hpp>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <map>
#include <new>

#include "changeover/core/error.hpp"
#include "changeover/core/version.hpp"
#include "changeover/io/output_file.hpp"

namespace changeover::cli {
namespace {

int complain(int code, const std::string& message) {
  // One line, whatever the message holds.
  std::string line = "changeover: " + message;
  for (char& c : line) {
    c = c == '\n' ? ' ' : c;
  }
  line += '\n';
  std::fputs(line.c_str(), stderr);
  return code;
}

int answer(const std::string& text) {
  if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0) {
    return complain(exit_code::missing_resource,
                    std::string("cannot write to standard output: ") + std::strerror(errno));
  }
  return exit_code::done;
}

// The parser's own words, made to say where help is.
std::string usage_message(const CLI::ParseError& fault, const CLI::App& verb) {
  std::string message = fault.what();
  while (!message.empty() && (message.back() == '\n' || message.back() == '.')) {
    message.pop_back();
  }
  const std::string name = verb.get_parent() == nullptr ? "" : " " + verb.get_name();
  return message + "; see changeover" + name + " --help";
}

// The parser would take "99999999999999999999" for the largest number that it knows.
std::string whole_number_defect(const std::string& given) {
  std::uint64_t value = 0;
  const char* const end = given.data() + given.size();
  const auto [rest, failure] = std::from_chars(given.data(), end, value);
  if (failure == std::errc::result_out_of_range) {
    return given + " is too large a number";
  }
  return failure == std::errc() && rest == end ? std::string()
                                               : "'" + given + "' is not a whole number";
}

}  // namespace

struct Verb::State {
  CLI::App* app = nullptr;
  std::function<int()>
      action;  // runs after parsing, so that its faults are not taken for the parser's
  std::map<const CLI::Option*, std::vector<std::string>> words;  // of choices, for completion
};

struct Program::State {
  CLI::App app{
      "Finds, proves, draws and runs change covering designs: ordered lists of k-element blocks "
      "over v "
      "items in which every pair meets and consecutive blocks differ in exactly m items.",
      "changeover"};
  std::vector<std::unique_ptr<Verb>> verbs;
};

Verb::Verb(std::unique_ptr<State> state) : state_(std::move(state)) {}
Verb::~Verb() = default;

void Verb::positional(const std::string& name, std::uint64_t& value, const std::string& help) {
  state_->app->add_option(name, value, help)
      ->required()
      ->option_text("NUMBER")
      ->check(whole_number_defect, "");
}

void Verb::positional(const std::string& name, std::string& value, const std::string& help,
                      bool required) {
  state_->app->add_option(name, value, help)->required(required)->option_text(" ");
}

void Verb::positional(const std::string& name, std::optional<std::uint64_t>& value,
                      const std::string& help) {
  state_->app->add_option(name, value, help)->option_text("NUMBER")->check(whole_number_defect, "");
}

void Verb::option(const std::string& flags, std::optional<std::uint64_t>& value,
                  const std::string& what, const std::string& help) {
  state_->app->add_option(flags, value, help)->option_text(what)->check(whole_number_defect, "");
}

void Verb::option(const std::string& flags, std::string& value, const std::string& what,
                  const std::string& help) {
  state_->app->add_option(flags, value, help)->option_text(what);
}

void Verb::choice(const std::string& flags, std::string& value,
                  const std::vector<std::string>& words, const std::string& help) {
  std::string all;
  for (const std::string& word : words) {
    all += (all.empty() ? "" : "|") + word;
  }
  CLI::Option* option = state_->app->add_option(flags, value, help);
  option->option_text(all);
  option->check(
      [words, all](const std::string& given) {
        for (const std::string& word : words) {
          if (word == given) {
            return std::string();
          }
        }
        return "'" + given + "' is not one of " + all;
      },
      "");
  state_->words[option] = words;
}

void Verb::flag(const std::string& flags, bool& value, const std::string& help) {
  state_->app->add_flag(flags, value, help);
}

void Verb::examples(const std::vector<std::string>& lines) {
  std::string text = "Examples:";
  for (const std::string& line : lines) {
    text += "\n  " + line;
  }
  state_->app->footer(text);
}

void Verb::run(std::function<int()> action) { state_->action = std::move(action); }

Program::Program() : state_(std::make_unique<State>()) {
  CLI::App& app = state_->app;
  app.require_subcommand(1);
  app.set_version_flag("--version", "changeover " + std::string(changeover::version));
  app.footer(
      "Exit codes: 0 done or valid; 1 the claim was refuted; 2 usage; 3 bad input; 4 nothing "
      "serves\n"
      "these parameters, or a file, memory or disk space is missing; 5 a bug of ours. Searches:\n"
      "10 found, 20 proved that there is none, 30 stopped by a limit before that was known.\n"
      "changeover VERB --help shows options and examples.");
}

Program::~Program() = default;

Verb& Program::add(const std::string& name, const std::string& summary) {
  auto state = std::make_unique<Verb::State>();
  state->app = state_->app.add_subcommand(name, summary);
  state_->verbs.push_back(std::unique_ptr<Verb>(new Verb(std::move(state))));
  return *state_->verbs.back();
}

int Program::run(int argc, char** argv) {
  CLI::App& app = state_->app;
  if (argc == 1) {
    std::fputs(app.help().c_str(), stderr);
    return exit_code::usage;
  }
  remove_unfinished_outputs_on_signals();
  const auto chosen = [&]() -> const CLI::App& {
    const auto verbs = app.get_subcommands();
    return verbs.empty() ? app : *verbs.front();
  };
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {  // --help, --version
    const bool help = dynamic_cast<const CLI::CallForHelp*>(&request) != nullptr;
    return answer((help ? app.help() : std::string(request.what())) + "\n");
  } catch (const CLI::ParseError& fault) {
    return complain(exit_code::usage, usage_message(fault, chosen()));
  }
  try {
    for (const auto& verb : state_->verbs) {
      if (verb->state_->app == &chosen()) {
        return verb->state_->action();
      }
    }
    throw InternalError("a verb without an action");
  } catch (const UsageError& fault) {
    return complain(exit_code::usage,
                    fault.message + "; see changeover " + chosen().get_name() + " --help");
  } catch (const ImpossibleParameters& fault) {
    return complain(exit_code::usage, fault.what());
  } catch (const BadInput& fault) {
    return complain(exit_code::bad_input, fault.what());
  } catch (const MissingResource& fault) {
    return complain(exit_code::missing_resource, fault.what());
  } catch (const std::bad_alloc&) {
    return complain(exit_code::missing_resource, "not enough memory for these parameters");
  } catch (const InternalError& fault) {
    return complain(exit_code::bug,
                    std::string("a bug of ours, please report it: ") + fault.what());
  } catch (const std::exception& fault) {
    return complain(exit_code::bug,
                    std::string("a bug of ours, please report it: ") + fault.what());
  }
}

std::string Program::bash_completion() const {
  std::string verbs;
  std::string cases;
  std::string values;
  for (const auto& entry : state_->verbs) {
    const CLI::App* verb = entry->state_->app;
    verbs += (verbs.empty() ? "" : " ") + verb->get_name();
    std::string options;
    for (const CLI::Option* option : verb->get_options()) {
      std::string names;
      for (const std::string& name : option->get_lnames()) {
        options += " --" + name;
        names += (names.empty() ? "--" : "|--") + name;
      }
      for (const std::string& name : option->get_snames()) {
        names += "|-" + name;
      }
      const auto found = entry->state_->words.find(option);
      if (found != entry->state_->words.end()) {
        std::string words;
        for (const std::string& word : found->second) {
          words += " " + word;
        }
        if (names.empty()) {  // a positional: offered with the options
          options += words;
        } else {
          values += "    " + verb->get_name() + ":" + names.substr(0, names.find('|')) +
                    ") words=\"" + words.substr(1) + "\" ;;\n";
        }
      }
    }
    cases += "    " + verb->get_name() + ") words=\"" + (options.empty() ? "" : options.substr(1)) +
             "\" ;;\n";
  }
  return "# Completion for bash: source this file, or put it into bash_completion.d.\n"
         "_changeover() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} words=\n"
         "  COMPREPLY=()\n"
         "  if [[ $COMP_CWORD -eq 1 ]]; then\n"
         "    COMPREPLY=($(compgen -W \"" +
         verbs +
         " --help --version\" -- \"$current\"))\n"
         "    return\n"
         "  fi\n"
         "  case ${COMP_WORDS[1]}:$previous in\n" +
         values +
         "    *:-o|*:--output) COMPREPLY=($(compgen -f -- \"$current\")); return ;;\n"
         "  esac\n"
         "  if [[ -z $words ]]; then\n"
         "    if [[ $current != -* ]]; then COMPREPLY=($(compgen -f -- \"$current\")); fi\n"
         "    case ${COMP_WORDS[1]} in\n" +
         cases +
         "    esac\n"
         "  fi\n"
         "  COMPREPLY+=($(compgen -W \"$words\" -- \"$current\"))\n"
         "}\n"
         "complete -F _changeover changeover\n";
}

}  // namespace changeover::cli
