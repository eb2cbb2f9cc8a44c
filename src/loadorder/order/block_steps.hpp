// Internal: blocks as steps. Elements that a block introduces are loaded; those that left it are
// evicted before.
#pragma once

#include <algorithm>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/loadorder/load_order.hpp"

namespace changeover {

/// The steps of a stream of blocks, which is read once, to its end. The step back to the first
/// block of a circular design is left out. O(k) per block.
class BlockSteps final : public StepSource {
 public:
  /// `keeper` is an object that must live as long as the blocks.
  explicit BlockSteps(std::unique_ptr<BlockSource> blocks,
                      std::shared_ptr<const void> keeper = nullptr)
      : keeper_(std::move(keeper)),
        blocks_(std::move(blocks)),
        mark_(static_cast<std::size_t>(blocks_->parameters().v), 0),
        block_(static_cast<std::size_t>(blocks_->parameters().k)),
        before_(block_.size()) {}

  bool next(Step& step) override {
    if (!blocks_->next(block_)) {
      return false;
    }
    step.number = ++number_;
    step.load.clear();
    step.evict.clear();
    if (number_ == 1) {
      step.load.assign(block_.begin(), block_.end());
    } else {
      take_changes(step);
    }
    std::swap(before_, block_);
    return true;
  }

 private:
  // Most places do not change: many are skipped at a time.
  void take_changes(Step& step) {
    constexpr std::size_t at_a_time = 64;
    changed_.clear();
    for (std::size_t from = 0; from < block_.size(); from += at_a_time) {
      const std::size_t to = std::min(from + at_a_time, block_.size());
      if (std::memcmp(&block_[from], &before_[from], (to - from) * sizeof(Element)) != 0) {
        for (std::size_t i = from; i < to; ++i) {
          if (block_[i] != before_[i]) {
            changed_.push_back(i);
          }
        }
      }
    }
    // mark_[x] is 2n if x left its place in block n, and 2n+1 if it entered another one.
    for (const std::size_t i : changed_) {
      mark_[before_[i]] = 2 * number_;
    }
    for (const std::size_t i : changed_) {
      const Element x = block_[i];
      if (mark_[x] != 2 * number_) {
        step.load.push_back(x);
      }
      mark_[x] = 2 * number_ + 1;
    }
    for (const std::size_t i : changed_) {
      if (mark_[before_[i]] == 2 * number_) {
        step.evict.push_back(before_[i]);
      }
    }
  }

  std::shared_ptr<const void> keeper_;
  std::unique_ptr<BlockSource> blocks_;
  std::vector<std::uint64_t> mark_;
  std::vector<std::size_t> changed_;
  Block block_;
  Block before_;
  std::uint64_t number_ = 0;
};

}  // namespace changeover
