// Covers of Z_v by intervals, in closed form.
//
// The intervals A, A+n, A+2n, … lie side by side; the last one reaches beyond 0 if n does not
// divide v, or else what is left out are the last residues. A + s is the unchanged subset at the
// positions sc, sc+1, …, sc+c−1, where 0 stands for cv; the first of them serves.
//
// For m = 1 and v = 2cn + 1 one residue can be left out at a good place. At c ≥ 2 it is the point
// 2n of the first base block, which leaves at position 1, where A is kept: it is the interval from
// 2n+1+tn on with t = 2c−2 < 2c. At c = 1 it is 0, which leaves at position 1, where A+1 is kept.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "changeover/core/error.hpp"
#include "construct/expansion/partial_expansion_parts.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

bool fits(const Parameters& p, std::uint64_t w) {
  constexpr std::uint64_t largest = std::numeric_limits<std::uint32_t>::max();
  return p.strength == 2 && w > 0 && p.change >= 1 && p.change < p.k && p.k <= p.v &&
         p.v <= largest && w <= largest - p.v && (p.change < 3 || w <= p.change) &&
         (w >= p.change || p.v >= p.k + 2 * p.change - w);
}

Block interval(std::uint64_t start, std::uint64_t n, std::uint64_t v) {
  Block elements;
  elements.reserve(static_cast<std::size_t>(n));
  for (std::uint64_t i = 0; i < n; ++i) {
    elements.push_back(static_cast<Element>((start + i) % v));
  }
  std::ranges::sort(elements);
  return elements;
}

// The fewest intervals when elements may be left out, ℓn + ⌊ℓ/w⌋ ≥ v (for w < m, ℓn + (m−w)ℓ ≥ v).
std::uint64_t fewest(const Parameters& p, std::uint64_t w) {
  const std::uint64_t n = p.k - p.change;
  if (w < p.change) {
    return ceil_div(p.v, n + p.change - w);
  }
  if (p.change != 2 || w % 2 == 0) {
    return ceil_div(p.v, n);
  }
  // Every w intervals serve nw + 1 elements; fewer do no more than n each.
  const std::uint64_t rounds = p.v / (n * w + 1);
  return rounds * w + ceil_div(p.v - rounds * (n * w + 1), n);
}

// Whether y is in A + shift or one of the points + shift.
bool holds(const Parameters& p, std::span<const Element> points, std::uint64_t shift, Element y) {
  const std::uint64_t unshifted = (y + p.v - shift % p.v) % p.v;
  return unshifted < p.k - p.change || std::ranges::find(points, unshifted) != points.end();
}

}  // namespace

std::optional<IntervalCoverSize> interval_cover_size(const Parameters& p, std::uint64_t c,
                                                     std::uint64_t w) {
  if (!fits(p, w) || p.kind != Kind::circular || c == 0) {
    return std::nullopt;
  }
  const std::uint64_t n = p.k - p.change;
  IntervalCoverSize size{ceil_div(p.v, n), false};
  if (p.change == 1) {
    if (w > 1 && p.v == 2 * c * n + 1 &&
        blocks_added(p, 2 * c, w, true) < blocks_added(p, 2 * c + 1, w, false)) {
      size = {2 * c, true};
    }
    return size;
  }
  const std::uint64_t positions = p.v > std::numeric_limits<std::uint64_t>::max() / c
                                      ? std::numeric_limits<std::uint64_t>::max()
                                      : c * p.v;
  const auto count = best_positions(p, fewest(p, w), positions, w);
  if (!count || *count > positions) {
    return std::nullopt;
  }
  size = {*count, *count * n < p.v};
  return size;
}

UnchangedCover interval_cover(const Parameters& p, std::uint64_t c, std::uint64_t w,
                              const IntervalDevelopedSource::Points& points) {
  const std::optional<IntervalCoverSize> size = interval_cover_size(p, c, w);
  if (!size) {
    throw InternalError(fmt::format("no intervals cover {} for w = {}", name(p), w));
  }
  const std::uint64_t n = p.k - p.change;
  const auto points_of = [&](std::uint64_t which) {
    Block result(static_cast<std::size_t>(p.change));
    points(which, result);
    return result;
  };
  UnchangedCover cover;
  const auto add = [&](std::uint64_t shift, std::uint64_t place) {
    const std::uint64_t position = shift * c + place;
    cover.subsets.push_back(
        {static_cast<std::size_t>(position == 0 ? c * p.v : position), interval(shift, n, p.v)});
  };
  const auto sort = [&] {
    std::ranges::sort(cover.subsets,
                      [](const auto& a, const auto& b) { return a.position < b.position; });
  };
  if (p.change == 1 && size->left_out) {
    const std::uint64_t start = c == 1 ? 1 : points_of(0).front() + std::uint64_t{1};
    for (std::uint64_t t = 0; t < size->subsets; ++t) {
      const std::uint64_t shift = (start + t * n) % p.v;
      add(shift, c > 1 && shift == 0 ? 1 : 0);
    }
    sort();
    if (cover.subsets.front().position != 1) {
      throw InternalError("the point of the first base block cannot be left out");
    }
    cover.minimum = true;
    return cover;
  }
  const std::uint64_t side_by_side = std::min(size->subsets, ceil_div(p.v, n));
  for (std::uint64_t t = 0; t < side_by_side; ++t) {
    add(t * n, 0);
  }
  // Further positions: the others of the shifts, from 0 on.
  for (std::uint64_t shift = 0; cover.subsets.size() < size->subsets; ++shift) {
    const bool used = shift % n == 0 && shift / n < side_by_side;
    for (std::uint64_t i = used ? 1 : 0; i < c && cover.subsets.size() < size->subsets; ++i) {
      add(shift, i);
    }
  }
  sort();
  if (size->left_out) {
    const Block first = w < p.change ? points_of(0) : Block{};
    const Block last = w < p.change ? points_of(c - 1) : Block{};
    // Position sc is between B_{c−1} + (s−1) and B₀ + s.
    const bool served = put_beside(p, w, cover, [&](std::size_t place, Element y) {
      const std::uint64_t shift = cover.subsets[place].position / c;
      return !holds(p, last, shift + p.v - 1, y) && !holds(p, first, shift, y);
    });
    if (!served) {
      throw InternalError("what is left out cannot be put beside new elements");
    }
  }
  cover.minimum = true;
  return cover;
}

std::optional<std::uint64_t> interval_cover_for_one_more_size(const Parameters& p, std::uint64_t c,
                                                              std::uint64_t w) {
  if (p.change != 2 || w % 2 != 0 || (w == 2 && c == 1)) {
    return std::nullopt;
  }
  const auto inner = interval_cover_size(p, c, w);
  if (!inner || takes_sweep(p, inner->subsets, w) || !fits(p.on(p.v + w), 1)) {
    return std::nullopt;
  }
  const std::uint64_t n = p.k - 2;
  const std::uint64_t count = std::max(w, ceil_div(p.v + w, n + 1));
  return count <= ceil_div(p.v, n) ? std::optional(count) : std::nullopt;
}

// At a position of the inner cover there are w/2 blocks U ∪ e between B and B′, and U is what is
// kept at each of the w/2 + 1 steps. For w ≥ 4 an old element can come beside x between the first
// two edges, and a new one before the first edge or after the last, not both of which hold it. For
// w = 2 there is one edge, of both new elements: they come beside x at the next position, at which
// U is kept too, and an old one comes before the edge or after it, as it is not in both B and B′.
UnchangedCover interval_cover_for_one_more(const Parameters& p, std::uint64_t c, std::uint64_t w,
                                           const IntervalDevelopedSource::Points& points) {
  const auto count = interval_cover_for_one_more_size(p, c, w);
  if (!count) {
    throw InternalError(
        fmt::format("no intervals cover {} with {} new elements for one more", name(p), w));
  }
  const std::uint64_t n = p.k - 2;
  const UnchangedCover inner = interval_cover(p, c, w, points);
  const std::uint64_t edges = w / 2;
  Block last(2);
  points(c - 1, last);
  Block rest;  // new elements first, as they have to have a place
  for (std::uint64_t x = 0; x < w; ++x) {
    rest.push_back(static_cast<Element>(p.v + x));
  }
  for (std::uint64_t x = *count * n; x < p.v; ++x) {
    rest.push_back(static_cast<Element>(x));
  }
  UnchangedCover cover;
  cover.minimum = true;
  std::size_t used = 0;
  for (std::size_t i = 0; i < inner.subsets.size(); ++i) {
    const auto& [position, elements] = inner.subsets[i];
    const std::uint64_t shift = position / c % p.v;
    if (position % c != 0 || shift % n != 0 || shift / n >= *count) {
      continue;  // a further position, or not needed
    }
    std::uint64_t step = 0;  // how many of the inserted blocks come before x
    Block beside;
    if (used < rest.size()) {
      const Element y = rest[used++];
      beside.push_back(y);
      if (y >= p.v) {
        const OneFactor factor =
            circle_factor(static_cast<std::uint32_t>(w), static_cast<std::uint32_t>(i % (w - 1)));
        const Element x = y - static_cast<Element>(p.v);
        const bool in_first = factor.front().a == x || factor.front().b == x;
        step = !in_first ? 0 : edges == 1 ? edges + 1 : edges;
      } else if (edges > 1 || holds(p, last, shift + p.v - 1, y)) {
        step = 1;
      }
    }
    cover.subsets.push_back({static_cast<std::size_t>(position + edges * i + step), elements});
    cover.beside.push_back(std::move(beside));
  }
  return cover;
}

}  // namespace changeover
