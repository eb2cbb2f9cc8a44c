// The list of tests that were done: what it leaves to be planned, and what its results say.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/plan/diagnosis.hpp"
#include "changeover/plan/job.hpp"

namespace changeover::cli {

struct DoneRequest {
  std::string path;                    ///< of the list
  std::optional<std::uint64_t> first;  ///< how many of its tests were done, if that was said
  FailedTests failed = FailedTests::again;
  bool for_diagnosis = false;  ///< no note says what is planned
  std::string first_tests;     ///< what the set-ups that come first were read from
};

/// What a list of tests that were done leaves.
struct DoneAnswer {
  std::vector<Block> rest;           ///< of the plan under way
  std::vector<TestedSetup> results;  ///< those that say pass or fail
  std::uint64_t unread = 0;          ///< results that are not understood
  std::vector<UnreadResult> first_unread;
  std::vector<std::string> notes;
};

/// Takes the tests that were done off the job: the first ones if their number is given, else those with a result if any has
/// one, else all; without those whose result says that they were not run. Those of the job's first tests among them are not
/// to be run again. O(size of the list), besides mark_tested(). @throws UsageError, BadInput, MissingResource
[[nodiscard]] DoneAnswer take_done(const DoneRequest& request, Job& job);

}  // namespace changeover::cli
