#include "changeover/plan/job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <set>
#include <unordered_set>
#include <utility>

#include "changeover/core/error.hpp"
#include "io/scan/place.hpp"
#include "io/scan/row_reader.hpp"
#include "io/write/csv_cell.hpp"
#include "plan/job/part_finder.hpp"
#include "plan/job/setup_list.hpp"

namespace changeover {
namespace {

// Which fields of the rows hold a set-up.
struct SetupColumns {
  std::optional<std::size_t> list;  // all parts in one field
  std::vector<std::size_t> slots;   // a part in each; increasing
  std::optional<std::size_t> result;
  std::optional<std::size_t> notes;
  bool header = false;  // the first row is one
};

// The place of "slot_7", or of "slot_7 CPU".
std::optional<DonePlace> place_in(std::string_view head) {
  constexpr std::string_view prefix = "slot_";
  if (!head.starts_with(prefix)) {
    return std::nullopt;
  }
  head.remove_prefix(prefix.size());
  DonePlace place;
  const char* const end = head.data() + head.size();
  const auto [rest, failure] = std::from_chars(head.data(), end, place.number);
  if (failure != std::errc() || (rest != end && *rest != ' ')) {
    return std::nullopt;
  }
  place.slot = rest == end ? "" : std::string(rest + 1, end);
  return place;
}

// A first row with such words is the header of a sheet, unless they are names of parts; then only if it
// is one beyond doubt.
SetupColumns setup_columns(const Row& first, const PartFinder& finder) {
  const auto has_all = [&](std::initializer_list<std::string_view> words) {
    return std::ranges::all_of(words, [&](std::string_view word) {
      return std::ranges::any_of(first, [&](const Field& field) { return field.text == word; });
    });
  };
  const bool beyond_doubt = has_all({"step", "take_out", "put_in", "cost_so_far"}) ||
                            has_all({"step", "result", "notes"});
  SetupColumns columns;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (finder.is_name(first[i].text) && !beyond_doubt) {
      continue;
    }
    if (first[i].text == "set_up") {
      columns.list = i;
    } else if (place_in(first[i].text)) {
      columns.slots.push_back(i);
    } else if (lower(first[i].text) == "result") {
      columns.result = i;
    } else if (lower(first[i].text) == "notes") {
      columns.notes = i;
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

}  // namespace

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
        for (const std::size_t i : columns.slots) {
          list.places.push_back(*place_in(header[i].text));
        }
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
    list.in_place.emplace_back();
    list.written.emplace_back();
    list.notes.emplace_back(columns.notes && *columns.notes < row.size()
                                ? text_of(row[*columns.notes].text)
                                : std::string());
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
      for (const Field& slot : slots) {
        list.in_place.back().push_back(slot.text.empty() ? std::nullopt : find_cell(slot.text));
        list.written.back().push_back(text_of(slot.text));
      }
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
