// Internal, of the check alone: which pairs were seen, and which met.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/core/pair_set.hpp"
#include "changeover/loadorder/schedule.hpp"
#include "loadorder/order/word_set.hpp"

namespace changeover {

/// Wanted pairs that were seen: a bit a pair, of listed ones two.
class SeenPairs {
 public:
  SeenPairs(const WantedPairs& wanted, std::uint64_t items);

  /// {x,y} is wanted. Whether it was seen for the first time.
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
  /// A pair that is wanted and was not seen.
  [[nodiscard]] std::optional<ItemPair> example() const;

 private:
  WantedPairs wanted_;
  std::uint64_t items_;
  std::uint64_t wanted_count_;
  std::vector<std::uint64_t> seen_;
  std::uint64_t size_ = 0;
};

/// What has been in one memory, in words: for rooms of many items. A pair belongs to the row of the
/// one that came later as far as that has the larger name; when a name leaves, its row takes what
/// came in the meantime, which is kept as a set for each so many arrivals.
class MetInWords {
 public:
  /// since[x], shared by memories that never hold the same item: so many arrivals of its memory
  /// were before x left out.
  MetInWords(std::uint64_t room, std::vector<std::uint32_t>& since);

  /// From now on the pairs that met for the first time are counted.
  void count_in(std::uint64_t& count) { count_ = &count; }

  void arrive(Element name, PairSet& pairs);
  void leave(Element name, PairSet& pairs);
  /// Adds what those that are there met.
  void settle(PairSet& pairs);
  /// Memory is empty; what met has met.
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
  std::vector<Element> arrivals_;  // since it was empty, or settled
  std::vector<WordSet> sets_;      // of each full run of them
  std::vector<WordSet> large_sets_;
};

/// Pairs that have been in one memory: all of them, those that are wanted, or those of a few
/// watched items.
class MetPairs {
 public:
  MetPairs(const ScheduleRules& rules, const CheckOptions& options);
  MetPairs(const MetPairs&) = delete;
  MetPairs& operator=(const MetPairs&) = delete;

  /// x comes to what is in the `memory` of a worker; place[y] is not 0 for what is there, or in
  /// lockstep at any worker.
  void arrive(std::size_t worker, Element x, const std::vector<Element>& memory,
              const std::vector<std::uint32_t>& place);
  /// x leaves its place in the list of what is there, which the last one takes.
  void leave(std::size_t worker, Element x, std::size_t place);
  /// The memory is empty; what met has met.
  void clear(std::size_t worker);

  /// Pairs that met for the first time since the memory was empty, and now is again; 0 if they are
  /// not counted.
  [[nodiscard]] std::uint64_t take_count();

  /// Fills in what is missing, an example and how many are watched.
  void report(ScheduleVerdict& verdict);

 private:
  /// What one worker holds, as far as it is followed.
  struct Memory {
    std::vector<Element> kept;        // names of what is there, in the same places; or
    std::optional<MetInWords> words;  // that, if there is much room
    std::vector<Element> watched;     // watched items that are there
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
  std::uint64_t count_ = 0;           // of pairs that are followed one by one
  std::vector<Memory> memories_;      // by worker
  std::optional<PairSet> pairs_;      // all of them, under the names kept_as_, or
  std::vector<std::uint32_t> since_;  // by name, of memories in words
  std::optional<SeenPairs> some_;     // those that are wanted, or
  std::vector<bool> loaded_;          // by item, of listed pairs
  std::vector<Element> kept_as_;      // by item; empty: their own
  std::vector<Element> watched_;      // a few rows
  std::vector<std::uint32_t> row_;    // by item: its row plus one, 0 if it is not watched
  std::vector<std::vector<bool>> met_;
};

}  // namespace changeover
