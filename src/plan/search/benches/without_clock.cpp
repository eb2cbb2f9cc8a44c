#include "plan/search/benches/without_clock.hpp"

#include <algorithm>

namespace changeover {

double share_without_clock(const ListsJob& job, const BenchLists& lists,
                           const RunControl& control) {
  constexpr double least = 0.1;
  constexpr double most = 0.5;
  constexpr double a_place = 0.0004;  // seconds
  const auto left = control.time_left();
  if (!left || left->count() <= 0) {
    return most;
  }
  double places = 0;
  for (std::size_t bench = 0; bench < lists.size(); ++bench) {
    places +=
        static_cast<double>(lists[bench].size()) * static_cast<double>(job.jobs[bench]->room());
  }
  return std::clamp(a_place * places / left->count(), least, most);
}

}  // namespace changeover
