// Rows of a sheet that are no tests: a line of sums below it, the name of a day between two, the
// heads again where two sheets were put one below the other.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "changeover/plan/job.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/part_finder.hpp"
#include "plan/job/setups/setup_columns.hpp"

namespace changeover {

class ExtraRows {
 public:
  /// What a row below a header is.
  enum class Kind {
    test,
    heads,  ///< the header again
    other   ///< it has no part and no result
  };

  /// Keeps a row that is no test for say(). @throws BadInput with the cell for a row with a result
  /// and no part, and for other heads than those above. O(its fields)
  Kind take(const Row& row, const Row& header, const SetupColumns& columns,
            const PartFinder& finder, const RowReader& reader);

  /// Once all rows are read: a note names those that were skipped. @throws BadInput with the place
  /// of a numbered row without parts in a list without results, where every row is a test
  void say(DoneList& list) const;

 private:
  std::vector<std::string> names_;       // "9 ('Total')"
  std::string first_;                    // the place of the first one
  std::optional<std::string> numbered_;  // the place of the first one that is a step
};

}  // namespace changeover
