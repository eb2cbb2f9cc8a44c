// changeover plan where costs depend on what is replaced.
#include "../cases.hpp"

namespace changeover::test::replaced_test {
namespace {

const std::string fast = " --quiet --threads 1 --steps 20000";

TEST(PlanReplaced, TakesCostsByWhatIsReplaced) {
  const TemporaryFolder folder;
  spit(folder.file("paints.csv"), "paint,price\nRed,6\nBlue,5\nWhite,12\nBlack,1\n");
  spit(folder.file("costs.csv"),
       ",Red,Blue,White,Black\nRed,,2,8,1\nBlue,3,,9,1\nWhite,1,1,,1\nBlack,6,5,12,\n");
  spit(folder.file("three.csv"), ",Red,Blue,White\nRed,,2,8\nBlue,3,,9\nWhite,1,1,\n");
  spit(folder.file("below.csv"), ",Red,Blue,White,Black\nRed,,-2,8,1\n");
  spit(folder.file("first.csv"), "Red,Black\n");
  spit(folder.file("failed.csv"), "slot_1,slot_2,result\nRed,Black,fail\n");
  spit(folder.file("heavy.csv"), "Red,Black,5\n");
  const auto plan = [](const std::string& rest) {
    return "$changeover plan paints.csv -k 2 --test-cost 1 --change-costs costs.csv " + rest + fast;
  };
  const std::string other = "$changeover plan paints.csv -k 2 --test-cost 1" + fast;
  expect({{plan(""), 0, "6 of 6 needed pairs tested, checked by an independent count"},
          {plan(""), 0, "Red for White"},
          {plan(""), 0, "new pairs  cost  cost so far"},
          {plan("--json"), 0, "\"replaced\":[[\"White\",\"Red\"]]"},
          {plan("--json"), 0, "\"replace_costs\":[[null,2,8,1],[3,null,9,1]"},
          {plan("--format markdown"), 0, "| new pairs | cost | cost so far |"},
          {plan("--format html"), 0, "<span class=\"part\">Red for White</span>"},
          {plan("--budget 18"), 0, "budget 18: testing all pairs would cost"},
          {plan("--first first.csv"), 0, "the first test is given: cost 8"},
          {plan("--done first.csv"), 0, "after 1 test done"},
          {plan("--benches 2"), 0, "of 6 needed pairs tested on some bench"},
          {plan("--benches 2 --json"), 0, "\"replaced\":[["},
          {plan("--shuffle 1"), 2, "--shuffle SEED has no meaning with --change-costs"},
          {plan("--what-if"), 0, "Your costs are at the factor"},
          {plan("--priority heavy.csv"), 2, "--priority FILE has no meaning with --change-costs"},
          {"$changeover plan paints.csv -k 2 --test-cost 1 --change-costs costs.csv --quiet "
           "--done failed.csv --diagnose",
           0, "Next test, cost "},
          {other + " --change-costs three.csv", 3, "three.csv:1:1: no column for 'Black'; give"},
          {other + " --change-costs below.csv", 3, "below.csv:2:6: "}},
         folder);
}

}  // namespace
}  // namespace changeover::test::replaced_test
