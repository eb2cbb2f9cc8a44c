#include "changeover/search/enumeration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/isomorphism/isomorphism.hpp"
#include "changeover/verify/verdict.hpp"
#include "search/enumerate/enumeration_case.hpp"
#include "search/enumerate/enumeration_team.hpp"

namespace changeover {
namespace {

Verdict verified(const Design& design, std::uint64_t b) {
  Verdict verdict = verify(design);
  if (!verdict.valid() || verdict.b != b) {
    throw InternalError(
        fmt::format("enumeration of {} found a list that is none", name(design.parameters())));
  }
  return verdict;
}

// v = k: one block holds everything, and nothing can change.
std::optional<Design> single_block(const Parameters& p, std::uint64_t b) {
  if (p.v != p.k || b != 1) {
    return std::nullopt;
  }
  Block block;
  for (Element x = 0; x < p.v; ++x) {
    block.push_back(x);
  }
  return Design(p, std::vector<Block>{block});
}

EnumerationRun explore(const EnumerationTask& task, std::uint64_t b, RunControl& control) {
  // Only one share finds the single block.
  const auto single = single_block(task.parameters, b);
  if (!single || control.settings().share.index != 0) {
    return explore_together(task, control);
  }
  EnumerationRun result{
      .why_stopped = WhyStopped::exhausted, .forms = 1, .nodes = 1, .prefixes = 0};
  if (auto judged = task.judge(*single)) {
    task.hand_out(*judged);
  }
  return result;
}

}  // namespace

EnumerationRun enumerate_designs(const Parameters& p, std::uint64_t b, RunControl& control,
                                 const std::function<void(const Design&)>& on_design) {
  EnumerationTask task;
  task.parameters = p;
  task.cases = enumeration_cases(p, b, false);
  task.judge = [&](const Design& design) -> std::optional<DesignClass> {
    // Linear designs come in standard form; circular ones also depend on where the list ends.
    DesignClass found{
        .representative = p.kind == Kind::linear ? design : standard_form(design).design,
        .group_order = {}};
    verified(found.representative, b);
    return found;
  };
  task.hand_out = [&](DesignClass& found) {
    if (on_design) {
      on_design(found.representative);
    }
  };
  return explore(task, b, control);
}

Classification classify_designs(const Parameters& p, std::uint64_t b,
                                const ClassifyOptions& options, RunControl& control) {
  const Sameness same{.rotation = true, .reversal = options.reversal};
  EnumerationTask task;
  task.parameters = p;
  task.cases = enumeration_cases(p, b, true);
  // Several sequences of a class are found. Only one of them is its canonical form, which begins
  // with a longest run and so is always among them.
  task.judge = [&](const Design& design) -> std::optional<DesignClass> {
    CanonicalForm own = standard_form(design);
    CanonicalForm least = canonical_form(own.design, same);
    if (!std::ranges::equal(own.design.elements(), least.design.elements())) {
      return std::nullopt;
    }
    const Verdict verdict = verified(least.design, b);
    const AutomorphismGroup group = automorphisms(least.design, same);
    DesignClass found{.representative = std::move(least.design), .group_order = group.order};
    found.forms = standard_forms_in_class(found.representative, group, same);
    found.rotations = group.rotations;
    found.reflections = group.reflections;
    found.fixed = verdict.fixed.size();
    found.tight = verdict.tight();
    found.economical = verdict.economical();
    return found;
  };
  Classification result;
  task.hand_out = [&](DesignClass& found) {
    ++result.classes;
    result.standard_forms += found.forms;
    result.tight += found.tight ? 1 : 0;
    ++result.group_orders[found.group_order];
    if (options.on_class) {
      options.on_class(found);
    }
    if (result.kept.size() < options.keep) {
      result.kept.push_back(std::move(found));
    }
  };
  const EnumerationRun run = explore(task, b, control);
  result.why_stopped = run.why_stopped;
  result.nodes = run.nodes;
  result.prefixes = run.prefixes;
  return result;
}

}  // namespace changeover
