#include "plan/search/benches/step_costs.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "plan/sheet/replacement.hpp"

namespace changeover {

std::vector<Amount> step_costs(const Job& job, const std::vector<Block>& setups) {
  std::vector<Amount> costs;
  Block before = job.start;
  std::ranges::sort(before);
  for (const Block& given : setups) {
    Block setup = given;
    std::ranges::sort(setup);
    Block out;
    Block in;
    std::ranges::set_difference(before, setup, std::back_inserter(out));
    std::ranges::set_difference(setup, before, std::back_inserter(in));
    Amount& cost = costs.emplace_back(job.test_cost);
    if (job.replaces()) {
      cost += cheapest_replacement(job, out, in).cost;
    } else {
      for (const Element x : in) {
        cost += job.change_costs[x];
      }
    }
    before = std::move(setup);
  }
  return costs;
}

}  // namespace changeover
