// The shortest way from one block to another by steps that change exactly m elements.
//
//     connecting_blocks({0, 1, 2, 3}, {6, 7, 8, 9}, 2, 10);      // one block between them
//     connecting_steps(4, 4, 2, 10);                             // 2, without naming elements
//
// Blocks that differ in d elements are (d, k, v) apart whatever their elements are, so the shortest
// way is found among distances: a step from distance d can lead to every distance d − a + h where a
// of the d wrong elements go, h elements outside both blocks come, and what is left over suffices.
//
// Who needs many ways, or long ones, makes the distances once and takes the blocks of a way one by
// one:
//
//     const auto distances = std::make_shared<const Distances>(k, m, v);
//     Way way(distances, from, to);
//     while (way.next(block)) { … }                              // memory: O(v)
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "changeover/core/block.hpp"
#include "core/contains.hpp"

namespace changeover {

/// How many elements of `to` are not in `from`: the distance of two blocks. O(k²).
[[nodiscard]] inline std::uint64_t distance_between(std::span<const Element> from,
                                                    std::span<const Element> to) {
  return static_cast<std::uint64_t>(
      std::ranges::count_if(to, [&](Element x) { return !contains(from, x); }));
}

/// From low to high, both included; empty if low > high.
struct StepRange {
  std::uint64_t low = 0;
  std::uint64_t high = 0;

  [[nodiscard]] bool empty() const { return low > high; }
};

/// One step at distance d from the goal: of the m elements that go, `wrong` are not in the goal; of
/// the m that come, `strange` are in neither block. Both can be chosen freely in their range, and
/// lead to distance d − wrong + strange.
struct StepMoves {
  StepRange wrong;
  StepRange strange;

  [[nodiscard]] bool possible() const { return !wrong.empty() && !strange.empty(); }
};

[[nodiscard]] constexpr StepMoves moves_at(std::uint64_t d, std::uint64_t k, std::uint64_t m,
                                           std::uint64_t v) {
  return {{m - std::min(m, k - d), std::min(m, d)}, {m - std::min(m, d), std::min(m, v - k - d)}};
}

/// How many steps of `change` elements there are between k-subsets of a v-set, by their distance.
class Distances {
 public:
  /// O(min(k, v−k)) time and memory. Of impossible parameters it knows no way.
  Distances(std::uint64_t k, std::uint64_t change, std::uint64_t v);

  [[nodiscard]] std::uint64_t k() const { return k_; }
  [[nodiscard]] std::uint64_t change() const { return change_; }
  [[nodiscard]] std::uint64_t v() const { return v_; }

  /// As connecting_steps(). O(1).
  [[nodiscard]] std::optional<std::uint64_t> steps(std::uint64_t distance) const;

 private:
  std::uint64_t k_;
  std::uint64_t change_;
  std::uint64_t v_;
  std::vector<std::uint64_t> steps_;
};

/// The blocks of connecting_blocks() one by one.
class Way {
 public:
  /// @throws ImpossibleParameters if there is no way or the blocks are the same.
  Way(std::shared_ptr<const Distances> distances, Block from, Block to);

  /// How many blocks are still to come before the goal.
  [[nodiscard]] std::uint64_t left() const { return left_; }

  /// The next block, false when only the goal is left. O(k + m²), and O(v) if elements of neither
  /// block come.
  bool next(std::span<Element> block);

 private:
  void take_step(std::uint64_t wrong_going, std::uint64_t others_coming);

  std::shared_ptr<const Distances> distances_;
  Block here_;
  Block to_;
  std::vector<bool> is_here_;
  std::vector<bool> is_goal_;
  std::uint64_t left_ = 0;
};

/// The least number of steps that change exactly `change` elements each and lead from a k-subset of
/// a v-set to another that differs from it in `distance` elements; 0 if distance is 0; nullopt if
/// there is no way (only for v < k + change, and for v = 2k, change = k). O(min(k, v−k)).
[[nodiscard]] std::optional<std::uint64_t> connecting_steps(std::uint64_t distance, std::uint64_t k,
                                                            std::uint64_t change, std::uint64_t v);

/// The blocks strictly between `from` and `to` on a shortest way; deterministic. Empty if one step
/// leads there. @throws ImpossibleParameters if there is no way or the blocks are the same.
[[nodiscard]] std::vector<Block> connecting_blocks(const Block& from, const Block& to,
                                                   std::uint64_t change, std::uint64_t v);

}  // namespace changeover
