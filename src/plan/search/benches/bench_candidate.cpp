#include "plan/search/benches/bench_candidate.hpp"

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

BenchLists without_first(const BenchField& field, const BenchLists& all) {
  BenchLists lists;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!field.benches()[i].down) {
      const std::size_t first = field.whole(lists.size()).first.size();
      lists.emplace_back(all[i].begin() + static_cast<std::ptrdiff_t>(first), all[i].end());
    }
  }
  return lists;
}

BenchCandidate counted(const BenchField& field, const std::string& name, const std::string& how,
                       const BenchLists& lists, BenchCount* kept) {
  RunControl undisturbed({});
  const RunScope scope(undisturbed);
  const BenchSchedule schedule = field.schedule(lists);
  BenchCount count = count_benches(field.asked(), field.benches(), schedule);
  if (!count.faults.empty()) {
    throw InternalError(name + ": " + count.faults.front());
  }
  BenchCandidate candidate{.name = name,
                           .how = how,
                           .lists = {},
                           .tests = count.tests,
                           .changes = count.changes,
                           .cost = count.cost,
                           .makespan = count.makespan,
                           .pairs_tested = count.pairs_tested,
                           .triples_tested = count.triples_tested,
                           .weight = count.weight_tested};
  for (const std::vector<BenchStep>& steps : schedule) {
    candidate.lists.emplace_back();
    for (const BenchStep& step : steps) {
      candidate.lists.back().push_back(step.setup);
    }
  }
  if (kept != nullptr) {
    *kept = std::move(count);
  }
  return candidate;
}

}  // namespace changeover
