// Circular 3-change designs (6c(k−2), k) with c base blocks whose new pairs have each difference
// once, v/2 as well, so that the pairs {x, x + v/2} are newly covered twice: c blocks more than the
// counting bound [docs/theorems.md, Theorem 34].
#include "construct/entries/families/cyclic/interval_family.hpp"
#include "construct/tools/leave/triple_leave.hpp"

namespace changeover::cyclic_triple_half_entry {
namespace {

constexpr Description description{
    .name = "cyclic-triple-half",
    .summary =
        "base blocks {0,...,k-4,x,y,z} over Z_v with each difference once and v/2 twice, developed",
    .preconditions = "circular, m = 3, k >= 4, v = 6c(k-2) with c = 1, 4, 5, 8, 9, 12 or 13, (72,6)",
    .guarantee = "cv blocks, c more than the counting bound",
    .place = "docs/theorems.md, Theorem 34",
};

class CyclicTripleHalf final : public IntervalFamily {
 public:
  CyclicTripleHalf() : IntervalFamily(description, 3, false) {}

 protected:
  std::uint64_t base_block_count(const Parameters& p) const override {
    if (!asks_for_pairs(p, 3) || p.kind != Kind::circular) {
      return 0;
    }
    const auto leave = TripleLeave::without_leave(p.k, p.v);
    return leave ? leave->base_blocks() : 0;
  }

  IntervalDevelopedSource::Points points_of(std::uint64_t c, std::uint64_t k) const override {
    return TripleLeave::without_leave(k, 6 * c * (k - 2))->points();
  }
};

}  // namespace

const Construction& construction() { return only<CyclicTripleHalf>(); }

}  // namespace changeover::cyclic_triple_half_entry
