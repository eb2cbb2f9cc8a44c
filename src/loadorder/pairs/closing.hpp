// Internal: loads for a list of pairs, by an order in which items are *closed*.
//
//     Closing closing(graph, room, order);      // order: every item once
//     closing.run();                            // closes all of them
//     closing.take_moves();                     // what was loaded, and what went for it
//
// An item is open while one of its pairs has not met. To close it, it is loaded (unless it is in
// memory), then all partners that it still lacks, one after another. Afterwards it can be evicted.
// If memory is full, closed items are evicted first, and then the item that is needed last: an open
// pair is needed when the first of its items is closed. For a given sequence of pairs this is
// Belady's rule for caches. Every order of the items gives an order of loads, so orders can be
// searched: improve() moves items within windows of the order and keeps changes that reduce the
// loads.
//
// At the start items are renamed by the order, so partners are sorted by when they are closed. The
// search for the next use of an item, and for the item to evict in a large memory, stops after a
// limited number of candidates: results may be slightly worse, but never wrong.
//
// Memory: 8 bytes per pair, some 40 per item and 8 per load.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"
#include "run/random.hpp"

namespace changeover {

/// One load, and the item that was evicted for it.
struct LoadMove {
  static constexpr Element nothing = ~Element{0};
  Element load = 0;
  Element evict = nothing;
};

class LoadOrder;

/// The loads of an order one by one, each with what goes for it.
[[nodiscard]] std::vector<LoadMove> one_by_one(const LoadOrder& order);

class Closing {
 public:
  Closing(const PairGraph& graph, std::uint64_t room, const std::vector<Element>& order);

  static constexpr std::uint64_t no_limit = ~std::uint64_t{0};

  /// Closes all items in order and returns the number of loads. Stops early if there are more than
  /// `limit` loads, which the result then exceeds. When in_a_hurry() returns true it also stops
  /// early, if there is a limit; otherwise it continues to the end with any eviction. After an
  /// exception the object can only be destroyed.
  std::uint64_t run(std::uint64_t limit = no_limit, const std::function<bool()>& in_a_hurry = {});

  /// The moves of the last completed run(), in the names of the graph; they are moved out.
  [[nodiscard]] std::vector<LoadMove> take_moves() { return std::move(moves_); }

  /// The work of the last run(), in the unit of improve().
  [[nodiscard]] std::uint64_t work_of_run() const { return work_of_run_; }

  /// The current order, in internal names.
  [[nodiscard]] const std::vector<Element>& closing_order() const { return order_; }

  /// Restores an order from closing_order().
  void take_order(std::vector<Element> order);

  /// Looks for a better order, for `work` steps of examining a pair, window by window from first to
  /// last. Orders are compared by their loads within the window and somewhat beyond. Calls `looked`
  /// eight times, the last time at the end, unless it is stopped before.
  void improve(std::uint64_t work, Random& random, const std::function<bool()>& stop_wanted,
               const std::function<void()>& looked);

 private:
  static constexpr Element met = Element{1} << 31;

  // The state after closing a stretch of the order, to be restored.
  struct Memory {
    std::vector<Element> items;
    std::vector<Element> closed;
  };

  struct Window {
    std::size_t begin = 0;
    std::size_t end = 0;    // end of the window for moves
    std::size_t sight = 0;  // loads are counted up to here
  };

  // A pair that has met, and its places in partners_.
  struct Met {
    std::uint64_t at_x = 0;
    std::uint64_t at_y = 0;
    Element x = 0;
    Element y = 0;
  };

  void reset();
  std::uint64_t close(Element x, std::uint64_t limit);
  void load(Element x);
  void make_room(Element keep);
  void evict(Element x);
  [[nodiscard]] std::uint32_t needed(Element x);
  void meet(Element x, std::uint64_t at_x, Element y);
  std::uint64_t trial(const Window& window, std::uint64_t limit);
  void take_back(const Memory& before);
  void anneal(const Window& window, std::uint64_t work, Random& random,
              const std::function<bool()>& stop_wanted);

  std::uint64_t room_;
  std::vector<Element> names_;        // of the graph, by internal name
  std::vector<std::uint64_t> begin_;  // of an item's partners
  std::vector<Element> partners_;     // sorted; with the bit `met`
  std::vector<std::uint64_t> front_;  // partners before it have been met for good
  std::vector<std::uint32_t> open_;   // number of pairs not met
  std::vector<bool> alone_;           // wanted without a pair
  std::vector<Element> order_;        // internal names
  std::vector<std::uint32_t> position_;
  std::vector<Element> memory_;        // open items
  std::vector<std::uint32_t> place_;   // by item: place in memory_ plus one
  std::vector<Element> closed_;        // items in memory that no other item needs
  std::vector<std::uint32_t> needed_;  // by item in memory; 0 if not computed yet
  std::vector<Met> log_;               // pairs met in a trial
  std::vector<LoadMove> moves_;
  Element went_ = LoadMove::nothing;
  std::vector<Element> missing_;
  bool trying_ = false;
  bool hurrying_ = false;
  std::uint64_t work_ = 0;
  std::uint64_t work_of_run_ = 0;
  std::size_t cursor_ = 0;
};

}  // namespace changeover
