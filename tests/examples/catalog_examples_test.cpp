// The examples of the headers of catalog/, as they stand there.
#include "example_support.hpp"
#include "run_program.hpp"

namespace changeover::test::catalog_examples_test {
namespace {

class CatalogExamples : public InAFolder {};

CatalogEntry example_entry() {
  return entry_from_line(
      R"({"label":"4.3.1.linear.3.fdc879cf","b":3,"lower_bound":3,"reason":"counting","recipe":)"
      R"({"construction":"literal","v":4,"k":3,"change":1,"kind":"linear",)"
      R"("arguments":{},"inputs":[],"blocks":[[0,1,2],[0,1,3],[0,2,3]]},)"
      R"("sha256":"fdc879cf58d819b2f1550061bf579ec55c0ec7cd10f723344cd6bba2b4e4cf12"})",
      "mine.jsonl", 1, {});
}

TEST_F(CatalogExamples, Catalog) {
  const CatalogEntry entry = example_entry();
  Catalog catalog({.shipped = {}, .user = "mine.db"});
  catalog.add(entry);
  EXPECT_EQ(catalog.best(entry.parameters)->b, 3U);
  EXPECT_EQ(catalog.find(entry.label()), entry);
  EXPECT_TRUE(verify(*Registry::standard().build(entry.recipe)).valid());
}

TEST_F(CatalogExamples, Reported) {
  const Parameters p{.v = 26, .k = 6, .change = 1, .kind = Kind::linear};
  EXPECT_EQ(reported_below(p, 64)->blocks, 63U);
  EXPECT_FALSE(reported_below(p, 63).has_value());
}

TEST_F(CatalogExamples, Classified) {
  const auto all = classified({.v = 9, .k = 4, .change = 1, .kind = Kind::circular}, 12);
  EXPECT_EQ(all->classes, 2U);
  EXPECT_EQ(all->groups, "1:1 3:1");
}

TEST_F(CatalogExamples, Entry) {
  // clang-format off
  CatalogEntry entry = entry_from_line(
      R"({"label":"4.3.1.linear.3.fdc879cf","b":3,"lower_bound":3,"reason":"counting",)"
      R"("recipe":{"construction":"literal","v":4,"k":3,"change":1,"kind":"linear",)"
      R"("arguments":{},"inputs":[],"blocks":[[0,1,2],[0,1,3],[0,2,3]]},)"
      R"("sha256":"fdc879cf58d819b2f1550061bf579ec55c0ec7cd10f723344cd6bba2b4e4cf12"})",
      "mine.jsonl", 1, {});
  EXPECT_EQ(entry.status(), "minimum");
  const std::string line = line_of(entry, {});
  // clang-format on
  EXPECT_EQ(entry_from_line(line, "mine.jsonl", 1, {}), entry);
  EXPECT_THAT(line, HasSubstr(R"("kind":"linear","arguments":{},"inputs":[],"blocks":[[0,1,2],)"));
  const Credit shared = shared_from_header(without_margin(R"(
    {"format":"changeover-catalog/1","credit":{"who":"A. Researcher","date":"2026-11-22","program":"changeover 0.1.0"}}
    )"),
                                           "mine.jsonl");
  EXPECT_EQ(shared.date, "2026-11-22");
}

TEST_F(CatalogExamples, Label) {
  const Parameters p{.v = 20, .k = 5, .change = 2, .kind = Kind::linear};
  EXPECT_EQ(cell_label(p), "20.5.2.linear");
  DesignLabel label = parse_design_label("20.5.2.linear.39.3fa9c1d2").value();
  EXPECT_EQ(label.b, 39U);
  const Outcome said = run(R"(
    $changeover design 61 4 --format text | grep -v '^#' | sha256sum
    )",
                           std::filesystem::current_path());
  const auto best = best_design({.v = 61, .k = 4});
  DesignSource blocks(best);
  EXPECT_THAT(said.out, testing::StartsWith(to_hex(design_digest(blocks).checksum)));
}

}  // namespace
}  // namespace changeover::test::catalog_examples_test
