// The check of a job that a search makes once more: one that is to stop still has an answer to a
// job that is right.
#pragma once

#include "changeover/plan/job.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

/// check(), whatever limits this thread listens to. @throws BadInput as check() does.
inline void check_in_full(const Job& job) {
  RunControl no_limit({});
  const RunScope scope(no_limit);
  check(job);
}

}  // namespace changeover
