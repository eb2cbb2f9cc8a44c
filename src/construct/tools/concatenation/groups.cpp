#include "construct/tools/concatenation/groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "changeover/construct/one_factorization.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "construct/tools/concatenation/slopes.hpp"
#include "construct/tools/concatenation/triple_classes.hpp"
#include "core/checked.hpp"
#include "core/sorted.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

[[noreturn]] void refuse_groups(const std::string& why) {
  throw BadInput("the designs cannot be concatenated with groups: " + why + "; correct the recipe");
}

Block joined(std::span<const Element> one, std::span<const Element> other) {
  Block all(one.begin(), one.end());
  all.insert(all.end(), other.begin(), other.end());
  std::ranges::sort(all);
  return all;
}

bool have_common(std::span<const Element> one, std::span<const Element> other) {
  return !intersection(one, other).empty();
}

// All elements below v but these, increasing.
Block others(std::uint64_t v, std::span<const Element> but) {
  std::vector<bool> is(static_cast<std::size_t>(v));
  for (const Element x : but) {
    is[x] = true;
  }
  Block rest;
  for (Element x = 0; x < v; ++x) {
    if (!is[x]) {
      rest.push_back(x);
    }
  }
  return rest;
}

}  // namespace

std::uint64_t class_count(const Groups& groups, std::uint64_t m) {
  const auto [q, g] = groups;
  if (q < 2 || g == 0 || m < 2) {
    return 0;
  }
  if (m == 2) {
    return q % 2 == 0 || g % 2 == 0 ? checked_multiply(q - 1, g) : 0;
  }
  if (m == 3) {
    return triple_class_count(q, g);
  }
  return q == m && Slopes::known(g, m) ? g : 0;
}

std::vector<Block> group_class(const Groups& groups, std::uint64_t m, std::uint64_t index) {
  const auto [q, g] = groups;
  const auto number = [](std::uint64_t x) { return static_cast<Element>(x); };
  std::vector<Block> blocks;
  if (m == 3) {
    return triple_class(q, g, index);
  }
  if (m > 3) {
    const Slopes slopes(g, m);
    for (std::uint64_t a = 0; a < g; ++a) {
      Block block;
      for (std::uint64_t i = 0; i < q; ++i) {
        block.push_back(number(i * g + slopes.at(i, index, a)));
      }
      blocks.push_back(std::move(block));
    }
    return blocks;
  }
  // Vertices are groups or halves of groups; each edge becomes the pairs of one shift.
  const bool halves = q % 2 != 0;
  const std::uint64_t size = halves ? g / 2 : g;
  const auto vertices = static_cast<std::uint32_t>(halves ? 2 * q : q);
  std::vector<std::uint64_t> from(vertices);
  if (halves) {
    std::uint64_t group = 0;
    for (const auto& [a, b] : circle_factor(vertices, 0)) {
      from[a] = group * g;
      from[b] = group++ * g + size;
    }
  } else {
    for (std::uint32_t a = 0; a < vertices; ++a) {
      from[a] = a * g;
    }
  }
  const auto factor = static_cast<std::uint32_t>(index / size + (halves ? 1 : 0));
  for (const auto& [a, b] : circle_factor(vertices, factor)) {
    for (std::uint64_t t = 0; t < size; ++t) {
      blocks.push_back({number(from[a] + t), number(from[b] + (t + index) % size)});
    }
  }
  return blocks;
}

std::uint64_t most_dropped(std::uint64_t h, const Parameters& p) {
  return h < p.k ? 0 : (h - p.k) / p.change + 1;
}

std::optional<OpenedPiece> opened(const Design& design, std::uint64_t h, std::uint64_t dropped) {
  const bool circular = design.parameters().kind == Kind::circular;
  const std::size_t b = design.block_count();
  const auto n = static_cast<std::size_t>(design.k() - design.parameters().change);
  if (dropped >= b || h < n || h >= design.v()) {
    return std::nullopt;
  }
  const auto fewer = static_cast<std::size_t>(dropped);
  const auto block = [&](std::size_t i) { return design.block(i % b); };
  for (std::size_t from = 0; from < (circular && fewer > 0 ? b : 1); ++from) {
    const std::size_t start = from + fewer;
    OpenedPiece piece{.start = start % b, .count = b - fewer, .hole = {}, .first = {}, .last = {}};
    const std::span<const Element> next = block(start);
    const std::span<const Element> before = block(from + b - 1);
    const bool from_its_start = !circular && fewer == 0;
    piece.first =
        from_its_start ? sorted(next.first(n)) : sorted(intersection(block(start + b - 1), next));
    piece.hole = piece.first;
    for (std::size_t i = from; i < start; ++i) {
      piece.hole = joined(piece.hole, difference(block(i), piece.hole));
    }
    if (circular) {
      piece.last = sorted(intersection(before, block(from)));
    }
    if (piece.hole.size() > h || piece.first.size() != n ||
        have_common(difference(next, piece.first), piece.hole) ||
        (circular &&
         (piece.last.size() != n || have_common(difference(before, piece.last), piece.hole)))) {
      continue;
    }
    Block no_more = joined(piece.hole, difference(next, piece.hole));
    if (circular) {
      no_more = joined(no_more, difference(before, no_more));
    }
    Block more = others(design.v(), no_more);
    if (piece.hole.size() + more.size() < h) {
      continue;
    }
    more.resize(static_cast<std::size_t>(h) - piece.hole.size());
    piece.hole = joined(piece.hole, more);
    return piece;
  }
  return std::nullopt;
}

std::optional<std::uint64_t> piece_blocks(const Parameters& p, const Grouping& how, std::uint64_t h,
                                          std::optional<std::uint64_t> closed,
                                          std::optional<std::uint64_t> open, bool ends_open) {
  const std::uint64_t less = most_dropped(h, p);
  const std::uint64_t rings = how.groups.groups - (ends_open ? 1 : 0);
  const bool one_block = how.groups.size == p.change && h + p.change == p.k;
  if (one_block) {
    closed = 1;
  }
  if ((rings > 0 && !closed) || (ends_open && !open) || how.dropped > rings ||
      (how.dropped > 0 && (less == 0 || less >= *closed)) || (ends_open && less >= *open)) {
    return std::nullopt;
  }
  return checked_multiply(rings, *closed) - how.dropped * less + (ends_open ? *open - less : 0);
}

namespace {

/// A design with groups, in the making.
class Joint {
 public:
  Joint(const Parameters& p, const Grouping& how, const Design& base)
      : p_(p), how_(how), base_(base), n_(static_cast<std::size_t>(p.k - p.change)) {
    for (std::size_t i = 0; i < base.block_count(); ++i) {
      order_.push_back(i);
    }
    if (how.hinge.reversed) {
      std::ranges::reverse(order_);
    }
    find_parts();
  }

  std::vector<Block> made(const Design* closed, const Design* open) {
    make_pieces(closed, open);
    std::vector<std::size_t> part_at(order_.size() + 1, none);
    for (std::size_t j = 0; j < how_.hinge.positions.size(); ++j) {
      part_at[how_.hinge.positions[j]] = j;
    }
    const std::size_t at = static_cast<std::size_t>(how_.hinge.at);
    const std::size_t turned = circular() ? at : 0;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const std::size_t place = (turned + i) % order_.size();
      blocks_.push_back(sorted(block(place)));
      if (place + 1 == at) {
        std::ranges::move(pieces_, std::back_inserter(blocks_));
      } else if (part_at[place + 1] != none) {
        insert_beside(part_at[place + 1]);
      }
    }
    return std::move(blocks_);
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  [[nodiscard]] bool circular() const { return base_.parameters().kind == Kind::circular; }
  [[nodiscard]] std::span<const Element> block(std::size_t place) const {
    return base_.block(order_[place % order_.size()]);
  }
  [[nodiscard]] Block unchanged(std::uint64_t position) const {
    const auto place = static_cast<std::size_t>(position);
    return sorted(intersection(block(place - 1), block(place)));
  }

  // What is in the parts, and what is in the hole.
  void find_parts() {
    const Hinge& hinge = how_.hinge;
    const std::size_t steps = order_.size() - (circular() ? 0 : 1);
    const bool at_end = !circular() && hinge.at == order_.size();
    if (hinge.at < 1 || (hinge.at > steps && !at_end)) {
      refuse_groups(fmt::format("the pieces come at a position from 1 to {}", order_.size()));
    }
    if (hinge.elements.size() != n_ ||
        !(at_end ? holds_all(block(order_.size() - 1), hinge.elements)
                 : unchanged(hinge.at) == sorted(hinge.elements))) {
      refuse_groups(fmt::format("the hinge must be {} that stay at position {}",
                                count_of(n_, "element"), hinge.at));
    }
    std::uint64_t last = 0;
    Block taken = sorted(hinge.elements);
    std::vector<bool> is(static_cast<std::size_t>(base_.v()));
    for (const Element x : taken) {
      is[x] = true;
    }
    taken.clear();
    for (const Element position : hinge.positions) {
      if (position <= last || position > steps) {
        refuse_groups(fmt::format("positions of parts must increase, from 1 to {}", steps));
      }
      last = position;
      parts_.push_back(unchanged(position));
      if (parts_.back().size() != n_) {
        refuse_groups(
            fmt::format("not {} change at position {}", count_of(p_.change, "element"), position));
      }
      for (const Element x : parts_.back()) {
        if (is[x]) {
          refuse_groups(fmt::format("element {} is in two parts, or in the hinge and a part", x));
        }
        is[x] = true;
        taken.push_back(x);
      }
    }
    hole_ = others(base_.v(), taken);
    classes_ = class_count(how_.groups, p_.change);
    if (classes_ == 0 || parts_.size() < classes_) {
      refuse_groups(fmt::format("{} of {} take {} parts", count_of(how_.groups.groups, "group"),
                                count_of(how_.groups.size, "element"),
                                classes_ == 0 ? "unknown" : std::to_string(classes_)));
    }
  }

  void insert_beside(std::size_t part) {
    for (Block& block : group_class(how_.groups, p_.change, part % classes_)) {
      for (Element& x : block) {
        x += static_cast<Element>(base_.v());
      }
      blocks_.push_back(joined(parts_[part], block));
    }
  }

  [[nodiscard]] Block group(std::uint64_t i) const {
    Block elements(static_cast<std::size_t>(how_.groups.size));
    std::iota(elements.begin(), elements.end(),
              static_cast<Element>(base_.v() + i * how_.groups.size));
    return elements;
  }

  static void name(std::vector<Element>& names, std::span<const Element> from,
                   std::span<const Element> to) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      names[from[i]] = to[i];
    }
  }

  // The hole of the piece becomes Y, so that its list begins with the elements in `ends_`.
  std::vector<Element> names_of_hole(const Design& design, const OpenedPiece& piece) const {
    std::vector<Element> names(static_cast<std::size_t>(design.v()));
    name(names, piece.first, ends_);
    name(names, difference(piece.hole, piece.first), difference(hole_, ends_));
    return names;
  }

  void add(const Design& design, const OpenedPiece& piece, std::vector<Element> names,
           std::uint64_t number, bool backwards) {
    name(names, others(design.v(), piece.hole), group(number));
    const std::size_t begin = pieces_.size();
    for (std::size_t i = 0; i < piece.count; ++i) {
      Block block;
      for (const Element x : design.block((piece.start + i) % design.block_count())) {
        block.push_back(names[x]);
      }
      pieces_.push_back(sorted(block));
    }
    if (backwards) {
      std::reverse(pieces_.begin() + static_cast<std::ptrdiff_t>(begin), pieces_.end());
    }
  }

  OpenedPiece piece_of(const Design& design, std::uint64_t dropped) const {
    if (design.v() != hole_.size() + how_.groups.size) {
      refuse_groups(fmt::format("a piece has {}, {} in the hole and {} in the group",
                                count_of(hole_.size() + how_.groups.size, "element"), hole_.size(),
                                how_.groups.size));
    }
    auto piece = opened(design, hole_.size(), dropped);
    if (!piece) {
      refuse_groups(
          fmt::format("no hole of {} fits into a piece", count_of(hole_.size(), "element")));
    }
    return *std::move(piece);
  }

  void make_pieces(const Design* closed, const Design* open) {
    const std::uint64_t rings = how_.groups.groups - (open == nullptr ? 0 : 1);
    const bool ends_there =
        p_.kind == Kind::linear && (circular() || how_.hinge.at == order_.size());
    if (how_.dropped > rings || (!ends_there && (how_.dropped % 2 != 0 || open != nullptr))) {
      refuse_groups(
          "at most all pieces lack blocks, an even number of them and no open one if others "
          "follow");
    }
    ends_ = sorted(how_.hinge.elements);
    const std::uint64_t less = most_dropped(hole_.size(), p_);
    std::optional<OpenedPiece> shorter;
    std::optional<OpenedPiece> whole;
    std::vector<Element> shared;
    for (std::uint64_t i = 0; i < how_.groups.groups; ++i) {
      stop_if_asked();
      if (open != nullptr && i + 1 == how_.groups.groups) {
        const OpenedPiece piece = piece_of(*open, less);
        add(*open, piece, names_of_hole(*open, piece), i, false);
      } else if (i < how_.dropped) {
        if (closed == nullptr || less == 0) {
          refuse_groups("no blocks are inside the hole");
        }
        if (!shorter) {
          shorter = piece_of(*closed, less);
          shared = names_of_hole(*closed, *shorter);
        }
        add(*closed, *shorter, shared, i, i % 2 != 0);
        ends_ = i % 2 == 0 ? shorter->last : shorter->first;
        for (Element& x : ends_) {
          x = shared[x];
        }
        std::ranges::sort(ends_);
      } else if (closed == nullptr) {
        pieces_.push_back(joined(ends_, group(i)));
      } else {
        if (!whole) {
          whole = piece_of(*closed, 0);
        }
        add(*closed, *whole, names_of_hole(*closed, *whole), i, false);
      }
    }
  }

  const Parameters& p_;
  const Grouping& how_;
  const Design& base_;
  std::size_t n_;
  std::vector<std::size_t> order_;
  std::vector<Block> parts_;
  Block hole_;
  std::uint64_t classes_ = 0;
  Block ends_;  // what the block before the next piece has of the hole
  std::vector<Block> pieces_, blocks_;
};

}  // namespace

Recipe concatenate_groups_recipe(const Parameters& p, const Grouping& how, Recipe base,
                                 std::optional<Recipe> closed, std::optional<Recipe> open) {
  Recipe recipe{"concatenate-groups",
                p,
                {{"groups", static_cast<std::int64_t>(how.groups.groups)},
                 {"at", static_cast<std::int64_t>(how.hinge.at)},
                 {"reversed", how.hinge.reversed ? 1 : 0},
                 {"dropped", static_cast<std::int64_t>(how.dropped)}},
                {std::move(base)},
                {how.hinge.positions, how.hinge.elements}};
  for (std::optional<Recipe>* piece : {&closed, &open}) {
    if (*piece) {
      recipe.inputs.push_back(*std::move(*piece));
    }
  }
  return recipe;
}

std::vector<Block> with_groups(const Parameters& p, const Grouping& how, const Design& base,
                               const Design* closed, const Design* open) {
  return Joint(p, how, base).made(closed, open);
}

}  // namespace changeover
