// Internal: passes steps on and counts the pairs that each worker computes: pairs of two items,
// each once, as (i,j) with i < j. Items alone and (j,i) are not counted.
//
//     CountedPairs counted(order.stream(), 2);
//     check_schedule(counted, rules);
//     counted.pairs()                          // {7, 8}
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "changeover/loadorder/schedule.hpp"

namespace changeover {

class CountedPairs final : public StepSource {
 public:
  CountedPairs(std::unique_ptr<StepSource> steps, std::uint64_t workers)
      : steps_(std::move(steps)), pairs_(static_cast<std::size_t>(workers), 0) {}

  bool next(Step& step) override {
    if (!steps_->next(step)) {
      return false;
    }
    if (step.worker < pairs_.size()) {
      const auto count = [](const std::vector<ItemPair>& pairs) {
        return static_cast<std::uint64_t>(std::ranges::count_if(
            pairs, [](const ItemPair& pair) { return pair.first < pair.second; }));
      };
      pairs_[static_cast<std::size_t>(step.worker)] += count(step.compute) + count(step.overlap);
    }
    return true;
  }

  [[nodiscard]] const std::vector<std::uint64_t>& pairs() const { return pairs_; }

 private:
  std::unique_ptr<StepSource> steps_;
  std::vector<std::uint64_t> pairs_;  // by worker
};

}  // namespace changeover
