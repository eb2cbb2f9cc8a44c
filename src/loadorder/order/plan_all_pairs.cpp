#include "loadorder/order/plan_all_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/verify/verdict.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "loadorder/order/block_steps.hpp"
#include "loadorder/order/read_order.hpp"
#include "loadorder/order/streamed_order.hpp"

namespace changeover {
namespace {

// Beyond both, streamed orders are within a few in 10⁴ of the bound and offers would cost seconds.
constexpr std::uint64_t most_for_registry = 2'000;
constexpr std::uint64_t most_for_registry_by_room = 16;
constexpr std::uint64_t most_for_closure_rules = 120;
constexpr std::uint64_t largest_planned_change = 3;
constexpr std::uint64_t largest_change = 64;

std::uint64_t loads_of(const Offer& offer) {
  const Parameters& p = offer.recipe.parameters;
  return checked_add(p.k, checked_multiply(p.change, offer.b - 1));
}

struct Candidate {
  std::uint64_t loads = 0;
  std::uint64_t steps = 0;
  std::optional<Offer> offer;  // otherwise the streamed order

  [[nodiscard]] bool better_than(const Candidate& other) const {
    return std::pair(loads, steps) < std::pair(other.loads, other.steps);
  }
};

void consider(Candidate& best, std::optional<Offer> offer) {
  if (offer && offer->b > 0) {
    const Candidate candidate{loads_of(*offer), offer->b, std::move(offer)};
    if (candidate.better_than(best)) {
      best = candidate;
    }
  }
}

// What the constructions give for change numbers up to 64 and both kinds.
void consider_constructions(Candidate& best, std::uint64_t items, std::uint64_t room,
                            bool closure_rules) {
  const bool plans = items <= most_for_closure_rules && closure_rules;
  for (std::uint64_t m = 1; m <= std::min(largest_change, room - 1); ++m) {
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      const Parameters p{.v = items, .k = room, .change = m, .kind = kind};
      if (impossibility(p)) {
        continue;
      }
      // No more than the fewest loads that blocks of this m could do with.
      const bool hopeful =
          checked_add(room, checked_multiply(m, lower_bound(p).blocks - 1)) <= best.loads;
      if (m <= largest_planned_change || hopeful) {
        consider(best, Registry::standard().best(p));
      }
      if (plans && m <= largest_planned_change && kind == Kind::linear && hopeful) {
        consider(best, best_known(Registry::standard(), p));
      }
    }
  }
}

LoadOrder::Maker maker_of(std::shared_ptr<const Design> design) {
  return [held = std::move(design)] {
    return std::make_unique<BlockSteps>(std::make_unique<DesignSource>(*held), held);
  };
}

// A linear single-change design: the best so far if it is one, else the streamed order, whose steps
// all load one item into a full memory.
Design start_of_search(const Candidate& best, const StreamedShape& shape) {
  if (best.offer && best.offer->recipe.parameters.change == 1) {
    Design design = Registry::standard().build_design(best.offer->recipe);
    design.set_kind(Kind::linear);
    design.recipe.reset();
    return design;
  }
  Design design({.v = shape.items, .k = shape.room, .change = 1, .kind = Kind::linear});
  Block block;
  Step step;
  for (const auto steps = streamed_steps(shape); steps->next(step);) {
    for (const Element x : step.evict) {
      std::erase(block, x);
    }
    block.insert(block.end(), step.load.begin(), step.load.end());
    design.append(block);
  }
  return design;
}

// Reads every step, or leaves the certificate to the structure.
void certify_order(LoadOrder::Maker& maker, LoadOrderFacts& facts, const std::string& by_structure,
                   std::vector<Element> kept_as) {
  facts.certificate = by_structure.empty() ? "not read yet" : by_structure;
  if (!facts.every_step_read) {
    return;
  }
  CheckOptions options;
  options.kept_as = std::move(kept_as);
  const ScheduleVerdict verdict =
      check_schedule(*maker(), {.items = facts.items, .room = facts.room}, options);
  if (!verdict.valid() || verdict.loads != facts.loads || verdict.steps != facts.steps ||
      verdict.loads < facts.bound.loads) {
    throw InternalError(fmt::format(
        "the load order '{}' of {} with room for {} is wrong: {}", facts.method,
        count_of(facts.items, "item"), facts.room,
        verdict.valid() ? "it does not keep its promise" : verdict.fault + verdict.example));
  }
  facts.certificate = "every step read, " + all_met(binomial(facts.items, 2));
}

}  // namespace

LoadOrder plan_all_pairs(std::uint64_t items, std::uint64_t room, const LoadOrderOptions& options) {
  LoadOrderFacts facts = facts_before(items, room);
  const StreamedShape shape = best_streamed_shape(items, room);
  facts.every_step_read =
      items <= std::min<std::uint64_t>(options.read_up_to, max_elements_in_memory) &&
      shape.steps() <= most_loads_read;

  Candidate best{shape.loads, shape.steps(), std::nullopt};
  // What cannot be read is taken from the structure that certifies itself.
  if (items > room && facts.every_step_read && options.constructions &&
      (items <= most_for_registry || items / room < most_for_registry_by_room)) {
    consider_constructions(best, items, room, options.closure_rules);
  }
  std::shared_ptr<const Design> improved;
  if (options.improve && items > room && items <= options.improve_up_to &&
      best.loads > facts.bound.loads) {
    const Design start = start_of_search(best, shape);
    auto better = options.improve(start, facts.bound.loads - room + 1);
    if (better && better->parameters() == start.parameters() &&
        room + better->block_count() - 1 < best.loads) {
      improved = std::make_shared<const Design>(std::move(*better));
      best.loads = room + improved->block_count() - 1;
      best.steps = improved->block_count();
    }
  }

  facts.loads = best.loads;
  facts.steps = best.steps;
  LoadOrder::Maker maker;
  std::string by_structure;
  std::vector<Element> kept_as;
  if (improved) {
    facts.method = "improved";
    facts.explanation = "A linear single-change design that search made shorter.";
    maker = maker_of(improved);
  } else if (best.offer) {
    const Recipe recipe = best.offer->recipe;
    facts.method = recipe.construction;
    facts.explanation = fmt::format("Blocks of a {}. {}", name(recipe.parameters),
                                    Registry::standard().construction_of(recipe).explain(recipe));
    maker = [recipe] { return std::make_unique<BlockSteps>(Registry::standard().build(recipe)); };
  } else {
    facts.method = items <= room ? "one-step" : "streamed";
    facts.explanation = shape.explain();
    maker = [shape] { return streamed_steps(shape); };
    if (!facts.every_step_read || !options.read_first) {
      by_structure = certify(shape);
    } else {
      kept_as = names_by_window(shape);
    }
  }
  facts.every_step_read = facts.every_step_read && options.read_first;
  certify_order(maker, facts, by_structure, std::move(kept_as));
  return {std::move(facts), std::move(maker)};
}

LoadOrder load_order_of(std::shared_ptr<const Design> design, std::string method,
                        std::string explanation) {
  const Parameters& p = design->parameters();
  if (p.kind != Kind::linear || design->block_count() == 0) {
    throw BadInput("a load order needs a linear design with at least one block");
  }
  LoadOrderFacts facts = facts_before(p.v, p.k);
  facts.steps = design->block_count();
  facts.method = std::move(method);
  facts.explanation = std::move(explanation);
  LoadOrder::Maker maker = maker_of(std::move(design));
  Step step;
  for (const auto reader = maker(); reader->next(step);) {
    facts.loads += step.load.size();
  }
  return {std::move(facts), std::move(maker)};
}

}  // namespace changeover
