// Internal: loads for a list of pairs, from an order in which items are *closed*.
//
//     Closing closing(graph, room, order);      // order: every item once
//     closing.run();                            // closes all of them
//     closing.take_moves();                     // what was loaded, and what went for it
//
// An item is open while a pair of it has not met. To close it is to load it, unless it is there,
// and then all partners that it still lacks, one after another; afterwards it may go. Where memory
// is full, what is closed goes first, and then what is needed last: an open pair is needed when the
// first of its two items is closed. For given pairs in a given order this is the rule of Belady for
// caches. Every order of the items leads to an order of loads, so orders can be searched: improve()
// moves items about within windows of the order and keeps what needs fewer loads.
//
// Items are renamed by the order at the start, so partners are sorted by when they are closed.
// Looking for when an item is needed next ends after some partners, and looking for what goes after
// some items of a large memory: that makes results worse now and then, never wrong.
//
// Memory: 8 bytes a pair, some 40 an item and 8 a load.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"
#include "run/random.hpp"

namespace changeover {

/// One load, and what was evicted for it.
struct LoadMove {
  static constexpr Element nothing = ~Element{0};
  Element load = 0;
  Element evict = nothing;
};

class Closing {
 public:
  Closing(const PairGraph& graph, std::uint64_t room, const std::vector<Element>& order);

  static constexpr std::uint64_t no_limit = ~std::uint64_t{0};

  /// Loads that closing all items in order takes; gives up where they are more than `limit`, and
  /// says so by what it returns. Once in_a_hurry() says yes it gives up, too, if there is a limit;
  /// otherwise it goes on to the end without care for what is evicted. It may throw; then nothing
  /// is left but to destroy this.
  std::uint64_t run(std::uint64_t limit = no_limit, const std::function<bool()>& in_a_hurry = {});

  /// Of the last run() that did not give up; in the names of the graph. They are gone from here.
  [[nodiscard]] std::vector<LoadMove> take_moves() { return std::move(moves_); }

  /// How much the last run() looked at, in the unit of improve().
  [[nodiscard]] std::uint64_t work_of_run() const { return work_of_run_; }

  /// The order now, in names of its own.
  [[nodiscard]] const std::vector<Element>& closing_order() const { return order_; }

  /// Back to what closing_order() was.
  void take_order(std::vector<Element> order);

  /// Looks for a better order for `work` steps of looking at a pair, window by window from the
  /// first to the last. Orders are judged by loads within the window and somewhat beyond.
  void improve(std::uint64_t work, Random& random, const std::function<bool()>& stop_wanted);

 private:
  static constexpr Element met = Element{1} << 31;

  // What closing a stretch of the order leaves, to be taken back.
  struct Memory {
    std::vector<Element> items;
    std::vector<Element> closed;
  };

  struct Window {
    std::size_t begin = 0;
    std::size_t end = 0;    // moves are within
    std::size_t sight = 0;  // judged up to here
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
  std::vector<Element> names_;        // of the graph, by ours
  std::vector<std::uint64_t> begin_;  // of an item's partners
  std::vector<Element> partners_;     // sorted; with the bit `met`
  std::vector<std::uint64_t> front_;  // partners before it have been met for good
  std::vector<std::uint32_t> open_;   // pairs not met
  std::vector<bool> alone_;           // wanted without a pair
  std::vector<Element> order_;        // our names
  std::vector<std::uint32_t> position_;
  std::vector<Element> memory_;        // open items
  std::vector<std::uint32_t> place_;   // by item: in memory_ plus one
  std::vector<Element> closed_;        // items in memory that no other needs
  std::vector<std::uint32_t> needed_;  // by item in memory, 0: to be found
  std::vector<std::uint64_t> log_;     // pairs met in a trial, by place in partners_
  std::vector<Element> log_owner_;
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
