#include "plan/search/benches/without_clock.hpp"

#include <algorithm>

namespace changeover {

std::uint64_t places_of(const ListsJob& job, const BenchLists& lists) {
  std::uint64_t places = 0;
  for (std::size_t bench = 0; bench < lists.size(); ++bench) {
    places += lists[bench].size() * job.jobs[bench]->room();
  }
  return places;
}

double share_without_clock(std::uint64_t places,
                           std::optional<std::chrono::duration<double>> left) {
  constexpr double least = 0.1;
  constexpr double most = 0.5;
  constexpr double a_place = 0.0004;  // seconds
  if (!left || left->count() <= 0) {
    return most;
  }
  return std::clamp(a_place * static_cast<double>(places) / left->count(), least, most);
}

}  // namespace changeover
