// Designs written down as what they are: a first block, and in each step x leaves and y enters; m
// times for an m-change design.
//
//     class Slide final : public SwapPlan {             // {0,1,2}, {1,2,3}, {2,3,4}, …
//       Block start() const override { return {0, 1, 2}; }
//       bool leg(std::uint64_t i, std::vector<Swap>& swaps) const override {
//         if (i == 7) return false;
//         swaps.push_back({.leaves = i, .enters = i + 3});
//         return true;
//       }
//     };
//     SwapSource blocks({.v = 10, .k = 3, .change = 1}, 8, std::make_unique<Slide>());
//
// A plan hands out its steps in legs, so that long designs need memory for one leg only.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

struct Swap {
  std::uint64_t leaves = 0;
  std::uint64_t enters = 0;
};

/// The swaps of a design, leg by leg, m a step. Stateless.
class SwapPlan {
 public:
  virtual ~SwapPlan() = default;

  [[nodiscard]] virtual Block start() const = 0;

  /// Appends the swaps of leg `index` = 0, 1, …; there may be none. False when there is no such
  /// leg.
  virtual bool leg(std::uint64_t index, std::vector<Swap>& swaps) const = 0;

 protected:
  SwapPlan() = default;
  SwapPlan(const SwapPlan&) = default;
  SwapPlan& operator=(const SwapPlan&) = default;
};

/// The blocks of a plan. O(k) a block, O(v) memory beside the leg's.
class SwapSource final : public BlockByBlock<SwapSource> {
 public:
  /// `b` is how many blocks the plan has.
  SwapSource(const Parameters& parameters, std::uint64_t b, std::unique_ptr<SwapPlan> plan);

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override { return b_; }
  /// @throws InternalError if what leaves is not there, or what enters is.
  bool make(std::span<Element> block);
  bool rewind() override;

 private:
  void replace(const Swap& swap);

  Parameters parameters_;
  std::uint64_t b_;
  std::unique_ptr<SwapPlan> plan_;
  Block current_;
  std::vector<std::uint32_t>
      place_;                // by element: 1 + its place in the block, 0 if it is not there
  std::vector<Swap> swaps_;  // of the leg
  std::size_t done_ = 0;     // of them
  std::uint64_t legs_ = 0;   // begun
  bool started_ = false;
};

}  // namespace changeover
