// changeover catalog: looking up what is known.
#include <gtest/gtest.h>

#include <algorithm>

#include "cases.hpp"
#include "changeover/core/sha256.hpp"

namespace changeover::test::catalog_lookup_test {
namespace {

TEST(CatalogVerbs, AnswerWhatIsAsked) {
  const TemporaryFolder folder;
  expect(
      {
          {"$changeover catalog show 26 4", 0, "26.4.2.circular.65.08c35011"},
          {"$changeover catalog show 26.4.2.circular", 0, "minimum"},
          {"$changeover catalog show 26.4.2.circular.65", 0, "how it is made"},
          {"$changeover 26.4.2.circular.65.08c3", 0, "SHA-256"},
          {"$changeover catalog show 20 5 --json", 0, "\"status\":\"minimum\""},
          {"$changeover catalog show 26.4.2.circular --format csv", 0, "block,element_1"},
          {"$changeover catalog show 26.4.2.circular --format text | $changeover verify -", 0,
           "tight"},
          {"$changeover catalog show 6 4 --strength 3 --change 1", 0, ".t3."},
          {"$changeover catalog show 26.4.2.circular.66", 4, "has no design"},
          {"$changeover catalog show 999 3 --change 900", 2, "change"},
          {"$changeover catalog show 999 4", 4, "changeover bounds"},
          {"$changeover catalog show 4 2 --json", 4, "[]"},
          {"$changeover catalog show pigs 4", 2, "neither a label"},
          {"$changeover catalog list --k 4 --v 5..12 --change 1 --linear --strength 2", 0,
           "8 designs"},
          {"$changeover catalog list --k 4 --v 5..12 --gap 1 --json", 0, "["},
          {"$changeover catalog list --k 20 --v 60 --format csv", 0, "60.20.3.circular"},
          {"$changeover catalog list --since tomorrow", 2, "--since"},
          {"$changeover catalog list --k 9..3", 2, "the range is empty"},
          {"$changeover catalog history 20.6.1.linear", 0, "38"},
          {"$changeover catalog history 15.3.2.linear", 0, "[ChafeeStevens2025]; Table 3; Chafee"},
          {"$changeover catalog history 26.4.2.circular.65", 0, "circular DCCD(26,4)"},
          {"$changeover catalog show 12.4.1.linear.21.6f25", 0, "note: the first of the 2554"},
          {"$changeover catalog show 12.4.1.linear.21.6f25", 0, "from: Phillips1999"},
          {"$changeover catalog show 12.4.1.linear", 0, "how the first of them is made"},
          {"$changeover catalog show 20.5.2.linear", 0,
           "catalog show 20.5.2.linear.29.f6bd9e33 --format text prints the blocks"},
          {"$changeover catalog cite 12.4.1.linear.21.6f25", 0, "@misc{Phillips1999"},
          {"$changeover catalog cite 15.3.2.linear.35.6cb7", 0,
           "author = {{Chafee} and {Stevens}}"},
          {"$changeover catalog cite 9.3.2.circular.12.9bda", 0,
           "author = {{Preece} and {Constable} and {Zhang} and {Yucas} and {Wallis} and {McSorley} "
           "and {Phillips}}"},
          {"$changeover catalog cite 26.4.2.circular.65", 0, "@misc{changeover-26.4.2.circular.65"},
          {"$changeover catalog cite 40.9.2.circular", 0, "@misc{changeover-40.9.2.circular."},
          {"$changeover catalog cite 200.9.2.circular", 4, "has no design"},
          {"$changeover catalog cite", 0, "A catalog of change covering designs"},
          {"$changeover catalog completeness --k 3..4 --change 1 --linear", 0, "(100 %)"},
          {"$changeover catalog list --since 2026-02-29", 2, "'2026-02-29' is not a day"},
          {"$changeover catalog list --since 2024-02-29 --k 4 --v 9", 0, "9.4."},
          {"$changeover catalog list --since 9999-12-31", 0, "0 designs"},
          {"$changeover --help | grep -A99 Subcommands: | grep -E '^  catalog '", 0,
           "catalog of known designs"},
          {"$changeover catlog list", 2, "did you mean catalog"},
          {"$changeover catalog add --help", 0, "Usage: changeover catalog add"},
          {"$changeover describe", 0, "\"groups\":[{\"name\":\"catalog\",\"summary\":\"browse"},
          {"$changeover describe", 0, "\"typed\":\"catalog show\""},
          {"$changeover completion bash | grep -c ' catalog '", 0, "1"},
          {"$changeover catalog --help", 0, "completeness"},
          {"$changeover catalog", 2, "there are show"},
          {"$changeover catalog shwo", 2, "did you mean show"},
          {"$changeover catalog list --kk 3", 2, "catalog list has no option --kk"},
          {"CHANGEOVER_CATALOG=/nowhere/at/all.db $changeover catalog list --users", 0,
           "0 designs"},
      },
      folder);
}

// The checksum is that of the lines that everybody can make.
TEST(CatalogVerbs, AChecksumIsThatOfTheLinesOfBlocks) {
  const TemporaryFolder folder;
  const Outcome text = run(
      "$changeover catalog show 26.4.2.circular.65 --format text | grep -v '^#'", folder.path());
  EXPECT_TRUE(to_hex(sha256(text.out)).starts_with("08c35011"));
}

TEST(CatalogVerbs, SayThatTheUsersFileIsNoCatalogAndGoOn) {
  const TemporaryFolder folder;
  ASSERT_EQ(run("echo 'my diary, and no catalog of designs at all' > mine.db", folder.path()).code,
            0);
  const Outcome outcome =
      run("CHANGEOVER_CATALOG=mine.db $changeover bounds 26 4 --circular", folder.path());
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.out.find("b <= 65"), std::string::npos);
  EXPECT_NE(outcome.err.find("mine.db"), std::string::npos);
  EXPECT_NE(run("cat mine.db", folder.path()).out.find("my diary"), std::string::npos);
  const Outcome verified =
      run("$changeover catalog verify --users --quiet --catalog mine.db", folder.path());
  EXPECT_EQ(verified.code, 1);
  EXPECT_EQ(verified.out.rfind("WRONG: your own catalog: mine.db: damaged, or not a catalog", 0),
            0U);
  // Where the answer is that there is nothing, the file that was left out may be why.
  const std::string left_out = "your own catalog was left out: mine.db: damaged, or not a catalog";
  for (const std::string words :
       {"show 7.3.2.circular.7.00000000", "show 7.3.2.circular.7.00000000 --json", "show 9 5 -m 4",
        "submit", "retract 7.3.2.circular.7.00000000 --why wrong",
        "alias mine 7.3.2.circular.7.00000000", "cite 7.3.2.circular.7.00000000"}) {
    const Outcome nothing =
        run("$changeover catalog " + words + " --catalog mine.db", folder.path());
    EXPECT_EQ(nothing.code, 4) << words;
    EXPECT_NE(nothing.err.find(left_out), std::string::npos) << words << ": " << nothing.err;
    EXPECT_EQ(nothing.err.find(left_out), nothing.err.rfind(left_out)) << words;
  }
  expect({{"$changeover draw nosuch.x --catalog mine.db", 4, left_out}}, folder);
  const Outcome unwritten = run(
      "$changeover catalog show 26.4.2.circular.65 --catalog mine.db -o nowhere/x", folder.path());
  EXPECT_EQ(unwritten.code, 4);
  EXPECT_EQ(std::count(unwritten.err.begin(), unwritten.err.end(), '\n'), 1) << unwritten.err;
}

}  // namespace
}  // namespace changeover::test::catalog_lookup_test
