// Internal: searches orders in which items of different sizes are closed.
//
//     ClosingSearch search(sizes, graph, room, least, 1);
//     const auto over = [] { return false; };
//     search.begin(over);                      // all starts
//     search.improve(20'000'000, over);        // for a fixed amount of work
//     search.offer().bytes;
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "changeover/loadorder/load_order.hpp"
#include "loadorder/shares/step_lists.hpp"
#include "loadorder/sizes/byte_closing.hpp"
#include "run/random.hpp"

namespace changeover {

/// Loads, how they were found, and what they cost.
struct SizedOffer {
  std::vector<SizedMove> moves;
  std::uint64_t bytes = ~std::uint64_t{0};
  std::string method;
  std::string explanation;
};

/// The loads up to the first eviction as one step, and each further load as a step.
[[nodiscard]] std::vector<Move> in_steps(const std::vector<SizedMove>& moves);

/// The loads one by one, of moves that evict no more than they must: an item goes when its bytes
/// are needed.
[[nodiscard]] std::vector<SizedMove> one_by_one(const std::vector<Move>& moves,
                                                const ItemSizes& sizes);

/// Gives each item, a number below items.size(), the name that stands there.
void give_names(std::vector<SizedMove>& moves, const std::vector<Element>& items);

class ClosingSearch {
 public:
  /// No order has fewer than `least` bytes; `room`: how many items fit at most.
  ClosingSearch(const ItemSizes& sizes, const PairGraph& graph, std::uint64_t room,
                std::uint64_t least, std::uint64_t seed);

  using Over = std::function<bool()>;

  /// Tries the starts. After the first one `over` may end that.
  void begin(const Over& over);
  /// Moves items to other places of the order, for so much work, a second or so for 20 million;
  /// ends if that is of no use any more, or if `over`.
  void improve(std::uint64_t work, const Over& over);

  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  /// The work so far.
  [[nodiscard]] std::uint64_t looked() const { return looked_; }
  /// Whether improve() cannot find fewer bytes.
  [[nodiscard]] bool is_done() const { return bytes_ <= least_ || best_.size() < 2; }
  [[nodiscard]] SizedOffer offer();

 private:
  void try_start(const std::string& name, std::vector<Element> order);
  void count_try();

  const ItemSizes& sizes_;
  const PairGraph& graph_;
  std::uint64_t room_;
  std::uint64_t least_;
  Random random_;
  ByteClosing closing_;
  std::vector<Element> best_;
  std::uint64_t bytes_ = 0;
  std::string name_;
  std::uint64_t looked_ = 0;
  std::uint64_t tries_ = 0;
};

/// The best order of a fixed amount of work, or of the caller's search.
[[nodiscard]] SizedOffer best_closing(const ItemSizes& sizes, const PairGraph& graph,
                                      std::uint64_t room, std::uint64_t least,
                                      const LoadOrderOptions& options);

}  // namespace changeover
