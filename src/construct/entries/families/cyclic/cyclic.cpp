// The tight circular DCCD(c(4k−6)+1, k, c²(4k−6)+c) for every c ≥ 1 and every k ≥ 3.
//
// The printed theorem stops at c = 5. What is needed for more is a way of pairing 2c numbers, which
// has a closed form: construct/tools/cyclic.hpp, proved in docs/theorems.md. The pairs are made as
// they are asked for, so the design is a stream without any memory for its base blocks.
#include <algorithm>

#include "construct/entries/families/cyclic/interval_family.hpp"

namespace changeover::cyclic_entry {
namespace {

constexpr Description description{
    .name = "cyclic",
    .summary = "c base blocks {0,...,k-3,x,y} over Z_v from a pairing of 2c numbers, developed",
    .preconditions = "circular, m = 2, k >= 3, v = c(4k-6)+1 with c >= 1",
    .guarantee =
        "a tight circular DCCD(c(4k-6)+1,k,cv); an expansion set if k-2 | 2c+1 and v <= 2^20",
    .cited = "ChafeeStevens2025",
    .place = "Theorem 10, here for all c: docs/theorems.md, Theorem 1",
};

class Cyclic final : public IntervalFamily {
 public:
  Cyclic() : IntervalFamily(description, 2) {}

 protected:
  std::uint64_t base_block_count(const Parameters& p) const override {
    if (!asks_for_pairs(p, 2) || p.kind != Kind::circular || p.k < 3 ||
        (p.v - 1) % (4 * p.k - 6) != 0) {
      return 0;
    }
    return (p.v - 1) / (4 * p.k - 6);
  }

  IntervalDevelopedSource::Points points_of(std::uint64_t c, const Parameters& p) const override {
    return [c, k = p.k](std::uint64_t which, std::span<Element> points) {
      std::ranges::copy(double_change_points(c, k, which), points.begin());
    };
  }
};

}  // namespace

const Construction& construction() { return only<Cyclic>(); }

}  // namespace changeover::cyclic_entry
