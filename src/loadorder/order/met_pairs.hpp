// Internal, for the check only: which pairs were seen, and which have met.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/core/pair_set.hpp"
#include "changeover/loadorder/schedule.hpp"
#include "loadorder/order/word_set.hpp"

namespace changeover {

/// The wanted pairs that were seen: one bit per pair, two for listed ones.
class SeenPairs {
 public:
  SeenPairs(const WantedPairs& wanted, std::uint64_t items);

  /// Needs a wanted pair {x,y}. Returns whether it is new.
  bool insert(Element x, Element y) {
    const std::uint64_t bit =
        wanted_.graph() != nullptr ? *wanted_.graph()->place(x, y) : PairSet::rank(x, y);
    std::uint64_t& word = seen_[static_cast<std::size_t>(bit / 64)];
    const std::uint64_t mask = std::uint64_t{1} << bit % 64;
    const bool is_new = (word & mask) == 0;
    word |= mask;
    size_ += is_new ? 1U : 0U;
    return is_new;
  }

  [[nodiscard]] std::uint64_t missing() const { return wanted_count_ - size_; }
  /// A wanted pair that was not seen.
  [[nodiscard]] std::optional<ItemPair> example() const;

 private:
  WantedPairs wanted_;
  std::uint64_t items_;
  std::uint64_t wanted_count_;
  std::vector<std::uint64_t> seen_;
  std::uint64_t size_ = 0;
};

/// The pairs that met in one memory, stored in words of bits: for rooms of many items. A pair
/// belongs to the row of the later item, as far as that has the larger name. When a name leaves,
/// its row is updated with the items that arrived in the meantime, which are kept as one set for
/// each fixed number of arrivals.
class MetInWords {
 public:
  /// since[x] is the number of arrivals at its memory before x, less the left-out ones; shared by
  /// memories that never hold the same item.
  MetInWords(std::uint64_t room, std::vector<std::uint32_t>& since);

  /// From now on pairs that meet for the first time are counted.
  void count_in(std::uint64_t& count) { count_ = &count; }

  void arrive(Element name, PairSet& pairs);
  void leave(Element name, PairSet& pairs);
  /// Adds the pairs of the items in memory.
  void settle(PairSet& pairs);
  /// Empties the memory; pairs that met are kept.
  void clear(PairSet& pairs);

 private:
  static constexpr std::size_t arrivals_of_a_set = 64;
  static constexpr std::size_t arrivals_of_a_large_set = 2048;

  void take_since_arrival(Element name, PairSet& pairs) const;
  void add_below(PairSet& pairs, Element x, const WordSet& set) const;

  std::size_t most_arrivals_;
  std::vector<std::uint32_t>* since_;
  std::uint64_t* count_ = nullptr;
  WordSet held_;
  std::vector<Element> arrivals_;  // since the memory was empty, or settled
  std::vector<WordSet> sets_;      // one per full run of arrivals
  std::vector<WordSet> large_sets_;
};

/// The pairs that have met in one memory: all pairs, the wanted ones, or those of a few watched
/// items.
class MetPairs {
 public:
  MetPairs(const ScheduleRules& rules, const CheckOptions& options);
  MetPairs(const MetPairs&) = delete;
  MetPairs& operator=(const MetPairs&) = delete;

  /// x joins the items in the `memory` of a worker. place[y] is not 0 for items there or, in
  /// lockstep, at any worker.
  void arrive(std::size_t worker, Element x, const std::vector<Element>& memory,
              const std::vector<std::uint32_t>& place);
  /// x leaves its place in the list of items in memory, which the last item takes.
  void leave(std::size_t worker, Element x, std::size_t place);
  /// Empties the memory; pairs that met are kept.
  void clear(std::size_t worker);

  /// The number of pairs that met for the first time since the last call, when memory is empty; 0
  /// if they are not counted.
  [[nodiscard]] std::uint64_t take_count();

  /// Reports missing pairs, an example, and the number of watched items.
  void report(ScheduleVerdict& verdict);

 private:
  /// The memory of one worker, as far as it is tracked.
  struct Memory {
    std::vector<Element> kept;        // names of the items in memory, in the same places; or
    std::optional<MetInWords> words;  // the same in words, for large rooms
    std::vector<Element> watched;     // watched items in memory
  };

  void leave_out_unwanted();
  void name_pairs(const std::vector<Element>& kept_as);
  void watch(const CheckOptions& options);
  void see_wanted(Element x, const std::vector<Element>& memory,
                  const std::vector<std::uint32_t>& place);

  std::uint64_t items_;
  WantedPairs wanted_;
  bool lockstep_;
  bool by_worker_;
  std::uint64_t count_ = 0;           // of pairs that are tracked one by one
  std::vector<Memory> memories_;      // by worker
  std::optional<PairSet> pairs_;      // all pairs, under the names kept_as_, or
  std::vector<std::uint32_t> since_;  // by name, of memories in words
  std::optional<SeenPairs> some_;     // the wanted pairs, or
  std::vector<bool> loaded_;          // by item, for listed pairs
  std::vector<Element> kept_as_;      // by item; empty: the item itself
  std::vector<Element> watched_;      // watched items
  std::vector<std::uint32_t> row_;    // by item: its row plus one, 0 if it is not watched
  std::vector<std::vector<bool>> met_;
};

}  // namespace changeover
