// Positions beyond those of a cover, what stands beside new elements, and how many to add.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "construct/expansion/partial_expansion_parts.hpp"
#include "core/checked.hpp"

namespace changeover {

std::vector<UnchangedSubset> one_subset_a_position(const Design& design) {
  stop_if_asked();
  const std::size_t b = design.block_count();
  const auto size = static_cast<std::ptrdiff_t>(design.k() - design.parameters().change);
  std::vector<UnchangedSubset> result = unchanged_subsets(design);
  std::erase_if(result, [&](const UnchangedSubset& subset) {
    return static_cast<std::ptrdiff_t>(subset.elements.size()) != size;
  });
  if (b > 0 && design.parameters().kind == Kind::linear) {
    const auto end = [&](std::size_t block) {
      const auto elements = design.block(block);
      Block subset(elements.begin(), elements.begin() + size);
      std::ranges::sort(subset);
      return subset;
    };
    result.insert(result.begin(), {0, end(0)});
    result.push_back({b, end(b - 1)});
  }
  return result;
}

bool add_positions(UnchangedCover& cover, const std::vector<UnchangedSubset>& more,
                   std::uint64_t count) {
  std::vector<UnchangedSubset>& subsets = cover.subsets;
  const auto by_position = [](const auto& a, const auto& b) { return a.position < b.position; };
  std::vector<UnchangedSubset> added;
  for (const UnchangedSubset& subset : more) {
    if (subsets.size() + added.size() >= count) {
      break;
    }
    if (!std::ranges::binary_search(subsets, subset, by_position)) {
      added.push_back(subset);
    }
  }
  subsets.insert(subsets.end(), added.begin(), added.end());
  std::ranges::sort(subsets, by_position);
  return subsets.size() >= count;
}

std::optional<UnchangedCover> cover_at(const Design& design, std::span<const Element> positions) {
  const std::size_t b = design.block_count();
  const bool linear = design.parameters().kind == Kind::linear;
  const auto size = static_cast<std::size_t>(design.k() - design.parameters().change);
  UnchangedCover cover;
  std::vector<bool> met(static_cast<std::size_t>(design.v()), false);
  for (const Element position : positions) {
    const bool end = linear && (position == 0 || position == b);
    if (position > b || (position == 0 && !linear) || (b == 1 && !linear) ||
        (!cover.subsets.empty() && position <= cover.subsets.back().position)) {
      return std::nullopt;
    }
    Block elements;
    if (!end) {
      elements = intersection(design.block(position - 1), design.block(position % b));
      std::ranges::sort(elements);
      for (const Element x : elements) {
        met[x] = true;
      }
    }
    cover.subsets.push_back({position, std::move(elements)});
  }
  // What both end blocks hold is left to the first one to take last.
  std::vector<UnchangedSubset*> ends;
  for (UnchangedSubset& subset : cover.subsets) {
    if (linear && (subset.position == 0 || subset.position == b)) {
      ends.push_back(&subset);
    }
  }
  const auto block_of = [&](const UnchangedSubset& end) {
    return design.block(end.position == 0 ? 0 : b - 1);
  };
  const auto holds = [](std::span<const Element> block, Element x) {
    return std::ranges::find(block, x) != block.end();
  };
  for (const bool shared : {false, true}) {
    for (UnchangedSubset* end : ends) {
      for (const Element x : block_of(*end)) {
        const bool in_all = std::ranges::all_of(
            ends, [&](const UnchangedSubset* each) { return holds(block_of(*each), x); });
        if (!met[x] && in_all == shared && end->elements.size() < size) {
          met[x] = true;
          end->elements.push_back(x);
        }
      }
    }
  }
  for (UnchangedSubset* end : ends) {
    for (const Element x : block_of(*end)) {
      if (end->elements.size() < size && !holds(end->elements, x)) {
        end->elements.push_back(x);
      }
    }
    std::ranges::sort(end->elements);
  }
  return std::ranges::all_of(met, [](bool once) { return once; }) ? std::optional(std::move(cover))
                                                                  : std::nullopt;
}

std::optional<std::vector<Block>> share_out(
    const Block& rest, std::size_t places, std::size_t capacity,
    const std::function<bool(std::size_t, Element)>& allowed) {
  std::vector<Block> result(places);
  std::size_t start = 0;
  for (const Element y : rest) {
    const auto has_room = [&](std::size_t place) { return result[place].size() < capacity; };
    bool placed = false;
    for (std::size_t i = 0; i < places && !placed; ++i) {
      const std::size_t place = (start + i) % places;
      if (has_room(place) && allowed(place, y)) {
        result[place].push_back(y);
        start = (place + 1) % places;
        placed = true;
      }
    }
    // Otherwise y takes the place of another that can go elsewhere.
    for (std::size_t place = 0; place < places && !placed; ++place) {
      if (!allowed(place, y)) {
        continue;
      }
      for (Element& other : result[place]) {
        for (std::size_t elsewhere = 0; elsewhere < places && !placed; ++elsewhere) {
          if (has_room(elsewhere) && allowed(elsewhere, other)) {
            result[elsewhere].push_back(other);
            other = y;
            placed = true;
          }
        }
        if (placed) {
          break;
        }
      }
    }
    if (!placed) {
      return std::nullopt;
    }
  }
  for (Block& beside : result) {
    std::ranges::sort(beside);
  }
  return result;
}

bool put_beside(const Parameters& p, std::uint64_t w, UnchangedCover& cover,
                const std::function<bool(std::size_t, Element)>& allowed) {
  const Block rest = left_out_elements(p.v, cover.subsets);
  cover.beside.clear();
  if (rest.empty()) {
    return true;
  }
  const std::size_t places = cover.subsets.size();
  if (rest.size() > may_be_left_out(p, places, w)) {
    return false;
  }
  if (w < p.change) {
    auto shared = share_out(rest, places, static_cast<std::size_t>(p.change - w), allowed);
    if (!shared) {
      return false;
    }
    cover.beside = *std::move(shared);
    return true;
  }
  // The new element number i mod w of the factorization is unmatched at the i-th position.
  cover.beside.resize(places);
  for (std::size_t i = 0; i < places; ++i) {
    if (const auto turn = static_cast<std::size_t>(i / w); turn < rest.size()) {
      cover.beside[i] = {rest[turn]};
    }
  }
  return true;
}

std::optional<NewElements> best_new_elements(const Design& design, std::uint64_t from,
                                             std::uint64_t to, const CoverOptions& options) {
  if (from == 0 || from > to) {
    throw BadInput(
        fmt::format("the range {}..{} of new elements is empty or begins with 0", from, to));
  }
  const Parameters& p = design.parameters();
  const auto positions = one_subset_a_position(design);
  const auto find = [&](std::uint64_t w) {
    CoverOptions mine = options;
    mine.new_elements = w;
    return find_cover(design, mine);
  };
  // A cover that leaves nothing out; for m = 1, w > 1 one that suits w = 2.
  std::optional<UnchangedCover> plain;
  bool has_plain = false;
  std::optional<NewElements> best;
  for (std::uint64_t w = from; w <= to; ++w) {
    if (p.change >= 3 && w > p.change) {
      break;
    }
    if (w < p.change && p.v < p.k + 2 * p.change - w) {
      continue;
    }
    std::optional<UnchangedCover> cover;
    const bool even = p.change == 2 && w % 2 == 0;
    if (even || (p.change == 1 && w > 1) ||
        (p.change == 2 && w > 2 && has_plain && plain && plain->subsets.size() < w)) {
      if (!has_plain) {
        plain = find(2);
        has_plain = true;
      }
      cover = plain;
      if (cover) {
        const auto count = best_positions(p, cover->subsets.size(), positions.size(), w);
        if (!count || !add_positions(*cover, positions, *count)) {
          cover.reset();
        }
      }
    } else {
      cover = find(w);
    }
    if (!cover) {
      continue;
    }
    NewElements mine{w, 0, 0, *std::move(cover)};
    const bool left_out = p.change == 1 && !left_out_elements(p.v, mine.cover.subsets).empty();
    mine.b =
        checked_add(design.block_count(), blocks_added(p, mine.cover.subsets.size(), w, left_out));
    mine.lower_bound = lower_bound(p.on(p.v + w)).blocks;
    if (!best ||
        checked_multiply(mine.b, best->lower_bound) < checked_multiply(best->b, mine.lower_bound)) {
      best = std::move(mine);
    }
  }
  return best;
}

}  // namespace changeover
