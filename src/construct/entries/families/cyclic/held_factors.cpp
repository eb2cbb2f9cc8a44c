// Double-change designs whose waste does not grow with v: what a cyclic list of base blocks leaves
// is split into classes of pairs, and these pass beside new elements that are held
// [docs/theorems.md, Theorem 33].
//
// v = w + nt, n = k−2. First the cyclic list on w elements, then a short list on nt new ones; where
// the latter keeps a group of n, the pairs of a class pass beside it. Shortest ways lead from the
// one list to the other, over the gaps of the short one, and back if the design is circular. All
// this is a stream in memory of the short list.
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

// The cyclic list, and the held one without the ways over its gaps.
class TwoLists {
 public:
  TwoLists(const Parameters& p, Shape s)
      : k_(p.k),
        shape_(std::move(s)),
        held_(p.k, shape_.groups),
        cyclic_(p.on(shape_.leave.elements()).as(Kind::circular), 0, p.k - 2,
                shape_.leave.base_blocks(), shape_.leave.all_points()) {}

  /// The blocks of both, with the ways that circular designs take or linear ones.
  [[nodiscard]] std::uint64_t count(const Distances& distances, Kind kind) const {
    std::uint64_t b = checked_multiply(shape_.leave.base_blocks(), shape_.leave.elements());
    for (std::size_t i = 0; i < shape_.factors.size(); ++i) {
      b = checked_add(b, shape_.factors.count(i));
    }
    b = checked_add(b, held_.size());
    const auto between = [&](std::uint64_t distance) { return *distances.steps(distance) - 1; };
    b += between(distance_between(last_cyclic(), first_held()));
    b += held_.gaps() * between(k_ - 2);
    return kind == Kind::linear ? b : b + between(distance_between(last_held(), first_cyclic()));
  }

  bool next_cyclic(std::span<Element> block) { return cyclic_.next(block); }
  bool next_held(std::span<Element> block) {
    if (group_ < shape_.groups && held_.position(group_) == made_) {
      write_passing(group_, pair_, block);
      if (++pair_ == shape_.factors.count(group_)) {
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
  void rewind() {
    made_ = pair_ = 0;
    group_ = 0;
    cyclic_.rewind();
  }

  [[nodiscard]] Block first_cyclic() const { return cyclic_block(0, 0); }
  [[nodiscard]] Block last_cyclic() const {
    return cyclic_block(shape_.leave.base_blocks() - 1, shape_.leave.elements() - 1);
  }

 private:
  [[nodiscard]] Block first_held() const {
    Block block(static_cast<std::size_t>(k_));
    if (held_.position(0) == 0) {
      write_passing(0, 0, block);
    } else {
      write_short(0, block);
    }
    return block;
  }
  [[nodiscard]] Block last_held() const {
    Block block(static_cast<std::size_t>(k_));
    const std::size_t last = shape_.factors.size() - 1;
    if (held_.position(last) == held_.size()) {
      write_passing(last, shape_.factors.count(last) - 1, block);
    } else {
      write_short(held_.size() - 1, block);
    }
    return block;
  }
  [[nodiscard]] Block cyclic_block(std::uint64_t which, std::uint64_t shift) const {
    Block block(static_cast<std::size_t>(k_ - 2));
    std::iota(block.begin(), block.end(), 0);
    std::ranges::copy(shape_.leave.points(which), std::back_inserter(block));
    for (Element& x : block) {
      x = static_cast<Element>((x + shift) % shape_.leave.elements());
    }
    return block;
  }
  void write_passing(std::size_t group, std::uint64_t pair, std::span<Element> block) const {
    const std::uint64_t first = shape_.leave.elements() + group * (k_ - 2);
    std::iota(block.begin(), block.end() - 2, static_cast<Element>(first));
    std::ranges::copy(shape_.factors.pair(group, pair), block.end() - 2);
  }
  void write_short(std::uint64_t number, std::span<Element> block) const {
    held_.write(number, block);
    for (Element& x : block) {
      x += static_cast<Element>(shape_.leave.elements());
    }
  }

  std::uint64_t k_;
  Shape shape_;
  HeldList held_;
  IntervalDevelopedSource cyclic_;
  std::uint64_t made_ = 0;  // of the short list
  std::size_t group_ = 0;   // that passes next
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

// Both lists, and shortest ways to where a step would change more than two elements.
class HeldFactorsSource final : public BlockByBlock<HeldFactorsSource> {
 public:
  HeldFactorsSource(const Parameters& p, Shape shape)
      : parameters_(p),
        lists_(p, std::move(shape)),
        distances_(std::make_shared<const Distances>(p.k, p.change, p.v)),
        here_(lists_.last_cyclic()),
        next_(here_) {}

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return lists_.count(*distances_, parameters_.kind);
  }

  bool make(std::span<Element> block) {
    if (lists_.next_cyclic(block)) {
      return true;
    }
    if (!way_) {
      if (!ended_ && !lists_.next_held(next_)) {
        ended_ = true;
        next_ = lists_.first_cyclic();
      }
      if (ended_ && (parameters_.kind == Kind::linear || here_ == next_)) {
        return false;
      }
      if (distance_between(here_, next_) != parameters_.change) {
        way_.emplace(distances_, here_, next_);
      }
    }
    if (way_ && way_->next(block)) {
      return true;
    }
    way_.reset();
    here_ = next_;
    std::ranges::copy(next_, block.begin());
    return !ended_;
  }

  bool rewind() override {
    lists_.rewind();
    here_ = lists_.last_cyclic();
    way_.reset();
    ended_ = false;
    return true;
  }

 private:
  Parameters parameters_;
  TwoLists lists_;
  std::shared_ptr<const Distances> distances_;
  Block here_;
  Block next_;
  std::optional<Way> way_;
  bool ended_ = false;  // only the way back to the first block follows
};

class HeldFactors final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    auto s = shape(p);
    if (!s) {
      return std::nullopt;
    }
    const Distances distances(p.k, p.change, p.v);
    return Promise{.b = TwoLists(p, *std::move(s)).count(distances, p.kind)};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    return std::make_unique<HeldFactorsSource>(p, *shape(p));
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
        explain_development(p.on(w), n, s.leave.base_blocks(), s.leave.all_points());
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
};

}  // namespace

const Construction& construction() { return only<HeldFactors>(); }

}  // namespace changeover::held_factors_entry
