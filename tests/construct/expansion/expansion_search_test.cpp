#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "construction_checks.hpp"

namespace changeover::expansion_search_test {
namespace {

using namespace test;

// Every way of choosing one unchanged subset or none at each position, tried one after another.
class BruteForce {
 public:
  explicit BruteForce(const Design& design) : v_(static_cast<std::size_t>(design.v())) {
    const Parameters& p = design.parameters();
    const std::size_t b = design.block_count();
    const auto size = static_cast<std::size_t>(p.k - p.change);
    const auto set_of = [&](std::size_t i) {
      return std::set<Element>(design.block(i).begin(), design.block(i).end());
    };
    choices_.resize(b + 1);
    if (p.kind == Kind::linear) {
      for (const auto& subset : subsets_of(set_of(0), size)) {
        choices_[0].push_back(subset);
      }
      for (const auto& subset : subsets_of(set_of(b - 1), size)) {
        choices_[b].push_back(subset);
      }
    }
    for (std::size_t i = 1; i < b + (p.kind == Kind::circular && b > 1 ? 1 : 0); ++i) {
      std::set<Element> common;
      for (const Element x : set_of(i - 1)) {
        if (set_of(i % b).count(x) != 0) {
          common.insert(x);
        }
      }
      if (common.size() == size) {
        choices_[i].push_back(common);
      }
    }
    chosen_.resize(b + 1);
    extend(0);
  }

  std::set<std::vector<std::pair<std::size_t, Block>>> full, maximal;
  std::size_t most = 0;

 private:
  void extend(std::size_t position) {
    if (position == choices_.size()) {
      finish();
      return;
    }
    chosen_[position].clear();
    extend(position + 1);
    for (const auto& subset : choices_[position]) {
      if (std::none_of(subset.begin(), subset.end(),
                       [&](Element x) { return used_.count(x) != 0; })) {
        chosen_[position] = subset;
        used_.insert(subset.begin(), subset.end());
        extend(position + 1);
        for (const Element x : subset) {
          used_.erase(x);
        }
        chosen_[position].clear();
      }
    }
  }

  void finish() {
    std::vector<std::pair<std::size_t, Block>> family;
    bool can_grow = false;
    for (std::size_t i = 0; i < choices_.size(); ++i) {
      if (!chosen_[i].empty()) {
        family.emplace_back(i, Block(chosen_[i].begin(), chosen_[i].end()));
        continue;
      }
      for (const auto& subset : choices_[i]) {
        can_grow = can_grow || std::none_of(subset.begin(), subset.end(),
                                            [&](Element x) { return used_.count(x) != 0; });
      }
    }
    most = std::max(most, used_.size());
    if (used_.size() == v_) {
      full.insert(family);
    }
    if (!can_grow) {
      maximal.insert(family);
    }
  }

  std::size_t v_;
  std::vector<std::vector<std::set<Element>>> choices_;
  std::vector<std::set<Element>> chosen_;
  std::set<Element> used_;
};

std::set<std::vector<std::pair<std::size_t, Block>>> as_families(
    const std::vector<ExpansionSet>& sets) {
  std::set<std::vector<std::pair<std::size_t, Block>>> families;
  for (const ExpansionSet& set : sets) {
    std::vector<std::pair<std::size_t, Block>> family;
    for (const UnchangedSubset& subset : set) {
      family.emplace_back(subset.position, subset.elements);
    }
    EXPECT_TRUE(std::is_sorted(family.begin(), family.end()));
    families.insert(family);
  }
  EXPECT_EQ(families.size(), sets.size());
  return families;
}

ExpansionSearchOptions everything(bool partial) {
  return {.how_many = 1'000'000, .count = true, .partial = partial, .limits = {}};
}

void expect_agreement(const Design& design) {
  const BruteForce brute(design);
  const ExpansionSearch full = find_expansion_sets(design, everything(false));
  ASSERT_TRUE(full.complete);
  ASSERT_EQ(full.count, brute.full.size());
  ASSERT_EQ(as_families(full.sets), brute.full);
  for (const ExpansionSet& set : full.sets) {
    ASSERT_EQ(expansion_set_defect(design, set), std::nullopt);
  }
  ASSERT_TRUE(full.reason.empty() || brute.full.empty());

  const ExpansionSearch partial = find_expansion_sets(design, everything(true));
  ASSERT_TRUE(partial.complete);
  ASSERT_EQ(partial.count, brute.maximal.size());
  ASSERT_EQ(as_families(partial.sets), brute.maximal);

  const PartialExpansion largest = largest_partial_expansion_set(design);
  ASSERT_TRUE(largest.optimal);
  ASSERT_EQ(largest.set.size() * (design.k() - design.parameters().change), brute.most);

  const ExpansionSearch counted =
      find_expansion_sets(design, {.how_many = 0, .count = true, .partial = false, .limits = {}});
  ASSERT_EQ(counted.count, brute.full.size());
  ASSERT_TRUE(counted.complete && counted.sets.empty());
  const ExpansionSearch one_of =
      find_expansion_sets(design, {.how_many = 1, .count = true, .partial = true, .limits = {}});
  ASSERT_EQ(one_of.count, brute.maximal.size());
  ASSERT_EQ(one_of.sets.size(), 1U);
  const ExpansionSearch first = find_expansion_sets(design);
  ASSERT_EQ(first.sets.empty(), brute.full.empty());
  ASSERT_FALSE(first.count);
}

Design design_of(std::string_view by, const Parameters& p) {
  return standard().build_design(offer_of(by, p)->recipe);
}

TEST(ExpansionSearch, AgreesWithBruteForceOnSmallDesigns) {
  for (std::uint64_t v = 3; v <= 13; ++v) {
    for (std::uint64_t k = 3; k <= std::min<std::uint64_t>(v, 6); ++k) {
      for (const Kind kind : {Kind::linear, Kind::circular}) {
        for (const Offer& offer : standard().offers({v, k, 2, kind, 2})) {
          if (offer.b <= 12) {
            SCOPED_TRACE(name(offer.recipe.parameters) + " by " + offer.recipe.construction);
            expect_agreement(standard().build_design(offer.recipe));
          }
        }
      }
    }
  }
}

TEST(ExpansionSearch, CountsThoseOfThePaper) {
  const auto count = [](const Design& design) {
    return find_expansion_sets(design, everything(false)).count;
  };
  EXPECT_EQ(count(design_of("doubling", {6, 4, 2, Kind::circular, 2})), 1U);
  EXPECT_EQ(count(design_of("printed", {7, 3, 2, Kind::linear, 2})), 2U);
  EXPECT_EQ(count(design_of("printed", {7, 3, 2, Kind::circular, 2})), 0U);
  EXPECT_EQ(count(design_of("cyclic-paper", {7, 3, 2, Kind::circular, 2})), 1U);
  // Each element is kept at two positions running: 2^13 choices.
  EXPECT_EQ(count(design_of("cyclic-paper", {13, 3, 2, Kind::circular, 2})), 8192U);
}

TEST(ExpansionSearch, NamesSimpleReasonsForThereBeingNone) {
  EXPECT_EQ(find_expansion_sets(design_of("printed", {7, 3, 2, Kind::circular, 2})).reason,
            "element 2 is in no unchanged subset");
  EXPECT_EQ(find_expansion_sets(design_of("doubling", {10, 6, 2, Kind::circular, 2})).reason,
            "k - m = 4 does not divide v = 10");
  const Design pairs(Parameters{6, 2, 2, Kind::linear, 2}, std::vector<Block>{{0, 1}, {2, 3}});
  EXPECT_EQ(find_expansion_sets(pairs).reason, "k = m: unchanged subsets are empty");
  EXPECT_TRUE(largest_partial_expansion_set(pairs).set.empty());
}

TEST(ExpansionSearch, ListsNoMoreThanAskedAndIsThenNotComplete) {
  const Design design = design_of("cyclic-paper", {13, 3, 2, Kind::circular, 2});
  const ExpansionSearch some =
      find_expansion_sets(design, {.how_many = 5, .count = false, .partial = false, .limits = {}});
  EXPECT_EQ(some.sets.size(), 5U);
  EXPECT_FALSE(some.complete);
  const ExpansionSearch counted =
      find_expansion_sets(design, {.how_many = 5, .count = true, .partial = false, .limits = {}});
  EXPECT_EQ(counted.sets.size(), 5U);
  EXPECT_EQ(counted.count, 8192U);
  EXPECT_TRUE(counted.complete);
}

TEST(ExpansionSearch, ClaimsNothingWhenALimitStrikes) {
  const Design design = design_of("cyclic-paper", {13, 3, 2, Kind::circular, 2});
  for (const bool partial : {false, true}) {
    const ExpansionSearch search =
        find_expansion_sets(design, {.how_many = 1'000'000,
                                     .count = true,
                                     .partial = partial,
                                     .limits = {.nodes = 5, .stop = {}}});
    EXPECT_FALSE(search.complete);
    EXPECT_FALSE(search.count);
  }
}

TEST(ExpansionSearch, CountsOnlyWhatItHasSeenToTheEnd) {
  const Design design = design_of("cut", {13, 3, 2, Kind::linear, 2});
  for (const bool partial : {false, true}) {
    const auto all = find_expansion_sets(design, everything(partial)).count;
    ASSERT_TRUE(all);
    bool listed_but_not_counted = false;
    bool counted = false;
    for (std::uint64_t nodes = 1; nodes < 2000; nodes += nodes / 8 + 1) {
      const ExpansionSearch search = find_expansion_sets(
          design, {.how_many = 1, .count = true, .partial = partial, .limits = {nodes, {}}});
      ASSERT_TRUE(!search.count || search.count == all);
      ASSERT_EQ(search.complete, search.count.has_value());
      listed_but_not_counted = listed_but_not_counted || (!search.sets.empty() && !search.count);
      counted = counted || search.count;
    }
    EXPECT_TRUE(listed_but_not_counted) << partial;
    EXPECT_TRUE(counted || partial);
  }
}

TEST(ExpansionSearch, LeavesOutEndsWithTooManyChoices) {
  Block first(30);
  std::iota(first.begin(), first.end(), 0U);
  Block second(30);
  std::iota(second.begin(), second.end(), 15U);
  const Design design(Parameters{45, 30, 15, Kind::linear, 2}, std::vector<Block>{first, second});
  const ExpansionSearch search = find_expansion_sets(design, everything(false));
  EXPECT_FALSE(search.complete);
  EXPECT_FALSE(search.count);
  EXPECT_NE(search.reason.find("C(30,15)"), std::string::npos);
  const PartialExpansion largest = largest_partial_expansion_set(design);
  EXPECT_EQ(largest.set.size(), 1U);
  EXPECT_FALSE(largest.optimal);
}

TEST(ExpansionSearch, SucceedsOnEveryCyclicDesignOfThePaperThatHasOne) {
  for (std::uint64_t c = 1; c <= 5; ++c) {
    for (std::uint64_t n = 1; n <= 2 * c + 1; ++n) {
      const std::uint64_t k = n + 2;
      const Design design =
          design_of("cyclic-paper", {c * (4 * k - 6) + 1, k, 2, Kind::circular, 2});
      const ExpansionSearch search = find_expansion_sets(design);
      ASSERT_EQ(!search.sets.empty(), (2 * c + 1) % n == 0) << "c = " << c << ", k = " << k;
      if (!search.sets.empty()) {
        EXPECT_EQ(expansion_set_defect(design, search.sets.front()), std::nullopt);
      }
    }
  }
}

// A list of blocks in which steps change m elements, or now and then some other number.
Design random_list() {
  const auto m = *rc::gen::inRange<std::uint64_t>(1, 3);
  const auto k = *rc::gen::inRange<std::uint64_t>(m + 1, 5);
  const auto v = *rc::gen::inRange<std::uint64_t>(k + m, 9);
  const auto b = *rc::gen::inRange<std::size_t>(1, 7);
  const auto kind = *rc::gen::element(Kind::linear, Kind::circular);
  Design design(Parameters{v, k, m, kind, 2});
  std::vector<Element> order(static_cast<std::size_t>(v));
  std::iota(order.begin(), order.end(), 0U);
  for (std::size_t i = 0; i < b; ++i) {
    design.append(std::span(order).first(static_cast<std::size_t>(k)));
    const std::uint64_t changes = *rc::gen::inRange(0, 10) == 0 ? 1 : m;
    for (std::uint64_t j = 0; j < changes; ++j) {
      const auto in = *rc::gen::inRange<std::size_t>(0, static_cast<std::size_t>(k));
      const auto out =
          *rc::gen::inRange<std::size_t>(static_cast<std::size_t>(k), static_cast<std::size_t>(v));
      std::swap(order[in], order[out]);
    }
  }
  return design;
}

RC_GTEST_PROP(ExpansionSearch, AgreesWithBruteForceOnRandomLists, ()) {
  expect_agreement(random_list());
}

RC_GTEST_PROP(ExpansionSearch, FindsOnlySetsWithoutDefectAndAllOfThem, ()) {
  const Design design = random_list();
  const BruteForce brute(design);
  for (const auto& family : brute.maximal) {
    ExpansionSet set;
    for (const auto& [position, elements] : family) {
      set.push_back({position, elements});
    }
    RC_ASSERT(expansion_set_defect(design, set).has_value() == (brute.full.count(family) == 0));
  }
}

}  // namespace
}  // namespace changeover::expansion_search_test
