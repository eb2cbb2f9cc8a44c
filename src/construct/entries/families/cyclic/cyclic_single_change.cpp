// The tight circular SCCD(2c(k−1)+1, k, 2c²(k−1)+c): {0, …, k−2} with one multiple of k−1,
// developed.
//
// Base block A ∪ {(p+1)(k−1)}, A = {0, …, k−2}, newly covers the differences p(k−1)+1, …,
// (p+1)(k−1), so the c of them cover 1, …, c(k−1) = (v−1)/2, each once. The base block that
// contains k−1 comes last: it holds A+1 = {1, …, k−1}, which is what it shares with the next
// translate of the first.
#include "construct/entries/families/cyclic/interval_family.hpp"

namespace changeover::cyclic_single_change_entry {
namespace {

constexpr Description description{
    .name = "cyclic-single-change",
    .summary = "c base blocks {0,...,k-2,j(k-1)} over Z_v, 1 <= j <= c, developed",
    .preconditions = "circular, m = 1, k >= 2, v = 2c(k-1)+1 with c >= 1",
    .guarantee =
        "a tight circular SCCD(2c(k-1)+1,k,cv), with an expansion set if k = 2 and v <= 2^20",
    .cited = "ChafeeStevens2023",
};

class CyclicSingleChange final : public IntervalFamily {
 public:
  CyclicSingleChange() : IntervalFamily(description, 1) {}

 protected:
  // v ≡ 1 modulo k−1, so k = 2 is all that has an expansion set.
  std::uint64_t base_block_count(const Parameters& p) const override {
    if (!asks_for_pairs(p, 1) || p.kind != Kind::circular || (p.v - 1) % (2 * (p.k - 1)) != 0) {
      return 0;
    }
    return (p.v - 1) / (2 * (p.k - 1));
  }

  IntervalDevelopedSource::Points points_of(std::uint64_t c, const Parameters& p) const override {
    return [c, k = p.k](std::uint64_t which, std::span<Element> points) {
      points.front() = single_change_point(c, k, which);
    };
  }
};

}  // namespace

const Construction& construction() { return only<CyclicSingleChange>(); }

}  // namespace changeover::cyclic_single_change_entry
