#include "changeover/search/local_search.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/verify/verdict.hpp"
#include "message_of.hpp"
#include "naive_verdict.hpp"
#include "oracle_minima.hpp"
#include "search/local/imposed.hpp"
#include "search/local/random_list.hpp"

namespace changeover::local_search_test {
namespace {

ImproveResult search(const Parameters& p, const ImproveOptions& options,
                     RunControl::Settings settings = {}) {
  RunControl control(std::move(settings));
  return improve(p, options, control);
}

TEST(Improve, ReachesWhatThePlannerDoesNot) {
  struct Case {
    Parameters parameters;
    std::uint64_t blocks;
  };
  for (const Case& of : std::vector<Case>{{{.v = 20, .k = 5, .change = 2}, 30},
                                          {{.v = 50, .k = 8, .change = 2}, 99},
                                          {{.v = 100, .k = 10, .change = 2}, 300},
                                          {{.v = 30, .k = 6, .change = 2}, 50},
                                          {{.v = 12, .k = 4, .change = 1}, 22}}) {
    const ImproveResult found = search(of.parameters, {.target = of.blocks, .moves = 40'000'000});
    ASSERT_TRUE(found.design.has_value());
    EXPECT_LE(found.design->block_count(), of.blocks) << name(of.parameters);
    EXPECT_EQ(found.why_stopped, WhyStopped::found) << name(of.parameters);
    EXPECT_TRUE(verify(*found.design).valid());
    EXPECT_FALSE(found.how.empty());
  }
}

TEST(Improve, IsNeverWorseThanTheBestRecipeNorBetterThanTheMinimum) {
  std::size_t compared = 0;
  for (const test::OracleMinimum& known : test::oracle_minima()) {
    if (known.parameters.v > 9 || known.parameters.v <= known.parameters.k) {
      continue;
    }
    SCOPED_TRACE(name(known.parameters));
    const auto recipe = best_known_design(known.parameters);
    const ImproveResult found = search(known.parameters, {.target = known.b, .moves = 100'000});
    ASSERT_TRUE(found.design.has_value());
    ASSERT_TRUE(test::naive_verdict(*found.design).valid);
    ASSERT_GE(found.design->block_count(), known.b);
    ASSERT_GE(found.design->block_count(), found.lower_bound);
    if (recipe) {
      ASSERT_LE(found.design->block_count(), recipe->block_count());
      ASSERT_EQ(found.started_from, recipe->block_count());
    }
    ++compared;
  }
  EXPECT_GT(compared, 30U);
}

TEST(Improve, WithoutMovesGivesTheBestRecipe) {
  const Parameters p{.v = 30, .k = 6, .change = 2};
  const ImproveResult found = search(p, {.moves = 0});
  ASSERT_TRUE(found.design.has_value());
  EXPECT_EQ(found.design->block_count(), best_known_design(p).value().block_count());
  EXPECT_EQ(found.why_stopped, WhyStopped::step_limit);
  EXPECT_EQ(found.moves, 0U);
  EXPECT_EQ(found.how, "best recipe");
}

TEST(Improve, IsDeterministicWithOneThreadAndALimitOfMoves) {
  const Parameters p{.v = 24, .k = 5, .change = 1};
  const auto once = [&](std::uint64_t seed) {
    return search(p, {.moves = 1'500'000}, {.seed = seed});
  };
  const ImproveResult first = once(11);
  const ImproveResult second = once(11);
  EXPECT_EQ(first.moves, second.moves);
  EXPECT_EQ(first.attempts, second.attempts);
  EXPECT_EQ(first.how, second.how);
  const auto one = first.design->design().elements();
  const auto two = second.design->design().elements();
  EXPECT_TRUE(std::equal(one.begin(), one.end(), two.begin(), two.end()));
  EXPECT_LE(first.moves, 1'500'000U);
}

TEST(Improve, StopsWhenTold) {
  std::atomic<bool> interrupted = true;
  const ImproveResult found =
      search({.v = 40, .k = 6, .change = 2}, {}, {.interrupted = &interrupted});
  EXPECT_EQ(found.why_stopped, WhyStopped::interrupted);
  // On a machine that is busy the grace may be over before there is a design to start from.
  EXPECT_TRUE(!found.design || verify(*found.design).valid());
}

// Known designs are so large here that the grace ends before, between or after the two that are
// built: what was built is where the search started, and nothing that it found.
TEST(Improve, StoppedAmongKnownDesignsFindsNothing) {
  const std::atomic<bool> interrupted = true;
  for (const auto& [v, k] : {std::pair{4200U, 600U}, {5000U, 700U}, {5600U, 800U}}) {
    const ImproveResult found =
        search({.v = v, .k = k, .change = 2}, {}, {.interrupted = &interrupted});
    EXPECT_EQ(found.moves, 0U);
    ASSERT_EQ(found.started_from.has_value(), found.design.has_value()) << v;
    if (found.design) {
      EXPECT_EQ(found.started_from, found.design->block_count()) << v;
    }
  }
}

TEST(Improve, SeveralThreadsAndSharesFindValidDesigns) {
  for (std::uint64_t index = 0; index < 3; ++index) {
    const ImproveResult found =
        search({.v = 26, .k = 5, .change = 2}, {.moves = 600'000},
               {.threads = 3, .seed = 5, .share = {.index = index, .of = 3}});
    ASSERT_TRUE(found.design.has_value());
    EXPECT_TRUE(test::naive_verdict(*found.design).valid);
    EXPECT_LE(found.design->block_count(), found.started_from.value());
  }
}

TEST(Improve, TellsHowFarItIs) {
  std::set<std::string> phases;
  std::uint64_t least_bound = 1000;
  const ImproveResult found = search({.v = 47, .k = 9, .change = 1}, {.moves = 4'000'000},
                                     {.on_progress =
                                          [&](const Progress& progress) {
                                            if (!progress.lower_bound) {
                                              return;  // It looks for a design to start from.
                                            }
                                            phases.insert(progress.phase);
                                            least_bound =
                                                std::min(least_bound, progress.lower_bound.value());
                                            EXPECT_TRUE(progress.best.has_value());
                                            EXPECT_TRUE(progress.missing.has_value());
                                          },
                                      .progress_interval = std::chrono::duration<double>(0)});
  EXPECT_GT(phases.size(), 2U);
  EXPECT_EQ(least_bound, found.lower_bound);
}

TEST(Improve, TakesADesignToStartFrom) {
  const Parameters p{.v = 28, .k = 7, .change = 4};
  const std::size_t less = best_known_design(p)->block_count() - 1;
  const ImproveResult first = search(p, {.target = less, .moves = 20'000'000});
  ASSERT_LE(first.design->block_count(), less);
  const ImproveResult second = search(p, {.moves = 0, .start = first.design});
  EXPECT_EQ(second.design->block_count(), first.design->block_count());
  EXPECT_EQ(second.how, "the design to start from");
  Design broken(p);
  broken.append(first.design->block(0));
  EXPECT_THROW(search(p, {.start = broken}), BadInput);
  EXPECT_THROW(search({.v = 28, .k = 7, .change = 3}, {.start = first.design}), BadInput);
}

TEST(Improve, RefusesWhatCannotBe) {
  EXPECT_THROW(search({.v = 4, .k = 2, .change = 2}, {}), ImpossibleParameters);
  EXPECT_THROW(search({.v = 5, .k = 4, .change = 2}, {}), ImpossibleParameters);
  const ImproveResult one = search({.v = 5, .k = 5, .change = 2}, {});
  EXPECT_EQ(one.design->block_count(), 1U);
  EXPECT_EQ(one.why_stopped, WhyStopped::found);
}

TEST(Improve, SearchesStrengthThreeAndFour) {
  for (const Parameters& p :
       {Parameters{.v = 8, .k = 4, .change = 1, .strength = 3},
        Parameters{.v = 8, .k = 5, .change = 2, .kind = Kind::circular, .strength = 3},
        Parameters{.v = 7, .k = 5, .change = 1, .strength = 4}}) {
    const ImproveResult found = search(p, {.moves = 300'000});
    ASSERT_TRUE(found.design.has_value());
    EXPECT_TRUE(test::naive_verdict(*found.design).valid) << name(p);
    EXPECT_GE(found.design->block_count(), found.lower_bound);
  }
}

TEST(ShortestCut, IsALinearDesignWithoutNeedlessEnds) {
  for (const auto& [v, k, m] : std::vector<std::array<std::uint64_t, 3>>{
           {11, 4, 2}, {21, 4, 2}, {15, 5, 2}, {13, 4, 1}, {25, 5, 1}}) {
    const Parameters p{.v = v, .k = k, .change = m, .kind = Kind::circular};
    const auto circular = best_known_design(p);
    ASSERT_TRUE(circular.has_value());
    const Design cut = shortest_cut(*circular);
    EXPECT_EQ(cut.parameters().kind, Kind::linear);
    EXPECT_TRUE(verify(cut).valid());
    EXPECT_LE(cut.block_count(), circular->block_count());
    const Design again = shortest_cut(cut);
    EXPECT_EQ(again.block_count(), cut.block_count());
    const Design part = best_part(*circular, cut.block_count() - 1);
    EXPECT_EQ(part.block_count(), cut.block_count() - 1);
    EXPECT_EQ(verify(part).bad_steps, 0U);
  }
}

TEST(RandomLists, HaveTheChangeProperty) {
  Random random(1);
  std::size_t circular = 0;
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (std::uint64_t v = 4; v <= 9; ++v) {
      for (std::uint64_t k = 2; k < v; ++k) {
        for (std::uint64_t m = 1; m <= std::min(k, v - k); ++m) {
          for (std::size_t b = 2; b < 12; ++b) {
            const Parameters p{.v = v, .k = k, .change = m, .kind = kind};
            const auto list = random_list(p, b, random);
            ASSERT_TRUE(list.has_value() || kind == Kind::circular);
            if (list) {
              ASSERT_EQ(list->block_count(), b);
              ASSERT_EQ(verify(*list).bad_steps, 0U) << name(p) << ' ' << b;
              circular += kind == Kind::circular ? 1U : 0U;
            }
          }
        }
      }
    }
  }
  EXPECT_GT(circular, 400U);
}

TEST(Imposed, CountsOrbitsAndNamesAutomorphisms) {
  const auto orbits_by_hand = [](const Automorphism& pi) {
    std::set<std::set<std::pair<Element, Element>>> orbits;
    for (Element y = 1; y < pi.v(); ++y) {
      for (Element x = 0; x < y; ++x) {
        std::set<std::pair<Element, Element>> orbit;
        for (std::uint64_t s = 0; s < pi.n; ++s) {
          orbit.insert(std::minmax({pi.image(x, s), pi.image(y, s)}));
        }
        orbits.insert(orbit);
      }
    }
    return orbits.size();
  };
  for (std::uint64_t v = 2; v <= 16; ++v) {
    std::set<Automorphism> seen;
    for (const Automorphism& pi : imposed_automorphisms(v)) {
      EXPECT_EQ(pi.v(), v);
      EXPECT_EQ(pi.pair_orbits(), orbits_by_hand(pi));
      EXPECT_TRUE(seen.insert(pi).second);
    }
    EXPECT_GE(seen.size(), 1U);
  }
}

TEST(Imposed, FindsTheTightDesignsThatWereFoundSo) {
  struct Case {
    std::uint64_t v, k;
    Automorphism pi;
    std::size_t c;
  };
  for (const Case& of : std::vector<Case>{{15, 4, {3, 5}, 7},
                                          {16, 4, {3, 5, 1}, 8},
                                          {26, 4, {13, 2}, 5},
                                          {28, 6, {7, 4}, 6},
                                          {21, 3, {7, 3}, 10},
                                          {11, 4, {11, 1}, 1}}) {
    const Parameters p{.v = of.v, .k = of.k, .change = 2, .kind = Kind::circular};
    bool found = false;
    for (std::uint64_t seed = 1; seed <= 10 && !found; ++seed) {
      Random random(seed);
      RunControl control({});
      const ImposedOutcome outcome =
          search_imposed(p, of.pi, of.c, {.moves = 1'000'000}, random, control);
      ASSERT_TRUE(outcome.started);
      if (outcome.design) {
        found = true;
        EXPECT_EQ(outcome.design->block_count(), of.c * of.pi.n);
        EXPECT_TRUE(verify(*outcome.design).tight());
      }
    }
    EXPECT_TRUE(found) << name(p);
  }
}

TEST(Imposed, FindsTheTightDesignOnTwentyFiveElementsSlow) {
  bool found = false;
  for (std::uint64_t seed = 1; seed <= 10 && !found; ++seed) {
    Random random(seed);
    RunControl control({});
    const auto outcome = search_imposed({.v = 25, .k = 4, .kind = Kind::circular}, {5, 5}, 12,
                                        {.moves = 20'000'000}, random, control);
    found = outcome.design && verify(*outcome.design).tight();
  }
  EXPECT_TRUE(found);
}

TEST(Imposed, RefusesAnAutomorphismThatDoesNotFit) {
  Random random(1);
  RunControl control({});
  const Parameters p{.v = 10, .k = 4};
  EXPECT_REFUSAL(static_cast<void>(search_imposed(p, {4, 2}, 3, {}, random, control)), BadInput,
                 "base blocks; the order must divide v less the fixed elements, v ≤");
  EXPECT_REFUSAL(static_cast<void>(search_imposed(p, {5, 2}, 0, {}, random, control)), BadInput,
                 "base blocks; the order must divide v less the fixed elements, v ≤");
}

}  // namespace
}  // namespace changeover::local_search_test
