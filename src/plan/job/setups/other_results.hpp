// Columns of results beside the one that is read: a sheet may have "Ergebnis" beside "result".
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "changeover/plan/job.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/setups/setup_columns.hpp"

namespace changeover {

class OtherResults {
 public:
  /// Finds the columns of a header.
  void find(const Row& header, const SetupColumns& columns);

  /// @throws BadInput with the cell if another column says pass or fail and that of results does
  /// not
  void check(const Row& row, const DoneRow& done, const Row& header, const SetupColumns& columns,
             const RowReader& reader);

  /// Names the columns that only repeat the results.
  void say(DoneList& list, const Row& header, const RowReader& reader) const;

 private:
  std::vector<std::size_t> columns_;
  std::optional<std::size_t> said_;  // the first that says pass or fail
};

}  // namespace changeover
