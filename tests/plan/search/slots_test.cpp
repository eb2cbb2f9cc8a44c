// Plans within slots.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "changeover/plan/run_plan.hpp"
#include "cheapest.hpp"
#include "random_jobs.hpp"

namespace changeover::slots_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Amount units(std::uint64_t n) { return Amount{n * 1'000'000}; }

// Whether a set of parts, as bits, is a set-up, in the plainest words.
bool is_setup(const Job& job, unsigned parts) {
  std::uint64_t size = 0;
  std::vector<std::uint64_t> of_slot(job.slots.size(), 0);
  for (Element x = 0; x < job.parts(); ++x) {
    const bool in = (parts >> x & 1U) != 0;
    size += in ? 1U : 0U;
    if (in && job.slot_of[x] != no_slot) {
      ++of_slot[job.slot_of[x]];
    }
    for (Element y = 0; y < x; ++y) {
      if (in && (parts >> y & 1U) != 0 && job.never.contains(x, y)) {
        return false;
      }
    }
  }
  for (const Element m : job.mounted) {
    if ((parts >> m & 1U) == 0) {
      return false;
    }
  }
  for (std::size_t s = 0; s < of_slot.size(); ++s) {
    if (of_slot[s] < job.slots[s].least || of_slot[s] > job.slots[s].most) {
      return false;
    }
  }
  return size <= job.at_once;
}

unsigned bits_of(const Block& setup) {
  unsigned bits = 0;
  for (const Element x : setup) {
    bits |= 1U << x;
  }
  return bits;
}

RunPlan planned(const Job& job, std::uint64_t steps) {
  RunControl control({.threads = 1});
  return make_run_plan(job, {.steps = steps, .design_moves = 0}, control);
}

TEST(Slots, PlansObeyThemAtTheLeastCost) {
  std::uint64_t needing = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Job job = test::random_job_with_slots(seed, 5);
    const RunPlan plan = planned(job, 10'000);
    for (const Candidate& candidate : plan.candidates) {
      for (const Block& setup : candidate.setups) {
        EXPECT_TRUE(is_setup(job, bits_of(setup))) << seed << ' ' << candidate.name;
      }
    }
    EXPECT_TRUE(plan.sheet.does_the_job());
    const auto least = test::least_cost(job);
    EXPECT_EQ(plan.sheet.cost.millionths, least) << seed;
    EXPECT_LE(plan.bound.cost.millionths, least) << seed << ' ' << plan.bound.reason;
    needing += job.slots[0].least > 0 ? 1U : 0U;
  }
  EXPECT_GT(needing, 50U);
}

TEST(Slots, BoundsAreNoMoreThanTheLeast) {
  for (std::uint64_t seed = 1000; seed <= 2500; ++seed) {
    const Job job = test::random_job_with_slots(seed, 5);
    EXPECT_LE(cost_bound(job).cost.millionths, test::least_cost(job)) << seed;
  }
}

TEST(Slots, PairsThatCannotMeetAreThoseThatNoSetUpHolds) {
  std::uint64_t apart_in_all = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Job job = test::random_job_with_slots(seed, 8);
    job.needed = all_pairs_but(job.never);
    const PairSet apart = cannot_meet(job);
    apart_in_all += apart.size();
    for (Element x = 0; x < job.parts(); ++x) {
      for (Element y = 0; y < x; ++y) {
        // What forbidden pairs alone keep apart is another defect.
        bool meet = std::any_of(job.mounted.begin(), job.mounted.end(), [&](Element m) {
          return job.never.contains(m, x) || job.never.contains(m, y);
        });
        for (unsigned bits = 0; bits < 1U << job.parts(); ++bits) {
          meet = meet || ((bits >> x & 1U) != 0 && (bits >> y & 1U) != 0 && is_setup(job, bits));
        }
        EXPECT_EQ(job.needed.contains(x, y) && !apart.contains(x, y),
                  job.needed.contains(x, y) && meet)
            << seed << ' ' << x << ' ' << y;
      }
    }
    job.needed = apart;
    EXPECT_EQ(defects(job).empty(), apart.size() == 0) << seed;
  }
  EXPECT_GT(apart_in_all, 100U);
}

// Whatever fills the slots of y and x at last stands against what is taken first, so that many
// choices fail.
TEST(Slots, WhatAloneCompletesASetUpIsFound) {
  Job job = make_job(70, 8, units(1), units(1));
  std::vector<std::string> slots = {"Y", "X", "Y", "Y", "A", "A", "A", "A", "A"};
  slots.insert(slots.end(), 30, "B");
  slots.insert(slots.end(), 30, "C");
  slots.emplace_back("Z");
  set_slots(job, slots, parse_slots("Y=1, X=1, A=1, B=2, C=2, Z=1"));
  for (const Element bad : {4U, 5U, 6U}) {
    for (const Element other : {69U, 0U, 2U}) {
      job.never.insert(other, bad);
    }
  }
  job.never.insert(2, 7);
  job.never.insert(3, 8);
  job.needed = PairSet(70);
  for (const Element y : {0U, 2U, 3U}) {
    job.needed.insert(y, 1);
  }
  EXPECT_EQ(cannot_meet(job).size(), 0U);
  EXPECT_TRUE(planned(job, 1'000).sheet.does_the_job());
}

// Ten of nine kinds, of which no two parts can be together: too many choices fail to look at all.
TEST(Slots, WhereTooManyChoicesFailThisIsSaid) {
  Job job = make_job(65, 12, units(1), units(1));
  std::vector<std::string> slots(63, "A");
  slots.resize(65);
  set_slots(job, slots, parse_slots("A=10"));
  for (Element x = 0; x < 63; ++x) {
    for (Element y = 0; y < x; ++y) {
      if (x % 9 == y % 9) {
        job.never.insert(x, y);
      }
    }
  }
  job.needed = PairSet(65);
  job.needed.insert(63, 64);
  EXPECT_THAT(defects(job), ElementsAre(HasSubstr("found among 100,000 choices")));
}

TEST(Slots, AJobThatWasCheckedHasTheSamePlan) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Job job = test::random_job_with_slots(seed, 7);
    RunControl control({.threads = 1});
    const RunPlan plan = make_run_plan(job, {.steps = 2'000}, control);
    RunControl another({.threads = 1});
    const RunPlan same = make_run_plan(CheckedJob(job), {.steps = 2'000}, another);
    EXPECT_EQ(same.candidates.front().setups, plan.candidates.front().setups) << seed;
    EXPECT_EQ(same.bound.cost, plan.bound.cost) << seed;
  }
}

// Three processors and two power supplies, exactly one of each in a set-up, and eight disks, two to
// four.
Job server() {
  Job job = make_job(13, 6, units(5), units(1));
  std::vector<std::string> slots(3, "CPU");
  slots.insert(slots.end(), 2, "PSU");
  slots.insert(slots.end(), 8, "disk");
  set_slots(job, slots, parse_slots("CPU=1, PSU=1, disk=2..4"));
  return job;
}

TEST(Slots, OfAServer) {
  Job job = server();
  const PairSet apart = cannot_meet(job);
  EXPECT_EQ(apart.size(), 4U);  // three of processors, one of power supplies
  EXPECT_TRUE(apart.contains(0, 1) && apart.contains(3, 4));
  EXPECT_FALSE(defects(job).empty());
  drop_needed(job, apart);
  EXPECT_THAT(defects(job), IsEmpty());
  const CostBound bound = cost_bound(job);
  EXPECT_EQ(bound.tests, 6U)
      << "each of 8 disks meets 3 processors, 4 at once; so do 2 power supplies";
  const RunPlan plan = planned(job, 100'000);
  for (const Block& setup : plan.candidates.front().setups) {
    EXPECT_TRUE(is_setup(job, bits_of(setup)));
  }
  EXPECT_TRUE(plan.sheet.does_the_job());
}

TEST(Slots, TheRefereeCountsThem) {
  Job job = server();
  drop_needed(job, cannot_meet(job));
  EXPECT_THAT(run_sheet(job, {{0, 3, 5, 6}}).faults, IsEmpty());
  EXPECT_THAT(run_sheet(job, {{0, 3, 5}}).faults,
              ElementsAre("set-up 1 has 1 part of slot disk, not 2 to 4"));
  EXPECT_THAT(run_sheet(job, {{0, 3, 5, 6}, {3, 5, 6}}).faults,
              ElementsAre(HasSubstr("set-up 2 has 0 parts of slot CPU")));
  EXPECT_THAT(run_sheet(job, {{0, 1, 3, 5, 6}}).faults,
              ElementsAre(HasSubstr("2 parts of slot CPU")));
}

TEST(Slots, WhatCannotBeIsOneLine) {
  const auto says = [](const std::string& slots, const Block& mounted = {}) {
    Job job = server();
    job.slots = parse_slots(slots);
    job.mounted = mounted;
    drop_needed(job, cannot_meet(job));
    const auto found = defects(job);
    return found.empty() ? "no defect" : found.front();
  };
  EXPECT_EQ(says("CPU=1, PSU=1, disk=2..4"), "no defect");
  EXPECT_THAT(says("CPU=1, PSU=1, disk=5..8"),
              HasSubstr("need 7 parts in every set-up, but only 6"));
  EXPECT_THAT(says("CPU=4, PSU=1, disk=1"),
              HasSubstr("slot 'CPU' needs 4 parts in every set-up, but only 3"));
  EXPECT_THROW((void)parse_slots("CPU=2..1, PSU=1, disk=1"), BadInput);
  EXPECT_THAT(says("CPU=1, PSU=1, disk=2..4", {0, 1}),
              HasSubstr("2 parts of slot 'CPU' stay mounted"));
  EXPECT_THAT(says("CPU=1, PSU=1, disk=4", {5, 6, 7, 8}), "no defect");
  Job job = server();
  EXPECT_THROW(set_slots(job, {"CPU"}, parse_slots("CPU=1")), BadInput);
  EXPECT_THROW(set_slots(job, std::vector<std::string>(13, "GPU"), parse_slots("CPU=1")), BadInput);
  job.slots.push_back({"GPU", 0, 1});
  EXPECT_THAT(defects(job), ElementsAre(HasSubstr("no part is in slot 'GPU'")));
  job.slots.pop_back();
  job.slot_of.pop_back();
  EXPECT_THAT(defects(job), ElementsAre(HasSubstr("do not fit the parts")));
}

TEST(Slots, AreRead) {
  const auto read = [](const std::string& text) {
    return read_slots(*input_from_text(text, "s.csv"));
  };
  const auto says = [&](const std::string& text) -> std::string {
    try {
      return "read " + std::to_string(read(text).size());
    } catch (const BadInput& fault) {
      return fault.what();
    }
  };
  const std::vector<Slot> slots = read("slot;least;most\nCPU;1;1\ndisk;2;\nfan;;3\n");
  ASSERT_EQ(slots.size(), 3U);
  EXPECT_EQ(slots[0].name, "CPU");
  EXPECT_EQ(slots[0].most, 1U);
  EXPECT_EQ(slots[1].least, 2U);
  EXPECT_EQ(slots[1].most, Slot{}.most);
  EXPECT_EQ(slots[2].least, 0U);
  EXPECT_EQ(says("CPU,one,1\n"),
            "s.csv:1:5: 'one' is not a number of parts; write a number, as in CPU,1,1");
  EXPECT_THAT(says("CPU,1,-1\n"), HasSubstr("s.csv:1:7: '-1' is not a number"));
  EXPECT_THAT(says("CPU,1,1\nCPU,1,1\n"), HasSubstr("s.csv:2:1: 'CPU' occurs twice"));
  EXPECT_THAT(says("CPU\n"), HasSubstr("s.csv:1:1: expected a slot with its least"));
  EXPECT_THAT(says(""), HasSubstr("no slot is listed"));
  for (const char* text : {"CPU", "=1", "CPU=", "CPU=..", "CPU=1..x", "CPU=1,CPU=2", "CPU=-1"}) {
    EXPECT_THROW((void)parse_slots(text), BadInput) << text;
  }
  EXPECT_EQ(parse_slots("a=b=..2").front().name, "a=b");
}

TEST(Slots, ABudgetAndTheRestObeyThem) {
  Job job = server();
  drop_needed(job, cannot_meet(job));
  RunControl control({.threads = 1});
  const RunPlan some =
      make_run_plan(job, {.steps = 20'000, .budget = units(40), .design_moves = 0}, control);
  EXPECT_LE(some.sheet.cost, units(40));
  EXPECT_THAT(some.sheet.faults, IsEmpty());
  Job rest = job;
  mark_done(rest,
            {some.candidates.front().setups.begin(), some.candidates.front().setups.begin() + 2});
  const RunPlan other = planned(rest, 20'000);
  EXPECT_TRUE(other.sheet.does_the_job());
  RunControl again({.threads = 1});
  for (const WhatIf::Range& range :
       what_if(job, planned(job, 20'000), {.steps = 20'000}, again).ranges) {
    EXPECT_TRUE(run_sheet(job, range.plan.setups).does_the_job());
  }
}

}  // namespace
}  // namespace changeover::slots_test
