#include "changeover/run/threads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <latch>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/run/scope.hpp"

namespace changeover {
namespace {

class Crew {
 public:
  Crew(RunControl& control, unsigned count, const std::function<void(unsigned)>& work)
      : control_(control), count_(count), work_(work) {}

  void run() {
    std::vector<std::jthread> threads;
    try {
      for (unsigned i = 1; i < count_; ++i) {
        threads.emplace_back([this, i] {
          complete_.wait();
          if (!too_many_) {
            act(i);
          }
        });
      }
    } catch (const std::system_error& fault) {
      too_many_ = true;
      complete_.count_down();
      threads.clear();
      throw MissingResource(fmt::format("cannot start {} threads: {}; use fewer, or allow more",
                                        count_, fault.code().message()));
    }
    complete_.count_down();
    act(0);
    threads.clear();
    if (fault_) {
      std::rethrow_exception(fault_);
    }
  }

 private:
  void act(unsigned i) {
    try {
      const RunScope scope(control_);
      work_(i);
    } catch (const Stopped&) {
      // The control knows why.
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (!fault_) {
        fault_ = std::current_exception();
      }
      control_.stop(WhyStopped::fault);
    }
  }

  RunControl& control_;
  unsigned count_;
  const std::function<void(unsigned)>& work_;
  std::latch complete_{1};  // nobody works before all are there
  bool too_many_ = false;   // written before the latch opens
  std::mutex mutex_;
  std::exception_ptr fault_;
};

}  // namespace

void run_together(RunControl& control, unsigned count, const std::function<void(unsigned)>& work) {
  Crew(control, count, work).run();
}

void in_parallel(RunControl& control, std::size_t count,
                 const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next{0};
  const auto threads = static_cast<unsigned>(
      std::clamp<std::size_t>(count, 1, std::max(1U, control.threads())));
  run_together(control, threads, [&](unsigned) {
    for (std::size_t i = next++; i < count; i = next++) {
      task(i);
    }
  });
}

}  // namespace changeover
