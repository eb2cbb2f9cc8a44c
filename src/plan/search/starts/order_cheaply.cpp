#include <algorithm>

#include "changeover/run/control.hpp"
#include "changeover/search/local_search.hpp"
#include "plan/search/listener.hpp"
#include "plan/search/starts/starts.hpp"

namespace changeover {
namespace {

// The weight of the parts of `to` that `from` lacks; both increasing.
std::uint64_t distance(const Weights& weights, const Block& from, const Block& to) {
  std::uint64_t weight = 0;
  for (const Element x : to) {
    weight += std::binary_search(from.begin(), from.end(), x) ? 0 : weights.change[x];
  }
  return weight;
}

// Repeatedly puts the set-up closest to the one before next, until all are placed or it is stopped.
void nearest_next(const Job& job, const Weights& weights, std::vector<Block>& setups,
                  RunControl& control) {
  Block before = job.start;
  std::sort(before.begin(), before.end());
  for (Block& setup : setups) {
    std::sort(setup.begin(), setup.end());
  }
  Listener listener(control);
  for (auto at = setups.begin(); at != setups.end(); ++at) {
    auto nearest = at;
    std::uint64_t least = distance(weights, before, *at);
    for (auto other = at + 1; other != setups.end(); ++other) {
      if (listener.stop_wanted(job.room())) {
        return;
      }
      if (const std::uint64_t weight = distance(weights, before, *other); weight < least) {
        nearest = other;
        least = weight;
      }
    }
    std::iter_swap(at, nearest);
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
    try {
      setups = arranged(
          setups,
          order_for_least_change(setups, {.v = job.parts()}, {.bound_effort = 0}, own).order);
    } catch (const Stopped&) {
      return setups;
    }
  } else {
    nearest_next(job, weights, setups, control);
  }
  Sequence sequence(job, weights, setups);
  constexpr std::size_t longest_moved = 3;
  Listener listener(control);
  bool again = true;
  while (again) {
    again = false;
    for (std::size_t i = 0; i < sequence.size(); ++i) {
      for (std::size_t j = i + 1; j < sequence.size(); ++j) {
        if (listener.stop_wanted(job.room())) {
          return sequence.setups();
        }
        if (sequence.rise_of_reverse({i, j}) < 0) {
          sequence.reverse({i, j});
          again = true;
          continue;
        }
        if (j - i <= longest_moved) {  // moves the stretch [i, j) to every other place
          for (std::size_t end = j + 1; end <= sequence.size(); ++end) {
            if (listener.stop_wanted(job.room())) {
              return sequence.setups();
            }
            if (sequence.rise_of_rotate(i, j, end) < 0) {
              sequence.rotate(i, j, end);
              again = true;
              break;
            }
          }
        }
      }
    }
  }
  return sequence.setups();
}

}  // namespace changeover
