// Tables are made once for all who ask at the same time, and again when the catalog changes.
#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <thread>
#include <utility>
#include <vector>

#include "answer/known/known_table.hpp"
#include "changeover/run/control.hpp"
#include "cli/cli.hpp"
#include "serve/api/explorer.hpp"

namespace changeover::test::known_tables_test {
namespace {

const cli::TableRange range{.k = {3, 4}, .v = {5, 12}, .change = 2};

TEST(KnownTables, OneForAllWhoAsk) {
  serve::KnownTables tables;
  std::vector<std::shared_ptr<const cli::KnownTable>> got(8);
  std::vector<std::thread> threads;
  for (auto& table : got) {
    threads.emplace_back([&] { table = tables.of(range, "1"); });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (const auto& table : got) {
    EXPECT_EQ(table, got.front());
  }
  EXPECT_EQ(got.front()->cells(Kind::linear).size(), 16U);
  EXPECT_NE(tables.of(range, "2"), got.front());
  EXPECT_EQ(tables.of(range, "1"), got.front());
}

// A table that is made for sometime may rest for long; a request does not wait for it.
TEST(KnownTables, WhoNeedsItDoesNotWaitForSometime) {
  serve::KnownTables tables;
  const cli::TableRange large{.k = {3, 6}, .v = {5, 60}, .change = 2};
  std::promise<void> begun;
  std::promise<void> released;
  std::atomic<bool> resting = false;
  std::thread preparing([&] {
    RunControl::Settings settings;
    settings.found_elsewhere = [&] {
      if (!resting.exchange(true)) {
        begun.set_value();
        released.get_future().wait();
      }
      return false;
    };
    RunControl control(std::move(settings));
    const RunScope scope(control);
    EXPECT_TRUE(tables.of(large, "1", serve::Haste::sometime));
  });
  begun.get_future().wait();
  const auto table = tables.of(large, "1");
  EXPECT_TRUE(table);
  released.set_value();
  preparing.join();
  EXPECT_EQ(tables.of(large, "1"), table);
}

TEST(KnownTables, TheOldestGoes) {
  serve::KnownTables tables;
  const auto first = tables.of(range, "0");
  for (int i = 1; i <= 12; ++i) {
    static_cast<void>(tables.of(range, std::to_string(i)));
  }
  EXPECT_EQ(tables.of(range, "12"), tables.of(range, "12"));
  EXPECT_NE(tables.of(range, "0"), first);
}

TEST(KnownTables, OneThatStopsLeavesNothingBehind) {
  serve::KnownTables tables;
  const cli::TableRange large{.k = {3, 12}, .v = {5, 300}, .change = 2};
  RunControl control({});
  control.stop(WhyStopped::interrupted);
  {
    const RunScope scope(control);
    EXPECT_THROW(static_cast<void>(tables.of(large, "1")), Stopped);
    EXPECT_THROW(static_cast<void>(tables.of(large, "1")), Stopped);
  }
  EXPECT_THROW(static_cast<void>(tables.of({.k = {3, 4}, .v = {5, 5000}, .change = 2}, "1")),
               cli::UsageError);
  EXPECT_TRUE(tables.of(range, "1"));
}

}  // namespace
}  // namespace changeover::test::known_tables_test
