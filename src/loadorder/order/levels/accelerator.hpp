// Internal: what is on an accelerator while orders for it follow one another.
//
// Items that the current order needs are wanted. An item that it needs no more stays until its
// place is needed; then the one that was used least recently goes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/schedule.hpp"

namespace changeover {

class Accelerator {
 public:
  /// With sizes, `fast_memory` bytes are the room.
  Accelerator(std::uint64_t items, std::uint64_t room,
              std::shared_ptr<const ItemSizes> sizes = nullptr)
      : room_(sizes ? sizes->fast_memory : room),
        sizes_(std::move(sizes)),
        at_(static_cast<std::size_t>(items)) {}

  [[nodiscard]] bool has(Element x) const { return at_[x].fast; }

  /// The current order needs the item no more.
  void unwant(Element x) {
    if (at_[x].wanted && at_[x].fast) {
      idle_.insert(place_of(x), x);
    }
    at_[x].wanted = false;
  }

  /// Transfers the items that are not there yet; adds what goes and comes to the lists of a step.
  /// @throws InternalError if there is no room for all that is wanted
  void bring(const std::vector<Element>& items, std::vector<Element>& fast_evict,
             std::vector<Element>& fast_load) {
    coming_.clear();
    std::uint64_t needed = 0;
    for (const Element x : items) {
      if (at_[x].fast) {
        idle_.erase(place_of(x));
      } else {
        coming_.push_back(x);
        needed += size_of(x);
      }
      at_[x].wanted = true;
      at_[x].used = ++uses_;
    }
    while (held_ + needed > room_) {
      if (idle_.empty()) {
        throw InternalError("an order for the accelerator needs more room than there is");
      }
      take_off(idle_.front(), fast_evict);
    }
    for (const Element x : coming_) {
      held_ += size_of(x);
      at_[x].fast = true;
      at_[x].used = ++uses_;
      fast_load.push_back(x);
    }
  }

  /// By value, since it is erased from a list.
  void take_off(Element x, std::vector<Element>& fast_evict) {
    if (!at_[x].wanted) {
      idle_.erase(place_of(x));
    }
    at_[x].fast = false;
    held_ -= size_of(x);
    fast_evict.push_back(x);
  }

 private:
  struct Item {
    bool wanted = false;     // needed by the current order
    bool fast = false;       // on the accelerator
    std::uint64_t used = 0;  // time of the last use
  };

  [[nodiscard]] std::uint64_t size_of(Element x) const { return sizes_ ? sizes_->bytes[x] : 1; }

  [[nodiscard]] std::vector<Element>::iterator place_of(Element x) {
    return std::lower_bound(idle_.begin(), idle_.end(), x,
                            [&](Element a, Element b) { return at_[a].used < at_[b].used; });
  }

  std::uint64_t room_;
  std::shared_ptr<const ItemSizes> sizes_;
  std::vector<Item> at_;  // by item
  std::uint64_t uses_ = 0;
  std::uint64_t held_ = 0;
  std::vector<Element> idle_;  // on the accelerator but not wanted, most recently used last
  std::vector<Element> coming_;
};

}  // namespace changeover
