#include "construct/tools/swaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"

namespace changeover {

SwapSource::SwapSource(const Parameters& parameters, std::uint64_t b,
                       std::unique_ptr<SwapPlan> plan)
    : parameters_(parameters), b_(b), plan_(std::move(plan)) {
  require_memory(parameters.v * sizeof(std::uint32_t), "the places of " + name(parameters));
  place_.resize(static_cast<std::size_t>(parameters.v));
}

bool SwapSource::rewind() {
  started_ = false;
  return true;
}

bool SwapSource::make(std::span<Element> block) {
  if (!started_) {
    started_ = true;
    current_ = plan_->start();
    std::ranges::fill(place_, 0U);
    for (std::size_t i = 0; i < current_.size(); ++i) {
      place_.at(current_[i]) = static_cast<std::uint32_t>(i + 1);
    }
    swaps_.clear();
    done_ = 0;
    legs_ = 0;
  } else {
    for (std::uint64_t changed = 0; changed < parameters_.change; ++changed) {
      while (done_ == swaps_.size()) {
        swaps_.clear();
        done_ = 0;
        if (!plan_->leg(legs_, swaps_)) {
          return false;
        }
        ++legs_;
      }
      replace(swaps_[done_++]);
    }
  }
  std::ranges::copy(current_, block.begin());
  return true;
}

void SwapSource::replace(const Swap& swap) {
  std::uint32_t& from = place_.at(static_cast<std::size_t>(swap.leaves));
  std::uint32_t& to = place_.at(static_cast<std::size_t>(swap.enters));
  if (from == 0 || to != 0) {
    throw InternalError(fmt::format("a step of {} lets {} leave and {} enter, which cannot be",
                                    name(parameters_), swap.leaves, swap.enters));
  }
  to = std::exchange(from, 0U);
  current_[to - 1] = static_cast<Element>(swap.enters);
}

namespace {

class UnionSource final : public BlockByBlock<UnionSource> {
 public:
  UnionSource(std::unique_ptr<BlockSource> single, std::uint64_t g)
      : parameters_(single->parameters()), single_(std::move(single)), g_(g) {
    one_.resize(static_cast<std::size_t>(parameters_.k));
    parameters_.k += g - 1;
    parameters_.change = g;
  }

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    const auto b = single_->block_count();
    return b ? std::optional(ceil_div(*b, g_)) : std::nullopt;
  }

  bool make(std::span<Element> block) {
    std::swap(before_, now_);  // both sorted
    now_.clear();
    for (std::uint64_t i = 0; i < g_ && single_->next(one_); ++i) {
      add_one();
    }
    if (now_.empty()) {
      return false;
    }
    if (first_.empty()) {
      first_ = now_;
    }
    fill(block.size());
    std::ranges::copy(now_, block.begin());
    return true;
  }

  bool rewind() override {
    first_.clear();
    now_.clear();
    return single_->rewind();
  }

 private:
  void add_one() {
    std::ranges::sort(one_);
    Block both;
    both.reserve(now_.size() + one_.size());
    std::set_union(now_.begin(), now_.end(), one_.begin(), one_.end(), std::back_inserter(both));
    now_ = std::move(both);
  }

  void fill(std::size_t size) {
    const auto in = [](const Block& set, Element x) { return std::ranges::binary_search(set, x); };
    const bool circular = parameters_.kind == Kind::circular;
    Block more;
    for (Element x = 0; now_.size() + more.size() < size; ++x) {
      if (!in(now_, x) && !in(before_, x) && !(circular && in(first_, x))) {
        more.push_back(x);
      }
    }
    now_.insert(now_.end(), more.begin(), more.end());
    std::ranges::sort(now_);
  }

  Parameters parameters_;
  std::unique_ptr<BlockSource> single_;
  std::uint64_t g_;
  Block one_;
  Block first_;
  Block before_;
  Block now_;
};

}  // namespace

std::unique_ptr<BlockSource> unions_of_blocks(std::unique_ptr<BlockSource> single,
                                              std::uint64_t g) {
  return std::make_unique<UnionSource>(std::move(single), g);
}

}  // namespace changeover
