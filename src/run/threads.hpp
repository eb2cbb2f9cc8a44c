// Threads of one piece of work: started together, joined together, their exceptions passed on.
//
//     run_together(control, control.threads(), [&](unsigned) { work(); });
//     in_parallel(control, jobs.size(), [&](std::size_t i) { run(jobs[i]); });
#pragma once

#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

#include "changeover/run/control.hpp"

namespace changeover {

/// Starts `count` threads, all or none: serve(0), …, serve(count−1), each on its own thread. If the
/// system cannot start them all, end() must make those that were started return. @throws
/// MissingResource, with all threads joined. An exception of serve() ends the process.
void start_threads(std::vector<std::thread>& threads, unsigned count,
                   const std::function<void(unsigned)>& serve, const std::function<void()>& end);

/// Calls work(0), …, work(count−1), all at the same time, work(0) on the caller (also if count is
/// 0), each with the scope of `control` (run/control.hpp), and returns when all have ended. If one
/// throws, the control is stopped (WhyStopped::fault) so that the others end soon, and the caller
/// gets the first exception; Stopped does not count as one: the control says why.
/// @throws MissingResource if the system cannot start so many threads; nothing is then running.
void run_together(RunControl& control, unsigned count, const std::function<void(unsigned)>& work);

/// Calls task(0), …, task(count−1), each once, in this order, on the threads that the control
/// allows. Otherwise as run_together(): a thread whose task throws, Stopped included, takes no
/// further one. Tasks are called even if the control is stopped: they check it themselves.
void in_parallel(RunControl& control, std::size_t count,
                 const std::function<void(std::size_t)>& task);

}  // namespace changeover
