// Names of files are paths, whatever they look like, and names of designs are labels, whatever an
// alias says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <random>

#include "../entries.hpp"
#include "catalog/store/database.hpp"
#include "catalog/store/schema.hpp"
#include "catalog/store/store.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/catalog/entry.hpp"
#include "run_program.hpp"

namespace changeover::test::names_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

const Parameters cell{.v = 6, .k = 3, .change = 2, .kind = Kind::linear};

CatalogEntry some_entry(std::uint64_t b = 5, unsigned seed = 1) {
  std::mt19937 random(seed);
  return random_entry(cell, b, random);
}

// Goes into a folder and back.
class InFolder {
 public:
  explicit InFolder(const std::filesystem::path& folder)
      : before_(std::filesystem::current_path()) {
    std::filesystem::current_path(folder);
  }
  ~InFolder() { std::filesystem::current_path(before_); }
  InFolder(const InFolder&) = delete;
  InFolder& operator=(const InFolder&) = delete;

 private:
  std::filesystem::path before_;
};

TEST(CatalogName, IsAPath) {
  const TemporaryFolder folder;
  const InFolder here(folder.path());
  std::filesystem::create_directory("a%20b");
  for (const std::string name :
       {":memory:", "file:zz.db?mode=memory", "file::memory:?cache=shared", "file:x.db",
        "file:///y.db", "a%20b/c#d?e=f.db", "?mode=ro", "-", "~", "mine.db?immutable=1"}) {
    {
      Catalog catalog({.user = name});
      EXPECT_EQ(catalog.add(some_entry()), Added::improved) << name;
      catalog.alias("nice", some_entry().label());
      EXPECT_EQ(catalog.best(cell), some_entry()) << name;
    }
    EXPECT_TRUE(std::filesystem::is_regular_file(name)) << name;
    const Catalog again({.user = name});
    EXPECT_EQ(again.find("nice"), some_entry()) << name;
    EXPECT_EQ(again.problem(), "") << name;
    // The same file by its whole path, also with two slashes in front, and for a reader that may
    // not write.
    const std::string whole = "/" + std::filesystem::absolute(name).string();
    EXPECT_EQ(Catalog({.user = whole}).best(cell), some_entry()) << name;
    for (const std::string& each : {name, whole}) {
      const Database unchanging = Database::open(each, Access::read_unchanging);
      EXPECT_EQ(unchanging.integer("SELECT count(*) FROM design"), 1U) << each;
    }
  }
}

TEST(CatalogName, OfTheCopyThatAMigrationKeeps) {
  const TemporaryFolder folder;
  const InFolder here(folder.path());
  const std::string name = "file:m.db?mode=memory";
  Catalog({.user = name}).add(some_entry());
  constexpr Migration to_two[] = {
      {.from = catalog_schema_version, .sql = "ALTER TABLE design ADD COLUMN colour TEXT"}};
  migrate(Database::open(name, Access::read_write), 2, to_two);
  EXPECT_EQ(Catalog({.user = name + ".version-1"}).best(cell), some_entry());
}

// Each of these is one line for readers and for writers.
TEST(CatalogName, OfWhatIsNoFile) {
  const TemporaryFolder folder;
  const InFolder here(folder.path());
  std::filesystem::create_directory("folder");
  ASSERT_EQ(::mkfifo("fifo", 0666), 0);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strcpy(address.sun_path, "socket");
  ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ::close(socket);
  std::filesystem::create_symlink("loop", "loop");
  std::filesystem::create_symlink("fifo", "link");
  spit("file", "");
  spit("journal.db", "");
  ASSERT_EQ(::mkfifo("journal.db-wal", 0666), 0);
  const std::string deep(240, 'd');
  const std::string long_path = deep + "/" + deep + "/" + deep + "/mine.db";
  std::filesystem::create_directories(std::filesystem::path(long_path).parent_path());
  const std::pair<std::string, std::string> names[] = {
      {"folder", "a folder"},
      {"fifo", "a FIFO"},
      {"link", "a FIFO"},
      {"socket", "a socket"},
      {"/dev/null", "a device"},
      {"/dev/full", "a device"},
      {"loop", "symbolic links"},
      {"file/mine.db", ""},
      {"journal.db", "journal.db-wal: a FIFO"},
      {long_path, "a shorter path"},
      {std::string(300, 'x'), "too long"},
      {std::string("a\0b", 3), "not a path of a file; name a file with --catalog"}};
  for (const auto& [name, words] : names) {
    Catalog catalog({.user = name});
    EXPECT_FALSE(catalog.best(cell)) << name;
    EXPECT_THAT(catalog.problem(), HasSubstr(words));
    const std::string said = fault_of([&] { catalog.add(some_entry()); });
    EXPECT_THAT(said, HasSubstr(words)) << name;
    EXPECT_THAT(said, HasSubstr("with --catalog")) << name;
    EXPECT_EQ(std::ranges::count(said, '\n'), 0) << said;
    EXPECT_FALSE(catalog.best(cell)) << name;
  }
}

// Makes an alias as an older program would have.
void put_alias(const std::string& path, const std::string& alias, const std::string& label) {
  const Database database = Database::open(path, Access::read_write);
  database.prepare("INSERT INTO alias VALUES(?,?)")
      .with(std::string_view(alias), std::string_view(label))
      .step();
}

TEST(CatalogAlias, IsNoBeginningOfALabel) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  const CatalogEntry five = some_entry(5);
  const CatalogEntry four = some_entry(4);
  Catalog catalog({.user = path});
  catalog.add(five);
  catalog.add(four);
  const std::string label = four.label();
  for (std::size_t length = 1; length <= label.size(); ++length) {
    const std::string beginning = label.substr(0, length);
    EXPECT_THAT(fault_of([&] { catalog.alias(beginning, five.label()); }), HasSubstr("is a label"))
        << beginning;
  }
  // In a file of an older program such an alias is there and is not used.
  const std::string beginning = cell_label(cell) + ".4";
  put_alias(path, beginning, five.label());
  Catalog again({.user = path});
  EXPECT_EQ(again.remark(), "");
  EXPECT_EQ(again.find(beginning), four);
  EXPECT_THAT(again.remark(), HasSubstr("the alias " + beginning + " is not used"));
  EXPECT_EQ(again.problem(), "");
  ASSERT_THAT(again.faults(), SizeIs(1));
  EXPECT_EQ(again.faults()[0].label, beginning);
  EXPECT_EQ(again.remove_alias(beginning), five.label());
  EXPECT_THAT(again.faults(), IsEmpty());
  EXPECT_THAT(fault_of([&] { again.remove_alias(beginning); }), HasSubstr("there is no alias"));
}

TEST(CatalogAlias, ThatLeadsNowhere) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  const CatalogEntry five = some_entry(5);
  Catalog({.user = path}).add(five);
  put_alias(path, "lost", cell_label(cell) + ".9.00000000");
  put_alias(path, "half", cell_label(cell) + ".5");  // of which one label is the beginning
  Catalog catalog({.user = path});
  EXPECT_FALSE(catalog.find("lost"));
  EXPECT_FALSE(catalog.find("half"));
  EXPECT_THAT(catalog.faults(), SizeIs(2));
  catalog.alias("lost", five.label());
  EXPECT_EQ(catalog.find("lost"), five);
  catalog.remove_alias("half");
  EXPECT_THAT(catalog.faults(), IsEmpty());
}

TEST(CatalogFaults, NameRowsThatContradictTheirLines) {
  for (const std::string change :
       {"v = 7", "k = 4", "change = 1", "kind = 1", "strength = 3", "b = 4", "lower_bound = 2",
        "carries_blocks = 0", "construction = 'cut'", "date = '2020-01-01'", "credit = 2",
        "line = replace(line, '\"b\":5', '\"b\":6')"}) {
    const TemporaryFolder folder;
    const std::string path = folder.file("mine.db");
    CatalogEntry entry = some_entry();
    entry.lower_bound = 1;
    {
      Catalog catalog({.user = path});
      catalog.add(entry);
      catalog.add(some_entry(4));
      EXPECT_THAT(catalog.faults(), IsEmpty());
    }
    {
      const Database database = Database::open(path, Access::read_write);
      database.run(
          "INSERT INTO credit VALUES(77, '{\"format\":\"changeover-catalog/1\",\"credit\":"
          "{\"date\":\"2020-01-02\"}}')");
      database.run("UPDATE design SET " +
                   (change == "credit = 2" ? std::string("credit = 77") : change) + " WHERE b = 5");
    }
    const Catalog catalog({.user = path});
    const auto faults = catalog.faults();
    ASSERT_THAT(faults, SizeIs(1)) << change;
    EXPECT_EQ(faults[0].label, entry.label());
    EXPECT_THAT(faults[0].what, HasSubstr("damaged")) << change;
  }
}

// SQLite tells what is wrong with pages in several lines.
TEST(CatalogFaults, OfPagesAreALineEach) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  Catalog({.user = path}).add(some_entry());
  {
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(36);  // how many pages are free
    file.write("\x01\x01\0\0", 4);
  }
  const auto faults = Catalog({.user = path}).faults();
  ASSERT_THAT(faults, SizeIs(1));
  EXPECT_THAT(faults[0].what, HasSubstr("damaged (Main freelist: "));
  EXPECT_THAT(faults[0].what, Not(HasSubstr("\n")));
}

// An index that misses a row hides a design from its cell, and nothing else shows it.
TEST(CatalogFaults, NameAnIndexThatMissesARow) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  Catalog({.user = path}).add(some_entry());
  {
    const Database database = Database::open(path, Access::read_write);
    database.run(
        "PRAGMA writable_schema = ON; UPDATE sqlite_schema SET rootpage = (SELECT rootpage FROM "
        "sqlite_schema WHERE name = 'sqlite_autoindex_design_1') WHERE name = 'design_by_cell'");
  }
  const Catalog catalog({.user = path});
  EXPECT_FALSE(catalog.faults().empty() && catalog.problem().empty());
}

TEST(CatalogLists, AreAddedOneAfterAnother) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  std::mt19937 random(3);
  std::vector<CatalogEntry> all;
  for (std::uint64_t b = 20; b > 5; --b) {
    all.push_back(random_entry(cell, b, random));
    all.back().retracted = b % 2 == 0 ? "no" : "";
  }
  Catalog catalog({.user = path});
  std::size_t next = 0;
  std::vector<Added> results;
  catalog.add_lists(
      [&] {
        // Another process writes between two lists.
        if (next > 0) {
          Catalog({.user = path}).add(random_entry(cell, 30 + next, random));
        }
        std::vector<CatalogEntry> list;
        for (int i = 0; i < 4 && next < all.size(); ++i) {
          list.push_back(all[next++]);
        }
        return list;
      },
      [&](std::span<const Added> some) {
        results.insert(results.end(), some.begin(), some.end());
      });
  ASSERT_THAT(results, SizeIs(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(results[i], all[i].retracted.empty() ? Added::improved : Added::added) << i;
    EXPECT_EQ(catalog.find(all[i].label()), all[i]);
  }
  EXPECT_EQ(catalog.cell(cell).size(), all.size() + 4);
  // Another file of that name is not written to unchecked.
  const std::string said = fault_of([&] {
    catalog.add_lists(
        [&] {
          std::filesystem::rename(path, path + std::to_string(next));
          Catalog({.user = path}).add(some_entry(3));
          return std::vector{random_entry(cell, 50 + next++, random)};
        },
        [](std::span<const Added>) {});
  });
  EXPECT_THAT(said, HasSubstr("another file took its name"));
}

// The first of a cell, however many are in it: to know it for each of n that are added must not
// take n² steps.
TEST(CatalogWork, TheFewestOfACellAreFoundWithoutSorting) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  std::mt19937 random(4);
  std::vector<std::uint64_t> work;
  for (const int count : {10, 1000}) {
    Catalog catalog({.user = path});
    std::vector<CatalogEntry> entries;
    for (int i = 0; i < count; ++i) {
      entries.push_back(random_entry(cell, 8, random));
    }
    catalog.add(entries);
    Shelf shelf(Database::open(path, Access::read));
    Statement& rows = shelf.counts(cell);
    ASSERT_TRUE(rows.step());
    work.push_back(rows.work());
  }
  EXPECT_EQ(work[0], work[1]);
}

}  // namespace
}  // namespace changeover::test::names_test
