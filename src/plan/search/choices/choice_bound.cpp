#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "changeover/plan/model.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/search/bounds/least_numbers.hpp"
#include "plan/search/choices/choice_plan.hpp"
#include "plan/search/choices/equal_values.hpp"
#include "plan/search/choices/tests_apart.hpp"
#include "plan/search/choices/transport.hpp"

namespace changeover {
namespace {

// The numbers of the proof.
struct ChoiceNumbers {
  std::size_t slots = 0;
  std::vector<bool> negative;  // by part
  std::vector<std::vector<std::uint64_t>>
      partners;                                   // by part and parameter: number of needed pairs
  std::vector<std::vector<std::uint64_t>> pairs;  // by two parameters: number of needed pairs
  std::vector<std::vector<std::uint64_t>> in_range;  // likewise, for pairs in R

  explicit ChoiceNumbers(const Job& job)
      : slots(job.slots.size()),
        partners(job.names.size(), std::vector<std::uint64_t>(slots, 0)),
        pairs(slots, std::vector<std::uint64_t>(slots, 0)),
        in_range(pairs) {
    for (Element x = 0; x < job.parts(); ++x) {
      negative.push_back(job.model->value(x).negative);
    }
    job.needed.for_each(all_of_them, [&](Element x, Element y) {
      const std::uint32_t p = job.slot_of[x];
      const std::uint32_t q = job.slot_of[y];
      const bool inside = !negative[x] && !negative[y];
      ++pairs[p][q];
      ++pairs[q][p];
      in_range[p][q] += inside ? 1U : 0U;
      in_range[q][p] += inside ? 1U : 0U;
      partners[x][q] += inside || negative[x] ? 1U : 0U;
      partners[y][p] += inside || negative[y] ? 1U : 0U;
    });
  }
};

// C(n, k), or the largest number.
std::uint64_t choose(std::uint64_t n, std::uint64_t k) {
  Wide value = 1;
  for (std::uint64_t i = 1; i <= k; ++i) {
    value = value * (n - k + i) / i;
    if (value > std::numeric_limits<std::uint32_t>::max()) {
      return std::numeric_limits<std::uint64_t>::max();
    }
  }
  return static_cast<std::uint64_t>(value);
}

// (2): whether a parameter is one of those with so many values each, all of which must meet.
std::vector<bool> clique_of_equal(const Job& job, const ChoiceNumbers& n, std::size_t values) {
  std::vector<bool> clique(n.slots, false);
  std::vector<std::vector<Element>> chosen;
  for (std::size_t p = 0; p < n.slots; ++p) {
    std::vector<Element> own;
    for (Element x = 0; x < job.parts() && own.size() < values; ++x) {
      const bool fits = job.slot_of[x] == p && !n.negative[x] &&
                        std::ranges::all_of(chosen, [&](const std::vector<Element>& others) {
                          return std::ranges::all_of(
                              others, [&](Element y) { return job.needed.contains(x, y); });
                        });
      if (fits) {
        own.push_back(x);
      }
    }
    if (own.size() == values) {
      chosen.push_back(std::move(own));
      clique[p] = true;
    }
  }
  return clique;
}

std::uint64_t number_in(const std::vector<bool>& clique) {
  return static_cast<std::uint64_t>(std::ranges::count(clique, true));
}

LeastNumber least_choice_tests(const Job& job, const ChoiceNumbers& n) {
  LeastNumber least;
  for (std::size_t p = 0; p < n.slots; ++p) {
    for (std::size_t q = 0; q < p; ++q) {
      least.at_least(n.in_range[p][q], fmt::format("each of the {} of {} and {} is in another test",
                                                   count_of(n.in_range[p][q], "pair"),
                                                   job.slots[q].name, job.slots[p].name));
    }
  }
  std::vector<std::uint64_t> by_slot(n.slots, 0);
  std::uint64_t hidden = 0;
  for (Element x = 0; x < job.parts(); ++x) {
    const std::uint64_t most = *std::ranges::max_element(n.partners[x]);
    (n.negative[x] ? hidden : by_slot[job.slot_of[x]]) += most;
  }
  for (std::size_t p = 0; p < n.slots; ++p) {
    least.at_least(by_slot[p],
                   fmt::format("the values of {} are in at least {} in all, one in each",
                               job.slots[p].name, count_of(by_slot[p], "test")));
  }
  std::map<std::array<std::uint32_t, 3>, std::uint64_t>
      triples;  // needed ones in range, by their parameters
  for (const Triple& t : job.triples) {
    triples[{job.slot_of[t[0]], job.slot_of[t[1]], job.slot_of[t[2]]}] +=
        n.negative[t[0]] || n.negative[t[1]] || n.negative[t[2]] ? 0U : 1U;
  }
  for (const auto& [slots, number] : triples) {
    least.at_least(number, fmt::format("each of the {} of {}, {} and {} is in another test",
                                       count_of(number, "triple"), job.slots[slots[0]].name,
                                       job.slots[slots[1]].name, job.slots[slots[2]].name));
  }
  const std::uint64_t k = number_in(clique_of_equal(job, n, 2));
  if (k >= 2) {
    std::uint64_t tests = 4;
    while (choose(tests - 1, tests / 2 - 1) < k) {
      ++tests;
    }
    least.at_least(tests, fmt::format("{} of two values and more need so many [Katona1973]",
                                      count_of(k, "parameter")));
  }
  constexpr std::uint64_t most_values = 40;
  for (std::uint64_t g = 3; g <= most_values; ++g) {
    const std::uint64_t equal = number_in(clique_of_equal(job, n, g));
    if (equal < g) {
      break;
    }
    least.at_least(least_tests_of_equal(equal, g),
                   fmt::format("in fewer, {} of {} values and more would have too few tests that "
                               "differ (docs/theorems.md, Theorem 21)",
                               count_of(equal, "parameter"), g));
  }
  for (const FewestTests& each : published_fewest_tests()) {
    if (number_in(clique_of_equal(job, n, each.values)) >= each.parameters) {
      least.at_least(each.tests,
                     fmt::format("{} of {} values and more need so many [IzquierdoTorres2018]",
                                 count_of(each.parameters, "parameter"), each.values));
    }
  }
  if (hidden > 0) {
    least.why += fmt::format("{}{} more with a value that is out of range",
                             least.why.empty() ? "" : ", and ", hidden);
    least.number += hidden;
  }
  if (!job.model->constraints.empty() || job.never.size() > 0) {
    const std::uint64_t apart = tuples_for_tests_apart(job).size();
    least.at_least(apart, fmt::format("no two of {} fit in one test",
                                      count_of(apart, job.triples.empty() ? "pair" : "triple")));
  }
  return least;
}

struct LeastChanges {
  std::uint64_t number = 0;
  Amount cost;        ///< of changes
  Amount with_tests;  ///< of tests and changes together
};

// (6): the stays of a parameter with two or three values, except for a few parameters.
constexpr std::uint64_t stays_of_two = 5;
constexpr std::uint64_t stays_of_three = 8;

// (5): what the parameters of a clique may save together if each but `exceptions` of them, one or
// two, has `often` stays, and what those have fewer only two can have.
Wide most_saved(const std::vector<bool>& clique, const std::vector<std::uint64_t>& there,
                const std::vector<std::uint64_t>& prices, std::uint64_t often,
                std::uint64_t exceptions) {
  Wide unit = 0;  // once more, each of them
  for (std::size_t p = 0; p < clique.size(); ++p) {
    unit += clique[p] ? prices[p] : 0;
  }
  Wide by_one = 0;
  std::array<Wide, 2> once{};  // by one less each
  for (std::size_t p = 0; p < clique.size(); ++p) {
    if (!clique[p] || there[p] >= often) {
      continue;
    }
    const bool others_cost_more = unit - prices[p] >= prices[p];
    const std::uint64_t fewer = often - there[p];
    by_one = std::max(by_one,
                      Wide{prices[p]} * (others_cost_more ? std::min(exceptions, fewer) : fewer));
    if (prices[p] > once[1]) {
      once[1] = prices[p];
      std::ranges::sort(once, std::greater<>());
    }
  }
  return std::max(by_one, exceptions == 2 ? once[0] + once[1] : once[0]);
}

// (4) and (5): the least cost of the changes beyond `there`, the changes of each parameter that are
// counted already. Two parameters change `wanted` times together, if that is not 0. `threes`:
// parameters with three values that all meet.
std::uint64_t least_more(const std::vector<std::vector<std::uint64_t>>& wanted,
                         const std::vector<std::uint64_t>& there,
                         const std::vector<std::uint64_t>& prices,
                         const std::vector<bool>& threes) {
  const std::size_t slots = there.size();
  std::vector<bool> is_in(slots, true);  // what is left for (4)
  const auto by_two = [&](const std::vector<bool>& among) {
    std::vector<std::vector<std::uint64_t>> more(slots, std::vector<std::uint64_t>(slots, 0));
    for (std::size_t p = 0; p < slots; ++p) {
      for (std::size_t q = 0; q < slots; ++q) {
        const std::uint64_t both = there[p] + there[q];
        more[p][q] = among[p] && among[q] ? wanted[p][q] - std::min(wanted[p][q], both) : 0;
      }
    }
    return ceil_div(most_profit(more, prices), 2);
  };
  Wide by_cliques = 0;
  const auto take = [&](const std::vector<bool>& clique, std::uint64_t often,
                        std::uint64_t exceptions) {
    Wide all = 0;
    for (std::size_t p = 0; p < slots; ++p) {
      all += clique[p] ? Wide{prices[p]} * (often - there[p]) : 0;
    }
    const Wide saved = most_saved(clique, there, prices, often, exceptions);
    if (all > saved && all - saved > by_two(clique)) {
      by_cliques += all - saved;
      for (std::size_t p = 0; p < slots; ++p) {
        is_in[p] = is_in[p] && !clique[p];
      }
    }
  };
  std::set<std::uint64_t> times;
  for (const std::vector<std::uint64_t>& row : wanted) {
    times.insert(row.begin(), row.end());
  }
  constexpr std::uint64_t of_three = 6;
  bool has_threes = std::ranges::count(threes, true) > 2;
  std::size_t looks = 16;
  for (auto each = times.rbegin(); each != times.rend() && *each > 2 && looks > 0;
       ++each, --looks) {
    const std::uint64_t often = (*each + 1) / 2;  // all but one change as often
    if (has_threes && often < of_three) {
      has_threes = false;
      std::vector<bool> clique(slots, false);
      for (std::size_t p = 0; p < slots; ++p) {
        clique[p] = is_in[p] && threes[p] && there[p] <= of_three;
      }
      take(clique, of_three, 2);
    }
    std::vector<bool> clique(slots, false);
    for (std::size_t p = 0; p < slots; ++p) {
      bool fits =
          is_in[p] && there[p] <= often && *std::ranges::max_element(wanted[p]) >= 2 * often - 1;
      for (std::size_t q = 0; q < p && fits; ++q) {
        fits = !clique[q] || wanted[p][q] >= 2 * often - 1;
      }
      clique[p] = fits;
    }
    take(clique, often, 1);
  }
  const std::vector<bool> any(slots, true);
  constexpr Wide most = std::numeric_limits<std::int64_t>::max();
  return static_cast<std::uint64_t>(
      std::min(most, std::max(Wide{by_two(any)}, by_cliques + by_two(is_in))));
}

// Parameters that each have so many stays, but for few: what these save.
class OftenSet {
 public:
  OftenSet(const std::vector<bool>& which, const std::vector<std::uint64_t>& there,
           const std::vector<std::uint64_t>& prices, std::uint64_t stays) {
    for (std::size_t p = 0; p < which.size(); ++p) {
      if (which[p]) {
        costliest_.push_back(prices[p]);
        changes_ += Amount{prices[p]} * (stays - there[p]);
      }
    }
    std::ranges::sort(costliest_, std::greater<>());
  }

  [[nodiscard]] std::uint64_t number() const { return costliest_.size(); }
  [[nodiscard]] Amount of_costliest(std::uint64_t number) const {
    Amount sum;
    for (std::uint64_t i = 0; i < std::min<std::uint64_t>(number, costliest_.size()); ++i) {
      sum += Amount{costliest_[i]};
    }
    return sum;
  }
  [[nodiscard]] Amount changes_but(Amount saved) const {
    return changes_ - std::min(changes_, saved);
  }

 private:
  std::vector<std::uint64_t> costliest_;
  Amount changes_;
};

// (6): how many parameters with three values can have so few stays, by Theorem 27.
struct FewStays {
  std::uint64_t stays = 0;
  std::span<const std::uint64_t> looked_through;  // by tests, from 9 on: so many are possible
};

constexpr std::uint64_t least_for_threes = 9;
constexpr std::array<std::uint64_t, 9> with_six_stays{2, 3, 3, 3, 4, 4, 4, 5, 5};
constexpr std::array<std::uint64_t, 5> with_seven_stays{4, 4, 4, 5, 5};
constexpr FewStays six_stays{6, with_six_stays};
constexpr FewStays seven_stays{7, with_seven_stays};

// In so many tests; any number from `enough` on if there can be as many.
std::uint64_t most_of(const FewStays& few, std::uint64_t tests, std::uint64_t enough) {
  const std::uint64_t last = least_for_threes + few.looked_through.size() - 1;
  std::uint64_t most =
      few.looked_through[std::clamp(tests, least_for_threes, last) - least_for_threes];
  const std::uint64_t changes = few.stays - 1;
  for (std::uint64_t n = last + 1; n <= tests && most < enough; ++n) {
    const std::uint64_t before = most;
    while (most < enough && (most + 1 - before) * (n - 1) <= changes * (most + 1)) {
      ++most;
    }
  }
  return most;
}

// (7): parameters with g ≥ 4 values each.
class EqualSet {
 public:
  // `at_least`: what (4) and (5) say of them, beyond one stay for each value.
  EqualSet(std::uint64_t parameters, std::uint64_t values, Amount price, Amount at_least)
      : parameters_(parameters), values_(values), price_(price), at_least_(at_least) {}

  // In so many tests; called for one number after the other. Nothing if these are too few.
  [[nodiscard]] std::optional<Amount> beyond(std::uint64_t tests) {
    stays_ = least_stays_of_equal(parameters_, values_, tests, stays_);
    if (!stays_) {
      return std::nullopt;
    }
    const std::uint64_t once = parameters_ * values_;
    return std::max(at_least_, price_ * (*stays_ - std::min(*stays_, once)));
  }
  // In any number of tests.
  [[nodiscard]] Amount at_least() const { return at_least_; }

 private:
  std::uint64_t parameters_;
  std::uint64_t values_;
  Amount price_;
  Amount at_least_;
  std::optional<std::uint64_t> stays_;
};

// (6) and (7): what tests and the changes of these parameters cost at least, beyond `there`.
Amount of_few_values(const Job& job, const OftenSet& twos, const OftenSet& threes,
                     std::vector<EqualSet> others, std::uint64_t least_tests) {
  std::optional<Amount> least;
  Amount in_any;  // of the others, in however many tests
  for (const EqualSet& each : others) {
    in_any += each.at_least();
  }
  constexpr std::uint64_t most_looks = 2000;
  std::uint64_t looks = 0;
  for (std::uint64_t tests = std::max<std::uint64_t>(4, least_tests);; ++tests, ++looks) {
    const std::uint64_t all = tests + (job.start.empty() ? 0 : 1);
    const std::uint64_t three = 1 + (all - 1) / 2;  // they and one with two stays
    const std::uint64_t four = three + (all - 2) * (all - 2) / 4;
    const std::uint64_t six = most_of(six_stays, all, threes.number());
    const std::uint64_t seven = most_of(seven_stays, all, threes.number());
    const Amount by_twos =
        twos.of_costliest(1) + twos.of_costliest(three) + twos.of_costliest(four);
    const Amount by_threes =
        threes.of_costliest(seven) +
        std::max(threes.of_costliest(six) + threes.of_costliest(1) * 2, threes.of_costliest(1) * 4);
    const Amount few =
        job.test_cost * tests + twos.changes_but(by_twos) + threes.changes_but(by_threes);
    const bool is_last = three >= twos.number() && six >= threes.number();
    if (is_last && (others.empty() || looks >= most_looks || (least && few + in_any >= *least))) {
      return least ? std::min(*least, few + in_any) : few + in_any;  // more tests cost no less
    }
    std::optional<Amount> cost = few;
    for (EqualSet& each : others) {
      const std::optional<Amount> more = each.beyond(all);
      cost = cost && more ? std::optional(*cost + *more) : std::nullopt;
    }
    if (cost) {
      least = least ? std::min(*least, *cost) : *cost;
    }
  }
}

LeastChanges least_choice_changes(const Job& job, const ChoiceNumbers& n,
                                  std::uint64_t least_tests) {
  std::vector<std::uint64_t> once(n.slots, 0);  // required introductions
  std::vector<std::uint64_t> at_start(n.slots, 0);
  std::vector<std::uint64_t> lowest(n.slots, std::numeric_limits<std::uint64_t>::max());
  std::vector<Amount> costs_once(n.slots);
  std::vector<bool> is_at_start(job.names.size(), false);
  for (const Element x : job.start) {
    is_at_start[x] = true;
    at_start[job.slot_of[x]] = 1;
  }
  for (Element x = 0; x < job.parts(); ++x) {
    const std::uint32_t p = job.slot_of[x];
    lowest[p] = std::min(lowest[p], job.change_costs[x].millionths);
    const bool needed =
        std::ranges::any_of(n.partners[x], [](std::uint64_t each) { return each > 0; }) ||
        std::ranges::find(job.mounted, x) != job.mounted.end();
    if (needed && !is_at_start[x]) {
      ++once[p];
      costs_once[p] += job.change_costs[x];
    }
  }
  LeastChanges least;
  for (std::size_t p = 0; p < n.slots; ++p) {
    if (once[p] == 0 && at_start[p] == 0) {  // some value must be set
      once[p] = 1;
      costs_once[p] = Amount{lowest[p]};
    }
    least.number += once[p];
    least.cost += costs_once[p];
  }
  std::vector<std::vector<std::uint64_t>> wanted(n.slots, std::vector<std::uint64_t>(n.slots, 0));
  std::vector<std::uint64_t> there(n.slots, 0);
  for (std::size_t p = 0; p < n.slots; ++p) {
    there[p] = once[p] + at_start[p];
    for (std::size_t q = 0; q < n.slots; ++q) {
      wanted[p][q] = p == q || n.pairs[p][q] == 0 ? 0 : n.pairs[p][q] + 1;
    }
  }
  const std::vector<std::uint64_t> ones(n.slots, 1);
  const std::vector<bool> threes = clique_of_equal(job, n, 3);
  least.number += least_more(wanted, there, ones, threes);
  const Amount once_each = least.cost;
  least.cost += Amount{least_more(wanted, there, lowest, threes)};
  least.with_tests = job.test_cost * least_tests + least.cost;
  const auto clique_of = [&](std::size_t values, std::uint64_t least_number) {
    std::vector<bool> clique = clique_of_equal(job, n, values);
    for (std::size_t p = 0; p < n.slots; ++p) {
      clique[p] = clique[p] && there[p] == values;
    }
    return number_in(clique) < least_number ? std::vector<bool>(n.slots, false) : clique;
  };
  const std::vector<bool> twos = clique_of(2, 2);
  const std::vector<bool> just_threes = clique_of(3, 3);
  // What (4) and (5) say of the others. Those that are counted elsewhere are in none of their sets.
  const auto more_without = [&](const std::vector<bool>& counted) {
    std::vector<std::vector<std::uint64_t>> others = wanted;
    std::vector<bool> other_threes(n.slots);
    for (std::size_t p = 0; p < n.slots; ++p) {
      other_threes[p] = threes[p] && !counted[p];
      for (std::size_t q = 0; q < n.slots; ++q) {
        others[p][q] = counted[p] || counted[q] ? 0 : wanted[p][q];
      }
    }
    return Amount{least_more(others, there, lowest, other_threes)};
  };
  const auto with_few = [&](const std::vector<bool>& counted, std::vector<EqualSet> others) {
    return once_each + more_without(counted) +
           of_few_values(job, OftenSet(twos, there, lowest, stays_of_two),
                         OftenSet(just_threes, there, lowest, stays_of_three), std::move(others),
                         least_tests);
  };
  std::vector<bool> counted(n.slots, false);
  for (std::size_t p = 0; p < n.slots; ++p) {
    counted[p] = twos[p] || just_threes[p];
  }
  if (number_in(counted) > 0) {
    least.with_tests = std::max(least.with_tests, with_few(counted, {}));
  }
  std::vector<EqualSet> others;
  constexpr std::uint64_t most_values = 40;
  for (const std::uint64_t values : std::set<std::uint64_t>(there.begin(), there.end())) {
    if (values < 4 || values > most_values || job.test_cost == Amount{}) {
      continue;
    }
    const std::vector<bool> equal = clique_of(values, 3);
    std::vector<bool> not_equal(n.slots, true);
    std::uint64_t price = std::numeric_limits<std::uint64_t>::max();
    for (std::size_t p = 0; p < n.slots; ++p) {
      not_equal[p] = !equal[p];
      counted[p] = counted[p] || equal[p];
      price = equal[p] ? std::min(price, lowest[p]) : price;
    }
    if (number_in(equal) > 0) {
      others.emplace_back(number_in(equal), values, Amount{price}, more_without(not_equal));
    }
  }
  if (!others.empty()) {
    least.with_tests = std::max(least.with_tests, with_few(counted, std::move(others)));
  }
  return least;
}

}  // namespace

void improve_choice_bound(const Job& job, CostBound& bound, std::string& known) {
  if (job.needed.size() == 0) {
    return;
  }
  const ChoiceNumbers n(job);
  const LeastNumber tests = least_choice_tests(job, n);
  const LeastChanges changes = least_choice_changes(job, n, std::max(tests.number, bound.tests));
  const Amount cost = rounded_up(job, changes.with_tests);
  if (tests.number >= bound.tests || cost >= bound.cost) {
    const std::uint64_t least = std::max(changes.number, bound.introductions);
    known = fmt::format(
        "at least {} ({}), at least {} (each new pair of two parameters takes a change of one of "
        "them, and this is counted over all parameters)",
        count_of(std::max(tests.number, bound.tests), "test"),
        tests.number >= bound.tests ? tests.why : "by their pairs", count_of(least, "change"));
    bound.reason = known;
  }
  bound.tests = std::max(bound.tests, tests.number);
  bound.introductions = std::max(bound.introductions, changes.number);
  bound.cost = std::max(bound.cost, cost);
}

}  // namespace changeover
