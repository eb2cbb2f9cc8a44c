// Calls that take time: the GIL is released, signals are polled, progress arrives, and every one of
// them can be stopped.
//
//     LongWork work({.seconds = 60, .threads = 2, .progress = callback});
//     work.run([&](RunControl& control) { result = improve(p, options, control); });
//     work.interrupted();                    // Ctrl-C: what was found so far is kept
//
// The work runs on a separate thread and listens to its control; this thread looks for signals
// twenty times a second and hands progress on. After a second without progress it says again what
// was said last, with the time as it is by then. When Python ends, the work of other threads is
// ended before. A callback that raises stops the work, and what it raised arrives where the work
// was called.
#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <functional>
#include <optional>

#include "changeover/run/control.hpp"

namespace changeover::python {

struct LongOptions {
  std::optional<double> seconds = {};
  std::uint64_t threads = 1;
  std::uint64_t seed = 1;
  WorkShare share = {};
  pybind11::object progress = pybind11::none();  ///< called with a dict, or None
  bool keeps_best = false;  ///< KeyboardInterrupt is no fault: what was found is the answer
};

/// The limits of calls that keep the best that they found.
[[nodiscard]] inline LongOptions limits(std::optional<double> time, std::uint64_t threads,
                                        std::uint64_t seed, pybind11::object progress) {
  return {.seconds = time,
          .threads = threads,
          .seed = seed,
          .progress = std::move(progress),
          .keeps_best = true};
}

class LongWork {
 public:
  /// @throws value_error for a time or a number of threads that is none.
  explicit LongWork(LongOptions options);

  /// Runs it to its end. @throws what it throws; error_already_set for signals and callbacks.
  /// Stopped becomes TimeoutError.
  void run(const std::function<void(RunControl&)>& work);

  /// KeyboardInterrupt came and was kept back.
  [[nodiscard]] bool interrupted() const { return interrupted_; }

 private:
  LongOptions options_;
  bool interrupted_ = false;
};

/// From now on all work is asked to stop when Python ends, which waits for it: what the work uses
/// is then still there.
void stop_long_work_at_the_end();

/// The same for work without its own limits but perhaps a time: the result of work().
template <typename Work>
auto stoppable(Work&& work, std::optional<double> seconds = std::nullopt) {
  std::optional<decltype(work())> result;
  LongWork(LongOptions{.seconds = seconds}).run([&](RunControl&) { result.emplace(work()); });
  return std::move(*result);
}

}  // namespace changeover::python
