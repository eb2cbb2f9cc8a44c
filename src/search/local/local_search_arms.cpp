#include "search/local/local_search_arms.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "search/local/imposed.hpp"
#include "search/local/segment_orbits.hpp"
#include "search/local/segment_pairs.hpp"
#include "search/local/segment_subsets.hpp"

namespace changeover {
namespace {

using Method = SearchArm::Method;

constexpr std::uint64_t first_budget_free = std::uint64_t{1} << 20;
constexpr std::uint64_t first_budget_reheated = std::uint64_t{1} << 19;
constexpr std::uint64_t first_budget_opened = std::uint64_t{1} << 24;
constexpr std::uint64_t first_budget_imposed = std::uint64_t{1} << 18;
constexpr std::uint64_t largest_budget = std::uint64_t{1} << 40;
constexpr std::uint64_t most_missed = 30;  // limit for counting
constexpr std::uint64_t cost_of_imposed =
    4;  // of a move, relative to one of blocks without symmetry
constexpr std::uint64_t fewest_blocks_of_a_circle = 3;

// a · b, or the largest number.
std::uint64_t saturated(std::uint64_t a, std::uint64_t b) {
  std::uint64_t product = 0;
  return __builtin_mul_overflow(a, b, &product) ? std::numeric_limits<std::uint64_t>::max()
                                                : product;
}

}  // namespace

SearchArms::SearchArms(const Parameters& p, std::uint64_t goal, const Kinds& kinds,
                       const WorkShare& share, std::optional<std::uint64_t> most_bytes)
    : parameters_(p), goal_(goal), most_bytes_(most_bytes) {
  arms_.push_back({.method = Method::free, .budget = first_budget_free});
  arms_.push_back({.method = Method::cold, .budget = first_budget_free});
  arms_.push_back({.method = Method::reheated, .budget = first_budget_reheated});
  if (kinds.opened) {
    arms_.push_back({.method = Method::opened, .budget = first_budget_opened});
  }
  if (kinds.imposed && p.strength == 2) {
    for (std::uint64_t extra = 0; extra <= SearchArm::most_extra; ++extra) {
      stop_if_asked();
      for (const Automorphism& pi : imposed_automorphisms(p.v + extra)) {
        if (extra == 0 || pi.fixed == 0) {
          arms_.push_back({.method = Method::imposed,
                           .order = static_cast<std::uint32_t>(pi.n),
                           .fixed = static_cast<std::uint32_t>(pi.fixed),
                           .extra = extra,
                           .budget = first_budget_imposed});
        }
      }
    }
  }
  if (p.kind == Kind::linear) {
    // A circular design has at least this many blocks.
    allowance_ = binomial(p.k, p.strength) / newly_covered_at_most(p);
  }
  if (share.of > 1) {
    const std::uint64_t first = arms_.size() * (share.index % share.of) / share.of;
    std::rotate(arms_.begin(), arms_.begin() + static_cast<std::ptrdiff_t>(first), arms_.end());
  }
  for (const SearchArm& arm : arms_) {
    stop_if_asked();
    std::uint64_t fewest = 0;
    if (arm.method == Method::imposed) {
      const Parameters circle = parameters_of(arm);
      const std::uint64_t bound = std::max(lower_bound(circle).blocks, fewest_blocks_of_a_circle);
      fewest = std::max(fewest_base_blocks(circle, *arm.automorphism(parameters_.v)),
                        ceil_div(bound, arm.order));
    }
    fewest_.push_back(fewest);
  }
  no_memory_.assign(arms_.size(), false);
}

void SearchArms::restore(const std::vector<SearchArm>& arms) {
  for (SearchArm& mine : arms_) {
    const auto same = std::ranges::find_if(arms, [&](const SearchArm& arm) {
      return arm.method == mine.method && arm.order == mine.order && arm.fixed == mine.fixed &&
             arm.extra == mine.extra;
    });
    if (same != arms.end()) {
      mine = *same;
    }
  }
}

std::uint64_t SearchArms::bytes(const SearchArm& arm, std::uint64_t aim) const {
  if (arm.method != Method::imposed) {
    return annealing_bytes(parameters_, aim);
  }
  try {
    return SegmentOrbits::bytes(parameters_of(arm), *arm.automorphism(parameters_.v), aim);
  } catch (const ImpossibleParameters&) {
    return std::numeric_limits<std::uint64_t>::max();
  }
}

std::uint64_t SearchArms::bytes_left_out(std::uint64_t best) const {
  std::uint64_t least = 0;
  for (std::size_t i = 0; i < arms_.size(); ++i) {
    const auto nearest = aim(arms_[i], best, 1);
    if (nearest && is_left_out(i, *nearest)) {
      const std::uint64_t needed = bytes(arms_[i], *nearest);
      least = least == 0 ? needed : std::min(least, needed);
    }
  }
  return least;
}

Parameters SearchArms::parameters_of(const SearchArm& arm) const {
  return arm.method == Method::imposed
             ? parameters_.on(parameters_.v + arm.extra).as(Kind::circular)
             : parameters_;
}

std::optional<std::uint64_t> SearchArms::aim(const SearchArm& arm, std::uint64_t best,
                                             std::uint64_t step) const {
  if (best <= goal_) {
    return std::nullopt;
  }
  if (arm.method != Method::imposed) {
    const std::uint64_t most = arm.from_design() ? 1 : step;
    return std::max(goal_, best - std::min(most, best - 1));
  }
  const auto at = static_cast<std::size_t>(&arm - arms_.data());
  const std::uint64_t most = (best - 1 + allowance_) / arm.order;
  if (most < fewest_[at]) {
    return std::nullopt;
  }
  return std::max(fewest_[at], most - std::min(most, step - 1));
}

std::optional<Attempt> SearchArms::next(std::uint64_t best) {
  std::optional<Attempt> chosen;
  std::uint64_t least = 0;
  for (std::size_t i = 0; i < arms_.size(); ++i) {
    SearchArm& arm = arms_[i];
    const auto nearest = aim(arm, best, 1);
    if (!nearest || is_left_out(i, *nearest)) {
      continue;
    }
    if (arm.spent == 0 && !arm.from_design()) {
      // Try first half way down.
      const auto farthest = aim(arm, best, best).value_or(*nearest);
      arm.step = std::max<std::uint64_t>(1, (*nearest - farthest) / 2);
    }
    const std::uint64_t weight = 1 + std::min(arm.missed, most_missed);
    const std::uint64_t each = arm.method == Method::imposed ? cost_of_imposed : 1;
    const std::uint64_t cost = saturated(saturated(arm.spent + arm.budget, each), weight * weight);
    if (!chosen || cost < least) {
      least = cost;
      const std::uint64_t target = aim(arm, best, arm.step).value_or(*nearest);
      std::uint64_t promise = target;
      if (arm.method == Method::imposed) {
        promise *= arm.order;
        promise -= std::min(allowance_, promise);
      }
      chosen = Attempt{i, 0, target, promise, arm.budget, target == *nearest};
    }
  }
  if (chosen) {
    arms_[chosen->arm].spent += chosen->moves;
  }
  return chosen;
}

void SearchArms::report(const Attempt& attempt, std::uint64_t missed, bool improved) {
  SearchArm& arm = arms_[attempt.arm];
  // A few base blocks are soon searched through; further moves would be wasted.
  const std::uint64_t largest =
      arm.method == Method::imposed
          ? std::min(saturated(first_budget_imposed / 2, saturated(attempt.aim, attempt.aim)),
                     SearchArm::most_moves)
          : largest_budget;
  const std::uint64_t doubled = std::max(arm.budget, std::min(arm.budget * 2, largest));
  if (missed == 0) {
    // Another design with the same symmetry may have a shorter cut: it gets as many moves again, no
    // more.
    arm.step = improved ? std::min(arm.step * 2, SearchArm::most_step) : 1;
    arm.missed = improved ? 0 : arm.missed + 1;
  } else if (attempt.nearest) {
    // An attempt that cannot take more moves can only be repeated, with decreasing priority.
    arm.missed = doubled > arm.budget ? missed : std::max(missed, arm.missed + 1);
    arm.budget = doubled;
    arm.step = 1;
  } else {
    arm.step = arm.from_random_list() ? std::max<std::uint64_t>(1, arm.step / 2) : 1;
  }
  if (improved) {
    for (SearchArm& other : arms_) {
      if (other.from_design()) {
        other.missed = 0;
      }
    }
  }
}

namespace {

using Bytes = SegmentPairs<std::uint8_t>;
using Words = SegmentPairs<std::uint16_t>;

template <typename State>
Annealed run(State state, const AnnealSchedule& schedule, Random& random, RunControl& control,
             const AnnealWatch& watch) {
  Annealed annealed;
  annealed.outcome = anneal(state, schedule, random, control, watch);
  if (annealed.outcome.missing == 0) {
    annealed.design = state.design();
    if constexpr (requires { state.parts(); }) {
      annealed.parts = state.parts();
    }
  }
  return annealed;
}

}  // namespace

std::uint64_t annealing_bytes(const Parameters& p, std::uint64_t blocks) {
  constexpr std::uint64_t too_many = std::numeric_limits<std::uint64_t>::max();
  constexpr std::uint64_t most_blocks = std::numeric_limits<std::uint32_t>::max();
  constexpr std::uint64_t most_occurrences = std::numeric_limits<std::uint8_t>::max() / 2;
  if (p.v > max_elements_in_memory || blocks > most_blocks) {
    return too_many;
  }
  if (p.strength == 2) {
    // Some element may be in more blocks than the average.
    return blocks * p.k / p.v < most_occurrences ? Bytes::bytes(p.v, p.k, blocks)
                                                 : Words::bytes(p.v, p.k, blocks);
  }
  try {
    return SegmentSubsets::bytes(p, blocks);
  } catch (const ImpossibleParameters&) {
    return too_many;
  }
}

Annealed anneal_blocks(const Design& start, std::size_t frozen, const AnnealSchedule& schedule,
                       Random& random, RunControl& control, const AnnealWatch& watch,
                       const Locks& locks) {
  control.require_memory(annealing_bytes(start.parameters(), start.block_count()),
                         "local search for the " + name(start.parameters()));
  if (start.parameters().strength != 2) {
    return run(SegmentSubsets(start, frozen), schedule, random, control, watch);
  }
  if (Bytes::fits(start)) {
    return run(Bytes(start, frozen, locks), schedule, random, control, watch);
  }
  if (Words::fits(start)) {
    return run(Words(start, frozen, locks), schedule, random, control, watch);
  }
  throw MissingResource("local search supports elements in at most 65535 blocks each");
}

}  // namespace changeover
