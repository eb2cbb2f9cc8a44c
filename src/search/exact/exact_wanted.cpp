#include "search/exact/exact_wanted.hpp"

#include <fmt/format.h>

#include <map>

#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "search/sat/cardinality.hpp"

namespace changeover {
namespace {

using Literals = std::vector<Literal>;
using Holds = std::function<Literal(std::uint64_t, std::uint64_t)>;

/// The numbers that decide which clauses exist, for the clauses and for their count.
struct WantedPlan {
  WantedPlan(const Parameters& p, std::uint64_t b, const Wanted& wanted)
      : circular(p.kind == Kind::circular),
        given(wanted.contained.size()),
        places(given == 0 || circular ? given
               : b < given            ? 0
                                      : b - given + 1),
        rest(wanted.expansion_set ? in_parts(p, wanted) : Block{}),
        parts(rest.empty() ? 0 : rest.size() / (p.k - p.change)),
        steps(circular && b > 1 ? b : b - 1) {}

  /// Whether the given blocks can only begin at block 0.
  [[nodiscard]] bool at_start() const { return given > 0 && (circular || places == 1); }

  bool circular;
  std::uint64_t given;
  std::uint64_t places;  // where the given blocks of a linear list may begin
  Block rest;            // elements that must be in parts
  std::uint64_t parts;
  std::uint64_t steps;
};

void add_units(Cnf& cnf, std::uint64_t block, const Block& elements, const Holds& holds) {
  for (const Element e : elements) {
    cnf.add({holds(block, e)});
  }
}

Literals add_given(Cnf& cnf, const WantedPlan& plan, std::uint64_t b,
                   const std::vector<Block>& given, const Holds& holds) {
  Literals begins;
  if (plan.at_start()) {
    for (std::size_t i = 0; i < given.size(); ++i) {
      add_units(cnf, i % b, given[i], holds);
    }
    return begins;
  }
  for (std::uint64_t place = 0; place < plan.places; ++place) {
    stop_if_asked();
    begins.push_back(cnf.new_variable());
    for (std::size_t i = 0; i < given.size(); ++i) {
      for (const Element e : given[i]) {
        cnf.add({-begins.back(), holds(place + i, e)});
      }
    }
  }
  cnf.add(begins);
  return begins;
}

Literals add_parts(Cnf& cnf, const WantedPlan& plan, const Parameters& p, std::uint64_t b,
                   const Holds& holds) {
  Literals chosen;
  for (std::uint64_t i = 0; i < plan.steps; ++i) {
    chosen.push_back(cnf.new_variable());
  }
  require_exactly(cnf, chosen, static_cast<std::size_t>(plan.parts));
  std::size_t next = 0;  // of the elements in parts
  Literals in;
  for (std::uint64_t e = 0; e < p.v; ++e) {
    stop_if_asked();
    const bool in_part = next < plan.rest.size() && plan.rest[next] == e;
    next += in_part ? 1 : 0;
    in.clear();
    for (std::uint64_t i = 0; i < plan.steps; ++i) {
      const Literal here = holds(i, e);
      const Literal there = holds((i + 1) % b, e);
      if (!in_part) {
        cnf.add({-chosen[i], -here, -there});
        continue;
      }
      in.push_back(cnf.new_variable());
      cnf.add({-in.back(), chosen[i]});
      cnf.add({-in.back(), here});
      cnf.add({-in.back(), there});
      cnf.add({in.back(), -chosen[i], -here, -there});
    }
    if (in_part) {
      require_exactly(cnf, in, 1);
    }
  }
  return chosen;
}

}  // namespace

std::vector<std::uint64_t> next_alike(const Parameters& p, const Wanted& wanted) {
  std::vector<const Block*> sets{&wanted.first, &wanted.last};
  for (const Block& block : wanted.contained) {
    sets.push_back(&block);
  }
  // Which sets an element is in; elements that are in none are not listed.
  std::map<Element, std::vector<std::size_t>> in;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    for (const Element e : *sets[i]) {
      in[e].push_back(i);
    }
  }
  std::map<std::vector<std::size_t>, std::uint64_t> last;  // the last element of each class so far
  std::vector<std::uint64_t> next(static_cast<std::size_t>(p.v), p.v);
  for (std::uint64_t e = 0; e < p.v; ++e) {
    const auto listed = in.find(static_cast<Element>(e));
    const auto [before, is_new] =
        last.try_emplace(listed == in.end() ? std::vector<std::size_t>{} : listed->second, e);
    if (!is_new) {
      next[before->second] = e;
      before->second = e;
    }
  }
  return next;
}

WantedVariables add_wanted(Cnf& cnf, const Parameters& p, std::uint64_t b, const Wanted& wanted,
                           const Holds& holds) {
  const WantedPlan plan(p, b, wanted);
  WantedVariables variables;
  add_units(cnf, 0, wanted.first, holds);
  add_units(cnf, b - 1, wanted.last, holds);
  if (plan.given > 0) {
    variables.begins = add_given(cnf, plan, b, wanted.contained, holds);
  }
  if (plan.parts > 0) {
    variables.chosen = add_parts(cnf, plan, p, b, holds);
  }
  return variables;
}

CnfSize wanted_size(const Parameters& p, std::uint64_t b, const Wanted& wanted) {
  const WantedPlan plan(p, b, wanted);
  const auto variables = [](std::uint64_t n) {
    return CnfSize{.variables = n, .clauses = 0, .literals = 0};
  };
  CnfSize size = clauses_of(wanted.first.size() + wanted.last.size(), 1);
  if (plan.at_start()) {
    size += clauses_of(checked_multiply(plan.given, p.k), 1);
  } else if (plan.given > 0) {
    size += variables(plan.places) + clauses_of(1, plan.places);
    size += plan.places * clauses_of(checked_multiply(plan.given, p.k), 2);
  }
  if (plan.parts > 0) {
    size += variables(plan.steps) + exactly_size(plan.steps, plan.parts);
    size += (p.v - plan.rest.size()) * clauses_of(plan.steps, 3);
    const CnfSize step = variables(1) + clauses_of(3, 2) + clauses_of(1, 4);
    size += plan.rest.size() * (plan.steps * step + exactly_size(plan.steps, 1));
  }
  return size;
}

std::vector<std::string> lines_of(const WantedVariables& variables) {
  std::vector<std::string> lines;
  if (!variables.begins.empty()) {
    lines.push_back(
        fmt::format("The given blocks begin at block i: variable i + {}.", variables.begins[0]));
  }
  if (!variables.chosen.empty()) {
    lines.push_back(
        fmt::format("The unchanged subset of block i and the next one is in the partition: "
                    "variable i + {}.",
                    variables.chosen[0]));
  }
  return lines;
}

}  // namespace changeover
