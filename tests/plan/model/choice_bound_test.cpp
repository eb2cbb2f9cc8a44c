// What tests of models cost at least, and how many there are [docs/theorems.md, Theorem 21].
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "changeover/plan/run_plan.hpp"
#include "changeover/run/control.hpp"
#include "cheapest.hpp"
#include "plan/search/choices/equal_values.hpp"
#include "random_models.hpp"
#include "run/random.hpp"

namespace changeover::choice_bound_test {
namespace {

std::string model_text(const std::vector<std::uint32_t>& sizes) {
  std::string text;
  for (std::size_t p = 0; p < sizes.size(); ++p) {
    text += "P" + std::to_string(p) + ":";
    for (std::uint32_t i = 0; i < sizes[p]; ++i) {
      text += (i == 0 ? " v" : ", v") + std::to_string(p) + "_" + std::to_string(i);
    }
    text += "\n";
  }
  return text;
}

TEST(ChoiceBound, IsNeverAboveTheCheapestPlanOfTinyModels) {
  std::size_t attained = 0;
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    Random random(seed, 99);
    std::vector<std::uint32_t> sizes(2 + random.below(3));
    for (std::uint32_t& size : sizes) {
      size = 2 + (sizes.size() < 4 ? random.below(2) : 0);
    }
    const Model model = test::model_of(model_text(sizes));
    Job job = job_of(model, Amount{random.below(4) * 1'000'000ULL}, Amount{1'000'000});
    const bool one_price = random.one_in_two();
    for (Amount& cost : job.change_costs) {
      cost = one_price ? cost : Amount{(1 + random.below(5)) * 500'000ULL};
    }
    while (job.needed.size() > 13) {
      PairSet some(job.parts());
      job.needed.for_each(1000, [&](Element x, Element y) {
        if (random.below(8) > 0) {
          some.insert(x, y);
        }
      });
      job.needed = some;
    }
    const std::uint64_t least = test::least_cost(job).value();
    const CostBound bound = cost_bound(job);
    EXPECT_LE(bound.cost.millionths, least) << seed << '\n' << model_text(sizes);
    attained += bound.cost.millionths == least ? 1U : 0U;
  }
  EXPECT_GT(attained, 500U);
}

// One parameter may change twice, and all others three times: intervals that overlap do it.
TEST(ChoiceBound, OfManyParametersWithTwoValuesIsAttained) {
  for (const std::size_t k : {2U, 3U, 7U, 20U}) {
    const Model model = test::model_of(model_text(std::vector<std::uint32_t>(k, 2)));
    const Job job = job_of(model, Amount{}, Amount{1});
    EXPECT_EQ(cost_bound(job).cost, Amount{3 * k - 1}) << k;
  }
}

TEST(ChoiceBound, OfManyParametersCountsEachSizeByItself) {
  const Model model = test::model_of(model_text({2, 2, 2, 2, 4, 4, 4}));
  const Job job = job_of(model, Amount{}, Amount{1});
  EXPECT_EQ(cost_bound(job).cost, Amount{11 + 26});  // 3 each but for one, and 9 each but for one
}

// Lists of k parameters of g values each in which one value changes per step: whether all pairs can
// meet in so many steps, by looking at everything. Changes at the same time do no more than one
// after the other.
class Stays {
 public:
  Stays(std::size_t k, std::size_t g) : k_(k), g_(g), now_(k, 0), met_(k * k, 1) {}

  [[nodiscard]] std::size_t least() {
    std::size_t steps = 0;
    while (!can_in(steps)) {
      ++steps;
      seen_.clear();
    }
    return steps + k_;
  }

 private:
  bool can_in(std::size_t steps) {
    std::size_t open = 0;
    std::vector<std::uint32_t> state(now_.begin(), now_.end());
    for (std::size_t p = 0; p < k_; ++p) {
      for (std::size_t q = 0; q < p; ++q) {
        open += g_ * g_ - static_cast<std::size_t>(std::popcount(met_[p * k_ + q]));
        state.push_back(met_[p * k_ + q]);
      }
    }
    state.push_back(static_cast<std::uint32_t>(steps));
    if (open == 0 || open > steps * (k_ - 1) || !seen_.insert(state).second) {
      return open == 0;
    }
    for (std::size_t p = 0; p < k_; ++p) {
      for (std::uint32_t x = 0; x < g_; ++x) {
        const std::vector<std::uint32_t> before = met_;
        const std::uint32_t old = std::exchange(now_[p], x);
        for (std::size_t q = 0; q < k_ && x != old; ++q) {
          const bool first = q < p;
          const std::size_t pair = first ? p * k_ + q : q * k_ + p;
          met_[pair] |= p == q ? 0 : 1U << (first ? x * g_ + now_[q] : now_[q] * g_ + x);
        }
        const bool can = x != old && can_in(steps - 1);
        met_ = before;
        now_[p] = old;
        if (can) {
          return true;
        }
      }
    }
    return false;
  }

  std::size_t k_;
  std::size_t g_;
  std::vector<std::uint32_t> now_;
  std::vector<std::uint32_t> met_;
  std::set<std::vector<std::uint32_t>> seen_;
};

TEST(ChoiceBound, OfStaysIsAttainedByTinyModels) {
  const std::vector<std::pair<std::uint32_t, std::size_t>> models{
      {2, 2}, {2, 3}, {2, 4}, {3, 2}, {3, 3}};
  for (const auto& [g, k] : models) {
    const Model model = test::model_of(model_text(std::vector<std::uint32_t>(k, g)));
    const CostBound bound = cost_bound(job_of(model, Amount{}, Amount{1}));
    EXPECT_EQ(bound.cost, Amount{Stays(k, g).least()}) << g << "^" << k;
  }
}

// At most two have five settings: Theorem 24 (3).
TEST(ChoiceBound, OfManyParametersWithThreeValues) {
  for (const std::size_t k : {2U, 3U, 7U, 20U}) {
    const Model model = test::model_of(model_text(std::vector<std::uint32_t>(k, 3)));
    EXPECT_EQ(cost_bound(job_of(model, Amount{}, Amount{1})).cost, Amount{6 * k - 2}) << k;
    Job costly = job_of(model, Amount{}, Amount{1});  // the expensive one saves two settings
    std::fill_n(costly.change_costs.begin(), 3, Amount{3});
    EXPECT_TRUE(k < 4 || cost_bound(costly).cost == Amount{6 * (k + 2) - 6}) << k;
  }
}

// The fewest stays of k parameters with two values in so many tests, by looking at all rows of
// signs; nothing if there are too few tests.
class RowsOfSigns {
 public:
  RowsOfSigns(std::size_t k, std::uint32_t tests) : k_(k), tests_(tests) { add(1); }

  [[nodiscard]] std::optional<std::size_t> least() const { return least_; }

 private:
  [[nodiscard]] bool meet(std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t all = (1U << tests_) - 1;
    return (a & b) != 0 && (a & ~b) != 0 && (b & ~a) != 0 && (all & ~(a | b)) != 0;
  }
  void add(std::uint32_t from) {  // the first sign is minus
    if (rows_.size() == k_) {
      least_ = std::min(least_.value_or(stays_), stays_);
      return;
    }
    if (least_ && stays_ + 2 * (k_ - rows_.size()) >= *least_) {
      return;
    }
    for (std::uint32_t row = from; row < 1U << (tests_ - 1); ++row) {
      if (std::ranges::all_of(rows_, [&](std::uint32_t other) { return meet(other, row); })) {
        rows_.push_back(row);
        stays_ += stays_of(row);
        add(row + 1);
        stays_ -= stays_of(row);
        rows_.pop_back();
      }
    }
  }
  [[nodiscard]] std::size_t stays_of(std::uint32_t row) const {
    const std::uint32_t steps = (row ^ row >> 1U) & ((1U << (tests_ - 1)) - 1);
    return 1 + static_cast<std::size_t>(std::popcount(steps));
  }

  std::size_t k_;
  std::uint32_t tests_;
  std::vector<std::uint32_t> rows_;
  std::size_t stays_ = 0;
  std::optional<std::size_t> least_;
};

// Theorem 25: what few tests need.
TEST(ChoiceBound, OfTwoValuesInFewTests) {
  std::size_t attained = 0;
  for (std::size_t k = 2; k <= 5; ++k) {
    const Model model = test::model_of(model_text(std::vector<std::uint32_t>(k, 2)));
    for (const std::uint64_t test : {1U, 2U, 5U}) {
      std::uint64_t cheapest = ~std::uint64_t{0};
      for (std::uint32_t tests = 4; tests <= 7; ++tests) {
        if (const auto stays = RowsOfSigns(k, tests).least()) {
          const std::size_t four = (tests - 2) * (tests - 2) / 4;
          EXPECT_GE(*stays + 3 + 2 * ((tests - 1) / 2) + four, 5 * k) << k << ' ' << tests;
          cheapest = std::min(cheapest, 2 * *stays + test * tests);
        }
      }
      const Amount bound = cost_bound(job_of(model, Amount{test}, Amount{2})).cost;
      EXPECT_LE(bound, Amount{cheapest}) << k << ' ' << test;
      attained += bound == Amount{cheapest} ? 1U : 0U;
    }
  }
  EXPECT_GE(attained, 6U);
  const Model model = test::model_of(model_text(std::vector<std::uint32_t>(40, 2)));
  EXPECT_EQ(cost_bound(job_of(model, Amount{5}, Amount{1})).cost, Amount{220});
  EXPECT_EQ(cost_bound(job_of(model, Amount{}, Amount{1})).cost, Amount{119});
}

// How many sets of tests of two stays each, the second of them at the end, of which none contains
// another: the chains of Theorem 25 as a matching, since there are as few chains as such sets.
TEST(ChoiceBound, OfFourStaysInFewTests) {
  for (std::uint32_t tests = 4; tests <= 11; ++tests) {
    std::vector<std::uint32_t> sets;
    for (std::uint32_t set = 1; set < 1U << tests; ++set) {
      const std::uint32_t steps = (set ^ set >> 1U) & ((1U << (tests - 1)) - 1);
      if ((set & 1U) == 0 && std::popcount(steps) == 3) {
        sets.push_back(set);
      }
    }
    std::vector<std::size_t> before(sets.size(), sets.size());
    std::vector<bool> seen;
    const auto follow = [&](const auto& self, std::size_t from) -> bool {
      for (std::size_t to = 0; to < sets.size(); ++to) {
        if (to != from && (sets[from] & ~sets[to]) == 0 && !seen[to]) {
          seen[to] = true;
          if (before[to] == sets.size() || self(self, before[to])) {
            before[to] = from;
            return true;
          }
        }
      }
      return false;
    };
    std::size_t chains = sets.size();
    for (std::size_t from = 0; from < sets.size(); ++from) {
      seen.assign(sets.size(), false);
      chains -= follow(follow, from) ? 1U : 0U;
    }
    EXPECT_EQ(chains, (tests - 2) * (tests - 2) / 4) << tests;
  }
}

// How many parameters of three values can have so few stays in so many tests, and how few stays a
// number of parameters has together, by looking at all rows of values.
class RowsOfThree {
 public:
  RowsOfThree(std::uint32_t tests, std::size_t most_stays) : tests_(tests), most_(most_stays) {
    make({}, 0, 0, 3, 0);
  }

  [[nodiscard]] std::size_t most_rows() {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      look_from(i, rows_.size());
    }
    return most_rows_;
  }
  // Those of one row count `costly` times.
  [[nodiscard]] std::size_t least_stays(std::size_t k, std::size_t costly) {
    least_ = tests_ * (k + costly) + 1;
    costly_ = costly;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      look_from(i, k);
    }
    return least_;
  }

 private:
  using Row = std::array<std::uint32_t, 3>;  // by value: in which tests
  using Bits = std::vector<std::uint64_t>;

  void make(Row row, std::uint32_t at, std::uint32_t seen, std::uint32_t last, std::size_t stays) {
    if (at == tests_) {
      if (std::ranges::all_of(row, [](std::uint32_t each) { return std::popcount(each) > 2; })) {
        rows_.push_back(row);
        stays_.push_back(stays);
      }
      return;
    }
    for (std::uint32_t x = 0; x < std::min(3U, seen + 1); ++x) {
      Row longer = row;
      longer[x] |= 1U << at;
      if (stays + (x == last ? 0 : 1) <= most_) {
        make(longer, at + 1, std::max(seen, x + 1), x, stays + (x == last ? 0 : 1));
      }
    }
  }
  [[nodiscard]] bool meet(std::size_t i, std::size_t j) const {
    return std::ranges::all_of(rows_[i], [&](std::uint32_t one) {
      return std::ranges::all_of(rows_[j], [&](std::uint32_t other) { return (one & other) != 0; });
    });
  }
  void look_from(std::size_t first, std::size_t k) {
    others_.clear();
    for (std::size_t j = first + 1; j < rows_.size(); ++j) {
      if (meet(first, j)) {
        others_.push_back(j);
      }
    }
    if (others_.size() < most_rows_ && k >= rows_.size()) {
      return;
    }
    fits_.assign(others_.size(), Bits((others_.size() + 63) / 64, 0));
    Bits all((others_.size() + 63) / 64, 0);
    for (std::size_t i = 0; i < others_.size(); ++i) {
      all[i / 64] |= std::uint64_t{1} << i % 64;
      for (std::size_t j = 0; j < i; ++j) {
        const std::uint64_t both = meet(others_[i], others_[j]) ? 1 : 0;
        fits_[i][j / 64] |= both << j % 64;
        fits_[j][i / 64] |= both << i % 64;
      }
    }
    add(all, 1, stays_[first], stays_[first], k);
  }
  // The open rows in classes, no two of a class fitting: of those up to a row, no more can be added
  // than there are classes up to its own.
  [[nodiscard]] std::vector<std::array<std::size_t, 2>> in_classes(Bits open) const {
    std::vector<std::array<std::size_t, 2>> order;
    for (std::size_t classes = 1;; ++classes) {
      Bits free = open;
      const std::size_t before = order.size();
      for (std::size_t w = 0; w < free.size(); ++w) {
        while (free[w] != 0) {
          const std::size_t i = 64 * w + static_cast<std::size_t>(std::countr_zero(free[w]));
          free[w] &= free[w] - 1;
          open[w] &= ~(std::uint64_t{1} << i % 64);
          for (std::size_t v = w; v < free.size(); ++v) {
            free[v] &= ~fits_[i][v];
          }
          order.push_back({i, classes});
        }
      }
      if (order.size() == before) {
        return order;
      }
    }
  }
  void add(Bits open, std::size_t rows, std::size_t stays, std::size_t fewest, std::size_t k) {
    most_rows_ = std::max(most_rows_, rows);
    if (rows == k) {
      least_ = std::min(least_, stays + (costly_ - 1) * fewest);
      return;
    }
    const std::vector<std::array<std::size_t, 2>> order = in_classes(open);
    for (auto each = order.rbegin(); each != order.rend(); ++each) {
      const auto [i, classes] = *each;
      const std::size_t wanted = k < rows_.size() ? k : most_rows_ + 1;
      if (rows + classes < wanted) {
        return;
      }
      open[i / 64] &= ~(std::uint64_t{1} << i % 64);
      Bits next = open;
      for (std::size_t w = 0; w < next.size(); ++w) {
        next[w] &= fits_[i][w];
      }
      const std::size_t own = stays_[others_[i]];
      add(std::move(next), rows + 1, stays + own, std::min(fewest, own), k);
    }
  }

  std::uint32_t tests_;
  std::size_t most_;
  std::vector<Row> rows_;
  std::vector<std::size_t> stays_;
  std::vector<std::size_t> others_;
  std::vector<Bits> fits_;  // of others, to later ones
  std::size_t most_rows_ = 0;
  std::size_t least_ = 0;
  std::size_t costly_ = 1;
};

// Theorem 27: six and seven stays in few tests.
TEST(ChoiceBound, OfThreeValuesInFewTests) {
  for (std::uint32_t tests = 9; tests <= 13; ++tests) {
    const std::size_t most = RowsOfThree(tests, 6).most_rows();
    EXPECT_EQ(most, (tests - 1) / 3) << tests;
    EXPECT_LE(most - 5 * most / (tests - 1), (tests - 2) / 3) << tests;  // with a test fewer
    if (tests <= 11) {
      EXPECT_EQ(RowsOfThree(tests, 7).most_rows(), 4U) << tests;
    }
  }
  for (std::size_t k = 3; k <= 4; ++k) {
    const Model few = test::model_of(model_text(std::vector<std::uint32_t>(k, 3)));
    for (std::uint32_t tests = 9; tests <= (k == 3 ? 10U : 9U); ++tests) {
      RowsOfThree rows(tests, tests);
      EXPECT_GE(rows.least_stays(k, 1) + (tests - 1) / 3 + 2, 7 * k) << tests;
      for (const std::uint32_t costly : {1U, 2U, 5U, 9U}) {
        const std::size_t stays = rows.least_stays(k, costly);
        for (const std::uint64_t test : {0U, 1U, 5U, 20U}) {
          Job job = job_of(few, Amount{test}, Amount{1});
          std::fill_n(job.change_costs.begin(), 3, Amount{costly});
          EXPECT_LE(cost_bound(job).cost, Amount{test * tests + stays})
              << k << ' ' << tests << ' ' << costly << ' ' << test;
        }
      }
    }
  }
  const Model model = test::model_of(model_text(std::vector<std::uint32_t>(12, 3)));
  EXPECT_EQ(cost_bound(job_of(model, Amount{5}, Amount{1})).cost, Amount{5 * 15 + 7 * 12 - 4 - 2});
  EXPECT_EQ(cost_bound(job_of(model, Amount{}, Amount{1})).cost, Amount{70});
  const Model many = test::model_of(model_text(std::vector<std::uint32_t>(40, 3)));
  EXPECT_EQ(cost_bound(job_of(many, Amount{5}, Amount{1})).cost, Amount{5 * 17 + 7 * 40 - 5 - 2});
  Job costly =
      job_of(model, Amount{5}, Amount{1});  // three stays of the expensive one, seven of others
  std::fill_n(costly.change_costs.begin(), 3, Amount{9});
  EXPECT_EQ(cost_bound(costly).cost, Amount{5 * 15 + 7 * 11 + 3 * 9});
}

TEST(ChoiceBoundSlow, OfThreeValuesInFewTests) {
  for (std::uint32_t tests = 14; tests <= 17; ++tests) {
    EXPECT_EQ(RowsOfThree(tests, 6).most_rows(), (tests - 1) / 3) << tests;
  }
  for (std::uint32_t tests = 12; tests <= 13; ++tests) {
    EXPECT_EQ(RowsOfThree(tests, 7).most_rows(), 5U) << tests;
  }
}

// What steps in which several parameters change do to pairs, (7) of choice_plan.hpp: no more than
// all rows of signs and of three values, looked through, and lists of four values.
TEST(ChoiceBound, OfEqualParametersInEachStep) {
  std::size_t attained = 0;
  for (std::size_t k = 2; k <= 5; ++k) {
    std::optional<std::uint64_t> before;
    for (std::uint32_t tests = 1; tests <= (k < 5 ? 7U : 6U); ++tests) {
      const std::optional<std::uint64_t> least = least_stays_of_equal(k, 2, tests);
      EXPECT_EQ(least, least_stays_of_equal(k, 2, tests, before)) << k << ' ' << tests;
      EXPECT_TRUE(!before || least <= before) << k << ' ' << tests;
      if (const auto stays = RowsOfSigns(k, tests).least()) {
        ASSERT_TRUE(least) << k << ' ' << tests;
        EXPECT_LE(*least, *stays) << k << ' ' << tests;
        attained += *least == *stays ? 1U : 0U;
      }
      before = least;
    }
  }
  for (std::size_t k = 2; k <= 4; ++k) {
    for (std::uint32_t tests = 9; tests <= (k < 4 ? 10U : 9U); ++tests) {
      const std::size_t stays = RowsOfThree(tests, tests).least_stays(k, 1);
      const std::uint64_t least = least_stays_of_equal(k, 3, tests).value();
      EXPECT_LE(least, stays) << k << ' ' << tests;
      attained += least == stays ? 1U : 0U;
    }
  }
  EXPECT_GE(attained, 3U);
  EXPECT_FALSE(least_stays_of_equal(3, 4, 15));  // 16 pairs, one a test
  EXPECT_EQ(least_stays_of_equal(3, 4, 16), 33U);
  // With expensive and cheap parameters, another number of values beside, and with a start.
  for (const std::uint64_t test : {1U, 3U, 10U}) {
    const Model model = test::model_of(model_text({4, 4, 4, 4, 3, 2}));
    Job job = job_of(model, Amount{test * 1'000'000}, Amount{1'000'000});
    RunControl control({.threads = 1});
    EXPECT_TRUE(make_run_plan(job, {.steps = 200'000}, control).sheet.does_the_job());
    std::fill_n(job.change_costs.begin(), 4, Amount{7'000'000});
    job.start = {0, 5};
    RunControl again({.threads = 1});
    const RunPlan plan = make_run_plan(job, {.steps = 200'000}, again);
    EXPECT_LE(plan.bound.cost, plan.sheet.cost) << test;
  }
}

// Parameters of three values that few tests bound are in no other set: plans of these models are
// cheaper than if they were counted twice.
TEST(ChoiceBound, CountsAParameterOnce) {
  for (const std::vector<std::uint32_t>& sizes :
       {std::vector<std::uint32_t>{3, 3, 3, 4, 2}, {3, 3, 3, 3, 3, 3, 4, 2}, {4, 4, 4, 3, 2}}) {
    for (const std::uint64_t test : {0U, 1U}) {
      const Job job =
          job_of(test::model_of(model_text(sizes)), Amount{test * 1'000'000}, Amount{1'000'000});
      RunControl control({.threads = 1});
      const RunPlan plan = make_run_plan(job, {.steps = 300'000}, control);
      EXPECT_LE(plan.bound.cost, plan.sheet.cost) << model_text(sizes) << test;
    }
  }
}

// One parameter after the other, a part of its way each time: with rules, too.
TEST(ChoiceBound, SweepsChangeLittle) {
  std::vector<std::uint32_t> sizes(24, 2);
  sizes.resize(32, 3);
  sizes.resize(36, 4);
  for (const std::string rule : {"", "IF [P0] = \"v0_0\" THEN [P30] <> \"v30_1\";\n"}) {
    const Model model = test::model_of(model_text(sizes) + rule);
    RunControl control({.threads = 1});
    Job job = job_of(model, Amount{}, Amount{1});
    drop_needed(job, cannot_meet(job));
    const RunPlan plan = make_run_plan(job, {.steps = 1, .attempts = 1}, control);
    EXPECT_TRUE(plan.sheet.does_the_job());
    EXPECT_LE(plan.sheet.cost, Amount{24 * 3 + 8 * 6 + 4 * 9 + 20}) << rule;
  }
}

// Theorem 24 (2): for any number of values, however many parameters there are.
TEST(ChoiceBound, SweepsNeedHalfOfThePairs) {
  for (const std::uint32_t g : {2U, 3U, 4U, 5U, 6U, 7U, 9U, 12U}) {
    constexpr std::size_t k = 9;
    const Model model = test::model_of(model_text(std::vector<std::uint32_t>(k, g)));
    RunControl control({.threads = 1});
    const Job job = job_of(model, Amount{}, Amount{1});
    const RunPlan plan = make_run_plan(job, {.steps = 1, .attempts = 1}, control);
    EXPECT_LE(plan.sheet.cost, Amount{k * ((g * g + 3) / 2)}) << g;
  }
}

// Arrays of so many tests exist: those known to be the smallest, or the smallest that are known.
TEST(ChoiceBound, NeedsNoMoreTestsThanThereAreArrays) {
  const std::map<std::pair<std::uint64_t, std::uint64_t>, std::uint64_t> arrays{
      {{3, 2}, 4},    {{4, 2}, 5},  {{10, 2}, 6}, {{15, 2}, 7}, {{35, 2}, 8}, {{56, 2}, 9},
      {{126, 2}, 10}, {{4, 3}, 9},  {{5, 3}, 11}, {{7, 3}, 12}, {{9, 3}, 13}, {{10, 3}, 14},
      {{20, 3}, 15},  {{5, 4}, 16}, {{6, 4}, 19}, {{7, 4}, 21}, {{6, 5}, 25}, {{7, 5}, 29},
      {{8, 7}, 49},   {{3, 6}, 36}, {{9, 8}, 64}};
  for (const auto& [cell, tests] : arrays) {
    EXPECT_LE(least_tests_of_equal(cell.first, cell.second), tests)
        << cell.first << ' ' << cell.second;
  }
  EXPECT_EQ(least_tests_of_equal(5, 3), 11U);
  EXPECT_EQ(least_tests_of_equal(13, 3), 12U);
  EXPECT_EQ(least_tests_of_equal(15, 4), 20U);
  EXPECT_EQ(least_tests_of_equal(20, 10), 107U);
  for (const FewestTests& each : published_fewest_tests()) {
    EXPECT_LT(least_tests_of_equal(each.parameters, each.values), each.tests);
    const std::vector<std::uint32_t> sizes(each.parameters,
                                           static_cast<std::uint32_t>(each.values));
    const Model model = test::model_of(model_text(sizes));
    EXPECT_EQ(cost_bound(job_of(model, Amount{1}, Amount{})).tests, each.tests);
  }
}

TEST(ChoiceBound, GrowsWithTheParameters) {
  for (std::uint64_t g = 2; g <= 12; ++g) {
    for (std::uint64_t k = 2; k < 200; ++k) {
      EXPECT_LE(least_tests_of_equal(k, g), least_tests_of_equal(k + 1, g)) << k << ' ' << g;
    }
  }
}

TEST(ChoiceBound, CountsAParameterByAsManyOfItsValuesAsOthersHave) {
  const Model model = test::model_of(model_text({3, 4, 3, 5, 3, 2}));
  const CostBound bound = cost_bound(job_of(model, Amount{1}, Amount{}));
  EXPECT_EQ(bound.tests, 20U);
  const Model more = test::model_of(model_text({3, 3, 3, 3, 3, 3, 3, 3, 2}));
  EXPECT_EQ(cost_bound(job_of(more, Amount{1}, Amount{})).tests, 12U);
}

}  // namespace
}  // namespace changeover::choice_bound_test
