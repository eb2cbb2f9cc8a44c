#include "plan/search/bounds/costliest_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "bounds/short_stays.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/search/bounds/least_numbers.hpp"

namespace changeover {
namespace {

using Counts = std::vector<std::uint64_t>;  // by number of most expensive parts

class CostliestBound {
 public:
  CostliestBound(const CostliestParts& question, std::uint64_t lists)
      : q_(&question), room_(question.room), lists_(lists), v_(question.parts.size()) {
    order_.resize(v_);
    std::iota(order_.begin(), order_.end(), 0);
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return question.prices[a] > question.prices[b];
    });
    count_prefixes();
    stays_at_least();
  }

  CostliestCost least() {
    relaxed_ = by_stays_;  // with any number of tests: (a), (d) and (e)
    for (std::size_t t = 1; t <= v_; ++t) {
      relaxed_[t] = std::max(relaxed_[t], fewest_one_by_one(t));
    }
    const std::uint64_t first_tests = std::max(q_->least_tests, lists_) + q_->starts;
    // Some numbers of tests first: once there is a value to compare with, the others take little
    // time.
    const std::uint64_t stride = 1 + first_tests / 12;
    for (std::uint64_t tests = first_tests; look_at(tests); tests += stride) {
      stop_if_asked();
    }
    for (std::uint64_t tests = first_tests; look_at(tests); ++tests) {
      stop_if_asked();
    }
    best_->tests -= std::min(best_->tests, q_->starts);
    best_->introductions -= std::min(best_->introductions, start_introductions_);
    return *best_;
  }

 private:
  // (e): all introductions, including those of the start.
  [[nodiscard]] std::uint64_t least_total(std::uint64_t tests) const {
    return std::max(q_->least_introductions, tests + lists_ * (q_->first - 1));
  }

  // Counts the needed pairs within the most expensive parts, and how many of these parts must all
  // meet.
  void count_prefixes() {
    pairs_.assign(v_ + 1, 0);
    degrees_.assign(v_ + 1, 0);
    least_each_.assign(v_ + 1, 0);
    most_each_.assign(v_ + 1, 0);
    price_.assign(v_ + 2, 0);
    for (std::size_t t = 1; t <= v_; ++t) {
      const std::size_t number = order_[t - 1];
      const Element x = q_->parts[number];
      std::uint64_t before = 0;
      std::uint64_t degree = 0;
      for (std::size_t u = 1; u <= v_; ++u) {
        const Element y = q_->parts[order_[u - 1]];
        const bool needed = x != y && q_->needed->contains(x, y);
        before += needed && u < t ? 1U : 0U;
        degree += needed ? 1U : 0U;
      }
      pairs_[t] = pairs_[t - 1] + before;
      degrees_[t] = degrees_[t - 1] + degree;
      const std::uint64_t there = q_->at_start[number];
      start_introductions_ += there;
      start_cost_ += Wide{q_->prices[number].millionths} * there;
      least_each_[t] = std::max<std::uint64_t>(1, there);
      most_each_[t] = std::max(least_each_[t], q_->most[number] + there);
      price_[t] = q_->prices[number].millionths;
    }
  }

  // (d), for the most expensive of the parts that must all meet; the others have one introduction.
  void stays_at_least() {
    by_stays_.assign(v_ + 1, 0);
    std::uint64_t together = 0;
    for (std::size_t t = 1; t <= v_; ++t) {
      together += q_->together[order_[t - 1]] ? 1U : 0U;
      std::uint64_t most = 0;
      for (std::uint64_t s = 1; s <= together; ++s) {
        const std::uint64_t all = (s + 1) * together;
        const std::uint64_t few = most_stays_short(s, room_);
        if (all <= few && s > 1) {
          break;
        }
        const std::uint64_t least = all - std::min(all, few);
        if (least < most) {
          break;  // the increments for few parts do not decrease
        }
        most = least;
      }
      by_stays_[t] = most + (t - together);
    }
  }

  // (a) for X: the fewest introductions that test its pairs.
  [[nodiscard]] std::uint64_t fewest_one_by_one(std::size_t t) const {
    std::uint64_t few = 0;
    while (few <= room_ && choose_two(few) < pairs_[t]) {
      ++few;
    }
    if (few <= room_) {
      return few;
    }
    return ceil_div(pairs_[t] + room_ * (room_ - 1) / 2, room_ - 1);
  }

  [[nodiscard]] std::uint64_t brought(std::uint64_t j) const {
    return choose_two(j) + j * (room_ - j);
  }

  // The sum of a concave function over the steps if a total is distributed over them as equally as
  // possible.
  template <typename Function>
  [[nodiscard]] std::uint64_t shared(std::uint64_t steps, std::uint64_t all,
                                     Function&& function) const {
    if (steps == 0) {
      return 0;
    }
    all = std::min(all, room_ * steps);
    const std::uint64_t each = all / steps;
    const std::uint64_t more = all % steps;
    return (steps - more) * function(each) + (more == 0 ? 0 : more * function(each + 1));
  }

  // (a) and (b) for one list.
  [[nodiscard]] std::uint64_t most_pairs_of_one(std::uint64_t tests, std::uint64_t number) const {
    const auto p = [&](std::uint64_t j) { return brought(j); };
    std::uint64_t most = 0;
    for (std::uint64_t j = 1; j <= std::min(room_, number); ++j) {
      most = std::max(most, choose_two(j) + shared(tests - 1, number - j, p));
    }
    const std::uint64_t one_by_one =
        number <= room_ ? choose_two(number) : choose_two(room_) + (number - room_) * (room_ - 1);
    return std::min(most, one_by_one);
  }

  // The same for all lists. The tested pairs are convex in the introductions of each list and of
  // each first step, so at the maximum one list has everything that the others do not require.
  [[nodiscard]] std::uint64_t most_pairs_of_all(std::uint64_t tests, std::uint64_t number) const {
    if (lists_ == 1) {
      return most_pairs_of_one(tests, number);
    }
    const auto p = [&](std::uint64_t j) { return brought(j); };
    const std::uint64_t few = q_->first;
    if (number < lists_ * few) {
      return 0;
    }
    std::uint64_t most = 0;
    for (std::uint64_t firsts = lists_ * few; firsts <= std::min(number, lists_ * room_);
         ++firsts) {
      most = std::max(most, most_at_first(firsts) + shared(tests - lists_, number - firsts, p));
    }
    const std::uint64_t of_one = number - (lists_ - 1) * few;
    const std::uint64_t one_by_one =
        (lists_ - 1) * choose_two(few) +
        (of_one <= room_ ? choose_two(of_one) : choose_two(room_) + (of_one - room_) * (room_ - 1));
    return std::min(most, one_by_one);
  }

  // The pairs of the first steps of all lists with `number` introductions in total.
  [[nodiscard]] std::uint64_t most_at_first(std::uint64_t number) const {
    const std::uint64_t few = q_->first;
    const std::uint64_t more = room_ - few;  // introductions beyond `few` that a list can have
    const std::uint64_t over = number - lists_ * few;
    const std::uint64_t full = more == 0 ? 0 : over / more;
    const std::uint64_t rest = more == 0 ? 0 : over % more;
    const std::uint64_t idle = lists_ - full - (rest > 0 ? 1 : 0);
    return full * choose_two(room_) + (rest > 0 ? choose_two(few + rest) : 0) +
           idle * choose_two(few);
  }

  // Y of (c).
  [[nodiscard]] std::uint64_t most_met_by_staying(std::uint64_t tests, std::uint64_t total) const {
    const auto h = [&](std::uint64_t j) { return j * (room_ - j); };
    std::uint64_t most = 0;
    for (std::uint64_t firsts = lists_ * q_->first; firsts <= std::min(total, lists_ * room_);
         ++firsts) {
      if (total - firsts <= room_ * (tests - lists_)) {
        most = std::max(most, shared(tests - lists_, total - firsts, h));
      }
    }
    return most;
  }

  // The fewest introductions of the most expensive parts for this many tests; false if there are
  // too few
  // tests.
  bool take_steps(std::uint64_t tests, Counts& at_least) const {
    const std::uint64_t most = room_ * tests;
    std::uint64_t number = 0;
    for (std::size_t t = 1; t <= v_; ++t) {
      number = std::max(number, at_least[t]);
      while (number <= most && most_pairs_of_one(tests, number) < pairs_[t]) {
        ++number;
      }
      if (number > most) {
        return false;
      }
      at_least[t] = number;
    }
    while (number <= most && most_pairs_of_all(tests, number) < pairs_[v_]) {
      ++number;
    }
    at_least[v_] = number;
    return number <= most;
  }

  // Searches for a cost below the best so far with this many tests; false if more tests cannot cost
  // less either.
  bool look_at(std::uint64_t tests) {
    Counts at_least = relaxed_;
    at_least[v_] = std::max(at_least[v_], least_total(tests));
    const Wide of_tests = tests_cost(tests);
    const std::uint64_t most_tests =
        pairs_[v_] + q_->starts + lists_;  // each test covers something new
    if (best_ && (tests > most_tests || is_beaten(of_tests + cost(closed(at_least))))) {
      return false;
    }
    if (!take_steps(tests, at_least)) {
      return true;
    }
    for (std::uint64_t total = at_least[v_]; total <= room_ * tests; ++total) {
      stop_if_asked();
      at_least[v_] = total;
      const Wide no_less = of_tests + cost(closed(at_least));
      if (is_beaten(no_less)) {
        break;  // more introductions cost no less
      }
      const std::uint64_t staying = most_met_by_staying(tests, total);
      Counts all = at_least;
      for (std::size_t t = 1; t <= v_; ++t) {
        const std::uint64_t lacking = degrees_[t] - std::min(degrees_[t], staying);
        all[t] = std::max(all[t], ceil_div(lacking, room_ - 1));
      }
      if (all[v_] > total) {
        continue;
      }
      const Wide found = of_tests + cost(closed(std::move(all)));
      constexpr Wide most = std::numeric_limits<std::int64_t>::max();
      if (found > most) {
        throw ImpossibleParameters("the costs are too large to be added up; use a larger unit");
      }
      if (!is_beaten(found)) {
        best_ = CostliestCost{Amount{static_cast<std::uint64_t>(found)}, tests, total};
      }
      if (found == no_less) {
        break;
      }
    }
    return true;
  }

  [[nodiscard]] bool is_beaten(Wide cost) const { return best_ && cost >= best_->cost.millionths; }

  // The smallest numbers that are at least these and allow each part its minimum and maximum.
  [[nodiscard]] Counts closed(Counts sums) const {
    for (std::size_t t = 1; t <= v_; ++t) {
      sums[t] = std::max(sums[t], sums[t - 1] + least_each_[t]);
    }
    for (std::size_t t = v_; t-- > 1;) {
      sums[t] = std::max(sums[t], sums[t + 1] - std::min(sums[t + 1], most_each_[t + 1]));
    }
    return sums;
  }

  [[nodiscard]] Wide cost(const Counts& sums) const {
    Wide sum = 0;
    for (std::size_t t = 1; t <= v_; ++t) {
      sum += Wide{price_[t] - price_[t + 1]} * sums[t];
    }
    return sum - std::min(sum, start_cost_);
  }

  [[nodiscard]] Wide tests_cost(std::uint64_t tests) const {
    return Wide{q_->test.millionths} * (tests - q_->starts);
  }

  const CostliestParts* q_;
  std::uint64_t room_;
  std::uint64_t lists_;
  std::size_t v_;
  std::vector<std::size_t> order_;
  Counts pairs_;
  Counts degrees_;
  Counts least_each_;
  Counts most_each_;
  Counts price_;
  Counts by_stays_;
  Counts relaxed_;
  std::optional<CostliestCost> best_;
  std::uint64_t start_introductions_ = 0;
  Wide start_cost_ = 0;
};

}  // namespace

std::optional<CostliestParts> costliest_parts_of(const Job& job, Amount& mounting) {
  const JobNumbers n = numbers_of(job);
  mounting = n.mounting;
  if (n.pairs == 0 || n.room < 2) {
    return std::nullopt;
  }
  const StaysCost stays = least_by_stays(job, n);
  const IntroductionCosts costs(job, n);
  CostliestParts costliest{
      .room = std::max(n.room, n.start),
      .parts = n.parts,
      .needed = &job.needed,
      .test = job.test_cost,
      .starts = n.start > 0 ? 1U : 0U,
      .least_tests = least_tests(job, n).number,
      .least_introductions = least_introductions(n, costs.once(), stays.extra).number,
      .first = 1};
  std::vector<bool> together(job.names.size(), false);
  for (const Element x : all_meeting(job, n)) {
    together[x] = true;
  }
  for (const Element x : n.parts) {
    const std::uint32_t slot = n.slot_of[x];
    const bool fills = slot < job.slots.size() && job.slots[slot].least > 0;
    costliest.prices.push_back(job.change_costs[x]);
    costliest.most.push_back(fills ? std::numeric_limits<std::uint32_t>::max() : n.degree[x]);
    costliest.at_start.push_back(n.at_start[x] ? 1U : 0U);
    costliest.together.push_back(together[x]);
    costliest.least_introductions += costliest.at_start.back();
  }
  if (n.start == 0) {
    costliest.first = std::clamp<std::uint64_t>(n.first, 1, costliest.room);
  }
  return costliest;
}

void raise_by_costliest(const Job& job, CostBound& bound) {
  Amount mounting;
  const auto question = costliest_parts_of(job, mounting);
  if (!question || question->parts.size() > most_costliest_parts) {
    return;
  }
  const CostliestCost costliest = cost_of_costliest(*question, 1);
  const Amount cost = rounded_up(job, costliest.cost + mounting);
  if (cost > bound.cost) {
    bound.cost = cost;
    bound.reason = fmt::format(
        "at least {}, at least {}, and however many are made, the most expensive parts must meet "
        "among "
        "themselves (docs/plan.md, The lower bound): {} with {} {} least",
        count_of(bound.tests, "test"), count_of(bound.introductions, "change"),
        count_of(costliest.tests, "test"), count_of(costliest.introductions, "change"),
        costliest.tests == 1 ? "costs" : "cost");
  }
}

CostliestCost cost_of_costliest(const CostliestParts& question, std::uint64_t lists) {
  return CostliestBound(question, lists).least();
}

}  // namespace changeover
