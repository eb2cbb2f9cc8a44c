#include "construct/tools/swaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"

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
    std::fill(place_.begin(), place_.end(), 0U);
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
  std::copy(current_.begin(), current_.end(), block.begin());
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

}  // namespace changeover
