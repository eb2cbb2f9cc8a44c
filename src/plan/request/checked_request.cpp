// Requests with what was read of them.
#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "changeover/plan/job_request.hpp"
#include "changeover/run/control.hpp"
#include "plan/request/question.hpp"

namespace changeover {

CheckedJobRequest checked_job(const JobRequest& request, Door door) {
  return checked_job(OpenedRequest{.request = request, .notes = {}}, door);
}

CheckedJobRequest checked_job(const OpenedRequest& opened, Door door,
                              std::optional<double> seconds) {
  constexpr double more_seconds = 3;
  RunControl unlimited({});
  RunControl* const outer = RunScope::current();
  RunControl limited(outer != nullptr ? *outer : unlimited,
                     std::chrono::duration<double>(std::min<double>(
                         seconds.value_or(most_seconds) + more_seconds, most_seconds)));
  const RunScope scope(limited);
  ReadJob read = read_job(opened.request, door);
  read.notes.insert(read.notes.begin(), opened.notes.begin(), opened.notes.end());
  complete(read.question, opened.kept);
  return {opened.request, std::move(read)};
}

}  // namespace changeover
