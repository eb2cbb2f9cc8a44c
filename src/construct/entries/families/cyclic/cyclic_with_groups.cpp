// Circular double-change designs of constant waste for infinitely many v: a cyclic design on w
// elements, 2n groups of g and cyclic pieces on g+h, n = k−2. [docs/theorems.md, Theorem 16].
//
// Positions cx of the cyclic design have the unchanged subsets {x, …, x+n−1}. Those with x = h,
// h+n, … are the parts; the hinge {0, …, n−1} is between the last block and the first. So the
// design is a stream without any search, in memory of a class of pairs.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/core/developed.hpp"
#include "construct/entry.hpp"
#include "construct/tools/concatenation/groups.hpp"
#include "construct/tools/cyclic.hpp"
#include "core/checked.hpp"

namespace changeover::cyclic_with_groups_entry {
namespace {

constexpr Description description{
    .name = "cyclic-with-groups",
    .summary = "a cyclic design, and cyclic pieces on 2k-4 groups of new elements",
    .preconditions =
        "circular, m = 2, k >= 4; v = h+(k-2)(2k-3)g, h = k-1 for even k, k-2 for odd "
        "k, g = 1-h modulo 4k-6",
    .guarantee = "(k-2)h(h-1) pairs more than there are, whatever v is",
    .place = "docs/theorems.md, Theorem 16",
};

struct Shape {
  std::uint64_t n = 0, hole = 0, w = 0;  // w: elements of the cyclic design
  Groups groups;
};

std::optional<Shape> shape(const Parameters& p) {
  if (!asks_for_pairs(p, 2) || p.kind != Kind::circular || p.k < 4 || p.k > (1U << 15)) {
    return std::nullopt;
  }
  Shape s;
  s.n = p.k - 2;
  s.hole = p.k % 2 == 0 ? s.n + 1 : s.n;
  s.groups.groups = 2 * s.n;
  const std::uint64_t for_each = s.n * (2 * s.n + 1);  // of a group: itself, and parts
  const std::uint64_t round = 4 * p.k - 6;
  if (p.v < s.hole || (p.v - s.hole) % for_each != 0) {
    return std::nullopt;
  }
  s.groups.size = (p.v - s.hole) / for_each;
  s.w = s.hole + s.n * (s.groups.groups - 1) * s.groups.size;
  if (s.groups.size == 0 || (s.groups.size + s.hole) % round != 1) {
    return std::nullopt;
  }
  return s;
}

std::uint64_t rounds(std::uint64_t v, std::uint64_t k) { return (v - 1) / (4 * k - 6); }

std::unique_ptr<BlockSource> cyclic(Parameters p, std::uint64_t v) {
  p.v = v;
  const std::uint64_t c = rounds(v, p.k);
  return std::make_unique<IntervalDevelopedSource>(
      p, 0, p.k - 2, c, [c, k = p.k](std::uint64_t which, std::span<Element> points) {
        std::ranges::copy(double_change_points(c, k, which), points.begin());
      });
}

std::uint64_t blocks_in(const Parameters& p, const Shape& s) {
  const std::uint64_t piece = s.groups.size + s.hole;
  const std::uint64_t inserted =
      checked_multiply(checked_multiply(s.groups.groups - 1, s.groups.size), s.n * s.groups.size);
  return checked_add(
      checked_add(checked_multiply(rounds(s.w, p.k), s.w), inserted),
      checked_multiply(s.groups.groups, checked_multiply(rounds(piece, p.k), piece)));
}

class WithGroupsSource final : public BlockByBlock<WithGroupsSource> {
 public:
  WithGroupsSource(const Parameters& p, const Shape& s)
      : parameters_(p),
        shape_(s),
        base_(cyclic(p, s.w)),
        piece_(cyclic(p, s.groups.size + s.hole)),
        names_(static_cast<std::size_t>(s.groups.size + s.hole)) {
    find_hole();
  }

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return blocks_in(parameters_, shape_);
  }

  bool make(std::span<Element> block) {
    if (next_pair_ < pairs_.size()) {
      insert(block);
      return true;
    }
    if (group_ == 0 && base_->next(block)) {
      after_base_block(++made_);
      return true;
    }
    while (group_ == 0 || !piece_->next(block)) {
      if (group_ == shape_.groups.groups) {
        return false;
      }
      begin_piece(group_++);
    }
    for (Element& x : block) {
      x = names_[x];
    }
    return true;
  }

  bool rewind() override {
    made_ = group_ = part_ = 0;
    next_pair_ = 0;
    pairs_.clear();
    return base_->rewind() && piece_->rewind();
  }

 private:
  // At position cx, x = h + n·part, the pairs of a class come beside {x, …, x+n−1}.
  void after_base_block(std::uint64_t position) {
    const std::uint64_t c = rounds(shape_.w, parameters_.k);
    const std::uint64_t x = shape_.hole + shape_.n * part_;
    if (position == c * x && x < shape_.w) {
      pairs_ = group_class(shape_.groups, 2, part_++);
      next_pair_ = 0;
    }
  }

  void insert(std::span<Element> block) {
    const std::uint64_t x = shape_.hole + shape_.n * (part_ - 1);
    for (std::uint64_t i = 0; i < shape_.n; ++i) {
      block[i] = static_cast<Element>(x + i);
    }
    const Block& pair = pairs_[next_pair_++];
    block[shape_.n] = static_cast<Element>(shape_.w + pair[0]);
    block[shape_.n + 1] = static_cast<Element>(shape_.w + pair[1]);
  }

  // The hole of the piece is {0, …, n−1} and, for even k, the first element that is in neither its
  // first nor its last block.
  void find_hole() {
    const std::uint64_t v = names_.size();
    const std::uint64_t c = rounds(v, parameters_.k);
    std::vector<bool> beside(names_.size());
    for (const Element x : double_change_points(c, parameters_.k, 0)) {
      beside[x] = true;
    }
    for (const Element x : double_change_points(c, parameters_.k, c - 1)) {
      beside[(x + v - 1) % v] = true;
    }
    beside[v - 1] = true;
    in_hole_.assign(names_.size(), false);
    for (Element x = 0; x < shape_.n; ++x) {
      in_hole_[x] = beside[x] = true;
    }
    if (shape_.hole > shape_.n) {
      in_hole_[static_cast<std::size_t>(std::ranges::find(beside, false) - beside.begin())] = true;
    }
  }

  void begin_piece(std::uint64_t group) {
    Element old = 0;
    auto fresh = static_cast<Element>(shape_.w + group * shape_.groups.size);
    for (std::size_t x = 0; x < names_.size(); ++x) {
      names_[x] = in_hole_[x] ? old++ : fresh++;
    }
    piece_->rewind();
  }

  Parameters parameters_;
  Shape shape_;
  std::unique_ptr<BlockSource> base_, piece_;
  std::vector<Element> names_;  // of a piece's elements
  std::vector<bool> in_hole_;
  std::uint64_t made_ = 0;   // blocks of the cyclic design
  std::uint64_t part_ = 0;   // parts that have their class
  std::uint64_t group_ = 0;  // pieces that have begun
  std::vector<Block> pairs_;
  std::size_t next_pair_ = 0;
};

class CyclicWithGroups final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    const auto s = shape(p);
    return s ? std::optional(Promise{.b = blocks_in(p, *s)}) : std::nullopt;
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    return std::make_unique<WithGroupsSource>(p, *shape(p));
  }

  std::string explanation(const Parameters& p) const override {
    const Shape s = *shape(p);
    return fmt::format(
        "The cyclic {} has the unchanged subsets {{x, ..., x+{}}} for all x. At those with x = "
        "{}, {}, ... pairs of {} groups of {} new elements are inserted, so that two of different "
        "groups meet. After the last block comes for each group the cyclic {}, {} elements of "
        "which are the first ones of the other.",
        changeover::name(p.on(s.w)), s.n - 1, s.hole, s.hole + s.n, s.groups.groups, s.groups.size,
        changeover::name(p.on(s.groups.size + s.hole)), s.hole);
  }
};

}  // namespace

const Construction& construction() { return only<CyclicWithGroups>(); }

}  // namespace changeover::cyclic_with_groups_entry
