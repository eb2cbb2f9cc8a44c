// Files that are not what they should be: said, never written to, never the end of the process.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <set>

#include "../entries.hpp"
#include "catalog/store/database.hpp"
#include "catalog/store/schema.hpp"
#include "changeover/catalog/catalog.hpp"
#include "run_program.hpp"

namespace changeover::test::damage_test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

const Parameters cell{.v = 6, .k = 3, .change = 2, .kind = Kind::linear};

CatalogEntry some_entry(std::uint64_t b = 5, unsigned seed = 1) {
  std::mt19937 random(seed);
  return random_entry(cell, b, random);
}

// Everything that reads, without a fault; then everything that writes, refused, and the file as it
// was.
void expect_unusable(const std::string& path, const std::string& words) {
  const bool is_file = std::filesystem::is_regular_file(path);
  const std::string before = is_file ? slurp(path) : "";
  {
    const CatalogEntry shipped = some_entry(7, 2);
    const auto image = make_catalog(std::span(&shipped, 1));
    Catalog catalog({.shipped = image, .user = path});
    EXPECT_EQ(catalog.best(cell), shipped);
    EXPECT_THAT(catalog.problem(), HasSubstr(words));
    EXPECT_THAT(catalog.problem(), HasSubstr(path));
    EXPECT_EQ(labels_of(catalog, {}).size(), 1U);
    EXPECT_THAT(fault_of([&] { catalog.add(some_entry()); }), HasSubstr(words));
    EXPECT_NE(fault_of([&] { catalog.retract(shipped.label(), "x"); }), "");
    EXPECT_NE(fault_of([&] { catalog.alias("x", shipped.label()); }), "");
    EXPECT_EQ(catalog.best(cell), shipped);
  }
  if (is_file) {
    EXPECT_EQ(slurp(path), before);
  }
}

TEST(CatalogFile, OfAnotherProgram) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  Database::open(path, Access::create).run("CREATE TABLE recipes(pancakes)");
  expect_unusable(path, "not a catalog of changeover");
}

TEST(CatalogFile, OfANewerProgram) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  Catalog({.user = path}).add(some_entry());
  Database::open(path, Access::read_write).run("PRAGMA user_version = 2");
  expect_unusable(path, "written by a newer program");
}

TEST(CatalogFile, OfAVersionThatNeverWas) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  Catalog({.user = path}).add(some_entry());
  Database::open(path, Access::read_write).run("PRAGMA user_version = 0");
  expect_unusable(path, "is not known");
}

TEST(CatalogFile, ThatIsText) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  spit(path, std::string(5000, 'x'));
  expect_unusable(path, "not a catalog");
}

TEST(CatalogFile, ThatIsAFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "mine.db");
  expect_unusable(folder.file("mine.db"), "name another file with --catalog");
}

TEST(CatalogFile, OfNoBytes) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  spit(path, "");
  Catalog catalog({.user = path});
  EXPECT_FALSE(catalog.best(cell));
  EXPECT_EQ(catalog.problem(), "");
  EXPECT_EQ(catalog.add(some_entry()), Added::improved);
  EXPECT_EQ(catalog.best(cell), some_entry());
}

TEST(CatalogFile, InAFolderThatIsNotThere) {
  const TemporaryFolder folder;
  Catalog catalog({.user = folder.file("a/b/mine.db")});
  EXPECT_EQ(catalog.add(some_entry()), Added::improved);
  spit(folder.file("c"), "");
  Catalog beneath({.user = folder.file("c/mine.db")});
  EXPECT_FALSE(beneath.best(cell));
  EXPECT_THAT(fault_of([&] { beneath.add(some_entry()); }), HasSubstr("cannot make the folder"));
}

TEST(CatalogFile, ReadOnly) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  Catalog({.user = path}).add(some_entry());
  std::filesystem::permissions(path, std::filesystem::perms::owner_read);
  std::filesystem::permissions(
      folder.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  const std::string before = slurp(path);
  {
    Catalog catalog({.user = path});
    EXPECT_EQ(catalog.best(cell), some_entry());
    EXPECT_EQ(catalog.problem(), "");
    if (::geteuid() != 0) {  // Who may do anything is refused nothing.
      EXPECT_THAT(fault_of([&] { catalog.add(some_entry(4, 3)); }),
                  HasSubstr("; allow writing there, or name another file with --catalog"));
      EXPECT_EQ(slurp(path), before);
      EXPECT_EQ(catalog.best(cell), some_entry());
    }
  }
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
}

// Bytes are changed at random. Whatever the file then is, reading ends without a fault of ours,
// what it hands out has the label that was asked for, and a file that is found damaged is not
// written to.
TEST(CatalogFile, WithBytesChanged) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  std::mt19937 random(5);
  {
    Catalog catalog({.user = path});
    std::vector<CatalogEntry> entries;
    std::set<std::string> labels;
    while (entries.size() < 40) {
      const CatalogEntry entry = random_entry(random);
      if (labels.insert(entry.label()).second) {
        entries.push_back(entry);
      }
    }
    catalog.add(entries);
    catalog.add(some_entry());
    catalog.retract(entries[0].label(), "no");
    catalog.alias("nice", entries[1].label());
  }
  const std::string good = slurp(path);
  ASSERT_FALSE(std::filesystem::exists(path + "-wal"));
  int unusable = 0;
  int refused = 0;
  for (unsigned i = 0; i < 300; ++i) {
    std::string bad = good;
    const std::size_t flips = std::size_t{1} + (i % 3 == 0 ? random() % 200 : random() % 3);
    for (std::size_t flip = 0; flip < flips; ++flip) {
      // Every second time in the first page, where the shape is.
      const std::size_t at = random() % (i % 2 == 0 ? std::size_t{4096} : bad.size());
      bad[at] = static_cast<char>(static_cast<unsigned char>(bad[at]) ^ (1U << (random() % 8)));
    }
    if (i % 10 == 9) {
      bad.resize(random() % bad.size());
    }
    std::filesystem::remove(path + "-wal");
    std::filesystem::remove(path + "-shm");
    spit(path, bad);
    {
      Catalog catalog({.user = path});
      static_cast<void>(catalog.best(cell));
      static_cast<void>(catalog.fewest(cell, true));
      if (const auto entry = catalog.find(some_entry().label())) {
        EXPECT_EQ(entry->label(), some_entry().label());
      }
      static_cast<void>(catalog.find("nice"));
      static_cast<void>(catalog.cell(cell));
      static_cast<void>(catalog.history(cell));
      static_cast<void>(labels_of(catalog, {.best_only = false}));
      static_cast<void>(catalog.largest_users_v());
      unusable += catalog.problem().empty() ? 0 : 1;
      EXPECT_EQ(slurp(path), bad) << i << " " << catalog.problem();
      std::string said;
      EXPECT_NO_THROW(said = fault_of([&] { catalog.add(some_entry(4, 3)); })) << i;
      if (!said.empty()) {
        ++refused;
        EXPECT_THAT(said, HasSubstr(path));
        EXPECT_EQ(said.find('\n'), std::string::npos);
      }
      if (!said.empty()) {
        EXPECT_EQ(slurp(path), bad) << i << " " << said;
      }
    }
  }
  EXPECT_GT(unusable, 50);
  EXPECT_GT(refused, 50);
}

TEST(CatalogFile, WithARowInTheCellOfAnother) {
  const Parameters other{.v = 7, .k = 3, .change = 2, .kind = Kind::linear};
  for (const std::string change : {"v = 7", "v = 7, b = 4", "b = 4"}) {
    const TemporaryFolder folder;
    const std::string path = folder.file("mine.db");
    Catalog({.user = path}).add(some_entry());
    Database::open(path, Access::read_write).run("UPDATE design SET " + change);
    for (const Parameters& p : {cell, other}) {
      EXPECT_FALSE(Catalog({.user = path}).best(p));
      EXPECT_FALSE(Catalog({.user = path}).fewest(p));
    }
    Catalog catalog({.user = path});
    EXPECT_FALSE(catalog.find(some_entry().label()));
    EXPECT_THAT(catalog.problem(), HasSubstr("is damaged (it is in the place of a design"));
  }
}

TEST(CatalogFile, WithoutACreditOfADesign) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  Catalog({.user = path}).add(some_entry());
  Database::open(path, Access::read_write).run("PRAGMA foreign_keys = OFF; DELETE FROM credit");
  const Catalog catalog({.user = path});
  EXPECT_FALSE(catalog.find(some_entry().label()));
  EXPECT_THAT(catalog.problem(), HasSubstr("the entry " + some_entry().label() + " is damaged"));
}

// A step to a version that is not there yet.
constexpr Migration to_two[] = {
    {.from = catalog_schema_version, .sql = "ALTER TABLE design ADD COLUMN colour TEXT"}};
constexpr Migration broken[] = {
    {.from = catalog_schema_version,
     .sql = "ALTER TABLE design ADD COLUMN x TEXT; ALTER TABLE nothing ADD COLUMN y"}};

TEST(Migration, KeepsACopy) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  Catalog({.user = path}).add(some_entry());
  spit(path + ".version-1", "a user's");
  {
    const Database database = Database::open(path, Access::read_write);
    check_catalog(database, 2, to_two);
    migrate(database, 2, to_two);
    migrate(database, 2, to_two);  // Nothing is left to do.
    EXPECT_EQ(database.integer("PRAGMA user_version"), 2U);
    EXPECT_EQ(database.integer("SELECT count(colour) + count(*) FROM design"), 1U);
  }
  EXPECT_EQ(slurp(path + ".version-1"), "a user's");
  EXPECT_FALSE(std::filesystem::exists(path + ".version-1.3"));
  EXPECT_EQ(Catalog({.user = path + ".version-1.2"}).best(cell), some_entry());
  EXPECT_THAT(Catalog({.user = path}).problem(), HasSubstr("newer program"));
}

// Killed at random moments: the file is of one version or the other, with all that was in it, and
// each copy is whole.
TEST(Migration, KilledOnItsWay) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  std::mt19937 random(1);
  std::vector<CatalogEntry> entries;
  for (std::uint64_t b = 1; b <= 300; ++b) {
    entries.push_back(random_entry(cell, b, random));
  }
  Catalog({.user = path}).add(entries);
  const std::string old = slurp(path);
  int killed_before = 0;
  int killed_after = 0;
  useconds_t longest = 1;  // Twice what the first round takes, in which nothing is killed.
  for (int round = 0; round < 60; ++round) {
    std::filesystem::remove(path + "-wal");
    std::filesystem::remove(path + "-shm");
    spit(path, old);
    const auto begin = std::chrono::steady_clock::now();
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      migrate(Database::open(path, Access::read_write), 2, to_two);
      ::_exit(0);
    }
    if (round > 0) {
      ::usleep(static_cast<useconds_t>(random()) % longest);
      ::kill(child, SIGKILL);
    }
    ASSERT_EQ(::waitpid(child, nullptr, 0), child);
    if (round == 0) {
      longest = 2 * static_cast<useconds_t>(std::chrono::duration_cast<std::chrono::microseconds>(
                                                std::chrono::steady_clock::now() - begin)
                                                .count());
    }
    const Database database = Database::open(path, Access::read_write);
    EXPECT_EQ(database.integer("SELECT count(*) FROM design"), entries.size());
    EXPECT_NO_THROW(check_catalog(database, 2, to_two));
    ++(database.integer("PRAGMA user_version") == 1 ? killed_before : killed_after);
    for (const auto& file : std::filesystem::directory_iterator(folder.path())) {
      const std::string name = file.path().filename();
      if (name.find(".version-1") != std::string::npos &&
          name.find("unfinished") == std::string::npos) {
        Catalog copy({.user = file.path()});
        EXPECT_EQ(labels_of(copy, {.best_only = false}).size(), entries.size()) << name;
        EXPECT_EQ(copy.problem(), "") << name;
      }
      if (name.find(".version-1") != std::string::npos) {
        std::filesystem::remove(file.path());
      }
    }
    if (database.integer("PRAGMA user_version") == 1) {
      migrate(database, 2, to_two);  // Nothing of the first time is in its way.
      EXPECT_EQ(database.integer("PRAGMA user_version"), 2U);
    }
  }
  EXPECT_GT(killed_before, 0);
  EXPECT_GT(killed_after, 0);
}

TEST(Migration, AllOrNothing) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  Catalog({.user = path}).add(some_entry());
  {
    const Database database = Database::open(path, Access::read_write);
    EXPECT_ANY_THROW(migrate(database, 2, broken));
  }
  EXPECT_EQ(Catalog({.user = path}).best(cell), some_entry());
  EXPECT_EQ(Catalog({.user = path}).problem(), "");
  const Database database = Database::open(path, Access::read_write);
  EXPECT_THAT(fault_of([&] { check_catalog(database, 3, to_two); }), testing::IsEmpty());
  EXPECT_ANY_THROW(migrate(database, 3, to_two));  // Nothing leads from 2 to 3.
  EXPECT_EQ(database.integer("PRAGMA user_version"), 1U);
}

}  // namespace
}  // namespace changeover::test::damage_test
