#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "changeover/construct/expansion.hpp"
#include "message_of.hpp"
#include "partial_expansion_designs.hpp"

namespace changeover::unchanged_cover_test {
namespace {

using namespace test;

// The least number of sets that cover 0, …, v−1 but for `slack` elements, by trying everything.
// Candidates with the same `end` ≥ 0 exclude one another.
struct Candidate {
  std::vector<Element> elements;
  int end = -1;
};

bool covers(const std::vector<Candidate>& candidates, std::vector<int>& times, std::set<int>& ends,
            std::size_t left, std::uint64_t slack) {
  const auto hole = std::find(times.begin(), times.end(), 0);
  if (hole == times.end()) {
    return true;
  }
  const auto x = static_cast<Element>(hole - times.begin());
  if (slack > 0) {
    times[x] = 1;
    const bool found = covers(candidates, times, ends, left, slack - 1);
    times[x] = 0;
    if (found) {
      return true;
    }
  }
  for (const Candidate& candidate : candidates) {
    const auto& elements = candidate.elements;
    if (left == 0 || std::find(elements.begin(), elements.end(), x) == elements.end() ||
        (candidate.end >= 0 && ends.count(candidate.end) != 0)) {
      continue;
    }
    for (const Element y : elements) {
      ++times[y];
    }
    ends.insert(candidate.end);
    const bool found = covers(candidates, times, ends, left - 1, slack);
    if (candidate.end >= 0) {
      ends.erase(candidate.end);
    }
    for (const Element y : elements) {
      --times[y];
    }
    if (found) {
      return true;
    }
  }
  return false;
}

std::vector<Candidate> all_candidates(const Design& design) {
  const std::size_t size = static_cast<std::size_t>(design.k() - design.parameters().change);
  std::vector<Candidate> candidates;
  for (const UnchangedSubset& subset : unchanged_subsets(design)) {
    candidates.push_back({subset.elements, -1});
  }
  if (design.parameters().kind == Kind::linear) {
    for (const int end : {0, 1}) {
      const auto block = design.block(end == 0 ? 0 : design.block_count() - 1);
      for (const Subset& subset : subsets_of(Subset(block.begin(), block.end()), size)) {
        candidates.push_back({{subset.begin(), subset.end()}, end});
      }
    }
  }
  return candidates;
}

// The least ℓ ≥ w, or just ℓ for w even, for which ℓ sets leave out no more than may be.
std::optional<std::size_t> least_cover(const Design& design, std::uint64_t w) {
  const auto candidates = all_candidates(design);
  const bool odd = design.parameters().change == 2 && w % 2 != 0;
  for (std::size_t count = odd ? w : 1; count <= design.block_count() + 1; ++count) {
    std::vector<int> times(static_cast<std::size_t>(design.v()), 0);
    std::set<int> ends;
    const std::uint64_t slack = odd ? may_be_left_out(design.parameters(), count, w) : 0;
    if (covers(candidates, times, ends, count, slack)) {
      return count;
    }
  }
  return std::nullopt;
}

TEST(UnchangedCover, IsMinimumOnSmallDesigns) {
  std::size_t seen = 0;
  for (const Design& design : some_designs()) {
    if (design.v() > 12) {
      continue;
    }
    SCOPED_TRACE(title(design, 2));
    const auto cover = find_cover(design, for_w(2));
    const auto least = least_cover(design, 2);
    ASSERT_EQ(cover.has_value(), least.has_value());
    if (cover && !leaves_one_out(*cover, design.v())) {
      ++seen;
      EXPECT_TRUE(cover->minimum);
      EXPECT_EQ(cover->subsets.size(), *least);
    }
  }
  EXPECT_GT(seen, 8U);
}

TEST(UnchangedCover, IsMinimumForOneAndThreeNewElementsToo) {
  for (const Design& design : some_designs()) {
    if (design.v() > 11 || design.parameters().change != 2) {
      continue;
    }
    for (const std::uint64_t w : {1U, 3U}) {
      SCOPED_TRACE(title(design, w));
      const auto cover = fits(design, w) ? find_cover(design, for_w(w)) : std::nullopt;
      if (!cover || cover->subsets.size() < w) {
        continue;  // there is none, or a sweep costs less
      }
      const auto least = least_cover(design, w);
      ASSERT_TRUE(least);
      EXPECT_GE(cover->subsets.size(), *least);
      if (cover->minimum) {
        EXPECT_EQ(cover->subsets.size(), *least);
      }
    }
  }
}

TEST(UnchangedCover, UsesTheEndsOfALinearDesign) {
  // The expansion set of the DCCD(7,3,7) takes both ends, and read as circular it has none.
  EXPECT_EQ(find_cover(built("printed", 7, 3, 2, Kind::linear))->subsets.size(), 7U);
  EXPECT_FALSE(find_cover(built("printed", 7, 3, 2, Kind::circular)));
}

TEST(UnchangedCover, IsGreedyForLargeDesignsAndSaysWhetherItIsMinimum) {
  const Design design = built("cyclic-paper", 51, 4);
  CoverOptions greedy;
  greedy.exact_up_to = 0;
  const auto cover = find_cover(design, greedy);
  ASSERT_TRUE(cover);
  EXPECT_EQ(cover_defect(design, *cover, 2), std::nullopt);
  EXPECT_EQ(cover->minimum, cover->subsets.size() == 26);
  EXPECT_TRUE(verify(expand_by(design, *cover, 2)).valid());
}

TEST(UnchangedCover, IsStillACoverWhenALimitStrikes) {
  for (const Design& design : some_designs()) {
    for (const std::uint64_t nodes : {0U, 1U, 10U}) {
      CoverOptions options;
      options.limits.nodes = nodes;
      if (const auto cover = find_cover(design, options)) {
        EXPECT_EQ(cover_defect(design, *cover, 2), std::nullopt);
      }
    }
  }
}

void expect_defect(const Design& design, const UnchangedCover& cover, std::uint64_t w,
                   const std::string& words) {
  const auto defect = cover_defect(design, cover, w);
  ASSERT_TRUE(defect) << words;
  EXPECT_NE(defect->find(words), std::string::npos) << *defect;
  EXPECT_EQ(defect->find('\n'), std::string::npos);
  EXPECT_REFUSAL((void)expand_by(design, cover, w), BadInput, "not a cover by unchanged subsets: ")
      << words;
  EXPECT_THROW(
      {
        const auto source = expand_by(std::make_unique<DesignSource>(design), cover, w);
        (void)blocks_of(*source);
      },
      BadInput)
      << words;
}

TEST(UnchangedCover, ThatIsSpoiltInOnePlaceIsRefused) {
  const Design design = built("cyclic-paper", 15, 5);
  const UnchangedCover good = *find_cover(design, for_w(4));
  const auto spoilt = [&](const auto& change) {
    UnchangedCover cover = good;
    change(cover);
    return cover;
  };
  expect_defect(design, spoilt([](auto& c) { c.subsets.pop_back(); }), 4,
                "is in no subset of the cover, nor beside every new element");
  expect_defect(design, spoilt([](auto& c) { std::swap(c.subsets[0], c.subsets[1]); }), 4,
                "must increase");
  expect_defect(design, spoilt([](auto& c) { c.subsets[1].position = c.subsets[0].position; }), 4,
                "must increase");
  expect_defect(design, spoilt([](auto& c) { c.subsets[0].elements.pop_back(); }), 4,
                "has 2 elements, not k - m = 3");
  expect_defect(design, spoilt([](auto& c) {
                  std::swap(c.subsets[0].elements[0], c.subsets[0].elements[1]);
                }),
                4, "do not increase");
  expect_defect(design, spoilt([](auto& c) { c.subsets[0].elements.back() = 99; }), 4,
                "the elements of the subset at position 1 do not increase below v = 15");
  expect_defect(design, spoilt([](auto& c) { c.subsets.back().position = 99; }), 4,
                "the design has no position 99");
  expect_defect(design, spoilt([](auto& c) { c.subsets.front().position = 0; }), 4, "position 0");
  expect_defect(design, spoilt([](auto& c) { ++c.subsets.front().position; }), 4,
                "the subset at position 2 is not in the block after it");
  expect_defect(design, spoilt([](auto& c) { c.sweep = 5; }), 4, "the sweep is at subset 6 of 5");
  expect_defect(design, spoilt([](auto& c) { c.beside.resize(2); }), 4,
                "5 subsets but 2 lists of what comes beside");
  expect_defect(design, spoilt([](auto& c) { c.beside.assign(5, {0}); }), 4,
                "1 old elements beside new ones at position 1: at most 0 can be");
  expect_defect(design, spoilt([](auto& c) {
                  c.beside.assign(5, {0, 1});
                }),
                5, "2 old elements beside new ones at position 1: at most 1 can be");
  expect_defect(design, spoilt([](auto& c) {
                  for (const auto& subset : c.subsets) {
                    c.beside.push_back({subset.elements.front()});
                  }
                }),
                5, "an element is in the subset at position 1 and beside it");
}

TEST(UnchangedCover, WithElementsLeftOutIsRefusedWhenTheyAreNotServed) {
  const Design design = built("cyclic-paper", 11, 4);
  const UnchangedCover good = *find_cover(design, for_w(1));
  ASSERT_LT(good.subsets.size(), 6U);
  ASSERT_FALSE(good.beside.empty());
  UnchangedCover cover = good;
  cover.beside.clear();
  expect_defect(design, cover, 1, "nor beside");
  cover = good;
  std::find_if(cover.beside.begin(), cover.beside.end(), [](const Block& block) {
    return !block.empty();
  })->clear();
  expect_defect(design, cover, 1, "nor beside");
  // An element of the block before cannot come beside.
  cover = good;
  const UnchangedSubset& subset = cover.subsets.front();
  cover.beside.front() = difference(design.block(subset.position - 1), subset.elements);
  cover.beside.front().resize(1);
  EXPECT_TRUE(cover_defect(design, cover, 1));
  EXPECT_REFUSAL((void)expand_by(design, cover, 1), BadInput,
                 "is in no subset of the cover, nor beside every new element");
}

TEST(UnchangedCover, WithAWanderingElementIsRefusedAtAnotherPlace) {
  const Design design = built("mcsorley-circular", 9, 5, 1);
  const UnchangedCover good = *find_cover(design, for_w(4));
  ASSERT_EQ(good.subsets.size(), 2U);
  ASSERT_TRUE(leaves_one_out(good, 9));
  UnchangedCover cover = good;
  cover.sweep = 1 - good.sweep;
  expect_defect(design, cover, 4, "nor does it leave at the sweep");
  expect_defect(design, good, 1, "is in no subset");
}

TEST(UnchangedCover, HasNoPositionInADesignOfOneBlock) {
  const Design one(Parameters{4, 4, 2, Kind::circular, 2}, std::vector<Block>{{0, 1, 2, 3}});
  EXPECT_FALSE(find_cover(one));
  const Design line(Parameters{4, 4, 2, Kind::linear, 2}, std::vector<Block>{{0, 1, 2, 3}});
  const auto ends = find_cover(line);
  ASSERT_TRUE(ends);
  EXPECT_EQ(ends->subsets.size(), 2U);
  EXPECT_TRUE(verify(expand_by(line, *ends, 2)).valid());
}

TEST(IntervalCover, IsACoverOfEveryCyclicDesign) {
  for (std::uint64_t c = 1; c <= 5; ++c) {
    for (std::uint64_t k = 3; k <= 12; ++k) {
      const Design design = built("cyclic-paper", c * (4 * k - 6) + 1, k);
      const BaseBlocks base = *construction("cyclic-paper").base_blocks(*design.recipe);
      const auto points = [&](std::uint64_t which, std::span<Element> out) {
        const Block& block = base.blocks[static_cast<std::size_t>(which)];
        std::copy(block.end() - 2, block.end(), out.begin());
      };
      for (std::uint64_t w = 1; w <= 24; ++w) {
        const Parameters& p = design.parameters();
        const auto size = interval_cover_size(p, c, w);
        if (!size) {
          EXPECT_TRUE(k == 3 && w > c * p.v) << name(p) << " " << w;
          continue;
        }
        const UnchangedCover cover = interval_cover(p, c, w, points);
        ASSERT_EQ(cover_defect(design, cover, w), std::nullopt) << name(p) << " " << w;
        EXPECT_EQ(cover.subsets.size(), size->subsets);
        EXPECT_EQ(leaves_one_out(cover, p.v), size->left_out);
        if (p.v <= 60 && w <= 6) {
          EXPECT_TRUE(verify(expand_by(design, cover, w)).valid()) << name(p) << " " << w;
        }
      }
    }
  }
}

TEST(IntervalCover, IsAsSmallAsWhatTheSearchFinds) {
  for (const auto& [c, k] : {std::pair{1, 4}, std::pair{1, 5}, std::pair{2, 4}, std::pair{1, 6}}) {
    const auto count = static_cast<std::uint64_t>(c);
    const auto size = static_cast<std::uint64_t>(k);
    const Design design = built("cyclic-paper", count * (4 * size - 6) + 1, size);
    for (std::uint64_t w = 1; w <= 6; ++w) {
      EXPECT_EQ(interval_cover_size(design.parameters(), count, w)->subsets,
                find_cover(design, for_w(w))->subsets.size())
          << title(design, w);
    }
  }
}

}  // namespace
}  // namespace changeover::unchanged_cover_test
