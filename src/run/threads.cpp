#include "run/threads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <latch>
#include <mutex>
#include <system_error>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

class Crew {
 public:
  Crew(RunControl& control, unsigned count, const std::function<void(unsigned)>& work)
      : control_(control), count_(count), work_(work) {}

  void run() {
    std::vector<std::thread> threads;
    start_threads(
        threads, count_ > 0 ? count_ - 1 : 0,
        [this](unsigned i) {
          complete_.wait();
          if (!too_many_) {
            act(i + 1);
          }
        },
        [this] {
          too_many_ = true;
          complete_.count_down();
        });
    complete_.count_down();
    act(0);
    for (std::thread& thread : threads) {
      thread.join();
    }
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
  std::latch complete_{1};  // no thread works before all have started
  bool too_many_ = false;   // written before the latch opens
  std::mutex mutex_;
  std::exception_ptr fault_;
};

}  // namespace

void start_threads(std::vector<std::thread>& threads, unsigned count,
                   const std::function<void(unsigned)>& serve, const std::function<void()>& end) {
  const auto give_up = [&] {
    end();
    for (std::thread& thread : threads) {
      thread.join();
    }
    threads.clear();
  };
  try {
    threads.reserve(count);
    for (unsigned i = 0; i < count; ++i) {
      threads.emplace_back(serve, i);
    }
  } catch (const std::system_error& fault) {
    give_up();
    throw MissingResource(fmt::format("cannot start {}: {}; use fewer, or allow more",
                                      count_of(count, "thread"), fault.code().message()));
  } catch (...) {
    give_up();
    throw;
  }
}

void run_together(RunControl& control, unsigned count, const std::function<void(unsigned)>& work) {
  Crew(control, count, work).run();
}

void in_parallel(RunControl& control, std::size_t count,
                 const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next{0};
  const auto threads =
      static_cast<unsigned>(std::clamp<std::size_t>(count, 1, std::max(1U, control.threads())));
  run_together(control, threads, [&](unsigned) {
    for (std::size_t i = next++; i < count; i = next++) {
      task(i);
    }
  });
}

}  // namespace changeover
