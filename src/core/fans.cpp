#include "changeover/core/fans.hpp"

#include <algorithm>
#include <utility>

namespace changeover {
namespace {

class BlocksOfFans final : public BlockByBlock<BlocksOfFans> {
 public:
  explicit BlocksOfFans(std::unique_ptr<FanSource> fans) : fans_(std::move(fans)) {}

  [[nodiscard]] const Parameters& parameters() const override { return fans_->parameters(); }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return fans_->block_count();
  }

  bool make(std::span<Element> block) {
    if (!fan_ || next_ > fan_->last) {
      fan_ = fans_->next();
      if (!fan_) {
        return false;
      }
      next_ = fan_->first;
    }
    std::ranges::copy(fan_->kept, block.begin());
    block.back() = static_cast<Element>(next_++);
    return true;
  }

  bool rewind() override {
    if (!fans_->rewind()) {
      return false;
    }
    fan_.reset();
    return true;
  }

 private:
  std::unique_ptr<FanSource> fans_;
  std::optional<Fan> fan_;
  std::uint64_t next_ = 0;  // element of the fan
};

class FansOfBlocks final : public FanSource {
 public:
  explicit FansOfBlocks(std::unique_ptr<BlockSource> blocks)
      : blocks_(std::move(blocks)), block_(static_cast<std::size_t>(blocks_->parameters().k)) {}

  [[nodiscard]] const Parameters& parameters() const override { return blocks_->parameters(); }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return blocks_->block_count();
  }

  std::optional<Fan> next() override {
    if (!blocks_->next(block_)) {
      return std::nullopt;
    }
    const std::span<const Element> all(block_);
    return Fan{all.first(all.size() - 1), all.back(), all.back()};
  }

  bool rewind() override { return blocks_->rewind(); }

 private:
  std::unique_ptr<BlockSource> blocks_;
  Block block_;
};

}  // namespace

std::unique_ptr<BlockSource> blocks_of(std::unique_ptr<FanSource> fans) {
  return std::make_unique<BlocksOfFans>(std::move(fans));
}

std::unique_ptr<FanSource> fans_of(std::unique_ptr<BlockSource> blocks) {
  return std::make_unique<FansOfBlocks>(std::move(blocks));
}

}  // namespace changeover
