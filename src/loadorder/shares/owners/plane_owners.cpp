#include "loadorder/shares/owners/plane_owners.hpp"

#include <algorithm>
#include <utility>

#include "core/checked.hpp"

namespace changeover {
namespace {

class PlaneRule final : public PairRule {
 public:
  PlaneRule(const PlaneOwners& owners, std::uint64_t worker) : owners_(owners), worker_(worker) {}
  [[nodiscard]] bool computes(std::uint64_t /*step*/, Element x, Element y) const override {
    return owners_.owner(x, y) == worker_;
  }

 private:
  const PlaneOwners& owners_;
  std::uint64_t worker_;
};

}  // namespace

PlaneOwners::PlaneOwners(Plane plane, std::uint64_t items)
    : plane_(std::move(plane)), groups_{items, plane_.points()} {}

std::uint64_t PlaneOwners::owner(Element x, Element y) const {
  const std::uint64_t i = groups_.group_of(x);
  const std::uint64_t j = groups_.group_of(y);
  if (i != j) {
    return plane_.line_of(i, j);
  }
  const std::uint64_t high = std::max(x, y) - groups_.begin(i);
  const std::uint64_t low = std::min(x, y) - groups_.begin(i);
  // Without the number, groups of one or two items would all belong to the first lines.
  const std::uint64_t turn = x == y ? low : high * (high - 1) / 2 + low;
  return plane_.line_through(i, (turn + i) % plane_.through_a_point());
}

std::vector<std::uint64_t> PlaneOwners::pairs() const {
  std::vector<std::uint64_t> pairs(static_cast<std::size_t>(plane_.lines()), 0);
  for (std::uint64_t line = 0; line < plane_.lines(); ++line) {
    std::uint64_t sum = 0;
    std::uint64_t squares = 0;
    for (const Element point : plane_.points_of(line)) {
      const std::uint64_t size = groups_.size(point);
      sum += size;
      squares += size * size;
    }
    pairs[static_cast<std::size_t>(line)] = (sum * sum - squares) / 2;
  }
  const std::uint64_t lines = plane_.through_a_point();
  for (std::uint64_t point = 0; point < plane_.points(); ++point) {
    const std::uint64_t count = binomial(groups_.size(point), 2);
    for (std::uint64_t turn = 0; turn < std::min(lines, count); ++turn) {
      const std::uint64_t line = plane_.line_through(point, (turn + point) % lines);
      pairs[static_cast<std::size_t>(line)] += (count - turn - 1) / lines + 1;
    }
  }
  return pairs;
}

std::unique_ptr<const PairRule> PlaneOwners::of(std::uint64_t worker) const {
  return std::make_unique<PlaneRule>(*this, worker);
}

}  // namespace changeover
