// The sets behind verification by themselves, against std::set: rows of bits and subsets one by one
// say the same.
#include "verify/subset_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

namespace changeover::subset_set_test {
namespace {

TEST(ElementBits, PayFromSixteenIntroducedElementsAndOneIn128On) {
  EXPECT_FALSE(ElementBits::pay(15, 100));
  EXPECT_TRUE(ElementBits::pay(16, 100));
  EXPECT_TRUE(ElementBits::pay(16, 2047));
  EXPECT_FALSE(ElementBits::pay(16, 2048));
  EXPECT_TRUE(ElementBits::pay(17, 2048));
  EXPECT_FALSE(ElementBits::pay(511, 65'535));
  EXPECT_TRUE(ElementBits::pay(512, 65'535));
}

TEST(ElementBits, AreTheElementsOfTheLatestBlock) {
  std::mt19937 random(3);
  ElementBits bits;
  for (int round = 0; round < 400; ++round) {
    const std::uint64_t v = 1 + random() % 300;
    Block all(static_cast<std::size_t>(v));
    std::iota(all.begin(), all.end(), Element{0});
    std::shuffle(all.begin(), all.end(), random);
    const std::size_t k = random() % (all.size() + 1);
    const std::size_t introduced_from = random() % (k + 1);
    bits.assign(std::span(all).first(k), introduced_from, v);  // the others stand behind it
    ASSERT_EQ(bits.completing(true).size(), v / 64 + 1) << "a word for each 64 elements";
    ASSERT_EQ(bits.completing(false).size(), v / 64 + 1);
    for (std::uint64_t x = 0; x < 64 * (v / 64 + 1); ++x) {
      const auto place =
          static_cast<std::size_t>(std::find(all.begin(), all.end(), x) - all.begin());
      const bool introduced = introduced_from <= place && place < k;
      ASSERT_EQ(bits.completing(true)[x / 64] >> (x % 64) & 1U, place < k ? 1U : 0U) << x;
      ASSERT_EQ(bits.completing(false)[x / 64] >> (x % 64) & 1U, introduced ? 1U : 0U) << x;
      if (x < v) {
        ASSERT_EQ(bits.is_introduced(static_cast<Element>(x)), introduced) << x;
      }
    }
  }
}

// The first in order of their largest elements, then of the next largest, …
struct Colexicographic {
  bool operator()(const Block& a, const Block& b) const {
    return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
  }
};
using Subsets = std::set<Block, Colexicographic>;

void add_subsets(const Block& from, std::size_t t, Block& chosen, std::size_t start, Subsets& out) {
  if (chosen.size() == t) {
    out.insert(chosen);
    return;
  }
  for (std::size_t i = start; i < from.size(); ++i) {
    chosen.push_back(from[i]);
    add_subsets(from, t, chosen, i + 1, out);
    chosen.pop_back();
  }
}

// Those of `block` that have an element of the last ones.
Subsets new_subsets(Block block, std::size_t introduced_from, std::size_t t) {
  const std::set<Element> introduced(block.begin() + static_cast<std::ptrdiff_t>(introduced_from),
                                     block.end());
  std::sort(block.begin(), block.end());
  Subsets all;
  Block chosen;
  add_subsets(block, t, chosen, 0, all);
  for (auto at = all.begin(); at != all.end();) {
    const bool has =
        std::any_of(at->begin(), at->end(), [&](Element x) { return introduced.count(x) != 0; });
    at = has ? std::next(at) : all.erase(at);
  }
  return all;
}

std::vector<Block> listed(const SubsetSet& set, bool missing, std::uint64_t limit) {
  std::vector<Block> out;
  const auto take = [&](std::span<const Element> subset) {
    out.emplace_back(subset.begin(), subset.end());
  };
  missing ? set.for_each_missing(limit, take) : set.for_each(limit, take);
  return out;
}

void expect_equal(const SubsetSet& set, const Subsets& wanted, std::uint64_t v, std::size_t t) {
  ASSERT_EQ(set.size(), wanted.size());
  Block all(static_cast<std::size_t>(v));
  std::iota(all.begin(), all.end(), Element{0});
  Subsets everything;
  Block chosen;
  add_subsets(all, t, chosen, 0, everything);
  std::vector<Block> missing;
  std::set_difference(everything.begin(), everything.end(), wanted.begin(), wanted.end(),
                      std::back_inserter(missing), Colexicographic{});
  const std::vector<Block> present(wanted.begin(), wanted.end());
  ASSERT_EQ(listed(set, false, everything.size()), present);
  ASSERT_EQ(listed(set, true, everything.size()), missing);
  for (const std::size_t limit : {std::size_t{0}, std::size_t{1}, std::size_t{7}}) {
    ASSERT_EQ(listed(set, false, limit).size(), std::min(limit, present.size()));
    ASSERT_EQ(listed(set, true, limit).size(), std::min(limit, missing.size()));
  }
}

// Blocks with few introduced elements and with many, each with those it keeps in front.
TEST(SubsetSet, IsTheSetOfNewSubsets) {
  std::mt19937 random(9);
  for (int round = 0; round < 40; ++round) {
    const auto t = static_cast<std::uint32_t>(2 + round % 3);
    const bool many = round % 2 == 0;
    const std::uint64_t v = (many ? 18 : 5) + random() % (t == 2 ? 150 : t == 3 ? 20 : 8);
    const Parameters p{.v = v, .k = t, .strength = t};
    SubsetSet set(p);
    Subsets wanted;
    Block all(static_cast<std::size_t>(v));
    std::iota(all.begin(), all.end(), Element{0});
    for (int b = 0; b < 3; ++b) {
      std::shuffle(all.begin(), all.end(), random);
      const std::size_t k = many ? 17 + random() % (std::min<std::size_t>(all.size(), 30) - 16)
                                 : t + random() % (all.size() - t + 1);
      const Block block(all.begin(),
                        all.begin() + static_cast<std::ptrdiff_t>(std::min(k, all.size())));
      const std::size_t introduced_from =
          many ? random() % (block.size() - 15) : random() % (block.size() + 1);
      set.insert_new(block, introduced_from);
      wanted.merge(new_subsets(block, introduced_from, t));
    }
    expect_equal(set, wanted, v, t);
    ASSERT_FALSE(HasFatalFailure()) << "v=" << v << " t=" << t << " round " << round;
  }
}

}  // namespace
}  // namespace changeover::subset_set_test
