// The examples of the headers of loadorder/, as they stand there.
#include <atomic>
#include <iostream>

#include "example_support.hpp"

extern "C" std::uint64_t steps_of_c_example(void);
extern "C" std::uint64_t pairs_of_c_example(std::uint64_t* said);

namespace changeover::test::loadorder_examples_test {
namespace {

class LoadOrderExamples : public InAFolder {};

TEST_F(LoadOrderExamples, AllPairs) {
  put("vectors.f32", "");
  std::filesystem::resize_file("vectors.f32", 64 << 20);
  std::atomic<int> calls = 0;
  const auto gram = [&](std::span<const std::byte> a, std::span<const std::byte> b) {
    EXPECT_EQ(a.size(), b.size());
    ++calls;
  };
  FileItems file("vectors.f32", 32 << 20, {.bypass_cache = true});
  PrefetchPlan plan = plan_prefetch(file.item_count(), room_for(file, 512 << 20));
  AllPairsReport report = all_pairs(
      file, plan.order,
      [&](const PairWork& pair) {
        gram(pair.first.bytes, pair.second.bytes);  // first = second: the pairs within one item
      },
      {.threads = 2, .read_ahead = plan.spare, .journal = "job.journal"});
  EXPECT_TRUE(report.finished);
  EXPECT_EQ(calls, 3);
}

class Distances final : public JobResults {
 public:
  std::string describe() const override { return "distances.f64, 300 rows of 300"; }
  void open(const ResultsClaim& claim) override { file_.open(300 * 300 * 8, claim); }
  Checksum checksum(const StepPairs& done) override;  // of what file_ holds for these pairs
  void sync() override { file_.sync(); }

 private:
  ResultFile file_{"distances.f64"};
};

Checksum Distances::checksum(const StepPairs& done) {
  Sha256 hash;
  for (const auto& [x, y] : done.pairs) {
    double distance = 0;
    file_.read(&distance, sizeof distance, (x * std::uint64_t{300} + y) * sizeof distance);
    hash.add(&distance, sizeof distance);
  }
  return hash.finish();
}

TEST_F(LoadOrderExamples, JobResults) {
  Distances distances;
  distances.open({sha256("a job"), {0, 1}});
  distances.sync();
  const std::vector<ItemPair> pairs = {{0, 0}, {0, 299}};
  EXPECT_EQ(distances.checksum({1, pairs}), sha256(std::string(16, '\0')));
}

TEST_F(LoadOrderExamples, Checksum) {
  Sha256 hash;
  hash.add("ab");
  hash.add("c");
  EXPECT_EQ(to_hex(hash.finish()),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST_F(LoadOrderExamples, ItemSource) {
  put("vectors.f32", "");
  std::filesystem::resize_file("vectors.f32", (70 << 20) + 1);
  FileItems file("vectors.f32", 32 << 20, {.bypass_cache = true});  // items of 32 MiB
  EXPECT_EQ(file.item_count(), 3U);
}

TEST_F(LoadOrderExamples, UpdatePairs) {
  put("embeddings.f32", std::string(24 * 4096, 'x'));
  std::atomic<int> trained = 0;
  const auto train = [&](std::span<std::byte> a, std::span<std::byte> b) {
    a[0] = b[0] = std::byte{1};
    ++trained;
  };
  LoadOrder order = plan_disjoint_order(24, 5, 2);
  UpdateOptions options{.data = "embeddings.f32", .item_bytes = 4096, .journal = "job.journal"};
  options.checkpoint_every = 10;
  UpdateReport report = update_pairs(
      order,
      [&](const PairUpdate& pair) {
        train(pair.first.bytes, pair.second.bytes);  // both may be written
      },
      options);
  EXPECT_TRUE(report.finished);
  EXPECT_EQ(trained, 24 * 23 / 2);
}

TEST_F(LoadOrderExamples, LoadOrder) {
  StandardOutput output;
  LoadOrder order = plan_load_order(64, 16);
  EXPECT_GE(order.facts().loads, order.facts().bound.loads);
  EXPECT_EQ(order.facts().bound.loads, 144U);
  Step step;
  while (order.next(step)) {  // one by one; nothing is kept
    std::cout << step.number << ": " << step.load.size() << '\n';
  }
  EXPECT_THAT(output.take(), HasSubstr(std::to_string(order.facts().steps) + ": 1\n"));
}

TEST_F(LoadOrderExamples, Sizes) {
  auto sizes = std::make_shared<const ItemSizes>(ItemSizes{{400, 300, 300, 200, 100}, 900});
  LoadOrder order = plan_sized_order(sizes, {});
  order.facts().bytes;  // facts().byte_bound.loads are needed
  EXPECT_GE(order.facts().bytes, order.facts().byte_bound.loads);
}

TEST_F(LoadOrderExamples, Epochs) {
  LoadOrder order = repeat_order(plan_load_order(64, 16), 10);
  order.facts().epoch_loads;  // 149, and then 133 in each epoch
  EXPECT_EQ(order.facts().epoch_loads.at(9), 133U);
}

TEST_F(LoadOrderExamples, Improve) {
  RunControl control({.time = std::chrono::seconds(1)});
  LoadOrderOptions options;
  options.improve = improve_by_search(control);
  LoadOrder order = plan_load_order(37, 9, options);  // no more loads than without the search
  EXPECT_LE(order.facts().loads, plan_load_order(37, 9).facts().loads);
}

TEST_F(LoadOrderExamples, TwoLevels) {
  LoadOrder order = plan_two_levels(200, 40, 8);
  EXPECT_GE(order.facts().loads, order.facts().bound.loads);               // from the disk
  EXPECT_GE(order.facts().transfers, order.facts().transfer_bound.loads);  // from memory
  EXPECT_TRUE(check_schedule(*order.stream(), order.rules()).valid());
}

TEST_F(LoadOrderExamples, StepWork) {
  std::size_t computed = 0;
  std::size_t loaded = 0;
  const auto move = [&](const std::vector<Element>&, const std::vector<Element>& load) {
    loaded += load.size();
  };
  const auto compute = [&](const std::vector<ItemPair>& pairs) { computed += pairs.size(); };
  std::size_t stored = 0;
  const auto store = [&](const std::vector<Element>& items) { stored += items.size(); };
  const ComputeRules both{.ordered = true, .self = true};
  ScheduleRules rules{.items = 24, .room = 6, .compute = both};
  rules.store = true;  // items change while they are held
  StepWork work(plan_load_order(24, 6).stream(), rules);
  for (Step step; work.next(step);) {
    store(step.store);  // what was changed and goes now
    move(step.evict, step.load);
    compute(step.compute);  // (i,j), (j,i) and (i,i), each once in all
  }
  EXPECT_EQ(computed, 24U * 24U);
  EXPECT_EQ(loaded, plan_load_order(24, 6).facts().loads);
  EXPECT_EQ(stored, loaded);
}

TEST_F(LoadOrderExamples, LoadRequest) {
  LoadRequest request{.items = 64, .room = 16, .workers = 4};
  EXPECT_EQ(to_json(request),
            "{\"format\":\"changeover-load-request/1\",\"items\":64,\"room\":16,\"workers\":4}\n");
  const CheckedLoads asked = checked_loads(request, Door::document);
  const WorkerSplit split = split_load_order(asked.items(), asked.room(), *request.workers);
  EXPECT_EQ(split.facts().workers.size(), 4U);
}

TEST_F(LoadOrderExamples, Schedule) {
  ScheduleRules rules{.items = 24, .room = 6, .compute = ComputeRules{}};
  StepWork work(plan_load_order(24, 6).stream(), rules);
  ScheduleCheck check(rules);
  for (Step step; work.next(step);) {
    check.read(step);
  }
  EXPECT_TRUE(check.finish().valid());  // each pair computed once, both items in memory
}

TEST_F(LoadOrderExamples, WantedPairs) {
  put("edges.txt", "0 1\n1 2\n");
  WantedPairs edges = WantedPairs::listed(read_pairs("edges.txt"));  // pairs that a file lists
  WantedPairs matching = WantedPairs::between(12, 20);  // items 0, …, 11 with items 12, …, 31
  WantedPairs grown = WantedPairs::beyond(1000, 1024);  // pairs of the last 24 with all others
  EXPECT_EQ(edges.count(), 2U);
  EXPECT_EQ(plan_load_order(grown, 64).facts().loads, 1024U);
  EXPECT_TRUE(matching.contains(3, 12));
  EXPECT_EQ(matching.count(), 240U);
}

TEST_F(LoadOrderExamples, Workers) {
  std::uint64_t busiest = 0;
  WorkerSplit split = split_load_order(64, 16, 4);
  EXPECT_GE(split.facts().makespan, split.facts().makespan_bound.loads);
  // Pairs that the worker with most of them computes.
  EXPECT_EQ(split.facts().most_pairs, 504U);
  for (std::uint64_t w = 0; w < 4; ++w) {
    auto steps = split.stream(w);  // its steps, numbered from 1; the first loads a full memory
    Step step;
    std::uint64_t loads = 0;
    for (std::uint64_t number = 1; steps->next(step); ++number) {
      EXPECT_EQ(step.number, number);
      loads += step.load.size();
    }
    busiest = std::max(busiest, loads);
  }
  EXPECT_EQ(busiest, split.facts().makespan);
}

TEST_F(LoadOrderExamples, InC) {
  EXPECT_EQ(steps_of_c_example(), plan_load_order(64, 16).facts().steps);
  std::uint64_t said = 0;
  EXPECT_EQ(pairs_of_c_example(&said), 504U);
  EXPECT_EQ(said, 504U);
}

TEST_F(LoadOrderExamples, Disjoint) {
  LoadOrder order = plan_disjoint_order(64, 8, 4);
  EXPECT_GE(order.facts().span,
            order.facts().makespan());  // what the slowest loads of all steps add up to
  StepWork work(order.stream(), order.rules(ComputeRules{}));
  EXPECT_TRUE(check_schedule(work, order.rules(ComputeRules{})).valid());  // disjoint at every step
}

TEST_F(LoadOrderExamples, Prefetch) {
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
  const auto wait_for = [&](const std::vector<Element>& items) { set(items, true); };
  const auto drop = [&](const std::vector<Element>& items) { set(items, false); };
  const auto start_loads = [&](const std::vector<Element>& items) { set(items, false); };
  PrefetchPlan plan = plan_prefetch(64, 16);
  ScheduleRules rules{.items = 64, .room = 16, .compute = ComputeRules{}, .overlap = true};
  StepWork schedule(plan.order.stream(), rules);
  Step step, next;
  for (bool more = schedule.next(step); more; std::swap(step, next)) {
    wait_for(step.load);    // these loads were started in the step before
    compute(step.compute);  // all pairs with what has to go first
    next = {};
    more = schedule.next(next);
    const auto late = next.evict.end() - static_cast<std::ptrdiff_t>(next.late);
    drop({next.evict.begin(), late});
    start_loads(next.load);
    compute(step.overlap);  // meanwhile
    drop({late, next.evict.end()});
  }
  EXPECT_EQ(computed, 64U * 63 / 2);
}

TEST_F(LoadOrderExamples, LoadsStartEarly) {
  LoadOrder order = start_loads_early(plan_two_levels(200, 40, 8));
  EXPECT_GT(order.facts().ahead, 0U);
  EXPECT_TRUE(check_schedule(*order.stream(), order.rules()).valid());
}

}  // namespace
}  // namespace changeover::test::loadorder_examples_test
