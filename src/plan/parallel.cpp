#include "plan/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace changeover::plan_detail {

void in_parallel(const SearchControl& control, unsigned count,
                 const std::function<void(unsigned)>& task) {
  std::atomic<unsigned> next{0};
  std::mutex guard;
  std::exception_ptr fault;
  const auto work = [&] {
    for (unsigned i = next++; i < count; i = next++) {
      try {
        task(i);
      } catch (...) {
        const std::scoped_lock lock(guard);
        fault = fault ? fault : std::current_exception();
      }
    }
  };
  std::vector<std::jthread> threads;
  for (unsigned i = 1; i < std::min(count, control.threads()); ++i) {
    threads.emplace_back(work);
  }
  work();
  threads.clear();
  if (fault) {
    std::rethrow_exception(fault);
  }
}

SearchControl::Settings settings_for_one_thread(const SearchControl& control) {
  SearchControl::Settings settings;
  settings.time = control.time_left();
  settings.seed = control.seed();
  settings.interrupted = control.settings().interrupted;
  return settings;
}

}  // namespace changeover::plan_detail
