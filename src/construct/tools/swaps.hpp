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

/// A plan with one leg.
class ShortPlan : public SwapPlan {
 public:
  bool leg(std::uint64_t index, std::vector<Swap>& swaps) const final {
    if (index == 0) {
      add_all(swaps);
    }
    return index == 0;
  }

 protected:
  /// Appends all swaps.
  virtual void add_all(std::vector<Swap>& swaps) const = 0;
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

// Streams of g-change designs out of streams of single-change designs: the unions of g
// consecutive blocks, for lists in which whatever leaves stays away for at least 2g−1 blocks.
//
//     auto blocks = unions_of_blocks(std::move(single), 3);     // ⌈b/3⌉ blocks of k+2
//
// The union C_i of the blocks gi, …, gi+g−1 has k+g−1 elements, and C_{i+1} has g that C_i lacks:
// each of the g that enter in it was away for 2g−1 blocks. Every pair that was in a block still
// is in one. If g does not divide b, the last union is short of elements. It gets the first that
// are neither in it nor in the union before nor, in a circular design, in the first union, so
// that they enter there and leave at once. coarsened() (construct/tools/coarsen.hpp) is for
// designs that lack this property.

/// Whether unions of g fit a list in which K−1 blocks or more stand between two stays of an
/// element: K ≥ 2g.
[[nodiscard]] constexpr bool unions_fit(std::uint64_t big, std::uint64_t g) { return big / 2 >= g; }

/// The g-change design on (v, k+g−1), of the same kind. `single` has that property and says how
/// many blocks it has, at least 3g; v ≥ k+3g−1, so that there are elements to fill with. O(gk)
/// memory.
[[nodiscard]] std::unique_ptr<BlockSource> unions_of_blocks(std::unique_ptr<BlockSource> single,
                                                            std::uint64_t g);

}  // namespace changeover
