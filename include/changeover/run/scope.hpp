// How work that was handed no control listens to the one above it.
//
//     RunScope scope(control);                 // for this thread, until the end of the block
//     const Bound bound = lower_bound(p);      // stops with the control, and tells it where it is
//
// Bounds, constructions and verification are called by searches that have a limit and by programs that
// have none, often several calls deep. Their loops call stop_if_asked(); where no scope is open that is a look
// at one pointer, and nothing happens. Scopes nest: the innermost counts. Threads that run/threads.hpp starts
// have the scope of their control.
//
// *Stopping* is an exception, Stopped, and no fault: what was under way is given up, what was found
// before is kept by whoever opened the scope. Catch it there, and ask the control why it stopped.
#pragma once

#include <cstdint>
#include <exception>
#include <string_view>

#include "changeover/run/control.hpp"

namespace changeover {

/// Thrown by stop_if_asked(). Not an Error: nothing is wrong.
class Stopped : public std::exception {
 public:
  explicit Stopped(WhyStopped why) : why_(why) {}
  [[nodiscard]] WhyStopped why() const { return why_; }
  [[nodiscard]] const char* what() const noexcept override { return "stopped"; }

 private:
  WhyStopped why_;
};

/// Makes a control the one that this thread listens to. The control must outlive the scope.
class RunScope {
 public:
  explicit RunScope(RunControl& control);
  ~RunScope();
  RunScope(const RunScope&) = delete;
  RunScope& operator=(const RunScope&) = delete;

  /// The control of the innermost scope of this thread; nullptr if there is none.
  [[nodiscard]] static RunControl* current();

 private:
  RunControl* outer_;
};

/// @throws Stopped if the control of this thread's scope wants to stop. Costs a look at the clock, some 30 ns;
/// nothing without a scope.
void stop_if_asked();

/// RunControl::require_memory() of this thread's scope. @throws MissingResource
void require_memory(std::uint64_t bytes, std::string_view what);

/// Whether report_progress() would reach anybody now; ask before making a long text.
[[nodiscard]] bool progress_due();

/// RunControl::tell() of this thread's scope.
void report_progress(const Progress& progress);

}  // namespace changeover
