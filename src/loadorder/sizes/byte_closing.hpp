// Internal: loads for wanted pairs of items of different size, from an order in which items are
// closed (loadorder/pairs/closing.hpp says what that is; there all items have the same size).
//
//     ByteClosing closing(sizes, graph);
//     closing.run(order);                      // bytes that are loaded
//     closing.moves();                         // each load with what goes for it
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/loadorder/schedule.hpp"
#include "changeover/loadorder/wanted_pairs.hpp"

namespace changeover {

/// One load, and what was evicted for it.
struct SizedMove {
  Element load = 0;
  std::vector<Element> evict;
};

class ByteClosing {
 public:
  ByteClosing(const ItemSizes& sizes, const PairGraph& graph);

  static constexpr std::uint64_t no_limit = ~std::uint64_t{0};

  /// Closes all items in this order. Gives up once it has loaded more than `limit` bytes, and
  /// returns what it had loaded then. What is needed last goes first, as many as make room.
  std::uint64_t run(const std::vector<Element>& order, std::uint64_t limit = no_limit);

  /// Of the last run.
  [[nodiscard]] const std::vector<SizedMove>& moves() const { return moves_; }

 private:
  void close(Element x, std::uint64_t limit);
  void load(Element x, Element keep);
  void make_room(std::uint64_t bytes, Element keep);
  [[nodiscard]] std::uint32_t needed(Element x);

  const ItemSizes& sizes_;
  const PairGraph& graph_;
  std::vector<std::uint64_t> begin_;  // of an item's partners, sorted by when they are closed
  std::vector<Element> partners_;
  std::vector<std::uint64_t> twin_;      // by place: that of the same pair at the other item
  std::vector<bool> met_;                // by place
  std::vector<std::uint64_t> front_;     // by item: partners before it have met it
  std::vector<std::uint32_t> open_;      // by item: pairs that have not met
  std::vector<std::uint32_t> position_;  // by item, in the order
  std::vector<Element> memory_;
  std::vector<std::uint32_t> place_;  // by item: in memory_ plus one
  std::vector<std::uint64_t> came_;   // by item: with which load
  std::vector<bool> loaded_;
  std::vector<SizedMove> moves_;
  std::uint64_t held_ = 0;  // bytes
  std::uint64_t bytes_ = 0;
  bool upward_ = true;
  std::vector<Element> lacking_;
};

}  // namespace changeover
