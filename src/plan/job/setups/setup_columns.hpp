// The columns of a run sheet or of a list of tests, by their heads: as they were written, or as
// people rename them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/plan/job.hpp"
#include "core/contains.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/part_finder.hpp"

namespace changeover {

/// The fields of a row that hold a set-up, and what is beside it.
struct SetupColumns {
  std::optional<std::size_t> list;      // all parts in one field
  std::vector<std::size_t> slots;       // one part in each; increasing
  std::vector<std::size_t> parameters;  // for a model, by slot: the one whose values it has
  std::optional<std::size_t> step;
  std::optional<std::size_t> result;
  std::optional<std::size_t> notes;
  std::optional<std::size_t> bench;
  bool header = false;  // the first row is a header

  // In place of a parameter: the model has that of the column no more.
  static constexpr std::size_t gone = ~std::size_t{0};

  [[nodiscard]] bool is_gone(std::size_t slot) const {
    return slot < parameters.size() && parameters[slot] == gone;
  }
  [[nodiscard]] bool have(std::size_t column) const {
    return contains(slots, column) || column == list || column == step || column == result ||
           column == notes || column == bench;
  }

  struct Lost {
    std::size_t parameter = 0;
    std::size_t column = 0;
  };
  std::optional<Lost> lost;  // a parameter without a column, and one of ours with its name
};

/// The columns below this row, if it is a header. Words of heads that are names of parts count only
/// if the row is certainly a header.
[[nodiscard]] SetupColumns setup_columns(const Row& first, const PartFinder& finder, bool is_given);

/// The places of a row: for a model, each parameter is a place.
[[nodiscard]] std::vector<DonePlace> places_of(const SetupColumns& columns, const Row& header,
                                               const PartFinder& finder);

/// The place of "slot_7", or of "slot_7 CPU"; also as people write it, "Slot 7".
[[nodiscard]] std::optional<DonePlace> place_in(std::string_view head);

/// The names of the parameters of the model that have no column.
[[nodiscard]] std::vector<std::string> parameters_without_column(const SetupColumns& columns,
                                                                 const Model& model);

/// What a column of a model calls its parameter: "OS", also of "slot_3 OS".
[[nodiscard]] std::string parameter_in(std::string_view head);

/// The heads of a table, by column; "" for a column without a head.
using Heads = std::vector<std::string>;

/// A head that the program writes on run sheets beside the places of parts, the step, the result,
/// the notes and the bench.
struct OwnHead {
  std::string_view head;
  bool is_figure = false;   ///< stands before the column of results
  bool counts_new = false;  ///< how many pairs or triples are new: no list but a run sheet has it
  bool is_planned = false;  ///< stands beside set-ups of a plan, not beside those that were done
};
/// That of these words, letter by letter; null for other heads.
[[nodiscard]] const OwnHead* own_head(std::string_view head);
/// The same in any case and with blanks: "New pairs".
[[nodiscard]] const OwnHead* own_head_meant(std::string_view head);

/// Whether a run sheet has a column of this name, in whatever case, so that a parameter of the name
/// is headed "slot_1 Step" there.
[[nodiscard]] bool is_head_beside_values(std::string_view name);

/// What a table is, by its heads alone.
enum class SheetShape {
  other,
  steps,  ///< what is to be done: steps with their set-ups, and figures or what is put in
  done    ///< tests with their set-ups and results, without figures
};
[[nodiscard]] SheetShape shape_of(const Heads& heads);

/// The column of results: that called "result", else the one whose head means it ("Ergebnis",
/// "Result (pass/fail)"), else the one that follows the figures of a step, where it was written.
/// `taken` are columns that have another meaning.
[[nodiscard]] std::optional<std::size_t> result_column(const Heads& heads,
                                                       const std::vector<bool>& taken = {});

/// The column with the numbers of the steps.
[[nodiscard]] std::optional<std::size_t> step_column(const Heads& heads,
                                                     const std::vector<bool>& taken = {});

/// The most rows of one field, as titles are, that may stand above a header.
inline constexpr std::size_t most_titles = 10;

}  // namespace changeover
