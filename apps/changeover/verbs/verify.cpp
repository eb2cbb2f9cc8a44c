// changeover verify FILE: checks a design and reports its quality.
#include "changeover/verify/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

#include "answer/answer.hpp"
#include "answer/design/judgement.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/tables.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "request/output.hpp"
#include "request/parameters.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct VerifyRequest {
  std::string path;
  ParameterRequest declared;
  bool elements = false;
  OutputRequest output;
};

using Labels = std::vector<std::string>;

std::string element(Element x, const Labels& labels) {
  return labels.empty() ? std::to_string(x) : labels[x];
}

std::string set(const std::vector<Element>& elements, const Labels& labels) {
  std::string text = "{";
  for (const Element x : elements) {
    text += (text.size() == 1 ? "" : ",") + element(x, labels);
  }
  return text + "}";
}

std::string some(const std::vector<Element>& elements, const Labels& labels) {
  constexpr std::size_t most = 20;
  if (elements.size() <= most) {
    return set(elements, labels);
  }
  const std::vector<Element> first(elements.begin(), elements.begin() + most);
  return fmt::format("{} and {} more", set(first, labels), elements.size() - most);
}

// "1 to 3", "2": the range of a count over the elements.
std::string range(const Verdict& verdict, std::uint64_t ElementCount::*count) {
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t most = 0;
  for (const ElementCount& each : verdict.elements) {
    least = std::min(least, each.*count);
    most = std::max(most, each.*count);
  }
  return least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
}

void add_defects(const Verdict& verdict, const Labels& labels, std::string& text) {
  const Parameters& p = verdict.parameters;
  if (verdict.b == 0) {
    text += "there is no block\n";
  }
  if (verdict.bad_steps > 0) {
    text += fmt::format("{} {} not change exactly {}:\n", count_of(verdict.bad_steps, "step"),
                        verdict.bad_steps == 1 ? "does" : "do", count_of(p.change, "element"));
    for (const BadStep& step : verdict.bad_step_examples) {
      text += fmt::format("  from block {} to block {}{}: {} changed\n", step.from, step.to,
                          step.to < step.from ? " (the circle closes)" : "",
                          count_of(step.changes, "element"));
    }
  }
  if (verdict.uncovered > 0) {
    text += fmt::format("{} of {} {} {} in no block:", verdict.uncovered, verdict.subsets,
                        p.strength == 2 ? "pairs" : fmt::format("{}-subsets", p.strength),
                        verdict.uncovered == 1 ? "is" : "are");
    for (const Block& subset : verdict.uncovered_examples) {
      text += " " + set(subset, labels);
    }
    text += verdict.uncovered > verdict.uncovered_examples.size() ? " …\n" : "\n";
  }
}

void add_qualities(const Verdict& verdict, const Judgement& judgement, const Labels& labels,
                   std::string& text) {
  const Parameters& p = verdict.parameters;
  const std::string subset = p.strength == 2 ? "pair" : fmt::format("{}-subset", p.strength);
  text += fmt::format("quality:  {}\n", quality(judgement));
  text += fmt::format("bound:    {}\n", judgement.bound.reason);
  text += fmt::format("excess:   {} of {} {}\n", verdict.excess,
                      count_of(verdict.covered, "covered " + subset),
                      verdict.excess == 1 ? "is a repetition" : "are repetitions");
  if (verdict.never_newly_covered > 0) {
    text += fmt::format("fixed:    {} in every block, never newly covered\n",
                        count_of(verdict.never_newly_covered, subset));
  }
  const std::string introduced = range(verdict, &ElementCount::introductions);
  const std::string blocks = range(verdict, &ElementCount::blocks);
  text +=
      fmt::format("elements: introduced {} {} each, in {} {} each\n", introduced,
                  introduced == "1" ? "time" : "times", blocks, blocks == "1" ? "block" : "blocks");
  if (p.strength == 2) {
    text += fmt::format("degrees:  i_x(k-1) + m(r_x-i_x) = v-1 + e_x {} at every element, e_x {}\n",
                        verdict.degree_identity ? "holds" : "fails",
                        range(verdict, &ElementCount::excess));
  }
  if (!verdict.fixed.empty() && verdict.b > 1) {
    text += fmt::format("fixed:    {} in every block\n", some(verdict.fixed, labels));
  }
  if (verdict.unchanged_subsets) {
    text += fmt::format("unchanged subsets: {} distinct", *verdict.unchanged_subsets);
    text += verdict.never_unchanged.empty()
                ? ", every element is in one\n"
                : fmt::format("; in none: {}\n", some(verdict.never_unchanged, labels));
  }
}

void add_elements(const Verdict& verdict, const Labels& labels, std::string& text) {
  text += fmt::format("{:>12} {:>12} {:>12} {:>12}\n", "element", "i_x", "r_x", "e_x");
  for (std::size_t x = 0; x < verdict.elements.size(); ++x) {
    const ElementCount& count = verdict.elements[x];
    const std::string name = element(static_cast<Element>(x), labels);
    constexpr std::size_t width = 12;
    text += std::string(width - std::min(width, display_width(name)), ' ') + name +
            fmt::format(" {:>12} {:>12} {:>12}\n", count.introductions, count.blocks, count.excess);
  }
}

Answer run(const VerifyRequest& request) {
  check_inputs(request.output, {{"the design", request.path}});
  const auto input = open_design(request.path, request.declared.reading());
  const Verdict verdict = verify(*input, {.unchanged = true});
  const Judgement judgement = judge(verdict);
  const Labels& labels = input->labels();
  std::string text;
  if (request.output.json()) {
    text = verify_json(verdict, judgement, labels) + "\n";
  } else {
    text = fmt::format("{}: {} with {}\n", verdict.valid() ? "valid" : "INVALID",
                       name(verdict.parameters), count_of(verdict.b, "block"));
    add_defects(verdict, labels, text);
    if (const auto names = names_among_numbers(labels); !verdict.valid() && !names.empty()) {
      text += fmt::format("all elements are numbers but {}; if that is a slip, correct it\n",
                          joined(names, " and "));
    }
    if (verdict.valid()) {
      add_qualities(verdict, judgement, labels, text);
    }
    if (request.elements) {
      add_elements(verdict, labels, text);
    }
  }
  return text_answer(text, request.output, verdict.valid() ? exit_code::done : exit_code::refuted);
}

}  // namespace

void add_verify(Program& program) {
  auto [verb, request] =
      program.add<VerifyRequest>("verify", "check a design and report its quality", run);
  verb.positional("FILE", request.path,
                  "text, JSON, CSV, GAP, Sage, XML or sets {A,B}; - is standard input");
  verb.option("-v", request.declared.v, "V", "number of elements, if the file does not say");
  verb.option("-k", request.declared.k, "K", "elements in a block");
  verb.option("-m,--change", request.declared.change, "M",
              "elements in which consecutive blocks differ");
  verb.option("-t,--strength", request.declared.strength, "T",
              "every T elements must meet (2, 3 or 4)");
  add_kind_to(verb, request.declared.kind, "treat the design as circular, whatever the file says",
              "treat the design as linear");
  verb.flag("--elements", request.elements,
            "show for every element x: introductions i_x, blocks r_x, excess e_x");
  request.output.add_to(verb, {"text", "json"});
  verb.examples({"changeover verify mine.txt", "changeover verify mine.csv --circular --change 1",
                 "changeover design 105 9 --json | changeover verify -"});
  verb.outcomes({{exit_code::done, "valid"}, {exit_code::refuted, "not a valid design"}});
}

}  // namespace changeover::cli
