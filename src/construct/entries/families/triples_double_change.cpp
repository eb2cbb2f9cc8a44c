// The minimum DCCD(v,3): a minimum covering of the pairs by triples, ordered so that consecutive
// triples share exactly one element. Circular for every v ≥ 5.
//
// Elements: (x,i) = x + ni for x ∈ Z_n and a level i ∈ Z_3, and up to three more. On Z_n let x∘y be
// (x+y)/2 if n is odd; if n = 2t, with x+y = 2z or 2z+1, 0 ≤ z < t, let it be z or z+t. The *mean*
// triples {(x,i),(y,i),(x∘y,i+1)}, x < y, cover the pairs within levels and, of the pairs of (x,i)
// and (z,i+1), all but z = x∘x. *Special* triples cover what is left:
//   v = 3n, n odd (Bose)      {(x,0),(x,1),(x,2)}.
//   v = 3n+1, n even (Skolem) the same for x < t, and {∞,(x+t,i),(x,i+1)} for x < t.
//   v = 3n, n even            {(x+t,i),(x,i+1),(x,i+2)} for x < t. Covers {(x+t,i),(x,i+2)} once
//                             more: every element has excess 1, as it must (v − 1 is odd).
//   v = 3n+2, n odd           here −(x∘y) replaces x∘y from level 2 to level 0, so that left are
//                             hexagons (±x,0),(±x,1),(±x,2) for x ≠ 0, whose edges alternately make
//                             triples with ∞ and ∞′. On {∞,∞′,(0,0),(0,1),(0,2)}: {∞,∞′,(0,i)} and
//                             {(0,0),(0,1),(0,2)}; of excess 2, the least here.
//   v − 1 ≡ 1, 3 (mod 6)      the triples for v − 1, and {ω,p,q} for v/2 pairs {p,q} that cover the
//                             other elements, one of them twice. Excess v/2 + 1, the least.
//
// Order. Let the numbers 0, …, 3n−1 be points on a circle. The mean triple through points p and p+1
// is the *link* from p to p+1; those at the ends of levels are {(n−1,i),(1,i),(0,i+1)}. For
// n ≥ 4 no triple is two links. The triples that have a point p (and are no links) come between the
// links at p, each triple at one of its points: (x,i) for a mean triple, x < y. What comes
// consecutively shares p, and a second element only if a pair is covered twice:
//   - {(x+t,i),(x,i+2)} is in a link within level i+2 and in the special triple; this comes at
//     (x,i+1), which is not in the link.
//   - {∞,∞′} is in three triples, which come at different points, so links are between them.
// The triples with ω come last, consecutive ones disjoint but for ω; the first holds 3n−1 of the
// link before it and the last holds 0 of the first triple.
//
// For v ≤ 11 the lists are written out; DCCD(5,3) needs 5 blocks, one more than a covering. That
// the coverings are minimum is a theorem of Fort and Hedlund (1958).
#include <fmt/format.h>

#include <array>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"
#include "construct/tools/short_blocks.hpp"
#include "core/checked.hpp"

namespace changeover::triples_double_change_entry {
namespace {

constexpr std::uint64_t largest_listed = 11;

// By v, from v = 5.
constexpr std::array<std::string_view, 7> lists{
    "012 034 123 014 234",
    "012 034 015 235 134 245",
    "013 124 235 346 045 156 026",
    "013 067 237 017 457 124 235 346 045 156 026",
    "036 015 024 123 147 348 357 456 258 267 168 078",
    "036 019 123 267 239 679 089 168 456 147 015 024 078 258 348 459 357",
    "015 09a 024 078 036 123 348 357 39a 149 456 167 47a 279 268 25a 589 69a 18a",
};

// ⌈v/3·⌈(v−1)/2⌉⌉ for v ≥ 6.
std::uint64_t block_count_for(std::uint64_t v) { return v == 5 ? 5 : ceil_div(v * (v / 2), 3); }

// v ≥ 12, so that n ≥ 4.
class TriplesSource final : public BlockByBlock<TriplesSource> {
 public:
  explicit TriplesSource(const Parameters& parameters)
      : parameters_(parameters),
        v_(parameters.v),
        has_omega_(v_ % 6 == 2 || v_ % 6 == 4),
        n_((v_ - (has_omega_ ? 1 : 0)) / 3),
        further_((v_ - (has_omega_ ? 1 : 0)) % 3),
        t_(n_ / 2) {
    start_level();
  }

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return block_count_for(v_);
  }

  bool make(std::span<Element> block) {
    if (level_ < 3) {
      next_at_point(block);
      return true;
    }
    if (!has_omega_ || omega_ == v_ / 2) {
      return false;
    }
    next_with_omega(block);
    return true;
  }

  bool rewind() override {
    level_ = 0;
    omega_ = 0;
    start_level();
    return true;
  }

 private:
  void start_level() {
    x_ = 0;
    start_point();
  }
  void start_point() {
    y_ = x_ + 2;
    special_ = 0;
  }

  // The element (x,i), x modulo n, i modulo 3.
  [[nodiscard]] Element point(std::uint64_t x, std::uint64_t i) const {
    return static_cast<Element>(x % n_ + n_ * (i % 3));
  }

  // x∘y, or −(x∘y) where that replaces it above level i.
  [[nodiscard]] std::uint64_t mean(std::uint64_t x, std::uint64_t y, std::uint64_t i) const {
    const std::uint64_t sum = (x + y) % n_;
    if (n_ % 2 == 0) {
      return sum / 2 + (sum % 2 == 0 ? 0 : t_);
    }
    const std::uint64_t half = sum % 2 == 0 ? sum / 2 : (sum + n_) / 2;
    return further_ == 2 && i == 2 ? n_ - half : half;
  }

  static void write(std::span<Element> block, Element a, Element b, Element c) {
    block[0] = a;
    block[1] = b;
    block[2] = c;
  }

  // Mean triples with y = x+2, x+3, …, then special ones, then the link.
  void next_at_point(std::span<Element> block) {
    if (x_ == 1 && y_ == n_ - 1) {
      ++y_;  // the link from (n−1,i) to (0,i+1)
    }
    if (y_ < n_) {
      write(block, point(x_, level_), point(y_, level_), point(mean(x_, y_, level_), level_ + 1));
      ++y_;
      return;
    }
    if (next_special(block)) {
      ++special_;
      return;
    }
    const bool last = x_ + 1 == n_;
    const std::uint64_t other = last ? 1 : x_ + 1;
    write(block, point(x_, level_), point(other, level_),
          point(mean(x_, other, level_), level_ + 1));
    ++x_;
    if (last) {
      ++level_;
      x_ = 0;
    }
    start_point();
  }

  // The special triple number special_ at (x,i), if there is one.
  bool next_special(std::span<Element> block) const {
    const std::uint64_t x = x_;
    const std::uint64_t i = level_;
    const auto infinity = static_cast<Element>(3 * n_);
    const auto vertical = [&] { write(block, point(x, 0), point(x, 1), point(x, 2)); };
    if (n_ % 2 == 0) {
      if (x >= t_) {
        return false;
      }
      if (special_ == 0) {  // that of (x+t, i−1), above which (x,i) is
        write(block, point(x, i), point(x + t_, i + 2), further_ == 1 ? infinity : point(x, i + 1));
        return true;
      }
      if (special_ == 1 && further_ == 1 && i == 0) {
        vertical();
        return true;
      }
      return false;
    }
    if (further_ == 2 && x != 0) {
      // Edge i of (x,0),(x,1),(x,2),(−x,0), of the hexagon of x and −x.
      if (special_ > 0) {
        return false;
      }
      const bool second_half = x > t_;
      const Element other = i == 2 ? point(n_ - x, 0) : point(x, i + 1);
      write(block, point(x, i), other, infinity + ((i % 2 == 0) == second_half ? 1U : 0U));
      return true;
    }
    if (special_ == 0 && i == 0) {
      vertical();
      return true;
    }
    if (further_ == 2 && special_ == (i == 0 ? 1U : 0U)) {
      write(block, point(0, i), infinity, infinity + 1);
      return true;
    }
    return false;
  }

  // The pairs beside ω: {3n−1,3n−2}, {3n−3,3n−4}, …, then what is left over with 3n−1, then {1,0}.
  void next_with_omega(std::span<Element> block) {
    const std::uint64_t top = 3 * n_ - 1;
    const std::uint64_t left_over = further_ == 1 ? 3 * n_ : 2;
    std::uint64_t a = top - 2 * omega_;
    std::uint64_t b = a - 1;
    if (omega_ + 2 == v_ / 2) {
      a = left_over;
      b = top;
    } else if (omega_ + 1 == v_ / 2) {
      a = 1;
      b = 0;
    }
    write(block, static_cast<Element>(a), static_cast<Element>(b), static_cast<Element>(v_ - 1));
    ++omega_;
  }

  Parameters parameters_;
  std::uint64_t v_;
  bool has_omega_;
  std::uint64_t n_;
  std::uint64_t further_;  // elements besides points and ω
  std::uint64_t t_;
  std::uint64_t level_ = 0;
  std::uint64_t x_ = 0;
  std::uint64_t y_ = 0;
  std::uint64_t special_ = 0;
  std::uint64_t omega_ = 0;  // triples with ω so far
};

constexpr Description description{
    .name = "triples-double-change",
    .summary = "a minimum covering by triples, ordered so that consecutive ones share one element",
    .preconditions = "m = 2, k = 3, v >= 5",
    .guarantee =
        "a minimum DCCD(v,3), circular too; tight if v = 1, 3 mod 6 (Steiner triple systems)",
    .cited = "GangodaGamachchige2014",
    .place = "minimum for v = 0, 1, 3, 5 mod 6; for the other v by us",
};

class TriplesDoubleChange final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    if (!asks_for_pairs(p, 2) || p.k != 3 || p.v < 5) {
      return std::nullopt;
    }
    const std::uint64_t b = block_count_for(p.v);
    const bool tight = p.v % 6 == 1 || p.v % 6 == 3;
    return Promise{b, tight, b == ceil_div(p.v * (p.v - 1) / 2, 3)};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    if (p.v <= largest_listed) {
      return std::make_unique<BlockListSource>(
          p, short_blocks(lists[static_cast<std::size_t>(p.v - 5)]));
    }
    return std::make_unique<TriplesSource>(p);
  }

  std::string explanation(const Parameters& p) const override {
    if (p.v <= largest_listed) {
      return fmt::format("A list of {} triples.", block_count_for(p.v));
    }
    const bool omega = p.v % 6 == 2 || p.v % 6 == 4;
    const std::uint64_t v = omega ? p.v - 1 : p.v;
    std::string how;
    switch (v % 6) {
      case 0:
        how = fmt::format("Take the minimum covering of excess {} on Z_{} x Z_3", v / 2, v / 3);
        break;
      case 1:
        how = fmt::format("Take Skolem's Steiner triple system on Z_{} x Z_3 and one more", v / 3);
        break;
      case 3:
        how = fmt::format("Take Bose's Steiner triple system on Z_{} x Z_3", v / 3);
        break;
      default:
        how =
            fmt::format("Take the minimum covering of excess 2 on Z_{} x Z_3 and two more", v / 3);
    }
    how += ", go round Z_n x Z_3 level by level, and list at each point triples that contain it.";
    if (omega) {
      how += fmt::format(" Then add {} with {} pairs of the other elements.", v, p.v / 2);
    }
    return how;
  }
};

}  // namespace

const Construction& construction() { return only<TriplesDoubleChange>(); }

}  // namespace changeover::triples_double_change_entry
