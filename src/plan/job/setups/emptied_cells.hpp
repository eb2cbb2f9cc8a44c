// Cells of parts that were emptied on a run sheet: the test before and the test after, with what
// was taken out and put in between, say what stood there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "changeover/plan/job.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/part_finder.hpp"
#include "plan/job/setups/first_noted.hpp"

namespace changeover {

class EmptiedCells {
 public:
  /// What a row says of its changes; nothing for what it does not say, or not in names of parts.
  struct Changes {
    std::optional<Block> out;
    std::optional<Block> in;
  };

  /// Keeps a row: its cells of parts, one for each place. O(its cells)
  void take(const DoneRow& done, const std::vector<Field>& cells, Changes changes);

  /// Once all rows are in their order. A part that is in the place of an empty cell in the test
  /// before, and is not taken out, or in the test after, and is not put in, was there. Only the
  /// step before and the step after say so; without numbers both have to. Where nothing says what
  /// is taken out, a note names the cell of a part that is there before and after. For a model, a
  /// value that is put in takes out that of its parameter. O(rows · log rows · places)
  /// @throws BadInput with the cell
  void judge(DoneList& list, const PartFinder& finder, const RowReader& reader) const;

 private:
  struct Known {
    std::vector<std::pair<std::size_t, std::size_t>> empty;  // place and offset of each empty cell
    Changes changes;
  };
  struct Neighbours;

  [[nodiscard]] bool was_before(const Neighbours& rows, std::size_t place,
                                const PartFinder& finder) const;
  [[nodiscard]] bool is_after(const Neighbours& rows, std::size_t place) const;
  void judge_row(const Neighbours& rows, const PartFinder& finder, const RowReader& reader,
                 FirstNoted& doubts) const;
  [[nodiscard]] bool is_own(const DoneRow& row) const;
  [[nodiscard]] bool is_doubtful(const Neighbours& rows, std::size_t place) const;

  std::map<std::uint64_t, Known> rows_;  // by line
  bool some_are_empty_ = false;
};

}  // namespace changeover
