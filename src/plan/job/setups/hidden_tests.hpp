// Tests whose values out of range are none any more: the error that was expected of one may have
// hidden all that was tested beside it, so that none of its pairs counts.
#pragma once

#include <optional>
#include <string>

#include "changeover/plan/job.hpp"
#include "plan/job/part_finder.hpp"
#include "plan/job/setups/first_noted.hpp"

namespace changeover {

/// Keeps in `hidden_by` of a test a value that is written as one out of range, "~-1" or "A: ~-1",
/// but is no such value of the model: it is gone (no part), or in range now. Does nothing for a
/// parts list.
void keep_if_hiding(const PartFinder& finder, const std::string& text, std::optional<Element> part,
                    DoneRow& test);

/// Collects the hidden tests of a list for one note.
class HiddenTests {
 public:
  /// Whether nothing of a test of this job counts: a value out of range is none any more, or two
  /// values are out of range. The test is then in the note.
  bool take(const Job& job, const DoneRow& test);

  /// One line on the tests of the list with this name; "" if none is hidden.
  [[nodiscard]] std::string said(const std::string& name) const;

 private:
  FirstNoted tests_;  // by row and values
};

}  // namespace changeover
