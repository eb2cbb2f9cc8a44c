// Double-change designs whose waste does not grow with v: what a cyclic list of base blocks leaves
// is split into classes of pairs, and these pass beside new elements that are held
// [docs/theorems.md, Theorem 33].
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "changeover/core/developed.hpp"
#include "construct/entry.hpp"
#include "construct/tools/cyclic.hpp"
#include "construct/tools/leave/cyclic_leave.hpp"
#include "construct/tools/leave/held_classes.hpp"
#include "construct/tools/leave/leave_factors.hpp"

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

// For HeldClasses.
class CyclicFactors final : public HeldClasses {
 public:
  explicit CyclicFactors(Shape shape) : shape_(std::move(shape)) {}

  [[nodiscard]] std::uint64_t elements() const override { return shape_.leave.elements(); }
  [[nodiscard]] std::uint64_t base_blocks() const override { return shape_.leave.base_blocks(); }
  [[nodiscard]] IntervalDevelopedSource::Points points() const override {
    return shape_.leave.all_points();
  }
  [[nodiscard]] std::uint64_t groups() const override { return shape_.groups; }
  [[nodiscard]] std::uint64_t count(std::uint64_t i) const override {
    return shape_.factors.count(static_cast<std::size_t>(i));
  }
  void write(std::uint64_t i, std::uint64_t j, std::span<Element> set) const override {
    std::ranges::copy(shape_.factors.pair(static_cast<std::size_t>(i), j), set.begin());
  }

 private:
  Shape shape_;
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

class HeldFactors final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    auto s = shape(p);
    if (!s) {
      return std::nullopt;
    }
    return Promise{.b =
                       held_classes_count(p, std::make_shared<const CyclicFactors>(*std::move(s)))};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    return held_classes_source(p, std::make_shared<const CyclicFactors>(*shape(p)));
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
