#include <algorithm>

#include "changeover/search/ordering.hpp"
#include "plan/anneal.hpp"
#include "plan/starts.hpp"

namespace changeover::plan_detail {
namespace {

// The weight of what `to` has and `from` lacks; both increasing.
std::uint64_t distance(const Weights& weights, const Block& from, const Block& to) {
  std::uint64_t weight = 0;
  for (const Element x : to) {
    weight += std::binary_search(from.begin(), from.end(), x) ? 0 : weights.change[x];
  }
  return weight;
}

// Puts the set-up nearest to the one before next, over and over.
void nearest_next(const Job& job, const Weights& weights, std::vector<Block>& setups) {
  Block before = job.start;
  std::sort(before.begin(), before.end());
  for (Block& setup : setups) {
    std::sort(setup.begin(), setup.end());
  }
  for (auto at = setups.begin(); at != setups.end(); ++at) {
    std::iter_swap(at, std::min_element(at, setups.end(), [&](const Block& x, const Block& y) {
                     return distance(weights, before, x) < distance(weights, before, y);
                   }));
    before = *at;
  }
}

}  // namespace

std::vector<Block> order_cheaply(const Job& job, const Weights& weights, std::vector<Block> setups,
                                 RunControl& control) {
  const bool one_weight = std::all_of(weights.change.begin(), weights.change.end(),
                                      [&](std::uint64_t w) { return w == weights.change.front(); });
  if (one_weight && job.start.empty()) {
    RunControl own(control, 1U);
    setups = arranged(
        setups, order_for_least_change(setups, {.v = job.parts()}, {.bound_effort = 0}, own).order);
  } else {
    nearest_next(job, weights, setups);
  }
  Sequence sequence(job, weights, setups);
  constexpr std::size_t longest_moved = 3;
  bool again = true;
  while (again && !control.stop_wanted()) {
    again = false;
    for (std::size_t i = 0; i < sequence.size(); ++i) {
      for (std::size_t j = i + 1; j < sequence.size(); ++j) {
        const std::int64_t cost = sequence.cost();
        sequence.reverse({i, j});
        if (sequence.cost() < cost) {
          again = true;
          continue;
        }
        sequence.reverse({i, j});
        if (j - i <= longest_moved) {  // The stretch [i, j) to every other place.
          for (std::size_t end = j + 1; end <= sequence.size(); ++end) {
            sequence.rotate(i, j, end);
            if (sequence.cost() < cost) {
              again = true;
              break;
            }
            sequence.rotate(i, i + end - j, end);
          }
        }
      }
      if (control.stop_wanted()) {
        return sequence.setups();
      }
    }
  }
  return sequence.setups();
}

}  // namespace changeover::plan_detail
