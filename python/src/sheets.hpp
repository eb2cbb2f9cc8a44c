// What plans become in Python: the sheet of one bench, and those of several.
#pragma once

#include "job.hpp"

namespace changeover::python {

/// What was asked and what came of it: a plan for one bench, or for several.
struct Planned {
  JobRequest request;
  AskedJob asked;
  PlanAnswer answer;
  bool interrupted = false;

  [[nodiscard]] const Job& job() const { return *asked.job; }
  [[nodiscard]] std::string written(const std::string& format) const {
    return changeover::written(request, asked, answer, format);
  }
};

/// A run sheet with the job that it names its parts from.
struct Sheet : Planned {
  [[nodiscard]] const RunPlan& plan() const { return *answer.plan; }
};

/// Run sheets, one a bench.
struct Sheets : Planned {
  [[nodiscard]] const BenchPlan& plan() const { return *answer.benches; }
};

/// Binds what both can be written as.
template <typename Kind>
void bind_formats(py::class_<Kind>& kind) {
  kind.def_property_readonly(
          "notes", [](const Kind& self) { return self.answer.notes; },
          "What else is to be said of the job, a line each: results that are not understood, pairs that cannot meet.")
      .def("to_csv", [](const Kind& self) { return self.written("csv"); })
      .def("to_html", [](const Kind& self) { return self.written("html"); })
      .def(
          "to_json", [](const Kind& self) { return self.written("json"); },
          "The document that the command line writes with --json, byte for byte.")
      .def("to_markdown", [](const Kind& self) { return self.written("markdown"); })
      .def("to_text", [](const Kind& self) { return self.written("table"); })
      .def(
          "to_xlsx", [](const Kind& self) { return py::bytes(self.written("xlsx")); },
          "The bytes of a workbook.")
      .def(
          "request_json", [](const Kind& self) { return to_json(self.request); },
          "What was asked, as the document that `changeover plan --request` reads.");
}

/// A dict for each test: number, take_out, put_in, setup (names), cost, cost_so_far.
[[nodiscard]] py::list steps_of(const Job& job, const RunSheet& sheet);

/// diagnose() of what results say of the first tests of a sheet, or of other set-ups. @throws BadInput for other results.
[[nodiscard]] py::dict diagnosis_of(const Sheet& self, const py::iterable& results);

}  // namespace changeover::python
