// Whether a list of steps is a load order: reads steps and trusts nothing else.
//
//     LoadCheck check(items, room);
//     LoadStep step;
//     while (order.next(step)) {
//       check.read(step);
//     }
//     LoadVerdict verdict = check.finish();
//     verdict.valid();                         // else verdict.fault and verdict.uncovered say why
//
// Checked of every step: steps are numbered 1, 2, …; what is evicted is in memory; what is loaded is not,
// and is an item; at most `room` items are in memory. Checked at the end: every pair was in memory together.
//
// Pairs cost C(P,2) bits, up to P = 65,535 (268 MB), listed ones two bits each. Above that, or if asked to, only *watched* items
// are followed: for each of them, chosen by a seed, whether all others met it. A wrong order that
// misses a share p of the items' rows escapes n watched items with probability (1−p)ⁿ; the rest of the checks
// is complete either way.
//
// Complexity: O(C) a load with all pairs, O(watched) without.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "changeover/core/pair_set.hpp"
#include "changeover/loadorder/load_order.hpp"

namespace changeover {

class WantedSet;

struct LoadVerdict {
  std::uint64_t steps = 0;
  std::uint64_t loads = 0;
  std::uint64_t most_in_memory = 0;
  std::string fault;            ///< the first step that is wrong, in one line; empty if none
  std::uint64_t uncovered = 0;  ///< pairs that never were in memory together, among those followed
  std::string uncovered_example;    ///< "{3,7}"; empty if none
  std::uint64_t watched_items = 0;  ///< items whose pairs were followed: all of them, or a few

  [[nodiscard]] bool valid() const { return steps > 0 && fault.empty() && uncovered == 0; }
};

struct LoadCheckOptions {
  bool all_pairs = true;       ///< needs items ≤ 65,535 unless pairs are listed
  std::uint64_t watched = 64;  ///< items to follow otherwise
  std::uint64_t seed = 1;      ///< of their choice
  /// Other names of the items, by which what is in memory together has numbers close to each other: pairs are
  /// kept under these names, and their bits share cache lines. Every renaming leads to the same verdict. Empty: none.
  std::vector<Element> kept_as = {};
  /// The pairs that have to meet. Listed ones cost two bits each, for any number of items, and other names are of no use then.
  WantedPairs wanted = {};
};

class LoadCheck {
 public:
  /// @throws BadInput if items = 0 or room = 0, or kept_as is not a permutation of the items; MissingResource if
  /// all pairs of more than 65,535 items are asked for.
  LoadCheck(std::uint64_t items, std::uint64_t room, const LoadCheckOptions& options = {});
  ~LoadCheck();
  LoadCheck(LoadCheck&&) noexcept;

  /// Takes the next step. After the first fault nothing is looked at any more.
  void read(const LoadStep& step);

  /// The steps that follow are those of another worker, numbered from 1, whose memory is empty; what met
  /// before has met.
  void start_over();

  /// What is true of the steps that were read.
  [[nodiscard]] LoadVerdict finish() const;

  /// What is in memory now, in no particular order.
  [[nodiscard]] const std::vector<Element>& in_memory() const { return memory_; }

 private:
  void name_pairs(const std::vector<Element>& kept_as);
  void load(Element x);
  void evict(Element x);
  void fail(std::string fault);

  std::uint64_t items_;
  std::uint64_t room_;
  LoadVerdict verdict_;
  std::uint64_t number_ = 0;  // of the worker's last step
  std::vector<Element> memory_;
  std::vector<std::uint32_t> place_;  // by item: index in memory_ plus one, 0 if absent
  WantedPairs wanted_;
  std::unique_ptr<PairSet> pairs_;   // all of them, under the names kept_as_, or
  std::unique_ptr<WantedSet> some_;  // those that are wanted, or
  std::vector<bool> loaded_;         // by item, of listed pairs
  std::vector<Element> kept_as_;     // by item; empty: their own
  std::vector<Element> kept_;        // names of what is in memory_, in the same places
  std::vector<Element> watched_;     // a few rows
  std::vector<std::uint32_t> row_;   // by item: its row plus one, 0 if it is not watched
  std::vector<std::vector<bool>> met_;
  std::vector<Element> watched_now_;  // watched items in memory
};

/// Reads a whole stream.
[[nodiscard]] LoadVerdict check_loads(StepSource& steps, std::uint64_t items, std::uint64_t room,
                                      const LoadCheckOptions& options = {});

}  // namespace changeover
