// Internal: anneals the order of closing items for a short list.
//
//     SmallSearch search(graph, room);          // up to most_items of them occur
//     SmallSearch::Found found = search.anneal(order, work, random, stop_wanted);
//     found.moves;                              // what was loaded, and what went for it
//
// Items are closed by the rule of closing.hpp, with all later uses of an item taken into account.
// Partners that have not met are bits, sorted by when they are closed, so computing the loads of an
// order takes some microseconds.
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

  /// Whether the list is short enough.
  [[nodiscard]] static bool serves(const PairGraph& graph);

  SmallSearch(const PairGraph& graph, std::uint64_t room);

  struct Found {
    std::vector<Element> order;  ///< in the names of the graph, without items that do not occur
    std::vector<LoadMove> moves;
  };

  /// Anneals for `work` steps (an item or a pair examined), starting with `order`; the result is at
  /// least as good as that. Ends when there are at most `enough` loads, or stop_wanted() returns
  /// true.
  [[nodiscard]] Found anneal(const std::vector<Element>& order, std::uint64_t enough,
                             std::uint64_t work, Random& random,
                             const std::function<bool()>& stop_wanted);

  /// The steps for computing the loads of one order.
  [[nodiscard]] std::uint64_t work_of_look() const;

 private:
  template <std::size_t Words>
  Found anneal_words(std::vector<Element> order, std::uint64_t enough, std::uint64_t work,
                     Random& random, const std::function<bool()>& stop_wanted);

  std::uint64_t room_;
  std::vector<Element> names_;                  // of the graph, by internal name
  std::vector<std::vector<Element>> partners_;  // internal names
  std::uint64_t pairs_ = 0;
};

}  // namespace changeover
