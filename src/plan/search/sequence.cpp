#include "plan/search/sequence.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "changeover/run/scope.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

__extension__ using Wide = unsigned __int128;

}  // namespace

Weights Weights::of(const Job& job, std::uint64_t tests) {
  Weights weights;
  weights.test = job.test_cost.millionths;
  std::uint64_t largest = 1;
  for (const Amount cost : job.change_costs) {
    weights.change.push_back(std::max<std::uint64_t>(1, cost.millionths));
    largest = std::max(largest, weights.change.back());
  }
  // A search weighs costs a few times over.
  constexpr Wide margin = 64;
  constexpr Wide most = std::numeric_limits<std::int64_t>::max();
  const Wide total = (weights.test + Wide{job.room()} * largest) * (Wide{tests} + 1) * margin;
  if (total > most) {
    weights.unit = static_cast<std::uint64_t>((total + most - 1) / most);
    weights.test = ceil_div(weights.test, weights.unit);
    for (std::uint64_t& weight : weights.change) {
      weight = ceil_div(weight, weights.unit);
    }
  }
  return weights;
}

Sequence::Sequence(const Job& job, Weights weights, const std::vector<Block>& setups)
    : job_(&job),
      fitting_(job),
      weights_(std::move(weights)),
      parts_(job.names.size()),
      room_(static_cast<std::size_t>(job.room())) {
  const std::size_t words = (parts_ + 63) / 64;
  one_weight_ = std::all_of(weights_.change.begin(), weights_.change.end(),
                            [&](std::uint64_t w) { return w == weights_.change.front(); });
  is_movable_.assign(parts_, false);
  count_.assign(parts_ * parts_, 1);
  place_.assign(parts_ * parts_, 0);
  constexpr auto all = std::numeric_limits<std::uint64_t>::max();
  job.needed.for_each(all, [&](Element x, Element y) {
    is_movable_[x] = is_movable_[y] = true;
    count_[pair_index(x, y)] = 0;
    place_[pair_index(x, y)] = static_cast<std::uint32_t>(uncovered_.size());
    uncovered_.push_back(static_cast<std::uint32_t>(pair_index(x, y)));
  });
  for (Element x = 0; x < parts_; ++x) {
    is_movable_[x] = is_movable_[x] || fitting_.least(fitting_.slot(x)) > 0;
  }
  for (const Element m : job.mounted) {
    is_movable_[m] = false;
  }
  for (Element x = 0; x < parts_; ++x) {
    if (is_movable_[x]) {
      movable_.push_back(x);
    }
  }
  has_never_ = job.never.size() > 0;
  if (has_never_) {
    never_.assign(parts_, Bits(words, 0));
    job.never.for_each(all, [&](Element x, Element y) {
      never_[x][y >> 6] |= std::uint64_t{1} << (y & 63);
      never_[y][x >> 6] |= std::uint64_t{1} << (x & 63);
    });
  }
  start_.bits.assign(words, 0);
  start_.of_slot.assign(fitting_.slots(), 0);
  for (const Element x : job.start) {
    put(start_, x);
  }
  for (const Block& setup : setups) {
    stop_if_asked();
    insert(size(), setup);
  }
}

std::vector<Block> Sequence::setups() const {
  std::vector<Block> result;
  result.reserve(size());
  for (const std::uint32_t handle : order_) {
    result.push_back(places_[handle].elements);
    std::sort(result.back().begin(), result.back().end());
  }
  return result;
}

std::pair<Element, Element> Sequence::uncovered_pair(std::size_t index) const {
  const std::uint32_t pair = uncovered_[index];
  return {static_cast<Element>(pair / parts_), static_cast<Element>(pair % parts_)};
}

bool Sequence::may_join(std::size_t at, Element y, Element leaving) const {
  const Place& place = places_[order_[at]];
  if (fitting_.has_slots() && (leaving == y || fitting_.slot(leaving) != fitting_.slot(y)) &&
      (!has_place(place, y) || (leaving != y && !has_to_spare(place, leaving)))) {
    return false;
  }
  if (!has_never_) {
    return true;
  }
  return std::none_of(place.elements.begin(), place.elements.end(),
                      [&](Element z) { return z != leaving && bit(never_[y], z); });
}

std::int64_t Sequence::step(const Place& from, const Place& to) const {
  if (one_weight_) {
    std::int64_t kept = 0;
    for (std::size_t w = 0; w < to.bits.size(); ++w) {
      kept += std::popcount(from.bits[w] & to.bits[w]);
    }
    return (static_cast<std::int64_t>(to.elements.size()) - kept) *
           static_cast<std::int64_t>(weights_.change.front());
  }
  std::int64_t weight = 0;
  for (const Element x : to.elements) {
    weight += bit(from.bits, x) ? 0 : static_cast<std::int64_t>(weights_.change[x]);
  }
  return weight;
}

std::int64_t Sequence::introductions(Element x, Stretch where) const {
  std::int64_t times = 0;
  bool before = bit(place_before(where.first).bits, x);
  for (std::size_t at = where.first; at <= std::min(where.last + 1, size() - 1); ++at) {
    const bool now = holds(at, x);
    times += now && !before ? 1 : 0;
    before = now;
  }
  return times * static_cast<std::int64_t>(weights_.change[x]);
}

void Sequence::put(Place& place, Element y) {
  place.elements.push_back(y);
  place.bits[y >> 6] |= std::uint64_t{1} << (y & 63);
  place.weight += static_cast<std::int64_t>(weights_.change[y]);
  if (const std::size_t s = fitting_.slot(y); s < fitting_.slots()) {
    ++place.of_slot[s];
  }
}

void Sequence::drop(Place& place, Element x) {
  auto found = std::find(place.elements.begin(), place.elements.end(), x);
  *found = place.elements.back();
  place.elements.pop_back();
  place.bits[x >> 6] &= ~(std::uint64_t{1} << (x & 63));
  place.weight -= static_cast<std::int64_t>(weights_.change[x]);
  if (const std::size_t s = fitting_.slot(x); s < fitting_.slots()) {
    --place.of_slot[s];
  }
}

void Sequence::cover(Element x, Element y) {
  const std::size_t pair = pair_index(x, y);
  if (count_[pair]++ == 0) {
    const std::uint32_t last = uncovered_.back();
    uncovered_[place_[pair]] = last;
    place_[last] = place_[pair];
    uncovered_.pop_back();
  }
}

void Sequence::uncover(Element x, Element y) {
  const std::size_t pair = pair_index(x, y);
  if (--count_[pair] == 0) {
    place_[pair] = static_cast<std::uint32_t>(uncovered_.size());
    uncovered_.push_back(static_cast<std::uint32_t>(pair));
  }
}

void Sequence::cover_all(const Place& place) {
  for (std::size_t i = 1; i < place.elements.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      cover(place.elements[i], place.elements[j]);
    }
  }
  occupied_ += place.elements.size();
}

void Sequence::uncover_all(const Place& place) {
  for (std::size_t i = 1; i < place.elements.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      uncover(place.elements[i], place.elements[j]);
    }
  }
  occupied_ -= place.elements.size();
}

void Sequence::exchange(Stretch where, Element x, Element y) {
  cost_ -= introductions(x, where) + introductions(y, where);
  for (std::size_t at = where.first; at <= where.last; ++at) {
    Place& place = places_[order_[at]];
    const bool has_x = bit(place.bits, x);
    const Element leaving = has_x ? x : y;
    const Element coming = has_x ? y : x;
    drop(place, leaving);
    for (const Element z : place.elements) {
      uncover(leaving, z);
      cover(coming, z);
    }
    put(place, coming);
  }
  cost_ += introductions(x, where) + introductions(y, where);
}

void Sequence::add(Stretch where, Element y) {
  cost_ -= introductions(y, where);
  for (std::size_t at = where.first; at <= where.last; ++at) {
    Place& place = places_[order_[at]];
    for (const Element z : place.elements) {
      cover(y, z);
    }
    put(place, y);
    ++occupied_;
  }
  cost_ += introductions(y, where);
}

void Sequence::remove(Stretch where, Element y) {
  cost_ -= introductions(y, where);
  for (std::size_t at = where.first; at <= where.last; ++at) {
    Place& place = places_[order_[at]];
    drop(place, y);
    for (const Element z : place.elements) {
      uncover(y, z);
    }
    --occupied_;
  }
  cost_ += introductions(y, where);
}

std::uint32_t Sequence::take_out(std::size_t at) {
  const std::uint32_t handle = order_[at];
  cost_ -= static_cast<std::int64_t>(weights_.test) + step_into(at) + step_into(at + 1);
  uncover_all(places_[handle]);
  order_.erase(order_.begin() + static_cast<std::ptrdiff_t>(at));
  cost_ += step_into(at);
  return handle;
}

void Sequence::put_back(std::size_t at, std::uint32_t handle) {
  cost_ -= step_into(at);
  order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(at), handle);
  cover_all(places_[handle]);
  cost_ += static_cast<std::int64_t>(weights_.test) + step_into(at) + step_into(at + 1);
}

void Sequence::insert(std::size_t at, std::span<const Element> setup) {
  std::uint32_t handle = 0;
  if (free_.empty()) {
    handle = static_cast<std::uint32_t>(places_.size());
    places_.emplace_back();
    places_.back().elements.reserve(room_);
  } else {
    handle = free_.back();
    free_.pop_back();
  }
  Place& place = places_[handle];
  place.elements.clear();
  place.bits.assign((parts_ + 63) / 64, 0);
  place.of_slot.assign(fitting_.slots(), 0);
  place.weight = 0;
  for (const Element x : setup) {
    put(place, x);
  }
  put_back(at, handle);
}

std::int64_t Sequence::rise_of_reverse(Stretch where) const {
  const Place& first = places_[order_[where.first]];
  const Place& last = places_[order_[where.last]];
  std::int64_t rise = step(place_before(where.first), last) - step_into(where.first);
  if (where.last + 1 < size()) {
    rise += step(first, places_[order_[where.last + 1]]) - step_into(where.last + 1);
  }
  return rise + first.weight - last.weight;
}

std::int64_t Sequence::rise_of_rotate(std::size_t first, std::size_t middle,
                                      std::size_t end) const {
  const auto place = [&](std::size_t at) -> const Place& { return places_[order_[at]]; };
  std::int64_t rise = step(place_before(first), place(middle)) - step_into(first) +
                      step(place(end - 1), place(first)) - step_into(middle);
  if (end < size()) {
    rise += step(place(middle - 1), place(end)) - step_into(end);
  }
  return rise;
}

void Sequence::reverse(Stretch where) {
  // Inside, introductions become leavings: the difference is that of the weights of the two ends.
  cost_ -= step_into(where.first) + step_into(where.last + 1);
  cost_ += places_[order_[where.first]].weight - places_[order_[where.last]].weight;
  std::reverse(order_.begin() + static_cast<std::ptrdiff_t>(where.first),
               order_.begin() + static_cast<std::ptrdiff_t>(where.last) + 1);
  cost_ += step_into(where.first) + step_into(where.last + 1);
}

void Sequence::rotate(std::size_t first, std::size_t middle, std::size_t end) {
  cost_ -= step_into(first) + step_into(middle) + step_into(end);
  std::rotate(order_.begin() + static_cast<std::ptrdiff_t>(first),
              order_.begin() + static_cast<std::ptrdiff_t>(middle),
              order_.begin() + static_cast<std::ptrdiff_t>(end));
  cost_ += step_into(first) + step_into(first + (end - middle)) + step_into(end);
}

}  // namespace changeover
