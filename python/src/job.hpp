// Jobs as Python tells them: parts by name, pairs and set-ups of names, costs as exact decimals.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bind.hpp"
#include "changeover/plan/job.hpp"

namespace changeover::python {

/// Numbers, strings and decimals alike, exactly as they are written. @throws BadInput
[[nodiscard]] Amount amount_of(const py::handle& value);

/// As decimal.Decimal.
[[nodiscard]] py::object decimal(Amount amount);

/// The names of these parts.
[[nodiscard]] std::vector<std::string> names(const Job& job, const Block& parts);

/// The part of that name. @throws BadInput if there is none.
[[nodiscard]] Element part_named(const Job& job, const py::handle& part);

/// An iterable of names. @throws BadInput for a string, unknown names and more of them than there are parts.
[[nodiscard]] Block parts_named(const Job& job, const char* argument, const py::handle& parts);

// Everything that plan() may be told about a job, as Python gave it.
struct Asked {
  py::object parts;
  std::uint64_t at_once = 0;
  py::object test_cost;
  py::object change_cost;
  py::object change_costs;
  std::uint64_t strength = 2;
  py::object pairs;
  py::object never;
  py::object slots;
  py::object slot_of;
  py::object mounted;
  py::object start;
  py::object first;
  py::object weights;
  py::object done;
  bool trust_failed = false;
};

/// What True (passed), False (failed), None (nothing is known) or a text such as "FAILED - hang" says of a test; nothing for
/// anything else.
[[nodiscard]] std::optional<TestResult> result_named(const py::handle& result);

/// The job, checked, without the pairs of the tests that were done. Ctrl-C ends it. @throws BadInput with the argument and how to
/// mend it; as check().
[[nodiscard]] Job job_of(const Asked& asked);

}  // namespace changeover::python
