#include "loadorder/pairs/held/held_blocks.hpp"

#include <algorithm>
#include <utility>

#include "core/checked.hpp"
#include "core/each.hpp"

namespace changeover {
namespace {

// Estimates the loads of a items with b others, where groups of one set stay; exact up to the
// number of items that stay at a time.
std::uint64_t estimate(std::uint64_t a, std::uint64_t b, std::uint64_t room) {
  const auto held = [&](std::uint64_t x, std::uint64_t y) {
    return checked_add(x, checked_multiply(ceil_div(x, room - 1), y));
  };
  return std::min(held(a, b), held(b, a));
}

// Part i of a range cut into `parts`; sizes differ by at most one, larger parts first.
ItemRange part_of(const ItemRange& range, std::uint64_t i, std::uint64_t parts) {
  const std::uint64_t size = range.size() / parts;
  const std::uint64_t larger = range.size() % parts;
  const std::uint64_t first = range.first + i * size + std::min(i, larger);
  return {first, first + size + (i < larger ? 1 : 0)};
}

class BlockedSteps final : public StepSource {
 public:
  BlockedSteps(std::shared_ptr<const HeldBlocks> blocks, std::uint64_t items)
      : blocks_(std::move(blocks)), there_(static_cast<std::size_t>(items), false) {}

  bool next(Step& step) override {
    while (!steps_ || !steps_->next(step)) {
      if (at_ == blocks_->shapes.size()) {
        return false;
      }
      steps_ = held_steps(blocks_->shapes[at_++]);
      begins_ = true;
    }
    step.number = ++number_;
    if (begins_) {
      for (const Element x : loaded_) {
        if (there_[x]) {
          step.evict.push_back(x);
          there_[x] = false;
        }
      }
      loaded_.clear();
      begins_ = false;
    }
    for (const Element x : step.evict) {
      there_[x] = false;
    }
    for (const Element x : step.load) {
      there_[x] = true;
      loaded_.push_back(x);
    }
    // Evicted items are removed now and then, so that the list has at most twice the items in
    // memory.
    if (loaded_.size() > most_) {
      std::ranges::sort(loaded_);
      loaded_.erase(std::unique(loaded_.begin(), loaded_.end()), loaded_.end());
      std::erase_if(loaded_, [&](Element x) { return !there_[x]; });
      most_ = std::max<std::size_t>(1024, 2 * loaded_.size());
    }
    return true;
  }

 private:
  std::shared_ptr<const HeldBlocks> blocks_;
  std::size_t at_ = 0;
  std::unique_ptr<StepSource> steps_;
  bool begins_ = false;
  std::vector<bool> there_;
  std::vector<Element> loaded_;  // all items in memory, and some evicted ones
  std::size_t most_ = 1024;
  std::uint64_t number_ = 0;
};

}  // namespace

std::uint64_t HeldBlocks::makespan() const { return largest_of(shapes, &HeldShape::loads); }

std::optional<HeldBlocks> best_held_blocks(const WantedPairs& between, std::uint64_t room,
                                           std::uint64_t workers) {
  constexpr std::uint64_t most_groups = 1'000'000;
  const ItemRange first{0, between.first()};
  const ItemRange other{between.first(), between.items()};
  HeldBlocks blocks;
  std::uint64_t least = 0;
  for (std::uint64_t p = 1; p <= std::min(workers, first.size()); ++p) {
    const std::uint64_t q = std::min(workers / p, other.size());
    const std::uint64_t loads =
        estimate(ceil_div(first.size(), p), ceil_div(other.size(), q), room);
    if (least == 0 || loads < least) {
      least = loads;
      blocks.first_parts = p;
      blocks.other_parts = q;
    }
  }
  const std::uint64_t groups = std::max(blocks.other_parts * ceil_div(first.size(), room - 1),
                                        blocks.first_parts * ceil_div(other.size(), room - 1));
  if (groups > most_groups) {
    return std::nullopt;
  }
  for (std::uint64_t i = 0; i < blocks.first_parts; ++i) {
    for (std::uint64_t j = 0; j < blocks.other_parts; ++j) {
      const auto& [some, others] = blocks.parts.emplace_back(part_of(first, i, blocks.first_parts),
                                                             part_of(other, j, blocks.other_parts));
      blocks.shapes.push_back(best_held_shape(some, others, room));
    }
  }
  return blocks;
}

std::unique_ptr<StepSource> block_steps(std::shared_ptr<const HeldBlocks> blocks,
                                        std::uint64_t items) {
  return std::make_unique<BlockedSteps>(std::move(blocks), items);
}

}  // namespace changeover
