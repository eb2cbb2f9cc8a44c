#include "plan/search/benches/cut_list.hpp"

#include <algorithm>
#include <iterator>

#include "changeover/plan/run_plan.hpp"
#include "plan/sheet/replacement.hpp"

namespace changeover {
namespace {

// What a set-up costs as the first of a list; sheets take the time of all pairs of parts.
Amount cost_anew(const Job& job, const Block& start, const Block& setup) {
  Block out;
  Block in;
  std::ranges::set_difference(start, setup, std::back_inserter(out));
  std::ranges::set_difference(setup, start, std::back_inserter(in));
  if (job.replaces()) {
    return job.test_cost + cheapest_replacement(job, out, in).cost;
  }
  Amount cost = job.test_cost;
  for (const Element x : in) {
    cost += job.change_costs[x];
  }
  return cost;
}

}  // namespace

BenchLists cut_list(const Job& job, const std::vector<Block>& setups, std::size_t benches) {
  std::vector<std::uint64_t> going_on;  // by set-up: what it costs after the one before
  std::vector<std::uint64_t> anew;      // and at the beginning of a list
  std::uint64_t most = 0;
  Block start = job.start;
  std::ranges::sort(start);
  for (const RunStep& step : run_sheet(job, setups).steps) {
    anew.push_back(cost_anew(job, start, step.setup).millionths);
    going_on.push_back(step.cost.millionths);
    most += going_on.back();
  }
  // Where pieces begin if none costs more than the limit.
  const auto pieces = [&](std::uint64_t limit) {
    std::vector<std::size_t> begins;
    std::uint64_t cost = 0;
    for (std::size_t i = 0; i < setups.size(); ++i) {
      if (begins.empty() || cost + going_on[i] > limit) {
        begins.push_back(i);
        cost = anew[i];
      } else {
        cost += going_on[i];
      }
    }
    return begins;
  };
  std::uint64_t low = setups.empty() ? 0 : *std::max_element(anew.begin(), anew.end());
  for (std::uint64_t high = std::max(low, most); low < high;) {
    const std::uint64_t middle = low + (high - low) / 2;
    pieces(middle).size() <= benches ? high = middle : low = middle + 1;
  }
  const std::vector<std::size_t> begins = pieces(low);
  BenchLists lists(benches);
  for (std::size_t i = 0; i < begins.size(); ++i) {
    const std::size_t end = i + 1 < begins.size() ? begins[i + 1] : setups.size();
    lists[i].assign(setups.begin() + static_cast<std::ptrdiff_t>(begins[i]),
                    setups.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return lists;
}

}  // namespace changeover
