// Whether a run sheet still has all of its columns of parts. What else is in a row (the parts that
// are put in, how many pairs are new) says what its set-up had; a column that was deleted, renamed
// or emptied would otherwise count as fewer pairs without a word.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "changeover/plan/job.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/part_finder.hpp"
#include "plan/job/setups/emptied_cells.hpp"
#include "plan/job/setups/first_noted.hpp"
#include "plan/job/setups/setup_columns.hpp"

namespace changeover {

class SheetEvidence {
 public:
  using FindPart = std::function<std::optional<Element>(const std::string&)>;

  /// For a sheet with one part in each column. The header and the finder must outlive this. `room`
  /// is the most parts that a set-up can have; the highest number if it is not known.
  SheetEvidence(const Row& header, const SetupColumns& columns, const RowReader& reader,
                const PartFinder& finder, std::uint64_t room);

  /// Keeps what contradicts the set-up of a row. O(its fields)
  void take(const Row& row, const DoneRow& done, const FindPart& find);

  /// Once all rows are in their order: refuses a sheet without one of its columns, and notes rows
  /// in which a part is missing. O(rows · log rows) if there are such rows, else O(columns).
  /// @throws BadInput with the cell
  void judge(DoneList& list) const;

 private:
  // A row whose set-up lacks parts.
  struct Doubt {
    std::uint64_t line = 0;
    Field at;
    std::string what;  // "'C' is put in here, but …"
    Block put_in;
    bool is_certain = false;  // so few parts cannot have so many new pairs
    bool keeps_old = false;   // a part that is taken out is still there: the user changed the row
    std::vector<std::size_t> empty;  // indices of its empty columns
  };

  [[nodiscard]] Block parts_in(const Row& row, std::optional<std::size_t> column,
                               const FindPart& find) const;
  [[nodiscard]] std::optional<Block> all_parts_in(const Row& row, std::optional<std::size_t> column,
                                                  const FindPart& find) const;
  void doubt_figures(const Row& row, const DoneRow& done, Doubt& doubt) const;
  [[nodiscard]] bool is_unexplained(const Doubt& doubt, const DoneList& list, std::size_t at) const;
  void judge_figures(DoneList& list) const;
  void judge_heads(DoneList& list) const;
  void judge_parameters(DoneList& list) const;

  const Row* header_;
  const SetupColumns* columns_;
  const RowReader* reader_;
  const PartFinder* finder_;
  std::uint64_t room_;
  std::optional<std::size_t> take_out_;
  std::optional<std::size_t> put_in_;
  std::optional<std::size_t> pairs_;
  std::optional<std::size_t> triples_;
  std::vector<bool> is_used_;  // by column of parts: whether a row has a part there
  bool is_proved_ = false;     // some row names the parts that are put in
  std::size_t largest_ = 0;    // the most parts of a row: more may have fitted then
  FirstNoted open_;            // cells without a value, in rows with results of a model
  std::vector<Doubt> doubts_;
  // Where nothing says what was put in: by line, the number of new pairs, and an empty cell.
  struct Figure {
    std::uint64_t pairs = 0;
    std::vector<std::pair<std::size_t, Field>> empty;
  };
  std::map<std::uint64_t, Figure> figures_;
  EmptiedCells emptied_;
};

}  // namespace changeover
