#include "cli/cli.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <new>
#include <stdexcept>
#include <system_error>

#include "answer/answer.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/output.hpp"
#include "changeover/run/control.hpp"
#include "cli/ending.hpp"
#include "cli/parser_words.hpp"
#include "cli/spelling.hpp"
#include "cli/status_line.hpp"
#include "cli/terminal.hpp"
#include "core/each.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/request/request_words.hpp"
#include "request/output.hpp"
#include "shell/features.hpp"

namespace changeover::cli {
namespace {

// One line on stderr, whatever the message holds.
int complain(int code, const std::string& message) {
  constexpr std::size_t longest = 1000;
  std::string line = "changeover: " + message;
  std::ranges::replace(line, '\n', ' ');
  line = printable(line);
  if (line.size() > longest) {
    std::size_t end = longest;
    while ((static_cast<unsigned char>(line[end]) & 0xc0U) == 0x80U) {  // within a character
      --end;
    }
    line.resize(end);
    line += " … (shortened)";
  }
  status_line().say(line);
  return code;
}

// Runs what makes an answer and delivers it; what goes wrong becomes one line and an exit code.
// `delivered` is set if nothing did.
int answer(const std::function<Answer()>& make, const std::string& verb,
           bool* delivered = nullptr) {
  const auto usage = [&verb](const std::string& message) {
    return complain(exit_code::usage, with_help(message, " " + as_typed(verb)));
  };
  try {
    const int code = deliver(make());
    if (delivered != nullptr) {
      *delivered = true;
    }
    return code;
  } catch (const UsageError& fault) {
    return usage(fault.message);
  } catch (const BadOption& fault) {  // the command line said so, not the file
    return usage(fault.what());
  } catch (const ImpossibleParameters& fault) {
    const std::string what = fault.what();
    // A reason why no such design exists needs no remedy.
    const bool is_whole = what.starts_with("there is no") || what.find(';') != std::string::npos;
    return is_whole ? complain(exit_code::usage, what) : usage(what);
  } catch (const BadInput& fault) {
    return complain(exit_code::bad_input, fault.what());
  } catch (const MissingResource& fault) {
    if (dynamic_cast<const ReaderGone*>(&fault) != nullptr) {
      leave_with_the_reader();
    }
    return complain(exit_code::missing_resource, fault.what());
  } catch (const Stopped& stopped) {
    return complain(exit_code::limit_reached, "stopped (" + std::string(to_string(stopped.why())) +
                                                  ") before anything was found");
  } catch (const std::bad_alloc&) {
    return complain(exit_code::missing_resource,
                    "not enough memory for these parameters; give smaller ones");
  } catch (const std::length_error&) {
    return complain(exit_code::missing_resource,
                    "not enough memory for these parameters; give smaller ones");
  } catch (const std::system_error& fault) {  // of files, threads, …
    return complain(exit_code::missing_resource, fault.what());
  } catch (const std::exception& fault) {
    return complain(exit_code::bug,
                    std::string("a bug of ours, please report it: ") + fault.what());
  }
}

// The verbs of a group, without its name.
std::vector<std::string> members_of(const CLI::App& program, const std::string& group) {
  std::vector<std::string> members;
  for (const CLI::App* each : program.get_subcommands({})) {
    if (each->get_name().starts_with(group + "-")) {
      members.push_back(each->get_name().substr(group.size() + 1));
    }
  }
  return members;
}

// The parser would take "99999999999999999999" for the largest number that it knows.
std::string whole_number_defect(const std::string& given) {
  std::uint64_t value = 0;
  const char* const end = given.data() + given.size();
  const auto [rest, failure] = std::from_chars(given.data(), end, value);
  if (failure == std::errc::result_out_of_range) {
    return given + " is too large; give at most 18446744073709551615";
  }
  if (failure == std::errc() && rest == end) {
    return "";
  }
  if (given.size() > 1 && given[0] == '-' &&
      std::all_of(given.begin() + 1, given.end(), is_digit)) {
    return "'" + given + "' is below 0; give a whole number, 0 or more";
  }
  // "1e3", "4.0": the number that is meant, in digits.
  double meant = -1;
  const auto [stop, bad] = std::from_chars(given.data(), end, meant);
  constexpr double most = 1e15;  // every whole number up to it is a double
  if (bad == std::errc() && stop == end && meant >= 0 && meant <= most &&
      std::floor(meant) == meant) {
    return fmt::format("'{}' is not written in digits alone; write {:.0f}", given, meant);
  }
  return "'" + given + "' is not a whole number";
}

// Whatever the verb, its answer must not replace the user's designs.
void check_output(const CLI::App& verb) {
  const auto given = [&verb](const std::string& name) {
    const CLI::Option* const option = verb.get_option_no_throw(name);
    return option != nullptr && option->count() > 0 ? option->as<std::string>() : std::string();
  };
  const std::string output = given("--output");
  const std::string catalog = given("--catalog");
  check_kept(output, {"your catalog", catalog.empty() ? standard_catalog_file() : catalog});
}

// What is to be given, from its name in the help: FILE, DIR, DURATION, SIZE, A..B.
std::string kind_of_value(const std::string& what) {
  return what == "FILE"                         ? "file"
         : what == "DIR"                        ? "folder"
         : what == "DURATION"                   ? "duration"
         : what == "SIZE"                       ? "size"
         : what.find("..") != std::string::npos ? "range"
                                                : "text";
}

// The same for an argument: most are files.
std::string kind_of_argument(const std::string& name) {
  static const std::vector<std::string> words{"LABEL", "CELL", "WORD", "K", "VERB"};
  return std::ranges::find(words, name) == words.end() ? "file" : "text";
}

}  // namespace

struct Verb::State {
  struct Kind {
    std::string name;                     // number, text, file, …
    std::vector<std::string> words = {};  // of a choice
  };

  CLI::App* app = nullptr;
  // Runs after parsing, so that its faults are not taken for the parser's.
  std::function<Answer()> action;
  std::vector<std::function<void()>> rules;       // throw UsageError, before that
  std::map<const CLI::Option*, Kind> kinds = {};  // flags have none
  std::vector<std::string> sentences = {};        // what the rules say
  std::vector<std::string> examples = {};
  std::vector<ExitCodeDescription> outcomes = {{exit_code::done, "done"}};

  // The end of the help.
  void write_footer() {
    std::string text = examples.empty() ? "" : "Examples:";
    for (const std::string& line : examples) {
      text += "\n  " + line;
    }
    if (outcomes.size() > 1) {
      text += (text.empty() ? "" : "\n\n") + std::string("Exit codes:");
      for (const ExitCodeDescription& each : outcomes) {
        text +=
            fmt::format("{} {} {}", &each == &outcomes.front() ? "" : ";", each.code, each.meaning);
      }
    }
    app->footer(text);
  }

  [[nodiscard]] bool given(const std::string& name) const { return app->count(name) > 0; }
  [[nodiscard]] bool any_given(const std::vector<std::string>& names) const {
    return std::ranges::any_of(names, [this](const auto& name) { return given(name); });
  }

  // Refuses each of `names` that is given where `misplaced` says so.
  void refuse(const std::vector<std::string>& names, const std::function<bool()>& misplaced,
              const std::string& reason) {
    rules.emplace_back([this, names, misplaced, reason] {
      for (const std::string& name : names) {
        if (given(name) && misplaced()) {
          const std::string& what = app->get_option(name)->get_option_text();
          throw UsageError{fmt::format("{}{}{} {}", name, what.empty() ? "" : " ", what, reason)};
        }
      }
    });
  }

  // Refuses each of `names` beside those of `others` that are given.
  // `sentence` is made of an option as it was given, and the options beside it.
  void refuse_beside(
      const std::vector<std::string>& names, const std::vector<std::string>& others,
      const std::function<std::string(const std::string&, const std::string&)>& sentence) {
    rules.emplace_back([this, names, others, sentence] {
      std::vector<std::string> beside;
      std::ranges::copy_if(others, std::back_inserter(beside),
                           [this](const auto& other) { return given(other); });
      const auto misplaced =
          std::ranges::find_if(names, [this](const auto& name) { return given(name); });
      if (!beside.empty() && misplaced != names.end()) {
        const std::string& what = app->get_option(*misplaced)->get_option_text();
        throw UsageError{
            sentence(*misplaced + (what.empty() ? "" : " ") + what, enumerated(beside))};
      }
    });
  }

  void text(CLI::Option* option, const std::string& what) {
    option->option_text(what);
    // As of a variable that was never set.
    option->check(
        [](const std::string& given) {
          return given.empty() ? std::string("it is empty; give a value, or leave the option out")
                               : std::string();
        },
        "");
    kinds[option] = {kind_of_value(what)};
  }

  void number(CLI::Option* option, const std::string& what) {
    option->option_text(what)->check(whole_number_defect, "");
    kinds[option] = {"number"};
  }
};

struct Program::State {
  CLI::App app{
      "Finds, verifies and draws change covering designs: ordered lists of k-element blocks "
      "over v elements in which every pair meets and consecutive blocks differ in m elements.",
      "changeover"};
  std::vector<std::unique_ptr<Verb>> verbs;
  std::vector<GroupDescription> groups;
};

Verb::Verb(std::unique_ptr<State> state) : state_(std::move(state)) {}
Verb::~Verb() = default;

void Verb::positional(const std::string& name, std::optional<std::uint64_t>& value,
                      const std::string& help, bool required) {
  state_->number(state_->app->add_option(name, value, help)->required(required), "NUMBER");
}

void Verb::positional(const std::string& name, std::string& value, const std::string& help,
                      bool required) {
  CLI::Option* option = state_->app->add_option(name, value, help);
  option->required(required)->option_text(" ");
  state_->kinds[option] = {kind_of_argument(name)};
}

void Verb::positional(const std::string& name, std::vector<std::string>& values,
                      const std::string& help, bool required) {
  CLI::Option* option = state_->app->add_option(name, values, help);
  option->required(required)->option_text("...");
  state_->kinds[option] = {kind_of_argument(name)};
}

void Verb::option(const std::string& flags, std::optional<std::uint64_t>& value,
                  const std::string& what, const std::string& help) {
  state_->number(state_->app->add_option(flags, value, help), what);
}

void Verb::option(const std::string& flags, std::string& value, const std::string& what,
                  const std::string& help) {
  state_->text(state_->app->add_option(flags, value, help), what);
}

void Verb::option(const std::string& flags, const std::function<void(const std::string&)>& take,
                  const std::string& what, const std::string& help) {
  CLI::Option* option = state_->app->add_option_function<std::string>(flags, take, help);
  state_->text(option, what);
}

void Verb::choice(const std::string& flags, std::string& value,
                  const std::vector<std::string>& words, const std::string& help) {
  const std::string all = joined(words, "|");
  CLI::Option* option = state_->app->add_option(flags, value, help);
  option->option_text(all);
  option->required(!flags.starts_with('-'));  // a verb that asks for one of some words needs it
  option->check(
      [words, all](const std::string& given) {
        return std::ranges::find(words, given) == words.end()
                   ? "'" + given + "' is not one of " + all
                   : std::string();
      },
      "");
  state_->kinds[option] = {"words", words};
}

void Verb::flag(const std::string& flags, bool& value, const std::string& help) {
  state_->app->add_flag(flags, value, help)->disable_flag_override();
}

void Verb::flag(const std::string& flags, std::function<void()> set, const std::string& help) {
  state_->app->add_flag_callback(flags, std::move(set), help)->disable_flag_override();
}

void Verb::exclude(const std::vector<std::string>& names) {
  state_->sentences.push_back(sentence_of(OptionRule::Says::exclude, names, {}));
  state_->rules.emplace_back([state = state_.get(), names] {
    if (std::ranges::count_if(names, [state](const auto& name) { return state->given(name); }) >
        1) {
      throw UsageError{enumerated(names) + " exclude each other; give one of them"};
    }
  });
}

void Verb::only_with(const std::vector<std::string>& names,
                     const std::vector<std::string>& others) {
  state_->sentences.push_back(sentence_of(OptionRule::Says::only_with, names, others));
  state_->refuse(
      names, [state = state_.get(), others] { return !state->any_given(others); },
      "is for " + enumerated(others, " or ") +
          (others.size() == 1 ? "; give both" : "; give one of them, too"));
}

void Verb::never_with(const std::vector<std::string>& names, const std::vector<std::string>& others,
                      const std::string& why) {
  state_->sentences.push_back(sentence_of(OptionRule::Says::never_with, names, others));
  state_->refuse_beside(names, others, [why](const std::string& option, const std::string& beside) {
    return fmt::format("{} has no meaning with {}{}{}; leave it out", option, beside,
                       why.empty() ? "" : ": ", why);
  });
}

void Verb::not_served_with(const std::vector<std::string>& names,
                           const std::vector<std::string>& others, const std::string& why) {
  state_->sentences.push_back(sentence_of(OptionRule::Says::never_with, names, others));
  state_->refuse_beside(names, others, [why](const std::string& option, const std::string& beside) {
    return fmt::format("{} cannot be used with {}, {}; leave out one of them", option, beside, why);
  });
}

void Verb::rule(const std::string& sentence) { state_->sentences.push_back(sentence); }

void Verb::require(std::function<void()> rule) { state_->rules.push_back(std::move(rule)); }

void Verb::examples(const std::vector<std::string>& lines) {
  state_->examples = lines;
  state_->write_footer();
}

void Verb::outcomes(const std::vector<ExitCodeDescription>& codes) {
  state_->outcomes = codes;
  state_->write_footer();
}

Program::Program() : state_(std::make_unique<State>()) {
  CLI::App& app = state_->app;
  app.require_subcommand(1);
  app.set_help_flag("-h,--help", "print this help message and exit");
  // Only to be listed: run() takes it before it parses.
  app.set_version_flag(
      "--version", "",
      "print the version, and what this program was built with; as JSON with --json");
  app.footer(
      "Exit codes: 0 done or valid; 1 the claim was refuted; 2 usage; 3 bad input; 4 nothing "
      "serves\n"
      "these parameters, or a file, memory or disk space is missing; 5 a bug of ours. Searches:\n"
      "10 found, 20 proved that there is none, 30 stopped by a limit before that was known.\n"
      "changeover VERB --help shows options and examples.");
}

Program::~Program() = default;

Verb& Program::add_verb(const std::string& name, const std::string& summary,
                        std::function<Answer()> action) {
  auto state = std::make_unique<Verb::State>();
  state->app = state_->app.add_subcommand(name, summary);
  if (name.find('-') != std::string::npos) {
    state->app->group("");  // Listed by its group's help, and there in two words.
  }
  state->action = std::move(action);
  state_->verbs.push_back(std::unique_ptr<Verb>(new Verb(std::move(state))));
  return *state_->verbs.back();
}

void Program::add_group(const std::string& name, const std::string& summary) {
  state_->app.add_subcommand(name,
                             summary);  // Only to be listed: run() takes groups before it parses.
  state_->groups.push_back({name, summary});
}

int Program::run(int argc, char** argv) {
  CLI::App& app = state_->app;
  if (argc == 1) {
    std::string help = app.help();
    help.erase(help.find_last_not_of('\n') + 1);
    status_line().say(help);
    return exit_code::usage;
  }
  end_on_signals();
  if (std::string(argv[1]) == "--version") {
    const bool json = argc == 3 && std::string(argv[2]) == "--json";
    if (argc > 2 && !json) {
      return complain(exit_code::usage, "after --version there is nothing but --json");
    }
    return answer(
        [json] { return text_answer((json ? features_json : features_text)(features()), {}); }, "");
  }
  std::vector<char*> words(argv, argv + argc);
  std::string joined_name;
  std::string show = "catalog";
  std::string design = "show";
  const std::string first = words[1];
  if (!first.empty() && first.front() >= '0' && first.front() <= '9' &&
      first.find('.') != std::string::npos) {
    // A label by itself is looked up.
    words.insert(words.begin() + 1, {show.data(), design.data()});
    argc = static_cast<int>(words.size());
  }
  if (const std::vector<std::string> members = members_of(app, words[1]); !members.empty()) {
    const std::string group = words[1];
    const bool asks_help =
        argc > 2 && (std::string(words[2]) == "--help" || std::string(words[2]) == "-h");
    if (asks_help) {
      std::string text;
      for (const GroupDescription& each : groups()) {
        text += each.name == group ? each.summary + "\n" : "";
      }
      text += "Usage: changeover " + group + " VERB …\n\nVerbs:\n";
      const std::size_t width = largest_of<std::size_t>(
          members, [&](const std::string& member) { return member.size(); });
      for (const VerbDescription& verb : verbs()) {
        if (verb.group() == group) {
          text += fmt::format("  {:<{}}  {}\n", verb.name.substr(group.size() + 1), width,
                              verb.summary);
        }
      }
      text += "\nchangeover " + group + " VERB --help shows options and examples.\n";
      return answer([&text] { return text_answer(text, {}); }, "");
    }
    const std::string member = argc > 2 ? words[2] : "";
    if (std::ranges::find(members, member) == members.end()) {
      return complain(exit_code::usage, (argc > 2 ? group + " has no verb '" + member + "'" +
                                                        did_you_mean(member, members)
                                                  : group + " wants a verb") +
                                            "; there are " + joined(members, ", "));
    }
    joined_name = group + "-" + member;
    words.erase(words.begin() + 2);
    words[1] = joined_name.data();
    argc = static_cast<int>(words.size());
    argv = words.data();
  }
  if (const std::string defect = misspelt(app, argc, argv); !defect.empty()) {
    return complain(exit_code::usage, defect);
  }
  const auto chosen = [&]() -> const CLI::App& {
    const auto verbs = app.get_subcommands();
    return verbs.empty() ? app : *verbs.front();
  };
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success&) {  // --help
    std::string text = app.help() + "\n";
    if (const std::size_t at = joined_name.empty() ? std::string::npos : text.find(joined_name);
        at != std::string::npos) {
      text.replace(at, joined_name.size(), as_typed(joined_name));
    }
    return answer([&text] { return text_answer(text, {}); }, "");
  } catch (const CLI::ParseError& fault) {
    return complain(exit_code::usage, usage_message(fault, chosen()));
  }
  const auto verb = std::ranges::find_if(
      state_->verbs, [&](const auto& each) { return each->state_->app == &chosen(); });
  bool delivered = false;
  const int code = answer(
      [&] {
        check_output(chosen());
        for (const auto& rule : (*verb)->state_->rules) {
          rule();
        }
        return (*verb)->state_->action();
      },
      chosen().get_name(), &delivered);
  // What was delivered may be that there is no such design, or nothing was found in time.
  const bool answered = delivered || code >= exit_code::found;
  if (const std::string problem = answered ? standard_catalog_problem() : ""; !problem.empty()) {
    complain(code, "your own catalog was left out: " + problem);
  }
  if (const std::string remark = answered ? standard_catalog_remark() : ""; !remark.empty()) {
    complain(code, remark);
  }
  return code;
}

std::vector<VerbDescription> Program::verbs() const {
  std::vector<VerbDescription> all;
  for (const auto& entry : state_->verbs) {
    const Verb::State& verb = *entry->state_;
    VerbDescription& described = all.emplace_back();
    described.name = verb.app->get_name();
    described.summary = verb.app->get_description();
    described.rules = verb.sentences;
    described.examples = verb.examples;
    described.outcomes = verb.outcomes;
    for (const CLI::Option* option : verb.app->get_options()) {
      if (option == verb.app->get_help_ptr()) {
        continue;
      }
      OptionDescription& each = described.options.emplace_back();
      each.names = names_of(*option);
      each.positional = each.names.empty();
      if (each.positional) {
        each.names = {option->get_name(true)};
        each.repeats = option->get_items_expected_max() > 1;
      }
      const auto kind = verb.kinds.find(option);
      if (kind == verb.kinds.end()) {
        each.kind = "flag";
      } else {
        each.kind = kind->second.name;
        each.words = kind->second.words;
        each.value = each.positional || !each.words.empty() ? "" : option->get_option_text();
      }
      each.required = option->get_required();
      each.help = option->get_description();
    }
  }
  return all;
}

std::vector<GroupDescription> Program::groups() const { return state_->groups; }

std::string Program::purpose() const { return state_->app.get_description(); }

}  // namespace changeover::cli
