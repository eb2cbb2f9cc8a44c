#include "changeover/plan/job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <unordered_set>
#include <utility>

#include "changeover/core/error.hpp"
#include "io/scan/place.hpp"
#include "io/scan/plain_text.hpp"
#include "io/scan/row_reader.hpp"
#include "io/write/csv_cell.hpp"
#include "plan/job/cost_reader.hpp"
#include "plan/job/part_columns.hpp"
#include "plan/job/part_finder.hpp"
#include "plan/job/setup_list.hpp"

namespace changeover {
namespace {

constexpr std::size_t longest_name = 255;

// Parts with blanks between them and no separator ("1 2 3") come as one field; a part whose name has blanks does, too.
void split_at_blanks(Row& row, const PartFinder& finder, const RowReader& reader) {
  if (row.size() == 1 && (!row.front().in_quotes || reader.is_workbook()) &&
      !finder.find(row.front().text)) {
    row = at_blanks(row.front(), reader);
  }
}

// Which fields of the rows hold a set-up.
struct SetupColumns {
  std::optional<std::size_t> list;  // all parts in one field
  std::vector<std::size_t> slots;   // a part in each; increasing
  std::optional<std::size_t> result;
  bool header = false;  // the first row is one
};

// Whether "slot_7" or the like, or "slot_7 CPU".
bool is_slot(const std::string& word) {
  constexpr std::string_view prefix = "slot_";
  if (!word.starts_with(prefix)) {
    return false;
  }
  const std::size_t end = word.find_first_not_of("0123456789", prefix.size());
  return end != prefix.size() && word.size() > prefix.size() &&
         (end == std::string::npos || word[end] == ' ');
}

// A first row with such words is the header of a sheet, unless they are names of parts; then only if it
// is one beyond doubt.
SetupColumns setup_columns(const Row& first, const PartFinder& finder) {
  constexpr std::array<std::string_view, 4> of_a_sheet{"step", "take_out", "put_in", "cost_so_far"};
  const bool beyond_doubt =
      std::all_of(of_a_sheet.begin(), of_a_sheet.end(), [&](std::string_view word) {
        return std::any_of(first.begin(), first.end(),
                           [&](const Field& field) { return field.text == word; });
      });
  SetupColumns columns;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (finder.is_name(first[i].text) && !beyond_doubt) {
      continue;
    }
    if (first[i].text == "set_up") {
      columns.list = i;
    } else if (is_slot(first[i].text)) {
      columns.slots.push_back(i);
    } else if (lower(first[i].text) == "result") {
      columns.result = i;
    }
  }
  columns.header = beyond_doubt || columns.list || !columns.slots.empty();
  return columns;
}

// Nothing can be told of two columns of one name.
void check_header(const Row& header, const RowReader& reader) {
  std::set<std::string> seen;
  for (const Field& field : header) {
    if (!field.text.empty() && !seen.insert(lower(field.text)).second) {
      reader.fail(
          field, fmt::format("two columns are called {}; rename or remove one", shown(field.text)));
    }
  }
}

// A row under a header: not the header again, nor cut off before its last part, nor with more than was headed.
void check_shape(const Row& row, const Row& header, const SetupColumns& columns,
                 const RowReader& reader) {
  const auto same = [](const Field& a, const Field& b) { return a.text == b.text; };
  if (std::equal(row.begin(), row.end(), header.begin(), header.end(), same)) {
    reader.fail(row.front(), "the header again; give one sheet at a time");
  }
  if (!columns.slots.empty() && row.size() <= columns.slots.back()) {
    reader.fail(row.back(), "the row ends before its last slot; it is cut off, complete it");
  }
  for (std::size_t i = header.size(); i < row.size(); ++i) {
    if (!row[i].text.empty() && !reader.is_workbook()) {  // there it is a note beside the table
      reader.fail(row[i],
                  fmt::format("more fields than the {} of the header; quote those with a comma",
                              header.size()));
    }
  }
}

// A first row of two words that head columns, neither of which is a part in whatever case.
bool heads_pairs(const Row& row, const PartFinder& finder, const RowReader& reader) {
  return row.size() == 2 && !reader.is_given() &&
         std::all_of(row.begin(), row.end(), [&](const Field& field) {
           return heads_parts(field.text) && !finder.find(field.text) &&
                  !finder.is_name_in_any_case(field.text);
         });
}

void check_name(const RowReader& reader, const Field& name) {
  if (name.text.size() > longest_name) {
    reader.fail(name, fmt::format("a name of more than {} bytes; shorten it", longest_name));
  }
  if (const auto defect = text_defect(name.text)) {
    reader.fail(name, fmt::format("the name {}: {}", shown(name.text), *defect));
  }
  if (!name.in_quotes && name.text.find_first_of(",;") != std::string::npos) {
    reader.fail(
        name, fmt::format("{} has a separator in it, but the rows are split at {}; put the name in "
                          "quotes, or use one separator everywhere",
                          shown(name.text),
                          reader.separator() == ';'   ? "semicolons"
                          : reader.separator() == ',' ? "commas"
                                                      : "tabs"));
  }
}

}  // namespace

PartList read_parts(Input& input, Header header) {
  RowReader reader(input);
  std::vector<Row> rows;  // at most one more than there can be, and a header
  while (auto next = rows.size() < max_parts + 2 ? reader.next() : std::nullopt) {
    rows.push_back(std::move(*next));
  }
  if (rows.empty()) {
    fail(input.name(), {}, "no part is listed; write one a line");
  }
  const PartColumns columns = part_columns(rows, header, reader);
  constexpr std::size_t most_without_header = 2;
  const std::size_t fields = columns.header ? rows.front().size() : most_without_header;
  PartList parts;
  parts.note = columns.note.empty() || reader.is_given()
                   ? ""
                   : fmt::format("{}: {}", input.name(), columns.note);
  std::unordered_set<std::string> seen;
  std::unordered_set<std::string> looks;
  CostReader costs(reader);
  rows.erase(rows.begin(), rows.begin() + (columns.header ? 1 : 0));
  for (const Row& row : rows) {
    if (row.size() > fields && !columns.header) {
      reader.fail(row[fields],
                  "a third field; write a name and a change cost, or a header with a word for each "
                  "column, and quote a name with a comma");
    }
    if (row.size() > fields && !reader.is_workbook()) {  // there it is a note beside the table
      reader.fail(row[fields],
                  fmt::format("more fields than the {} of the header; quote those with "
                              "a comma",
                              fields));
    }
    if (columns.name >= row.size() || row[columns.name].text.empty()) {
      reader.fail(row.front(), "a row without a name; name the part");
    }
    const Field& name = row[columns.name];
    check_name(reader, name);
    if (!seen.insert(name.text).second) {
      reader.fail(name, fmt::format("a second part is called {}; rename one", shown(name.text)));
    }
    const std::string look = visible(name.text);
    if (look.empty()) {
      reader.fail(name, "nothing of this name can be seen; name the part");
    }
    if (!looks.insert(look).second) {
      reader.fail(name,
                  fmt::format("a second part looks like {}: the names differ in characters that "
                              "cannot be seen; rename one",
                              shown(look)));
    }
    if (parts.names.size() == max_parts) {
      reader.fail(name, fmt::format("more than {} parts; plan for fewer at a time", max_parts));
    }
    parts.names.push_back(name.text);
    parts.change_costs.emplace_back();
    if (columns.cost && *columns.cost < row.size() && !row[*columns.cost].text.empty()) {
      parts.change_costs.back() = costs.read(row[*columns.cost]);
    }
    if (columns.slot) {
      parts.slots.push_back(*columns.slot < row.size() ? row[*columns.slot].text : "");
      if (!parts.slots.back().empty()) {
        check_name(reader, row[*columns.slot]);
      }
    }
  }
  if (parts.names.empty()) {
    fail(input.name(), {}, "no part is listed; write one a line");
  }
  return parts;
}

PairSet read_pairs(Input& input, const std::vector<std::string>& names) {
  RowReader reader(input, {.blanks = true});
  const PartFinder finder(names, numbers_in(reader));
  PairSet pairs(names.size());
  bool first = true;
  while (auto row = reader.next()) {
    finder.restore_blanks(*row);
    split_at_blanks(*row, finder, reader);
    if (std::exchange(first, false) && heads_pairs(*row, finder, reader)) {
      continue;
    }
    const Block pair = find_parts(
        finder, *row, [&](const std::string& word) { return finder.find(word); },
        [&](const Field& field, const std::string& what) { reader.fail(field, what); });
    if (pair.size() != 2) {
      reader.fail(row->front(),
                  fmt::format("{} here, and a pair has two; write A,B",
                              pair.size() == 1 ? "one part stands" : "more than two stand"));
    }
    pairs.insert(pair[0], pair[1]);
  }
  return pairs;
}

PairWeights read_priorities(Input& input, const std::vector<std::string>& names) {
  RowReader reader(input, {.blanks = true});
  const PartFinder finder(names, numbers_in(reader));
  PairWeights weights;
  std::set<std::uint64_t> seen;
  const auto weight_of = [&](const Field& field) -> std::optional<Amount> {
    std::string text = field.text;
    if (reader.separator() != ',' && std::count(text.begin(), text.end(), ',') == 1) {
      text[text.find(',')] = '.';
    }
    try {
      return parse_amount(text);
    } catch (const BadInput&) {
      return std::nullopt;
    }
  };
  bool first = true;
  while (auto row = reader.next()) {
    constexpr std::size_t fields = 3;
    split_at_blanks(*row, finder, reader);
    if (row->size() != fields) {
      reader.fail(row->front(), "no pair with its weight; write A,B,5, a pair a line");
    }
    const auto weight = weight_of(row->back());
    const Row parts(row->begin(), row->end() - 1);
    if (std::exchange(first, false) && !weight && heads_pairs(parts, finder, reader)) {
      continue;
    }
    const Block pair = find_parts(
        finder, parts, [&](const std::string& word) { return finder.find(word); },
        [&](const Field& field, const std::string& what) { reader.fail(field, what); });
    if (pair.size() != 2) {
      reader.fail(row->front(), "one part stands here, and a pair has two; write A,B,5");
    }
    if (!weight) {
      reader.fail(row->back(), fmt::format("{} is no weight; write a number that is not negative, "
                                           "with at most six decimals, as in A,B,2.5",
                                           shown(row->back().text)));
    }
    if (!seen.insert(PairSet::rank(pair[0], pair[1])).second &&
        weights(pair[0], pair[1]) != *weight) {
      reader.fail(row->back(),
                  fmt::format("{} and {} weigh {} on a line before; remove one", names[pair[0]],
                              names[pair[1]], to_string(weights(pair[0], pair[1]))));
    }
    weights.set(pair[0], pair[1], *weight);
  }
  if (weights.empty()) {
    fail(input.name(), {}, "no pair is listed; write A,B,5, a pair and its weight a line");
  }
  return weights;
}

DoneList read_list(Input& input, const std::vector<std::string>& names, std::uint64_t at_once,
                   bool forgiving) {
  RowReader reader(input);
  const PartFinder finder(names, numbers_in(reader));
  DoneList list;
  std::vector<Block>& setups = list.setups;
  const bool names_only = forgiving && finder.has_number_as_name();
  SetupColumns columns;
  Row header;
  std::unordered_set<std::string> gone;
  bool first = true;
  const auto find = [&](const std::string& word) { return finder.find(word); };
  // A text may have the apostrophe of csv_cell(); a cell of a workbook is what it says.
  const auto text_of = [&](const std::string& cell) {
    return reader.is_workbook() ? cell : std::string(csv_text(cell));
  };
  const auto find_cell = [&](const std::string& cell) {
    return finder.find_cell(cell, text_of(cell), names_only);
  };
  const auto leave_out_gone = [&](Row& parts) {
    const std::size_t left_out = std::erase_if(parts, [&](const Field& field) {
      const std::string name = text_of(field.text);
      if (!forgiving || name.empty() || find_cell(field.text)) {
        return false;
      }
      if (gone.count(name) == 0) {
        if (finder.is_name_in_any_case(name)) {
          return false;
        }
        gone.insert(name);
        list.gone.push_back(name);
      }
      return true;
    });
    list.lacks.back() = left_out > 0;
  };
  const auto fail = [&](const Field& field, const std::string& what) { reader.fail(field, what); };
  while (auto next = reader.next()) {
    Row& row = *next;
    finder.restore_blanks(row);
    if (std::exchange(first, false) && (!reader.is_given() || row.front().line == 0)) {
      columns = setup_columns(row, finder);
      if (columns.header) {
        header = row;
        check_header(header, reader);
        continue;
      }
    }
    if (columns.header) {
      check_shape(row, header, columns, reader);
    }
    const std::size_t place = row.front().offset;
    bool is_empty = false;  // of any parts, and not only of those that are still there
    list.results.emplace_back();
    list.lacks.push_back(false);
    list.lines.push_back(row.front().line);
    list.unread.emplace_back();
    if (columns.result && *columns.result < row.size()) {
      const Field& result = row[*columns.result];
      list.results.back() = text_of(result.text);
      if (result_of(list.results.back()) == TestResult::unread) {
        list.unread.back() = reader.place(result);
      }
    }
    if (!columns.header) {
      split_at_blanks(row, finder, reader);
      setups.push_back(find_parts(finder, row, find, fail));
    } else if (!columns.slots.empty()) {
      Row slots;
      for (const std::size_t i : columns.slots) {
        if (i < row.size()) {
          slots.push_back(std::move(row[i]));
        }
      }
      is_empty =
          std::all_of(slots.begin(), slots.end(), [](const Field& f) { return f.text.empty(); });
      leave_out_gone(slots);
      setups.push_back(find_parts(finder, slots, find_cell, fail));
    } else if (columns.list && *columns.list < row.size()) {  // the parts in one field
      const Field& field = row[*columns.list];
      const auto fail_in_list = [&](const Field&, const std::string& what) { fail(field, what); };
      Row parts;
      try {
        parts = split_row(field.text);
      } catch (const BadInput& fault) {
        fail(field, fault.what());
      }
      is_empty =
          std::all_of(parts.begin(), parts.end(), [](const Field& f) { return f.text.empty(); });
      leave_out_gone(parts);
      setups.push_back(find_parts(finder, parts, find_cell, fail_in_list));
    } else {
      setups.emplace_back();
      is_empty = true;
    }
    if (columns.header && is_empty) {
      reader.fail(place, "a row without a set-up; remove it or complete it");
    }
    if (setups.back().size() > at_once) {
      reader.fail(place, fmt::format("{} parts stand here, but only {} fit at once",
                                     setups.back().size(), at_once));
    }
  }
  return list;
}

std::vector<Block> read_setups(Input& input, const std::vector<std::string>& names,
                               std::uint64_t at_once) {
  return read_list(input, names, at_once, false).setups;
}

DoneList read_done(Input& input, const std::vector<std::string>& names, std::uint64_t at_once) {
  return read_list(input, names, at_once, true);
}

bool DoneList::has_results() const {
  return std::any_of(results.begin(), results.end(),
                     [](const std::string& result) { return !result.empty(); });
}

Block parse_parts(std::string_view text, const std::vector<std::string>& names) {
  const PartFinder finder(names);
  return find_parts(
      finder, split_row(text), [&](const std::string& word) { return finder.find(word); },
      [](const Field&, const std::string& what) { throw BadInput(what); });
}

Block parts_named(const std::vector<std::string>& words, const std::vector<std::string>& names) {
  const PartFinder finder(names, PartNumbers::unless_names_are_so);
  Row row;
  for (const std::string& word : words) {
    row.push_back({.text = word});
  }
  return find_parts(
      finder, row, [&](const std::string& word) { return finder.find(word); },
      [](const Field&, const std::string& what) { throw BadInput(what); });
}

std::string parts_text(const Block& parts, const std::vector<std::string>& names) {
  std::string text;
  for (const Element x : parts) {
    text += (text.empty() ? "" : ", ") + quoted(names[x]);
  }
  return text;
}

}  // namespace changeover
