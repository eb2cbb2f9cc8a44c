#include "loadorder/shares/groups/group_shares.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <string>

#include "../../loadorder_support.hpp"
#include "changeover/loadorder/workers.hpp"
#include "loadorder/shares/groups/idle_workers.hpp"
#include "loadorder/shares/groups/known_shares.hpp"
#include "loadorder/shares/owners/group_owners.hpp"

namespace changeover::test::group_shares_test {
namespace {

TEST(ItemGroups, AreConsecutiveAndAsLargeAsEachOther) {
  for (std::uint64_t items = 1; items <= 40; ++items) {
    for (std::uint64_t count = 1; count <= items; ++count) {
      const ItemGroups groups{items, count};
      for (std::uint64_t g = 0; g < count; ++g) {
        EXPECT_TRUE(groups.size(g) == items / count || groups.size(g) == items / count + 1);
        for (std::uint64_t x = groups.begin(g); x < groups.end(g); ++x) {
          EXPECT_EQ(groups.group_of(x), g);
        }
      }
      EXPECT_EQ(groups.end(count - 1), items);
    }
  }
}

// What is held stays, each streamed item comes once, and all is in its room.
TEST(GroupShares, StreamInAnyRoomThatTakesWhatIsHeldAndOneMore) {
  const ItemGroups groups{23, 7};
  const GroupShare share{{0, 3}, {1, 4, 6}};
  for (std::uint64_t room = 1; room <= 23; ++room) {
    const ShareCost cost = cost_of(share, groups, room);
    EXPECT_EQ(cost.loads, groups.size(share.held) + groups.size(share.streamed));
    EXPECT_EQ(cost.steps > 0, room > groups.size(share.held)) << room;
    if (cost.steps == 0) {
      continue;
    }
    const auto steps = share_steps(share, groups, room, 5);
    const Simulation played = simulate(*steps, 23, room);
    EXPECT_EQ(played.fault, "") << room;
    EXPECT_EQ(played.loads, cost.loads);
    EXPECT_EQ(played.steps, cost.steps);
    std::vector<Element> held;
    std::vector<Element> streamed;
    groups.put(share.held, held);
    groups.put(share.streamed, streamed);
    for (const Element x : held) {
      EXPECT_TRUE(played.memory.contains(x));
      for (const std::vector<Element>* const others : {&held, &streamed}) {
        for (const Element y : *others) {
          EXPECT_TRUE(x == y || played.met.contains({std::min(x, y), std::max(x, y)}));
        }
      }
    }
  }
}

TEST(GroupShares, CanBeReadFromAnyStep) {
  const ItemGroups groups{23, 7};
  const GroupShare share{{0, 3}, {1, 4, 6}};
  for (const std::uint64_t room : {8U, 9U, 11U, 14U, 23U}) {
    const auto reader = share_steps(share, groups, room, 0);
    const std::vector<Step> all = all_steps(*reader);
    std::set<Element> memory;
    for (const Step& step : all) {
      std::vector<Element> held;
      const auto from = share_steps(share, groups, room, 0);
      ASSERT_TRUE(from->jump(step.number, held));
      EXPECT_EQ(std::set<Element>(held.begin(), held.end()), memory) << room << " " << step.number;
      EXPECT_EQ(
          all_steps(*from),
          std::vector<Step>(all.begin() + static_cast<std::ptrdiff_t>(step.number - 1), all.end()));
      for (const Element x : step.evict) {
        memory.erase(x);
      }
      memory.insert(step.load.begin(), step.load.end());
    }
    std::vector<Element> held;
    EXPECT_FALSE(share_steps(share, groups, room, 0)->jump(all.size() + 1, held));
    EXPECT_FALSE(share_steps(share, groups, room, 0)->jump(0, held));
  }
}

// Every line of the table, by the definition: any two groups meet, every group is held.
TEST(ShareTable, EveryLineBringsAllGroupsTogether) {
  ASSERT_GT(share_table().size(), 100U);
  std::set<std::string> lines;
  for (const char* const line : share_table()) {
    EXPECT_TRUE(lines.insert(line).second) << line;
    const GroupShares shares = developed_shares(line);
    const std::size_t n = shares.groups;
    std::vector<bool> met(n * n, false);
    for (const GroupShare& share : shares.workers) {
      EXPECT_EQ(share.held.size(), shares.workers[0].held.size()) << line;
      EXPECT_EQ(share.streamed.size(), shares.workers[0].streamed.size()) << line;
      std::set<Element> all(share.held.begin(), share.held.end());
      all.insert(share.streamed.begin(), share.streamed.end());
      ASSERT_EQ(all.size(), share.held.size() + share.streamed.size()) << line;
      ASSERT_LT(*all.rbegin(), n) << line;
      for (const Element x : share.held) {
        for (const Element y : all) {
          met[x * n + y] = met[y * n + x] = true;
        }
      }
    }
    EXPECT_EQ(std::find(met.begin(), met.end(), false), met.end()) << line;
  }
}

// A line with a group less is none: the test above can fail.
TEST(ShareTable, ALineThatLacksAGroupIsFound) {
  const GroupShares right = developed_shares("7 1 | 0 1 3 /");
  EXPECT_EQ(owners_of(right, 70)->missing(), 0U);
  const GroupShares wrong = developed_shares("7 1 | 0 1 2 /");
  EXPECT_GT(owners_of(wrong, 70)->missing(), 0U);
}

// The fewest elements of a cover of all differences modulo n, by trying all.
std::uint64_t smallest_cover(std::uint64_t n) {
  for (std::uint64_t size = 1;; ++size) {
    std::vector<std::uint64_t> cover{0};
    const std::function<bool()> extend = [&] {
      if (cover.size() == size) {
        std::vector<bool> is_difference(n, false);
        for (const std::uint64_t x : cover) {
          for (const std::uint64_t y : cover) {
            is_difference[(x + n - y) % n] = true;
          }
        }
        return std::find(is_difference.begin(), is_difference.end(), false) == is_difference.end();
      }
      for (std::uint64_t next = cover.back() + 1; next < n; ++next) {
        cover.push_back(next);
        if (extend()) {
          return true;
        }
        cover.pop_back();
      }
      return false;
    };
    if (size * (size - 1) + 1 >= n && extend()) {
      return size;
    }
  }
}

TEST(ShareTable, SharesAreNoWorseThanQuorums) {
  for (std::uint64_t n = 3; n <= 32; ++n) {
    const auto shares = best_group_shares(40 * n, 40 * n, n, 40 * n);
    ASSERT_TRUE(shares.has_value()) << n;
    std::uint64_t most = 0;
    for (const GroupShare& share : shares->workers) {
      most = std::max(most, cost_of(share, {40 * n, shares->groups}, 40 * n).loads);
    }
    EXPECT_LE(most, 40 * smallest_cover(n)) << n;
  }
}

TEST(ShareTable, HasQuorumsOfManyNumbersOfWorkers) {
  for (std::uint64_t n = 40; n <= 200; n += 20) {
    const auto shares = best_group_shares(40 * n, 40 * n, n, 40 * n);
    ASSERT_TRUE(shares.has_value()) << n;
    EXPECT_LE(shares->workers.size(), n);
    // Planes and covers are within a quarter of what counting pairs alone asks.
    EXPECT_LE(cost_of(shares->workers[0], {40 * n, shares->groups}, 40 * n).loads,
              1.25 * 40 * std::sqrt(n))
        << n;
  }
}

// Pairs of items, by playing: each is one worker's, who has both, and counts are as said.
TEST(GroupOwners, GiveEachPairToOneWorkerThatHasIt) {
  for (const char* const line : {"7 1 | 0 1 3 /", "5 1 | 0 / 1 2", "16 1 | 2 5 11 / 7 10"}) {
    const GroupShares shares = developed_shares(line);
    for (const std::uint64_t items : {shares.groups, 2 * shares.groups + 3, 61UL}) {
      const auto owners = owners_of(shares, items);
      const ItemGroups groups{items, shares.groups};
      std::vector<std::uint64_t> counted(shares.workers.size(), 0);
      for (Element y = 0; y < items; ++y) {
        for (Element x = 0; x <= y; ++x) {
          unsigned times = 0;
          for (std::size_t w = 0; w < shares.workers.size(); ++w) {
            if (!owners->of(w)->computes(1, x, y)) {
              continue;
            }
            ++times;
            counted[w] += x == y ? 0U : 1U;
            const GroupShare& share = shares.workers[w];
            const auto has = [&](const std::vector<Element>& set, Element item) {
              return std::find(set.begin(), set.end(), groups.group_of(item)) != set.end();
            };
            EXPECT_TRUE((has(share.held, x) && (has(share.held, y) || has(share.streamed, y))) ||
                        (has(share.held, y) && has(share.streamed, x)));
          }
          EXPECT_EQ(times, 1U) << line << " " << items << " " << x << " " << y;
        }
      }
      EXPECT_EQ(owners->pairs(), counted) << line;
      const std::uint64_t most = *std::max_element(counted.begin(), counted.end());
      const std::uint64_t all = items * (items - 1) / 2;
      EXPECT_LE(most, (all + counted.size() - 1) / counted.size() + 4 * groups.size(0) + 4) << line;
    }
  }
}

// Streamed groups that stay meet each other: as many loads, and pairs are never less even.
TEST(GroupShares, HoldMoreWhereItFitsAndPairsAreMoreEven) {
  int better = 0;
  for (const std::uint64_t workers : {5U, 9U, 14U}) {
    for (const std::uint64_t items : {64U, 256U}) {
      each_group_shares(
          workers, items, [](const ShareShape& shape) { return shape.groups <= 30; },
          [&](const GroupShares& shares) {
            for (const std::uint64_t room : {items / 4, items / 2, items}) {
              const GroupShares more = with_more_held(shares, items, room);
              const ItemGroups few{items, shares.groups};
              const ItemGroups many{items, more.groups};
              for (std::size_t w = 0; w < shares.workers.size(); ++w) {
                const ShareCost cost = cost_of(shares.workers[w], few, room);
                const ShareCost its = cost_of(more.workers[w], many, room);
                EXPECT_EQ(its.loads, cost.loads);
                EXPECT_EQ(its.steps > 0, cost.steps > 0);
              }
              const double before = unevenness(shares, items, shares.workers.size());
              const double after = unevenness(more, items, shares.workers.size());
              EXPECT_LE(after, before + 1e-9);
              better += after < before - 0.01 ? 1 : 0;
            }
          });
    }
  }
  EXPECT_GT(better, 0);
  const SplitFacts facts = split_load_order(256, 128, 9).facts();
  EXPECT_LE(facts.makespan, 104U);
  EXPECT_LE(facts.most_pairs * 9 * 100, facts.all_pairs * 105);
}

}  // namespace
}  // namespace changeover::test::group_shares_test
