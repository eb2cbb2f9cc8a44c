#include <algorithm>

#include "plan/search/bounds/step_program.hpp"

namespace changeover {

void StepProgram::set_walks(const Job& job, const JobNumbers& n) {
  std::vector<std::uint64_t> prices(costs_.begin(),
                                    costs_.begin() + static_cast<std::ptrdiff_t>(v_));
  std::sort(prices.begin(), prices.end());
  prices.erase(std::unique(prices.begin(), prices.end()), prices.end());
  for (; !prices.empty(); prices.pop_back()) {
    Costliest costliest;
    for (std::size_t x = 0; x < v_; ++x) {
      if (costs_[x] >= prices.back()) {
        costliest.parts.push_back(x);
        costliest.starts += q_->at_start[x];
      }
    }
    costliest.walk = CostlyWalk(job, n, counted_, q_->at_start, costliest.parts);
    if (!costliest.walk.fits()) {
      return;
    }
    walks_.push_back(std::move(costliest));
  }
}

// Theorem 28, (2): for the most expensive parts, one more than how often they come.
bool StepProgram::add_costliest() {
  constexpr std::uint64_t most_states = 10'000;
  constexpr double slightly = 1e-6;
  bool any = false;
  for (Costliest& costliest : walks_) {
    if (!costliest.open) {
      continue;
    }
    double all = slightly;
    LeastSum::Row row;
    for (const std::size_t x : costliest.parts) {
      all += times(x);
      row.push_back({x, 1});
    }
    const auto known = static_cast<std::uint64_t>(all) - costliest.starts;
    std::uint64_t states = std::min(most_states, walk_states_);
    walk_states_ -= states;
    costliest.open = costliest.walk.comes_more_than(known, states);
    walk_states_ += states;
    if (costliest.open &&
        add_if_room(std::move(row), static_cast<std::int64_t>(known + 1 + costliest.starts))) {
      costliest.times = known + 1;
      costliest.row = rows_.size() - 1;
      any = true;
    }
  }
  return any;
}

std::optional<CostlyTimes> StepProgram::costly_times() const {
  std::optional<CostlyTimes> last;
  for (const Costliest& costliest : walks_) {
    if (costliest.row && program_->price(*costliest.row) > 0) {
      last = CostlyTimes{costliest.parts.size(), costliest.times};
    }
  }
  return last;
}

}  // namespace changeover
