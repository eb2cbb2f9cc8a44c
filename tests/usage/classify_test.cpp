// changeover classify and changeover same, as their users see them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run_program.hpp"

namespace changeover::test {
namespace {

using testing::HasSubstr;

class Classify : public testing::Test {
 protected:
  Outcome run_here(const std::string& command) { return run(command, folder_.path()); }

  void write(const std::string& name, const std::string& text) { spit(folder_.file(name), text); }

  TemporaryFolder folder_;
};

TEST_F(Classify, CountsTheStandardFormsOfTheLiterature) {
  const Outcome outcome = run_here("$changeover classify 12 4 21 --change 1 --json");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("\"standard_forms\":2554,\"classes\":2554"));
  EXPECT_THAT(outcome.out, HasSubstr("\"complete\":true"));
}

TEST_F(Classify, TellsTheTwoCircularDesignsOfNineElementsApart) {
  const Outcome outcome = run_here("$changeover classify 9 4 12 --change 1 --circular");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out,
              HasSubstr("16 standard forms in 2 classes up to relabelling and rotation, 2 tight"));
  EXPECT_THAT(outcome.out, HasSubstr("group order 3 with 3 rotations, tight, economical"));
  EXPECT_THAT(outcome.out, HasSubstr("group order 1: 1 class\n"));
}

TEST_F(Classify, TakesTheLowerBoundIfTheNumberOfBlocksIsNotGiven) {
  const Outcome outcome = run_here("$changeover classify 8 5 --circular --reversal --json");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("\"b\":5"));
  EXPECT_THAT(outcome.out, HasSubstr("\"standard_forms\":25,\"classes\":4"));
}

TEST_F(Classify, ShowsAllClassesInAFileThatAppearsWhole) {
  const Outcome outcome =
      run_here("$changeover classify 10 4 15 --change 1 --circular --designs -o all.json --json");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, "");
  const std::string text = slurp(folder_.file("all.json"));
  std::size_t shown = 0;
  for (std::size_t at = text.find("\"blocks\""); at != std::string::npos;
       at = text.find("\"blocks\"", at + 1)) {
    ++shown;
  }
  EXPECT_EQ(shown, 12U);
}

TEST_F(Classify, GivesTheSameAnswerWithOneThreadAndThree) {
  const std::string cut = " --circular --change 1 --designs | grep -v nodes";
  const Outcome one = run_here("$changeover classify 10 4 15 --threads 1" + cut);
  const Outcome three = run_here("$changeover classify 10 4 15 --threads 3" + cut);
  EXPECT_EQ(one.out, three.out);
  EXPECT_THAT(one.out, HasSubstr("12 classes"));
}

TEST_F(Classify, SaysWhenALimitStoppedIt) {
  const Outcome outcome = run_here("$changeover classify 20 5 46 --change 1 --time 100ms --quiet");
  EXPECT_EQ(outcome.code, 30);
  EXPECT_THAT(outcome.out, HasSubstr("NOT ALL: stopped (time limit)"));
}

TEST_F(Classify, SaysWhyThereIsNoneForAnyNumberOfBlocks) {
  const Outcome outcome = run_here("$changeover classify 4 2 9");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("none"));
  EXPECT_THAT(run_here("$changeover classify 4 2 9 --json").out,
              HasSubstr("\"standard_forms\":0,\"classes\":0"));
}

TEST_F(Classify, RefusesWrongArgumentsInOneLine) {
  EXPECT_EQ(run_here("$changeover classify 9 4 0").code, 2);
  EXPECT_EQ(run_here("$changeover classify 9 4 9 --circular --linear").code, 2);
  EXPECT_EQ(run_here("$changeover classify 9 4 9 --time soon").code, 2);
  const Outcome outcome = run_here("$changeover classify 70 4 900");
  EXPECT_NE(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("at most 64 elements"));
}

TEST_F(Classify, SameFindsTheMapBetweenRenamedAndRotatedDesigns) {
  write("a.txt", "# changeover design v=6 k=4 change=2 kind=circular\n0 1 2 3\n4 5 2 3\n4 5 0 1\n");
  write("b.txt", "# changeover design v=6 k=4 change=2 kind=circular\na b e f\na b c d\nc d e f\n");
  const Outcome outcome = run_here("$changeover same a.txt b.txt");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("the same: circular DCCD(6,4), 3 blocks\n"));
  EXPECT_THAT(outcome.out, HasSubstr("0 -> "));
  EXPECT_THAT(outcome.out, HasSubstr("automorphisms: 24\n"));
  const Outcome json = run_here("$changeover same a.txt b.txt --reversal --json");
  EXPECT_EQ(json.code, 0);
  EXPECT_THAT(json.out, HasSubstr("\"same\":true"));
  EXPECT_THAT(json.out, HasSubstr("\"group_order\":\"48\""));
}

TEST_F(Classify, SameTellsOtherDesignsApartAndSaysHowTheyDiffer) {
  write("a.txt", "# changeover design v=5 k=2 change=1 kind=linear\n0 1\n1 2\n2 3\n3 4\n");
  write("b.txt", "# changeover design v=5 k=2 change=1 kind=linear\n1 2\n0 1\n2 3\n3 4\n");
  write("c.txt", "# changeover design v=5 k=2 change=1 kind=linear\n0 1\n1 2\n2 3\n");
  write("d.txt", "# changeover design v=5 k=2 change=1 kind=linear\n0 1\n1 2\n2 0\n3 4\n");
  const Outcome order = run_here("$changeover same a.txt b.txt");
  EXPECT_EQ(order.code, 1);
  EXPECT_THAT(order.out, HasSubstr("without their order the blocks are the same"));
  const Outcome blocks = run_here("$changeover same a.txt c.txt");
  EXPECT_EQ(blocks.code, 1);
  EXPECT_THAT(blocks.out, HasSubstr("4 blocks"));
  EXPECT_THAT(blocks.out, HasSubstr("3 blocks"));
  const Outcome other = run_here("$changeover same a.txt d.txt");
  EXPECT_EQ(other.code, 1);
  EXPECT_THAT(other.out, HasSubstr("even without their order the blocks differ"));
  EXPECT_THAT(run_here("$changeover same a.txt d.txt --json").out, HasSubstr("\"same\":false"));
}

TEST_F(Classify, SameReadsBackwardsOnlyIfItMay) {
  write("a.txt", "# changeover design v=4 k=2 change=1 kind=linear\n0 1\n1 2\n1 3\n");
  write("b.txt", "# changeover design v=4 k=2 change=1 kind=linear\n0 1\n1 2\n0 2\n");
  write("r.txt", "# changeover design v=4 k=2 change=1 kind=linear\n0 2\n1 2\n0 1\n");
  write("s.txt", "# changeover design v=4 k=2 change=1 kind=linear\n0 1\n1 2\n2 3\n1 3\n");
  write("t.txt", "# changeover design v=4 k=2 change=1 kind=linear\n1 3\n2 3\n1 2\n0 1\n");
  EXPECT_EQ(run_here("$changeover same s.txt t.txt").code, 1);
  const Outcome backwards = run_here("$changeover same s.txt t.txt --reversal");
  EXPECT_EQ(backwards.code, 0);
  EXPECT_THAT(backwards.out, HasSubstr("which is read backwards"));
  EXPECT_EQ(run_here("$changeover same b.txt r.txt").code, 0);
  EXPECT_EQ(run_here("$changeover same a.txt b.txt --reversal").code, 1);
}

TEST_F(Classify, SameReportsBadFilesAndArguments) {
  write("a.txt", "0 1\n1 2\n");
  EXPECT_EQ(run_here("$changeover same a.txt missing.txt").code, 4);
  EXPECT_EQ(run_here("$changeover same - -").code, 2);
  EXPECT_EQ(run_here("$changeover same a.txt a.txt --linear --circular").code, 2);
}

}  // namespace
}  // namespace changeover::test
