// Threads of one piece of work: started together, ended together, and their faults arrive.
//
//     run_together(control, control.threads(), [&](unsigned) { work(); });
//     in_parallel(control, jobs.size(), [&](std::size_t i) { run(jobs[i]); });
#pragma once

#include <cstddef>
#include <functional>

#include "changeover/run/control.hpp"

namespace changeover {

/// Calls work(0), …, work(count−1), all at the same time, work(0) on the caller, each with the scope of
/// `control` (run/scope.hpp), and returns when all have ended. If one throws, the control is stopped
/// (WhyStopped::fault) so that the others end soon, and the first exception is thrown to the caller; Stopped is
/// none: the control knows why.
/// @throws MissingResource if the system has no room for so many threads; nothing is then under way.
void run_together(RunControl& control, unsigned count, const std::function<void(unsigned)>& work);

/// Calls task(0), …, task(count−1), each once, in this order, on the threads that the control allows.
/// Otherwise as run_together(); a stopped control does not keep tasks from being called: they look themselves.
void in_parallel(RunControl& control, std::size_t count,
                 const std::function<void(std::size_t)>& task);

}  // namespace changeover
