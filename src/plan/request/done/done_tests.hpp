// Reads the list of tests that were done: what remains to be planned, and what the results mean.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/plan/job_request.hpp"
#include "plan/request/parts_left.hpp"

namespace changeover {

/// Options for reading the list.
struct DoneOptions {
  const std::vector<std::string>* names = nullptr;  ///< of all parts of the list
  const Job* all_values = nullptr;                  ///< of a model: its job with all values
  const PartsLeft* left = nullptr;                  ///< which of them remain
  std::optional<std::uint64_t> first;  ///< number of its tests that were done, if given
  FailedTests failed = FailedTests::again;
  bool for_diagnosis = false;    ///< omits notes on planning
  bool all_parts_known = false;  ///< unknown names are faults: the list is no older sheet
};

/// The door's spelling of words in notes.
struct DoneWords {
  std::string done_first;
  std::string trust_failed;
  std::string first_tests;  ///< where the set-ups that come first were read from
};

/// Takes the tests that were done off the job: the first ones if their number is given, else those
/// with a result if any has one, else all; without those whose result says that they were not run.
/// Those of the job's first tests among them are not to be run again. Several inputs are sheets of
/// one workbook. A test says by name or number on which bench it was; a bench then goes on after
/// its last test, with what was mounted there and the rest of its sheet. Tests of a bench that is
/// none any more, or of none, count all the same. Fills all of the answer but its job and its
/// benches. O(size of the lists), besides mark_tested(). @throws BadOption, BadInput,
/// MissingResource
[[nodiscard]] ReadJob take_done(const std::vector<std::unique_ptr<Input>>& inputs,
                                const DoneOptions& options, const DoneWords& words, Job& job,
                                std::vector<Bench>& benches);

}  // namespace changeover
