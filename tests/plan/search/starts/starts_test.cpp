#include "plan/search/starts/starts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>

#include "changeover/plan/run_plan.hpp"
#include "plan/search/anneal/attempts.hpp"
#include "plan/search/candidates.hpp"
#include "random_jobs.hpp"

namespace changeover::starts_test {
namespace {

Job job_with_costly_parts(Element parts, std::uint64_t at_once) {
  Job job = make_job(parts, at_once, parse_amount("5"), Amount{});
  for (Element x = 0; x < parts; ++x) {
    job.change_costs[x] = x % 2 == 0 ? parse_amount("0.5") : parse_amount("9.5");
  }
  return job;
}

TEST(GreedyStart, DoesEveryJob) {
  RunControl control({});
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Job job = test::random_job(seed, 9);
    EXPECT_TRUE(run_sheet(job, greedy_start(job, control).setups).does_the_job()) << seed;
  }
}

TEST(GreedyStart, DoesEveryJobInHaste) {
  std::atomic<bool> interrupted = true;
  RunControl control({.interrupted = &interrupted});
  int hasty = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    for (const Job& job : {test::random_job(seed, 60), test::random_job_with_slots(seed, 60)}) {
      const Start start = greedy_start(job, control);
      EXPECT_TRUE(run_sheet(job, start.setups).does_the_job()) << seed;
      hasty += start.how.find("any that test some") != std::string::npos ? 1 : 0;
    }
  }
  EXPECT_GT(hasty, 200);  // Small jobs end before the control is asked.
}

TEST(GreedyStart, InHasteKeepsApartWhatMustNotMeet) {
  std::atomic<bool> interrupted = true;
  RunControl control({.interrupted = &interrupted});
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Job job = make_job(50, 3, parse_amount("1"), parse_amount("1"));
    Random random(seed, 0);
    for (Element y = 1; y < job.parts(); ++y) {
      for (Element x = 0; x < y; ++x) {
        if (random.below(3) == 0) {
          job.never.insert(x, y);
        }
      }
    }
    job.needed = all_pairs_but(job.never);
    const Start start = greedy_start(job, control);
    EXPECT_TRUE(run_sheet(job, start.setups).does_the_job()) << seed;
    EXPECT_LT(start.setups.size(), job.needed.size()) << seed;  // most have a third part
  }
}

// All but the last of a part do.
TEST(GreedyStart, InHasteSmallSetUpsStillTestTwoNewPairsEach) {
  std::atomic<bool> interrupted = true;
  RunControl control({.interrupted = &interrupted});
  for (const Element parts : {40U, 41U, 100U, 300U}) {
    const Job job = make_job(parts, 3, parse_amount("1"), parse_amount("1"));
    const std::size_t steps = greedy_start(job, control).setups.size();
    EXPECT_LE(2 * steps, job.needed.size() + parts) << parts;
  }
}

TEST(GreedyStart, PutsInCheapPartsMoreOftenThanCostlyOnes) {
  const Job job = job_with_costly_parts(40, 6);
  RunControl control({});
  const RunSheet sheet = run_sheet(job, greedy_start(job, control).setups);
  std::array<std::uint64_t, 2> times{};
  for (const auto& step : sheet.steps) {
    for (const Element x : step.put_in) {
      ++times.at(x % 2);
    }
  }
  EXPECT_GT(times[0], 2 * times[1]) << times[0] << " and " << times[1];
}

// Free parts are worth much, but not everything.
TEST(GreedyStart, DoesJobsWithFreeParts) {
  Job job = job_with_costly_parts(20, 4);
  for (Element x = 0; x < 20; x += 2) {
    job.change_costs[x] = Amount{};
  }
  RunControl control({});
  EXPECT_TRUE(run_sheet(job, greedy_start(job, control).setups).does_the_job());
  job.change_costs.assign(20, Amount{});
  EXPECT_TRUE(run_sheet(job, greedy_start(job, control).setups).does_the_job());
}

// All known designs come before the searches for better ones, which take all the time there is.
TEST(DesignStarts, AreAllThereWhateverTheSearchesTake) {
  const Job job = job_with_costly_parts(20, 4);
  RunControl no_limit({});
  const std::vector<Start> known = design_starts(job, 0, no_limit);
  ASSERT_EQ(known.size(), 4U);  // 1 to 4 changes a step
  constexpr std::uint64_t endless = std::uint64_t{1} << 50U;
  RunControl short_time({.time = std::chrono::seconds(2), .threads = 1});
  EXPECT_EQ(design_starts(job, endless, short_time).size(), known.size());
}

TEST(DesignStarts, SearchesMakeNoneDearer) {
  bool any_better = false;
  for (const std::uint64_t room : {5U, 6U, 7U}) {
    const Job job = job_with_costly_parts(34, room);
    RunControl control({});
    std::vector<Start> known = design_starts(job, 0, control);
    const std::vector<Start> searched = design_starts(job, 200'000, control);
    ASSERT_EQ(searched.size(), known.size());
    for (const Start& start : searched) {
      const auto before = std::find_if(
          known.begin(), known.end(), [&](const Start& other) { return other.name == start.name; });
      ASSERT_NE(before, known.end()) << start.name;
      const RunSheet sheet = run_sheet(job, start.setups);
      EXPECT_TRUE(sheet.does_the_job()) << start.how;
      const Amount cost = run_sheet(job, before->setups).cost;
      EXPECT_LE(sheet.cost, cost) << start.how;
      any_better = any_better || sheet.cost < cost;
      known.erase(before);
    }
  }
  EXPECT_TRUE(any_better);
}

// The search for a covering leaves the time to the search for a cheap list.
TEST(Covering, IsLeftOutWhereTimeIsShort) {
  const Job job = job_with_costly_parts(40, 6);
  RunControl no_limit({});
  const Candidate greedy = counted_complete(job, greedy_start(job, no_limit));
  const CostBound bound = cost_bound(job);
  const auto found = Attempts(job, bound, no_limit).covering(greedy, 100'000);
  ASSERT_TRUE(found);
  EXPECT_TRUE(run_sheet(job, found->setups).does_the_job());
  EXPECT_LT(found->setups.size(), greedy.setups.size());
  RunControl hardly_any({.time = std::chrono::microseconds(1)});
  EXPECT_FALSE(Attempts(job, bound, hardly_any).covering(greedy, 100'000));
}

}  // namespace
}  // namespace changeover::starts_test
