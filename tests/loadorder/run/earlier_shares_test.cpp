// A job that was begun in some number of shares and goes on in another.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/all_pairs.hpp"
#include "changeover/loadorder/workers.hpp"
#include "message_of.hpp"
#include "run_program.hpp"

namespace changeover::test::earlier_shares_test {
namespace {

constexpr Element items = 24;

CallbackItems numbers() {
  return {items, sizeof(Element),
          [](Element item, std::span<std::byte> buffer) {
            std::memcpy(buffer.data(), &item, sizeof item);
            return sizeof item;
          },
          "numbers", "the same"};
}

/// How often each pair was computed, and results that a journal can vouch for.
class Table final : public JobResults {
 public:
  [[nodiscard]] std::string describe() const override { return "a table"; }
  void open(const ResultsClaim& claim) override { jobs.insert(claim.job); }
  Checksum checksum(const StepPairs& done) override {
    const std::scoped_lock lock(mutex);
    Sha256 all;
    for (const ItemPair& pair : done.pairs) {
      const auto found = times.find(pair);
      all.add(fmt::format("{} {} {};", pair.first, pair.second,
                          found != times.end() && !lost.contains(pair)));
    }
    return all.finish();
  }
  void sync() override {}

  void compute(const PairWork& work) {
    const std::scoped_lock lock(mutex);
    ++times[{work.first.item, work.second.item}];
    lost.erase({work.first.item, work.second.item});
  }

  std::mutex mutex;
  std::map<ItemPair, int> times;
  std::set<ItemPair> lost;
  std::set<Checksum> jobs;
};

struct Job {
  TemporaryFolder folder;
  Table table;
  LoadOrder order = plan_load_order(items, 6);

  [[nodiscard]] std::string journal(std::uint64_t index, std::uint64_t of) const {
    return folder.file(fmt::format("journal.{}-of-{}", index, of));
  }
  [[nodiscard]] std::vector<std::string> journals(std::uint64_t of) const {
    std::vector<std::string> all;
    for (std::uint64_t i = 0; i < of; ++i) {
      if (std::filesystem::exists(journal(i, of))) {
        all.push_back(journal(i, of));
      }
    }
    return all;
  }

  // One share, at most so many steps of it.
  AllPairsReport run(std::uint64_t index, std::uint64_t of, std::vector<std::string> earlier = {},
                     std::uint64_t most_steps = 1000) {
    std::atomic<bool> cancelled{false};
    std::uint64_t steps = 0;
    AllPairsOptions options;
    options.share = {index, of};
    options.journal = journal(index, of);
    options.earlier = std::move(earlier);
    options.results = &table;
    options.cancelled = &cancelled;
    options.on_progress = [&](const AllPairsProgress&) { cancelled = ++steps >= most_steps; };
    CallbackItems source = numbers();
    return all_pairs(
        source, order, [this](const PairWork& work) { table.compute(work); }, options);
  }
};

TEST(EarlierShares, GoOnInAnotherNumberAndComputeNothingTwice) {
  for (const auto& [first, then] :
       {std::pair(4U, 2U), std::pair(2U, 5U), std::pair(1U, 3U), std::pair(3U, 1U)}) {
    Job job;
    for (std::uint64_t i = 0; i < first; ++i) {
      job.run(i, first, {}, 3 + i);
    }
    const std::size_t before = job.table.times.size();
    ASSERT_GT(before, 0U);
    ASSERT_LT(before, std::size_t{items} * (items + 1) / 2);
    std::uint64_t loads = 0;
    for (std::uint64_t i = 0; i < then; ++i) {
      const AllPairsReport report = job.run(i, then, job.journals(first));
      EXPECT_TRUE(report.finished);
      EXPECT_EQ(report.earlier_lost, 0U);
      loads += report.loads;
    }
    EXPECT_EQ(job.table.times.size(), std::size_t{items} * (items + 1) / 2);
    for (const auto& [pair, times] : job.table.times) {
      EXPECT_EQ(times, 1) << pair.first << " " << pair.second << ": " << first << ", " << then;
    }
    // Results of all shares of one number are one job's.
    EXPECT_EQ(job.table.jobs.size(), 2U);
  }
}

TEST(EarlierShares, MayFollowOneAnother) {
  Job job;
  job.run(0, 3, {}, 2);
  job.run(1, 3, {}, 2);
  job.run(2, 3, {}, 2);
  std::vector<std::string> all = job.journals(3);
  for (std::uint64_t i = 0; i < 2; ++i) {
    job.run(i, 2, all, 3);
  }
  // The same number once more goes on with its own journals.
  job.run(0, 2, all, 4);
  for (const std::string& path : job.journals(2)) {
    all.push_back(path);
  }
  std::swap(all.front(), all.back());  // in any order
  for (std::uint64_t i = 0; i < 5; ++i) {
    EXPECT_TRUE(job.run(i, 5, all).finished);
  }
  EXPECT_EQ(job.table.times.size(), std::size_t{items} * (items + 1) / 2);
  for (const auto& [pair, times] : job.table.times) {
    EXPECT_EQ(times, 1) << pair.first << " " << pair.second;
  }
}

TEST(EarlierShares, WhatWasRecordedAndIsLostIsComputedAgain) {
  Job job;
  for (std::uint64_t i = 0; i < 3; ++i) {
    job.run(i, 3, {}, 3);
  }
  const ItemPair lost = job.table.times.begin()->first;
  job.table.lost.insert(lost);
  std::uint64_t lost_steps = 0;
  std::uint64_t resumed = 0;
  for (std::uint64_t i = 0; i < 2; ++i) {
    const AllPairsReport report = job.run(i, 2, job.journals(3));
    lost_steps += report.earlier_lost;
    resumed += report.earlier_resumed;
  }
  EXPECT_EQ(lost_steps, 1U);
  EXPECT_EQ(resumed, 8U);
  EXPECT_TRUE(job.table.lost.empty());
  EXPECT_EQ(job.table.times.size(), std::size_t{items} * (items + 1) / 2);
  EXPECT_EQ(job.table.times[lost], 2);
}

TEST(EarlierShares, OfAnotherJobOrIncompleteAreRefused) {
  Job job;
  for (std::uint64_t i = 0; i < 3; ++i) {
    job.run(i, 3, {}, 2);
  }
  job.run(0, 2, job.journals(3), 2);
  // A run that continues one whose journals are not there.
  EXPECT_REFUSAL(job.run(0, 5, job.journals(2)), BadInput,
                 ": continues a run whose journals are missing or have changed; name all of them");
  // Its own journal continues another selection.
  EXPECT_THROW(job.run(0, 2, {job.journal(0, 3)}), BadInput);
  EXPECT_THROW(job.run(0, 5, {job.folder.file("missing")}), MissingResource);
  spit(job.folder.file("text"), "something else\n");
  EXPECT_THROW(job.run(0, 5, {job.folder.file("text")}), BadInput);
  Job other;
  other.order = plan_load_order(items, 7);
  EXPECT_THROW(other.run(0, 2, job.journals(3)), BadInput);
  const std::string before = slurp(job.journal(0, 3));
  job.run(0, 2, job.journals(3), 2);
  EXPECT_EQ(slurp(job.journal(0, 3)), before);
}

TEST(AllPairsOfShares, ComputeEachPairOnceAndEvenly) {
  for (const std::uint64_t workers : {3U, 7U, 13U}) {
    const WorkerSplit shares = split_load_order(items, 14, workers);
    Table table;
    for (std::uint64_t i = 0; i < workers; ++i) {
      AllPairsOptions options;
      options.share = {i, workers};
      CallbackItems source = numbers();
      const AllPairsReport report = all_pairs(
          source, shares, [&](const PairWork& work) { table.compute(work); }, options);
      EXPECT_TRUE(report.finished);
      EXPECT_EQ(report.loads, shares.facts().workers[i].loads);
      EXPECT_EQ(report.steps_done, shares.facts().workers[i].steps);
    }
    EXPECT_EQ(table.times.size(), std::size_t{items} * (items + 1) / 2);
    for (const auto& [pair, times] : table.times) {
      EXPECT_EQ(times, 1) << pair.first << " " << pair.second;
    }
    AllPairsOptions options;
    options.share = {0, workers + 1};
    CallbackItems source = numbers();
    EXPECT_REFUSAL(all_pairs(
                       source, shares, [](const PairWork&) {}, options),
                   BadInput, ": these are shares of");
  }
}

// What is wrong is found beside the work, and fails the job in the end.
TEST(AllPairsVerifiedBeside, FailIfTheOrderIsWrong) {
  LoadOrderOptions unread;
  unread.read_first = false;
  const LoadOrder right = plan_load_order(items, 6, unread);
  EXPECT_FALSE(right.facts().every_step_read);
  AllPairsOptions options;
  options.verify_beside = true;
  Table table;
  CallbackItems source = numbers();
  EXPECT_TRUE(all_pairs(
                  source, right, [&](const PairWork& work) { table.compute(work); }, options)
                  .finished);
  EXPECT_EQ(table.times.size(), std::size_t{items} * (items + 1) / 2);

  class Short final : public StepSource {
   public:
    explicit Short(std::unique_ptr<StepSource> steps) : steps_(std::move(steps)) {}
    bool next(Step& step) override { return ++count_ < 5 && steps_->next(step); }

   private:
    std::unique_ptr<StepSource> steps_;
    int count_ = 0;
  };
  const LoadOrder wrong(right.facts(), [&] { return std::make_unique<Short>(right.stream()); });
  EXPECT_REFUSAL(all_pairs(
                     source, wrong, [](const PairWork&) {}, options),
                 BadInput, "this is not a load order of 24 items with room for 6: {0,1}");
}

}  // namespace
}  // namespace changeover::test::earlier_shares_test
