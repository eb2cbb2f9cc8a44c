// Internal: blocks as steps. What a block introduces is loaded, what left is evicted before.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/loadorder/load_order.hpp"

namespace changeover {

/// Steps of a stream of blocks, which is read once, to its end; the step back to the first block of a
/// circular one is not made. O(k) a block.
class BlockSteps final : public StepSource {
 public:
  /// `keeper` is whatever must live as long as the blocks.
  explicit BlockSteps(std::unique_ptr<BlockSource> blocks,
                      std::shared_ptr<const void> keeper = nullptr)
      : keeper_(std::move(keeper)),
        blocks_(std::move(blocks)),
        seen_(static_cast<std::size_t>(blocks_->parameters().v), 0),
        block_(static_cast<std::size_t>(blocks_->parameters().k)) {}

  bool next(Step& step) override {
    if (!blocks_->next(block_)) {
      return false;
    }
    step.number = ++number_;
    step.load.clear();
    step.evict.clear();
    // seen_[x] is the number of the last block that holds x.
    for (const Element x : block_) {
      if (number_ == 1 || seen_[x] != number_ - 1) {
        step.load.push_back(x);
      }
      seen_[x] = number_;
    }
    for (const Element x : before_) {
      if (seen_[x] != number_) {
        step.evict.push_back(x);
      }
    }
    before_ = block_;
    return true;
  }

 private:
  std::shared_ptr<const void> keeper_;
  std::unique_ptr<BlockSource> blocks_;
  std::vector<std::uint64_t> seen_;
  Block block_;
  Block before_;
  std::uint64_t number_ = 0;
};

}  // namespace changeover
