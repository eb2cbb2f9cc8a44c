// Internal: loads for wanted pairs of items of different sizes, by an order in which items are
// closed (defined in loadorder/pairs/closing.hpp for items of equal size).
//
//     ByteClosing closing(sizes, graph);
//     closing.run(order);                      // bytes loaded
//     closing.moves();                         // each load with its evictions
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/loadorder/schedule.hpp"
#include "changeover/loadorder/wanted_pairs.hpp"

namespace changeover {

/// One load, and the items evicted for it.
struct SizedMove {
  Element load = 0;
  std::vector<Element> evict;
};

class ByteClosing {
 public:
  ByteClosing(const ItemSizes& sizes, const PairGraph& graph);

  static constexpr std::uint64_t no_limit = ~std::uint64_t{0};

  /// Closes all items in this order and returns the bytes loaded. Stops early after more than
  /// `limit` bytes. As many items as necessary are evicted, those needed last first.
  std::uint64_t run(const std::vector<Element>& order, std::uint64_t limit = no_limit);

  /// The moves of the last run.
  [[nodiscard]] const std::vector<SizedMove>& moves() const { return moves_; }

 private:
  void close(Element x, std::uint64_t limit);
  void load(Element x, Element keep);
  void make_room(std::uint64_t bytes, Element keep);
  [[nodiscard]] std::uint32_t needed(Element x);

  const ItemSizes& sizes_;
  const PairGraph& graph_;
  std::vector<std::uint64_t> begin_;  // an item's first partner, sorted by when they are closed
  std::vector<Element> partners_;
  std::vector<std::uint64_t> twin_;      // by place: the place of the same pair at the other item
  std::vector<bool> met_;                // by place
  std::vector<std::uint64_t> front_;     // by item: partners before it have met it
  std::vector<std::uint32_t> open_;      // by item: number of pairs that have not met
  std::vector<std::uint32_t> position_;  // by item, in the order
  std::vector<Element> memory_;
  std::vector<std::uint32_t> place_;  // by item: place in memory_ plus one
  std::vector<std::uint64_t> came_;   // by item: number of the load that brought it
  std::vector<bool> loaded_;
  std::vector<SizedMove> moves_;
  std::uint64_t held_ = 0;  // bytes in memory
  std::uint64_t bytes_ = 0;
  bool upward_ = true;
  std::vector<Element> lacking_;
};

}  // namespace changeover
