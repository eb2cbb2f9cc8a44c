// changeover classify and changeover same, as their users see them.
#include "cases.hpp"

namespace changeover::test::classify_test {
namespace {

TEST(Classify, CountsTheStandardFormsOfTheLiterature) {
  const TemporaryFolder folder;
  expect({{"$changeover classify 12 4 21 --change 1 --json", 0,
           "\"complete\":true,\"stopped\":\"exhausted\",\"reason\":null,\"standard_forms\":2554,"
           "\"classes\":2554"},
          // If the number of blocks is not given, the lower bound.
          {"$changeover classify 8 5 --circular --reversal --json", 0,
           "\"b\":5,\"reversal\":true,\"complete\":true,\"stopped\":\"exhausted\",\"reason\":null,"
           "\"standard_forms\":25,\"classes\":4"},
          // As in the bounds.
          {"$changeover classify 9 4 12 --change 1 --circular --json", 0,
           "\"groups\":[{\"order\":1,\"classes\":1},{\"order\":3,\"classes\":1}]"}},
         folder);
}

TEST(Classify, TellsTheTwoCircularDesignsOfNineElementsApart) {
  const TemporaryFolder folder;
  const std::string nine = "$changeover classify 9 4 12 --change 1 --circular";
  expect({{nine, 0, "16 standard forms in 2 classes up to relabelling and rotation, 2 tight"},
          {nine, 0, "group order 3 with 3 rotations, tight, economical"},
          {nine, 0, "group order 1: 1 class\n"}},
         folder);
}

TEST(Classify, SaysWhenALimitStoppedItAndWhyThereIsNone) {
  const TemporaryFolder folder;
  expect({{"$changeover classify 20 5 46 --change 1 --time 100ms --quiet", 30,
           "NOT ALL: stopped (time limit)"},
          {"$changeover classify 4 2 9", 0, "none, for "},
          {"$changeover classify 4 2 9 --json", 0, "\"standard_forms\":0,\"classes\":0"}},
         folder);
}

TEST(Classify, ShowsAllClassesInAFileThatAppearsWhole) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run("$changeover classify 10 4 15 --change 1 --circular --designs -o all.json --json",
          folder.path());
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(count(slurp(folder.file("all.json")), "\"blocks\""), 12U);
}

TEST(Classify, GivesTheSameAnswerWithOneThreadAndThree) {
  const TemporaryFolder folder;
  const std::string cut = " --circular --change 1 --designs | grep -v nodes";
  const Outcome one = run("$changeover classify 10 4 15 --threads 1" + cut, folder.path());
  const Outcome three = run("$changeover classify 10 4 15 --threads 3" + cut, folder.path());
  EXPECT_EQ(one.out, three.out);
  EXPECT_EQ(count(one.out, "12 classes"), 1U) << one.out;
}

TEST(Same, FindsTheMapBetweenRenamedAndRotatedDesigns) {
  const TemporaryFolder folder;
  spit(folder.file("a"),
       "# changeover design v=6 k=4 change=2 kind=circular\n0 1 2 3\n4 5 2 3\n4 5 0 1\n");
  spit(folder.file("b"),
       "# changeover design v=6 k=4 change=2 kind=circular\na b e f\na b c d\nc d e f\n");
  expect({{"$changeover same a b", 0, "the same: circular DCCD(6,4), 3 blocks\n"},
          {"$changeover same a b", 0, "0 -> "},
          {"$changeover same a b", 0, "automorphisms: 24\n"},
          {"$changeover same a b --reversal --json", 0, "{\"same\":true,"},
          {"$changeover same a b --reversal --json", 0, "\"group_order\":\"48\""}},
         folder);
}

TEST(Same, TellsOtherDesignsApartAndSaysHowTheyDiffer) {
  const TemporaryFolder folder;
  spit(folder.file("a"), "# changeover design v=5 k=2 change=1 kind=linear\n0 1\n1 2\n2 3\n3 4\n");
  spit(folder.file("b"), "# changeover design v=5 k=2 change=1 kind=linear\n1 2\n0 1\n2 3\n3 4\n");
  spit(folder.file("c"), "# changeover design v=5 k=2 change=1 kind=linear\n0 1\n1 2\n2 3\n");
  spit(folder.file("d"), "# changeover design v=5 k=2 change=1 kind=linear\n0 1\n1 2\n2 0\n3 4\n");
  expect({{"$changeover same a b", 1, "without their order the blocks are the same"},
          {"$changeover same a c", 1, "4 blocks, the other"},
          {"$changeover same a c", 1, "3 blocks\n"},
          {"$changeover same a d", 1, "even without their order the blocks differ"},
          {"$changeover same a d --json", 1, "{\"same\":false"}},
         folder);
}

TEST(Same, ReadsBackwardsOnlyIfItMay) {
  const TemporaryFolder folder;
  const std::string head = "# changeover design v=4 k=2 change=1 kind=linear\n";
  spit(folder.file("a"), head + "0 1\n1 2\n1 3\n");
  spit(folder.file("b"), head + "0 1\n1 2\n0 2\n");
  spit(folder.file("r"), head + "0 2\n1 2\n0 1\n");
  spit(folder.file("s"), head + "0 1\n1 2\n2 3\n1 3\n");
  spit(folder.file("t"), head + "1 3\n2 3\n1 2\n0 1\n");
  expect({{"$changeover same s t", 1, "not the same"},
          {"$changeover same s t --reversal", 0, "which is read backwards"},
          {"$changeover same b r", 0, "the same: "},
          {"$changeover same a b --reversal", 1, "not the same"}},
         folder);
}

}  // namespace
}  // namespace changeover::test::classify_test
