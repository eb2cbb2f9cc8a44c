#include "changeover/construct/planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <queue>
#include <utility>

#include "bounds/counting_bound.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/closure.hpp"
#include "changeover/construct/standard_catalog.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/scope.hpp"
#include "changeover/verify/verdict.hpp"
#include "construct/needs.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

// Beyond that rules are not put on top of each other one by one: recipes have a limited depth.
constexpr std::size_t deepest_chain = max_recipe_depth / 2;

// Where nothing serves yet, designs with so many times the bound are looked for.
constexpr std::uint64_t most_worse = 4;

std::size_t depth(const Recipe& recipe) {
  std::size_t deepest = 0;
  for (const Recipe& input : recipe.inputs) {
    deepest = std::max(deepest, depth(input));
  }
  return deepest + 1;
}

Offer offer_of(Recipe recipe, std::uint64_t b) {
  Offer offer{std::move(recipe), b, false, false, false};
  offer.economical = b == counting_bound(offer.recipe.parameters);
  return offer;
}

}  // namespace

std::string PlannedCell::status() const {
  if (impossible) {
    return "impossible";
  }
  if (!best) {
    return "open";
  }
  return best->b == bound.blocks ? "minimum" : "best-known";
}

Plan::Plan(const PlanRange& range) : range_(range) {
  for (const Kind kind : {Kind::circular, Kind::linear}) {
    for (std::uint64_t k = range.k_from; k <= range.k_to; ++k) {
      for (std::uint64_t v = range.v_from; v <= range.v_to; ++v) {
        PlannedCell cell;
        cell.parameters = {.v = v, .k = k, .change = range.change, .kind = kind};
        if (v < k) {
          cell.impossible = "a block has at most v elements";
        } else if (range.change > k) {
          cell.impossible = "a block has at least m elements";
        } else if (range.only && !range.only->contains(cell.parameters)) {
          cell.impossible = "it is not among those that are planned";
        } else {
          cell.impossible = impossibility(cell.parameters);
          if (!cell.impossible) {
            stop_if_asked();
            cell.bound = lower_bound(cell.parameters);
          }
        }
        cells_.push_back(std::move(cell));
      }
    }
  }
}

std::optional<std::size_t> Plan::index(const Parameters& p) const {
  if (p.v < range_.v_from || p.v > range_.v_to || p.k < range_.k_from || p.k > range_.k_to ||
      p.change != range_.change || p.strength != 2) {
    return std::nullopt;
  }
  const std::uint64_t vs = range_.v_to - range_.v_from + 1;
  const std::uint64_t ks = range_.k_to - range_.k_from + 1;
  const std::uint64_t kind = p.kind == Kind::circular ? 0 : 1;
  return static_cast<std::size_t>((kind * ks + (p.k - range_.k_from)) * vs + (p.v - range_.v_from));
}

PlannedCell* Plan::find(const Parameters& p) {
  const auto at = index(p);
  return at ? &cells_[*at] : nullptr;
}

const PlannedCell& Plan::at(const Parameters& p) const {
  const auto at = index(p);
  if (!at) {
    throw BadInput(fmt::format("{} is outside the planned range", name(p)));
  }
  return cells_[*at];
}

namespace {

/// Relaxes cells in the order of their number of blocks.
class Relaxation {
 public:
  Relaxation(const Registry& registry, Plan& plan) : registry_(registry), plan_(plan) {}

  void run() {
    std::uint64_t asked = 0;
    for (const PlannedCell& cell : plan_.cells()) {
      tell("asking the constructions", ++asked);
      if (!cell.impossible) {
        if (auto offer = registry_.best(cell.parameters)) {
          improve(cell.parameters, *std::move(offer));
        }
      }
    }
    offer_from_other_change_numbers();
    settle_all();
    // A design that partial expansion makes may serve the other rules less well than the one it takes the place
    // of, so these come first.
    while (!expansions_.empty()) {
      for (auto& [p, offer] : std::exchange(expansions_, {})) {
        improve(p, std::move(offer));
      }
      settle_all();
    }
  }

 private:
  // Where the work is, and a place where it can stop.
  void tell(const char* phase, std::uint64_t cells) const {
    stop_if_asked();
    if (progress_due()) {
      report_progress({.phase = fmt::format("{} of {} cells", phase, plan_.cells().size()),
                       .steps = cells,
                       .unit = "cells"});
    }
  }

  struct Entry {
    std::uint64_t b;
    Parameters parameters;

    bool operator<(const Entry& other) const {  // the queue gives the largest first
      return std::pair(b, parameters) > std::pair(other.b, other.parameters);
    }
  };

  void settle_all() {
    while (!queue_.empty()) {
      const Entry entry = queue_.top();
      queue_.pop();
      PlannedCell& cell = *plan_.find(entry.parameters);
      if (cell.best && cell.best->b == entry.b) {  // otherwise it was improved since
        tell("building and verifying designs", ++settled_);
        settle(cell);
      }
    }
  }

  void improve(const Parameters& p, Offer offer) {
    PlannedCell* cell = plan_.find(p);
    if (cell == nullptr || cell->impossible || (cell->best && cell->best->b <= offer.b)) {
      return;
    }
    queue_.push({offer.b, p});
    cell->best = std::move(offer);
  }

  [[nodiscard]] bool improvable(const Parameters& p, std::uint64_t b) {
    const PlannedCell* cell = plan_.find(p);
    return cell != nullptr && !cell->impossible && (!cell->best || b < cell->best->b);
  }

  Design checked(const Offer& offer) {
    Design design = registry_.build_design(offer.recipe);
    if (design.block_count() != offer.b || !verify(design).valid()) {
      throw InternalError(fmt::format("the construction {} does not keep its promise for {}",
                                      offer.recipe.construction, name(offer.recipe.parameters)));
    }
    return design;
  }

  // The design is built once; what the rules make of it is looked at with the blocks at hand.
  void settle(PlannedCell& cell) {
    const Offer offer = *cell.best;
    const Parameters p = cell.parameters;
    const Design design = checked(offer);
    if (offer.b > cell.bound.blocks) {
      const std::uint64_t needed = needed_block_count(design);
      if (needed < offer.b) {
        improve(p, offer_of(drop_recipe(offer.recipe), needed));
        return;  // it comes again, better
      }
    }
    if (p.kind == Kind::circular) {
      cut_open(offer, design);
    }
    Parameters fixed = p;
    ++fixed.v;
    ++fixed.k;
    if (improvable(fixed, offer.b)) {
      improve(fixed, offer_of(fix_recipe(offer.recipe, 1), offer.b));
    }
    if (auto recipe = unfix_recipe(offer.recipe, design)) {
      const Parameters unfixed = recipe->parameters;
      if (improvable(unfixed, offer.b)) {
        improve(unfixed, offer_of(*std::move(recipe), offer.b));
      }
    }
    Parameters smaller = p;
    --smaller.v;
    if (p.change == 1 && p.kind == Kind::linear && depth(offer.recipe) < deepest_chain &&
        improvable(smaller, offer.b - 1)) {
      if (auto made = close_up_recipe(offer.recipe, design)) {
        improve(smaller, offer_of(std::move(made->recipe), made->b));
      }
    }
    if (improvable(smaller, offer.b)) {
      if (auto recipe = truncate_recipe(offer.recipe, design)) {
        improve(smaller, offer_of(*std::move(recipe), offer.b));
      }
    }
    expand(offer, design);
  }

  // New elements at the positions of a cover, which is searched for only if the smallest there can be would help.
  void expand(const Offer& offer, const Design& design) {
    const Parameters& p = offer.recipe.parameters;
    if (p.change >= p.k || depth(offer.recipe) >= deepest_chain) {
      return;
    }
    const std::uint64_t b = offer.b;
    const auto larger = [&p](std::uint64_t w) {
      Parameters result = p;
      result.v += w;
      return result;
    };
    const auto helps = [&](std::uint64_t w, std::uint64_t blocks) {
      const auto other = expansions_.find(larger(w));
      return improvable(larger(w), blocks) &&
             (other == expansions_.end() || blocks < other->second.b);
    };
    const CoverPositions least = smallest_cover(p, b + 1);
    std::vector<std::uint64_t> helpful;
    for (std::uint64_t w = 1; p.v + w <= plan_.range().v_to; ++w) {
      if (new_elements_fit(p, w) && helps(w, b + 1)) {
        const auto made = partial_expansion_count(p, b, least, w);
        if (made && helps(w, *made)) {
          helpful.push_back(w);
        }
      }
    }
    const auto cover = helpful.empty() ? std::nullopt : cover_positions(design);
    for (const std::uint64_t w : cover ? helpful : std::vector<std::uint64_t>{}) {
      const auto made = partial_expansion_count(p, b, *cover, w);
      if (made && helps(w, *made)) {
        expansions_.insert_or_assign(
            larger(w), offer_of(partial_expansion_recipe(offer.recipe, *cover, w), *made));
      }
    }
  }

  // Rules that lead from one change number to another: m from a proper divisor by blowing up, from 1 by
  // coarsening; 1 from 2 by interpolating, which looks no further, so that this ends.
  void offer_from_other_change_numbers() {
    const PlanRange& range = plan_.range();
    const std::uint64_t m = range.change;
    if (range.alone) {
      return;
    }
    // `source` says what makes a design of p with at most b blocks, if the plan is only of some.
    const auto each_best = [&](PlanRange other, const auto& source, const auto& take) {
      other.k_from = std::max<std::uint64_t>(2, other.k_from);
      other.v_from = std::max(other.v_from, other.k_from + 1);
      if (other.v_from > other.v_to || other.k_from > other.k_to) {
        return;
      }
      if (range.only) {
        Needs goals;
        for (const auto& [p, b] : *range.only) {
          if (const std::optional<std::pair<Parameters, std::uint64_t>> goal = source(p, b)) {
            goals.insert(*goal);
          }
        }
        other = narrowed(other, spread(goals, other));
        if (other.only->empty()) {
          return;
        }
      }
      const Plan plan = plan_range(registry_, other);
      for (const PlannedCell& cell : plan.cells()) {
        if (cell.best) {
          take(*cell.best);
        }
      }
    };
    using Goal = std::optional<std::pair<Parameters, std::uint64_t>>;
    if (m == 1) {
      each_best(
          {.v_from = range.v_from,
           .v_to = range.v_to,
           .k_from = range.k_from,
           .k_to = range.k_to,
           .change = 2,
           .alone = true},
          [](Parameters p, std::uint64_t b) -> Goal {
            p.change = 2;
            return std::pair(p, b / 2 + 1);
          },
          [&](const Offer& offer) {
            const std::uint64_t b = interpolated_count(offer.recipe.parameters, 1, offer.b);
            Parameters p = offer.recipe.parameters;
            p.change = 1;
            if (improvable(p, b)) {
              improve(p, offer_of(interpolate_recipe(offer.recipe, 1), b));
            }
          });
    }
    for (std::uint64_t s = 2; s <= m; ++s) {
      if (m % s == 0) {
        each_best(
            {.v_from = ceil_div(range.v_from, s),
             .v_to = range.v_to / s,
             .k_from = ceil_div(range.k_from, s),
             .k_to = range.k_to / s,
             .change = m / s},
            [s](Parameters p, std::uint64_t b) -> Goal {
              if (p.v % s != 0 || p.k % s != 0) {
                return std::nullopt;
              }
              p.v /= s;
              p.k /= s;
              p.change /= s;
              return std::pair(p, b);
            },
            [&](const Offer& offer) {
              Recipe recipe = blow_up_recipe(offer.recipe, s);
              const Parameters p = recipe.parameters;
              improve(p, offer_of(std::move(recipe), offer.b));
            });
      }
    }
    if (m >= 2 && range.k_to > m) {
      each_best(
          {.v_from = range.v_from,
           .v_to = range.v_to,
           .k_from = range.k_from > m ? range.k_from - m + 1 : 2,
           .k_to = range.k_to - m + 1,
           .change = 1},
          [m](Parameters p, std::uint64_t b) -> Goal {
            if (p.kind != Kind::linear || p.k <= m) {
              return std::nullopt;
            }
            p.k -= m - 1;
            p.change = 1;
            return std::pair(p, b * m);
          },
          [&](const Offer& offer) { coarsen(offer, m); });
    }
  }

  void coarsen(const Offer& offer, std::uint64_t m) {
    Parameters p = offer.recipe.parameters;
    if (p.kind != Kind::linear) {
      return;
    }
    p.k += m - 1;
    p.change = m;
    if (p.k < p.v && improvable(p, ceil_div(offer.b, m))) {
      if (auto made = coarsen_recipe(offer.recipe, registry_.build_design(offer.recipe), m)) {
        improve(p, offer_of(std::move(made->recipe), made->b));
      }
    }
  }

  // The cut that lets most blocks be dropped.
  void cut_open(const Offer& offer, const Design& design) {
    Parameters linear = design.parameters();
    linear.kind = Kind::linear;
    PlannedCell* cell = plan_.find(linear);
    if (cell == nullptr || cell->impossible) {
      return;
    }
    if (improvable(linear, offer.b)) {
      improve(linear, offer_of(cut_recipe(offer.recipe), offer.b));
    }
    constexpr std::size_t most_cuts = 64;
    if (cell->best->b < offer.b || cell->best->b == cell->bound.blocks) {
      return;
    }
    const BestCut cut = best_cut(design, most_cuts, cell->bound.blocks);
    if (cut.needed < cell->best->b) {
      improve(linear, offer_of(drop_recipe(cut_recipe(offer.recipe, cut.at)), cut.needed));
    }
  }

  const Registry& registry_;
  Plan& plan_;
  std::priority_queue<Entry> queue_;
  std::map<Parameters, Offer> expansions_;  // the best ones of the designs that were settled
  std::uint64_t settled_ = 0;
};

}  // namespace

PlanRange range_of_a_table(const PlanRange& shown) {
  constexpr std::uint64_t margin = 8;
  PlanRange range = shown;
  range.k_from = std::max<std::uint64_t>(2, shown.k_from - 1);
  // And w elements more at once by partial expansion, at most about every k-th; what is better comes from there.
  const std::uint64_t less =
      std::max(shown.k_to - range.k_from, shown.v_from / shown.k_from + margin);
  range.v_from = shown.v_from - std::min(shown.v_from - 2, less);
  range.v_to = std::min(shown.v_to + margin, largest_v_of_a_plan);
  return range;
}

Plan plan_range(const Registry& registry, const PlanRange& range) {
  if (range.v_from > range.v_to || range.k_from > range.k_to || range.k_from < 2) {
    throw ImpossibleParameters(fmt::format("the range v = {}..{}, k = {}..{} is empty or has k < 2",
                                           range.v_from, range.v_to, range.k_from, range.k_to));
  }
  if (range.v_to > largest_v_of_a_plan) {
    throw ImpossibleParameters(fmt::format("v = {} exceeds {}, the most that is planned at once",
                                           range.v_to, largest_v_of_a_plan));
  }
  if (range.change < 1) {
    throw ImpossibleParameters("change = 0: consecutive blocks must differ in at least 1 element");
  }
  if (range.k_to - range.k_from >= most_cells_of_a_plan / 2 / (range.v_to - range.v_from + 1)) {
    throw ImpossibleParameters(
        fmt::format("the range has more than {} cells", most_cells_of_a_plan));
  }
  Plan plan(range);
  Relaxation(registry, plan).run();
  return plan;
}

namespace {

// How many elements in every block a plan for one cell allows for.
constexpr std::uint64_t most_fixed = 24;

// Blocks that some design for p has, as fixing, blowing up and cutting one offer show: what is
// worse need not be planned for. O(24·d(m)) offers.
std::optional<std::uint64_t> upper_estimate(const Registry& registry, const Parameters& p) {
  std::optional<std::uint64_t> least;
  for (std::uint64_t f = 0; f <= std::min(p.k - 2, most_fixed); ++f) {
    for (std::uint64_t s = 1; s <= p.change; ++s) {
      if (p.change % s != 0 || (p.v - f) % s != 0 || (p.k - f) % s != 0 || p.k - f < p.change ||
          (p.k - f) / s < 2) {
        continue;
      }
      Parameters input{(p.v - f) / s, (p.k - f) / s, p.change / s, Kind::circular, p.strength};
      const auto consider = [&] {
        const auto offer = impossibility(input) ? std::nullopt : registry.best(input);
        if (offer && (!least || offer->b < *least)) {
          least = offer->b;
        }
      };
      consider();
      if (p.kind == Kind::linear) {
        input.kind = Kind::linear;
        consider();
      }
    }
  }
  return least;
}

}  // namespace

std::optional<Offer> best_known(const Registry& registry, const Parameters& p,
                                std::uint64_t largest_v) {
  std::optional<Offer> best = registry.best(p);
  if (p.strength != 2 || p.k < 2 || p.v > largest_v || impossibility(p) ||
      (best && best->b == lower_bound(p).blocks)) {
    return best;
  }
  // The cells that the catalog comes with were planned with all others; only what the user has added can be news.
  if (const Catalog* const catalog = registry.catalog();
      best && catalog != nullptr && comes_planned(p) && !catalog->largest_users_v()) {
    return best;
  }
  // Rules come from nearby: fix from (v−i, k−i), unfix from (v+1, k+1), truncate and close up from more elements,
  // partial expansion from fewer.
  constexpr std::uint64_t above = 8;
  const PlanRange limits{.v_from = 2,
                         .v_to = p.v + above,
                         .k_from = p.k - std::min(p.k - 2, most_fixed),
                         .k_to = p.k + 1,
                         .change = p.change};
  // Some blocks may be dropped in the end.
  std::uint64_t enough =
      best ? best->b - 1 + std::min<std::uint64_t>(p.k / 2, 4) : most_worse * lower_bound(p).blocks;
  if (const auto estimate = upper_estimate(registry, p)) {
    enough = std::min(enough, *estimate + std::min<std::uint64_t>(p.k / 2, 4));
  }
  const Needs needs = spread({{p, enough}}, limits);
  if (!needs.contains(p)) {
    return best;
  }
  const Plan plan = plan_range(registry, narrowed(limits, needs));
  const std::optional<Offer>& planned = plan.at(p).best;
  return planned && (!best || planned->b < best->b) ? planned : best;
}

std::optional<VerifiedDesign> best_known_design(const Parameters& p) {
  const Registry& registry = Registry::standard();
  const auto best = best_known(registry, p);
  if (!best) {
    return std::nullopt;
  }
  require_memory(checked_multiply(checked_multiply(best->b, p.k), sizeof(Element)),
                 "the best design that is known, the " + name(p) + ",");
  const std::unique_ptr<BlockSource> blocks = registry.build(best->recipe);
  Design design(p);
  design.reserve(static_cast<std::size_t>(best->b));
  Block block(static_cast<std::size_t>(p.k));
  while (blocks->next(block)) {
    stop_if_asked();
    design.append(block);
  }
  design.set_labels(registry.construction_of(best->recipe).labels(best->recipe, registry));
  design.recipe = best->recipe;
  return surely_verified(std::move(design), "the best recipe for the " + name(p));
}

}  // namespace changeover
