// All circular single-change designs in which each element has one or two stays, and so no
// circular SCCD(14,5) with 23 blocks [docs/theorems.md, Theorem 29].
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover::one_or_two_stays_test {
namespace {

using Places = std::uint32_t;  // blocks, or steps: bit i is block i, and the step to it

/// Where an element is: its stays, and the steps at which it comes and leaves.
struct Placed {
  Places in = 0;
  Places comes = 0;
  Places leaves = 0;
  int again = 0;  // its meetings more than other elements
};

/// Places the elements with one stay, then those with two, so that one comes and one leaves at each
/// step.
///
/// A *meeting* of two elements is a run of blocks with both; one begins for each of the k−1
/// elements beside the one that comes. b blocks have `spare` of them more than there are pairs. An
/// element with a stay of L blocks has L + k − 2 meetings in it. So it is in v − 1 − (k−2) blocks
/// if it has one stay, in v − 1 − 2(k−2) if it has two, and in one more for each of its meetings
/// that is not the first of that pair.
class Stays {
 public:
  Stays(int v, int k, int b)
      : v_(v),
        k_(k),
        b_(b),
        spare_((k - 1) * b - v * (v - 1) / 2),
        with_one_(2 * v - b),
        all_((Places{1} << b) - 1) {}

  std::optional<Design> first() {
    find_pairs_of_stays();
    place_single(0, spare_);
    return found_;
  }

 private:
  /// A pair of stays that is left, and how often it meets again who is placed.
  struct Candidate {
    std::size_t number;
    int again;
  };

  [[nodiscard]] Places turned(Places places, int by) const {
    return by == 0 ? places : (places << by | places >> (b_ - by)) & all_;
  }
  [[nodiscard]] Places stay(int from, int length) const {
    return turned((Places{1} << length) - 1, from);
  }
  [[nodiscard]] Places step(int to) const { return Places{1} << (to % b_); }
  /// Runs of blocks around the circle.
  [[nodiscard]] int runs(Places places) const {
    return std::popcount(places & ~turned(places, 1) & all_);
  }
  /// Meetings of two elements beyond the first; nothing if they do not meet or cannot both be.
  [[nodiscard]] std::optional<int> again(const Placed& x, const Placed& y) const {
    const int meetings = runs(x.in & y.in);
    if (meetings == 0 || (x.comes & y.comes) != 0 || (x.leaves & y.leaves) != 0) {
      return std::nullopt;
    }
    return meetings - 1;
  }

  /// The same with all that are placed.
  [[nodiscard]] std::optional<int> again_with_all(const Placed& x) const {
    int sum = 0;
    for (const Placed& y : placed_) {
      const auto times = again(x, y);
      if (!times) {
        return std::nullopt;
      }
      sum += *times;
    }
    return sum;
  }

  void find_pairs_of_stays() {
    for (int more = 0; more <= spare_; ++more) {
      const int blocks = v_ - 2 * k_ + 3 + more;
      for (int one = 1; one < blocks; ++one) {
        for (int from = 0; from < b_; ++from) {
          for (int to = 0; to < from; ++to) {
            const Places first = stay(from, one);
            const Places second = stay(to, blocks - one);
            if ((first & second) == 0 && runs(first | second) == 2) {
              pairs_.push_back({first | second, step(from) | step(to),
                                step(from + one) | step(to + blocks - one), more});
            }
          }
        }
      }
    }
    for (const Placed& x : pairs_) {
      std::vector<std::optional<int>>& row = again_.emplace_back();
      for (const Placed& y : pairs_) {
        row.push_back(again(x, y));
      }
    }
  }

  void place_single(int from, int left) {
    if (static_cast<int>(placed_.size()) == with_one_) {
      if (has_longest_gap_at_the_end()) {
        place_pairs(left);
      }
      return;
    }
    for (int more = 0; more <= spare_; ++more) {
      const int length = v_ - k_ + 1 + more;
      for (int begin = from; begin < b_ && length < b_ && !found_; ++begin) {
        if (placed_.empty() && begin > 0) {
          break;  // Turned, one of them comes at step 0.
        }
        const Placed x{stay(begin, length), step(begin), step(begin + length), more};
        if (const auto times = again_with_all(x); times && *times <= left) {
          placed_.push_back(x);
          place_single(begin + 1, left - *times);
          placed_.pop_back();
        }
      }
    }
  }

  /// One of the ways to turn them has no longer gap than that between the last that comes and b.
  [[nodiscard]] bool has_longest_gap_at_the_end() const {
    int longest = 0;
    int before = 0;
    for (const Placed& x : placed_) {
      const int comes = std::countr_zero(x.comes);
      longest = std::max(longest, comes - before);
      before = comes;
    }
    return b_ - before >= longest;
  }

  void place_pairs(int left) {
    Places comes = 0;
    Places leaves = 0;
    for (const Placed& x : placed_) {
      comes |= x.comes;
      leaves |= x.leaves;
    }
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (const auto times = again_with_all(pairs_[i]); times && *times <= left) {
        candidates.push_back({i, *times});
      }
    }
    go_on(comes, leaves, left, candidates);
  }

  /// Goes on at the step at which the fewest candidates come or leave.
  void go_on(Places comes, Places leaves, int left, const std::vector<Candidate>& candidates) {
    if (static_cast<int>(placed_.size()) == v_) {
      if (comes == all_ && leaves == all_ && left == 0) {
        found_ = design();
      }
      return;
    }
    std::array<std::array<std::size_t, 32>, 2> count{};
    for (const Candidate& x : candidates) {
      for (int i = 0; i < b_; ++i) {
        const auto at = static_cast<std::size_t>(i);
        count[0][at] += pairs_[x.number].comes >> i & 1;
        count[1][at] += pairs_[x.number].leaves >> i & 1;
      }
    }
    std::size_t fewest = candidates.size() + 1;
    bool is_leaving = false;
    Places wanted = 0;
    for (int i = 0; i < b_; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if ((comes >> i & 1) == 0 && count[0][at] < fewest) {
        fewest = count[0][at];
        is_leaving = false;
        wanted = Places{1} << i;
      }
      if ((leaves >> i & 1) == 0 && count[1][at] < fewest) {
        fewest = count[1][at];
        is_leaving = true;
        wanted = Places{1} << i;
      }
    }
    for (const Candidate& x : candidates) {
      const Placed& element = pairs_[x.number];
      if (((is_leaving ? element.leaves : element.comes) & wanted) == 0 || found_) {
        continue;
      }
      const int after = left - x.again;
      std::vector<Candidate> others;
      for (const Candidate& y : candidates) {
        const auto times = again_[x.number][y.number];
        if (times && y.again + *times <= after) {
          others.push_back({y.number, y.again + *times});
        }
      }
      placed_.push_back(element);
      go_on(comes | element.comes, leaves | element.leaves, after, others);
      placed_.pop_back();
    }
  }

  [[nodiscard]] Design design() const {
    Design design({.v = static_cast<std::uint64_t>(v_),
                   .k = static_cast<std::uint64_t>(k_),
                   .change = 1,
                   .kind = Kind::circular});
    for (int i = 0; i < b_; ++i) {
      Block block;
      for (std::size_t x = 0; x < placed_.size(); ++x) {
        if ((placed_[x].in >> i & 1) != 0) {
          block.push_back(static_cast<Element>(x));
        }
      }
      design.append(block);
    }
    return design;
  }

  int v_, k_, b_;
  int spare_;     // meetings more than pairs
  int with_one_;  // elements with one stay
  Places all_;
  std::vector<Placed> pairs_;
  std::vector<std::vector<std::optional<int>>> again_;  // of two of pairs_
  std::vector<Placed> placed_;
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
    const auto design = Stays(v, k, b).first();
    ASSERT_TRUE(design) << v << ' ' << k;
    EXPECT_TRUE(verify(*design).valid());
    EXPECT_EQ(design->block_count(), static_cast<std::uint64_t>(b));
  }
}

TEST(OneOrTwoStays, NoneHasFourteenElementsInBlocksOfFive) {
  EXPECT_FALSE(Stays(14, 5, 23).first());
}

}  // namespace
}  // namespace changeover::one_or_two_stays_test
