// All circular single-change designs in which each element has one or two stays, and so no
// circular SCCD(14,5) with 23 blocks [docs/theorems.md, Theorem 29].
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "changeover/core/design.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover::one_or_two_stays_test {
namespace {

constexpr std::size_t most_elements = 16;

template <typename T>
class ByElement {
 public:
  T& operator[](int x) { return all_[static_cast<std::size_t>(x)]; }
  const T& operator[](int x) const { return all_[static_cast<std::size_t>(x)]; }

 private:
  std::array<T, most_elements> all_{};
};

/// Looks through the lists block by block: who leaves, and who comes.
///
/// Element 0 has one stay, the blocks 0, …, v−k−1. A *meeting* of two elements is a run of blocks
/// with both; one begins for each of the k−1 elements beside the one that comes. b blocks have
/// `spare` of them more than there are pairs. An element that comes with a stay of L blocks has
/// L + k − 2 meetings. So it is in at least v − 1 − (k−2) blocks if it has one stay, in at least
/// v − 1 − 2(k−2) if it has two, and in at most `spare` more.
class Lists {
 public:
  Lists(int v, int k, int b)
      : v_(v),
        k_(k),
        b_(b),
        spare_((k - 1) * b - v * (v - 1) / 2),
        one_(v - k + 1),
        two_(v - 2 * k + 3),
        with_two_(b - v) {}

  /// The first design found.
  std::optional<Design> first() {
    for (int x = 0; x < k_; ++x) {
      list_[0][static_cast<std::size_t>(x)] = x;
      of_[x] = {.stays = 1, .blocks = 1, .is_in = true, .spans_the_cut = x > 0};
      if (x > 0) {
        meet(0, x);
      }
    }
    seen_ = k_;
    length_ = 1;
    go_on();
    return found_;
  }

 private:
  struct Presence {
    int stays = 0;   // that began in block 0 or later, or were there
    int blocks = 0;  // so far
    bool is_in = false;
    bool spans_the_cut = false;  // its stay in block 0 began before
    bool has_left = false;
  };

  void meet(int x, int y) {
    met_[x] |= std::uint32_t{1} << y;
    met_[y] |= std::uint32_t{1} << x;
  }

  [[nodiscard]] int unmet(int x) const { return v_ - 1 - std::popcount(met_[x]); }

  /// Not in now, and does not come again: one stay, as it was long, or the second of two.
  [[nodiscard]] bool is_gone(int x) const {
    const Presence& of = of_[x];
    return !of.is_in && !of.spans_the_cut && (of.stays == 2 || of.blocks >= one_);
  }

  using Elements = std::array<int, 6>;

  [[nodiscard]] const Elements& last() const {
    return list_[static_cast<std::size_t>(length_ - 1)];
  }

  [[nodiscard]] std::span<const int> in_last() const {
    return std::span(last()).first(static_cast<std::size_t>(k_));
  }

  void go_on() {
    const int next = length_;
    if (next == b_) {
      close();
    } else if (can_end(b_ - next)) {
      for (std::size_t place = 0; place < static_cast<std::size_t>(k_) && !found_; ++place) {
        if (may_leave(last()[place], next)) {
          leave(place);
        }
      }
    }
  }

  /// The last block has all that stay across the cut, and one more.
  void close() {
    for (int x = 0; x < v_; ++x) {
      const bool there = x == 0 ? !of_[x].is_in : !of_[x].spans_the_cut || of_[x].is_in;
      if (!there || x >= seen_ || unmet(x) > 0) {
        return;
      }
    }
    Design design({.v = static_cast<std::uint64_t>(v_),
                   .k = static_cast<std::uint64_t>(k_),
                   .change = 1,
                   .kind = Kind::circular});
    for (int i = 0; i < b_; ++i) {
      const Elements& block = list_[static_cast<std::size_t>(i)];
      Block elements(block.begin(), block.begin() + k_);
      std::ranges::sort(elements);
      design.append(elements);
    }
    found_ = std::move(design);
  }

  /// Whether so many steps can be enough for who must come and meet.
  [[nodiscard]] bool can_end(int steps) const {
    int to_come = v_ - seen_;
    int unmet_pairs = to_come * (v_ - 1);
    for (int x = 0; x < seen_; ++x) {
      const Presence& of = of_[x];
      unmet_pairs += unmet(x);
      if (is_gone(x) && unmet(x) > 0) {
        return false;
      }
      to_come += x > 0 && !of.is_in && (of.spans_the_cut || !is_gone(x)) ? 1 : 0;
      if (x > 0 && !of.spans_the_cut && !is_gone(x) && unmet(x) > most_meetings(of, steps)) {
        return false;
      }
    }
    return to_come <= steps && unmet_pairs <= 2 * (k_ - 1) * steps;
  }

  [[nodiscard]] int most_meetings(const Presence& of, int steps) const {
    const int again = two_ + spare_ - of.blocks + k_ - 2;  // with a second stay
    if (!of.is_in) {
      return std::min(again, steps + k_ - 2);
    }
    const int in_this_stay = (of.stays == 2 ? two_ : one_) + spare_ - of.blocks;
    return of.stays == 2 ? std::min(in_this_stay, steps)
                         : std::min(std::max(in_this_stay, of.blocks < two_ + spare_ ? again : 0),
                                    steps + k_ - 2);
  }

  [[nodiscard]] bool may_leave(int x, int next) const {
    const Presence& of = of_[x];
    if (of_[0].is_in && (next == one_) != (x == 0)) {
      return false;  // Element 0 leaves after its one_ blocks.
    }
    if (of.spans_the_cut) {  // They leave for the first time in the order of their names.
      return of.has_left || x == 1 || of_[x - 1].has_left;
    }
    return of.stays == 2 ? of.blocks >= two_ : of.blocks >= one_ || of.blocks < two_ + spare_;
  }

  void leave(std::size_t place) {
    const int x = last()[place];
    std::uint32_t others = 0;
    for (const int y : in_last()) {
      others |= y == x ? 0 : std::uint32_t{1} << y;
    }
    const Presence before = of_[x];
    of_[x].is_in = false;
    of_[x].has_left = true;
    for (int y = 1; y <= std::min(seen_, v_ - 1) && !found_; ++y) {
      if (y != x && may_come(y, others)) {
        come(y, place, others);
      }
    }
    of_[x] = before;
  }

  [[nodiscard]] bool may_come(int y, std::uint32_t others) const {
    const Presence& of = of_[y];
    if (of.is_in || again_ + std::popcount(met_[y] & others) > spare_) {
      return false;
    }
    if (y == seen_) {
      return true;
    }
    if (of.spans_the_cut) {
      return of.stays < 3;
    }
    return of.stays < 2 && of.blocks < one_ && twice_ < with_two_;
  }

  void come(int y, std::size_t place, std::uint32_t others) {
    const auto met = met_;
    const auto of = of_;
    const int seen = seen_;
    const int again = again_;
    const int twice = twice_;
    again_ += std::popcount(met_[y] & others);
    twice_ += y < seen_ && !of_[y].spans_the_cut ? 1 : 0;
    seen_ = std::max(seen_, y + 1);
    list_[static_cast<std::size_t>(length_)] = last();
    list_[static_cast<std::size_t>(length_)][place] = y;
    ++length_;
    of_[y].is_in = true;
    ++of_[y].stays;
    bool fits = true;
    for (const int x : in_last()) {
      if (x != y) {
        meet(x, y);
      }
      const Presence& now = of_[x];
      ++of_[x].blocks;
      const int with_two = now.spans_the_cut ? 3 : 2;
      fits = fits && now.blocks <= (now.stays == with_two ? two_ : one_) + spare_;
    }
    if (fits) {
      go_on();
    }
    --length_;
    met_ = met;
    of_ = of;
    seen_ = seen;
    again_ = again;
    twice_ = twice;
  }

  int v_, k_, b_;
  int spare_;     // meetings more than pairs
  int one_;       // blocks of an element with one stay, at least
  int two_;       // of one with two
  int with_two_;  // how many these are
  ByElement<Presence> of_;
  ByElement<std::uint32_t> met_;
  std::array<Elements, 32> list_{};
  int length_ = 0;
  int seen_ = 0;   // elements that have been in a block: 0, …, seen_−1
  int again_ = 0;  // meetings of pairs that had met
  int twice_ = 0;  // elements that have come twice and are in no stay across the cut
  std::optional<Design> found_;
};

// Where there are such designs, the search finds one.
TEST(OneOrTwoStays, FindsDesigns) {
  for (const auto& [v, k, b] : {std::array{7, 4, 7},
                                {9, 4, 12},
                                {9, 5, 9},
                                {10, 5, 12},
                                {11, 5, 14},
                                {12, 5, 17},
                                {13, 5, 20}}) {
    const auto design = Lists(v, k, b).first();
    ASSERT_TRUE(design) << v << ' ' << k;
    EXPECT_TRUE(verify(*design).valid());
    EXPECT_EQ(design->block_count(), static_cast<std::uint64_t>(b));
  }
}

TEST(OneOrTwoStaysSlow, NoneHasFourteenElementsInBlocksOfFive) {
  EXPECT_FALSE(Lists(14, 5, 23).first());
}

}  // namespace
}  // namespace changeover::one_or_two_stays_test
