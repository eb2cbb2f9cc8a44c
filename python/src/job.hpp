// Jobs as Python tells them, made into requests: parts by name, pairs and set-ups of names, costs as exact decimals.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bind.hpp"
#include "changeover/plan/job_request.hpp"

namespace changeover::python {

/// As decimal.Decimal.
[[nodiscard]] py::object decimal(Amount amount);

/// The names of these parts.
[[nodiscard]] std::vector<std::string> names(const Job& job, const Block& parts);

/// An iterable of names. @throws BadInput for unknown names and more of them than there are parts; type_error for a string.
[[nodiscard]] Block parts_named(const Job& job, const char* argument, const py::handle& parts);

// What plan() may be told of a job by objects, as Python gave them.
struct GivenJob {
  py::object parts;
  py::object test_cost;
  py::object change_cost;
  py::object change_costs;
  py::object pairs;
  py::object never;
  py::object slots;
  py::object slot_of;
  py::object mounted;
  py::object start;
  py::object first;
  py::object weights;
  py::object done;
  py::object budget;
};

/// What True (passed), False (failed), None (nothing is known) or a text such as "FAILED - hang" says of a test; nothing for
/// anything else.
[[nodiscard]] std::optional<TestResult> result_named(const py::handle& result);

/// The request without what is not an object. Iterators are read item by item, so Ctrl-C ends it. @throws BadInput with the argument and how to mend it.
[[nodiscard]] JobRequest request_of(const GivenJob& given);

}  // namespace changeover::python
