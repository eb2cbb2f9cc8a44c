// What moves between lists would change, against making them.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "plan/search/lists/lists.hpp"
#include "random_jobs.hpp"
#include "random_models.hpp"

namespace changeover::rises_test {
namespace {

// Lists of set-ups with some of the parts; what slots need or forbid does not matter here.
BenchLists some_lists(const Job& job, std::size_t benches, Random& random) {
  BenchLists lists(benches);
  for (std::vector<Block>& list : lists) {
    for (std::uint32_t i = 1 + random.below(6); i > 0; --i) {
      Block setup;
      while (setup.empty()) {
        for (Element x = 0; x < job.parts(); ++x) {
          if (setup.size() < job.room() && random.one_in_two()) {
            setup.push_back(x);
          }
        }
      }
      list.push_back(setup);
    }
  }
  return lists;
}

class Rises : public ::testing::Test {
 protected:
  // Makes a move, compares and undoes it.
  template <typename Move>
  void expect(Lists& lists, const Lists::Rise& rise, Move&& move) {
    std::vector<std::int64_t> ends;
    for (std::size_t b = 0; b < lists.benches(); ++b) {
      ends.push_back(lists.end(b) + (b == rise.bench ? rise.work : 0) +
                     (b == rise.other ? rise.other_work : 0));
    }
    const std::int64_t work = lists.work() + rise.work + rise.other_work;
    const std::int64_t missing = static_cast<std::int64_t>(lists.missing()) + rise.missing;
    move();
    EXPECT_EQ(lists.work(), work);
    EXPECT_EQ(static_cast<std::int64_t>(lists.missing()), missing);
    for (std::size_t b = 0; b < lists.benches(); ++b) {
      EXPECT_EQ(lists.end(b), ends[b]);
    }
    lists.undo();
    ++moves_;
  }

  // Taking out, turning and moving, from this place on.
  template <typename Below>
  void expect_of_whole_setups(Lists& lists, Spot where, Below&& below) {
    expect(lists, lists.rise_of_take_out(where), [&] { lists.take_out(where); });
    Stretch stretch{where.at, below(lists.tests(where.bench))};
    if (stretch.first > stretch.last) {
      std::swap(stretch.first, stretch.last);
    }
    expect(lists, lists.rise_of_reverse(where.bench, stretch),
           [&] { lists.reverse(where.bench, stretch); });
    const std::size_t count = 1 + below(lists.tests(where.bench) - where.at);
    Spot to{below(lists.benches()), 0};
    to.at = below(lists.tests(to.bench) - (to.bench == where.bench ? count : 0) + 1);
    if (to.bench == where.bench && to.at == where.at) {
      return;
    }
    for (const bool reversed : {false, true}) {
      expect(lists, lists.rise_of_move(where, count, to, reversed), [&] {
        lists.move(where, count, to);
        if (reversed) {
          lists.reverse(to.bench, {to.at, to.at + count - 1});
        }
      });
    }
  }

  unsigned moves_ = 0;
};

TEST_F(Rises, AreWhatMovesChange) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed, 5);
    Job job = test::random_job(seed, 8);
    if (job.needed.size() == 0) {
      continue;
    }
    if (seed % 3 == 0) {
      job.needed.for_each(1000, [&](Element x, Element y) {
        job.weights.set(x, y, Amount{(1 + random.below(5)) * 500'000ULL});
      });
    }
    Job costlier = job;
    for (Amount& cost : costlier.change_costs) {
      cost += Amount{1'000'000};
    }
    const std::vector<const Job*> benches{&job, &job, &costlier};
    const ListsJob question{.common = &job, .jobs = benches, .weights = weights_of(benches, 100)};
    Lists lists(question, some_lists(job, benches.size(), random));
    ASSERT_TRUE(lists.foresees());
    const auto below = [&](std::size_t limit) {
      return random.below(static_cast<std::uint32_t>(limit));
    };
    for (unsigned i = 0; i < 200; ++i) {
      const Spot where = lists.spot(below(lists.tests()));
      const auto setup = lists.setup(where);
      const Element x = below(job.parts());
      const Element out = setup[below(setup.size())];
      if (!lists.holds(where, x)) {
        expect(lists, lists.rise_of_replace(where, out, x), [&] { lists.replace(where, out, x); });
        if (setup.size() < job.room()) {
          expect(lists, lists.rise_of_replace(where, no_part, x),
                 [&] { lists.replace(where, no_part, x); });
        }
      }
      expect(lists, lists.rise_of_replace(where, out, no_part),
             [&] { lists.replace(where, out, no_part); });
      expect_of_whole_setups(lists, where, below);
    }
  }
  EXPECT_GT(moves_, 40'000U);
}

// Values of models: with some out of range, and costs by what is replaced.
TEST_F(Rises, OfValuesAreWhatMovesChange) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Model model = test::model_of(test::random_model_text(4000 + seed, 5, 4));
    Random random(seed, 7);
    Job job = job_of(model, Amount{3'000'000}, Amount{});
    for (Amount& cost : job.change_costs) {
      cost = Amount{(1 + random.below(5)) * 1'000'000ULL};
    }
    for (std::size_t i = 0; seed % 2 == 0 && i < job.parts() * job.parts(); ++i) {
      job.replace_costs.push_back(Amount{(1 + random.below(5)) * 1'000'000ULL});
    }
    const std::vector<Block> rows = test::all_tests(model);
    const auto below = [&](std::size_t limit) {
      return random.below(static_cast<std::uint32_t>(limit));
    };
    job.start = rows[below(rows.size())];
    job.start.pop_back();
    const std::vector<const Job*> benches{&job, &job};
    const ListsJob question{.common = &job,
                            .jobs = benches,
                            .weights = weights_of(benches, 100),
                            .rules = std::make_shared<const CompiledRules>(model)};
    BenchLists some(2);
    for (std::vector<Block>& list : some) {
      for (std::size_t i = 1 + below(5); i > 0; --i) {
        list.push_back(rows[below(rows.size())]);
      }
    }
    Lists lists(question, some);
    ASSERT_TRUE(lists.foresees());
    for (unsigned i = 0; i < 100; ++i) {
      const Spot where = lists.spot(below(lists.tests()));
      const Element x = below(job.parts());
      const Element out = lists.rival_in(lists.setup(where), x);
      if (x != out) {
        const auto there = lists.setup(where);
        Block row(there.begin(), there.end());
        std::ranges::replace(row, out, x);
        ASSERT_EQ(lists.may_replace(where, out, x), follows(model, row));
        if (follows(model, row)) {
          expect(lists, lists.rise_of_replace(where, out, x),
                 [&] { lists.replace(where, out, x); });
        }
      }
      expect_of_whole_setups(lists, where, below);
    }
  }
  EXPECT_GT(moves_, 5'000U);
}

}  // namespace
}  // namespace changeover::rises_test
