#include "changeover/plan/run_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "plan/job/check_in_full.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/job/prices.hpp"
#include "plan/search/bounds/costliest_parts.hpp"
#include "plan/search/bounds/exchange_bound.hpp"
#include "plan/search/bounds/job_numbers.hpp"
#include "plan/search/bounds/least_numbers.hpp"
#include "plan/search/bounds/step_bound.hpp"
#include "plan/search/choices/choice_plan.hpp"
#include "plan/search/first_plan.hpp"
#include "plan/search/triple_plan.hpp"
#include "plan/search/valid_job.hpp"

namespace changeover {
namespace {

// (6): the least that the introductions must cost so that all parts meet whom they must.
class DegreeCosts {
 public:
  DegreeCosts(const Job& job, const JobNumbers& n) : numbers_(&n) {
    const std::uint64_t each = n.room - 1;
    for (const Element x : n.parts) {
      std::uint64_t left = n.inner[x];
      if (!n.at_start[x]) {
        base_ += job.change_costs[x];
        left -= std::min(left, each);
      }
      lacking_ += left;
      if (left >= each) {
        offers_.push_back({job.change_costs[x], each, left / each});
      }
      if (left % each != 0) {
        offers_.push_back({job.change_costs[x], left % each, 1});
      }
    }
    std::stable_sort(offers_.begin(), offers_.end(), [](const Offer& a, const Offer& b) {
      return static_cast<double>(a.cost.millionths) * static_cast<double>(b.gain) <
             static_cast<double>(b.cost.millionths) * static_cast<double>(a.gain);
    });
  }

  [[nodiscard]] Amount operator()(std::uint64_t tests, std::uint64_t introductions) const {
    const std::uint64_t met = most_met_by_staying(tests, introductions);
    std::uint64_t left = lacking_ - std::min(lacking_, met);
    Amount cost = base_;
    for (const Offer& offer : offers_) {
      const std::uint64_t whole = std::min(offer.times, left / offer.gain);
      cost += offer.cost * whole;
      left -= whole * offer.gain;
      if (whole < offer.times) {  // left < gain: a fraction of one introduction, rounded down
        cost += Amount{static_cast<std::uint64_t>(Wide{offer.cost.millionths} * left / offer.gain)};
        break;
      }
    }
    return cost;
  }

 private:
  struct Offer {
    Amount cost;
    std::uint64_t gain = 0;   // of one introduction
    std::uint64_t times = 0;  // number of such introductions
  };

  // Y of the proof.
  [[nodiscard]] std::uint64_t most_met_by_staying(std::uint64_t tests,
                                                  std::uint64_t introductions) const {
    const JobNumbers& n = *numbers_;
    const auto met = [&](std::uint64_t j) { return j * (n.room - j); };
    std::uint64_t most = 0;
    for (std::uint64_t j = 0; j <= std::min(n.room, introductions); ++j) {
      const std::uint64_t rest = introductions - j;
      if (rest > n.room * (tests - 1)) {
        continue;
      }
      const std::uint64_t kept = std::min(n.start, n.room - j);
      std::uint64_t sum = j * kept + 2 * std::min(choose_two(kept), n.start_pairs);
      if (tests > 1) {
        const std::uint64_t each = rest / (tests - 1);
        const std::uint64_t more = rest % (tests - 1);
        sum += (tests - 1 - more) * met(each) + (more == 0 ? 0 : more * met(each + 1));
      }
      most = std::max(most, sum);
    }
    return most;
  }

  const JobNumbers* numbers_;
  Amount base_;
  std::uint64_t lacking_ = 0;
  std::vector<Offer> offers_;
};

// JobNumbers of tests and of introductions of parts of F that cost least.
struct Cheapest {
  Amount cost;
  std::uint64_t tests = 0;
  std::uint64_t introductions = 0;
};

// The minimum over all numbers that (1) to (4) allow; `seven` is (7). @throws Stopped
Cheapest cheapest_numbers(const Job& job, const JobNumbers& n, const IntroductionCosts& costs,
                          Amount seven, std::uint64_t least_tests,
                          std::uint64_t least_introductions) {
  std::optional<DegreeCosts> degrees;
  constexpr std::uint64_t most_parts = 150;
  if (n.room >= 2 && n.parts.size() <= most_parts) {
    degrees.emplace(job, n);
  }
  std::optional<Cheapest> best;
  std::optional<std::uint64_t>
      counted;  // I(t) of the last t that can cover all; it does not increase
  for (std::uint64_t t = least_tests;; ++t) {
    stop_if_asked();
    const std::uint64_t most = n.room * t;
    if (most_pairs(n, t, most) < n.pairs) {
      continue;
    }
    counted = counted.value_or(most);
    while (*counted > 0 && most_pairs(n, t, *counted - 1) >= n.pairs) {
      stop_if_asked();
      --*counted;
    }
    std::uint64_t i = std::max({*counted, least_introductions, t - 1 + n.first});
    const bool at_steps = t - 1 + n.first >= std::max(*counted, least_introductions);
    bool too_costly = false;  // with the fewest introductions, and so with more tests, too
    bool first = true;
    for (; i <= most; ++i) {
      stop_if_asked();
      const auto five = costs(i);
      if (!five ||
          (best && job.test_cost * t + std::max(*five, seven) + n.mounting >= best->cost)) {
        too_costly = first;
        break;  // more introductions cost no less
      }
      first = false;
      const Amount six = degrees ? (*degrees)(t, i) : Amount{};
      const Amount total = job.test_cost * t + std::max({*five, six, seven}) + n.mounting;
      if (!best || total < best->cost) {
        best = Cheapest{total, t, i};
      }
      if (six <= std::max(*five, seven)) {
        break;
      }
    }
    // More tests help only as long as some relevant step has two changes.
    const bool cannot_help = best && job.test_cost * (t + 1) + n.mounting >= best->cost;
    if (cannot_help || (best && at_steps && too_costly) ||
        (best && !degrees && *counted <= least_introductions)) {
      break;
    }
  }
  return best.value_or(Cheapest{job.test_cost * least_tests, 0, 0});
}

}  // namespace

CostBound cost_bound(const Job& job) {
  check_in_full(job);
  CostBound bound = bound_of_valid_job(job);
  raise_numbers(job, bound);
  return bound;
}

void raise_numbers(const Job& job, CostBound& bound) {
  if (job.replaces() || job.change_costs.empty()) {
    return;
  }
  const Amount costliest = *std::ranges::max_element(job.change_costs);
  const auto raise = [&](std::uint64_t& number, Amount each, std::string_view what) {
    const std::uint64_t least = ceil_div(bound.cost.millionths, each.millionths);
    if (least > number) {
      number = least;
      bound.reason += fmt::format("; a {} costs {} at most and nothing else costs anything, so {}",
                                  what, to_string(each), count_of(least, what));
    }
  };
  if (job.test_cost.millionths == 0 && costliest.millionths > 0) {
    raise(bound.introductions, costliest, "change");
  }
  if (costliest.millionths == 0 && job.test_cost.millionths > 0) {
    raise(bound.tests, job.test_cost, "test");
  }
}

namespace {

CostBound bound_of_pairs(const Job& job, std::string& least);

}  // namespace

CostBound bound_of_valid_job(const Job& job) {
  if (!job.first.empty()) {
    return bound_with_first(job);
  }
  if (job.replaces()) {
    CostBound bound = bound_of_valid_job(at_prices(job, Price::least));
    bound.cost = rounded_up(job, bound.cost);
    bound.reason =
        fmt::format("each {} costs at least what it costs where it is cheapest to {}: {}",
                    job.model == nullptr ? "part" : "value",
                    job.model == nullptr ? "put in" : "set", bound.reason);
    if (job.triples.empty() && job.needed.size() > 0) {
      try {
        raise_by_exchanges(job, bound);
      } catch (const Stopped&) {
        // What is known is true.
      }
    }
    return bound;
  }
  std::string least;  // tests and changes, with reasons
  CostBound bound = job.triples.empty() ? bound_of_pairs(job, least) : bound_for_triples(job);
  if (job.model != nullptr) {
    try {
      improve_choice_bound(job, bound, least);
    } catch (const Stopped&) {
      // the bound so far is valid
    }
  }
  if (job.triples.empty() && job.needed.size() > 0) {
    try {
      raise_by_steps(job, least, bound);
    } catch (const Stopped&) {
      // the bound so far is valid
    }
  }
  return bound;
}

namespace {

CostBound bound_of_pairs(const Job& job, std::string& least) {
  const JobNumbers n = numbers_of(job);
  CostBound bound;
  if (job.needed.size() == 0) {
    bound.reason = "nothing is left to test";
    return bound;
  }
  const IntroductionCosts costs(job, n);
  const LeastNumber tests = least_tests(job, n);
  const StaysCost stays = least_by_stays(job, n);
  const LeastNumber introductions = least_introductions(n, costs.once(), stays.extra);

  Cheapest cheapest;
  bound.tests = tests.number;
  bound.introductions = introductions.number + n.mounted_introductions;
  least = fmt::format("at least {} ({}), at least {} ({})", count_of(tests.number, "test"),
                      tests.why, count_of(bound.introductions, "change"), introductions.why);
  try {
    cheapest = cheapest_numbers(job, n, costs, stays.cost, tests.number, introductions.number);
  } catch (const Stopped&) {
    bound.cost = job.test_cost * tests.number +
                 std::max(costs(introductions.number).value_or(Amount{}), stays.cost) + n.mounting;
    bound.reason = least;
    return bound;
  }
  bound.cost = rounded_up(job, cheapest.cost);
  bound.reason = fmt::format(
      "{}, and j changes of {} bring at most C(j,2) + j({}-j) new pairs: {} with {} {} least",
      least, n.room, n.room, count_of(cheapest.tests, "test"),
      count_of(cheapest.introductions + n.mounted_introductions, "change"),
      cheapest.tests == 1 ? "costs" : "cost");
  try {
    raise_by_costliest(job, bound);
  } catch (const Stopped&) {
    // the bound so far is valid
  }
  return bound;
}

}  // namespace

}  // namespace changeover
