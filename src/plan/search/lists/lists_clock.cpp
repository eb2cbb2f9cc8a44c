// The clock of lists: when everything is done if parts are scarce or benches rest.
#include <algorithm>
#include <utility>

#include "core/checked.hpp"
#include "plan/search/lists/lists.hpp"

namespace changeover {

void Lists::set_clock(const ListsJob& job) {
  if (job.clock == nullptr) {
    return;
  }
  const ClockRules& rules = *job.clock;
  const std::uint64_t unit = job.weights.front().unit;
  std::vector<ClockBench> courses;
  before_.reserve(benches());  // the clock refers to it
  for (std::size_t bench = 0; bench < benches(); ++bench) {
    Before before{.start = place_of(rules.start[bench]),
                  .steps = {},
                  .shared = Bits((parts_ + 63) / 64, 0),
                  .change = {}};
    for (Element x = 0; x < parts_; ++x) {
      before.shared[x >> 6] |= std::uint64_t{rules.shared[bench][x]} << (x & 63);
      before.change.push_back(static_cast<Ticks>(view(bench).weights.change[x]));
    }
    for (const Block& setup : rules.first[bench]) {
      Place place = place_of(setup);
      const Place& from = before.steps.empty() ? before.start : before.steps.back();
      place.cost =
          static_cast<std::int64_t>(view(bench).weights.test) + step(view(bench), from, place);
      before.steps.push_back(std::move(place));
    }
    before_.push_back(std::move(before));
    const Before& kept = before_.back();
    courses.push_back({.start = kept.start.bits.data(),
                       .shared = kept.shared.data(),
                       .change = kept.change,
                       .hours = static_cast<Ticks>(rules.hours[bench] / unit)});
  }
  clock_.emplace(std::move(courses), rules.quantity, static_cast<Ticks>(ceil_div(rules.day, unit)));
  stale_.assign(benches(), 0);
}

std::int64_t Lists::largest() const {
  return clock_ ? clocked().finish : *std::max_element(cost_.begin(), cost_.end());
}

const BenchClock::Result& Lists::clocked() const {
  if (!clocked_) {
    for (std::size_t bench = 0; bench < benches(); ++bench) {
      const std::vector<Place>& first = before_[bench].steps;
      const std::vector<std::uint32_t>& order = order_[bench];
      std::vector<ClockStep>& steps = clock_->steps(bench);
      steps.resize(first.size() + order.size());
      for (std::size_t i = stale_[bench]; i < steps.size(); ++i) {
        const Place& place = i < first.size() ? first[i] : places_[order[i - first.size()]];
        steps[i] = {place.cost, place.bits.data()};
      }
      stale_[bench] = steps.size();
    }
    (void)clock_->run();
    clocked_ = true;
    if (notes_.empty()) {
      clock_->keep();
      clock_kept_ = true;
    }
  }
  return clock_->result();
}

// Tells the clock that steps from a place on change.
void Lists::changed(Spot where) {
  if (clock_) {
    const std::size_t at = before_[where.bench].steps.size() + where.at;
    stale_[where.bench] = std::min(stale_[where.bench], at);
    clock_->change(where.bench, at);
    clocked_ = false;
  }
}

}  // namespace changeover
