#include "changeover/construct/path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "changeover/core/error.hpp"
#include "changeover/core/transitions.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t unreached = std::numeric_limits<std::uint64_t>::max();

/// One step at distance d from the goal: of the m that go, a are not in the goal; of the m that come,
/// h are in neither block.
struct Move {
  std::uint64_t a = 0;
  std::uint64_t h = 0;
};

/// Calls visit(next distance, move) for every move that k, m, v allow at distance d.
template <typename Visit>
void for_each_move(std::uint64_t d, std::uint64_t k, std::uint64_t m, std::uint64_t v,
                   Visit&& visit) {
  const std::uint64_t outside = v - k - d;  // in neither block
  for (std::uint64_t a = 0; a <= std::min(m, d); ++a) {
    if (m - a > k - d) {
      continue;
    }
    for (std::uint64_t h = 0; h <= std::min(m, outside); ++h) {
      if (m - h <= d) {
        visit(d - a + h, Move{a, h});
      }
    }
  }
}

/// The number of steps to distance 0 from every distance up to min(k, v−k).
std::vector<std::uint64_t> steps_to_goal(std::uint64_t k, std::uint64_t m, std::uint64_t v) {
  const std::uint64_t farthest = std::min(k, v - k);
  std::vector<std::uint64_t> steps(static_cast<std::size_t>(farthest) + 1, unreached);
  steps[0] = 0;
  // A step can be made backwards, so distances are reached from 0 outwards.
  std::vector<std::uint64_t> frontier{0};
  for (std::uint64_t count = 1; !frontier.empty(); ++count) {
    std::vector<std::uint64_t> next;
    for (const std::uint64_t d : frontier) {
      for_each_move(d, k, m, v, [&](std::uint64_t to, Move) {
        if (to <= farthest && steps[static_cast<std::size_t>(to)] == unreached) {
          steps[static_cast<std::size_t>(to)] = count;
          next.push_back(to);
        }
      });
    }
    frontier = std::move(next);
  }
  return steps;
}

}  // namespace

std::optional<std::uint64_t> connecting_steps(std::uint64_t distance, std::uint64_t k,
                                              std::uint64_t change, std::uint64_t v) {
  if (v < k || change < 1 || change > k || distance > std::min(k, v - k)) {
    return std::nullopt;
  }
  const std::uint64_t steps = steps_to_goal(k, change, v)[static_cast<std::size_t>(distance)];
  return steps == unreached ? std::nullopt : std::optional(steps);
}

std::vector<Block> connecting_blocks(const Block& from, const Block& to, std::uint64_t change,
                                     std::uint64_t v) {
  const std::uint64_t k = from.size();
  const std::vector<std::uint64_t> steps = steps_to_goal(k, change, v);
  std::vector<Block> between;
  Block here = from;
  while (true) {
    const Block wrong = difference(here, to);
    const Block wanted = difference(to, here);
    const auto d = static_cast<std::uint64_t>(wrong.size());
    const std::uint64_t left = steps[static_cast<std::size_t>(d)];
    if (left == unreached || (d == 0 && between.empty())) {
      throw ImpossibleParameters(fmt::format(
          "no way from a block to another by changes of {} for v = {}, k = {}", change, v, k));
    }
    if (left <= 1) {
      return between;
    }
    std::optional<Move> move;
    for_each_move(d, k, change, v, [&](std::uint64_t next, Move candidate) {
      if (!move && steps[static_cast<std::size_t>(next)] == left - 1) {
        move = candidate;
      }
    });
    Block going(wrong.begin(), wrong.begin() + static_cast<std::ptrdiff_t>(move->a));
    const Block right = intersection(here, to);
    going.insert(going.end(), right.begin(),
                 right.begin() + static_cast<std::ptrdiff_t>(change - move->a));
    Block coming(wanted.begin(), wanted.begin() + static_cast<std::ptrdiff_t>(change - move->h));
    Block taken = here;
    taken.insert(taken.end(), to.begin(), to.end());
    std::sort(taken.begin(), taken.end());
    for (Element x = 0; coming.size() < change; ++x) {
      if (!std::binary_search(taken.begin(), taken.end(), x)) {
        coming.push_back(x);
      }
    }
    here = difference(here, going);
    here.insert(here.end(), coming.begin(), coming.end());
    between.push_back(here);
  }
}

}  // namespace changeover
