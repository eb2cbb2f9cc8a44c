// Double-change designs whose waste does not grow with v: what a cyclic list of base blocks leaves
// is split into classes of pairs, and these pass beside new elements that are held [docs/theorems.md,
// Theorem 33].
//
// v = w + nt, n = k−2. First the cyclic list on w elements, then a short list on nt new ones; where
// the latter keeps a group of n, the pairs of a class pass beside it. Where two neighbours do not
// differ in two elements a shortest way leads from the one to the other: between the two lists, and
// back if the design is circular. The list is a stream in memory of the short list.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "changeover/core/developed.hpp"
#include "construct/entry.hpp"
#include "construct/tools/cyclic.hpp"
#include "construct/tools/leave/cyclic_leave.hpp"
#include "construct/tools/leave/held_lists.hpp"
#include "construct/tools/leave/leave_factors.hpp"
#include "construct/tools/path.hpp"
#include "core/checked.hpp"

namespace changeover::held_factors_entry {
namespace {

constexpr Description description{
    .name = "held-factors",
    .summary = "a cyclic list, and 1-factors of what it leaves beside groups of new elements",
    .preconditions = "m = 2, 4 <= k <= 64, v from about 5k^2 on, and some smaller ones",
    .guarantee =
        "over the counting or degree bound by at most a number of blocks that depends on k alone",
    .place = "docs/theorems.md, Theorem 33",
};

constexpr std::uint64_t largest_k = 64;

struct Shape {
  std::uint64_t groups;  // t
  CyclicLeave leave;
  LeaveFactors factors;
};

// t groups of n are held, and t tells the rest. If k is odd and v even each element must meet one
// twice, so pairs with the difference w/2 are covered twice.
std::optional<Shape> shape_with(const Parameters& p, std::uint64_t groups) {
  using Half = CyclicLeave::Half;
  const bool covers_half = p.k % 2 == 1 && p.v % 2 == 0;
  if (covers_half && groups % 2 == 1) {
    return std::nullopt;
  }
  const std::uint64_t n = p.k - 2;
  const std::uint64_t round = 4 * p.k - 6;
  const std::uint64_t others = groups * (n + 1) + (covers_half ? 0 : 1);  // than 2cN
  if (p.v < others + round || (p.v - others) % round != 0) {
    return std::nullopt;
  }
  const CyclicLeave::Shape shape{(p.v - others) / round, groups / 2,
                                 covers_half       ? Half::covered
                                 : groups % 2 == 1 ? Half::left
                                                   : Half::none};
  if (!CyclicLeave::serves(p.k, shape)) {
    return std::nullopt;
  }
  const CyclicLeave leave(p.k, shape);
  auto factors = LeaveFactors::of(leave.elements(), leave.differences(), shape.half == Half::left);
  return factors ? std::optional(Shape{groups, leave, *std::move(factors)}) : std::nullopt;
}

std::optional<Shape> shape(const Parameters& p) {
  if (!asks_for_pairs(p, 2) || p.k < 4 || p.k > largest_k) {
    return std::nullopt;
  }
  // t is determined modulo N or 2N; not for the least are there always base blocks.
  const std::uint64_t most = 8 * p.k - 12;
  for (std::uint64_t groups = 1; groups < most; ++groups) {
    if (auto found = shape_with(p, groups)) {
      return found;
    }
  }
  return std::nullopt;
}

IntervalDevelopedSource::Points points_of(const CyclicLeave& leave) {
  return [leave](std::uint64_t which, std::span<Element> points) {
    std::ranges::copy(leave.points(which), points.begin());
  };
}

// The two lists, without the ways between them.
class TwoLists final : public BlockByBlock<TwoLists> {
 public:
  TwoLists(const Parameters& p, Shape s)
      : parameters_(p.as(Kind::linear)),
        shape_(std::move(s)),
        held_(p.k, shape_.groups),
        cyclic_(p.on(shape_.leave.elements()).as(Kind::circular), 0, p.k - 2,
                shape_.leave.base_blocks(), points_of(shape_.leave)) {}

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    std::uint64_t b = checked_multiply(shape_.leave.base_blocks(), shape_.leave.elements());
    for (std::size_t i = 0; i < shape_.factors.size(); ++i) {
      b = checked_add(b, shape_.factors.count(i));
    }
    return checked_add(b, held_.size());
  }

  bool make(std::span<Element> block) {
    if (cyclic_.next(block)) {
      return true;
    }
    const bool passes = group_ < shape_.groups && held_.position(group_) == made_;
    if (passes) {
      write_held(group_, pair_, block);
      if (++pair_ == shape_.factors.count(static_cast<std::size_t>(group_))) {
        ++group_;
        pair_ = 0;
      }
      return true;
    }
    if (made_ == held_.size()) {
      return false;
    }
    write_short(made_++, block);
    return true;
  }

  bool rewind() override {
    made_ = group_ = 0;
    pair_ = 0;
    return cyclic_.rewind();
  }

  // ---- The blocks at the ends of the two lists.

  [[nodiscard]] Block first_cyclic() const { return cyclic_block(0, 0); }
  [[nodiscard]] Block last_cyclic() const {
    return cyclic_block(shape_.leave.base_blocks() - 1, shape_.leave.elements() - 1);
  }
  [[nodiscard]] Block first_held() const {
    return held_.position(0) == 0 ? passing(0, 0) : short_block(0);
  }
  [[nodiscard]] Block last_held() const {
    const std::uint64_t last = shape_.groups - 1;
    return held_.position(last) == held_.size()
               ? passing(last, shape_.factors.count(static_cast<std::size_t>(last)) - 1)
               : short_block(held_.size() - 1);
  }
  [[nodiscard]] std::uint64_t gaps() const { return held_.gaps(); }

 private:
  [[nodiscard]] Block cyclic_block(std::uint64_t which, std::uint64_t shift) const {
    Block block(static_cast<std::size_t>(parameters_.k - 2));
    std::iota(block.begin(), block.end(), 0);
    std::ranges::copy(shape_.leave.points(which), std::back_inserter(block));
    for (Element& x : block) {
      x = static_cast<Element>((x + shift) % shape_.leave.elements());
    }
    return block;
  }
  [[nodiscard]] Block passing(std::uint64_t group, std::uint64_t pair) const {
    Block block(static_cast<std::size_t>(parameters_.k));
    write_held(group, pair, block);
    return block;
  }
  [[nodiscard]] Block short_block(std::uint64_t number) const {
    Block block(static_cast<std::size_t>(parameters_.k));
    write_short(number, block);
    return block;
  }
  void write_held(std::uint64_t group, std::uint64_t pair, std::span<Element> block) const {
    const auto n = static_cast<std::ptrdiff_t>(parameters_.k - 2);
    std::iota(block.begin(), block.begin() + n,
              static_cast<Element>(shape_.leave.elements() + group * (parameters_.k - 2)));
    std::ranges::copy(shape_.factors.pair(static_cast<std::size_t>(group), pair),
                      block.begin() + n);
  }
  void write_short(std::uint64_t number, std::span<Element> block) const {
    held_.write(number, block);
    for (Element& x : block) {
      x += static_cast<Element>(shape_.leave.elements());
    }
  }

  Parameters parameters_;
  Shape shape_;
  HeldList held_;
  IntervalDevelopedSource cyclic_;
  std::uint64_t made_ = 0;   // of the short list
  std::uint64_t group_ = 0;  // that passes next
  std::uint64_t pair_ = 0;
};

// "the differences 16, 17, 19", or "8 differences from 83 to 98" of more than six.
std::string differences(const std::vector<std::uint64_t>& numbers) {
  constexpr std::size_t most_shown = 6;
  if (numbers.size() > most_shown) {
    return fmt::format("{} differences from {} to {}", numbers.size(), numbers.front(),
                       numbers.back());
  }
  return fmt::format("the difference{} {}", numbers.size() == 1 ? "" : "s",
                     fmt::join(numbers, ", "));
}

std::uint64_t missing(const Block& from, const Block& to) {
  return static_cast<std::uint64_t>(std::ranges::count_if(
      to, [&](Element x) { return std::ranges::find(from, x) == from.end(); }));
}

// A list in which neighbours may differ in more than two elements, with shortest ways between them.
class Joined final : public BlockByBlock<Joined> {
 public:
  Joined(const Parameters& p, std::unique_ptr<TwoLists> lists, std::uint64_t b)
      : parameters_(p),
        lists_(std::move(lists)),
        b_(b),
        distances_(std::make_shared<const Distances>(p.k, p.change, p.v)),
        here_(static_cast<std::size_t>(p.k)),
        next_(here_) {}

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override { return b_; }

  bool make(std::span<Element> block) {
    if (way_) {
      if (way_->next(block)) {
        return true;
      }
      way_.reset();
      if (ended_) {
        return false;
      }
      std::ranges::copy(next_, block.begin());
      here_ = next_;
      return true;
    }
    if (ended_) {
      return false;
    }
    if (!lists_->next(next_)) {
      ended_ = true;
      if (parameters_.kind == Kind::linear) {
        return false;
      }
      next_ = lists_->first_cyclic();
      way_.emplace(distances_, here_, next_);
      return make(block);
    }
    if (begun_ && missing(here_, next_) != parameters_.change) {
      way_.emplace(distances_, here_, next_);
      return make(block);
    }
    begun_ = true;
    std::ranges::copy(next_, block.begin());
    here_ = next_;
    return true;
  }

  bool rewind() override {
    way_.reset();
    begun_ = ended_ = false;
    return lists_->rewind();
  }

 private:
  Parameters parameters_;
  std::unique_ptr<TwoLists> lists_;
  std::uint64_t b_;
  std::shared_ptr<const Distances> distances_;
  Block here_;
  Block next_;
  std::optional<Way> way_;
  bool begun_ = false;
  bool ended_ = false;
};

class HeldFactors final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    const auto s = shape(p);
    return s ? std::optional(Promise{.b = count(p, *s)}) : std::nullopt;
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    Shape s = *shape(p);
    const std::uint64_t b = count(p, s);
    return std::make_unique<Joined>(p, std::make_unique<TwoLists>(p, std::move(s)), b);
  }

  std::string explanation(const Parameters& p) const override {
    const Shape s = *shape(p);
    const std::uint64_t w = s.leave.elements();
    const std::uint64_t n = p.k - 2;
    std::vector<std::uint64_t> left = s.leave.differences();
    if (s.leave.half() == CyclicLeave::Half::left) {
      left.push_back(w / 2);
    }
    const std::string developed =
        explain_development(p.on(w), n, s.leave.base_blocks(), points_of(s.leave));
    std::uint64_t pairs = 0;
    for (std::size_t i = 0; i < s.factors.size(); ++i) {
      pairs = std::max(pairs, s.factors.count(i));
    }
    const std::string beside =
        s.groups == 1
            ? fmt::format("These pass beside {} new elements that are held.", n)
            : fmt::format(
                  "{} make {} classes, each of which holds every element of Z_{}. Each "
                  "passes beside a group of {} new elements, which is held in a short list "
                  "on all {} new elements.",
                  2 * pairs == w ? "They" : "They and a few more", s.groups, w, n, s.groups * n);
    return fmt::format("{} This leaves the pairs with {}. {}", developed, differences(left),
                       beside);
  }

  static std::uint64_t count(const Parameters& p, const Shape& s) {
    const TwoLists lists(p, s);
    const Distances distances(p.k, p.change, p.v);
    const auto between = [&](const Block& from, const Block& to) {
      return distances.steps(missing(from, to)).value() - 1;
    };
    std::uint64_t b = *lists.block_count() + between(lists.last_cyclic(), lists.first_held());
    if (p.kind == Kind::circular) {
      b += between(lists.last_held(), lists.first_cyclic());
    }
    b += lists.gaps() * (*distances.steps(p.k - 2) - 1);
    return b;
  }
};

}  // namespace

const Construction& construction() { return only<HeldFactors>(); }

}  // namespace changeover::held_factors_entry
