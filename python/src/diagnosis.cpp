// What the results of a sheet's tests say.
#include "changeover/plan/diagnosis.hpp"
#include "arguments.hpp"
#include "changeover/core/error.hpp"
#include "long_work.hpp"
#include "sheets.hpp"

namespace changeover::python {
namespace {

// What results say, and the texts that are not understood, each with its place in them.
struct Results {
  std::vector<TestedSetup> tests;
  py::list unread;
};

// True, False or a text for the next set-up of the sheet, None for no result, or a set-up of its own with its result.
Results results_of(const Sheet& self, const py::iterable& results) {
  const char* const wanted =
      "results has True (passed), False (failed), None or a text for each of the first tests, or (set-up, result)";
  if (py::isinstance<py::str>(results)) {
    throw BadInput(wanted);
  }
  const std::vector<RunStep>& steps = self.plan().sheet.steps;
  std::size_t next = 0;
  std::size_t place = 0;
  Results all;
  const auto add = [&](const Block& setup, const py::handle& result, bool may_be_none) {
    const auto said = result_named(result);
    if (!said || (result.is_none() && !may_be_none)) {
      throw BadInput(wanted);
    }
    if (*said == TestResult::pass || *said == TestResult::fail) {
      all.tests.push_back({setup, *said == TestResult::fail});
    } else if (*said == TestResult::unread) {
      all.unread.append(py::make_tuple(place, result));
    }
    ++place;
  };
  for_each(results, [&](const py::handle& result) {
    if (py::isinstance<py::tuple>(result)) {
      const auto two = py::reinterpret_borrow<py::tuple>(result);
      if (two.size() != 2) {
        throw BadInput(wanted);
      }
      add(parts_named(self.job(), "results", two[0]), two[1], false);
      return;
    }
    if (next == steps.size()) {
      throw BadInput("results has more than the sheet has tests");
    }
    add(steps[next++].setup, result, true);
  });
  return all;
}

// A part as ("Motor",), a pair as ("Motor", "Pump").
py::tuple suspect_of(const Job& job, const Suspect& suspect) {
  return suspect.other ? py::make_tuple(job.names[suspect.one], job.names[*suspect.other])
                       : py::make_tuple(job.names[suspect.one]);
}

py::list suspects_of(const Job& job, const std::vector<Suspect>& suspects) {
  py::list all;
  for (const Suspect& suspect : suspects) {
    all.append(suspect_of(job, suspect));
  }
  return all;
}

py::dict as_dict(const Job& job, const Diagnosis& found) {
  py::list two;
  for (const auto& [one, other] : found.two) {
    two.append(py::make_tuple(suspect_of(job, one), suspect_of(job, other)));
  }
  py::list contradictions;
  for (const auto& [failed, passed] : found.contradictions) {
    contradictions.append(py::make_tuple(names(job, failed), names(job, passed)));
  }
  py::list tests;
  for (const NextTest& test : found.tests) {
    py::list after;
    for (const bool failed : test.after) {
      after.append(!failed);
    }
    py::dict one;
    one["after"] = py::tuple(after);
    one["setup"] = names(job, test.setup);
    one["take_out"] = names(job, test.take_out);
    one["put_in"] = names(job, test.put_in);
    one["cost"] = decimal(test.cost);
    one["if_it_fails"] = suspects_of(job, test.if_it_fails);
    one["if_it_passes"] = suspects_of(job, test.if_it_passes);
    tests.append(one);
  }
  py::dict all;
  all["passed"] = found.passed;
  all["failed"] = found.failed;
  all["suspects"] = suspects_of(job, found.suspects);
  all["two"] = two;
  all["contradictions"] = contradictions;
  all["tests"] = tests;
  all["most_cost"] = decimal(found.most_cost);
  return all;
}

}  // namespace

py::dict diagnosis_of(const Sheet& self, const py::iterable& results) {
  const Results all = results_of(self, results);
  const std::vector<TestedSetup>& tested = all.tests;
  Job job = self.job();
  if (!tested.empty()) {
    job.start = tested.back().setup;  // it is on the bench
  }
  py::dict found =
      as_dict(self.job(), stoppable([&] { return changeover::diagnose(job, tested); }));
  found["unread"] = all.unread;
  return found;
}

}  // namespace changeover::python
