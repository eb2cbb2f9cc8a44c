#include "plan/search/benches/easiest_job.hpp"

#include <algorithm>

#include "core/contains.hpp"
#include "plan/job/prices.hpp"

namespace changeover {

Job easiest_job(const BenchField& field) {
  Job easiest = at_prices(field.rest(0), Price::least);
  easiest.needed = field.common().needed;
  easiest.triples = field.common().triples;
  easiest.start.clear();
  for (std::size_t w = 1; w < field.size(); ++w) {
    if (&field.rest(w) == &field.rest(0)) {
      continue;
    }
    const Job other = at_prices(field.rest(w), Price::least);
    easiest.at_once = std::max(easiest.at_once, other.at_once);
    easiest.test_cost = std::min(easiest.test_cost, other.test_cost);
    for (std::size_t x = 0; x < easiest.change_costs.size(); ++x) {
      easiest.change_costs[x] = std::min(easiest.change_costs[x], other.change_costs[x]);
    }
    std::erase_if(easiest.mounted, [&](Element m) {
      return std::ranges::find(other.mounted, m) == other.mounted.end();
    });
    std::erase_if(easiest.barred, [&](Element x) { return !contains(other.barred, x); });
    // A part that a bench cannot have is in another slot there.
    const auto of_both = std::min(easiest.slots.size(), other.slots.size());
    for (std::size_t s = 0; s < of_both; ++s) {
      easiest.slots[s].least = std::min(easiest.slots[s].least, other.slots[s].least);
      easiest.slots[s].most = std::max(easiest.slots[s].most, other.slots[s].most);
    }
    if (easiest.slot_of != other.slot_of) {
      easiest.slots.clear();
      easiest.slot_of.clear();
    }
  }
  return easiest;
}

}  // namespace changeover
