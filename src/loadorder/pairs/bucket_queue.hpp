// Internal: a queue of items by small numbers, which returns an item with the lowest one.
//
//     BucketQueue queue(items, BucketQueue::Ties::newest);
//     queue.put(x, degree);                     // or again, with another number
//     while (const auto x = queue.take_lowest()) { … }
//
// Of items with equal numbers it returns the newest or the oldest one. O(1) per change, 12 bytes
// per item, for any number of changes.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

class BucketQueue {
 public:
  enum class Ties : std::uint8_t { newest, oldest };

  explicit BucketQueue(std::size_t items, Ties ties = Ties::newest)
      : ties_(ties), next_(items, none), before_(items, none), number_(items, none) {}

  /// Adds the item, or changes its number.
  void put(Element x, std::uint32_t number) {
    remove(x);
    if (number >= first_.size()) {
      first_.resize(number + std::size_t{1}, none);
      last_.resize(first_.size(), none);
    }
    number_[x] = number;
    if (ties_ == Ties::newest) {
      link(none, x);
      link(x, first_[number]);
    } else {
      link(last_[number], x);
      link(x, none);
    }
    if (before_[x] == none) {
      first_[number] = x;
    }
    if (next_[x] == none) {
      last_[number] = x;
    }
    lowest_ = number < lowest_ ? number : lowest_;
  }

  void remove(Element x) {
    const std::uint32_t number = number_[x];
    if (number == none) {
      return;
    }
    if (first_[number] == x) {
      first_[number] = next_[x];
    }
    if (last_[number] == x) {
      last_[number] = before_[x];
    }
    link(before_[x], next_[x]);
    number_[x] = none;
  }

  [[nodiscard]] bool holds(Element x) const { return number_[x] != none; }

  /// Removes and returns an item with the lowest number; nullopt if the queue is empty.
  std::optional<Element> take_lowest() {
    for (; lowest_ < first_.size(); ++lowest_) {
      if (const Element x = first_[lowest_]; x != none) {
        remove(x);
        return x;
      }
    }
    return std::nullopt;
  }

 private:
  static constexpr Element none = ~Element{0};

  // Makes b the successor of a; one of them may be none.
  void link(Element a, Element b) {
    if (a != none) {
      next_[a] = b;
    }
    if (b != none) {
      before_[b] = a;
    }
  }

  Ties ties_;
  std::vector<Element> first_, last_;  // by number
  std::vector<Element> next_, before_;
  std::vector<std::uint32_t> number_;
  std::size_t lowest_ = 0;
};

}  // namespace changeover
