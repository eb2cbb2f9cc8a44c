// The examples of the room's headers, as they stand there, with what they leave open filled in.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <fstream>

#include "changeover/loadorder/all_pairs.hpp"
#include "changeover/loadorder/checksum.hpp"
#include "changeover/loadorder/improve.hpp"
#include "changeover/loadorder/job_results.hpp"
#include "changeover/loadorder/load_check.hpp"
#include "changeover/loadorder/prefetch.hpp"
#include "changeover/loadorder/workers.hpp"
#include "loadorder_support.hpp"
#include "peers/load_orders.hpp"

namespace changeover::test {
namespace {

TEST(HeaderExamples, AllPairs) {
  const std::string path = testing::TempDir() + "header_example.f32";
  const std::string journal = path + ".journal";
  std::remove(journal.c_str());
  std::ofstream(path) << std::string(64 * 4096, 'x');
  std::atomic<int> calls = 0;
  const auto gram = [&](std::span<const std::byte> a, std::span<const std::byte> b) {
    EXPECT_EQ(a.size(), b.size());
    ++calls;
  };

  FileItems file(path, 4096, {.bypass_cache = true});
  PrefetchPlan plan = plan_prefetch(file.item_count(), room_for(file, 16 * 4096));
  AllPairsReport report = all_pairs(
      file, plan.order,
      [&](const PairWork& pair) {
        gram(pair.first.bytes, pair.second.bytes);  // first = second: the pairs within one item
      },
      {.threads = 2, .read_ahead = plan.spare, .journal = journal});

  EXPECT_TRUE(report.finished);
  EXPECT_EQ(calls, 64 * 65 / 2);
  std::remove(path.c_str());
  std::remove(journal.c_str());
}

TEST(HeaderExamples, Checksum) {
  Sha256 hash;
  hash.add("ab");
  hash.add("c");
  EXPECT_EQ(to_hex(hash.finish()),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(HeaderExamples, JobResults) {
  const std::string path = testing::TempDir() + "header_example.f64";
  class Distances final : public JobResults {
   public:
    explicit Distances(const std::string& path) : file_(path) {}
    std::string describe() const override { return "distances.f64, 300 rows of 300"; }
    void open(const ResultsClaim& claim) override { file_.open(300 * 300 * 8, claim); }
    Checksum checksum(const StepPairs& done) override {
      Sha256 hash;
      for (const auto& [x, y] : done.pairs) {
        double distance = 0;
        file_.read(&distance, sizeof distance, (x * std::uint64_t{300} + y) * sizeof distance);
        hash.add(&distance, sizeof distance);
      }
      return hash.finish();
    }
    void sync() override { file_.sync(); }

   private:
    ResultFile file_;
  };
  {
    Distances distances(path);
    distances.open({sha256("a job"), {0, 1}});
    distances.sync();
    const std::vector<ItemPair> pairs = {{0, 0}, {0, 299}};
    EXPECT_EQ(distances.checksum({1, pairs}), sha256(std::string(16, '\0')));
  }
  std::remove(path.c_str());
}

TEST(HeaderExamples, LoadCheck) {
  const std::uint64_t items = 64;
  const std::uint64_t room = 16;
  LoadOrder order = plan_load_order(items, room);
  LoadCheck check(items, room);
  LoadStep step;
  while (order.next(step)) {
    check.read(step);
  }
  LoadVerdict verdict = check.finish();
  EXPECT_TRUE(verdict.valid());
}

TEST(HeaderExamples, Workers) {
  WorkerSplit split = split_load_order(64, 16, 4);
  EXPECT_GE(split.facts().makespan, split.facts().makespan_bound.loads);
  for (std::uint64_t w = 0; w < 4; ++w) {
    auto steps = split.stream(w);
    LoadStep step;
    ASSERT_TRUE(steps->next(step));
    EXPECT_EQ(step.number, 1U);
    EXPECT_TRUE(step.evict.empty());
  }
}

TEST(HeaderExamples, Prefetch) {
  PrefetchPlan plan = plan_prefetch(64, 16);
  PrefetchSchedule schedule(plan.order.stream(), 64, 16);
  std::vector<bool> there(64, false);
  std::uint64_t computed = 0;
  const auto compute = [&](const std::vector<ItemPair>& pairs) {
    for (const auto& [x, y] : pairs) {
      EXPECT_TRUE(there[x] && there[y]);
      ++computed;
    }
  };
  const auto set = [&](const std::vector<Element>& items, bool value) {
    for (const Element x : items) {
      there[x] = value;
    }
  };
  PrefetchStep step;
  PrefetchStep next;
  for (bool more = schedule.next(step); more;) {
    more = schedule.next(next);
    set(step.load, true);
    compute(step.before);
    if (more) {
      set(next.evict_first, false);
    }
    compute(step.overlap);
    if (more) {
      set(next.evict_late, false);
      std::swap(step, next);
    }
  }
  EXPECT_EQ(computed, 64U * 63 / 2);
}

TEST(HeaderExamples, ImproveAndBaselines) {
  RunControl control({.time = std::chrono::seconds(1)});
  LoadOrderOptions options;
  options.improve = improve_by_search(control);
  LoadOrder order = plan_load_order(37, 9, options);
  EXPECT_LE(order.facts().loads, plan_load_order(37, 9).facts().loads);
  LoadOrder beta = beta_order(20, 5);
  EXPECT_EQ(beta.facts().loads - 5 + 1, 52U);
}

}  // namespace
}  // namespace changeover::test
