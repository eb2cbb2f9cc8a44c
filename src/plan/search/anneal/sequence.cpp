#include "plan/search/anneal/sequence.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "changeover/run/control.hpp"
#include "core/bit_number.hpp"
#include "core/checked.hpp"

namespace changeover {
Weights Weights::of(const Job& job, std::uint64_t tests) {
  Weights weights;
  weights.test = job.test_cost.millionths;
  std::uint64_t largest = 1;
  for (const Amount cost : job.change_costs) {
    weights.change.push_back(std::max<std::uint64_t>(1, cost.millionths));
    largest = std::max(largest, weights.change.back());
  }
  for (const Amount cost : job.replace_costs) {
    largest = std::max(largest, cost.millionths);
  }
  // A search adds up several costs.
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
      room_(static_cast<std::size_t>(job.room())),
      words_((parts_ + 63) / 64) {
  one_weight_ = std::all_of(weights_.change.begin(), weights_.change.end(),
                            [&](std::uint64_t w) { return w == weights_.change.front(); });
  is_movable_.assign(parts_, false);
  count_.assign(parts_ * parts_, 1);
  place_.assign(parts_ * parts_, 0);
  constexpr auto all = std::numeric_limits<std::uint64_t>::max();
  job.needed.for_each(all, [&](Element x, Element y) {
    is_movable_[x] = is_movable_[y] = true;
    count_[x * parts_ + y] = count_[y * parts_ + x] = 0;
    place_[pair_index(x, y)] = static_cast<std::uint32_t>(uncovered_.size());
    uncovered_.push_back(static_cast<std::uint32_t>(pair_index(x, y)));
  });
  for (Element x = 0; x < parts_; ++x) {
    is_movable_[x] = is_movable_[x] || fitting_.least(fitting_.slot(x)) > 0;
  }
  for (const Element m : job.mounted) {
    is_movable_[m] = false;
  }
  movable_bits_.assign(words_, 0);
  for (Element x = 0; x < parts_; ++x) {
    if (is_movable_[x]) {
      movable_.push_back(x);
      movable_bits_[x >> 6] |= std::uint64_t{1} << (x & 63);
    }
  }
  has_never_ = job.never.size() > 0;
  if (has_never_) {
    never_.assign(parts_, std::vector<std::uint64_t>(words_, 0));
    job.never.for_each(all, [&](Element x, Element y) {
      never_[x][y >> 6] |= std::uint64_t{1} << (y & 63);
      never_[y][x >> 6] |= std::uint64_t{1} << (x & 63);
    });
  }
  const std::uint32_t start = new_handle();
  for (const Element x : job.start) {
    put(start, x);
  }
  for (const Block& setup : setups) {
    stop_if_asked();
    insert(size(), setup);
  }
}

void Sequence::write_to(std::vector<Element>& flat) const {
  flat.clear();
  for (std::size_t at = 0; at < size(); ++at) {
    const auto members = setup(at);
    flat.push_back(static_cast<Element>(members.size()));
    flat.insert(flat.end(), members.begin(), members.end());
  }
}

std::vector<Block> Sequence::setups_of(const std::vector<Element>& flat) {
  std::vector<Block> result;
  for (auto at = flat.begin(); at != flat.end();) {
    const auto end = at + 1 + static_cast<std::ptrdiff_t>(*at);
    result.emplace_back(at + 1, end);
    std::sort(result.back().begin(), result.back().end());
    at = end;
  }
  return result;
}

std::vector<Block> Sequence::setups() const {
  std::vector<Element> flat;
  write_to(flat);
  return setups_of(flat);
}

std::pair<Element, Element> Sequence::uncovered_pair(std::size_t index) const {
  const std::uint32_t pair = uncovered_[index];
  return {static_cast<Element>(pair / parts_), static_cast<Element>(pair % parts_)};
}

bool Sequence::may_join(std::size_t at, Element y, Element leaving) const {
  const std::uint32_t h = order_[at];
  if (fitting_.has_slots() && (leaving == y || fitting_.slot(leaving) != fitting_.slot(y)) &&
      (!has_place(h, y) || (leaving != y && !has_to_spare(h, leaving)))) {
    return false;
  }
  if (!has_never_) {
    return true;
  }
  const auto members = setup(at);
  return std::none_of(members.begin(), members.end(), [&](Element z) {
    return z != leaving && (never_[y][z >> 6] >> (z & 63) & 1) != 0;
  });
}

std::optional<Element> Sequence::some_difference(std::size_t in, std::size_t without,
                                                 std::uint32_t choice) const {
  const std::uint64_t* const has = bits_of(in == size() ? 0 : order_[in]);
  const std::uint64_t* const lacks = bits_of(without == size() ? 0 : order_[without]);
  std::uint32_t number = 0;
  for (std::size_t w = 0; w < words_; ++w) {
    number += number_of_bits(has[w] & ~lacks[w] & movable_bits_[w]);
  }
  if (number == 0) {
    return std::nullopt;
  }
  auto skip = static_cast<int>((std::uint64_t{choice} * number) >> 32U);
  for (std::size_t w = 0;; ++w) {
    std::uint64_t found = has[w] & ~lacks[w] & movable_bits_[w];
    const auto here = static_cast<int>(number_of_bits(found));
    if (skip < here) {
      for (; skip > 0; --skip) {
        found &= found - 1;
      }
      return static_cast<Element>(64 * w) + static_cast<Element>(std::countr_zero(found));
    }
    skip -= here;
  }
}

std::int64_t Sequence::step(std::uint32_t from, std::uint32_t to) const {
  if (one_weight_) {
    std::int64_t kept = 0;
    for (std::size_t w = 0; w < words_; ++w) {
      kept += number_of_bits(bits_of(from)[w] & bits_of(to)[w]);
    }
    return (static_cast<std::int64_t>(sizes_[to]) - kept) * weight(0);
  }
  std::int64_t total = 0;
  const Element* const elements = elements_of(to);
  for (std::size_t i = 0; i < sizes_[to]; ++i) {
    total += bit(from, elements[i]) ? 0 : weight(elements[i]);
  }
  return total;
}

std::int64_t Sequence::introductions(Element x, Stretch where) const {
  std::int64_t times = 0;
  bool was_there = bit(before(where.first), x);
  for (std::size_t at = where.first; at <= std::min(where.last + 1, size() - 1); ++at) {
    const bool now = holds(at, x);
    times += now && !was_there ? 1 : 0;
    was_there = now;
  }
  return times * weight(x);
}

std::uint32_t Sequence::new_handle() {
  std::uint32_t h = 0;
  if (free_.empty()) {
    h = static_cast<std::uint32_t>(sizes_.size());
    elements_.resize(elements_.size() + room_);
    sizes_.push_back(0);
    bits_.resize(bits_.size() + words_);
    mounting_.push_back(0);
    of_slot_.resize(of_slot_.size() + fitting_.slots());
  } else {
    h = free_.back();
    free_.pop_back();
    sizes_[h] = 0;
    std::fill_n(bits_.begin() + static_cast<std::ptrdiff_t>(h * words_), words_, std::uint64_t{0});
    mounting_[h] = 0;
    std::fill_n(of_slot_.begin() + static_cast<std::ptrdiff_t>(h * fitting_.slots()),
                fitting_.slots(), 0U);
  }
  return h;
}

void Sequence::put(std::uint32_t h, Element y) {
  elements_of(h)[sizes_[h]++] = y;
  flip(h, y);
  mounting_[h] += weight(y);
  if (const std::size_t s = fitting_.slot(y); s < fitting_.slots()) {
    ++of_slot_[h * fitting_.slots() + s];
  }
}

void Sequence::drop(std::uint32_t h, Element x) {
  Element* const elements = elements_of(h);
  Element* const found = std::find(elements, elements + sizes_[h], x);
  *found = elements[--sizes_[h]];
  flip(h, x);
  mounting_[h] -= weight(x);
  if (const std::size_t s = fitting_.slot(x); s < fitting_.slots()) {
    --of_slot_[h * fitting_.slots() + s];
  }
}

void Sequence::cover(Element x, Element y) {
  const std::uint32_t count = count_[x * parts_ + y]++;
  count_[y * parts_ + x] = count + 1;
  if (count == 0) {
    const std::size_t pair = pair_index(x, y);
    const std::uint32_t last = uncovered_.back();
    uncovered_[place_[pair]] = last;
    place_[last] = place_[pair];
    uncovered_.pop_back();
  }
}

void Sequence::uncover(Element x, Element y) {
  const std::uint32_t count = --count_[x * parts_ + y];
  count_[y * parts_ + x] = count;
  if (count == 0) {
    const std::size_t pair = pair_index(x, y);
    place_[pair] = static_cast<std::uint32_t>(uncovered_.size());
    uncovered_.push_back(static_cast<std::uint32_t>(pair));
  }
}

void Sequence::cover_all(std::uint32_t h) {
  const Element* const elements = elements_of(h);
  for (std::size_t i = 1; i < sizes_[h]; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      cover(elements[i], elements[j]);
    }
  }
  occupied_ += sizes_[h];
}

void Sequence::uncover_all(std::uint32_t h) {
  const Element* const elements = elements_of(h);
  for (std::size_t i = 1; i < sizes_[h]; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      uncover(elements[i], elements[j]);
    }
  }
  occupied_ -= sizes_[h];
}

std::int64_t Sequence::rise_of_cost(std::size_t at, Element x, Element y) const {
  const std::uint32_t earlier = before(at);
  std::int64_t rise = (bit(earlier, y) ? 0 : weight(y)) - (bit(earlier, x) ? 0 : weight(x));
  if (at + 1 < size()) {
    const std::uint32_t later = order_[at + 1];
    rise += (bit(later, x) ? weight(x) : 0) - (bit(later, y) ? weight(y) : 0);
  }
  return rise;
}

Rise Sequence::rise_of_replace(std::size_t at, Element x, Element y) const {
  Rise rise{rise_of_cost(at, x, y), 0};
  const std::uint32_t* const with_x = &count_[x * parts_];
  const std::uint32_t* const with_y = &count_[y * parts_];
  for (const Element z : setup(at)) {
    rise.uncovered += (with_x[z] == 1 ? 1 : 0) - (with_y[z] == 0 ? 1 : 0);
  }
  // x itself was counted as one of its partners.
  rise.uncovered += (with_y[x] == 0 ? 1 : 0) - (with_x[x] == 1 ? 1 : 0);
  return rise;
}

void Sequence::replace(std::size_t at, Element x, Element y, const Rise& rise) {
  const std::uint32_t h = order_[at];
  drop(h, x);
  for (const Element z : setup(at)) {
    uncover(x, z);
    cover(y, z);
  }
  put(h, y);
  cost_ += rise.cost;
}

void Sequence::exchange(Stretch where, Element x, Element y) {
  cost_ -= introductions(x, where) + introductions(y, where);
  for (std::size_t at = where.first; at <= where.last; ++at) {
    const std::uint32_t h = order_[at];
    const bool has_x = bit(h, x);
    const Element leaving = has_x ? x : y;
    const Element coming = has_x ? y : x;
    drop(h, leaving);
    for (const Element z : setup(at)) {
      uncover(leaving, z);
      cover(coming, z);
    }
    put(h, coming);
  }
  cost_ += introductions(x, where) + introductions(y, where);
}

void Sequence::add(Stretch where, Element y) {
  cost_ -= introductions(y, where);
  for (std::size_t at = where.first; at <= where.last; ++at) {
    for (const Element z : setup(at)) {
      cover(y, z);
    }
    put(order_[at], y);
    ++occupied_;
  }
  cost_ += introductions(y, where);
}

void Sequence::remove(Stretch where, Element y) {
  cost_ -= introductions(y, where);
  for (std::size_t at = where.first; at <= where.last; ++at) {
    drop(order_[at], y);
    for (const Element z : setup(at)) {
      uncover(y, z);
    }
    --occupied_;
  }
  cost_ += introductions(y, where);
}

Rise Sequence::rise_of_take_out(std::size_t at) const {
  const std::uint32_t h = order_[at];
  Rise rise{-static_cast<std::int64_t>(weights_.test) - step_into(at), 0};
  if (at + 1 < size()) {
    rise.cost += step(before(at), order_[at + 1]) - step(h, order_[at + 1]);
  }
  const auto members = setup(at);
  for (std::size_t i = 1; i < members.size(); ++i) {
    const std::uint32_t* const with = &count_[members[i] * parts_];
    for (std::size_t j = 0; j < i; ++j) {
      rise.uncovered += with[members[j]] == 1 ? 1 : 0;
    }
  }
  return rise;
}

Rise Sequence::rise_of_copy(std::size_t at, Element x, Element y) const {
  Rise rise{static_cast<std::int64_t>(weights_.test), 0};
  if (x == y) {
    return rise;
  }
  rise.cost += weight(y);
  if (at + 1 < size()) {
    const std::uint32_t later = order_[at + 1];
    rise.cost += (bit(later, x) ? weight(x) : 0) - (bit(later, y) ? weight(y) : 0);
  }
  const std::uint32_t* const with_y = &count_[y * parts_];
  for (const Element z : setup(at)) {
    rise.uncovered -= z != x && with_y[z] == 0 ? 1 : 0;
  }
  return rise;
}

std::uint32_t Sequence::take_out(std::size_t at) {
  const std::uint32_t handle = order_[at];
  cost_ -= static_cast<std::int64_t>(weights_.test) + step_into(at) + step_into(at + 1);
  uncover_all(handle);
  order_.erase(order_.begin() + static_cast<std::ptrdiff_t>(at));
  cost_ += step_into(at);
  return handle;
}

void Sequence::put_back(std::size_t at, std::uint32_t handle) {
  cost_ -= step_into(at);
  order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(at), handle);
  cover_all(handle);
  cost_ += static_cast<std::int64_t>(weights_.test) + step_into(at) + step_into(at + 1);
}

void Sequence::insert(std::size_t at, std::span<const Element> setup) {
  const std::uint32_t handle = new_handle();
  for (const Element x : setup) {
    put(handle, x);
  }
  put_back(at, handle);
}

std::int64_t Sequence::rise_of_reverse(Stretch where) const {
  const std::uint32_t first = order_[where.first];
  const std::uint32_t last = order_[where.last];
  std::int64_t rise = step(before(where.first), last) - step_into(where.first);
  if (where.last + 1 < size()) {
    rise += step(first, order_[where.last + 1]) - step_into(where.last + 1);
  }
  return rise + mounting_[first] - mounting_[last];
}

std::int64_t Sequence::rise_of_rotate(std::size_t first, std::size_t middle,
                                      std::size_t end) const {
  std::int64_t rise = step(before(first), order_[middle]) - step_into(first) +
                      step(order_[end - 1], order_[first]) - step_into(middle);
  if (end < size()) {
    rise += step(order_[middle - 1], order_[end]) - step_into(end);
  }
  return rise;
}

void Sequence::reverse(Stretch where) {
  // Inside, introductions become removals: the difference is that of the weights of the two ends.
  cost_ += rise_of_reverse(where);
  std::reverse(order_.begin() + static_cast<std::ptrdiff_t>(where.first),
               order_.begin() + static_cast<std::ptrdiff_t>(where.last) + 1);
}

void Sequence::rotate(std::size_t first, std::size_t middle, std::size_t end) {
  cost_ += rise_of_rotate(first, middle, end);
  std::rotate(order_.begin() + static_cast<std::ptrdiff_t>(first),
              order_.begin() + static_cast<std::ptrdiff_t>(middle),
              order_.begin() + static_cast<std::ptrdiff_t>(end));
}

}  // namespace changeover
