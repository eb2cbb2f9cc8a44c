#include <algorithm>

#include "plan/search/bounds/step_program.hpp"

namespace changeover {

void StepProgram::set_walks(const Job& job, const JobNumbers& n) {
  std::vector<std::uint64_t> prices(costs_.begin(),
                                    costs_.begin() + static_cast<std::ptrdiff_t>(v_));
  std::sort(prices.begin(), prices.end());
  prices.erase(std::unique(prices.begin(), prices.end()), prices.end());
  for (; !prices.empty(); prices.pop_back()) {
    Dearest dearest;
    for (std::size_t x = 0; x < v_; ++x) {
      if (costs_[x] >= prices.back()) {
        dearest.parts.push_back(x);
        dearest.starts += q_->at_start[x];
      }
    }
    dearest.walk = DearWalk(job, n, counted_, q_->at_start, dearest.parts);
    if (!dearest.walk.fits()) {
      return;
    }
    walks_.push_back(std::move(dearest));
  }
}

// Theorem 28, (2): for the most expensive parts, one more than how often they come.
bool StepProgram::add_dearest() {
  constexpr std::uint64_t most_states = 10'000;
  constexpr double slightly = 1e-6;
  bool any = false;
  for (Dearest& dearest : walks_) {
    if (!dearest.open) {
      continue;
    }
    double all = slightly;
    LeastSum::Row row;
    for (const std::size_t x : dearest.parts) {
      all += times(x);
      row.push_back({x, 1});
    }
    const auto known = static_cast<std::uint64_t>(all) - dearest.starts;
    std::uint64_t states = std::min(most_states, walk_states_);
    walk_states_ -= states;
    dearest.open = dearest.walk.comes_more_than(known, states);
    walk_states_ += states;
    if (dearest.open &&
        add_if_room(std::move(row), static_cast<std::int64_t>(known + 1 + dearest.starts))) {
      dearest.times = known + 1;
      dearest.row = rows_.size() - 1;
      any = true;
    }
  }
  return any;
}

std::optional<DearTimes> StepProgram::dear_times() const {
  std::optional<DearTimes> last;
  for (const Dearest& dearest : walks_) {
    if (dearest.row && program_->price(*dearest.row) > 0) {
      last = DearTimes{dearest.parts.size(), dearest.times};
    }
  }
  return last;
}

}  // namespace changeover
