#include "loadorder/sizes/byte_closing.hpp"

#include <algorithm>
#include <utility>

#include "changeover/run/control.hpp"

namespace changeover {

ByteClosing::ByteClosing(const ItemSizes& sizes, const PairGraph& graph)
    : sizes_(sizes),
      graph_(graph),
      begin_(static_cast<std::size_t>(graph.items()) + 1, 0),
      front_(graph.items(), 0),
      open_(graph.items(), 0),
      position_(graph.items(), 0),
      place_(graph.items(), 0),
      came_(graph.items(), 0),
      loaded_(graph.items(), false) {
  for (Element x = 0; x < graph.items(); ++x) {
    begin_[x + 1] = begin_[x] + graph.partners(x).size();
  }
  partners_.resize(static_cast<std::size_t>(begin_.back()));
  twin_.resize(partners_.size());
  met_.resize(partners_.size());
}

std::uint64_t ByteClosing::run(const std::vector<Element>& order, std::uint64_t limit) {
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    position_[order[i]] = i;
  }
  // Partners by position: items, in their order, are appended to their partners' lists.
  std::copy(begin_.begin(), begin_.end() - 1, front_.begin());
  for (const Element x : order) {
    for (const Element y : graph_.partners(x)) {
      partners_[front_[y]++] = x;
    }
  }
  // In the same sequence, each item's place in the list of x is the next one in the list of y.
  std::copy(begin_.begin(), begin_.end() - 1, front_.begin());
  for (const Element x : order) {
    for (std::uint64_t at = begin_[x]; at < begin_[x + 1]; ++at) {
      twin_[at] = front_[partners_[at]]++;
    }
    open_[x] = static_cast<std::uint32_t>(begin_[x + 1] - begin_[x]);
  }
  std::copy(begin_.begin(), begin_.end() - 1, front_.begin());
  std::fill(met_.begin(), met_.end(), false);
  std::ranges::fill(place_, 0);
  std::fill(loaded_.begin(), loaded_.end(), false);
  memory_.clear();
  moves_.clear();
  held_ = bytes_ = 0;
  upward_ = true;
  for (const Element x : order) {
    stop_if_asked();
    if (graph_.is_needed(x)) {
      close(x, limit);
      if (bytes_ > limit) {
        break;
      }
    }
  }
  return bytes_;
}

// Items that pass go up and down in turn, so that those that passed last are in memory when the
// next item is closed.
void ByteClosing::close(Element x, std::uint64_t limit) {
  if (open_[x] == 0 && loaded_[x]) {
    return;
  }
  if (place_[x] == 0) {
    load(x, x);
  }
  if (open_[x] == 0) {
    return;
  }
  lacking_.clear();
  for (std::uint64_t at = front_[x]; at < begin_[x + 1]; ++at) {
    if (!met_[at]) {
      lacking_.push_back(partners_[at]);
    }
  }
  if (!upward_) {
    std::ranges::reverse(lacking_);
  }
  upward_ = !upward_;
  for (const Element y : std::exchange(lacking_, {})) {
    load(y, x);
    if (bytes_ > limit) {
      return;
    }
  }
}

void ByteClosing::load(Element x, Element keep) {
  moves_.push_back({x, {}});
  const std::uint64_t size = sizes_.bytes[x];
  make_room(size, keep);
  for (std::uint64_t at = begin_[x]; at < begin_[x + 1]; ++at) {
    if (place_[partners_[at]] != 0 && !met_[at]) {
      met_[at] = met_[twin_[at]] = true;
      --open_[x];
      --open_[partners_[at]];
    }
  }
  memory_.push_back(x);
  place_[x] = static_cast<std::uint32_t>(memory_.size());
  came_[x] = moves_.size();
  loaded_[x] = true;
  held_ += size;
  bytes_ += size;
}

// The first pair that has not met is needed when one of its items is closed.
std::uint32_t ByteClosing::needed(Element x) {
  if (open_[x] == 0) {
    return ~std::uint32_t{0};
  }
  while (met_[front_[x]]) {
    ++front_[x];
  }
  return std::min(position_[x], position_[partners_[front_[x]]]);
}

// Of items that are needed equally late, the last loaded one is evicted: it has just met the items
// that stay.
void ByteClosing::make_room(std::uint64_t bytes, Element keep) {
  while (held_ + bytes > sizes_.memory) {
    Element goes = keep;
    std::pair<std::uint32_t, std::uint64_t> latest{0, 0};
    for (const Element y : memory_) {
      if (y == keep) {
        continue;
      }
      const std::pair<std::uint32_t, std::uint64_t> its{needed(y), came_[y]};
      if (goes == keep || its > latest) {
        goes = y;
        latest = its;
      }
    }
    moves_.back().evict.push_back(goes);
    const std::uint32_t at = place_[goes] - 1;
    memory_[at] = memory_.back();
    place_[memory_[at]] = at + 1;
    memory_.pop_back();
    place_[goes] = 0;
    held_ -= sizes_.bytes[goes];
  }
}

}  // namespace changeover
