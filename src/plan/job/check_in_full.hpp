// Checks a job within a search, ignoring requests to stop: a stopped search still has an answer for
// a correct job.
#pragma once

#include "changeover/plan/job.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

/// Like check(), but without the limits of this thread. @throws BadInput as check() does.
inline void check_in_full(const Job& job) {
  RunControl no_limit({});
  const RunScope scope(no_limit);
  check(job);
}

}  // namespace changeover
