#include "shell/manual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "changeover/core/version.hpp"
#include "core/each.hpp"
#include "shell/build_information.hpp"
#include "shell/roff.hpp"

namespace changeover::cli {
namespace {

// A summary, or the help of an option, as a sentence.
std::string sentence(std::string text) {
  text += text.ends_with('.') ? "" : ".";
  // A name such as v.k.m.kind stays as it is.
  const std::size_t end = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz");
  if (end > 0 && (text[end] == ' ' || text[end] == ',' || text[end] == ':')) {
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  }
  return roff_text(text);
}

// The macro of a title takes quoted words.
std::string begun(const std::string& name, const std::string& summary) {
  std::string upper = name;
  std::ranges::transform(upper, upper.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return fmt::format(
      ".\\\" Made by changeover manual. Do not edit.\n"
      ".TH {} 1 {} \"changeover {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n",
      roff_literal(upper), build_information().date, version, roff_literal(name),
      roff_text(summary));
}

std::string shown_argument(const OptionDescription& each) {
  const std::string name = roff_italic(each.names.front()) + (each.repeats ? "\\ ..." : "");
  return each.required ? name : "[" + name + "]";
}

// "-f, --format WORD" and what it does.
std::string entry_of(const OptionDescription& each) {
  std::string names = joined(each.names, each.positional ? roff_italic : roff_bold);
  if (!each.positional && each.kind != "flag") {
    names += " " + roff_italic(each.kind == "words" ? "WORD" : each.value);
  }
  std::string text = fmt::format(".TP\n{}\n{}\n", names, sentence(each.help));
  if (!each.words.empty()) {
    text += (each.words.size() > 1 ? "One of " : "It is ") + joined(each.words, roff_bold) + ".\n";
  }
  if (each.kind == "duration") {
    text += "A number with ms, s, m, h or d.\n";
  } else if (each.kind == "size") {
    text += "A number of bytes, or one with K, M, G or T.\n";
  } else if (each.kind == "range") {
    text += "A number, or two numbers with two dots between them, of which one may be left out.\n";
  }
  return text;
}

// The end of the page of a verb, or of a page on several verbs.
std::string ending(const std::vector<ExitCodeDescription>& codes) {
  std::string text = ".SH EXIT STATUS\n";
  for (const ExitCodeDescription& each : codes) {
    text += fmt::format(".TP\n.B {}\n{}\n", each.code, sentence(each.meaning));
  }
  text +=
      ".SH ENVIRONMENT\n"
      ".TP\n.B CHANGEOVER_CATALOG\n"
      "The file of your own designs; if it is empty, there is none.\n"
      ".TP\n.BR XDG_DATA_HOME \", \" HOME\n"
      "Where that file is if the above is not set.\n"
      ".TP\n.B NO_COLOR\n"
      "If it is set and not empty, answers to a terminal have no colours.\n"
      ".TP\n.B COLUMNS\n"
      "How wide tables may be.\n"
      ".SH FILES\n"
      ".TP\n.I $XDG_DATA_HOME/changeover/catalog.db\n"
      "Your own designs, which every verb knows besides those that come with the program.\n"
      "Without\n.B XDG_DATA_HOME\nit is\n.IR \\(ti/.local/share/changeover/catalog.db .\n";
  return text;
}

std::string references(const std::vector<std::string>& names) {
  std::string text = ".SH SEE ALSO\n";
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += fmt::format(".BR {} (1){}\n", roff_literal(names[i]), i + 1 < names.size() ? "," : "");
  }
  return text;
}

// "changeover-catalog-show".
std::string page_name(const std::string& verb) { return "changeover-" + verb; }

std::string verb_page(const VerbDescription& verb, const std::vector<VerbDescription>& all) {
  std::string text = begun(page_name(verb.name), verb.summary);
  text += fmt::format(".SH SYNOPSIS\n{}\n", roff_bold("changeover " + verb.typed()));
  std::string arguments;
  std::string options;
  for (const OptionDescription& each : verb.options) {
    if (each.positional) {
      text += shown_argument(each) + "\n";
      arguments += entry_of(each);
    } else {
      options += entry_of(each);
    }
  }
  text += fmt::format("[{}]\n.SH DESCRIPTION\n{}: {}\n", roff_italic("OPTIONS"),
                      roff_bold("changeover " + verb.typed()), roff_text(verb.summary + "."));
  if (!arguments.empty()) {
    text += ".SH ARGUMENTS\n" + arguments;
  }
  text += ".SH OPTIONS\n" + options +
          ".TP\n\\fB\\-h\\fR, \\fB\\-\\-help\\fR\nOptions and examples, shortly.\n";
  if (!verb.rules.empty()) {
    text += ".SS What does not go together\n";
    for (const std::string& rule : verb.rules) {
      text += (&rule == &verb.rules.front() ? "" : ".PP\n") + sentence(rule) + "\n";
    }
  }
  std::vector<ExitCodeDescription> codes = verb.outcomes;
  const std::vector<ExitCodeDescription> refused = refusals();
  codes.insert(codes.end(), refused.begin(), refused.end());
  std::ranges::sort(codes, {}, &ExitCodeDescription::code);
  text += ending(codes);
  if (!verb.examples.empty()) {
    text += ".SH EXAMPLES\n.nf\n";
    for (const std::string& line : verb.examples) {
      text += roff_literal(line) + "\n";
    }
    text += ".fi\n";
  }
  std::vector<std::string> others{"changeover"};
  if (const std::string group = verb.group(); !group.empty()) {
    others.push_back(page_name(group));
    for (const VerbDescription& each : all) {
      if (each.group() == group && each.name != verb.name) {
        others.push_back(page_name(each.name));
      }
    }
  }
  others.emplace_back("checkdesign");
  return text + references(others);
}

// The verbs that `chosen` takes, each with its summary.
template <typename Chosen>
std::string verb_list(const std::vector<VerbDescription>& all, const Chosen& chosen) {
  std::string text;
  for (const VerbDescription& verb : all) {
    if (chosen(verb)) {
      text +=
          fmt::format(".TP\n{}(1)\n{}\n", roff_bold(page_name(verb.name)), sentence(verb.summary));
    }
  }
  return text;
}

std::string group_page(const GroupDescription& group, const std::vector<VerbDescription>& all) {
  const std::string typed = roff_bold("changeover " + group.name);
  return begun(page_name(group.name), group.summary) +
         fmt::format(".SH SYNOPSIS\n{} {} ...\n.SH DESCRIPTION\n{}: {}\n", typed,
                     roff_italic("VERB"), typed, roff_text(group.summary + ".")) +
         ".SH VERBS\n" +
         verb_list(all, [&](const auto& verb) { return verb.group() == group.name; }) +
         ending(exit_codes()) + references({"changeover", "checkdesign"});
}

std::string program_page(const Program& program) {
  const std::vector<VerbDescription> all = program.verbs();
  std::string text = begun("changeover", "change covering designs");
  text += fmt::format(
      ".SH SYNOPSIS\n.B changeover\n{0} ...\n.br\n.B changeover\n{1}\n.br\n"
      ".B changeover \\-\\-version\n[\\fB\\-\\-json\\fR]\n.SH DESCRIPTION\n{2}\n.PP\n"
      "Results are verified before they are shown, by code that shares nothing with what made "
      "them.\nA file that is written appears whole or not at all.\n"
      ".PP\n{1} by itself, such as 26.4.2.circular.65, shows that design of the catalog.\n",
      roff_italic("VERB"), roff_italic("LABEL"), sentence(program.purpose()));
  text += ".SH VERBS\n" + verb_list(all, [](const auto& verb) { return verb.group().empty(); });
  for (const GroupDescription& group : program.groups()) {
    text += fmt::format(".SS {}\n{}(1): {}\n", roff_bold("changeover " + group.name),
                        roff_bold(page_name(group.name)), roff_text(group.summary + "."));
    text += verb_list(all, [&](const auto& verb) { return verb.group() == group.name; });
  }
  text +=
      ".SH OPTIONS\n.TP\n\\fB\\-h\\fR, \\fB\\-\\-help\\fR\nThe verbs.\n"
      ".BI \"changeover \" VERB \" \\-\\-help\"\nhas the options of a verb and examples.\n"
      ".TP\n\\fB\\-\\-version\\fR [\\fB\\-\\-json\\fR]\n"
      "The version, and what this program was built with and can do.\n";
  return text + ending(exit_codes()) + references({"checkdesign"});
}

}  // namespace

std::vector<ManualPage> manual_pages(const Program& program) {
  const std::vector<VerbDescription> verbs = program.verbs();
  std::vector<ManualPage> pages{{"changeover", program_page(program)}};
  for (const GroupDescription& group : program.groups()) {
    pages.push_back({page_name(group.name), group_page(group, verbs)});
  }
  for (const VerbDescription& verb : verbs) {
    pages.push_back({page_name(verb.name), verb_page(verb, verbs)});
  }
  return pages;
}

}  // namespace changeover::cli
