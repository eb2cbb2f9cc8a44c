#include "changeover/plan/job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "changeover/core/error.hpp"
#include "io/read/place.hpp"
#include "io/write/csv_cell.hpp"
#include "plan/job/rows.hpp"

namespace changeover {
namespace {

constexpr std::size_t longest_name = 255;

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return result;
}

// Parts by name or number.
class PartFinder {
 public:
  explicit PartFinder(const std::vector<std::string>& names) : names_(&names) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      by_name_.emplace(names[i], static_cast<Element>(i));
    }
  }

  [[nodiscard]] std::optional<Element> find(const std::string& word) const {
    if (const auto found = by_name_.find(word); found != by_name_.end()) {
      return found->second;
    }
    std::size_t number = 0;
    const char* const end = word.data() + word.size();
    const auto [rest, failure] = std::from_chars(word.data(), end, number);
    if (failure == std::errc() && rest == end && number >= 1 && number <= names_->size()) {
      return static_cast<Element>(number - 1);
    }
    return std::nullopt;
  }

  // What stands in a cell that csv_cell() wrote, or that a spreadsheet made of it.
  [[nodiscard]] std::optional<Element> find_cell(const std::string& cell) const {
    const auto part = find(std::string(csv_text(cell)));
    return part ? part : find(cell);
  }

  [[nodiscard]] bool is_name(const std::string& word) const { return by_name_.count(word) != 0; }
  [[nodiscard]] std::size_t size() const { return names_->size(); }

  // What to say of a word that is no part: with the name that differs in its case only, if there is one.
  [[nodiscard]] std::string complaint(const std::string& word) const {
    for (const std::string& name : *names_) {
      if (lower(name) == lower(word)) {
        return fmt::format("there is no part {}; did you mean {}?", shown(word), shown(name));
      }
    }
    return fmt::format(
        "there is no part {}; give a name of the parts list or a number from 1 to {}", shown(word),
        names_->size());
  }

 private:
  const std::vector<std::string>* names_;
  std::unordered_map<std::string, Element> by_name_;
};

// The parts of some fields, none twice; says which field is at fault. `find` takes its text.
template <typename Find, typename Fail>
Block find_parts(const PartFinder& finder, std::span<const Field> row, Find&& find, Fail&& fail) {
  Block parts;
  std::vector<bool> seen(finder.size());
  for (const Field& field : row) {
    if (field.text.empty()) {
      continue;
    }
    const std::optional<Element> part = find(field.text);
    if (!part) {
      fail(field, finder.complaint(field.text));
    }
    if (seen[*part]) {
      fail(field, fmt::format("{} stands here twice; remove one", shown(field.text)));
    }
    seen[*part] = true;
    parts.push_back(*part);
  }
  return parts;
}

// A row of numbers with blanks between them and no comma: "1 2 3".
Row at_blanks(const Field& field) {
  Row row;
  for (std::size_t at = 0; at < field.text.size();) {
    const std::size_t start = field.text.find_first_not_of(" \t", at);
    if (start == std::string::npos) {
      break;
    }
    at = std::min(field.text.find_first_of(" \t", start), field.text.size());
    row.push_back({field.text.substr(start, at - start), field.offset + start});
  }
  return row;
}

struct PartColumns {
  std::size_t name = 0;
  std::optional<std::size_t> cost = 1;
  bool header = false;
};

PartColumns columns_of(const Row& first) {
  constexpr std::array<std::string_view, 4> words{"name", "part", "component", "item"};
  const auto is_word = [&](const Field& field) {
    return std::find(words.begin(), words.end(), lower(field.text)) != words.end();
  };
  const auto has_digit = [](const std::string& text) {
    return std::any_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  PartColumns columns;
  columns.header = std::any_of(first.begin(), first.end(), is_word) ||
                   (first.size() > 1 && !first[1].text.empty() && !has_digit(first[1].text));
  if (columns.header) {
    const auto name = std::find_if(first.begin(), first.end(), is_word);
    const auto cost = std::find_if(first.begin(), first.end(), [](const Field& field) {
      return lower(field.text).find("cost") != std::string::npos;
    });
    columns.name = name == first.end() ? 0 : static_cast<std::size_t>(name - first.begin());
    columns.cost = cost == first.end()
                       ? std::nullopt
                       : std::optional(static_cast<std::size_t>(cost - first.begin()));
  }
  return columns;
}

// Which fields of the rows hold a set-up.
struct SetupColumns {
  std::optional<std::size_t> list;  // all parts in one field
  std::vector<std::size_t> slots;   // a part in each; increasing
  bool header = false;              // the first row is one
};

// Whether "slot_7" or the like.
bool is_slot(const std::string& word) {
  constexpr std::string_view prefix = "slot_";
  return word.size() > prefix.size() && word.starts_with(prefix) &&
         std::all_of(word.begin() + prefix.size(), word.end(),
                     [](char c) { return c >= '0' && c <= '9'; });
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
    }
  }
  columns.header = beyond_doubt || columns.list || !columns.slots.empty();
  return columns;
}

}  // namespace

PartList read_parts(Input& input) {
  RowReader reader(input);
  PartList parts;
  std::unordered_set<std::string> seen;
  PartColumns columns;
  bool first = true;
  while (const auto next = reader.next()) {
    const Row& row = *next;
    if (std::exchange(first, false)) {
      columns = columns_of(row);
      if (columns.header) {
        continue;
      }
    }
    if (!columns.header && row.size() > 2) {
      reader.fail(row[2].offset,
                  "a third field; write a name and a change cost, and quote a name with a comma");
    }
    if (columns.name >= row.size() || row[columns.name].text.empty()) {
      reader.fail(row.front().offset, "a row without a name; name the part");
    }
    const Field& name = row[columns.name];
    if (name.text.size() > longest_name) {
      reader.fail(name.offset,
                  fmt::format("a name of more than {} bytes; shorten it", longest_name));
    }
    if (const auto defect = text_defect(name.text)) {
      reader.fail(name.offset, fmt::format("the name {}: {}", shown(name.text), *defect));
    }
    if (!seen.insert(name.text).second) {
      reader.fail(name.offset,
                  fmt::format("a second part is called {}; rename one", shown(name.text)));
    }
    if (parts.names.size() == max_parts) {
      reader.fail(name.offset,
                  fmt::format("more than {} parts; plan for fewer at a time", max_parts));
    }
    parts.names.push_back(name.text);
    parts.change_costs.emplace_back();
    if (columns.cost && *columns.cost < row.size() && !row[*columns.cost].text.empty()) {
      const Field& cost = row[*columns.cost];
      try {
        parts.change_costs.back() = parse_amount(cost.text);
      } catch (const Error& fault) {
        reader.fail(cost.offset, fault.what());
      }
    }
  }
  if (parts.names.empty()) {
    fail(input.name(), {}, "no part is listed; write one a line");
  }
  return parts;
}

PairSet read_pairs(Input& input, const std::vector<std::string>& names) {
  RowReader reader(input);
  const PartFinder finder(names);
  PairSet pairs(names.size());
  while (const auto row = reader.next()) {
    const Block pair = find_parts(
        finder, *row, [&](const std::string& word) { return finder.find(word); },
        [&](const Field& field, const std::string& what) { reader.fail(field.offset, what); });
    if (pair.size() != 2) {
      reader.fail(row->front().offset,
                  fmt::format("{} here, and a pair has two; write A,B",
                              pair.size() == 1 ? "one part stands" : "more than two stand"));
    }
    pairs.insert(pair[0], pair[1]);
  }
  return pairs;
}

std::vector<Block> read_setups(Input& input, const std::vector<std::string>& names,
                               std::uint64_t at_once) {
  RowReader reader(input);
  const PartFinder finder(names);
  std::vector<Block> setups;
  SetupColumns columns;
  bool first = true;
  const auto find = [&](const std::string& word) { return finder.find(word); };
  const auto find_cell = [&](const std::string& cell) { return finder.find_cell(cell); };
  const auto fail = [&](const Field& field, const std::string& what) {
    reader.fail(field.offset, what);
  };
  while (auto next = reader.next()) {
    Row& row = *next;
    if (std::exchange(first, false)) {
      columns = setup_columns(row, finder);
      if (columns.header) {
        continue;
      }
    }
    const std::size_t place = row.front().offset;
    if (!columns.header) {
      if (row.size() == 1 && !finder.find(row.front().text)) {
        row = at_blanks(row.front());
      }
      setups.push_back(find_parts(finder, row, find, fail));
    } else if (!columns.slots.empty()) {
      Row slots;
      for (const std::size_t i : columns.slots) {
        if (i < row.size()) {
          slots.push_back(std::move(row[i]));
        }
      }
      setups.push_back(find_parts(finder, slots, find_cell, fail));
    } else if (columns.list && *columns.list < row.size()) {  // the parts in one field
      const Field& list = row[*columns.list];
      const auto fail_in_list = [&](const Field&, const std::string& what) { fail(list, what); };
      Row parts;
      try {
        parts = split_row(list.text);
      } catch (const BadInput& fault) {
        fail(list, fault.what());
      }
      setups.push_back(find_parts(finder, parts, find, fail_in_list));
    } else {
      setups.emplace_back();
    }
    if (columns.header && setups.back().empty()) {
      reader.fail(place, "a row without a set-up; remove it or complete it");
    }
    if (setups.back().size() > at_once) {
      reader.fail(place, fmt::format("{} parts stand here, but only {} fit at once",
                                     setups.back().size(), at_once));
    }
  }
  return setups;
}

Block parse_parts(std::string_view text, const std::vector<std::string>& names) {
  const PartFinder finder(names);
  return find_parts(
      finder, split_row(text), [&](const std::string& word) { return finder.find(word); },
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
