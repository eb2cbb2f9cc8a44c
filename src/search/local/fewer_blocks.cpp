#include "search/local/fewer_blocks.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "changeover/construct/best_known.hpp"
#include "changeover/core/error.hpp"

namespace changeover {
namespace {

constexpr int tries_to_leave_out = 60;
constexpr std::array<double, 2> opened_from = {0.17, 0.22};  // in turn
constexpr double opened_cooling = 0.6;

std::vector<std::size_t> shuffled(std::size_t count, Random& random) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  shuffle(order, random);
  return order;
}

}  // namespace

std::optional<Design> without_a_block(const Design& best, Random& random) {
  const std::size_t b = best.block_count();
  const bool circular = best.parameters().kind == Kind::circular;
  for (int i = 0; i < tries_to_leave_out && b > 4; ++i) {
    const std::size_t at = random.below(static_cast<std::uint32_t>(b));
    if (!circular && (at == 0 || at + 1 == b)) {
      continue;
    }
    if (difference(best.block((at + 1) % b), best.block((at + b - 1) % b)).size() ==
        best.parameters().change) {
      Design list(best.parameters());
      for (std::size_t j = 0; j < b; ++j) {
        if (j != at) {
          list.append(best.block(j));
        }
      }
      return list;
    }
  }
  return std::nullopt;
}

std::optional<Design> known_circle(const Parameters& p) {
  const Parameters circular = p.as(Kind::circular);
  if (p.kind == Kind::circular || impossibility(circular)) {
    return std::nullopt;
  }
  try {
    const auto known = best_known_design(circular);
    return known ? std::optional(known->design()) : std::nullopt;
  } catch (const MissingResource&) {
    return std::nullopt;
  }
}

OpenedOutcome anneal_opened(const Design& circle, const Parameters& p, const Attempt& attempt,
                            Random& random, RunControl& control,
                            const std::function<AnnealWatch(std::uint64_t)>& watch) {
  OpenedOutcome outcome;
  outcome.least = std::numeric_limits<std::uint32_t>::max();
  const std::size_t b = circle.block_count();
  const std::size_t blocks = std::min(static_cast<std::size_t>(attempt.aim), b);
  AnnealSchedule schedule{.moves = std::max<std::uint64_t>(1, attempt.moves / b),
                          .hot = opened_from[attempt.number % opened_from.size()]};
  schedule.cold = opened_cooling * schedule.hot;
  for (const std::size_t begin : shuffled(b, random)) {
    Design list(p);
    for (std::size_t i = 0; i < blocks; ++i) {
      list.append(circle.block((begin + i) % b));
    }
    Annealed annealed = anneal_blocks(list, 0, schedule, random, control, watch(outcome.moves));
    outcome.moves += annealed.outcome.moves;
    outcome.least = std::min(outcome.least, annealed.outcome.least);
    outcome.stopped = annealed.outcome.stopped;
    outcome.design = std::move(annealed.design);
    if (outcome.design || outcome.stopped || outcome.moves >= attempt.moves) {
      break;
    }
  }
  return outcome;
}

}  // namespace changeover
