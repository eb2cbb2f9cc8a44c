// The examples of the headers of search/, as they stand there.
#include <iostream>

#include "example_support.hpp"

namespace changeover::test::search_examples_test {
namespace {

using changeover::Outcome;  // not that of a program that was run

class SearchExamples : public InAFolder {};

TEST_F(SearchExamples, BaseBlockSearch) {
  bool found = false;
  RunControl control({.time = std::chrono::seconds(60)});
  const BaseBlockResult result = search_base_blocks({.v = 26, .k = 4, .kind = Kind::circular},
                                                    {.shapes = {.tight = true}}, control);
  if (result.found()) {
    EXPECT_EQ(to_string(result.shape), "5 base blocks, 2 cycles of length 13");
    EXPECT_TRUE(result.verdict().tight());
    EXPECT_THAT(result.recipe->blocks, SizeIs(5));
    EXPECT_EQ(result.recipe->construction, "developed");
    EXPECT_EQ(result.comparison, Comparison::equal);
    found = true;
  }
  EXPECT_TRUE(found);
}

TEST_F(SearchExamples, BaseBlockShape) {
  StandardOutput output;
  const Parameters p{.v = 26, .k = 4, .kind = Kind::circular};
  for (const BaseBlockShape& shape : base_block_shapes(p, {.tight = true})) {
    std::cout << to_string(shape) << '\n';
  }
  EXPECT_THAT(output.take(), HasSubstr("5 base blocks, 2 cycles of length 13\n"));
  EXPECT_THAT(
      shape_obstruction({.v = 26, .k = 8, .kind = Kind::circular}, {5, 5, 1, 5}, true).value(),
      HasSubstr("a fixed element would be introduced j times in r ≥ j ≥ 1 base blocks, "
                "7j + 2(r−j) = 5"));
}

TEST_F(SearchExamples, Enumeration) {
  std::uint64_t seen = 0;
  RunControl control({.threads = 2});
  auto result = enumerate_designs({.v = 12, .k = 4, .change = 1}, 21, control,
                                  [&](const Design&) { ++seen; });
  EXPECT_EQ(result.forms, 2554U);
  EXPECT_EQ(seen, 2554U);
}

TEST_F(SearchExamples, Classification) {
  RunControl control({.threads = 2});
  auto classes =
      classify_designs({.v = 9, .k = 4, .change = 1, .kind = Kind::circular}, 12, {}, control);
  EXPECT_EQ(classes.standard_forms, 16U);
  EXPECT_EQ(classes.classes, 2U);
}

TEST_F(SearchExamples, Exact) {
  RunControl control({.time = std::chrono::seconds(60)});
  Decision decision =
      decide({.v = 9, .k = 4, .change = 1}, 11, {.proof_directory = "proofs"}, control);
  EXPECT_TRUE(decision.excluded());
  EXPECT_EQ(decision.parts.front().proof_path, "proofs/linear-m1-v9-k4-b11.drat");
  EXPECT_TRUE(std::filesystem::exists("proofs/linear-m1-v9-k4-b11.cnf"));

  ExactOptions options;
  options.wanted = {.first = {0, 1}, .last = {0, 1}};
  EXPECT_EQ(decide({.v = 6, .k = 3, .change = 1}, 8, options, control).outcome, Outcome::found);
}

TEST_F(SearchExamples, MinimumSearch) {
  RunControl control({.time = std::chrono::minutes(5)});
  MinimumResult result = find_minimum({.v = 12, .k = 4}, {}, control);
  EXPECT_TRUE(result.settled());
  EXPECT_EQ(result.start.blocks, 13U);
  EXPECT_EQ(result.lower, 14U);
  EXPECT_EQ(result.upper(), 14U);
}

TEST_F(SearchExamples, MinimaTable) {
  put("minima.csv", "");
  {
    OutputFile file("minima.csv");
    write_minima({}, file);
    file.commit();
  }
  RunControl control({.time = std::chrono::seconds(60)});
  std::vector<MinimaRow> rows = read_minima(*open_input("minima.csv"));  // of an earlier run
  fill_minima({.changes = {1}, .k_from = 3, .k_to = 3, .v_to = 6}, rows, {}, control,
              [&](const MinimaRow&) {
                OutputFile file("minima.csv");
                write_minima(rows, file);
                file.commit();
              });
  std::string text = minima_markdown(rows);
  EXPECT_EQ(read_minima(*open_input("minima.csv")), rows);
  EXPECT_FALSE(rows.empty());
  EXPECT_THAT(text, HasSubstr("|"));
}

TEST_F(SearchExamples, LocalSearch) {
  RunControl control({.time = std::chrono::seconds(60), .seed = 7});
  ImproveResult found = improve({.v = 30, .k = 6, .change = 2}, {.moves = 1'000'000}, control);
  EXPECT_LE(found.design->block_count(), found.started_from.value());
  EXPECT_FALSE(found.how.empty());
  EXPECT_NE(found.why_stopped, WhyStopped::running);
}

// The blocks of the affine plane of order 3, a Steiner triple system.
std::vector<Block> lines_of_the_plane() {
  return {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {0, 3, 6}, {1, 4, 7}, {2, 5, 8},
          {0, 4, 8}, {1, 5, 6}, {2, 3, 7}, {0, 5, 7}, {1, 3, 8}, {2, 4, 6}};
}

TEST_F(SearchExamples, LockedSearch) {
  RunControl control({.time = std::chrono::seconds(20)});
  LockedResult found =
      search_locked({.v = 12, .k = 4, .change = 1}, {.first = {0, 1, 2}, .expansion_set = true},
                    {.blocks = 21}, control);
  ASSERT_TRUE(found.design);
  EXPECT_EQ(found.design->block_count(), 21U);
  EXPECT_EQ(found.parts.size(), 3U);
}

TEST_F(SearchExamples, Ordering) {
  const std::vector<Block> triples = lines_of_the_plane();
  const std::vector<Block> batches{{0, 1, 4999}, {2, 3}, {1, 2, 3}, {0, 1}};
  std::vector<Block> walk;
  RunControl control({.time = std::chrono::seconds(10)});
  const ChangeOrder order =
      order_for_change(triples, {.v = 9, .m = 2, .kind = Kind::circular}, {}, control);
  if (order.outcome == Outcome::found) {
    walk = arranged(triples, order.order);
  }
  ASSERT_THAT(walk, SizeIs(12));
  EXPECT_EQ(verify(Design({.v = 9, .k = 3, .kind = Kind::circular}, walk)).bad_steps, 0U);

  const LeastChangeOrder least = order_for_least_change(batches, {.v = 5000}, {}, control);
  EXPECT_EQ(least.cost, 5U);
  EXPECT_LE(least.lower_bound, least.cost);
}

TEST_F(SearchExamples, Repair) {
  const Design list(Parameters{.v = 6, .k = 4},
                    std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 2, 0}});
  RunControl control({.time = std::chrono::seconds(10)});
  RepairResult mended = repair(list, {}, control);  // few blocks changed
  EXPECT_LE(mended.kept, 3U);
  EXPECT_GE(mended.design->block_count(), 3U);

  const Design beginning(Parameters{.v = 12, .k = 4},
                         std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}});
  ExtendResult longer = extend(beginning, {.blocks = 40}, control);  // the beginning stays
  EXPECT_LE(longer.design->block_count(), 40U);
  EXPECT_EQ(longer.why_stopped, WhyStopped::found);
}

TEST_F(SearchExamples, WantedBesides) {
  const Wanted wanted{.first = {0, 1, 2}, .expansion_set = true};
  EXPECT_EQ(wanted_defect({.v = 12, .k = 4, .change = 1}, wanted), "");
  EXPECT_THAT(wanted_words(wanted),
              HasSubstr(" that begins with {0,1,2} and has disjoint unchanged subsets that hold"));
}

}  // namespace
}  // namespace changeover::test::search_examples_test
