// Bounds on what a budget can pay for.
#include <algorithm>

#include "changeover/run/control.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/search/bounds/job_numbers.hpp"
#include "plan/search/weighted.hpp"

namespace changeover {
namespace {

// The most introductions for an amount of money.
class Introductions {
 public:
  Introductions(const Job& job, const std::vector<bool>& mounted) {
    std::vector<std::uint64_t> degree(job.names.size(), 0);
    job.needed.for_each(all_of_them, [&](Element x, Element y) {
      ++degree[x];
      ++degree[y];
    });
    std::vector<Element> parts;
    for (Element x = 0; x < job.parts(); ++x) {
      const bool fills =
          !job.slot_of.empty() && job.slot_of[x] != no_slot && job.slots[job.slot_of[x]].least > 0;
      if (!mounted[x] && fills && degree[x] > 0) {
        degree[x] = unlimited;
      }
      if (!mounted[x] && degree[x] > 0) {
        parts.push_back(x);
      }
    }
    std::sort(parts.begin(), parts.end(),
              [&](Element x, Element y) { return job.change_costs[x] < job.change_costs[y]; });
    for (const Element x : parts) {
      rows_.push_back({job.change_costs[x].millionths, degree[x]});
    }
  }

  [[nodiscard]] std::uint64_t operator()(std::uint64_t money, std::uint64_t most) const {
    std::uint64_t number = 0;
    for (const auto& [price, times] : rows_) {
      const std::uint64_t affordable = price == 0 ? times : std::min(times, money / price);
      number += affordable;
      money -= affordable * price;
      if (number >= most || affordable < times) {
        break;
      }
    }
    return std::min(number, most);
  }

 private:
  static constexpr std::uint64_t unlimited = std::uint64_t{1} << 40U;
  struct Row {
    std::uint64_t price = 0;
    std::uint64_t times = 0;
  };
  std::vector<Row> rows_;  // cheapest first
};

// An upper bound on the number of pairs: if the introductions of each step are put in an order,
// each part meets at most the parts that are mounted before it.
std::uint64_t most_one_by_one(std::uint64_t room, std::uint64_t at_start,
                              std::uint64_t introductions) {
  std::uint64_t pairs = choose_two(at_start);
  const std::uint64_t few = std::min(introductions, room - std::min(room, at_start + 1));
  pairs += few * at_start + choose_two(few);
  return pairs + (introductions - few) * (room - 1);
}

std::vector<bool> mounted_parts(const Job& job) {
  std::vector<bool> mounted(job.names.size(), false);
  for (const Element m : job.mounted) {
    mounted[m] = true;
  }
  return mounted;
}

}  // namespace

std::uint64_t most_pairs_within(const Job& job, Amount budget) {
  const std::vector<bool> mounted = mounted_parts(job);
  std::uint64_t pairs = 0;
  job.needed.for_each(all_of_them,
                      [&](Element x, Element y) { pairs += !mounted[x] && !mounted[y] ? 1U : 0U; });
  std::vector<bool> there(job.names.size(), false);
  std::uint64_t at_start = 0;
  for (const Element x : job.start) {
    there[x] = true;
    at_start += mounted[x] ? 0U : 1U;
  }
  std::uint64_t money = budget.millionths;
  for (const Element m : job.mounted) {
    const std::uint64_t price = there[m] ? 0 : job.change_costs[m].millionths;
    if (price > money) {
      return 0;
    }
    money -= price;
  }
  const Introductions affordable(job, mounted);
  JobNumbers n;
  n.room = job.room() - job.mounted.size();
  n.start = at_start;
  n.start_pairs = all_of_them;
  const std::uint64_t test = job.test_cost.millionths;
  std::uint64_t most = 0;
  for (std::uint64_t t = 1; t <= pairs && (test == 0 || t <= money / test); ++t) {
    stop_if_asked();
    const std::uint64_t introductions = affordable(money - t * test, n.room * t);
    if (t > introductions + 1) {
      break;  // some step would introduce nothing
    }
    most = std::max(most, std::min(most_pairs(n, t, introductions),
                                   most_one_by_one(n.room, at_start, introductions)));
    if (most >= pairs) {
      return pairs;
    }
  }
  return most;
}

Amount most_weight_within(const Job& job, Amount budget) {
  const std::vector<bool> mounted = mounted_parts(job);
  std::vector<std::uint64_t> weights;
  Amount most;
  job.needed.for_each(all_of_them, [&](Element x, Element y) {
    if (mounted[x] || mounted[y]) {
      most += job.weights(x, y);
    } else {
      weights.push_back(job.weights(x, y).millionths);
    }
  });
  std::sort(weights.begin(), weights.end(), std::greater<>());
  const std::uint64_t number = [&]() -> std::uint64_t {
    try {
      return most_pairs_within(job, budget);
    } catch (const Stopped&) {
      return weights.size();
    }
  }();
  for (std::uint64_t i = 0; i < std::min<std::uint64_t>(number, weights.size()); ++i) {
    most += Amount{weights[static_cast<std::size_t>(i)]};
  }
  return most;
}

}  // namespace changeover
