#include "changeover/plan/job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <unordered_set>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/contains.hpp"
#include "core/each.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/scan/place.hpp"
#include "io/scan/row_reader.hpp"
#include "io/write/csv_cell.hpp"
#include "plan/job/part_finder.hpp"
#include "plan/job/parts/heading_words.hpp"
#include "plan/job/setups/extra_rows.hpp"
#include "plan/job/setups/first_noted.hpp"
#include "plan/job/setups/gone_parameters.hpp"
#include "plan/job/setups/hidden_tests.hpp"
#include "plan/job/setups/other_results.hpp"
#include "plan/job/setups/setup_columns.hpp"
#include "plan/job/setups/setup_list.hpp"
#include "plan/job/setups/sheet_evidence.hpp"
#include "plan/job/setups/step_numbers.hpp"

namespace changeover {
namespace {

// Whether a column means something.
bool is_read(const Row& header, std::size_t i, const SetupColumns& columns) {
  const std::string& head = header[i].text;
  const OwnHead* const own = own_head(lower_case(head));
  return columns.have(i) || heads_results(head) || heads_steps(head) ||
         (own != nullptr && (own->is_planned || own->counts_new));
}

// Two columns with the same name cannot be told apart. Those that are of the user's own need not
// be, whatever their case.
void check_header(const Row& header, const SetupColumns& columns, const RowReader& reader) {
  std::map<std::string, std::size_t> seen;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const std::string& head = header[i].text;
    const auto [before, is_new] = seen.emplace(lower_case(head), i);
    if (head.empty() || is_new) {
      continue;
    }
    const std::string& other = header[before->second].text;
    const bool is_ours = other == head && own_head(head) != nullptr;
    if (is_ours || is_read(header, i, columns) || is_read(header, before->second, columns)) {
      const std::string both =
          other == head ? shown(head) : fmt::format("{} and {}", shown(other), shown(head));
      reader.fail(header[i], fmt::format("two columns are called {}; rename or remove one", both));
    }
  }
}

// Checks a row below a header: not the header again, not cut off before its last part, and no more
// fields than the header.
void check_shape(const Row& row, const Row& header, const SetupColumns& columns,
                 const RowReader& reader) {
  const auto same = [](const Field& a, const Field& b) { return a.text == b.text; };
  if (std::ranges::equal(row, header, same)) {
    reader.fail(row.front(), "a second header; give one sheet at a time");
  }
  if (!columns.slots.empty() && row.size() <= columns.slots.back()) {
    reader.fail(row.back(), "the row ends before its last slot; it is cut off, complete it");
  }
  for (std::size_t i = header.size(); i < row.size(); ++i) {
    if (!row[i].text.empty() &&
        !reader.is_workbook()) {  // in a workbook that is a note beside the table
      reader.fail(row[i],
                  fmt::format("more fields than the {} of the header; quote those with a comma",
                              header.size()));
    }
  }
}

// Cells side by side that were merged keep one value: the others are lost.
void check_merged(const Row& row, const SetupColumns& columns, const RowReader& reader) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto range =
        columns.have(i) && i != columns.notes ? reader.merged_with_others(row[i]) : std::nullopt;
    if (range) {
      reader.fail(row[i], fmt::format("the cells {} are merged, so this one is empty; separate "
                                      "them, and write what belongs here",
                                      *range));
    }
  }
}

// Replaces a value in the column of a parameter by the name of its part; an unknown value by what
// its name would be.
void name_value(const PartFinder& finder, std::size_t parameter, const std::string& text,
                Field& field) {
  if (const auto part = finder.model()->value(parameter, text)) {
    field.text = finder.name(*part);
  } else if (!text.empty()) {
    field.text = fmt::format("{}: {}", finder.model()->model().parameters[parameter].name,
                             finder.model()->without_parameter(parameter, text));
  }
}

class SetupReader {
 public:
  SetupReader(Input& input, const PartNames& names, std::uint64_t at_once, bool forgiving)
      : reader_(input, {.is_no_comment =
                            [this](const Row& row) {
                              return is_begun_ ? is_test_all_the_same(row)
                                               : setup_columns(row, finder_, false).header;
                            }}),
        finder_(names, numbers_in(reader_)),
        at_once_(at_once),
        forgiving_(forgiving),
        names_only_(forgiving && finder_.has_number_as_name()) {}

  DoneList read() {
    std::vector<Row> above;  // the first row, and those that follow a title
    for (std::optional<Row> row = reader_.next(); row; row = reader_.next()) {
      finder_.restore_blanks(*row);
      if (is_begun_) {
        take(*std::move(row));
        continue;
      }
      is_begun_ = is_header(*row);
      if (is_begun_) {
        continue;  // what is above it are titles
      }
      const bool may_be_title = is_title(*row);
      above.push_back(*std::move(row));
      if (!may_be_title || above.size() > most_titles) {
        is_begun_ = true;
        take_all_of(above);
      }
    }
    if (!is_begun_) {
      take_all_of(above);
    }
    if (columns_.header && forgiving_) {
      if (merged_ && !list_.has_results()) {
        throw BadInput(merged_->what());
      }
      extra_rows_.say(list_);
      say_what_is_a_comment();
      say_what_was_taken();
      gone_parameters_.say(reader_, list_);
      steps_.put_in_order(list_, header_, columns_, reader_);
      other_results_.say(list_, header_, columns_, reader_);
      if (evidence_) {
        evidence_->judge(list_);
      }
    }
    return std::move(list_);
  }

 private:
  // A row of one field that is no part, as it may stand above a header.
  [[nodiscard]] bool is_title(const Row& row) const {
    const auto is_filled = [](const Field& field) { return !field.text.empty(); };
    const auto filled = std::ranges::find_if(row, is_filled);
    return !reader_.is_given() && std::ranges::count_if(row, is_filled) == 1 &&
           !are_parts(filled->text);
  }

  // Whether a text is a part, or parts between blanks.
  [[nodiscard]] bool are_parts(const std::string& text) const {
    if (finder_.find(text)) {
      return true;
    }
    std::size_t begin = 0;
    while (begin < text.size()) {
      const std::size_t end = std::min(text.find(' ', begin), text.size());
      if (end > begin && !finder_.find(text.substr(begin, end - begin))) {
        return false;
      }
      begin = end + 1;
    }
    return true;
  }

  void take_all_of(std::vector<Row>& rows) {
    for (Row& row : rows) {
      take(std::move(row));
    }
  }

  // Whether a line that begins with # is a test below the heads of a run sheet: the first column
  // may be one of tickets, as #40. A part that was commented out is kept for a note.
  bool is_test_all_the_same(const Row& row) {
    const auto last = columns_.slots.empty() ? columns_.list : std::optional(columns_.slots.back());
    if (!forgiving_ || !columns_.header || !last || row.size() <= *last ||
        shape_of(each_of<std::string>(header_, &Field::text)) == SheetShape::other) {
      return false;
    }
    const auto names_part = [&](std::size_t at) { return is_part_in(at, row[at].text); };
    const TestResult said = columns_.result && *columns_.result < row.size()
                                ? result_of(row[*columns_.result].text)
                                : TestResult::none;
    const bool has_result = said == TestResult::pass || said == TestResult::fail;
    const bool is_test = has_result || std::ranges::any_of(columns_.slots, names_part) ||
                         (columns_.list && names_part(*columns_.list));
    const bool begins_with_part = *last == 0 || contains(columns_.slots, std::size_t{0});
    if (is_test && begins_with_part && !names_part(0) && is_part_in(0, row[0].text.substr(1))) {
      comments_.add([&] {
        const Field begin{.text = {}, .offset = 0, .line = row.front().line};
        return reader_.place(begin) + ": the row begins with #, so it is a comment";
      });
      return false;
    }
    return is_test;
  }

  // Whether a text is a part in this column, or begins with one where it has all of them.
  [[nodiscard]] bool is_part_in(std::size_t column, const std::string& text) const {
    const auto place = std::ranges::find(columns_.slots, column);
    const auto at = static_cast<std::size_t>(place - columns_.slots.begin());
    if (columns_.is_gone(at)) {
      return false;
    }
    if (at < columns_.parameters.size()) {
      return finder_.model()->value(columns_.parameters[at], text_of(text)).has_value();
    }
    return !text.empty() &&
           find_cell(column == columns_.list ? text.substr(0, text.find(',')) : text).has_value();
  }

  void say_what_is_a_comment() {
    if (comments_) {
      list_.notes.push_back(comments_.said("other row") + "; remove the # if the test was run");
    }
  }

  // A column of results that is not called so, and results that are where none is looked for.
  void say_what_was_taken() {
    if (columns_.result && lower_case(header_[*columns_.result].text) != "result") {
      const Field& head = header_[*columns_.result];
      list_.notes.push_back(fmt::format("{}: the results are those of the column {}",
                                        reader_.place(head), shown(head.text)));
    }
    const auto is_result = [](const DoneRow& row) {
      const TestResult said = result_of(row.notes);
      return said == TestResult::pass || said == TestResult::fail;
    };
    const auto found = std::ranges::find_if(list_.rows, is_result);
    if (columns_.notes && !list_.has_results() && found != list_.rows.end()) {
      list_.notes.push_back(
          fmt::format("{}: {} is among the notes, which are not results; write it in the column of "
                      "results",
                      reader_.place(header_[*columns_.notes]), shown(found->notes)));
    }
  }

  // Whether the first row is a header, which is then kept.
  bool is_header(const Row& row) {
    if (reader_.is_given() && row.front().line != 0) {
      return false;
    }
    columns_ = setup_columns(row, finder_, reader_.is_given());
    if (columns_.header) {
      header_ = row;
      // "# step" is no comment.
      std::string& first = header_.front().text;
      if (first.starts_with('#') && first.size() > 1 && !reader_.is_workbook()) {
        first.erase(0, std::min(first.find_first_not_of("# "), first.size()));
        columns_ = setup_columns(header_, finder_, false);
      }
      check_header(header_, columns_, reader_);
      check_parameters();
      if (forgiving_ && !reader_.is_given()) {
        gone_parameters_.find(header_, finder_, reader_, columns_);
      } else if (!reader_.is_given()) {
        note_unread_columns(header_, finder_, reader_, columns_, list_.notes);
      }
      list_.places = places_of(columns_, header_, finder_);
      other_results_.find(header_, columns_);
      if (forgiving_ && !reader_.is_given() && !columns_.slots.empty()) {
        evidence_.emplace(header_, columns_, reader_, finder_, at_once_);
      }
    }
    return columns_.header;
  }

  // The column step is none of the parameter Step, which has its own.
  void check_parameters() const {
    if (columns_.lost) {
      const std::size_t p = columns_.lost->parameter;
      const std::string& name = finder_.model()->model().parameters[p].name;
      reader_.fail(
          header_[columns_.lost->column],
          fmt::format("the parameter {} has no column {}, and this one is not it; put that "
                      "column back",
                      shown(name), shown(fmt::format("slot_{} {}", p + 1, name))));
    }
  }

  void take(Row row) {
    if (columns_.header) {
      if (reader_.is_workbook() && row.size() < header_.size()) {
        row.resize(header_.size(), Field{.text = {}, .line = row.front().line});
      }
      if (is_extra(row)) {
        return;
      }
      check_shape(row, header_, columns_, reader_);
      look_at_merged(row);
    }
    const std::size_t place = row.front().offset;
    DoneRow done{.setup = {}, .line = row.front().line};
    take_beside(row, done);
    // Without any parts, also removed ones.
    bool is_empty = false;
    if (!columns_.header) {
      take_all(row, done);
    } else if (!columns_.slots.empty()) {
      is_empty = take_slots(row, done);
    } else if (columns_.list && *columns_.list < row.size()) {
      is_empty = take_field(row[*columns_.list], done);
    } else {
      is_empty = true;
    }
    if (is_empty) {
      reader_.fail(place, "a row without a set-up; remove it or complete it");
    }
    // More may have fitted when a test was done.
    if (done.setup.size() > at_once_ && !forgiving_) {
      reader_.fail(place, fmt::format("{} parts, but only {} fit at once; remove some",
                                      done.setup.size(), at_once_));
    }
    if (evidence_) {
      evidence_->take(row, done, [this](const std::string& name) {
        return finder_.find_cell(name, name, names_only_);
      });
    }
    list_.rows.push_back(std::move(done));
  }

  // Cells that were merged in a row that was not run do no harm, unless no row has a result.
  void look_at_merged(const Row& row) {
    try {
      check_merged(row, columns_, reader_);
    } catch (const BadInput& fault) {
      const bool has_result = !columns_.result || !row[*columns_.result].text.empty() ||
                              reader_.merged_with_others(row[*columns_.result]).has_value();
      if (!forgiving_ || has_result) {
        throw;
      }
      merged_ = merged_.value_or(fault);
    }
  }

  // Whether a row is no test. One that another column of results has something to say of is none
  // that could be skipped.
  bool is_extra(const Row& row) {
    if (!forgiving_ || reader_.is_given()) {
      return false;
    }
    const auto kind = extra_rows_.take(row, header_, columns_, finder_, reader_);
    if (kind == ExtraRows::Kind::other) {
      other_results_.check(row, DoneRow{}, header_, columns_, reader_);
    }
    return kind != ExtraRows::Kind::test;
  }

  // The columns beside the set-up.
  void take_beside(const Row& row, DoneRow& done) {
    const auto text_in = [&](const std::optional<std::size_t>& column) {
      return column && *column < row.size() ? text_of(row[*column].text) : std::string();
    };
    done.notes = text_in(columns_.notes);
    done.bench = text_in(columns_.bench);
    done.result = text_in(columns_.result);
    if (forgiving_ && columns_.header) {
      gone_parameters_.look_beside(row, finder_, done);
      done.step = steps_.take(row, columns_, text_in(columns_.step), reader_);
      other_results_.check(row, done, header_, columns_, reader_);
    }
    if (result_of(done.result) == TestResult::unread) {
      done.unread = reader_.place(row[*columns_.result]);
    }
  }

  // A row without a header: all fields are parts.
  void take_all(Row& row, DoneRow& done) {
    const bool separated = row.size() > 1;
    split_at_blanks(row, finder_, reader_);
    for (const Field& field : row) {
      keep_if_hiding(finder_, field.text, finder_.find(field.text), done);
    }
    if (forgiving_ && separated && finder_.some_gone(row, reader_, &list_.gone)) {
      leave_out(row, done, [&](const Field& field) { return finder_.may_be_gone(field.text); });
    }
    done.setup = find_parts(
        finder_, row, [&](const std::string& word) { return finder_.find(word); },
        [&](const Field& field, const std::string& what) { reader_.fail(field, what); });
  }

  // A part in each column of a slot. Returns whether all are empty.
  bool take_slots(Row& row, DoneRow& done) {
    Row slots;
    for (std::size_t c = 0; c < columns_.slots.size() && columns_.slots[c] < row.size(); ++c) {
      Field& slot = slots.emplace_back(std::move(row[columns_.slots[c]]));
      const std::string text = text_of(slot.text);
      if (columns_.is_gone(c)) {
        gone_parameters_.take(c, text);
        keep_if_hiding(finder_, text, std::nullopt, done);
        done.lacks = done.lacks || (gone_parameters_.are_certain() && !text.empty());
        done.written.push_back(text);
        slot.text.clear();
      } else if (c < columns_.parameters.size()) {
        const std::size_t parameter = columns_.parameters[c];
        done.written.emplace_back(finder_.model()->without_parameter(parameter, text));
        name_value(finder_, parameter, text, slot);
        keep_if_hiding(finder_, text, find_cell(slot.text), done);
      } else {
        done.written.push_back(text);
      }
      done.in_place.push_back(slot.text.empty() ? std::nullopt : find_cell(slot.text));
    }
    return take_cells(std::move(slots), done, [&](const Field& field, const std::string& what) {
      reader_.fail(field, what);
    });
  }

  // All parts in one field. Returns whether there are none.
  bool take_field(const Field& field, DoneRow& done) {
    const auto fail = [&](const Field&, const std::string& what) { reader_.fail(field, what); };
    Row parts;
    try {
      parts = split_row(field.text);
    } catch (const BadInput& fault) {
      fail(field, fault.what());
    }
    for (const Field& part : parts) {
      keep_if_hiding(finder_, part.text, find_cell(part.text), done);
    }
    return take_cells(std::move(parts), done, fail);
  }

  template <class Fail>
  bool take_cells(Row cells, DoneRow& done, Fail&& fail) {
    const bool is_empty = std::ranges::all_of(cells, [](const Field& f) { return f.text.empty(); });
    leave_out(cells, done, [&](const Field& cell) { return is_gone(cell); });
    done.setup = find_parts(
        finder_, cells, [&](const std::string& cell) { return find_cell(cell); }, fail);
    return is_empty;
  }

  // Removes the cells of parts that are gone.
  template <class IsGone>
  void leave_out(Row& cells, DoneRow& done, IsGone&& is_gone) const {
    std::erase_if(cells, [&](const Field& cell) {
      if (!is_gone(cell)) {
        return false;
      }
      done.gone.push_back(text_of(cell.text));
      return true;
    });
    done.lacks = done.lacks || !done.gone.empty();
  }

  // Whether a cell names a part that is gone, which is then listed.
  bool is_gone(const Field& cell) {
    const std::string name = text_of(cell.text);
    if (!forgiving_ || name.empty() || find_cell(cell.text)) {
      return false;
    }
    if (gone_.count(name) == 0) {
      if (finder_.is_name_in_any_case(name)) {
        return false;
      }
      gone_.insert(name);
      list_.gone.push_back(name);
    }
    return true;
  }

  [[nodiscard]] std::optional<Element> find_cell(const std::string& cell) const {
    return finder_.find_cell(cell, text_of(cell), names_only_);
  }

  // A text may have the apostrophe of csv_cell(); a workbook cell is taken as it is.
  [[nodiscard]] std::string text_of(const std::string& cell) const {
    return reader_.is_workbook() ? cell : std::string(csv_text(cell));
  }

  RowReader reader_;
  PartFinder finder_;
  std::uint64_t at_once_;
  bool forgiving_;
  bool names_only_;
  bool is_begun_ = false;  // the titles are behind
  SetupColumns columns_;
  Row header_;
  StepNumbers steps_;
  ExtraRows extra_rows_;
  OtherResults other_results_;
  GoneParameters gone_parameters_;
  std::optional<SheetEvidence> evidence_;  // of a run sheet with a column for each place
  std::unordered_set<std::string> gone_;
  std::optional<BadInput> merged_;  // the first cells merged in a row without a result
  FirstNoted comments_;             // rows with a test that was commented out
  DoneList list_;
};

}  // namespace

DoneList read_list(Input& input, const PartNames& names, std::uint64_t at_once, bool forgiving) {
  return SetupReader(input, names, at_once, forgiving).read();
}

std::vector<Block> read_setups(Input& input, const std::vector<std::string>& names,
                               std::uint64_t at_once) {
  return read_list(input, names, at_once, false).setups();
}

std::vector<Block> read_setups(Input& input, const Job& job) {
  return read_list(input, job, job.at_once, false).setups();
}

DoneList read_done(Input& input, const std::vector<std::string>& names, std::uint64_t at_once) {
  return read_list(input, names, at_once, true);
}

DoneList read_done(Input& input, const Job& job) {
  return read_list(input, job, job.at_once, true);
}

bool DoneList::has_results() const {
  return std::ranges::any_of(rows, [](const DoneRow& row) { return !row.result.empty(); });
}

std::vector<Block> DoneList::setups() const { return each_of<Block>(rows, &DoneRow::setup); }

Block parse_parts(std::string_view text, const std::vector<std::string>& names) {
  const PartFinder finder(names);
  return find_parts(
      finder, split_row(text), [&](const std::string& word) { return finder.find(word); },
      [](const Field&, const std::string& what) { throw BadInput(what); });
}

namespace {

Block parts_called(const std::vector<std::string>& words, const PartNames& names) {
  const PartFinder finder(names, PartNumbers::unless_names_are_so);
  Row row;
  for (const std::string& word : words) {
    row.push_back({.text = word});
  }
  return find_parts(
      finder, row, [&](const std::string& word) { return finder.find(word); },
      [](const Field&, const std::string& what) { throw BadInput(what); });
}

}  // namespace

Block parts_named(const std::vector<std::string>& words, const std::vector<std::string>& names) {
  return parts_called(words, names);
}

Block parts_named(const std::vector<std::string>& words, const Job& job) {
  return parts_called(words, job);
}

std::string parts_text(const Block& parts, const std::vector<std::string>& names) {
  return joined(parts, [&](const Element x) { return quoted_field(names[x]); });
}

}  // namespace changeover
