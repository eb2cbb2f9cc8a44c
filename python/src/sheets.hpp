// What plans become in Python: the sheet of one bench, and those of several.
#pragma once

#include "changeover/plan/benches.hpp"
#include "changeover/plan/run_plan.hpp"
#include "job.hpp"

namespace changeover::python {

/// A run sheet with the job that it names its parts from.
struct Sheet {
  Job job;
  PlanOptions options;
  RunPlan plan;
  bool interrupted = false;
};

/// Run sheets, one a bench.
struct Sheets {
  Job job;
  BenchOptions options;
  BenchPlan plan;
  bool interrupted = false;
};

/// A dict for each test: number, take_out, put_in, setup (names), cost, cost_so_far.
[[nodiscard]] py::list steps_of(const Job& job, const RunSheet& sheet);

/// diagnose() of what results say of the first tests of a sheet, or of other set-ups. @throws BadInput for other results.
[[nodiscard]] py::dict diagnosis_of(const Sheet& self, const py::iterable& results);

}  // namespace changeover::python
