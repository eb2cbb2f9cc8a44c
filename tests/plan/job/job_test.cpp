#include "changeover/plan/job.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "cheapest.hpp"
#include "message_of.hpp"
#include "random_jobs.hpp"

namespace changeover::job_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Amount units(std::uint64_t n) { return Amount{n * 1'000'000}; }

Job five() { return make_job(5, 3, units(1), units(1)); }

TEST(Job, WithoutConstraintsHasNoDefect) { EXPECT_THAT(defects(five()), IsEmpty()); }

TEST(Job, SaysWhatIsMalformed) {
  Job job = five();
  job.at_once = 1;
  EXPECT_THAT(defects(job), ElementsAre(HasSubstr("no pair can meet")));
  job = five();
  job.names[3] = "1";
  EXPECT_THAT(defects(job), ElementsAre(HasSubstr("two parts are called 1")));
  job = five();
  job.mounted = {2, 2};
  EXPECT_THAT(defects(job), testing::Contains(HasSubstr("mounted twice")));
  job = five();
  job.start = {7};
  EXPECT_THAT(defects(job), ElementsAre(HasSubstr("not in the parts list")));
  job = five();
  job.change_costs.pop_back();
  EXPECT_THAT(defects(job), ElementsAre(HasSubstr("do not fit")));
  EXPECT_THROW((void)make_job(1001, 3, units(1), units(1)), BadInput);
  EXPECT_THAT(defects(make_job(1, 2, units(1), units(1))),
              ElementsAre(HasSubstr("fewer than two")));
}

TEST(Job, SaysWhichConstraintsContradictEachOther) {
  Job job = five();
  job.never.insert(0, 1);
  EXPECT_THAT(defects(job),
              ElementsAre("1 and 2 must meet and must never be in one set-up; remove the pair "
                          "from one of the lists"));
  job.needed = all_pairs_but(job.never);
  EXPECT_THAT(defects(job), IsEmpty());

  job.mounted = {0, 1};
  EXPECT_THAT(defects(job), ElementsAre(HasSubstr("both stay mounted")));
  job.mounted = {0};
  EXPECT_THAT(defects(job), testing::Contains(HasSubstr("2 must never be in one set-up with 1")));

  job = five();
  job.mounted = {0, 1};
  EXPECT_THAT(defects(job), testing::Each(HasSubstr("no room for both")));
  EXPECT_EQ(defects(job).size(), 3U);  // the pairs within 3, 4, 5
  job.mounted = {0, 1, 2, 3};
  EXPECT_THAT(defects(job), ElementsAre(HasSubstr("4 parts stay mounted, but only 3 fit")));
  job = five();
  job.start = {0, 1, 2, 3};
  EXPECT_THAT(defects(job), ElementsAre(HasSubstr("4 parts are mounted at the start")));
  EXPECT_THROW(check(job), BadInput);

  job = make_job(12, 12, units(1), units(1));
  for (Element x = 0; x < 12; ++x) {
    job.mounted.push_back(x);
  }
  job.never = job.needed;  // 66 reasons
  EXPECT_EQ(defects(job).size(), 10U);
}

TEST(Job, HasADefectExactlyIfNoListOfSetUpsDoesIt) {
  std::uint64_t possible = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    Random random(seed);
    Job job = make_job(4 + random.below(2), 2 + random.below(2), units(1), units(1));
    for (Element x = 0; x < job.parts(); ++x) {
      for (Element y = 0; y < x; ++y) {
        if (random.below(4) == 0) {
          job.never.insert(x, y);
        }
      }
      if (random.below(5) == 0) {
        job.mounted.push_back(x);
      }
    }
    PairSet needed(job.parts());
    for (Element x = 0; x < job.parts(); ++x) {
      for (Element y = 0; y < x; ++y) {
        if (random.below(3) == 0) {
          needed.insert(x, y);
        }
      }
    }
    job.needed = needed;
    if (job.needed.size() == 0) {
      continue;
    }
    EXPECT_EQ(defects(job).empty(), test::least_cost(job).has_value()) << seed;
    possible += defects(job).empty() ? 1U : 0U;
  }
  EXPECT_GT(possible, 50U);
  EXPECT_LT(possible, 550U);
}

TEST(Job, NeedsTheRestOnceTestsAreDone) {
  Job job = five();
  mark_done(job, {{0, 1, 2}, {1, 2, 3}});
  EXPECT_EQ(job.needed.size(), 5U);
  EXPECT_FALSE(job.needed.contains(2, 3));
  EXPECT_TRUE(job.needed.contains(0, 3));
  EXPECT_THAT(job.start, ElementsAre(1, 2, 3));
  EXPECT_EQ(job.tests_done, 2U);
  Job other = five();
  other.start = {4};
  mark_done(other, {{0, 1, 2}});
  EXPECT_THAT(other.start, ElementsAre(4));
  EXPECT_REFUSAL(mark_done(other, {{0, 1}, {0, 5}}), BadInput,
                 "a test that was done names part 6 of 5; name parts that there are")
      << "there is no part 5";
  EXPECT_REFUSAL(mark_done(other, {{2, 2}}), BadInput,
                 "a test that was done has 3 twice; name each part once");
  EXPECT_EQ(other.needed.size(), 7U);
  EXPECT_EQ(other.tests_done, 1U);
}

// A place broke since: what was tested counts, and as much stays mounted as fits.
TEST(Job, TestsThatWereDoneMayBeLargerThanNewOnes) {
  Job job = five();
  job.mounted = {3};
  mark_done(job, {{0, 1, 2, 3}});
  EXPECT_EQ(job.needed.size(), 4U);
  EXPECT_THAT(job.start, ElementsAre(0, 1, 3)) << "with what stays mounted";
}

TEST(Job, HasRoomForNoMorePartsThanThereAre) {
  Job job = five();
  EXPECT_EQ(job.room(), 3U);
  job.at_once = ~std::uint64_t{0};
  EXPECT_EQ(job.room(), 5U);
  EXPECT_THAT(defects(job), IsEmpty());
}

TEST(Job, NamesThatCannotStandOnASheetAreDefects) {
  for (const std::string& name :
       {std::string("a\nb"), std::string("\x1b[2J"), std::string("a\tb"), std::string("a\0b", 3),
        std::string("\x7f"), std::string("\xff"), std::string("caf\xe9"), std::string("\xc2\x9b"),
        std::string("\xe2\x80\xae") + "abc", std::string("\xe2\x81\xa6"),
        std::string("\xe2\x80\xa8"), std::string()}) {
    Job job = five();
    job.names[2] = name;
    EXPECT_EQ(defects(job).size(), 1U) << testing::PrintToString(name);
  }
  for (const char* name : {"=1+1", "<script>", "Größe", "\xe2\x80\x8f\xd7\x90", "a b", "'\""}) {
    EXPECT_EQ(text_defect(name), std::nullopt) << name;
  }
}

TEST(Job, NeedsTheRestOfManyLargeTests) {
  Job job = make_job(130, 130, units(1), units(1));
  Block half;
  Block ends{0, 64, 129};
  for (Element x = 0; x < 65; ++x) {
    half.push_back(x);
  }
  mark_done(job, {half, ends});
  EXPECT_EQ(job.needed.size(), 130U * 129 / 2 - 65 * 64 / 2 - 2);
  EXPECT_FALSE(job.needed.contains(64, 129));
  EXPECT_FALSE(job.needed.contains(63, 64));
  EXPECT_TRUE(job.needed.contains(63, 129));
}

}  // namespace
}  // namespace changeover::job_test
