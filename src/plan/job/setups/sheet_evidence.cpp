#include "plan/job/setups/sheet_evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/contains.hpp"
#include "core/each.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/write/csv_cell.hpp"
#include "plan/job/parts/heading_words.hpp"

namespace changeover {
namespace {

constexpr std::string_view put_it_back =
    "a column of parts is missing or empty: put it back, with its head";

std::optional<std::size_t> column_headed(const Row& header, std::string_view word) {
  const auto found = std::ranges::find_if(
      header, [&](const Field& field) { return lower_case(field.text) == word; });
  return found == header.end() ? std::nullopt
                               : std::optional(static_cast<std::size_t>(found - header.begin()));
}

// What is chosen of n, 2 or 3; rows have few fields.
std::uint64_t sets_of(std::uint64_t n, std::uint64_t of) {
  const std::uint64_t pairs = n < 2 ? 0 : n * (n - 1) / 2;
  return of == 2 ? pairs : n < 3 ? 0 : pairs * (n - 2) / 3;
}

// The first number from 1 on that none of these places has, if one with a higher number follows.
std::optional<std::uint64_t> gap_in_numbers(const std::vector<DonePlace>& places) {
  std::vector<std::uint64_t> numbers = each_of<std::uint64_t>(places, &DonePlace::number);
  std::ranges::sort(numbers);
  std::uint64_t next = 1;
  for (const std::uint64_t number : numbers) {
    if (number > next) {
      return next;
    }
    next = number == next ? next + 1 : next;
  }
  return std::nullopt;
}

// Whether a row has something in a place: a part, one that is gone, or the value without a name.
bool is_there(const DoneRow& row, std::size_t place) {
  return !row.written[place].empty() || row.in_place[place];
}

// A column before the figures of a model's sheet that is taken for another one than of a parameter.
std::string_view head_of_another(const Row& header, const SetupColumns& columns,
                                 std::optional<std::size_t> figures) {
  for (std::size_t i = 0; i < figures.value_or(0) && !columns.parameters.empty(); ++i) {
    const std::string& head = header[i].text;
    const OwnHead* const own = own_head_meant(head);
    const bool is_so = own != nullptr ? !own->is_planned || own->is_figure
                                      : heads_results(head) || heads_occasions(head);
    if (!columns.have(i) && is_so) {
      return head;
    }
  }
  return {};
}

bool is_figure_of_pairs(const std::string& text) {
  constexpr std::size_t most_digits = 18;
  return !text.empty() && text.size() <= most_digits && std::ranges::all_of(text, is_digit);
}

}  // namespace

SheetEvidence::SheetEvidence(const Row& header, const SetupColumns& columns,
                             const RowReader& reader, const PartFinder& finder, std::uint64_t room)
    : header_(&header),
      columns_(&columns),
      reader_(&reader),
      finder_(&finder),
      room_(room == ~std::uint64_t{0} ? 0 : std::min<std::uint64_t>(room, finder.size())),
      pairs_(column_headed(header, "new_pairs")),
      triples_(column_headed(header, "new_triples")),
      is_used_(columns.slots.size()) {
  if (!columns.parameters.empty()) {
    put_in_ = column_headed(header, "set");
  } else {
    take_out_ = column_headed(header, "take_out");
    put_in_ = column_headed(header, "put_in");
  }
  for (auto* column : {&take_out_, &put_in_, &pairs_, &triples_}) {
    if (*column && contains(columns.slots, **column)) {
      column->reset();
    }
  }
}

// The parts that a list in one field names; what is no part is nothing here.
Block SheetEvidence::parts_in(const Row& row, std::optional<std::size_t> column,
                              const FindPart& find) const {
  Block parts;
  if (!column || *column >= row.size() || row[*column].text.empty()) {
    return parts;
  }
  const std::string& text = row[*column].text;
  try {
    for (const Field& word :
         split_row(reader_->is_workbook() ? std::string_view(text) : csv_text(text))) {
      if (const auto part = find(word.text)) {
        parts.push_back(*part);
      }
    }
  } catch (const BadInput&) {
    parts.clear();  // a remark of the user
  }
  return parts;
}

// The same if all that it names are parts; nothing without such a column.
std::optional<Block> SheetEvidence::all_parts_in(const Row& row, std::optional<std::size_t> column,
                                                 const FindPart& find) const {
  if (!column) {
    return std::nullopt;
  }
  bool are_parts = true;
  const Block parts = parts_in(row, column, [&](const std::string& word) {
    const auto part = find(word);
    are_parts = are_parts && part.has_value();
    return part;
  });
  const bool says_some = *column < row.size() && !row[*column].text.empty();
  return are_parts && parts.empty() != says_some ? std::optional(parts) : std::nullopt;
}

// More new pairs than there are pairs in the set-up.
void SheetEvidence::doubt_figures(const Row& row, const DoneRow& done, Doubt& doubt) const {
  std::uint64_t there = 0;
  for (std::size_t i = 0; i < done.written.size(); ++i) {
    there += is_there(done, i) ? 1U : 0U;
  }
  const auto look = [&](std::optional<std::size_t> column, std::uint64_t of,
                        std::string_view what) {
    if (!column || *column >= row.size() || !is_figure_of_pairs(row[*column].text) ||
        std::stoull(row[*column].text) <= sets_of(there, of)) {
      return;
    }
    doubt.is_certain = true;
    doubt.at = row[*column];
    doubt.what = fmt::format("{} new {}, but the {} here have only {}", row[*column].text, what,
                             count_of(there, "part"), sets_of(there, of));
  };
  look(pairs_, 2, "pairs");
  look(triples_, 3, "triples");
}

void SheetEvidence::take(const Row& row, const DoneRow& done, const FindPart& find) {
  largest_ = std::max(largest_, done.setup.size() + done.gone.size());
  std::vector<Field> cells;
  for (std::size_t i = 0; i < columns_->slots.size() && columns_->slots[i] < row.size(); ++i) {
    cells.push_back(Field{.text = {}, .offset = row[columns_->slots[i]].offset});
  }
  emptied_.take(
      done, cells,
      {.out = all_parts_in(row, take_out_, find), .in = all_parts_in(row, put_in_, find)});
  Doubt doubt{.line = done.line, .at = {}, .what = {}, .put_in = {}, .empty = {}};
  for (std::size_t i = 0; i < done.written.size(); ++i) {
    if (!is_there(done, i) && !columns_->is_gone(i)) {
      doubt.empty.push_back(i);
    } else {
      is_used_[i] = true;
    }
  }
  if (!columns_->parameters.empty() && !doubt.empty.empty() && !done.result.empty()) {
    const std::size_t at = columns_->slots[doubt.empty.front()];
    open_.add([&] {
      return reader_->place(at < row.size() ? row[at] : row.back()) + ": no value is here";
    });
  }
  doubt_figures(row, done, doubt);
  if (!put_in_ && columns_->parameters.empty() && pairs_ && *pairs_ < row.size() &&
      done.gone.empty() && !doubt.empty.empty() && is_figure_of_pairs(row[*pairs_].text)) {
    Figure figure{.pairs = std::stoull(row[*pairs_].text), .empty = {}};
    for (const std::size_t i : doubt.empty) {
      const std::size_t at = columns_->slots[i];
      figure.empty.emplace_back(i, at < row.size() ? row[at] : row.back());
    }
    figures_.emplace(done.line, std::move(figure));
  }
  doubt.put_in = parts_in(row, put_in_, find);
  is_proved_ = is_proved_ || !doubt.put_in.empty();
  const auto lost =
      std::ranges::find_if(doubt.put_in, [&](Element x) { return !contains(done.setup, x); });
  if (lost != doubt.put_in.end()) {
    doubt.keeps_old = std::ranges::any_of(parts_in(row, take_out_, find),
                                          [&](Element x) { return contains(done.setup, x); });
    doubt.at = row[*put_in_];
    doubt.what = fmt::format("{} is put in here, but no column of parts has it",
                             shown(finder_->name(*lost)));
  }
  if (!doubt.what.empty()) {
    doubts_.push_back(std::move(doubt));
  }
}

// Whether nothing but a missing column explains a row: it has no part that the sheet did not plan
// there.
bool SheetEvidence::is_unexplained(const Doubt& doubt, const DoneList& list, std::size_t at) const {
  const DoneRow& here = list.rows[at];
  if (doubt.put_in.empty() || doubt.keeps_old || !here.gone.empty()) {
    return false;
  }
  while (at-- > 0) {
    const DoneRow& before = list.rows[at];
    if (before.bench == here.bench) {
      return std::ranges::all_of(here.setup, [&](Element x) {
        return contains(before.setup, x) || contains(doubt.put_in, x);
      });
    }
  }
  return doubt.put_in.size() > here.setup.size();
}

// More new pairs than the parts here have that no test before had: an empty cell had a part. Copies
// of a part are one kind.
void SheetEvidence::judge_figures(DoneList& list) const {
  if (figures_.empty()) {
    return;
  }
  std::map<std::string, std::size_t> kinds;
  std::vector<std::size_t> kind_of;
  for (std::size_t x = 0; x < finder_->size(); ++x) {
    const std::string& name = finder_->name(static_cast<Element>(x));
    const std::size_t mark = name.rfind(" #");
    const bool is_copy = mark != std::string::npos && finder_->is_name(name.substr(0, mark));
    kind_of.push_back(
        kinds.emplace(is_copy ? name.substr(0, mark) : name, kinds.size()).first->second);
  }
  const bool has_results = list.has_results();
  std::set<std::pair<std::string, std::uint64_t>> seen;                      // bench and step
  std::map<std::string, std::set<std::pair<std::size_t, std::size_t>>> met;  // by bench
  FirstNoted lacking;
  for (const DoneRow& row : list.rows) {
    if (columns_->step && (!row.step || !seen.emplace(row.bench, *row.step).second)) {
      continue;  // an own test was not planned, and a copy adds nothing
    }
    auto& before = met[row.bench];
    if (!columns_->step) {
      before.clear();  // the order is not known
    }
    std::uint64_t added = 0;
    for (const Element x : row.setup) {
      for (const Element y : row.setup) {
        const auto pair = std::make_pair(kind_of[x], kind_of[y]);
        added += pair.first < pair.second && before.insert(pair).second ? 1U : 0U;
      }
    }
    const auto figure = figures_.find(row.line);
    if (figure == figures_.end() || figure->second.pairs <= added ||
        (has_results && row.result.empty()) || result_of(row.result) == TestResult::not_run) {
      continue;
    }
    const auto& cells = figure->second.empty;
    const auto cell =
        std::ranges::find_if(cells, [&](const auto& each) { return is_used_[each.first]; });
    if (cell == cells.end()) {
      continue;
    }
    lacking.add([&] {
      return fmt::format(
          "{}: the cell is empty, and the parts here have only {} of the {} new pairs",
          reader_->place(cell->second), added, figure->second.pairs);
    });
  }
  if (lacking) {
    list.notes.push_back(lacking.said("other row") +
                         "; write the part that was there: what was tested with it does not count");
  }
}

// Heads of places whose numbers have a gap, and a list that has too few of them.
void SheetEvidence::judge_heads(DoneList& list) const {
  const auto gap = gap_in_numbers(list.places);
  const bool has_slots =
      std::ranges::any_of(list.places, [](const DonePlace& place) { return !place.slot.empty(); });
  if (gap) {
    std::size_t next = 0;  // the lowest one above the gap
    for (std::size_t i = 1; i < list.places.size(); ++i) {
      const std::uint64_t number = list.places[i].number;
      if (number > *gap && (list.places[next].number < *gap || number < list.places[next].number)) {
        next = i;
      }
    }
    const Field& head = (*header_)[columns_->slots[next]];
    // Slots that there are no more may have left one; what is put in is then all there.
    if (!has_slots && !is_proved_) {
      reader_->fail(head,
                    fmt::format("a column {}, but none is called slot_{}; put that column back, or "
                                "number the columns of parts from slot_1 on",
                                shown(head.text), *gap));
    }
    list.notes.push_back(
        fmt::format("{}: no column is called slot_{}; if it was deleted, put it back: its parts do "
                    "not count",
                    reader_->place(head), *gap));
  }
  const bool is_planned =
      shape_of(each_of<std::string>(*header_, &Field::text)) == SheetShape::steps;
  const bool has_all_places = is_planned && !put_in_ && !columns_->bench && !list.rows.empty();
  for (std::size_t i = 0; i < is_used_.size() && has_all_places; ++i) {
    if (!is_used_[i]) {
      const Field& head = (*header_)[columns_->slots[i]];
      list.notes.push_back(fmt::format(
          "{}: no row has a part in the column {}; if it was emptied, fill it in: its parts do not "
          "count",
          reader_->place(head), shown(head.text)));
    }
  }
  if (!gap && !has_slots && !put_in_ && columns_->slots.size() < room_) {
    list.notes.push_back(
        fmt::format("{}: {} of parts, and {} fit at once; if a column is missing, put it back",
                    reader_->place((*header_)[columns_->slots.back()]),
                    count_of(columns_->slots.size(), "column"), room_));
  }
}

// Every test of a model has a value of each parameter.
void SheetEvidence::judge_parameters(DoneList& list) const {
  const std::vector<std::string> without =
      parameters_without_column(*columns_, finder_->model()->model());
  if (!without.empty()) {
    list.notes.push_back(fmt::format(
        "{}: no column has the values of {}, whose pairs do not count; add one if they were set",
        reader_->place((*header_)[columns_->slots.front()]), joined(without, shown)));
  }
  if (open_) {
    list.notes.push_back(open_.said("other row") +
                         "; what was tested with it does not count: write it if it was set");
  }
}

void SheetEvidence::judge(DoneList& list) const {
  const Doubt* some = nullptr;
  std::uint64_t others = 0;
  const bool has_results = list.has_results();
  std::map<std::uint64_t, std::size_t> by_line;
  for (std::size_t i = 0; i < list.rows.size() && !doubts_.empty(); ++i) {
    by_line.emplace(list.rows[i].line, i);
  }
  for (const Doubt& doubt : doubts_) {
    const std::size_t at = by_line.at(doubt.line);
    const bool is_full =
        std::ranges::none_of(doubt.empty, [&](std::size_t i) { return is_used_[i]; });
    if (is_full && (doubt.is_certain || is_unexplained(doubt, list, at))) {
      const std::string_view other =
          head_of_another(*header_, *columns_, pairs_ ? pairs_ : triples_);
      const std::string headed =
          other.empty()
              ? ""
              : fmt::format(
                    "; if {} is a parameter that the model had, head it {}", shown(other),
                    shown(fmt::format("slot_{} {}", columns_->parameters.size() + 1, other)));
      reader_->fail(doubt.at, fmt::format("{}; {}{}", doubt.what, put_it_back, headed));
    }
    const bool counts = !has_results || !list.rows[at].result.empty();
    const bool is_changed = doubt.keeps_old || !list.rows[at].gone.empty();  // by the user
    const bool is_short = list.rows[at].setup.size() < std::max<std::size_t>(room_, largest_);
    if (counts && (!is_full || (!is_changed && is_short))) {
      others += some == nullptr ? 0U : 1U;
      some = some == nullptr ? &doubt : some;
    }
  }
  emptied_.judge(list, *finder_, *reader_);
  judge_figures(list);
  if (some != nullptr) {
    list.notes.push_back(fmt::format(
        "{}: {}{}; what a test lacks does not count with it: write it in its column if it was "
        "there",
        reader_->place(some->at), some->what,
        others == 0 ? "" : fmt::format(", as in {}", count_of(others, "other row"))));
  }
  columns_->parameters.empty() ? judge_heads(list) : judge_parameters(list);
}

}  // namespace changeover
