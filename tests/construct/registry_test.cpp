#include "changeover/construct/registry.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"
#include "message_of.hpp"
#include "oracle_minima.hpp"

namespace changeover::registry_test {
namespace {

using namespace test;

constexpr std::uint64_t huge = 0xffff'ffff;

template <typename Visit>
void for_each_parameters(std::uint64_t largest_v, Visit&& visit) {
  for (std::uint64_t v = 2; v <= largest_v; ++v) {
    for (std::uint64_t k = 2; k <= v; ++k) {
      for (std::uint64_t m = 1; m <= std::min<std::uint64_t>(k, 3); ++m) {
        for (const Kind kind : {Kind::linear, Kind::circular}) {
          visit(Parameters{v, k, m, kind, 2});
        }
      }
    }
  }
}

TEST(Registry, HasEveryConstructionOnceInTheOrderOfNames) {
  std::vector<std::string> names;
  for (const Construction* construction : standard().constructions()) {
    names.emplace_back(construction->name());
  }
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  for (const char* name :
       {"cut", "cyclic-61-4", "cyclic-paper", "doubling", "expansion", "fixed-element", "literal",
        "mcsorley-circular", "printed", "short-long-runs"}) {
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  }
}

TEST(Registry, DescribesEveryConstructionInShortLines) {
  for (const Construction* construction : standard().constructions()) {
    const std::string name(construction->name());
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string::npos);
    for (const std::string_view line :
         {construction->summary(), construction->preconditions(), construction->guarantee()}) {
      EXPECT_FALSE(line.empty()) << name;
      EXPECT_EQ(line.find('\n'), std::string_view::npos) << name;
      EXPECT_LE(line.size(), 100U) << name;
    }
    EXPECT_EQ(standard().find(name), construction);
  }
  EXPECT_EQ(standard().find("nonsense"), nullptr);
  EXPECT_EQ(standard().find(""), nullptr);
}

TEST(Registry, WritesCitationsInBrackets) {
  EXPECT_EQ((Citation{"ChafeeStevens2025", "Theorem 2"}.to_string()),
            "[ChafeeStevens2025, Theorem 2]");
  EXPECT_EQ((Citation{"McSorley1999", ""}.to_string()), "[McSorley1999]");
}

TEST(Registry, KeepsEveryPromiseOfEveryOfferForSmallParameters) {
  std::size_t offers = 0;
  for_each_parameters(20, [&](const Parameters& p) {
    for (const Offer& offer : standard().offers(p)) {
      ++offers;
      ASSERT_EQ(offer.recipe.parameters, p);
      ASSERT_GE(offer.b, lower_bound(p).blocks) << name(p);
      expect_as_promised(offer);
    }
  });
  EXPECT_GE(offers, 100U);
}

TEST(Registry, NeverOffersFewerBlocksThanTheKnownMinimum) {
  std::size_t attained = 0;
  for (const OracleMinimum& row : oracle_minima()) {
    for (const Offer& offer : standard().offers(row.parameters)) {
      EXPECT_GE(offer.b, row.b) << name(row.parameters) << " by " << offer.recipe.construction;
      // Economical proves minimum in linear designs only: see elements that are in every block.
      EXPECT_TRUE(!offer.economical || offer.b == row.b || row.parameters.kind == Kind::circular)
          << name(row.parameters);
      attained += offer.b == row.b ? 1 : 0;
    }
  }
  EXPECT_GE(attained, 20U);
}

TEST(Registry, ListsOffersByBlocksAndThenByName) {
  const auto offers = standard().offers({15, 3, 2, Kind::linear, 2});
  ASSERT_GE(offers.size(), 2U);
  EXPECT_EQ(offers[0].recipe.construction, "cut");
  EXPECT_EQ(offers[1].recipe.construction, "expansion");
  EXPECT_EQ(offers[0].b, offers[1].b);
  for_each_parameters(30, [](const Parameters& p) {
    const auto all = standard().offers(p);
    EXPECT_TRUE(std::is_sorted(all.begin(), all.end(), [](const Offer& a, const Offer& b) {
      const auto rank = [](const Offer& offer) {
        const std::string& name = offer.recipe.construction;
        return std::tuple(offer.b, name == "found", name);
      };
      return rank(a) < rank(b);
    }));
    EXPECT_EQ(standard().best(p).has_value(), !all.empty());
  });
}

// Claims to make everything, in as many blocks as it was told.
class Eager final : public Construction {
 public:
  Eager(std::string_view name, std::uint64_t b) : name_(name), b_(b) {}
  std::string_view name() const override { return name_; }
  std::string_view summary() const override { return "claims everything"; }
  std::string_view preconditions() const override { return "none"; }
  std::string_view guarantee() const override { return "none"; }
  Citation citation() const override { return {}; }
  std::optional<Offer> offer(const Parameters& p, const Registry&) const override {
    return Offer{Recipe{std::string(name_), p, {}, {}, {}}, b_, false, false, false};
  }
  std::unique_ptr<BlockSource> build(const Recipe&, const Registry&) const override {
    throw BadInput("it cannot");
  }

 private:
  std::string_view name_;
  std::uint64_t b_;
};

TEST(Registry, AsksNobodyAboutWhatCannotExist) {
  const Eager many("a-many", 9);
  const Eager few("c-few", 5);
  const Eager as_few("b-as-few", 5);
  const Registry eager({&many, &few, &as_few});
  EXPECT_TRUE(eager.offers({4, 2, 2, Kind::linear, 2}).empty());
  EXPECT_TRUE(eager.offers({5, 4, 2, Kind::circular, 2}).empty());
  const auto offers = eager.offers({6, 4, 2, Kind::circular, 2});
  ASSERT_EQ(offers.size(), 3U);
  EXPECT_EQ(offers[0].recipe.construction, "b-as-few");
  EXPECT_EQ(offers[1].recipe.construction, "c-few");
  EXPECT_EQ(offers[2].recipe.construction, "a-many");
}

TEST(Registry, HasDefaultsForWhatAConstructionNeedNotSay) {
  const Eager eager("eager", 1);
  const Recipe recipe{"eager", {6, 4, 2, Kind::circular, 2}, {}, {}, {}};
  EXPECT_FALSE(eager.expansion_set(recipe, standard()));
  EXPECT_FALSE(eager.base_blocks(recipe));
  EXPECT_EQ(eager.explain(recipe), "claims everything");
  EXPECT_TRUE(eager.labels(recipe, standard()).empty());
}

TEST(Registry, OffersNothingWhereNothingExists) {
  EXPECT_TRUE(standard().offers({4, 2, 2, Kind::linear, 2}).empty());
  EXPECT_FALSE(standard().best({5, 4, 2, Kind::circular, 2}));
}

TEST(Registry, RefusesParametersThatCannotBeWrittenDown) {
  for (const Parameters& p :
       {Parameters{3, 4, 2, Kind::linear, 2}, Parameters{5, 0, 2, Kind::linear, 2},
        Parameters{5, 3, 0, Kind::linear, 2}, Parameters{5, 3, 4, Kind::linear, 2},
        Parameters{huge + 1, 3, 2, Kind::linear, 2}, Parameters{5, 3, 2, Kind::linear, 1}}) {
    EXPECT_THROW((void)standard().offers(p), ImpossibleParameters);
    EXPECT_THROW((void)standard().best(p), ImpossibleParameters);
    EXPECT_THROW((void)standard().nearest(p, 1, 1), ImpossibleParameters);
  }
}

TEST(Registry, ConstructionsAskedDirectlyOfferNothingForNonsense) {
  const std::vector<std::uint64_t> numbers{0,
                                           1,
                                           2,
                                           3,
                                           4,
                                           huge / 2,
                                           huge / 2 + 1,
                                           huge - 1,
                                           huge,
                                           huge + 1,
                                           huge + 2,
                                           2 * huge + 1,
                                           ~std::uint64_t{0} / 4,
                                           ~std::uint64_t{0} / 2,
                                           ~std::uint64_t{0}};
  for (const Construction* construction : standard().constructions()) {
    for (const std::uint64_t v : numbers) {
      for (const std::uint64_t k : numbers) {
        for (const std::uint64_t m : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{2}, k, v}) {
          for (const Kind kind : {Kind::linear, Kind::circular}) {
            const auto offer = construction->offer({v, k, m, kind, 2}, standard());
            if (offer) {
              EXPECT_TRUE(k >= 2 && k <= v && v <= huge && m >= 1 && m <= k);
            }
          }
        }
      }
    }
  }
}

TEST(Registry, ServesTheLargestParametersWithoutWrapping) {
  const auto mcsorley = standard().best({huge, huge / 2 + 1, 1, Kind::circular, 2});
  ASSERT_TRUE(mcsorley);
  EXPECT_EQ(mcsorley->b, huge);
  const std::uint64_t k = 107'374'184;  // c = 5: v = 5(4k−6)+1 is 36 below 2³¹
  const auto cyclic = standard().best({5 * (4 * k - 6) + 1, k, 2, Kind::circular, 2});
  ASSERT_TRUE(cyclic);
  EXPECT_EQ(cyclic->b, 5 * (5 * (4 * k - 6) + 1));
}

RC_GTEST_PROP(Registry, NeverOffersLessThanTheLowerBoundForLargeFamilies, ()) {
  const auto k = *rc::gen::inRange<std::uint64_t>(2, 200'000'000);
  const auto c = *rc::gen::inRange<std::uint64_t>(1, 6);
  for (const auto& [v, m] : {std::pair{2 * k - 1, 1}, std::pair{2 * k - 2, 2},
                             std::pair{2 * k - 3, 2}, std::pair{c * (4 * k - 6) + 1, 2}}) {
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      const Parameters p{v, k, static_cast<std::uint64_t>(m), kind, 2};
      if (p.k > p.v || p.v > huge || p.change > p.k) {
        continue;
      }
      for (const Offer& offer : standard().offers(p)) {
        RC_ASSERT(offer.b >= lower_bound(p).blocks);
      }
    }
  }
}

TEST(Registry, RefusesUnknownConstructionsAndSaysWhoListsThem) {
  Recipe recipe{"no-such", {7, 3, 2, Kind::linear, 2}, {}, {}, {}};
  expect_refused(recipe, "unknown");
  try {
    (void)standard().build(recipe);
  } catch (const BadInput& fault) {
    EXPECT_EQ(std::string(fault.what()),
              "no construction is named 'no-such'; changeover constructions lists them");
  }
  EXPECT_THROW((void)standard().build_design(recipe), BadInput);
}

TEST(Registry, RefusesRecipesThatAreNestedTooDeep) {
  Recipe recipe{"literal", {7, 3, 2, Kind::circular, 2}, {}, {}, {}};
  for (std::size_t depth = 0; depth < 1000; ++depth) {
    Recipe outer{"cut", {7, 3, 2, Kind::linear, 2}, {{"at", 0}}, {}, {}};
    outer.inputs.push_back(std::move(recipe));
    recipe = std::move(outer);
  }
  expect_refused(recipe, "a thousand cuts");
  try {
    (void)standard().build(recipe);
  } catch (const BadInput& fault) {
    EXPECT_EQ(std::string(fault.what()), "the recipe is nested deeper than 64");
  }
}

TEST(Registry, RefusesTwoConstructionsOfOneName) {
  const Construction* cut = standard().find("cut");
  EXPECT_REFUSAL(Registry({cut, cut}), BadInput, "two constructions are named 'cut'");
}

TEST(Registry, OfSomeConstructionsOnlyOffersOnlyThose) {
  const Registry some({standard().find("short-long-runs"), standard().find("cut")});
  EXPECT_TRUE(some.best({8, 5, 2, Kind::circular, 2}));
  EXPECT_TRUE(some.best({8, 5, 2, Kind::linear, 2}));
  EXPECT_FALSE(some.best({7, 3, 2, Kind::circular, 2}));
}

std::uint64_t apart(std::uint64_t a, std::uint64_t b) { return a > b ? a - b : b - a; }

TEST(Registry, NearestAgreesWithTryingAllParameters) {
  for (const Parameters& p :
       {Parameters{20, 6, 2, Kind::circular, 2}, Parameters{4, 3, 2, Kind::linear, 2},
        Parameters{30, 9, 2, Kind::linear, 2}, Parameters{2, 2, 1, Kind::circular, 2},
        Parameters{11, 4, 2, Kind::circular, 2}}) {
    for (const std::uint64_t radius : {0U, 1U, 3U, 8U}) {
      std::vector<std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>> expected;
      for (std::uint64_t v = 2; v <= 60; ++v) {
        for (std::uint64_t k = 2; k <= v; ++k) {
          const Parameters near{v, k, p.change, p.kind, 2};
          if (apart(v, p.v) <= radius && apart(k, p.k) <= radius && standard().best(near)) {
            expected.emplace_back(apart(v, p.v) + apart(k, p.k), v, k);
          }
        }
      }
      std::sort(expected.begin(), expected.end());
      for (const std::size_t limit : {0U, 1U, 4U, 1000U}) {
        std::vector<std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>> found;
        for (const Offer& offer : standard().nearest(p, limit, radius)) {
          const Parameters& near = offer.recipe.parameters;
          found.emplace_back(apart(near.v, p.v) + apart(near.k, p.k), near.v, near.k);
        }
        EXPECT_EQ(found, decltype(expected)(expected.begin(),
                                            expected.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                                   limit, expected.size()))))
            << name(p) << " radius " << radius << " limit " << limit;
      }
    }
  }
}

}  // namespace
}  // namespace changeover::registry_test
