// Results that are not in the column that is read: a sheet may have "Ergebnis" beside "result", or
// "Status" in its place.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
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
  /// not, or if no column is read and one says so
  void check(const Row& row, const DoneRow& done, const Row& header, const SetupColumns& columns,
             const RowReader& reader);

  /// Names the columns that only repeat the results, and one that says pass or fail while that of
  /// results is empty. @throws BadInput with the result where one that does not repeat all of them
  /// may be the one that is meant: none is called "result"
  void say(DoneList& list, const Row& header, const SetupColumns& columns,
           const RowReader& reader) const;

 private:
  struct Silence {
    Field at;  // the result beside the empty cell
    std::string result;
  };

  void check_unread(const Row& row, const Row& header, const SetupColumns& columns,
                    const RowReader& reader);

  std::vector<std::size_t> columns_;       // their heads mean results
  std::vector<std::size_t> unread_;        // their heads mean nothing that is known
  std::optional<std::size_t> strange_;     // the first of these that says pass or fail
  std::optional<std::size_t> said_;        // the first that says pass or fail
  std::map<std::size_t, Silence> silent_;  // by column: where it first says nothing of a result
};

}  // namespace changeover
