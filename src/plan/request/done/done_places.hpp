// The places of a bench in lists of tests that were done, which have a column for each: several
// lists as one, the tests that are kept for the sheet of those that were done, and what is where.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover {

/// Appends a list: places with the same headings are the same; of a model, those of the same
/// parameter. O(places · rows)
void append_done(DoneList& list, DoneList more, bool is_of_model);

/// Keeps a test for the sheet of those that were done; of a test without places, its parts and
/// those that are gone, one after another.
void record_test(DoneRecord& record, std::vector<DonePlace> places, const DoneRow& test,
                 const Job& job, const std::string& bench);

/// The places of the bench after the test, row `test`, from which the plan continues, with their
/// parts; without slots, no more than parts fit.
[[nodiscard]] std::vector<MountedPlace> places_after(const DoneList& list, std::size_t test,
                                                     const Job& job, std::uint64_t room);

}  // namespace changeover
