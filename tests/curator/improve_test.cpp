#include "changeover/curator/curator.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "changeover/catalog/entry.hpp"
#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "run_program.hpp"

namespace changeover::test::improve_test {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

// A design with one block more than needed: the last one comes twice over a detour, so nothing is
// better known here.
CatalogEntry poor_entry() {
  const Parameters p{.v = 4, .k = 3, .change = 1, .kind = Kind::linear};
  const Design design(p, std::vector<Block>{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}});
  return *newcomer_of(design, {}).entry;
}

TEST(Improve, FindsAndAddsAtOnce) {
  const TemporaryFolder folder;
  Catalog catalog({.user = folder.file("mine.db")});
  const CatalogEntry poor = poor_entry();
  ASSERT_EQ(poor.status(), "best-known");
  catalog.add(poor);
  RunControl control({.time = std::chrono::seconds(60)});
  std::vector<std::string> labels;
  const auto finds = improve_catalog(
      catalog, {}, control,
      {.introduction =
           {.credit = {.who = "me", .date = "2026-11-22", .program = "", .command = ""}}},
      [&](const CatalogFind& find) {
        labels.push_back(find.label);
        EXPECT_TRUE(Catalog({.user = folder.file("mine.db")}).find(find.label));
      });
  ASSERT_THAT(finds, SizeIs(1));
  EXPECT_THAT(labels, SizeIs(1));
  EXPECT_EQ(finds[0].before, 4U);
  EXPECT_EQ(finds[0].b, 3U);
  const auto best = catalog.best(poor.parameters);
  EXPECT_EQ(best->label(), finds[0].label);
  EXPECT_EQ(best->credit.who, "me");
  EXPECT_EQ(best->status(), "minimum");
  EXPECT_EQ(fault_of_entry(*best), "");
  // Nothing is left to gain, so nothing is waited for.
  EXPECT_THAT(improve_catalog(catalog, {}, control), SizeIs(0));
}

TEST(Improve, StopsWhenAsked) {
  const TemporaryFolder folder;
  Catalog catalog({.user = folder.file("mine.db")});
  catalog.add(poor_entry());
  RunControl control(RunControl::Settings{});
  control.stop(WhyStopped::interrupted);
  EXPECT_THAT(improve_catalog(catalog, {}, control), SizeIs(0));
  EXPECT_EQ(catalog.best(poor_entry().parameters)->b, 4U);
}

std::string submitted(const Catalog& catalog, std::size_t left_out = 0) {
  StringSink sink;
  const Submission submission = write_submission(catalog, sink);
  EXPECT_THAT(submission.left_out, SizeIs(left_out));
  return sink.text();
}

// What the user has is held against what is shipped, here a poor design of a cell that no
// construction serves better.
TEST(Submission, IsWhatIsBetterThanWhatIsShipped) {
  const TemporaryFolder folder;
  const Parameters p{.v = 20, .k = 9, .change = 4, .kind = Kind::linear};
  const Registry constructions(registry_entries());
  const Registry& registry = Registry::standard();
  const auto offer = registry.best(p);
  ASSERT_TRUE(offer);
  const Design good = registry.build_design(offer->recipe);
  Design longer = good;
  longer.append(good.block(good.block_count() - 2));  // There and back.
  const CatalogEntry good_entry = *newcomer_of(good, {}).entry;
  const CatalogEntry long_entry = *newcomer_of(longer, {}).entry;
  ASSERT_EQ(long_entry.b, good_entry.b + 1);
  const auto image = make_catalog(std::span(&long_entry, 1));
  Catalog catalog({.shipped = image, .user = folder.file("mine.db")});
  EXPECT_EQ(submitted(catalog), header_line({}) + "\n");
  catalog.add(good_entry);
  // A tree that makes fewer blocks than all that is shipped is news; a list of blocks that a
  // construction equals is none.
  const bool is_tree = !good_entry.carries_blocks();
  EXPECT_EQ(submitted(catalog),
            header_line({}) + "\n" + (is_tree ? line_of(good_entry, {}) + "\n" : ""));
  const auto better = make_catalog(std::span(&good_entry, 1));
  Catalog other({.shipped = better, .user = folder.file("other.db")});
  other.add(long_entry);
  EXPECT_EQ(submitted(other), header_line({}) + "\n");
}

TEST(Submission, LeavesOutWhatIsNotAsItSays) {
  const TemporaryFolder folder;
  Catalog catalog({.user = folder.file("mine.db")});
  const Parameters p{.v = 4, .k = 3, .change = 1, .kind = Kind::linear};
  CatalogEntry liar =
      *newcomer_of(Design(p, std::vector<Block>{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}}), {}).entry;
  liar.recipe.blocks.pop_back();
  liar.b = 2;
  liar.lower_bound = 1;
  catalog.add(liar);
  EXPECT_EQ(submitted(catalog, 1), header_line({}) + "\n");
}

}  // namespace
}  // namespace changeover::test::improve_test
