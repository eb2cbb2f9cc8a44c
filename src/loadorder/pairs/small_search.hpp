// Internal: the best order of closing items that annealing finds for a short list.
//
//     SmallSearch search(graph, room);          // up to most_items of them occur
//     SmallSearch::Found found = search.anneal(order, work, random, stop_wanted);
//     found.moves;                              // what was loaded, and what went for it
//
// The rule by which items are closed is that of closing.hpp, and everything an item is needed for
// is looked at. Partners that are not met are bits by when they are closed, so to play an order
// takes some microseconds.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"
#include "loadorder/pairs/closing.hpp"
#include "run/random.hpp"

namespace changeover {

class SmallSearch {
 public:
  static constexpr std::size_t most_items = 256;

  /// Whether so few items occur.
  [[nodiscard]] static bool serves(const PairGraph& graph);

  SmallSearch(const PairGraph& graph, std::uint64_t room);

  struct Found {
    std::vector<Element>
        order;  ///< in the names of the graph; items that do not occur are left out
    std::vector<LoadMove> moves;
  };

  /// The best order on a way of `work` steps of looking at an item or a pair that begins at
  /// `order`; at least as good as that. It ends when no more than `enough` loads are left, and once
  /// stop_wanted().
  [[nodiscard]] Found anneal(const std::vector<Element>& order, std::uint64_t enough,
                             std::uint64_t work, Random& random,
                             const std::function<bool()>& stop_wanted);

  /// What one look at an order costs, in steps.
  [[nodiscard]] std::uint64_t work_of_look() const;

 private:
  template <std::size_t Words>
  Found anneal_words(std::vector<Element> order, std::uint64_t enough, std::uint64_t work,
                     Random& random, const std::function<bool()>& stop_wanted);

  std::uint64_t room_;
  std::vector<Element> names_;                  // of the graph, by ours
  std::vector<std::vector<Element>> partners_;  // our names
  std::uint64_t pairs_ = 0;
};

}  // namespace changeover
