// What changeover plan says of its plans where options meet: strength 3 with tests that come first
// or failed, weights, budgets on benches, single units.
#include <gmock/gmock.h>

#include "cases.hpp"

namespace changeover::test::plan_words_test {
namespace {

const std::string fast = " --quiet --threads 1 --steps 20000";

TEST(PlanWords, OfTriplesAlsoWhereNoneIsLeft) {
  const TemporaryFolder folder;
  spit(folder.file("first.csv"), "1,2,3\n");
  spit(folder.file("done.csv"), "slot_1,slot_2,slot_3,slot_4,result\n1,2,3,4,fail\n");
  const std::string first =
      "$changeover plan --items 5 -k 3 --test-cost 1 --change-cost 1 --strength 3 "
      "--first first.csv" +
      fast;
  const std::string done =
      "$changeover plan --items 4 -k 4 --test-cost 1 --change-cost 1 --strength 3 --done done.csv "
      "--trust-failed" +
      fast;
  expect({{first, 0, "the first test is given: cost 4, 1 of the needed triples\n"},
          {done, 0, "0 of 0 needed triples tested"},
          {done, 0, "4 triples met only in tests that failed"},
          {done, 0, "no plan for all triples is cheaper"},
          {done + " --benches 2", 0, "0 of 0 needed triples tested"}},
         folder);
}

TEST(PlanWords, OfWeightsAndBudgets) {
  const TemporaryFolder folder;
  spit(folder.file("first.csv"), "1,2,3\n");
  spit(folder.file("heavy.csv"), "1,2,5\n");
  spit(folder.file("none.csv"), "1,2,0\n");
  spit(folder.file("pair.csv"), "1,2\n");
  const std::string plan = "$changeover plan --test-cost 1 --change-cost 1" + fast;
  const std::string all = plan + " --items 4 -k 3 --priority heavy.csv --budget 100 --benches 2";
  expect({{plan + " --items 5 -k 3 --first first.csv --budget 4", 0, "best: the first tests\n"},
          {all, 0, "weight of the pairs tested: 10 of 10\n"},
          {plan + " --items 3 -k 2 --priority none.csv --pairs pair.csv", 0,
           "no needed pair weighs anything\n"}},
         folder);
}

// One bench can test E and F for 4; the search for all pairs leaves time for that.
TEST(PlanWords, BenchesSpendABudgetWithinTheTime) {
  const TemporaryFolder folder;
  spit(folder.file("parts.csv"), "name,cost\nA,40\nB,30\nC,20\nD,30\nE,1\nF,1\n");
  expect({{"$changeover plan parts.csv -k 3 --test-cost 2 --budget 5 --benches 2 --threads 1 "
           "--time 2 --quiet",
           0, "on 2 benches: 1 test, 2 changes\n"}},
         folder);
}

TEST(PlanWords, BoundsAfterFirstTestsSayWhatTheseCost) {
  const TemporaryFolder folder;
  spit(folder.file("first.csv"), "1,2,3\n");
  const std::string plan =
      "$changeover plan --items 5 -k 3 --test-cost 1 --change-cost 1 --first first.csv "
      "--benches 2" +
      fast;
  expect({{plan, 0, "each bench: the first set-ups cost 8; after them, "}}, folder);
}

TEST(PlanWords, OneHourIsNotHours) {
  const TemporaryFolder folder;
  const std::string plan = "$changeover plan --items 2 -k 2 --test-cost 1 --change-cost 0" + fast;
  expect({{plan + " --benches 1 --hours 8", 0,
           "done on day 1 after 1 hour; 1 hour of work together\n"},
          {plan + " --cost-unit hours", 0, "2 changes, cost 1 hour, 1:00 on the clock\n"},
          {plan + " --cost-unit minutes", 0, "cost 1 minute, 0:01 on the clock\n"}},
         folder);
}

}  // namespace
}  // namespace changeover::test::plan_words_test
