#include "plan/search/anneal/sequence.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "changeover/run/control.hpp"
#include "plan/search/starts/starts.hpp"
#include "random_jobs.hpp"

namespace changeover::sequence_test {
namespace {

Sequence sequence_of(const Job& job, const std::vector<Block>& setups) {
  return {job, Weights::of(job, 100), setups};
}

// The cost and what is uncovered, counted from the definition.
struct Counted {
  std::int64_t cost = 0;
  std::int64_t uncovered = 0;
};

Counted counted(const Job& job, const std::vector<Block>& setups) {
  const Weights weights = Weights::of(job, 100);
  Counted result;
  PairSet met(job.parts());
  Block before = job.start;
  for (const Block& setup : setups) {
    result.cost += static_cast<std::int64_t>(weights.test);
    for (const Element x : setup) {
      const bool stays = std::find(before.begin(), before.end(), x) != before.end();
      result.cost += stays ? 0 : static_cast<std::int64_t>(weights.change[x]);
      for (const Element y : setup) {
        if (x < y && job.needed.contains(x, y)) {
          met.insert(x, y);
        }
      }
    }
    before = setup;
  }
  result.uncovered = static_cast<std::int64_t>(job.needed.size() - met.size());
  return result;
}

void expect_counted(const Job& job, const Sequence& s, const char* what) {
  const Counted recount = counted(job, s.setups());
  ASSERT_EQ(s.cost(), recount.cost) << what;
  ASSERT_EQ(static_cast<std::int64_t>(s.uncovered()), recount.uncovered) << what;
}

TEST(Sequence, SaysBeforehandWhatAMoveAddsAndCountsItAfterwards) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Job job = test::random_job(seed, 12);
    RunControl control({});
    Sequence s = sequence_of(job, greedy_start(job, control).setups);
    Random random(seed);
    const auto below = [&](std::size_t n) { return random.below(static_cast<std::uint32_t>(n)); };
    for (unsigned turn = 0; turn < 120 && s.size() > 1; ++turn) {
      const Counted before{s.cost(), static_cast<std::int64_t>(s.uncovered())};
      Rise rise;
      const std::size_t at = below(s.size());
      const auto members = s.setup(at);
      const Element x = members[below(members.size())];
      const Element y = below(job.parts());
      const unsigned kind = turn % 5;
      if (kind <= 1 && !s.holds(at, y)) {
        rise = s.rise_of_replace(at, x, y);
        s.replace(at, x, y, rise);
      } else if (kind == 2 && !s.holds(at, y)) {
        rise = s.rise_of_copy(at, x, y);
        Block copy(members.begin(), members.end());
        *std::find(copy.begin(), copy.end(), x) = y;
        s.insert(at + 1, copy);
      } else if (kind == 3 && turn % 2 == 0) {
        rise = s.rise_of_take_out(at);
        s.forget(s.take_out(at));
      } else if (kind == 4) {
        const std::size_t other = below(s.size());
        const Stretch where{std::min(at, other), std::max(at, other)};
        rise.cost = s.rise_of_reverse(where);
        s.reverse(where);
      }
      ASSERT_EQ(s.cost(), before.cost + rise.cost) << "seed " << seed << ", move " << kind;
      ASSERT_EQ(static_cast<std::int64_t>(s.uncovered()), before.uncovered + rise.uncovered)
          << "seed " << seed << ", move " << kind;
      expect_counted(job, s, "after a move");
    }
  }
}

TEST(Sequence, NamesEachDifferenceOfTwoSetUps) {
  Job job = make_job(70, 4, Amount{1}, Amount{1});
  job.start = {68, 69};
  const Sequence s = sequence_of(job, {{0, 1, 65, 68}, {1, 65, 2, 66}});
  const auto some = [&](std::size_t in, std::size_t without) {
    Block found;
    for (std::uint64_t i = 0; i < 16; ++i) {
      if (const auto x = s.some_difference(in, without, static_cast<std::uint32_t>(i << 28U))) {
        found.push_back(*x);
      }
    }
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  };
  EXPECT_EQ(some(1, 0), (Block{2, 66}));
  EXPECT_EQ(some(0, 1), (Block{0, 68}));
  EXPECT_EQ(some(0, 2), (Block{0, 1, 65})) << "2 set-ups: the third is the start";
  EXPECT_EQ(some(2, 0), (Block{69}));
  EXPECT_EQ(some(0, 0), Block{});
}

TEST(Sequence, WritesItsSetUpsAndReadsThemBack) {
  const Job job = make_job(6, 3, Amount{1}, Amount{1});
  const Sequence s = sequence_of(job, {{5, 0, 2}, {1, 3}, {4, 3, 0}});
  std::vector<Element> flat;
  s.write_to(flat);
  EXPECT_EQ(Sequence::setups_of(flat), (std::vector<Block>{{0, 2, 5}, {1, 3}, {0, 3, 4}}));
  EXPECT_EQ(s.setups(), Sequence::setups_of(flat));
}

}  // namespace
}  // namespace changeover::sequence_test
