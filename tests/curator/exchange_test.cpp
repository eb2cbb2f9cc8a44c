#include "changeover/curator/curator.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "changeover/catalog/entry.hpp"
#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "message_of.hpp"
#include "run_program.hpp"

namespace changeover::test::exchange_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

CatalogEntry entry_for(const Parameters& p) {
  const Registry& registry = Registry::standard();
  return *newcomer_of(registry.build_design(registry.best(p).value().recipe), {}).entry;
}

std::vector<CatalogEntry> some_entries() {
  std::vector<CatalogEntry> entries;
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (std::uint64_t v = 5; v < 14; ++v) {
      for (const std::uint64_t k : {3U, 4U}) {
        entries.push_back(entry_for({.v = v, .k = k, .change = 1, .kind = kind}));
      }
    }
  }
  return entries;
}

std::string exported(const Catalog& catalog) {
  StringSink sink;
  write_entries(catalog, {.best_only = false, .users_only = true}, sink);
  return sink.text();
}

Foreign read(const std::string& text, const Catalog& catalog, const ForeignLimits& limits = {}) {
  const auto input = input_from_text(text, "theirs.jsonl");
  return read_foreign(*input, catalog, limits);
}

std::string refusal(const std::string& text, const ForeignLimits& limits = {}) {
  const Catalog nothing({});
  return message_of([&] { static_cast<void>(read(text, nothing, limits)); });
}

std::string file_of(const std::vector<CatalogEntry>& entries) {
  std::string text = header_line({}) + "\n";
  for (const CatalogEntry& entry : entries) {
    text += line_of(entry, {}) + "\n";
  }
  return text;
}

TEST(Exchange, ThereAndBack) {
  const TemporaryFolder folder;
  Catalog mine({.user = folder.file("mine.db")});
  mine.add(some_entries());
  mine.retract(some_entries()[3].label(), "to see whether it is kept");
  const std::string text = exported(mine);
  Catalog theirs({.user = folder.file("theirs.db")});
  const Foreign foreign = read(text, theirs);
  EXPECT_EQ(foreign.entries.size(), some_entries().size());
  EXPECT_EQ(foreign.known, 0U);
  theirs.add(foreign.entries);
  EXPECT_EQ(exported(theirs), text);
  EXPECT_EQ(read(text, theirs).known, some_entries().size());
}

// What a recipe makes can be larger than all that the entry says.
TEST(Exchange, ARecipeTakesNoMoreThanIsAllowed) {
  const Parameters p{.v = 200, .k = 50, .change = 2, .kind = Kind::circular};
  std::mt19937 random(1);
  std::vector<Block> base;
  for (int i = 0; i < 50; ++i) {
    Block all(p.v);
    std::iota(all.begin(), all.end(), Element{0});
    std::ranges::shuffle(all, random);
    all.resize(p.k);
    base.push_back(all);
  }
  CatalogEntry entry;
  entry.parameters = p;
  entry.b = 20;
  entry.lower_bound = 1;
  entry.reason = "trivial";
  const Recipe developed{"developed", p, {{"n", 200}, {"f", 0}, {"shift", 1}}, {}, base, ""};
  entry.recipe = Recipe{"drop", p, {}, {developed}, {}, ""};
  EXPECT_THAT(refusal(file_of({entry}), {.memory_each = 1U << 20}), HasSubstr("of memory"));
  EXPECT_THAT(refusal(file_of({entry}), {.time_each = std::chrono::microseconds(1)}),
              HasSubstr("building and verifying it takes longer than "));
  // Blocks that are read one by one take no memory, but time.
  entry.recipe = developed;
  entry.b = 10'000;
  EXPECT_THAT(refusal(file_of({entry}), {.memory_each = 1U << 20}),
              HasSubstr("its blocks do not have the checksum of the entry"));
  EXPECT_THAT(refusal(file_of({entry}), {.time_each = std::chrono::microseconds(1)}),
              HasSubstr("takes longer than"));
}

TEST(Exchange, NothingIsBelieved) {
  const CatalogEntry good = entry_for({.v = 9, .k = 4, .change = 2, .kind = Kind::circular});
  EXPECT_EQ(refusal(file_of({good})), "");
  const auto with = [&](auto&& change) {
    CatalogEntry bad = good;
    bad.recipe = literal_recipe(Registry::standard().build_design(good.recipe));
    change(bad);
    return refusal(file_of({good, bad}));
  };
  EXPECT_THAT(with([](CatalogEntry& e) { ++e.b; }), HasSubstr("theirs.jsonl:3: 9.4.2.circular.9."));
  EXPECT_THAT(with([](CatalogEntry& e) { e.b = 100; }), HasSubstr("blocks and not 100"));
  EXPECT_THAT(with([](CatalogEntry& e) {
                std::swap(e.recipe.blocks[0], e.recipe.blocks[1]);
                e.checksum[0] = {};
              }),
              HasSubstr("checksum"));
  EXPECT_THAT(with([](CatalogEntry& e) {
                e.recipe.blocks.pop_back();
                --e.b;
                e.lower_bound = 1;
                const Design shorter(e.parameters, e.recipe.blocks);
                DesignSource source(shorter);
                e.checksum = design_digest(source).checksum;
              }),
              HasSubstr("its blocks are not a design with these parameters"));
  EXPECT_THAT(with([](CatalogEntry& e) {
                e.recipe.construction = "magic";
                e.checksum[0] = {};
              }),
              HasSubstr("magic"));
  // A bound that is not known: one block more, and it says that this is the least.
  CatalogEntry longer = entry_for({.v = 20, .k = 5, .change = 2, .kind = Kind::linear});
  if (longer.status() == "best-known") {
    longer.lower_bound = longer.b;
    EXPECT_THAT(refusal(file_of({longer})), HasSubstr("no more than"));
  }
  CatalogEntry modest = entry_for({.v = 9, .k = 4, .change = 2, .kind = Kind::circular});
  modest.lower_bound = 1;
  modest.reason = "trust me";
  const Catalog nothing({});
  const Foreign foreign = read(file_of({modest}), nothing);
  ASSERT_THAT(foreign.entries, SizeIs(1));
  EXPECT_EQ(foreign.entries[0].reason, good.reason);
  EXPECT_EQ(foreign.entries[0].lower_bound, good.lower_bound);
}

TEST(Exchange, Limits) {
  const std::vector<CatalogEntry> entries = some_entries();
  const std::string text = file_of(entries);
  EXPECT_THAT(refusal(text, {.entries = 3}),
              HasSubstr("theirs.jsonl:5: more than 3 entries; split the file"));
  EXPECT_THAT(refusal(text, {.line = 300}), HasSubstr("too long"));
  EXPECT_THAT(refusal(text, {.v = 7}), HasSubstr("more than 7 elements"));
  EXPECT_THAT(refusal(text, {.b = 5}), HasSubstr("or 5 blocks"));
  EXPECT_THAT(refusal(""), HasSubstr("the file is empty; name one that catalog export wrote"));
  EXPECT_THAT(refusal("0 1 2\n0 1 3\n"), HasSubstr("theirs.jsonl:1:"));
  EXPECT_THAT(refusal("{\"format\":\"changeover-catalog/2\"}\n"), HasSubstr("newer"));
  EXPECT_THAT(refusal(text + "x\n"), HasSubstr("theirs.jsonl:"));
}

TEST(Exchange, LeavesOutWhatIsBadAndNamesIt) {
  std::vector<CatalogEntry> entries = some_entries();
  const std::string good = line_of(entries[0], {});
  ++entries[1].lower_bound;
  entries[1].lower_bound = entries[1].b;
  const Catalog nothing({});
  const Foreign foreign =
      read(header_line({}) + "\n" + good + "\nx\n" + good + "\n{}\n" + line_of(entries[2], {}),
           nothing, {.skip_bad = true});
  EXPECT_THAT(foreign.entries, SizeIs(2));
  EXPECT_EQ(foreign.known, 1U);
  EXPECT_THAT(foreign.left_out,
              ElementsAre(HasSubstr("theirs.jsonl:3:"), HasSubstr("theirs.jsonl:5:")));
}

// What a file says of a catalog of one's own, through import_foreign().
Imported import(const std::string& text, Catalog& catalog, const ForeignLimits& limits = {},
                std::size_t batch = 1000) {
  const auto input = input_from_text(text, "theirs.jsonl");
  return import_foreign(*input, catalog, limits, batch);
}

TEST(Import, InBatchesAsAtOnce) {
  const TemporaryFolder folder;
  std::vector<CatalogEntry> entries = some_entries();
  entries[3].retracted = "a mistake";
  entries.push_back(entries[2]);
  Catalog whole({.user = folder.file("whole.db")});
  whole.add(read(file_of(entries), whole).entries);
  for (const std::size_t batch : {1U, 5U, 1000U}) {
    Catalog mine({.user = folder.file(std::to_string(batch) + ".db")});
    mine.add(entries[7]);
    const Imported first = import(file_of(entries), mine, {}, batch);
    EXPECT_EQ(first.added, entries.size() - 2);
    EXPECT_EQ(first.improved, entries.size() - 3);  // What is retracted is no better.
    EXPECT_EQ(first.known, 2U);
    EXPECT_EQ(first.not_added, 0U);
    EXPECT_EQ(exported(mine), exported(whole));
    const Imported again = import(file_of(entries), mine, {}, batch);
    EXPECT_EQ(again.added, 0U);
    EXPECT_EQ(again.known, entries.size());
  }
}

TEST(Import, NothingUnlessTheWholeFileIsGood) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  Catalog mine({.user = path});
  const std::string text = file_of(some_entries());
  EXPECT_THROW(import(text + "x\n", mine, {}, 2), BadInput);
  EXPECT_FALSE(std::filesystem::exists(path));
  const Imported imported = import(text + "x\n", mine, {.skip_bad = true}, 2);
  EXPECT_EQ(imported.added, some_entries().size());
  EXPECT_THAT(imported.left_out, SizeIs(1));
  // Two designs with one label: the second is not the first.
  CatalogEntry good = entry_for({.v = 15, .k = 4, .change = 2, .kind = Kind::linear});
  CatalogEntry other = good;
  other.checksum.back() = static_cast<std::uint8_t>(other.checksum.back() ^ 1U);
  mine.add(good);
  EXPECT_THROW(import(file_of({other}), mine), BadInput);
  EXPECT_THAT(refusal(file_of({other})), HasSubstr("checksum"));
}

TEST(Import, StopsBetweenBatchesAndGoesOn) {
  const TemporaryFolder folder;
  Catalog mine({.user = folder.file("mine.db")});
  const std::vector<CatalogEntry> entries = some_entries();  // Not under a control that stops.
  const std::string text = file_of(entries);
  {
    RunControl control(RunControl::Settings{});
    control.stop(WhyStopped::interrupted);
    const RunScope scope(control);
    EXPECT_THROW(import(text, mine), Stopped);
    EXPECT_FALSE(std::filesystem::exists(folder.file("mine.db")));
  }
  std::uint64_t left = 0;
  {
    RunControl* running = nullptr;
    RunControl control({.on_progress =
                            [&](const Progress& progress) {
                              if (progress.phase.starts_with("adding")) {
                                running->stop(WhyStopped::interrupted);
                              }
                            },
                        .progress_interval = std::chrono::seconds(0)});
    running = &control;
    const RunScope scope(control);
    const Imported imported = import(text, mine, {}, 3);
    EXPECT_EQ(imported.added, 3U);
    left = imported.not_added;
    EXPECT_EQ(left, entries.size() - 3);
  }
  const Imported rest = import(text, mine, {}, 3);
  EXPECT_EQ(rest.added, left);
  EXPECT_EQ(rest.known, 3U);
}

// Files that were put together have byte order marks on their way.
TEST(Import, ByteOrderMarks) {
  const TemporaryFolder folder;
  Catalog mine({.user = folder.file("mine.db")});
  const std::string mark = "\xEF\xBB\xBF";
  const CatalogEntry entry = some_entries()[0];
  EXPECT_EQ(
      import(mark + header_line({}) + "\n" + mark + "\n" + mark + line_of(entry, {}), mine).added,
      1U);
  // What is wrong is said as without it, three bytes further on.
  std::string line = line_of(entry, {});
  line.insert(line.find("\"b\":") + 4, "-");
  const std::string said = refusal(header_line({}) + "\n" + line);
  const std::string with_mark = refusal(header_line({}) + "\n" + mark + line);
  const std::size_t at = line.find("\"b\":") + 5;
  const auto place = [](std::size_t column) { return fmt::format("theirs.jsonl:2:{}: ", column); };
  ASSERT_TRUE(said.starts_with(place(at))) << said;
  EXPECT_EQ(with_mark, place(at + 3) + said.substr(place(at).size()));
}

TEST(Exchange, Stops) {
  RunControl control(RunControl::Settings{});
  control.stop(WhyStopped::interrupted);
  const RunScope scope(control);
  const Catalog nothing({});
  EXPECT_THROW(static_cast<void>(read(file_of(some_entries()), nothing)), Stopped);
}

TEST(Compare, CellByCell) {
  const Parameters a{.v = 5, .k = 3}, b{.v = 6, .k = 3}, c{.v = 7, .k = 3}, d{.v = 8, .k = 3},
      e{.v = 9, .k = 3};
  std::vector<std::string> said;
  for (const CellChange& change :
       compare_cells({{a, 5}, {b, 6}, {c, 7}, {d, 8}}, {{a, 5}, {b, 5}, {c, 8}, {e, 9}})) {
    said.push_back(std::string(change.kind()) + " " + std::to_string(change.parameters.v) + " " +
                   std::to_string(change.before) + " " + std::to_string(change.after));
  }
  EXPECT_THAT(said, ElementsAre("better 6 6 5", "worse 7 7 8", "gone 8 8 0", "new 9 0 9"));
}

TEST(Compare, AFileAndItsCatalog) {
  const TemporaryFolder folder;
  Catalog mine({.user = folder.file("mine.db")});
  mine.add(some_entries());
  mine.retract(some_entries()[0].label(), "no");
  const auto input = input_from_text(exported(mine), "f");
  const BestOfCells file = best_of_cells(*input);
  EXPECT_EQ(file.size(), some_entries().size() - 1);
  EXPECT_EQ(file, best_of_cells(mine));
}

TEST(Audit, FindsWhatIsWrong) {
  const TemporaryFolder folder;
  Catalog mine({.user = folder.file("mine.db")});
  std::vector<CatalogEntry> entries = some_entries();
  mine.add(entries);
  RunControl control({.threads = 2});
  EXPECT_EQ(audit_catalog(mine, {.best_only = false}, control).faults.size(), 0U);
  // The catalog itself trusts its callers.
  CatalogEntry liar = entry_for({.v = 20, .k = 5, .change = 2, .kind = Kind::linear});
  liar.recipe = literal_recipe(Registry::standard().build_design(liar.recipe));
  std::swap(liar.recipe.blocks.front(), liar.recipe.blocks.back());
  mine.add(liar);
  const AuditScope scope = audit_scope(mine, {.best_only = false});
  EXPECT_THAT(scope.labels, SizeIs(entries.size() + 1));
  std::set<std::string> good;
  const Audit audit = audit_entries(mine, scope, control, {entries[0].label()},
                                    [&](const std::string& label) { good.insert(label); });
  EXPECT_EQ(audit.checked, entries.size());
  EXPECT_TRUE(audit.complete(1));
  EXPECT_FALSE(audit.complete());
  ASSERT_THAT(audit.faults, SizeIs(1));
  EXPECT_EQ(audit.faults[0].label, liar.label());
  EXPECT_THAT(audit.faults[0].what, HasSubstr("checksum"));
  EXPECT_EQ(good.size(), entries.size() - 1);
  EXPECT_NE(audit_scope(mine, {}).checksum, audit_scope(mine, {.v_to = 8}).checksum);
  CatalogEntry proud = entries[5];
  proud.b += 3;
  proud.lower_bound = proud.b;
  EXPECT_THAT(fault_of_entry(proud), HasSubstr("blocks and not"));
  CatalogEntry claims = entries[5];
  claims.lower_bound = 1000;
  EXPECT_THAT(fault_of_entry(claims), HasSubstr("it claims the lower bound 1000, but only "));
  RunControl stopped(RunControl::Settings{});
  stopped.stop(WhyStopped::interrupted);
  EXPECT_FALSE(audit_catalog(mine, {}, stopped).complete());
}

}  // namespace
}  // namespace changeover::test::exchange_test
