// The examples of the headers of curator/, as they stand there.
#include "example_support.hpp"

namespace changeover::test::curator_examples_test {
namespace {

class CuratorExamples : public InAFolder {
 protected:
  CuratorExamples() { put("mine.txt", "0 1 2\n0 1 3\n0 2 3\n"); }
};

TEST_F(CuratorExamples, Add) {
  Catalog catalog({.shipped = {}, .user = "mine.db"});
  const Design design = read_design("mine.txt");
  const Newcomer newcomer = newcomer_of(design, {.note = "found by hand"});
  if (newcomer.entry && !same_in_catalog(catalog, *newcomer.entry)) {
    catalog.add(*newcomer.entry);
  }
  EXPECT_TRUE(catalog.find("4.3.1.linear.3.fdc879cf"));
}

TEST_F(CuratorExamples, Exchange) {
  Catalog catalog({.shipped = {}, .user = "mine.db"});
  catalog.add(*newcomer_of(read_design("mine.txt"), {}).entry);
  OutputFile file("all.jsonl");
  write_entries(catalog, {.best_only = false}, file);
  file.commit();
  std::filesystem::copy("all.jsonl", "theirs.jsonl");
  std::filesystem::copy("all.jsonl", "before.jsonl");
  const auto input = open_input("theirs.jsonl");
  EXPECT_EQ(import_foreign(*input, catalog).added, 0U);  // each one was built and verified
  BestOfCells before = best_of_cells(*open_input("before.jsonl"));
  before.begin()->second = 4;
  for (const CellChange& change : compare_cells(before, best_of_cells(catalog))) {
    EXPECT_EQ(change.after, 3U);
  }
}

TEST_F(CuratorExamples, Audit) {
  Catalog catalog({.shipped = {}, .user = "mine.db"});
  catalog.add(*newcomer_of(read_design("mine.txt"), {}).entry);
  RunControl control({.threads = 2});
  const Audit audit = audit_catalog(catalog, {.v_to = 20, .best_only = false}, control);
  EXPECT_TRUE(audit.faults.empty());
  EXPECT_EQ(audit.checked, 1U);
}

TEST_F(CuratorExamples, Improve) {
  Catalog catalog({.shipped = {}, .user = "mine.db"});
  put("mine.txt", "0 1 2\n0 1 3\n0 2 3\n1 2 3\n");
  catalog.add(*newcomer_of(read_design("mine.txt"), {}).entry);
  StringSink sink;
  RunControl control({.time = std::chrono::seconds(2)});
  const auto finds = improve_catalog(catalog, {.v_to = 9, .k_to = 4}, control);
  const Submission submission = write_submission(catalog, sink);
  EXPECT_LE(submission.labels.size(), 1U);
  EXPECT_EQ(finds.size(), 1U);
}

}  // namespace
}  // namespace changeover::test::curator_examples_test
