// What moves would change, before they are made.
#include "plan/search/lists/lists.hpp"

namespace changeover {

Lists::Rise Lists::rise_of_replace(Spot where, Element out, Element in) const {
  if (of_model()) {
    return rise_of_value(where, out, in);
  }
  const View& own = view(where.bench);
  const std::vector<std::uint32_t>& order = order_[where.bench];
  const Bits& earlier = before(where).bits;
  const Bits* const later =
      where.at + 1 < order.size() ? &places_[order[where.at + 1]].bits : nullptr;
  Rise rise{.bench = where.bench};
  // A part that is there and in the next set-up need not be put in for that.
  const auto look_at = [&](Element x, int sign) {
    const auto weight = static_cast<std::int64_t>(own.weights.change[x]);
    const std::int64_t times =
        (bit(earlier, x) ? 0 : 1) - (later != nullptr && bit(*later, x) ? 1 : 0);
    rise.work += sign * times * weight;
    for (const Element z : places_[order[where.at]].elements) {
      if (z == out) {
        continue;
      }
      const std::size_t pair = index(x, z);
      if (count_[pair] == (sign < 0 ? 1U : 0U)) {
        rise.missing -= sign * weight_of(pair);
      }
    }
  };
  const Place& place = places_[order[where.at]];
  if (out != no_part) {
    look_at(out, -1);
    rise.overlap -= overlap_of(where.bench, place, out);
  }
  if (in != no_part) {
    look_at(in, 1);
    rise.overlap += overlap_of(where.bench, place, in);
  }
  return rise;
}

// The weight of the pairs that a set-up shows and that are in so many set-ups.
std::int64_t Lists::weight_with_count(std::span<const Element> setup, std::uint32_t times) const {
  std::int64_t weight = 0;
  const auto look_at = [&](Element x, Element y) {
    const std::size_t pair = index(x, y);
    weight += count_[pair] == times ? weight_of(pair) : 0;
  };
  if (const Element hiding = hiding_in(setup); hiding != no_part) {
    for (const Element x : setup) {
      if (x != hiding) {
        look_at(x, hiding);
      }
    }
    return weight;
  }
  for (std::size_t i = 1; i < setup.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      look_at(setup[i], setup[j]);
    }
  }
  return weight;
}

Lists::Rise Lists::rise_of_value(Spot where, Element out, Element in) const {
  const View& own = view(where.bench);
  const Block& row = places_[order_[where.bench][where.at]].elements;
  const Element before_it = rival_in(before(where).elements, in);
  Rise rise{.bench = where.bench,
            .work = price_of(own, before_it, in) - price_of(own, before_it, out)};
  if (where.at + 1 < tests(where.bench)) {
    const Element after = rival_in(places_[order_[where.bench][where.at + 1]].elements, in);
    rise.work += price_of(own, in, after) - price_of(own, out, after);
  }
  if (!scarce_.empty()) {
    const Place& place = places_[order_[where.bench][where.at]];
    rise.overlap = overlap_of(where.bench, place, in) - overlap_of(where.bench, place, out);
  }
  const Element hiding = hiding_in(row);
  const bool hides_then = !hides_.empty() && hides_[in];
  if (hiding == out || (hides_then && hiding == no_part)) {  // other pairs are shown then
    come_ = row;
    *std::ranges::find(come_, out) = in;
    rise.missing = weight_with_count(row, 1) - weight_with_count(come_, 0);
    return rise;
  }
  for (const Element z : row) {
    if (z != out && (hiding == no_part || hiding == z)) {
      rise.missing += count_[index(out, z)] == 1 ? weight_of(index(out, z)) : 0;
      rise.missing -= count_[index(in, z)] == 0 ? weight_of(index(in, z)) : 0;
    }
  }
  return rise;
}

Lists::Rise Lists::rise_of_take_out(Spot where) const {
  const View& own = view(where.bench);
  const std::vector<std::uint32_t>& order = order_[where.bench];
  const Place& place = places_[order[where.at]];
  Rise rise{.bench = where.bench, .work = -place.cost, .overlap = -overlap_of(where.bench, place)};
  if (where.at + 1 < order.size()) {
    const Place& later = places_[order[where.at + 1]];
    rise.work += step(own, before(where), later) - step(own, place, later);
  }
  rise.missing = weight_with_count(place.elements, 1);
  return rise;
}

// What the steps within a stretch cost less if it is reversed.
std::int64_t Lists::saved_within(std::size_t bench, Stretch where) const {
  const View& own = view(bench);
  const std::vector<std::uint32_t>& order = order_[bench];
  if (own.replace.empty()) {
    return mounting(own, places_[order[where.last]]) - mounting(own, places_[order[where.first]]);
  }
  std::int64_t saved = 0;
  for (std::size_t at = where.first; at < where.last; ++at) {
    const Place& here = places_[order[at]];
    const Place& next = places_[order[at + 1]];
    saved += step(own, here, next) - step(own, next, here);
  }
  return saved;
}

// Inside, introductions become removals: the difference is that of mounting the two ends.
Lists::Rise Lists::rise_of_reverse(std::size_t bench, Stretch where) const {
  const View& own = view(bench);
  const std::vector<std::uint32_t>& order = order_[bench];
  const Place& first = places_[order[where.first]];
  const Place& last = places_[order[where.last]];
  const Place& earlier = before({bench, where.first});
  Rise rise{
      .bench = bench,
      .work = step(own, earlier, last) - step(own, earlier, first) - saved_within(bench, where),
      .overlap = -overlap_};
  if (where.last + 1 < order.size()) {
    const Place& later = places_[order[where.last + 1]];
    rise.work += step(own, first, later) - step(own, last, later);
  }
  return rise;
}

Lists::Rise Lists::rise_of_move(Spot from, std::size_t count, Spot to, bool reversed) const {
  const View& old_view = view(from.bench);
  const View& new_view = view(to.bench);
  const auto place = [&](std::size_t bench, std::size_t at) -> const Place& {
    return places_[order_[bench][at]];
  };
  const auto moved = [&](std::size_t i) -> const Place& {
    return place(from.bench, from.at + (reversed ? count - 1 - i : i));
  };
  Rise rise{.bench = from.bench, .other = to.bench, .overlap = -overlap_};
  for (std::size_t i = 0; i < count; ++i) {
    rise.work -= place(from.bench, from.at + i).cost;
    rise.other_work += static_cast<std::int64_t>(new_view.weights.test) +
                       (i > 0 ? step(new_view, moved(i - 1), moved(i)) : 0);
  }
  if (const std::size_t after = from.at + count; after < tests(from.bench)) {
    const Place& later = place(from.bench, after);
    rise.work +=
        step(old_view, before(from), later) - step(old_view, place(from.bench, after - 1), later);
  }
  // The place in the list as it is; it is not where the stretch was.
  Spot gap = to;
  gap.at += to.bench == from.bench && to.at > from.at ? count : 0;
  rise.other_work += step(new_view, before(gap), moved(0));
  if (gap.at < tests(gap.bench)) {
    const Place& later = place(gap.bench, gap.at);
    rise.other_work += step(new_view, moved(count - 1), later) - step(new_view, before(gap), later);
  }
  return rise;
}

std::int64_t Lists::mounting(const View& view, const Place& place) const {
  std::int64_t weight = 0;
  for (const Element x : place.elements) {
    weight += static_cast<std::int64_t>(view.weights.change[x]);
  }
  return weight;
}

}  // namespace changeover
