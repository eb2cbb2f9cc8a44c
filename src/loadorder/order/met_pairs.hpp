// Internal, of the check alone: which pairs were seen, and which met.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/core/pair_set.hpp"
#include "changeover/loadorder/schedule.hpp"

namespace changeover {

/// Wanted pairs that were seen: a bit a pair, of listed ones two.
class SeenPairs {
 public:
  SeenPairs(const WantedPairs& wanted, std::uint64_t items);

  /// {x,y} is wanted. Whether it was seen for the first time.
  bool insert(Element x, Element y) {
    const std::uint64_t bit =
        wanted_.graph() != nullptr ? *wanted_.graph()->place(x, y) : PairSet::rank(x, y);
    const auto place = static_cast<std::size_t>(bit);
    const bool is_new = !seen_[place];
    seen_[place] = true;
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
  std::vector<bool> seen_;
  std::uint64_t size_ = 0;
};

/// All pairs that have been in one memory, in words: for a room that is large against the words of a row. A pair belongs to the
/// row of its larger name. When that name comes, the row takes what is there, as words; when it leaves, what came in the meantime, which is kept as
/// one set for each so many arrivals.
class MetInWords {
 public:
  explicit MetInWords(std::uint64_t items);

  void arrive(Element name, PairSet& pairs);
  void leave(Element name, PairSet& pairs);
  /// Memory is empty; what met has met.
  void clear(PairSet& pairs);
  /// Adds what those that are still there met.
  void settle(PairSet& pairs);

 private:
  static constexpr std::size_t arrivals_of_a_set = 2048;
  using Set = std::vector<std::uint64_t>;

  void take_since_arrival(Element name, PairSet& pairs) const;

  std::size_t words_;
  Set held_;
  std::vector<std::uint64_t> since_;  // by name: how many had arrived before it, itself included
  std::vector<Element> arrivals_;     // all of them since memory was empty
  std::vector<Set> sets_;             // of each full run of them
};

/// Pairs that have been in one memory: all of them, those that are wanted, or those of a few
/// watched items.
class MetPairs {
 public:
  MetPairs(const ScheduleRules& rules, const CheckOptions& options);

  /// x comes to what is in `memory`; place[y] is not 0 for what is there.
  void arrive(Element x, const std::vector<Element>& memory,
              const std::vector<std::uint32_t>& place);
  /// x leaves its place in the list of what is there, which the last one takes.
  void leave(Element x, std::size_t place);
  /// Memory is empty; what met has met.
  void clear();

  /// Fills in what is missing, an example and how many are watched.
  void report(ScheduleVerdict& verdict);

 private:
  void name_pairs(const std::vector<Element>& kept_as);
  void watch(const CheckOptions& options);

  std::uint64_t items_;
  WantedPairs wanted_;
  std::optional<PairSet> pairs_;     // all of them, under the names kept_as_, or
  std::optional<MetInWords> words_;  // which adds to these, if there is much room
  std::optional<SeenPairs> some_;    // those that are wanted, or
  std::vector<bool> loaded_;         // by item, of listed pairs
  std::vector<Element> kept_as_;     // by item; empty: their own
  std::vector<Element> kept_;        // names of what is in memory, in the same places
  std::vector<Element> watched_;     // a few rows
  std::vector<std::uint32_t> row_;   // by item: its row plus one, 0 if it is not watched
  std::vector<std::vector<bool>> met_;
  std::vector<Element> watched_now_;  // watched items in memory
};

}  // namespace changeover
