// Minimum circular DCCD(2c(2k−3), k) for odd k and c ≡ 0 or 1 (mod 4): base blocks whose new pairs
// have each difference once, v/2 as well, so that the pairs {x, x + v/2} are newly covered twice
// [docs/theorems.md, Theorem 33].
//
// If k is odd and v is even each element has an excess of at least 1. Here it has no more.
#include "construct/entries/families/cyclic/interval_family.hpp"
#include "construct/tools/leave/cyclic_leave.hpp"

namespace changeover::cyclic_half_entry {
namespace {

constexpr Description description{
    .name = "cyclic-half",
    .summary =
        "base blocks {0,...,k-3,x,y} over Z_v with each difference once and v/2 twice, developed",
    .preconditions = "circular, m = 2, k >= 5 odd, v = c(4k-6), c >= 1, c = 0 or 1 modulo 4",
    .guarantee = "a minimum circular DCCD(c(4k-6),k,cv); an expansion set if k-2 | c and v <= 2^20",
    .place = "docs/theorems.md, Theorem 33",
};

class CyclicHalf final : public IntervalFamily {
 public:
  CyclicHalf() : IntervalFamily(description, 2, false) {}

 protected:
  std::uint64_t base_block_count(const Parameters& p) const override {
    if (!asks_for_pairs(p, 2) || p.kind != Kind::circular || p.k < 5 || p.k % 2 == 0 ||
        p.v % (4 * p.k - 6) != 0) {
      return 0;
    }
    const std::uint64_t c = p.v / (4 * p.k - 6);
    return c % 4 < 2 ? c : 0;
  }

  IntervalDevelopedSource::Points points_of(std::uint64_t c, const Parameters& p) const override {
    return CyclicLeave(p.k, {.rounds = c, .left = 0, .half = CyclicLeave::Half::covered})
        .all_points();
  }
};

}  // namespace

const Construction& construction() { return only<CyclicHalf>(); }

}  // namespace changeover::cyclic_half_entry
