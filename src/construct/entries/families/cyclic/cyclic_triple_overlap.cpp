// Circular 3-change designs with c base blocks whose new pairs have each difference, most of them
// once: on 6c(k−2) elements, where only v/2 comes and pairs {x, x + v/2} are newly covered twice,
// or on 6c(k−2)−2j+1, where j differences come twice [docs/theorems.md, Theorem 34].
#include "construct/entries/families/cyclic/interval_family.hpp"
#include "construct/tools/leave/triple_leave.hpp"

namespace changeover::cyclic_triple_overlap_entry {
namespace {

constexpr Description description{
    .name = "cyclic-triple-overlap",
    .summary = "base blocks {0,...,k-4,x,y,z} over Z_v, developed; few differences come twice",
    .preconditions =
        "circular, m = 3, k >= 4, v = 6c(k-2), 6c(k-2)-1 or 6c(k-2)-3, c <= 13 as known",
    .guarantee =
        "c, 2c-1 or 4c-1 blocks over the counting bound; minimum for the first two if 3 | k-1",
    .place = "docs/theorems.md, Theorem 34",
};

class CyclicTripleOverlap final : public IntervalFamily {
 public:
  CyclicTripleOverlap() : IntervalFamily(description, 3, false) {}

 protected:
  std::uint64_t base_block_count(const Parameters& p) const override {
    if (!asks_for_pairs(p, 3) || p.kind != Kind::circular) {
      return 0;
    }
    const auto leave = TripleLeave::without_leave(p.k, p.v);
    return leave ? leave->base_blocks() : 0;
  }

  IntervalDevelopedSource::Points points_of(std::uint64_t /*c*/,
                                            const Parameters& p) const override {
    return TripleLeave::without_leave(p.k, p.v)->points();
  }
};

}  // namespace

const Construction& construction() { return only<CyclicTripleOverlap>(); }

}  // namespace changeover::cyclic_triple_overlap_entry
