// The catalog against what a list of entries says.
#include "changeover/catalog/catalog.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <thread>

#include "../entries.hpp"
#include "run_program.hpp"

namespace changeover::test::catalog_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const Parameters cell{.v = 6, .k = 3, .change = 2, .kind = Kind::linear};

// Distinct entries, and which of them come with the program.
struct Stock {
  std::vector<CatalogEntry> shipped, own;
  std::vector<std::byte> image;

  Stock(unsigned seed, int count) {
    std::mt19937 random(seed);
    std::map<std::string, CatalogEntry> all;
    for (int i = 0; i < count; ++i) {
      CatalogEntry entry = random_entry(random);
      if (random() % 3 == 0) {
        entry.recipe = Recipe{"cut", entry.parameters, {}, {entry.recipe}, {}, ""};
      }
      if (random() % 6 == 0) {
        entry.retracted = "a mistake";
      }
      all.emplace(entry.label(), entry);
    }
    for (const auto& [label, entry] : all) {
      (random() % 2 == 0 ? shipped : own).push_back(entry);
    }
    image = make_catalog(shipped);
  }

  [[nodiscard]] std::vector<std::pair<CatalogEntry, bool>> all() const {
    std::vector<std::pair<CatalogEntry, bool>> both;
    for (const CatalogEntry& entry : shipped) {
      both.emplace_back(entry, false);
    }
    for (const CatalogEntry& entry : own) {
      both.emplace_back(entry, true);
    }
    std::ranges::sort(both, {}, [](const auto& each) {
      const CatalogEntry& e = each.first;
      const Parameters& p = e.parameters;
      return std::tuple(p.change, p.strength, p.kind == Kind::circular, p.k, p.v, e.b, each.second,
                        e.carries_blocks(), e.label());
    });
    return both;
  }
};

TEST(Catalog, AddsAndFinds) {
  const TemporaryFolder folder;
  std::mt19937 random(1);
  Catalog catalog({.user = folder.file("mine.db")});
  EXPECT_FALSE(catalog.best(cell));
  EXPECT_THAT(catalog.cell(cell), IsEmpty());
  EXPECT_FALSE(std::filesystem::exists(folder.file("mine.db")));  // Looking makes no file.
  const CatalogEntry five = random_entry(cell, 5, random);
  const CatalogEntry four = random_entry(cell, 4, random);
  const CatalogEntry six = random_entry(cell, 6, random);
  EXPECT_EQ(catalog.add(five), Added::improved);
  EXPECT_EQ(catalog.add(five), Added::already_there);
  EXPECT_EQ(catalog.add(six), Added::added);
  EXPECT_EQ(catalog.add(four), Added::improved);
  EXPECT_EQ(catalog.best(cell), four);
  EXPECT_EQ(catalog.cell(cell), (std::vector{four, five, six}));
  EXPECT_EQ(catalog.find(six.label()), six);
  EXPECT_EQ(catalog.fewest(cell)->b, 4U);
  EXPECT_EQ(catalog.largest_users_v(), 6U);
  Catalog again({.user = folder.file("mine.db")});
  EXPECT_EQ(again.cell(cell), (std::vector{four, five, six}));
  EXPECT_EQ(again.problem(), "");
}

TEST(Catalog, CountsWhatThereIs) {
  const TemporaryFolder folder;
  const Stock stock(3, 60);
  Catalog catalog({.shipped = stock.image, .user = folder.file("mine.db")});
  const auto expect_size = [&](const std::vector<CatalogEntry>& entries) {
    std::set<Parameters> cells;
    std::string latest;
    for (const CatalogEntry& entry : entries) {
      cells.insert(entry.parameters);
      latest = std::max(latest, entry.credit.date);
    }
    const Catalog::Size size = catalog.size();
    EXPECT_EQ(size.designs, entries.size());
    EXPECT_EQ(size.cells, cells.size());
    EXPECT_EQ(size.latest, latest);
  };
  expect_size(stock.shipped);
  catalog.add(stock.own);
  std::vector<CatalogEntry> all = stock.shipped;
  all.insert(all.end(), stock.own.begin(), stock.own.end());
  expect_size(all);
  EXPECT_EQ(Catalog(Catalog::Files{}).size().designs, 0U);
}

TEST(Catalog, SeesWhatOthersAdd) {
  const TemporaryFolder folder;
  std::mt19937 random(1);
  const CatalogEntry five = random_entry(cell, 5, random);
  const CatalogEntry four = random_entry(cell, 4, random);
  Catalog mine({.user = folder.file("mine.db")});
  mine.add(five);
  EXPECT_TRUE(mine.find(five.label()));
  EXPECT_EQ(mine.best(cell), five);
  Catalog theirs({.user = folder.file("mine.db")});
  theirs.add(four);
  EXPECT_EQ(mine.best(cell), four);
  EXPECT_EQ(mine.fewest(cell)->b, 4U);
  theirs.retract(four.label(), "no");
  EXPECT_EQ(mine.best(cell), five);
}

TEST(Catalog, FindsByTheBeginning) {
  const TemporaryFolder folder;
  std::mt19937 random(2);
  Catalog catalog({.user = folder.file("mine.db")});
  std::map<std::string, CatalogEntry> all;
  for (int i = 0; i < 60; ++i) {
    const CatalogEntry entry = random_entry(cell, 3 + random() % 10, random);
    all.emplace(entry.label(), entry);
    catalog.add(entry);
  }
  const std::string name = cell_label(cell);
  std::set<std::string> asked;
  for (const auto& [label, entry] : all) {
    for (std::size_t length = 0; length <= label.size(); ++length) {
      asked.insert(label.substr(0, length));
    }
  }
  for (const std::string& beginning : asked) {
    std::vector<std::string> matches;
    for (const auto& [label, entry] : all) {
      // More than the cell, and its number of blocks whole.
      const std::size_t dot = label.find('.', name.size() + 1);
      if (label.starts_with(beginning) && beginning.size() >= dot) {
        matches.push_back(label);
      }
    }
    if (matches.size() > 1) {
      EXPECT_THAT(fault_of([&] { static_cast<void>(catalog.find(beginning)); }),
                  HasSubstr("designs have a label that begins with"))
          << beginning;
    } else if (matches.empty()) {
      EXPECT_FALSE(catalog.find(beginning)) << beginning;
    } else {
      ASSERT_TRUE(catalog.find(beginning)) << beginning;
      EXPECT_EQ(catalog.find(beginning)->label(), matches.front());
    }
  }
  for (const char* const nonsense :
       {"", ".", "%", "6.3.2.linear.%", "6.3.2.linear.99", "' OR 1", "*", "6.3.2.linear.t3.4"}) {
    EXPECT_FALSE(catalog.find(nonsense)) << nonsense;
  }
}

TEST(Catalog, Aliases) {
  const TemporaryFolder folder;
  std::mt19937 random(3);
  Catalog catalog({.user = folder.file("mine.db")});
  const CatalogEntry five = random_entry(cell, 5, random);
  const CatalogEntry four = random_entry(cell, 4, random);
  catalog.add(five);
  catalog.add(four);
  catalog.alias("nice", five.label());
  catalog.alias("nice", five.label());
  EXPECT_EQ(catalog.find("nice"), five);
  EXPECT_THAT(fault_of([&] { catalog.alias("nice", four.label()); }),
              HasSubstr(" already; choose another word"));
  EXPECT_THAT(fault_of([&] { catalog.alias(four.label(), five.label()); }),
              HasSubstr("is a label"));
  EXPECT_THAT(fault_of([&] { catalog.alias(cell_label(cell), five.label()); }),
              HasSubstr("is a label"));
  EXPECT_THAT(fault_of([&] { catalog.alias("other", "6.3.2.linear.9.00000000"); }),
              HasSubstr("there is no design"));
  EXPECT_EQ(catalog.find("nice"), five);
}

TEST(Catalog, RetractedIsKeptAndNotUsed) {
  const TemporaryFolder folder;
  std::mt19937 random(4);
  const CatalogEntry shipped = random_entry(cell, 4, random);
  const CatalogEntry own = random_entry(cell, 5, random);
  const auto image = make_catalog(std::span(&shipped, 1));
  Catalog catalog({.shipped = image, .user = folder.file("mine.db")});
  catalog.add(own);
  EXPECT_TRUE(catalog.is_shipped(shipped.label()));
  EXPECT_FALSE(catalog.is_shipped(own.label()));
  catalog.retract(shipped.label(), "its proof was wrong");
  EXPECT_EQ(catalog.best(cell), own);
  EXPECT_EQ(catalog.fewest(cell)->label, own.label());
  EXPECT_EQ(catalog.find(shipped.label())->retracted, "its proof was wrong");
  EXPECT_EQ(catalog.find(shipped.label())->status(), "retracted");
  EXPECT_EQ(catalog.cell(cell).size(), 2U);
  EXPECT_THAT(labels_of(catalog, {.status = "retracted"}), ElementsAre(shipped.label()));
  EXPECT_THAT(labels_of(catalog, {}), ElementsAre(own.label()));
  EXPECT_EQ(catalog.history(cell).size(), 1U);
  EXPECT_THAT(fault_of([&] { catalog.retract("6.3.2.linear.9.00000000", "x"); }),
              HasSubstr("there is no design"));
  Catalog alone({.shipped = image});
  EXPECT_EQ(alone.best(cell), shipped);
  EXPECT_THAT(fault_of([&] { alone.add(own); }), HasSubstr("--catalog"));
  EXPECT_THAT(fault_of([&] { alone.retract(shipped.label(), "x"); }), HasSubstr("--catalog"));
}

TEST(Catalog, HistoryIsOfImprovements) {
  const TemporaryFolder folder;
  std::mt19937 random(5);
  Catalog catalog({.user = folder.file("mine.db")});
  const auto put = [&](std::uint64_t b, const char* date, const char* who) {
    CatalogEntry entry = random_entry(cell, b, random);
    entry.credit = {.who = who, .date = date, .program = "", .command = "by hand"};
    catalog.add(entry);
  };
  put(9, "2026-01-01", "A");
  put(10, "2026-02-01", "too late");
  put(7, "2026-03-01", "B");
  put(7, "2026-03-02", "no better");
  put(5, "2026-03-01", "C");
  put(6, "2026-12-01", "too late");
  std::vector<std::string> steps;
  for (const Improvement& step : catalog.history(cell)) {
    steps.push_back(step.date + " " + std::to_string(step.b) + " " + step.how);
  }
  EXPECT_THAT(steps, ElementsAre("2026-01-01 9 by hand; A", "2026-03-01 7 by hand; B",
                                 "2026-03-01 5 by hand; C"));
}

// Where a design is from comes before how it was made; without either, what constructs it.
TEST(Catalog, HistoryNamesWhatIsCited) {
  const TemporaryFolder folder;
  std::mt19937 random(5);
  Catalog catalog({.user = folder.file("mine.db")});
  const auto put = [&](std::uint64_t b, std::vector<std::string> cites, std::string command,
                       std::string note) {
    CatalogEntry entry = random_entry(cell, b, random);
    entry.cites = std::move(cites);
    entry.note = std::move(note);
    entry.credit = {.who = "A", .date = "2026-01-01", .program = "", .command = std::move(command)};
    catalog.add(entry);
    return entry.recipe.construction;
  };
  const std::string made_by = put(9, {}, "", "");
  put(8, {"One2020"}, "", "table 3");
  put(7, {"One2020", "Two2021"}, "by hand", "");
  std::vector<std::string> steps;
  for (const Improvement& step : catalog.history(cell)) {
    steps.push_back(step.how);
  }
  EXPECT_THAT(steps, ElementsAre(made_by + "; A", "[One2020]; table 3; A",
                                 "[One2020, Two2021]; by hand; A"));
}

// What a filter lets through, entry by entry.
std::vector<std::string> by_hand(const Stock& stock, const CatalogFilter& f) {
  std::vector<std::string> labels;
  std::set<Parameters> taken;
  const bool retracted = f.status == "retracted";
  for (const auto& [e, users] : stock.all()) {
    const Parameters& p = e.parameters;
    const auto from = [](const auto& least, auto value) { return !least || value >= *least; };
    const auto to = [](const auto& most, auto value) { return !most || value <= *most; };
    if (!(from(f.v_from, p.v) && to(f.v_to, p.v) && from(f.k_from, p.k) && to(f.k_to, p.k)) ||
        (f.change && p.change != *f.change) || (f.kind && p.kind != *f.kind) ||
        (f.strength && p.strength != *f.strength) || (f.users_only && !users) ||
        e.retracted.empty() == retracted) {
      continue;
    }
    if (f.best_only && !retracted && !taken.insert(p).second) {
      continue;
    }
    if ((f.status.empty() || e.status() == f.status) &&
        (f.construction.empty() || e.recipe.construction == f.construction) &&
        e.credit.date >= f.since && (!f.gap || e.b - e.lower_bound >= *f.gap)) {
      labels.push_back(e.label());
    }
  }
  return labels;
}

TEST(Catalog, FiltersAndLooksUpAsAListWould) {
  const TemporaryFolder folder;
  const Stock stock(6, 400);
  Catalog catalog({.shipped = stock.image, .user = folder.file("mine.db")});
  catalog.add(stock.own);
  std::mt19937 random(7);
  const auto maybe = [&](std::uint64_t from, std::uint64_t count) {
    return random() % 3 == 0 ? std::optional<std::uint64_t>(from + random() % count) : std::nullopt;
  };
  std::size_t some = 0;
  for (int i = 0; i < 150; ++i) {
    CatalogFilter f;
    f.v_from = maybe(3, 5);
    f.v_to = maybe(3, 5);
    f.k_from = maybe(2, 3);
    f.k_to = maybe(2, 3);
    f.change = maybe(1, 2);
    f.gap = maybe(0, 4);
    if (const auto kind = maybe(0, 2)) {
      f.kind = *kind == 0 ? Kind::linear : Kind::circular;
    }
    if (const auto strength = maybe(2, 2)) {
      f.strength = static_cast<std::uint32_t>(*strength);
    }
    f.status = std::vector<std::string>{"", "", "minimum", "best-known", "retracted"}[random() % 5];
    f.construction = std::vector<std::string>{"", "", "literal", "developed", "none"}[random() % 5];
    f.since = std::vector<std::string>{"", "", "2025-01-31", "2026-01-01"}[random() % 4];
    f.best_only = random() % 2 == 0;
    f.users_only = random() % 3 == 0;
    const std::vector<std::string> expected = by_hand(stock, f);
    ASSERT_EQ(labels_of(catalog, f), expected) << i;
    some += expected.empty() ? 0U : 1U;
  }
  EXPECT_GT(some, 30U);
  std::set<Parameters> cells;
  for (const auto& [entry, users] : stock.all()) {
    if (cells.insert(entry.parameters).second) {
      const Parameters& p = entry.parameters;
      const auto best = by_hand(stock, {.v_from = p.v,
                                        .v_to = p.v,
                                        .k_from = p.k,
                                        .k_to = p.k,
                                        .change = p.change,
                                        .kind = p.kind,
                                        .strength = p.strength});
      const auto found = catalog.best(p);
      const auto fewest = catalog.fewest(p);
      ASSERT_EQ(best.empty(), !found);
      ASSERT_EQ(best.empty(), !fewest);
      if (found) {
        EXPECT_EQ(found->label(), best.front());
        EXPECT_EQ(fewest->label, best.front());
      }
    }
    EXPECT_EQ(catalog.find(entry.label()), entry);
    EXPECT_EQ(catalog.is_shipped(entry.label()), !users);
  }
  int calls = 0;
  catalog.each({}, [&](const CatalogEntry&) { return ++calls < 3; });
  EXPECT_EQ(calls, 3);
  EXPECT_FALSE(catalog.best({.v = std::uint64_t{1} << 63, .k = 3}));
  EXPECT_FALSE(catalog.fewest({.v = std::uint64_t{1} << 63, .k = 3}));
}

TEST(Catalog, AnImageIsAlwaysTheSame) {
  const Stock stock(8, 50);
  EXPECT_EQ(make_catalog(stock.shipped), stock.image);
}

TEST(Catalog, AllOrNothing) {
  const TemporaryFolder folder;
  std::mt19937 random(9);
  Catalog catalog({.user = folder.file("mine.db")});
  const CatalogEntry five = random_entry(cell, 5, random);
  CatalogEntry other = random_entry(cell, 5, random);
  catalog.add(five);
  // Another design whose checksum begins with the same digits.
  other.checksum = five.checksum;
  other.checksum.back() = static_cast<std::remove_reference_t<decltype(other.checksum.back())>>(
      ~static_cast<unsigned>(five.checksum.back()));
  const std::vector<CatalogEntry> both{random_entry(cell, 4, random), other};
  EXPECT_THAT(fault_of([&] { catalog.add(both); }),
              HasSubstr(": another design has that label; write its elements by other numbers"));
  EXPECT_EQ(catalog.cell(cell), std::vector{five});
}

// Two that write at once, each waits for the other.
TEST(Catalog, TwoWriters) {
  const TemporaryFolder folder;
  std::vector<std::vector<CatalogEntry>> stocks(2);
  std::mt19937 random(10);
  for (int i = 0; i < 40; ++i) {
    stocks[i < 20 ? 0 : 1].push_back(random_entry(cell, 5 + static_cast<std::uint64_t>(i), random));
  }
  std::vector<std::thread> writers;
  for (const auto& stock : stocks) {
    writers.emplace_back([&] {
      Catalog catalog({.user = folder.file("mine.db")});
      for (const CatalogEntry& entry : stock) {
        catalog.add(entry);
      }
    });
  }
  for (std::thread& writer : writers) {
    writer.join();
  }
  Catalog catalog({.user = folder.file("mine.db")});
  EXPECT_EQ(catalog.cell(cell).size(), 40U);
  EXPECT_EQ(catalog.problem(), "");
}

TEST(Catalog, DistrustIsOfThisProcess) {
  const TemporaryFolder folder;
  std::mt19937 random(11);
  Catalog catalog({.user = folder.file("mine.db")});
  const CatalogEntry five = random_entry(cell, 5, random);
  catalog.add(five);
  catalog.distrust(five.label(), "no such design");
  EXPECT_FALSE(catalog.best(cell));
  EXPECT_THAT(catalog.problem(), HasSubstr(five.label() + " is left out: no such design"));
  EXPECT_TRUE(Catalog({.user = folder.file("mine.db")}).best(cell));
}

}  // namespace
}  // namespace changeover::test::catalog_test
