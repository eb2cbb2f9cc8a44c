#include "changeover/search/exact.hpp"

#include <fmt/format.h>

#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "search/local/known_as_wanted.hpp"

namespace changeover {

std::optional<std::uint64_t> MinimumResult::upper() const {
  return best ? std::optional<std::uint64_t>(best->block_count()) : std::nullopt;
}

Bound lower_bound_on_paper(const Parameters& p) {
  try {
    for (Bound& bound : lower_bounds(p)) {
      if (bound.name != "checked proofs") {
        return std::move(bound);
      }
    }
  } catch (const Stopped&) {
    // There was no time for a better bound.
  }
  return {1, "trivial", "a design has at least one block"};
}

namespace {

Decision decide_by(const MinimumOptions& options, const ExactOptions& exact, const Parameters& p,
                   std::uint64_t b, RunControl& control) {
  return options.decider ? options.decider(b, exact) : decide(p, b, exact, control);
}

void take(MinimumResult& result, const Decision& found) {
  result.best = found.design;
  result.subsets = found.subsets;
  result.known = false;
}

// Goes up from the lower bound, to the first design or the first number that stays open.
void walk(MinimumResult& result, const MinimumOptions& options, RunControl& control) {
  while (!result.settled()) {
    if (control.stop_wanted()) {
      result.why_stopped = control.why_stopped();
      return;
    }
    if (result.best && *result.upper() < result.lower) {
      throw InternalError(fmt::format("{} has {} blocks, but fewer than {} were excluded",
                                      name(result.parameters), *result.upper(), result.lower));
    }
    Decision decision;
    try {
      decision = decide_by(options, options.exact, result.parameters, result.lower, control);
    } catch (const MissingResource&) {
      if (!result.best && result.steps.empty()) {
        throw;
      }
      result.fault = std::current_exception();
      result.why_stopped = WhyStopped::fault;
      return;
    }
    result.why_stopped = decision.why_stopped;
    const bool excluded = decision.excluded();
    const bool found = decision.outcome == Outcome::found;
    if (found) {
      take(result, decision);
    }
    result.steps.push_back(std::move(decision));
    if (excluded) {
      ++result.lower;
    } else if (!found) {
      return;
    }
  }
}

// Searches for a better design with more blocks than the number that stayed open.
void look_above(MinimumResult& result, const MinimumOptions& options, RunControl& control) {
  ExactOptions quick = options.exact;
  quick.prove = false;
  for (std::uint64_t i = 1; i <= options.tries_above && !control.stop_wanted(); ++i) {
    const std::uint64_t b = result.lower + i;
    if (result.best && *result.upper() <= b) {
      return;
    }
    try {
      result.steps.push_back(decide_by(options, quick, result.parameters, b, control));
    } catch (const MissingResource&) {
      return;  // this number is not requested
    }
    if (result.steps.back().outcome == Outcome::found) {
      take(result, result.steps.back());
      return;
    }
  }
}

// Verifies a given design, if there is time.
std::optional<VerifiedDesign> checked(const Parameters& p, const std::optional<Design>& known) {
  if (!known) {
    return std::nullopt;
  }
  try {
    if (auto design = verified(*known); design && design->parameters() == p) {
      return design;
    }
  } catch (const Stopped&) {
    return std::nullopt;
  }
  throw BadInput(fmt::format("the design that was given is not a {}", name(p)));
}

// What can be searched with what is wanted: there is a design with some number of blocks.
void require_wanted(const Parameters& p, const Wanted& wanted, bool from_a_design) {
  if (p.v == p.k) {
    throw BadInput(fmt::format(
        "v = k = {}: one block holds all elements, and nothing more can be wanted of it; leave "
        "that out",
        p.k));
  }
  if (const std::string defect = wanted_defect(p, wanted); !defect.empty()) {
    throw BadInput(defect);
  }
  if (from_a_design) {
    throw BadInput(
        "a search for a design with given properties cannot start from a given design; "
        "leave one of the two out");
  }
}

// A known design that has what is wanted, if there is time to look.
void take_known(MinimumResult& result, const Wanted& wanted, RunControl& control) {
  const Parameters& p = result.parameters;
  if (p.strength != 2) {
    return;
  }
  try {
    const RunScope scope(control);
    if (auto known = known_as_wanted(p, wanted)) {
      auto subsets = parts_as_wanted(known->design, wanted, known->positions);
      if (!subsets) {
        throw InternalError("a known design lost what was wanted");
      }
      result.best = surely_verified(std::move(known->design), name(p));
      result.subsets = *std::move(subsets);
      result.known = true;
    }
  } catch (const Stopped&) {
    return;  // There was no time for it.
  }
}

}  // namespace

MinimumResult find_minimum(const Parameters& p, const MinimumOptions& options, RunControl& control,
                           const std::optional<Design>& known) {
  const auto begin = RunControl::Clock::now();
  MinimumResult result;
  result.parameters = p;
  result.impossible = impossibility(p);
  auto given = checked(p, known);
  if (result.impossible) {
    result.why_stopped = WhyStopped::exhausted;
    return result;
  }
  result.start = lower_bound_on_paper(p);
  result.best = std::move(given);
  if (const Wanted& wanted = options.exact.wanted; wanted.any()) {
    require_wanted(p, wanted, known.has_value());
    result.start = wanted_bound(p, wanted, std::move(result.start));
    if (options.from_known) {
      take_known(result, wanted, control);
    }
  }
  result.lower = result.start.blocks;
  walk(result, options, control);
  if (result.settled()) {
    result.why_stopped = WhyStopped::exhausted;
  } else if (!result.fault) {
    look_above(result, options, control);
  }
  result.time = RunControl::Clock::now() - begin;
  return result;
}

}  // namespace changeover
