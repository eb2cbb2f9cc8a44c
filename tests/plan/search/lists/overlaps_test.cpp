// For how long scarce parts are on two benches at a time, against counting moment by moment and
// against the clock.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "plan/search/benches/bench_field.hpp"
#include "plan/search/lists/lists.hpp"
#include "run/random.hpp"

namespace changeover::overlaps_test {
namespace {

constexpr std::size_t parts = 7;
constexpr std::size_t room = 3;
constexpr Element scarce = 4;  // so many, the first

Job some_job(Random& random) {
  Job job = make_job(parts, room, Amount{1'000'000}, Amount{});
  for (Amount& cost : job.change_costs) {
    cost = Amount{(1 + random.below(4)) * 1'000'000ULL};
  }
  for (Element x = 0; x < parts; ++x) {
    job.quantities.push_back(x < scarce ? 1 : enough_for_all);
  }
  return job;
}

BenchLists some_lists(std::size_t benches, Random& random) {
  BenchLists lists(benches);
  for (std::vector<Block>& list : lists) {
    for (std::uint32_t i = 1 + random.below(5); i > 0; --i) {
      Block all{0, 1, 2, 3, 4, 5, 6};
      for (std::size_t j = 0; j < room; ++j) {
        std::swap(all[j], all[j + random.below(static_cast<std::uint32_t>(parts - j))]);
      }
      all.resize(1 + random.below(room));
      list.push_back(all);
    }
  }
  return lists;
}

// Each unit of time by itself; no bench waits.
std::int64_t counted(const BenchLists& lists, const ListsJob& job) {
  std::vector<std::vector<Block>> held(lists.size());  // by bench and unit of time
  for (std::size_t b = 0; b < lists.size(); ++b) {
    Block before;
    for (const Block& setup : lists[b]) {
      std::uint64_t cost = job.weights[b].test;
      for (const Element x : setup) {
        cost += std::ranges::count(before, x) == 0 ? job.weights[b].change[x] : 0;
      }
      held[b].insert(held[b].end(), cost, setup);
      before = setup;
    }
  }
  std::int64_t all = 0;
  for (std::size_t a = 0; a < lists.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      for (std::size_t t = 0; t < std::min(held[a].size(), held[b].size()); ++t) {
        all += std::ranges::count_if(held[a][t], [&](Element x) {
          return x < scarce && std::ranges::count(held[b][t], x) > 0;
        });
      }
    }
  }
  return all;
}

TEST(Overlaps, AreCountedAndUndone) {
  std::size_t none = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed, 6);
    const Job job = some_job(random);
    const std::vector<Bench> benches(2 + random.below(2));
    const BenchField field(job, benches);
    ASSERT_TRUE(field.has_single_parts());
    ListsJob asked = field.lists_job(field.most_tests());
    for (Weights& weights : asked.weights) {  // the times are small numbers
      weights.test = 1;
      for (Element x = 0; x < parts; ++x) {
        weights.change[x] = job.change_costs[x].millionths / 1'000'000;
      }
    }
    const ListsJob with_clock = asked;
    asked.overlaps = true;
    Lists lists(asked, some_lists(benches.size(), random));
    for (int move = 0; move < 40; ++move) {
      EXPECT_EQ(lists.overlap(), counted(lists.lists(), asked)) << seed;
      const std::int64_t before = lists.overlap();
      const BenchLists all = lists.lists();
      const Spot where = lists.spot(random.below(static_cast<std::uint32_t>(lists.tests())));
      const Element in = random.below(parts);
      const Element out = lists.setup(where)[0];
      const Spot to{random.below(static_cast<std::uint32_t>(benches.size())), 0};
      switch (random.below(4)) {
        case 0:
          if (!lists.holds(where, in)) {
            const std::int64_t rise = lists.rise_of_replace(where, out, in).overlap;
            lists.replace(where, out, in);
            EXPECT_EQ(lists.overlap(), before + rise) << seed;
          }
          break;
        case 1:
          if (lists.tests() > 2) {
            lists.take_out(where);
          }
          break;
        case 2:
          lists.move(where, 1, to);
          break;
        default:
          lists.insert(to, Block{in});
      }
      if (random.one_in_two()) {
        lists.undo();
        EXPECT_EQ(lists.overlap(), before) << seed;
        EXPECT_EQ(lists.lists(), all) << seed;
      }
      lists.keep();
      lists.retime();
    }
    const Lists clocked(with_clock, lists.lists());
    std::int64_t longest = 0;
    for (std::size_t b = 0; b < benches.size(); ++b) {
      longest = std::max(longest, lists.end(b));
    }
    if (lists.overlap() == 0) {
      EXPECT_EQ(clocked.largest(), longest) << "no bench waits, seed " << seed;
      ++none;
    }
  }
  EXPECT_GT(none, 0U);
}

}  // namespace
}  // namespace changeover::overlaps_test
