// Adds blocks to a list until everything is covered: simple and always possible, but not with few
// blocks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "run/random.hpp"
#include "search/subset_ranks.hpp"

namespace changeover {

/// Appends blocks until every t-subset is covered and, if the list is circular, its last step is
/// right, too. The next block is the best of some random ones, or a step on the shortest path to
/// something uncovered. Needs one or more blocks with right steps, and v ≥ k + m unless v = k. The
/// scope of this thread (run/control.hpp) can stop it. @throws ImpossibleParameters if there is no
/// path between some blocks; MissingResource if there are too many subsets.
[[nodiscard]] Design cover_the_rest(const Design& list, Random& random);

// Shared by repairing and extending a list.

[[nodiscard]] inline Block block_of(const Design& design, std::size_t i) {
  const auto elements = design.block(i);
  return Block(elements.begin(), elements.end());
}

/// Anneals by `work()`. If memory is too small, returns one line that says so; otherwise an empty
/// text.
template <typename Work>
std::string annealing_fault(Work&& work) {
  try {
    work();
  } catch (const MissingResource& fault) {
    return fault.what();
  } catch (const std::bad_alloc&) {
    return "not enough memory to anneal the list";
  }
  return "";
}

// The t-subsets that some blocks cover, for adding blocks one by one.
//
//     CoveredSubsets covered(p);
//     covered.insert(block);
//     covered.gain(candidate);              // subsets that it would newly cover
//     covered.first_missing();              // one that is still uncovered
//
// The scope of this thread (run/control.hpp) can stop it anywhere with Stopped; the constructor can
// throw MissingResource.

class CoveredSubsets {
 public:
  explicit CoveredSubsets(const Parameters& p)
      : covered_(counted(p), false), missing_(covered_.size()), ranks_(p.v, p.strength) {}

  [[nodiscard]] std::uint64_t missing() const { return missing_; }

  void insert(std::span<const Element> block) {
    ranks_.for_each_rank(block, [&](std::uint64_t subset) {
      const auto rank = static_cast<std::size_t>(subset);
      worked(1);
      if (!covered_[rank]) {
        covered_[rank] = true;
        --missing_;
      }
    });
  }

  /// The number of uncovered subsets of the block. O(C(k,t)).
  [[nodiscard]] std::uint64_t gain(std::span<const Element> block) {
    std::uint64_t count = 0;
    ranks_.for_each_rank(block, [&](std::uint64_t rank) {
      worked(1);
      count += covered_[static_cast<std::size_t>(rank)] ? 0U : 1U;
    });
    return count;
  }

  /// The uncovered subset of least rank, in decreasing order; nullopt if there is none. O(C(v,t))
  /// in total, over all calls.
  [[nodiscard]] std::optional<Block> first_missing() {
    while (first_ < covered_.size() && covered_[first_]) {
      ++first_;
      worked(1);
    }
    if (first_ == covered_.size()) {
      return std::nullopt;
    }
    return ranks_.subset(first_);
  }

 private:
  static std::size_t counted(const Parameters& p) {
    constexpr std::uint64_t bits_of_a_byte = 8;
    const std::uint64_t subsets = binomial(p.v, p.strength);
    require_memory(subsets / bits_of_a_byte, "covering the " + name(p));
    return static_cast<std::size_t>(subsets);
  }

  // Checks now and then whether to stop.
  void worked(std::size_t steps) {
    constexpr std::size_t between_questions = 1 << 14;
    worked_ += steps;
    if (worked_ > between_questions) {
      worked_ = 0;
      stop_if_asked();
    }
  }

  std::vector<bool> covered_;
  std::uint64_t missing_;
  SubsetRanks ranks_;
  std::size_t first_ = 0;
  std::size_t worked_ = 0;
};

}  // namespace changeover
