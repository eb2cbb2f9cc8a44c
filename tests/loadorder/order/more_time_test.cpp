// A search never gives a worse order than none, and more time never a worse one than less. The
// clock is the number of questions that a search asks: no run depends on another clock.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "../pairs/pairs_support.hpp"
#include "../sizes/sizes_support.hpp"
#include "changeover/loadorder/workers.hpp"

namespace changeover::test::more_time_test {
namespace {

constexpr std::uint64_t no_search = ~std::uint64_t{0};

LoadOrderOptions searched(std::uint64_t questions) {
  LoadOrderOptions options;
  options.effort = 1e-4;
  if (questions == no_search) {
    return options;
  }
  options.search_pairs = [questions](const std::function<void()>& search) {
    RunControl whole({});
    RunControl control(whole, Questions{questions});
    const RunScope scope(control);
    search();
  };
  options.improve = [questions](const Design& start, std::uint64_t least) {
    RunControl whole({});
    RunControl control(whole, Questions{questions});
    return improve_by_search(control)(start, least);
  };
  return options;
}

struct Job {
  WantedPairs wanted;
  std::uint64_t room = 0;
  std::uint64_t fast_room = 0;
  std::uint64_t workers = 0;
  std::shared_ptr<const ItemSizes> sizes = {};  // of both levels
  std::shared_ptr<const ItemSizes> memory = {};
  std::string what = {};
};

Job random_job(std::mt19937& random) {
  Job job;
  const std::uint64_t items = 9 + random() % 20;
  switch (random() % 4) {
    case 0:
      job.wanted = WantedPairs(items);
      break;
    case 1:
      job.wanted = WantedPairs::between(items / 2, items - items / 2);
      break;
    case 2:
      job.wanted = WantedPairs::beyond(items / 2, items);
      break;
    default:
      job.wanted = listed(items, random_pairs(items, items + random() % (2 * items), random()));
      break;
  }
  job.workers = 2 + random() % 2;
  job.room = 3 + random() % (items / job.workers - 2);
  job.fast_room = 2 + random() % (job.room - 1);
  const auto fast = random_sizes(random, items, 9, 24);
  job.sizes = std::make_shared<const ItemSizes>(
      ItemSizes{fast->bytes, fast->memory + 1 + random() % 30, fast->memory});
  job.memory = std::make_shared<const ItemSizes>(ItemSizes{fast->bytes, job.sizes->memory});
  job.what =
      fmt::format("{}, room for {} and {}, {} workers, {} and {} bytes", job.wanted.describe(),
                  job.room, job.fast_room, job.workers, job.sizes->memory, job.sizes->fast_memory);
  return job;
}

double over(std::uint64_t count, const LoadBound& bound) {
  return static_cast<double>(count) / static_cast<double>(bound.loads);
}

double in_this_order(std::uint64_t first, std::uint64_t then) {
  return static_cast<double>(first) * 1e6 + static_cast<double>(then);
}

std::uint64_t moved(const std::vector<Element>& items, const ItemSizes* sizes) {
  std::uint64_t sum = 0;
  for (const Element x : items) {
    sum += sizes != nullptr ? sizes->bytes[x] : 1;
  }
  return sum;
}

double of_levels(const LoadOrderFacts& facts) {
  return facts.sizes ? over(facts.bytes, facts.byte_bound) +
                           over(facts.transfer_bytes, facts.transfer_byte_bound)
                     : over(facts.loads, facts.bound) + over(facts.transfers, facts.transfer_bound);
}

double of_busiest(const WorkerSplit& split) {
  const LoadOrderFacts& facts = split.order().facts();
  std::vector<double> costs(split.facts().workers.size(), 0);
  const auto steps = split.stream();
  for (Step step; steps->next(step);) {
    costs[step.worker] +=
        over(moved(step.load, facts.sizes.get()), facts.sizes ? facts.byte_bound : facts.bound) +
        over(moved(step.fast_load, facts.sizes.get()),
             facts.sizes ? facts.transfer_byte_bound : facts.transfer_bound);
  }
  return *std::ranges::max_element(costs);
}

// The spans of both levels, each over the bound of the busiest worker.
double of_spans(const LoadOrder& order, const LoadBound& loads, const LoadBound& transfers) {
  const ItemSizes* const sizes = order.facts().sizes.get();
  std::uint64_t most_loads = 0, most_transfers = 0, all_loads = 0, all_transfers = 0;
  const auto steps = order.stream();
  for (Step step; steps->next(step);) {
    most_loads = std::max(most_loads, moved(step.load, sizes));
    most_transfers = std::max(most_transfers, moved(step.fast_load, sizes));
    if (step.worker + 1 == order.facts().lockstep) {
      all_loads += std::exchange(most_loads, 0);
      all_transfers += std::exchange(most_transfers, 0);
    }
  }
  return over(all_loads, loads) + over(all_transfers, transfers);
}

using Cost = std::function<double(const Job&, const LoadOrderOptions&)>;

void never_worse(unsigned seed, int jobs, std::vector<std::uint64_t> times, const Cost& cost) {
  std::mt19937 random(seed);
  for (int i = 0; i < jobs; ++i) {
    const Job job = random_job(random);
    times.insert(times.begin(), no_search);
    double last = std::numeric_limits<double>::max();
    for (const std::uint64_t questions : times) {
      const double now = cost(job, searched(questions));
      EXPECT_LE(now, last) << job.what << ", " << static_cast<std::int64_t>(questions);
      last = now;
    }
    times.erase(times.begin());
  }
}

const std::vector<std::uint64_t> short_times{0, 1, 5, 30, 200, 1500};
const std::vector<std::uint64_t> times_of_rounds{0, 10, 6000, 40'000};

TEST(MoreTime, OneLevel) {
  never_worse(1, 12, short_times, [](const Job& job, const LoadOrderOptions& options) {
    return static_cast<double>(plan_load_order(job.wanted, job.room, options).facts().loads);
  });
}

TEST(MoreTime, OneLevelOfALongList) {
  const WantedPairs list = listed(400, close_points(400, 1500, 5));
  double last = std::numeric_limits<double>::max();
  for (const std::uint64_t questions : {no_search, 0UL, 100UL, 3000UL, 20'000UL, 100'000UL}) {
    LoadOrderOptions options = searched(questions);
    options.effort = 1e-2;
    const auto loads = static_cast<double>(plan_load_order(list, 12, options).facts().loads);
    EXPECT_LE(loads, last) << questions;
    last = loads;
  }
}

TEST(MoreTime, OneLevelOfBytes) {
  never_worse(2, 12, short_times, [](const Job& job, const LoadOrderOptions& options) {
    return static_cast<double>(plan_sized_order(job.memory, job.wanted, options).facts().bytes);
  });
}

TEST(MoreTime, TwoLevels) {
  never_worse(3, 12, short_times, [](const Job& job, const LoadOrderOptions& options) {
    return of_levels(plan_two_levels(job.wanted, job.room, job.fast_room, options).facts());
  });
}

// A limit above that of the search cuts the fixed work short, wherever that is.
TEST(MoreTime, ALimitOfTheWholeLeavesAnOrderOfAList) {
  const WantedPairs list = listed(40, close_points(40, 130, 3));
  for (const std::uint64_t most : {0U, 1U, 3U, 10U, 40U, 200U, 1000U}) {
    LoadOrderOptions options = searched(no_search);
    options.search_pairs = [most](const std::function<void()>& search) {
      RunControl all({});
      RunControl limit(all, Questions{most});
      RunControl control(limit, Questions{0});
      const RunScope scope(control);
      search();
    };
    EXPECT_TRUE(plan_load_order(list, 10, options).facts().every_step_read) << most;
    EXPECT_TRUE(plan_two_levels(list, 10, 4, options).facts().every_step_read) << most;
  }
}

// A time for all of it leaves an order of every kind, which is said to be cut short. Without a time
// that is too short nothing is said.
TEST(MoreTime, ATimeInAllLeavesAnOrderOfEachKind) {
  const WantedPairs list = listed(40, close_points(40, 130, 3));
  std::mt19937 random(1);
  const auto bytes = random_sizes(random, 40, 40, 90);
  const auto both =
      std::make_shared<const ItemSizes>(ItemSizes{bytes->bytes, bytes->memory + 60, bytes->memory});
  const auto memory = std::make_shared<const ItemSizes>(ItemSizes{bytes->bytes, both->memory});
  using Plan = std::function<std::uint64_t(const LoadOrderOptions&)>;  // the loads
  const std::vector<std::pair<const char*, Plan>> plans{
      {"one level",
       [&](const auto& options) { return plan_load_order(list, 10, options).facts().loads; }},
      {"two levels",
       [&](const auto& options) { return plan_two_levels(list, 10, 4, options).facts().loads; }},
      {"bytes",
       [&](const auto& options) { return plan_sized_order(memory, list, options).facts().loads; }},
      {"bytes at two levels",
       [&](const auto& options) { return plan_two_levels(both, list, options).facts().loads; }},
      {"workers",
       [&](const auto& options) { return split_load_order(list, 10, 3, options).facts().loads; }},
      {"workers of bytes",
       [&](const auto& options) {
         return split_sized_order(memory, list, 3, options).facts().loads;
       }},
      {"workers of two levels",
       [&](const auto& options) {
         return split_two_levels(list, 10, 4, 3, options).facts().loads;
       }},
      {"prefetch",
       [&](const auto& options) { return plan_prefetch(list, 10, options).order.facts().loads; }},
  };
  for (const auto& [what, plan] : plans) {
    LoadOrderOptions options = searched(0);
    bool is_cut_short = false;
    options.on_cut_short = [&] { is_cut_short = true; };
    options.time_in_all = std::chrono::hours(1);
    const std::uint64_t all = plan(options);
    EXPECT_FALSE(is_cut_short) << what;
    options.time_in_all = std::chrono::seconds(0);
    EXPECT_LE(plan(options), 2 * all) << what;
    EXPECT_TRUE(is_cut_short) << what;
  }
}

TEST(MoreTime, TwoLevelsOfBytes) {
  never_worse(4, 8, times_of_rounds, [](const Job& job, const LoadOrderOptions& options) {
    return of_levels(plan_two_levels(job.sizes, job.wanted, options).facts());
  });
}

TEST(MoreTime, Workers) {
  never_worse(5, 8, times_of_rounds, [](const Job& job, const LoadOrderOptions& options) {
    const SplitFacts facts = split_load_order(job.wanted, job.room, job.workers, options).facts();
    return in_this_order(facts.makespan, facts.loads);
  });
}

TEST(MoreTime, WorkersOfBytes) {
  never_worse(6, 8, short_times, [](const Job& job, const LoadOrderOptions& options) {
    return static_cast<double>(
        split_sized_order(job.memory, job.wanted, job.workers, options).facts().makespan_bytes);
  });
}

TEST(MoreTime, WorkersOfTwoLevels) {
  never_worse(7, 6, times_of_rounds, [](const Job& job, const LoadOrderOptions& options) {
    return of_busiest(split_two_levels(job.wanted, job.room, job.fast_room, job.workers, options));
  });
  never_worse(8, 4, times_of_rounds, [](const Job& job, const LoadOrderOptions& options) {
    return of_busiest(split_two_levels(job.sizes, job.wanted, job.workers, options));
  });
}

TEST(MoreTime, DisjointWorkers) {
  never_worse(9, 10, {0, 1, 20, 400}, [](const Job& job, const LoadOrderOptions& options) {
    const LoadOrder order = plan_disjoint_order(job.wanted, job.room, job.workers, options);
    return in_this_order(order.facts().span, order.facts().loads);
  });
  never_worse(10, 6, times_of_rounds, [](const Job& job, const LoadOrderOptions& options) {
    const LoadOrder order = plan_disjoint_order(job.memory, job.wanted, job.workers, options);
    return in_this_order(order.facts().span_bytes, order.facts().bytes);
  });
}

TEST(MoreTime, DisjointWorkersOfTwoLevels) {
  never_worse(11, 6, times_of_rounds, [](const Job& job, const LoadOrderOptions& options) {
    return of_spans(plan_disjoint_levels(job.wanted, job.room, job.fast_room, job.workers, options),
                    makespan_lower_bound(job.wanted, job.room, job.workers),
                    makespan_lower_bound(job.wanted, job.fast_room, job.workers));
  });
  never_worse(12, 4, times_of_rounds, [](const Job& job, const LoadOrderOptions& options) {
    const LoadOrder order = plan_disjoint_levels(job.sizes, job.wanted, job.workers, options);
    const ItemSizes fast{job.sizes->bytes, job.sizes->fast_memory};
    return of_spans(order, order.facts().makespan_byte_bound,
                    sized_makespan_bound(fast, job.wanted, job.workers));
  });
}

}  // namespace
}  // namespace changeover::test::more_time_test
