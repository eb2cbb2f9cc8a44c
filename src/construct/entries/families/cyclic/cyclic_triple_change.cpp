// Tight circular 3-change designs (6c(k−2)+1, k) with c base blocks {0, …, k−4} ∪ {three points}.
//
// With n = k−3, N = n+1, v = 6cN+1 and A = {0, …, n−1} put x_p = pN+n. The differences x_p − a, a
// in A, are pN+1, …, pN+n, up to sign those of p and of −p−1 alike; two points differ in (p−q)N. So
// c triples of integers do for every k if of each two numbers p, −p−1 with 0 ≤ p < 3c one is used,
// once, and the differences inside the triples are 1, …, 3c, once each. The base block with x_0 = n
// comes last: it holds A+1. Proof: docs/theorems.md, Theorem 4.
//
// Each triple has two differences that add up to the third, so 1 + … + 3c is even: c ≡ 0 or 1
// modulo 4. For c ≡ 2 or 3 the last triple is {−r, 0, 3c−1}, and its largest point moves up by one,
// to 3cN. Its differences are then (3c−1)N+2, …, 3cN with A, (3c−1)N+1 with x_0 and (3c+1−r)N with
// x_{−r}; so r, 3c+1−r and the differences inside the other triples are 1, …, 3c−1. The triples
// below were found by exact cover; for c = 2 there are none.
#include <algorithm>
#include <span>

#include "construct/entries/families/cyclic/interval_family.hpp"

namespace changeover::cyclic_triple_change_entry {
namespace {

struct Triples {
  std::uint64_t c = 0;
  std::vector<int> points;  ///< three of each triple, the one with 0 last
};

const std::vector<Triples>& tables() {
  static const std::vector<Triples> all{
      {1, {-3, -2, 0}},
      {3, {2, 4, 7, -2, 5, 6, -4, 0, 8}},
      {4, {-2, 2, 10, -8, -7, 3, -12, -10, -5, -9, -6, 0}},
      {5, {-7, -6, 8, -4, 1, 9, -15, -13, -3, -14, -11, -5, 0, 7, 11}},
      {6, {-13, -3, 3, -17, -14, -5, 7, 9, 14, -16, -12, 1, -7, -6, 8, -11, 0, 17}},
      {7, {-12, -9, 5, -20, -18, -10, -19, -14, -3, 3, 12, 16, -11, 1, 7, -16, -15, 4, -7, 0, 20}},
      {8, {-15, -11, 9,  -19, -9,  4,  -20, -18, 1,   -12, -6, 6,
           -4,  -3,  13, -22, -17, -8, -24, -21, -13, 0,   15, 22}},
      {9, {-10, -3,  17,  -24, -21, 1,  -17, -16, 7,   -7,  -5, 14, 3, 11,
           21,  -23, -19, -6,  8,   13, 24,  -26, -20, -11, 0,  12, 26}},
      {10, {-6,  11,  22, -29, -24, -4, -28, -22, -19, -2,  24, 25, -21, -11, 2,
            -18, -16, 6,  -5,  9,   13, -27, -20, -8,  -13, 8,  16, -15, 0,   29}},
      {11, {-28, -12, -11, -32, -23, -8,  -2, 8,   29,  -14, 15,  18,  -24, -22, 6, 12, 26,
            30,  -5,  14,  20,  -25, -20, 2,  -17, -10, 3,   -29, -18, -6,  -26, 0, 32}},
      {12, {-16, -15, 19, -32, -30, 1, -29, -22, 3,  -5, 9,  25, -18, -7, 11, 2,   10, 30,
            -35, -25, -8, -21, -17, 5, -33, -28, -9, 12, 18, 33, 23,  26, 35, -23, 0,  13}},
      {13,
       {-38, -28, 1,   -31, -27, 6,   -15, -13, 21, -3, 13, 32, -24, -23, 8,  5,  10, 35, -25, -19,
        3,   -37, -30, -10, -34, -26, -8,  4,   15, 28, 11, 20, 34,  16,  19, 31, 0,  17, 38}},
      {14, {-8,  8,   30,  4,  19,  40,  11,  35,  39,  -23, -22, 18,  -39, -28,
            -14, -21, -4,  16, -35, -33, -27, -16, -6,  23,  -2,  28,  31,  -38,
            -25, -7,  -10, 2,  25,  -15, 12,  17,  -37, -30, -11, -34, 0,   41}},
      {15, {-44, -33, -17, -15, 25,  28, -23, 9,   21,  -30, -25, 12,  -3,  23,  38,
            7,   17,  42,  -38, -4,  -2, -42, -28, -9,  -37, -31, -14, -34, -16, 4,
            11,  35,  39,  -21, -20, 10, -41, -32, -19, 5,   26,  34,  -7,  0,   44}},
      {16, {-32, -27, 16, -25, -13, 22,  -36, -30, 10,  -26, -7,  19,  -6,  11, 38,  -44,
            -24, -2,  7,  9,   46,  -41, -31, -3,  3,   18,  39,  8,   17,  42, -48, -45,
            -16, 14,  27, 45,  -35, -21, -5,  -38, -37, -14, -33, -29, -22, 0,  33,  41}},
      {17, {-19, 1,   32,  -10, 14, 40, -45, -28, 4,   -29, -11, 19, -39, -27, 8,   -40, -31,
            6,   -34, -32, 11,  5,  13, 47,  7,   12,  48,  -3,  16, 37,  -43, -42, -4,  17,
            23,  50,  20,  34,  49, 21, 24,  46,  -46, -36, -23, 25, 29,  36,  -44, -16, 0}},
      {18, {4,   38, 42, -17, -7,  35,  -19, 22, 34, -47, -45, 3,  -29, -12, 20, 7,   37, 50,
            -14, 26, 32, -52, -44, -15, 21,  47, 52, -40, -18, 5,  -11, 33,  40, 24,  25, 49,
            29,  45, 48, 9,   27,  36,  2,   30, 41, -32, 1,   15, -13, 8,   23, -20, 0,  53}},
      {19,
       {-47, -27, -11, -6, 36, 49,  -13, 4,  43, -21, 23,  32,  -51, -18, 3,   -12, 18,  40, -49,
        -22, 1,   -20, 27, 31, -56, -31, -7, -8, 33,  38,  -40, -26, 8,   -25, -23, 15,  16, 44,
        51,  13,  42,  45, 29, 37,  47,  41, 52, 53,  -35, -29, 2,   -55, -36, -10, -15, 0,  56}},
  };
  return all;
}

/// nullptr if there is no table for c.
const Triples* triples_for(std::uint64_t c) {
  const auto found = std::ranges::find(tables(), c, &Triples::c);
  return found == tables().end() ? nullptr : &*found;
}

// x_p modulo v, and 3cN for p = 3c−1 if c ≡ 2 or 3 (mod 4).
Element point(std::uint64_t v, std::uint64_t k, std::uint64_t c, int p) {
  const auto n = static_cast<std::int64_t>(k - 3);
  const bool moved = c % 4 >= 2 && p == 3 * static_cast<std::int64_t>(c) - 1;
  const std::int64_t x = p * (n + 1) + n + (moved ? 1 : 0);
  return static_cast<Element>(x < 0 ? x + static_cast<std::int64_t>(v) : x);
}

constexpr Description description{
    .name = "cyclic-triple-change",
    .summary = "c base blocks {0,...,k-4,x,y,z} over Z_v from c triples of integers, developed",
    .preconditions = "circular, m = 3, k >= 4, v = 6c(k-2)+1 with c = 1 or 3 <= c <= 19",
    .guarantee = "a tight circular 3-change design with cv blocks",
    .place = "docs/theorems.md, Theorem 4",
};

class CyclicTripleChange final : public IntervalFamily {
 public:
  CyclicTripleChange() : IntervalFamily(description, 3) {}

 protected:
  std::uint64_t base_block_count(const Parameters& p) const override {
    if (!asks_for_pairs(p, 3) || p.kind != Kind::circular || p.k < 4 ||
        (p.v - 1) % (6 * (p.k - 2)) != 0) {
      return 0;
    }
    const std::uint64_t c = (p.v - 1) / (6 * (p.k - 2));
    return triples_for(c) == nullptr ? 0 : c;
  }

  IntervalDevelopedSource::Points points_of(std::uint64_t c, const Parameters& p) const override {
    return [triples = triples_for(c), v = p.v, k = p.k, c](std::uint64_t which,
                                                           std::span<Element> points) {
      const std::span triple(triples->points.begin() + 3 * static_cast<std::ptrdiff_t>(which), 3);
      std::ranges::transform(triple, points.begin(),
                             [&](int place) { return point(v, k, c, place); });
      std::ranges::sort(points);
    };
  }
};

}  // namespace

const Construction& construction() { return only<CyclicTripleChange>(); }

}  // namespace changeover::cyclic_triple_change_entry
