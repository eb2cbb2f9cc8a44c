// Columns of parameters that a model had when its run sheet was written, and has no more.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "changeover/plan/job.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/part_finder.hpp"
#include "plan/job/setups/setup_columns.hpp"

namespace changeover {

/// Such a column has an unknown head among those of parameters, or one as "slot_3 OS". Its values
/// are kept as written; the tests count for what the model still has.
class GoneParameters {
 public:
  /// Adds the columns of a header to `columns`; those of no model stay as they are. The header and
  /// the finder must outlive this. O(heads · parameters)
  /// @throws BadInput with the head of one that a parameter without a column has, but for a slip
  void find(const Row& header, const PartFinder& finder, const RowReader& reader,
            SetupColumns& columns);

  /// Whether such columns certainly had values of a parameter: a test with one there may have
  /// failed by it. In a list by hand they may be of the user's own.
  [[nodiscard]] bool are_certain() const { return !is_by_hand_; }

  /// Looks at what is in such a column.
  void take(std::size_t slot, const std::string& text);
  /// Looks at the columns of a list by hand that may be those of a parameter, though they are not
  /// among the others: in front of them, or behind them in a list without results. One word there
  /// that is written as a value out of range may have hidden the rest.
  void look_beside(const Row& row, const PartFinder& finder, DoneRow& done) const;

  /// Notes each column, in a list by hand with the head that it needs to be one, and which
  /// parameter it may be instead, if all of its values are its own; and columns in front that may
  /// be one.
  void say(const RowReader& reader, DoneList& list) const;

 private:
  struct Column {
    std::size_t slot = 0;
    const Field* head = nullptr;
    std::vector<std::size_t> may_be;  // parameters without a column that have all values here
    bool has_values = false;
  };

  [[nodiscard]] std::string not_read(const Field& head, const RowReader& reader) const;

  const ModelNames* names_ = nullptr;
  std::vector<Column> columns_;
  bool is_by_hand_ = false;           // nothing says that the program wrote the sheet
  std::vector<std::size_t> beside_;   // columns that may be those of a parameter
  std::vector<const Field*> before_;  // the heads of those in front of all parameters
};

/// In a list of set-ups that come first, values may be left open. Notes each column whose head is
/// neither a parameter nor one that is known, if a parameter has no column.
/// @throws BadInput with the head if it is such a parameter but for a slip
void note_unread_columns(const Row& header, const PartFinder& finder, const RowReader& reader,
                         const SetupColumns& columns, std::vector<std::string>& notes);

}  // namespace changeover
