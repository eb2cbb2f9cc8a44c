// Enumeration against all lists of tiny parameters, against the numbers of the literature, and its
// promises.
#include "changeover/search/enumeration.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "changeover/core/error.hpp"
#include "changeover/verify/verdict.hpp"
#include "core/checked.hpp"
#include "enumeration_oracle.hpp"
#include "message_of.hpp"

namespace changeover::test::enumeration_test {
namespace {

Parameters parameters(std::uint64_t v, std::uint64_t k, std::uint64_t change, Kind kind) {
  return {.v = v, .k = k, .change = change, .kind = kind};
}

std::vector<Design> all_designs(const Parameters& p, std::uint64_t b, unsigned threads = 1,
                                WorkShare share = {}) {
  RunControl control({.threads = threads, .share = share});
  std::vector<Design> designs;
  const EnumerationRun run =
      enumerate_designs(p, b, control, [&](const Design& design) { designs.push_back(design); });
  EXPECT_EQ(run.why_stopped, WhyStopped::exhausted);
  EXPECT_EQ(run.forms, designs.size());
  return designs;
}

Classification classes(const Parameters& p, std::uint64_t b, bool reversal = false,
                       unsigned threads = 1, WorkShare share = {}) {
  RunControl control({.threads = threads, .share = share});
  return classify_designs(p, b, {.reversal = reversal, .keep = 1'000'000}, control);
}

// How many lists the oracle would walk through, or more.
bool oracle_can(const Parameters& p, std::uint64_t b) {
  const std::uint64_t steps = binomial(p.k, p.change) * binomial(p.v - p.k, p.change);
  std::uint64_t lists = 1;
  for (std::uint64_t i = 1; i < b && lists <= 100'000; ++i) {
    lists *= steps;
  }
  return lists <= 100'000;
}

TEST(Enumeration, FindsEachStandardFormOnceAndEachClassOnceForAllTinyParameters) {
  int cases = 0;
  int with_designs = 0;
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (std::uint64_t v = 2; v <= 8; ++v) {
      for (std::uint64_t k = 2; k <= v; ++k) {
        for (std::uint64_t change = 1; change <= k; ++change) {
          for (std::uint64_t b = 1; b <= 7; ++b) {
            const Parameters p = parameters(v, k, change, kind);
            if (!oracle_can(p, b)) {
              continue;
            }
            SCOPED_TRACE(name(p) + ", b = " + std::to_string(b));
            const EnumerationOracle oracle(p, b);
            std::set<Columns> found;
            for (const Design& design : all_designs(p, b)) {
              EXPECT_TRUE(naive_verdict(design).valid);
              EXPECT_TRUE(found.insert(columns_of(design)).second);
            }
            EXPECT_EQ(found, oracle.forms());
            for (const bool reversal : {false, true}) {
              const Classification answer = classes(p, b, reversal);
              EXPECT_EQ(answer.standard_forms, oracle.forms().size());
              std::set<Columns> representatives;
              for (const DesignClass& each : answer.kept) {
                EXPECT_TRUE(representatives
                                .insert(class_of(columns_of(each.representative),
                                                 kind == Kind::circular, reversal))
                                .second);
              }
              EXPECT_EQ(answer.classes, representatives.size());
              EXPECT_EQ(representatives, oracle.classes(reversal));
            }
            ++cases;
            with_designs += oracle.forms().empty() ? 0 : 1;
          }
        }
      }
    }
  }
  EXPECT_GT(cases, 300);
  EXPECT_GT(with_designs, 50);
}

TEST(Enumeration, FindsCircularDesignsWithTwoFixedElements) {
  // {2..7}, {0,1,4..7}, {0,1,2,3,6,7}: two elements in every block, fewer blocks than the counting
  // bound.
  const Classification answer = classes(parameters(8, 6, 2, Kind::circular), 3);
  ASSERT_EQ(answer.classes, 1U);
  EXPECT_EQ(answer.kept.front().fixed, 2U);
  EXPECT_EQ(classes(parameters(9, 8, 1, Kind::circular), 3).classes, 1U);
}

struct Known {
  Parameters parameters;
  std::uint64_t b = 0;
  std::uint64_t forms = 0;
  std::uint64_t classes = 0;           // with rotation
  std::uint64_t classes_reversal = 0;  // and reversal
};

TEST(Enumeration, ReproducesTheNumbersOfTheLiteratureAndOfOtherPrograms) {
  const Kind linear = Kind::linear;
  const Kind circular = Kind::circular;
  const std::vector<Known> known{
      // Tight single-change designs [PreeceEtAl1995].
      {parameters(6, 3, 1, linear), 7, 2, 2, 1},
      {parameters(7, 3, 1, linear), 10, 32, 32, 16},
      {parameters(12, 4, 1, linear), 21, 2554, 2554, 1277},
      {parameters(6, 4, 1, linear), 4, 0, 0, 0},
      {parameters(7, 4, 1, linear), 6, 0, 0, 0},
      {parameters(9, 4, 1, linear), 11, 0, 0, 0},
      {parameters(10, 4, 1, linear), 14, 0, 0, 0},
      {parameters(12, 5, 1, linear), 15, 0, 0, 0},
      {parameters(13, 5, 1, linear), 18, 0, 0, 0},
      // Tight circular single-change designs [McSorley1999].
      {parameters(9, 4, 1, circular), 12, 16, 2, 2},
      {parameters(10, 4, 1, circular), 15, 136, 12, 6},
      // Double-change designs.
      {parameters(6, 4, 2, circular), 3, 1, 1, 1},
      {parameters(7, 3, 2, circular), 7, 30, 6, 3},
      {parameters(10, 4, 2, circular), 9, 6, 2, 1},
      {parameters(11, 4, 2, circular), 11, 2, 2, 1},
      {parameters(8, 5, 2, circular), 5, 25, 5, 4},
      {parameters(9, 6, 2, circular), 5, 35, 7, 6},
      {parameters(7, 3, 2, linear), 7, 30, 30, 15},
      {parameters(10, 4, 2, linear), 9, 14, 14, 7},
  };
  for (const Known& each : known) {
    SCOPED_TRACE(name(each.parameters));
    const Classification answer = classes(each.parameters, each.b);
    const Classification reversal = classes(each.parameters, each.b, true);
    EXPECT_EQ(all_designs(each.parameters, each.b).size(), each.forms);
    EXPECT_EQ(answer.standard_forms, each.forms);
    EXPECT_EQ(reversal.standard_forms, each.forms);
    EXPECT_EQ(answer.classes, each.classes);
    EXPECT_EQ(reversal.classes, each.classes_reversal);
  }
}

TEST(Enumeration, GroupsOfTheCircularSingleChangeDesignsAreKnown) {
  const Classification nine = classes(parameters(9, 4, 1, Kind::circular), 12);
  EXPECT_EQ(nine.group_orders, (std::map<std::string, std::uint64_t>{{"1", 1}, {"3", 1}}));
  const Classification eleven = classes(parameters(11, 4, 2, Kind::circular), 11, true);
  EXPECT_EQ(eleven.group_orders, (std::map<std::string, std::uint64_t>{{"11", 1}}));
  ASSERT_FALSE(eleven.kept.empty());
  EXPECT_EQ(eleven.kept.front().rotations, 11U);
  EXPECT_TRUE(eleven.kept.front().tight);
}

// A minimum is where designs begin: none with one block less.
TEST(Enumeration, AgreesWithKnownMinimaAlsoWherePairsAreCoveredAgain) {
  const std::vector<std::pair<Parameters, std::uint64_t>> minima{
      {parameters(8, 4, 1, Kind::linear), 9},   {parameters(9, 4, 1, Kind::linear), 12},
      {parameters(7, 4, 1, Kind::circular), 7}, {parameters(8, 4, 1, Kind::circular), 10},
      {parameters(8, 5, 1, Kind::linear), 7},   {parameters(7, 4, 2, Kind::linear), 5},
      {parameters(9, 4, 2, Kind::circular), 8}, {parameters(6, 3, 2, Kind::circular), 6},
      {parameters(10, 5, 2, Kind::linear), 7},  {parameters(6, 3, 1, Kind::circular), 8},
      {parameters(8, 3, 2, Kind::linear), 11},
  };
  for (const auto& [p, b] : minima) {
    SCOPED_TRACE(name(p));
    EXPECT_EQ(classes(p, b - 1).classes, 0U);
    RunControl control({.threads = 1});
    bool any = false;
    try {
      (void)enumerate_designs(p, b, control, [&](const Design& design) {
        any = verify(design).valid();
        throw std::out_of_range("enough");
      });
    } catch (const std::out_of_range&) {
    }
    EXPECT_TRUE(any);
  }
}

TEST(Enumeration, DoesNotDependOnTheNumberOfThreads) {
  const Parameters p = parameters(9, 3, 2, Kind::circular);
  const auto lists = [&](const std::vector<Design>& designs) {
    std::vector<std::vector<Element>> all;
    for (const Design& design : designs) {
      all.emplace_back(design.elements().begin(), design.elements().end());
    }
    return all;
  };
  const auto one = lists(all_designs(p, 12, 1));
  EXPECT_FALSE(one.empty());
  EXPECT_EQ(lists(all_designs(p, 12, 2)), one);
  EXPECT_EQ(lists(all_designs(p, 12, 5)), one);
  const Classification serial = classes(p, 12, true, 1);
  const Classification parallel = classes(p, 12, true, 3);
  EXPECT_EQ(serial.nodes, parallel.nodes);
  ASSERT_EQ(serial.classes, parallel.classes);
  for (std::size_t i = 0; i < serial.kept.size(); ++i) {
    EXPECT_TRUE(std::ranges::equal(serial.kept[i].representative.elements(),
                                   parallel.kept[i].representative.elements()));
  }
}

TEST(Enumeration, SharesOfSeveralProcessesAddUp) {
  for (const auto& [p, b] : {std::pair{parameters(10, 4, 1, Kind::circular), std::uint64_t{15}},
                             std::pair{parameters(7, 3, 1, Kind::linear), std::uint64_t{10}},
                             std::pair{parameters(5, 5, 1, Kind::linear), std::uint64_t{1}}}) {
    const Classification whole = classes(p, b);
    Classification sum;
    for (std::uint64_t i = 0; i < 3; ++i) {
      const Classification part = classes(p, b, false, 1, {.index = i, .of = 3});
      sum.standard_forms += part.standard_forms;
      sum.classes += part.classes;
      sum.nodes += part.nodes;
    }
    EXPECT_EQ(sum.standard_forms, whole.standard_forms);
    EXPECT_EQ(sum.classes, whole.classes);
    EXPECT_EQ(sum.nodes, whole.nodes);
  }
}

TEST(Enumeration, StopsWhenItIsToldToAndSaysSo) {
  const Parameters p = parameters(20, 5, 1, Kind::linear);
  const std::atomic<bool> interrupted = true;
  RunControl stopped({.threads = 2, .interrupted = &interrupted});
  EXPECT_EQ(enumerate_designs(p, 46, stopped).why_stopped, WhyStopped::interrupted);
  RunControl timed({.time = std::chrono::milliseconds(50), .threads = 2});
  EXPECT_EQ(classify_designs(p, 46, {}, timed).why_stopped, WhyStopped::time_limit);
}

TEST(Enumeration, SaysHowFarItCame) {
  const auto prefixes_done = [](const Parameters& p, std::uint64_t b, RunControl& control) {
    const Classification run = classify_designs(p, b, {}, control);
    EXPECT_GT(run.prefixes, 1U);
    EXPECT_EQ(run.prefixes_done == run.prefixes, run.why_stopped == WhyStopped::exhausted);
    return run.prefixes_done;
  };
  RunControl whole({.threads = 2});
  EXPECT_GT(prefixes_done(parameters(9, 4, 1, Kind::circular), 12, whole), 0U);
  // One share of two explores half of them.
  RunControl half({.threads = 2, .share = {.index = 1, .of = 2}});
  const Classification part = classify_designs(parameters(9, 4, 1, Kind::circular), 12, {}, half);
  EXPECT_EQ(part.prefixes_done, part.prefixes / 2);
  std::uint64_t calls = 0;
  RunControl stopped({.threads = 1});
  const EnumerationRun found =
      enumerate_designs(parameters(9, 4, 1, Kind::linear), 12, stopped, [&](const Design&) {
        if (++calls == 1000) {
          stopped.stop(WhyStopped::interrupted);
        }
      });
  EXPECT_GT(found.prefixes_done, 0U);
  EXPECT_LT(found.prefixes_done, found.prefixes);
}

TEST(Enumeration, WhatTheCallbackThrowsComesOutFromAnyThread) {
  for (const unsigned threads : {1U, 3U}) {
    RunControl control({.threads = threads});
    EXPECT_THROW((void)enumerate_designs(parameters(9, 3, 2, Kind::linear), 12, control,
                                         [](const Design&) { throw std::out_of_range("stop"); }),
                 std::out_of_range);
  }
}

TEST(Enumeration, TellsProgress) {
  std::atomic<int> told = 0;
  RunControl control({.threads = 2,
                      .on_progress =
                          [&](const Progress& progress) {
                            EXPECT_EQ(progress.unit, "nodes");
                            ++told;
                          },
                      .progress_interval = std::chrono::milliseconds(1)});
  (void)enumerate_designs(parameters(12, 4, 1, Kind::linear), 21, control);
  EXPECT_GT(told, 0);
}

TEST(Enumeration, RefusesWhatItCannotDo) {
  RunControl control(RunControl::Settings{});
  EXPECT_THROW((void)enumerate_designs(parameters(65, 4, 1, Kind::linear), 9, control),
               ImpossibleParameters);
  EXPECT_THROW((void)enumerate_designs(parameters(9, 4, 1, Kind::linear), 5000, control),
               ImpossibleParameters);
  EXPECT_THROW((void)enumerate_designs(parameters(3, 4, 1, Kind::linear), 5, control),
               ImpossibleParameters);
  Parameters triples = parameters(9, 4, 1, Kind::linear);
  triples.strength = 3;
  EXPECT_REFUSAL((void)enumerate_designs(triples, 9, control), ImpossibleParameters,
                 "enumeration supports strength 2 only; give strength 2");
}

TEST(Enumeration, StopsInTimeWhateverIsAsked) {
  for (const Parameters& p :
       {parameters(64, 32, 16, Kind::linear), parameters(64, 60, 2, Kind::circular),
        parameters(64, 8, 3, Kind::circular), parameters(40, 20, 3, Kind::linear)}) {
    for (const std::uint64_t b : {300U, 4096U}) {
      RunControl control({.time = std::chrono::milliseconds(100)});
      const auto begin = RunControl::Clock::now();
      (void)classify_designs(p, b, {}, control);
      EXPECT_LT(RunControl::Clock::now() - begin, std::chrono::seconds(10)) << name(p) << ", " << b;
    }
  }
}

TEST(Enumeration, RefusesTablesThatTheMemoryDoesNotHold) {
  RunControl control({.memory_bytes = 1'000'000});
  EXPECT_THROW((void)enumerate_designs(parameters(64, 8, 3, Kind::circular), 4096, control),
               MissingResource);
}

TEST(Enumeration, WorksUpToSixtyFourElements) {
  EXPECT_EQ(all_designs(parameters(64, 62, 1, Kind::linear), 4).size(), 0U);
  const std::size_t five = all_designs(parameters(64, 62, 1, Kind::linear), 5).size();
  EXPECT_GT(five, 0U);
  EXPECT_EQ(all_designs(parameters(63, 61, 1, Kind::linear), 5).size(), five);
  EXPECT_EQ(classes(parameters(64, 63, 1, Kind::circular), 3).classes, 1U);
  EXPECT_EQ(classes(parameters(4, 2, 2, Kind::linear), 7).classes, 0U);
}

TEST(Enumeration, SlowFindsAllTightLinearDoubleChangeDesignsOfNineElements) {
  EXPECT_EQ(all_designs(parameters(9, 3, 2, Kind::linear), 12, 2).size(), 123'912U);
  EXPECT_EQ(classes(parameters(9, 3, 2, Kind::linear), 12, true, 2).classes, 61'956U);
}

}  // namespace
}  // namespace changeover::test::enumeration_test
