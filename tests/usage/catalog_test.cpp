// changeover catalog …: what goes into a catalog of one's own, and out of it.
#include <gmock/gmock.h>

#include <algorithm>

#include "cases.hpp"
#include "catalog/store/database.hpp"

namespace changeover::test::catalog_test {
namespace {

using testing::HasSubstr;

// A folder with files, whose catalog is mine.db.
class CatalogUsage : public testing::Test {
 protected:
  CatalogUsage() {
    spit(folder.file("three.txt"), "0 1 2\n0 1 3\n0 2 3\n");
    spit(folder.file("same.txt"), "0 1 3\n0 1 2\n0 3 2\n");
    spit(folder.file("four.txt"), "0 1 2\n0 1 3\n0 2 3\n1 2 3\n");
    spit(folder.file("bad.txt"), "0 1 2\n0 1 3\n");
    spit(folder.file("steps.txt"), "0 1 2\n0 1 3\n2 4 0\n");
    spit(folder.file("words.txt"), "0 1\n0 1 2\n");
  }

  std::string with(const std::string& catalog, const std::string& command) const {
    return "CHANGEOVER_CATALOG='" + folder.file(catalog) + "' $changeover catalog " + command;
  }
  std::string mine(const std::string& command) const { return with("mine.db", command); }

  TemporaryFolder folder;
};

TEST_F(CatalogUsage, Add) {
  expect(
      {{mine("add three.txt --who Me --note 'by hand'"), 0,
        "added: 4.3.1.linear.3.fdc879cf, linear SCCD(4,3) with 3 blocks, minimum"},
       {mine("add three.txt"), 0, "there already: 4.3.1.linear.3.fdc879cf"},
       {mine("add - <three.txt --json"), 0, "\"outcome\":\"already there\""},
       {mine("add same.txt"), 0,
        "not added: 4.3.1.linear.3.2fc52240 is 4.3.1.linear.3.fdc879cf up to names"},
       {mine("add same.txt --even-isomorphic"), 0, "  it is 4.3.1.linear.3.fdc879cf up to"},
       {mine("add four.txt bad.txt"), 1,
        "INVALID: bad.txt: 1 of 6 pairs is in no block, e.g. {2,3}; add blocks that cover them\nnothing was added"},
       {mine("add steps.txt"), 1, "the first from block 2 to block 3"},
       {mine("show 4.3.1.linear.4"), 4, "4.3.1.linear.4"},
       {mine("add four.txt"), 0,
        "the best that is known of its cell has 3 blocks: 4.3.1.linear.3."},
       {with("ring.db", "add four.txt --circular"), 0, "added: 4.3.1.circular.4."},
       {with("worse.db", "add four.txt"), 0,
        "with 4 blocks, not the best that is known (four.txt)"},
       {with("again.db", "add four.txt"), 0, "consecutive, too: --circular adds it as circular"},
       {mine("add words.txt"), 3, "words.txt"},
       {with("fresh.db", "add three.txt same.txt"), 0,
        "not added: 4.3.1.linear.3.2fc52240 is 4.3.1.linear.3.fdc879cf up to names"},
       {mine("add nothing.txt"), 4, "nothing.txt"},
       {mine("add three.txt --note \"$(printf 'a\\nb')\""), 3, "note"},
       {mine("add"), 2, "FILE"},
       {mine("add - - <three.txt"), 2, "standard input"},
       {"CHANGEOVER_CATALOG= $changeover catalog add three.txt", 4, "--catalog"},
       {"CHANGEOVER_CATALOG= $changeover catalog add three.txt --catalog other.db", 0, "added: "},
       {mine("show 4.3.1.linear.3.fdc879cf"), 0, "Me"},
       {mine("list --users --all"), 0, "3 designs"}},
      folder);
}

// What comes with the program is not added again.
TEST_F(CatalogUsage, NotWhatIsShipped) {
  expect({{"$changeover design 9 4 --change 2 --circular --format text -o nine.txt && " +
               mine("add nine.txt"),
           0, "there already: 9.4.2.circular."},
          {mine("list --users --all"), 0, "0 designs"}},
         folder);
}

TEST_F(CatalogUsage, RetractAndAlias) {
  expect({{mine("add three.txt four.txt"), 0, "added: "},
          {mine("alias nice 4.3.1.linear.3.fdc8"), 0, "nice leads to 4.3.1.linear.3.fdc879cf"},
          {mine("show nice"), 0, "4.3.1.linear.3.fdc879cf"},
          {mine("alias nice 4.3.1.linear.4"), 3, "choose another word"},
          {mine("alias 4.3.1.linear 4.3.1.linear.4"), 3, "is a label"},
          {mine("retract 4.3.1.linear.3.fdc879cf"), 2, "--why"},
          {mine("retract 4.3.1.linear.3.00000000 --why x"), 4, "the catalog has no design"},
          {mine("alias nicer 4.3.1.linear.3.00000000"), 4, "the catalog has no design"},
          {mine("alias 4.3.1.linear.4 4.3.1.linear.3"), 3, "is a label or the beginning of one"},
          {mine("alias 4 4.3.1.linear.3"), 3, "is a label or the beginning of one"},
          {mine("alias"), 2, "WORD"},
          {mine("alias word"), 2, "LABEL is missing"},
          {mine("alias word 4.3.1.linear.3 --remove"), 2, "leave LABEL out"},
          {mine("alias word 4.3.1.linear.3"), 0, "word leads to 4.3.1.linear.3.fdc879cf"},
          {mine("alias word --remove"), 0, "word leads to 4.3.1.linear.3.fdc879cf no more"},
          {mine("alias word --remove"), 3, "there is no alias word"},
          {mine("show word"), 4, "has no design word"},
          {mine("show ''"), 2, "name a label of the catalog, or V and K"},
          {mine("retract nice --why 'a misprint'"), 0,
           "retracted: 4.3.1.linear.3.fdc879cf (found by nice)"},
          {mine("retract 4.3.1.linear.4 --why again"), 0, "(found by 4.3.1.linear.4)"},
          {mine("show nice"), 0, "a misprint"},
          {mine("list --users --status retracted"), 0, "4.3.1.linear.4."}},
         folder);
}

// An alias of an older program that is the beginning of a label: what is written goes to the design
// of the label.
TEST_F(CatalogUsage, AnAliasThatReadsAsALabelIsNotUsed) {
  expect({{mine("add three.txt four.txt"), 0, "added: "}}, folder);
  Database::open(folder.file("mine.db"), Access::read_write)
      .run("INSERT INTO alias VALUES('4.3.1.linear.4', '4.3.1.linear.3.fdc879cf')");
  const Outcome outcome = run(mine("retract 4.3.1.linear.4 --why wrong"), folder.path());
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, testing::StartsWith("retracted: 4.3.1.linear.4."));
  EXPECT_THAT(outcome.err, HasSubstr("the alias 4.3.1.linear.4 is not used"));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  expect({{mine("verify --users --quiet"), 1, "WRONG: 4.3.1.linear.4: an alias that reads as a"},
          {mine("alias --remove 4.3.1.linear.4"), 0, "no more"},
          {mine("verify --users --quiet"), 0, "all as they say"}},
         folder);
}

// Names are paths: a file of that name, or one true line.
TEST_F(CatalogUsage, NamesOfTheCatalogArePaths) {
  EXPECT_EQ(run("mkdir folder; mkfifo fifo", folder.path()).code, 0);
  const auto named = [](const std::string& name, const std::string& command) {
    return "$changeover catalog " + command + " --catalog '" + name + "'";
  };
  for (const std::string name : {":memory:", "file:zz.db?mode=memory", "file:x.db", "?.db"}) {
    expect({{named(name, "add three.txt"), 0, "added: "},
            {named(name, "list --users"), 0, "1 design"},
            {"test -f '" + name + "' && echo there", 0, "there"}},
           folder);
  }
  for (const std::string name : {"folder", "fifo", "/dev/null"}) {
    for (const std::string command : {"add three.txt", "import three.jsonl", "alias a b"}) {
      const Outcome outcome = run(named(name, command), folder.path());
      EXPECT_THAT(outcome.code, testing::AnyOf(4)) << name << " " << command;
      EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
    expect({{named(name, "add three.txt"), 4, "not a file; name another file with --catalog"},
            {named(name, "list --users 2>&1"), 0, "your own catalog was left out: " + name}},
           folder);
  }
}

// No answer without a place for it, and nothing done before.
TEST_F(CatalogUsage, TheAnswerHasAPlaceBeforeAnythingIsChanged) {
  expect({{mine("add three.txt"), 0, "added: "},
          {mine("export --users -o one.jsonl && mkdir folder && echo made"), 0, "made"}},
         folder);
  const std::string label = "4.3.1.linear.3.fdc879cf";
  for (const std::string place : {"-o folder", "-o nowhere/answer", "-o three.txt/answer", ">&-"}) {
    expect({{with("new.db", "add three.txt " + place), 4, "cannot write"},
            {with("new.db", "import one.jsonl -o folder"), 4, "cannot write"},
            {mine("retract " + label + " --why wrong " + place), 4, "cannot write"},
            {mine("alias word " + label + " " + place), 4, "cannot write"},
            {mine("alias --remove word " + place), 4, "cannot write"},
            {mine("improve --users --time 1s -o folder"), 4, "cannot write"},
            {"test ! -e new.db && echo none", 0, "none"},
            {mine("show word"), 4, "has no design word"},
            {mine("show " + label + " | grep -c wrong || true"), 0, "0"}},
           folder);
  }
  // What only the writing shows is said with what was done.
  expect({{with("new.db", "add three.txt >/dev/full"), 4, "the catalog was changed as asked"},
          {with("new.db", "show 4.3.1.linear.3"), 0, label}},
         folder);
}

TEST_F(CatalogUsage, ExportAndImport) {
  expect({{mine("add three.txt same.txt four.txt --even-isomorphic"), 0, "added: "},
          {mine("export --users -o one.jsonl && wc -l <one.jsonl"), 0, "4"},
          {with("theirs.db", "import one.jsonl"), 0, "added: 3 designs"},
          {with("theirs.db", "import one.jsonl"), 0, "there already: 3"},
          {with("theirs.db", "export --users -o two.jsonl") +
               " && cmp one.jsonl two.jsonl && echo same",
           0, "same"},
          {mine("export --users --best | wc -l"), 0, "2"},
          {"sed 's/\\[0,1,3\\]/[0,1,2]/' one.jsonl >bad.jsonl; " + with("x.db", "import bad.jsonl"),
           3, "bad.jsonl:"},
          {"test ! -e x.db && echo none", 0, "none"},
          {with("x.db", "import three.txt"), 3, "three.txt:1:"},
          {with("x.db", "import nothing.jsonl"), 4, "nothing.jsonl"},
          {"(cat one.jsonl; echo x) | " + with("x.db", "import - --skip-bad"), 1,
           "left out: <stdin>:5:"},
          {with("x.db", "export --users") + " | cmp - one.jsonl && echo same", 0, "same"}},
         folder);
}

TEST_F(CatalogUsage, Verify) {
  expect({{mine("add three.txt four.txt"), 0, "added: "},
          {mine("verify --users --resume done.txt"), 0, "2 of 2 designs built and verified"},
          {mine("verify --users --resume done.txt"), 0,
           "0 of 2 designs built and verified (2 before)"},
          {mine("add same.txt --even-isomorphic"), 0, "added: "},
          {mine("verify --users --resume done.txt --json"), 0,
           "\"checked\":3,\"checked_before\":0,\"complete\":true"},
          {"printf '\\357\\273\\277' >mark; " + mine("export --users -o own.jsonl") +
               "; (head -1 own.jsonl; cat mark; sed -n 2p own.jsonl; cat mark) | " +
               with("marked.db", "import -"),
           0, "added: 1 design"},
          {mine("verify --users --resume three.txt"), 3,
           "not a list that catalog verify --resume wrote"},
          {"echo 9.9.9.linear.1.00000000 >>done.txt; " +
               mine("verify --users --resume done.txt --json"),
           0, "\"checked\":0,\"checked_before\":3,\"complete\":true"},
          {"(trap '' XFSZ; ulimit -f 0; " + mine("verify --users --resume done.txt") +
               "); wc -l <done.txt",
           0, "4"},
          {"mkfifo pipe; " + mine("verify --users --resume pipe"), 3, "pipe: not a regular file"},
          {mine("verify --k 4 --v 10..20 --change 1 --threads 2"), 0, "all as they say"}},
         folder);
}

TEST_F(CatalogUsage, NoAnswerReplacesIt) {
  expect({{mine("add three.txt four.txt"), 0, "added: "}}, folder);
  const std::string before = slurp(folder.file("mine.db"));
  const std::string refused = "would replace your catalog";
  EXPECT_EQ(run("ln -s mine.db link", folder.path()).code, 0);
  expect(
      {{mine("list --users -o mine.db"), 2, refused},
       {mine("list --users -o ./mine.db"), 2, refused},
       {mine("list --users -o link"), 2, refused},
       {mine("add four.txt -o mine.db"), 2, refused},
       {mine("export -o mine.db-wal"), 2, refused},
       {"CHANGEOVER_CATALOG= $changeover catalog verify --users --catalog mine.db -o mine.db", 2,
        refused},
       {"CHANGEOVER_CATALOG=mine.db $changeover design 7 3 -o mine.db", 2, refused},
       {"CHANGEOVER_CATALOG=not-yet.db $changeover bounds 7 3 -o not-yet.db", 2, refused},
       {mine("verify --users --resume done.txt -o done.txt"), 2, "would replace --resume"},
       {mine("verify --users --resume done.txt -o ./done.txt.lock"), 2, "would replace --resume"},
       {mine("list --users -o answer.txt && tail -n 1 answer.txt"), 0, "1 design"}},
      folder);
  EXPECT_EQ(slurp(folder.file("mine.db")), before);
}

TEST_F(CatalogUsage, ImproveAndSubmit) {
  expect({{mine("add four.txt"), 0, "added: 4.3.1.linear.4."},
          {mine("submit"), 4, "Nothing of yours is better than what comes with the program."},
          {mine("improve --users --time 300s --who Me"), 10,
           "better: 4.3.1.linear  4 -> 3  4.3.1.linear.3."},
          {mine("improve --users --time 300s"), 30, "0 designs better"},
          {mine("improve --time nonsense"), 2, "--time"},
          {mine("improve --each nonsense"), 2, "--each"},
          {mine("list --users"), 0, "4.3.1.linear.3."}},
         folder);
}

TEST_F(CatalogUsage, Diff) {
  expect({{mine("add four.txt && ") + mine("export --users -o old.jsonl"), 0, "added: "},
          {mine("add three.txt && ") + mine("export --users -o new.jsonl"), 0, "added: "},
          {mine("diff old.jsonl new.jsonl"), 0,
           "better  4.3.1.linear  4 -> 3\n1 better, 0 worse, 0 new, 0 gone"},
          {mine("diff new.jsonl old.jsonl"), 0, "worse   4.3.1.linear  3 -> 4"},
          {mine("diff new.jsonl old.jsonl --json"), 0,
           R"([{"cell":"4.3.1.linear","change":"worse","before":3,"after":4}])"},
          {mine("diff new.jsonl"), 0, "0 better, 0 worse, "},
          {mine("diff three.txt"), 3, "three.txt:1:"}},
         folder);
}

}  // namespace
}  // namespace changeover::test::catalog_test
