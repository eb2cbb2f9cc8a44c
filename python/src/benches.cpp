// Run sheets for several benches side by side.
#include "sheets.hpp"

namespace changeover::python {
namespace {

py::list all_steps(const Sheets& self) {
  py::list sheets;
  for (const RunSheet& sheet : self.plan().sheets) {
    sheets.append(steps_of(self.job(), sheet));
  }
  return sheets;
}

py::list candidates_of(const Sheets& self) {
  py::list all;
  for (const BenchCandidate& each : self.plan().candidates) {
    py::dict one;
    one["name"] = each.name;
    one["how"] = each.how;
    one["tests"] = each.tests;
    one["changes"] = each.changes;
    one["cost"] = decimal(each.cost);
    one["makespan"] = decimal(each.largest);
    all.append(one);
  }
  return all;
}

}  // namespace

void bind_benches(py::module_& module) {
  py::class_<Sheets> sheets(
      module, "BenchSheets",
      "Run sheets for several benches, counted by code that shares nothing with what made them.");
  bind_formats(sheets);
  sheets
      .def_property_readonly("sheets", &all_steps,
                             "For each bench a list of its tests, as RunSheet.steps.")
      .def_property_readonly(
          "tests", [](const Sheets& self) { return self.plan().tests; }, "On all benches.")
      .def_property_readonly(
          "changes", [](const Sheets& self) { return self.plan().changes; }, "On all benches.")
      .def_property_readonly(
          "cost", [](const Sheets& self) { return decimal(self.plan().cost); },
          "Of all benches; exact, a Decimal.")
      .def_property_readonly(
          "makespan", [](const Sheets& self) { return decimal(self.plan().largest); },
          "What the bench costs that costs most; exact, a Decimal.")
      .def_property_readonly(
          "complete", [](const Sheets& self) { return self.plan().does_the_job(); },
          "All that must meet does, on one bench or another.")
      .def_property_readonly(
          "pairs_tested", [](const Sheets& self) { return self.plan().pairs_tested; },
          "Of the pairs that must meet.")
      .def_property_readonly("pairs_needed",
                             [](const Sheets& self) { return self.plan().pairs_needed; })
      .def_property_readonly(
          "triples_tested", [](const Sheets& self) { return self.plan().triples_tested; },
          "Of three parts that must meet, with strength 3.")
      .def_property_readonly("triples_needed",
                             [](const Sheets& self) { return self.plan().triples_needed; })
      .def_property_readonly(
          "lower_bound", [](const Sheets& self) { return decimal(self.plan().bound.cost); },
          "Of the cost of all benches together.")
      .def_property_readonly(
          "reason", [](const Sheets& self) { return self.plan().bound.reason; }, "Of that bound.")
      .def_property_readonly(
          "makespan_bound", [](const Sheets& self) { return decimal(self.plan().largest_bound); },
          "Of the bench that costs most.")
      .def_property_readonly(
          "makespan_reason", [](const Sheets& self) { return self.plan().largest_reason; },
          "Of that bound.")
      .def_readonly("interrupted", &Sheets::interrupted, "Ctrl-C ended the search.")
      .def_property_readonly("candidates", &candidates_of,
                             "What it was compared with, the best first.")
      .def("__len__", [](const Sheets& self) { return self.plan().sheets.size(); })
      .def("__repr__", [](const Sheets& self) {
        return "<BenchSheets: " + std::to_string(self.plan().sheets.size()) + " benches, " +
               std::to_string(self.plan().tests) + " tests, makespan " +
               to_string(self.plan().largest) + ">";
      });
}

}  // namespace changeover::python
