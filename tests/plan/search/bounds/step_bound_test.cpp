// The bound by steps and slots [docs/theorems.md, Theorem 18]: no list costs less, whatever the
// prices are.
#include "plan/search/bounds/step_bound.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>

#include "changeover/run/control.hpp"
#include "cheapest.hpp"
#include "plan/search/exact_plan.hpp"
#include "random_jobs.hpp"

namespace changeover::step_bound_test {
namespace {

constexpr std::uint64_t money = 1'000'000;

// The bound by steps alone, with no more known than that there is a test.
Amount by_steps(const Job& job) {
  CostBound bound;
  bound.tests = 1;
  raise_by_steps(job, "at least 1 test", bound);
  return bound.cost;
}

// A job with slots, at random, of so many parts; some with forbidden pairs, a start, mounted parts,
// little room.
Job slotted_job(std::uint64_t seed, std::uint64_t number, std::uint64_t kinds) {
  const auto parts = static_cast<std::uint32_t>(number);
  const auto slots = static_cast<std::uint32_t>(kinds);
  for (std::uint64_t stream = 0;; ++stream) {
    Random random(seed, 500 + stream);
    Job job = make_job(parts, parts, Amount{random.below(8) * money}, Amount{});
    for (std::uint32_t s = 0; s < slots; ++s) {
      const std::uint64_t most = 1 + random.below(3);
      job.slots.push_back(
          {"s" + std::to_string(s), random.below(static_cast<std::uint32_t>(most) + 1), most});
    }
    std::uint64_t room = 0;
    for (const Slot& slot : job.slots) {
      room += slot.most;
    }
    const bool some_in_none = random.below(4) == 0;
    for (Element x = 0; x < parts; ++x) {
      const std::uint32_t slot = random.below(slots + (some_in_none ? 1 : 0));
      job.slot_of.push_back(slot == slots ? no_slot : slot);
      job.change_costs[x] = Amount{(1 + random.below(12)) * money / 2};
    }
    job.at_once = room - (random.below(3) == 0 && room > 3 ? 1 : 0) + (some_in_none ? 1 : 0);
    if (random.one_in_two()) {
      for (std::uint32_t i = random.below(parts); i > 0; --i) {
        const std::uint32_t x = random.below(parts);
        const std::uint32_t y = random.below(parts);
        if (x != y) {
          job.never.insert(x, y);
        }
      }
      job.needed = all_pairs_but(job.never);
    }
    for (Element x = 0; x < parts; ++x) {
      if (random.below(20) == 0) {
        job.mounted.push_back(x);
      } else if (random.below(8) == 0 && job.start.size() < job.at_once) {
        job.start.push_back(x);
      }
    }
    if (!defects(job).empty()) {
      drop_needed(job, cannot_meet(job));
    }
    if (defects(job).empty() && job.needed.size() > 0) {
      return job;
    }
  }
}

TEST(StepBound, IsNoMoreThanTheLeastOfSmallJobs) {
  std::uint64_t attained = 0;
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    const Job job =
        seed % 3 == 0 ? test::random_job(seed, 5) : test::random_job_with_slots(seed, 5);
    const std::uint64_t least = test::least_cost(job).value();
    EXPECT_LE(by_steps(job).millionths, least) << seed;
    attained += by_steps(job).millionths == least ? 1U : 0U;
  }
  EXPECT_GT(attained, 600U);
}

struct Looked {
  std::uint64_t through = 0;   // jobs whose least cost is known
  std::uint64_t attained = 0;  // of them those where it is the bound
};

// Jobs of small size of these seeds: no bound may be above the least cost of all lists.
Looked look_through(std::uint64_t seeds, const std::function<Job(std::uint64_t seed)>& make) {
  Looked looked;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Job job = make(seed);
    if (!defects(job).empty() || !is_small(job)) {
      continue;
    }
    RunControl control({.threads = 1});
    RunPlan plan = make_run_plan(job, {.steps = 5'000, .design_moves = 0, .states = 0}, control);
    const ExactPlan exact = exact_plan(job, plan.sheet.cost, 100'000, control);
    if (!exact.setups && exact.bound < plan.sheet.cost) {
      continue;  // That took too long.
    }
    const Amount least = exact.setups ? run_sheet(job, *exact.setups).cost : plan.sheet.cost;
    EXPECT_LE(by_steps(job), least) << seed;
    ++looked.through;
    looked.attained += by_steps(job) == least ? 1U : 0U;
  }
  return looked;
}

TEST(StepBound, IsNoMoreThanWhatAllListsAreLookedThroughFor) {
  const Looked looked = look_through(
      120, [](std::uint64_t seed) { return slotted_job(seed, 6 + seed % 4, 2 + seed % 3); });
  EXPECT_GT(looked.through, 60U);
  EXPECT_GT(looked.attained, 15U);
}

// Slots of one place with a few parts each.
Job one_each_job(std::uint64_t seed) {
  Random random(seed, 900);
  const std::uint32_t slots = 3 + random.below(2);
  Job job = make_job(2 * slots + random.below(slots == 3 ? 4 : 2), slots,
                     Amount{random.below(3) * money}, Amount{});
  for (std::uint32_t s = 0; s < slots; ++s) {
    job.slots.push_back({"s" + std::to_string(s), 1, 1});
  }
  for (Element x = 0; x < job.parts(); ++x) {
    job.slot_of.push_back(x < 2 * slots ? x % slots : random.below(slots));
    job.change_costs[x] = Amount{(random.below(3) == 0 ? 10 : 1) * money};
  }
  for (std::uint32_t i = random.below(4); i > 0; --i) {
    const Element x = random.below(slots);
    const Element y = (x + 1) % slots + slots * random.below(2);
    job.never.insert(x, y);
  }
  job.needed = all_pairs_but(job.never);
  drop_needed(job, cannot_meet(job));
  return job;
}

// Jobs for which the linear program says less than it does with whole numbers of times: 118, 59.5,
// 47.5, 57, 56, 104.5 and 73.5. The plans that a search finds cost no less.
TEST(StepBound, LetsPartsComeAWholeNumberOfTimes) {
  struct Raised {
    std::uint64_t seed;
    const char* bound;
  };
  for (const auto& [seed, bound] : std::initializer_list<Raised>{{111, "118.5"},
                                                                 {114, "61"},
                                                                 {117, "48"},
                                                                 {135, "57.5"},
                                                                 {187, "56.5"},
                                                                 {315, "105.5"},
                                                                 {399, "74"}}) {
    const Job job = slotted_job(seed, 6 + seed % 4, 2 + seed % 3);
    EXPECT_GE(by_steps(job), parse_amount(bound)) << seed;
    RunControl control({.threads = 1});
    const RunPlan plan =
        make_run_plan(job, {.steps = 20'000, .design_moves = 0, .states = 0}, control);
    EXPECT_LE(by_steps(job), plan.sheet.cost) << seed;
  }
}

// (6) of the theorem counts the parts of several slots together.
TEST(StepBound, IsNoMoreThanTheLeastWhereSlotsHaveOnePlace) {
  const Looked looked = look_through(150, one_each_job);
  EXPECT_GT(looked.through, 100U);
  EXPECT_GT(looked.attained, 50U);
}

TEST(StepBound, CountsTwoPartsOfManySlots) {
  for (std::uint32_t slots = 2; slots <= 6; ++slots) {
    Job job = make_job(2 * slots, slots, Amount{}, Amount{money});
    for (std::uint32_t s = 0; s < slots; ++s) {
      job.slots.push_back({"s" + std::to_string(s), 1, 1});
    }
    for (Element x = 0; x < job.parts(); ++x) {
      job.slot_of.push_back(x / 2);
    }
    drop_needed(job, cannot_meet(job));
    EXPECT_EQ(to_string(by_steps(job)), std::to_string(3 * slots - 1));
    RunControl control({.threads = 1});
    EXPECT_EQ(to_string(make_run_plan(job, {}, control).sheet.cost), std::to_string(3 * slots - 1));
  }
}

// Any list that does the job costs at least the bound, at prices for which it is as cheap as can
// be: parts that it puts in often cost little, others much.
TEST(StepBound, HoldsForEveryListAtEveryPrice) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Job job = seed % 4 == 0 ? make_job(8 + seed % 9, 3 + seed % 4, Amount{}, Amount{money})
                            : slotted_job(seed, 10 + seed % 15, 2 + seed % 5);
    RunControl control({.threads = 1});
    const RunPlan plan =
        make_run_plan(job, {.steps = 20'000, .design_moves = 0, .states = 0}, control);
    ASSERT_TRUE(plan.sheet.does_the_job());
    std::vector<std::uint64_t> times(job.names.size(), 0);
    std::vector<bool> before(job.names.size(), false);
    for (const Element x : job.start) {
      before[x] = true;
    }
    for (const Block& setup : plan.candidates.front().setups) {
      std::vector<bool> now(job.names.size(), false);
      for (const Element x : setup) {
        now[x] = true;
        times[x] += before[x] ? 0U : 1U;
      }
      before = now;
    }
    Random random(seed);
    for (std::uint32_t power = 0; power < 5; ++power) {
      for (Element x = 0; x < job.parts(); ++x) {
        std::uint64_t price = 64 * money;
        for (std::uint32_t i = 0; i < power; ++i) {
          price /= 1 + times[x];
        }
        job.change_costs[x] = Amount{price * (4 + random.below(2)) / 4};
      }
      for (const std::uint64_t test : {0U, 1U, 30U}) {
        job.test_cost = Amount{test * money};
        const Amount cost = run_sheet(job, plan.candidates.front().setups).cost;
        EXPECT_LE(cost_bound(job).cost, cost) << seed << ' ' << power << ' ' << test;
      }
    }
  }
}

// Nine values of which three by three must meet, one of each a test: an orthogonal array tests all
// in nine tests, and each of its steps changes two or three.
TEST(StepBound, KnowsThatAFewTestsChangeMoreEach) {
  Job job = make_job(9, 3, Amount{100 * money}, Amount{money});
  set_slots(job, {"A", "A", "A", "B", "B", "B", "C", "C", "C"}, parse_slots("A=1, B=1, C=1"));
  drop_needed(job, cannot_meet(job));
  EXPECT_EQ(cost_bound(job).cost, Amount{(900 + 3 + 16) * money});
  job.test_cost = Amount{};
  // One change a test is cheaper then; 15 changes would do if each brought two pairs, which no walk
  // of 12 does (Theorem 28).
  EXPECT_EQ(cost_bound(job).cost, Amount{16 * money});
}

TEST(StepBound, IsWeakerButTrueWhenItIsStopped) {
  std::atomic<bool> interrupted = true;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Job job = slotted_job(seed, 20, 4);
    const Amount whole = by_steps(job);
    RunControl control({.interrupted = &interrupted});
    const RunScope scope(control);
    EXPECT_LE(by_steps(job), whole) << seed;
  }
}

}  // namespace
}  // namespace changeover::step_bound_test
