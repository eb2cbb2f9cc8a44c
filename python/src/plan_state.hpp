// Plans as pickles have them: the request with the content of its files, and the set-ups that were
// found. What is made from a pickle is counted again.
#pragma once

#include <memory>
#include <optional>

#include "bind.hpp"
#include "changeover/plan/job_request.hpp"
#include "long_work.hpp"

namespace changeover::python {

/// A plan that Python holds.
struct Planned {
  JobRequest request;
  CheckedJobRequest asked;
  /// The same request without names of files; nullopt if one of them can be read only once.
  std::optional<JobRequest> whole = {};
  PlanAnswer answer = {};

  [[nodiscard]] const Job& job() const { return *asked->job; }
};

/// The request with the content of its files in place of their names.
[[nodiscard]] std::optional<JobRequest> without_files(const JobRequest& request);

/// The request checked in its time.
[[nodiscard]] inline CheckedJobRequest checked(const OpenedRequest& opened) {
  return stoppable([&] { return checked_job(opened, Door::python, opened.request.seconds); });
}

/// Numbers, texts and tuples of them. @throws BadInput if a file was one that can be read only
/// once.
[[nodiscard]] py::tuple state_of(const Planned& plan);

/// The plan of a state; its sheets are counted. @throws BadInput if the set-ups do not fit the
/// request; cast_error for what is no state.
[[nodiscard]] std::unique_ptr<Planned> planned_again(const py::tuple& state);

}  // namespace changeover::python
