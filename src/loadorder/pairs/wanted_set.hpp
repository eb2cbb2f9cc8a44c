// Internal: the wanted pairs that have met.
//
// Two bits per listed pair; otherwise one bit for each of all pairs (core/pair_set.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/core/pair_set.hpp"
#include "changeover/loadorder/wanted_pairs.hpp"

namespace changeover {

class WantedSet {
 public:
  WantedSet(const WantedPairs& wanted, std::uint64_t items) : wanted_(wanted) {
    if (wanted_.graph() == nullptr) {
      pairs_.emplace(items);
    } else {
      listed_.resize(static_cast<std::size_t>(2 * wanted_.graph()->pairs()), false);
    }
  }

  /// Adds {x,y}; returns whether it is wanted and new.
  bool insert(Element x, Element y) {
    if (pairs_) {
      if (!wanted_.contains(x, y) || pairs_->contains(x, y)) {
        return false;
      }
      pairs_->insert(x, y);
    } else {
      const auto place = wanted_.graph()->place(x, y);
      if (!place || listed_[*place]) {
        return false;
      }
      listed_[*place] = true;
    }
    return true;
  }

  /// Calls insert(x, y) for all y in `memory` with is_due(y), in this order unless x has fewer
  /// partners than that; is_there(y) tells whether an item is in memory. Calls visit(y) for new
  /// pairs.
  template <typename IsThere, typename IsDue, typename Visit>
  void insert_all(Element x, const std::vector<Element>& memory, IsThere&& is_there, IsDue&& is_due,
                  Visit&& visit) {
    const PairGraph* graph = wanted_.graph();
    if (graph != nullptr && graph->partners(x).size() < memory.size()) {
      for (const Element y : graph->partners(x)) {
        if (is_there(y) && is_due(y) && insert(x, y)) {
          visit(y);
        }
      }
      return;
    }
    for (const Element y : memory) {
      if (is_due(y) && insert(x, y)) {
        visit(y);
      }
    }
  }

 private:
  WantedPairs wanted_;
  std::optional<PairSet> pairs_;
  std::vector<bool> listed_;
};

}  // namespace changeover
