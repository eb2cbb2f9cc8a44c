#include "plan/job/parts/part_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/printable.hpp"
#include "core/words.hpp"
#include "plan/job/parts/cost_reader.hpp"

namespace changeover {
namespace {

constexpr const char* how_to_say =
    "say --header if it heads the columns, --no-header if it is a part";
constexpr const char* no_column = "-";  // instead of the name of a column

const std::string& text_of(const Row& row, std::size_t column) {
  static const std::string none;
  return column < row.size() ? row[column].text : none;
}

// Whether it looks like a number, even a malformed one, or says that there is none.
bool like_a_number(std::string_view text) {
  return !text.empty() && (std::string_view("0123456789.,+-").find(text.front()) != text.npos ||
                           is_missing_number(text));
}

std::size_t filled(const Row& row) {
  return static_cast<std::size_t>(
      std::ranges::count_if(row, [](const Field& field) { return !field.text.empty(); }));
}

bool has_word_of_headers(const Row& row) {
  const bool several = filled(row) > 1;
  return std::ranges::any_of(row, [&](const Field& field) {
    return heads_parts(field.text) || heads_costs(field.text) || heads_slots(field.text) ||
           (several &&
            (heads_times(field.text) || heads_names(field.text) || heads_quantities(field.text)));
  });
}

bool has_no_number(const Row& row) {
  return std::ranges::none_of(row, [](const Field& field) { return like_a_number(field.text); });
}

// Whether one text differs from all others in a property that they share.
bool of_another_kind(std::span<const Row> rows) {
  const auto alone = [&](auto&& property) {
    const auto first = property(rows.front().front().text);
    const auto others = property(rows[1].front().text);
    return first != others && std::all_of(rows.begin() + 1, rows.end(), [&](const Row& row) {
             return property(row.front().text) == others;
           });
  };
  return rows.size() > 2 &&
         (alone([&](const std::string& t) { return std::ranges::any_of(t, is_digit); }) ||
          alone([](const std::string& t) { return t.size(); }) ||
          alone([](const std::string& t) { return !t.empty() && t[0] >= 'a' && t[0] <= 'z'; }));
}

// The number of rows above a header of several columns: titles, of one field each.
std::size_t rows_above(const std::vector<Row>& rows) {
  constexpr std::size_t most = 10;
  std::size_t above = 0;
  while (above < most && above + 1 < rows.size() && filled(rows[above]) == 1) {
    ++above;
  }
  return above < rows.size() && filled(rows[above]) > 1 && has_no_number(rows[above]) &&
                 has_word_of_headers(rows[above])
             ? above
             : 0;
}

// Whether the first row is a header.
bool is_header(std::span<const Row> rows, const RowReader& reader, std::string& note) {
  const Row& first = rows.front();
  const auto has_cost = [](const Row& row) { return like_a_number(text_of(row, 1)); };
  const auto others =
      static_cast<std::size_t>(std::count_if(rows.begin() + 1, rows.end(), has_cost));
  const auto doubtful = [&](const std::string& why) {
    reader.fail(first.front(), fmt::format("{} may be a header or a part: {}; {}",
                                           shown(first.front().text), why, how_to_say));
  };
  constexpr std::size_t most_without_header = 2;
  if (first.size() > most_without_header) {
    return has_word_of_headers(first) && has_no_number(first);
  }
  if (has_cost(first)) {
    return false;
  }
  const bool has_word = has_word_of_headers(first);
  const bool two = !text_of(first, 1).empty();
  if (two && !has_word) {
    doubtful(fmt::format("{} is not a cost, and {}", shown(first[1].text),
                         others > 0 ? "other rows have one" : "no other row has one"));
  }
  if (has_word && first.size() == 2 && !two && others > 0) {
    doubtful("its second field is empty, and other rows have a cost there");
  }
  if (has_word) {
    return true;
  }
  if (others > 0 && others + 1 == rows.size()) {
    doubtful("all other rows have a cost");
  }
  const bool one_column =
      std::ranges::all_of(rows, [](const Row& row) { return text_of(row, 1).empty(); });
  if (one_column && of_another_kind(rows)) {
    doubtful("it does not look like the others");
  }
  if (one_column) {
    note = fmt::format("no header: {} is the first part", shown(first.front().text));
  }
  return false;
}

[[noreturn]] void fail_for_two(const Field& one, const Field& other, std::string_view what,
                               const RowReader& reader, std::string_view how) {
  reader.fail(other, fmt::format("{} and {} may both head the {}; {}", shown(one.text),
                                 shown(other.text), what, how));
}

// Finds the meaning of the columns below a header.
class ColumnFinder {
 public:
  ColumnFinder(std::span<const Row> rows, const RowReader& reader)
      : rows_(rows), header_(rows.front()), reader_(&reader) {}

  PartColumns columns(const PartListOptions& options) {
    const std::string& cost_column = options.cost_column;
    columns_.header = true;
    columns_.slot = only(heads_slots, "slots");
    columns_.quantity = only(heads_quantities, "quantities");
    if (!columns_.slot && !options.slots.empty()) {
      columns_.slot = column_of(options.slots);
    }
    columns_.name = name_column();
    columns_.cost = cost_column.empty() ? cost() : named(cost_column);
    if (columns_.cost) {
      columns_.unit = unit_in_heading(header_[*columns_.cost].text);
    }
    columns_.note = note();
    return columns_;
  }

 private:
  template <typename Heads>
  std::optional<std::size_t> find(Heads&& heads, std::size_t from = 0) const {
    for (std::size_t i = from; i < header_.size(); ++i) {
      if (heads(header_[i].text)) {
        return i;
      }
    }
    return std::nullopt;
  }

  std::optional<std::size_t> only(bool (*heads)(std::string_view), std::string_view what) const {
    const auto found = find(heads);
    if (const auto other = found ? find(heads, *found + 1) : std::nullopt) {
      fail_for_two(header_[*found], header_[*other], what, *reader_,
                   "rename or remove one of the columns");
    }
    return found;
  }

  // The column in which more than half of the fields are such words, whatever its heading; nullopt
  // if there is none.
  [[nodiscard]] std::optional<std::size_t> column_of(const std::vector<std::string>& words) const {
    const auto is_of_words = [&](std::size_t i) {
      std::size_t all = 0;
      std::size_t known = 0;
      for (const Row& row : rows_.subspan(1)) {
        const std::string& text = text_of(row, i);
        all += text.empty() ? 0U : 1U;
        known += std::ranges::find(words, text) == words.end() ? 0U : 1U;
      }
      return known > 1 && 2 * known > all && i != columns_.quantity &&
             !heads_parts(header_[i].text);
    };
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < header_.size(); ++i) {
      if (!is_of_words(i)) {
        continue;
      }
      if (found) {
        fail_for_two(header_[*found], header_[i], "slots", *reader_,
                     "call one of them slot, or remove one of the columns");
      }
      found = i;
    }
    return found;
  }

  // The first column that is named so, or that has no other meaning; row numbers are used as names
  // only if there is no other column.
  [[nodiscard]] std::size_t name_column() const {
    if (const auto found = find(heads_parts)) {
      return *found;
    }
    if (const auto found = find(heads_names)) {
      return *found;
    }
    const auto says_nothing = [&](std::size_t i) {
      const std::string& head = header_[i].text;
      return i != columns_.slot && i != columns_.quantity && !heads_costs(head) &&
             !(heads_times(head) && has_numbers(i));
    };
    std::optional<std::size_t> counts;
    for (std::size_t i = 0; i < header_.size(); ++i) {
      if (says_nothing(i) && !header_[i].text.empty()) {
        if (!heads_row_numbers(header_[i].text)) {
          return i;
        }
        counts = counts.value_or(i);
      }
    }
    return counts.value_or(header_.size() - 1);
  }

  // Whether most fields of the column are numbers.
  [[nodiscard]] bool has_numbers(std::size_t column) const {
    std::size_t numbers = 0;
    std::size_t all = 0;
    for (const Row& row : rows_.subspan(1)) {
      const std::string& text = text_of(row, column);
      all += text.empty() ? 0U : 1U;
      numbers += CostReader::is_like_a_cost(text) ? 1U : 0U;
    }
    return numbers > 0 && 2 * numbers >= all;
  }

  // How well a column is suited for the costs; 0: not at all.
  [[nodiscard]] unsigned rank(std::size_t column) const {
    const std::string& head = header_[column].text;
    const bool is_money = heads_costs(head);
    if (column == columns_.name || column == columns_.slot || column == columns_.quantity ||
        !(is_money || (heads_times(head) && has_numbers(column)))) {
      return 0;
    }
    return (is_of_changes(head) ? 2U : 0U) + (is_money ? 2U : 1U);
  }

  [[nodiscard]] std::optional<std::size_t> cost() const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < header_.size(); ++i) {
      if (rank(i) > 0 && (!found || rank(i) > rank(*found))) {
        found = i;
      }
    }
    for (std::size_t i = found.value_or(header_.size()) + 1; i < header_.size(); ++i) {
      if (rank(i) == rank(*found)) {
        fail_for_two(header_[*found], header_[i], "costs", *reader_,
                     "say which with --cost-column, or rename or remove one of the columns");
      }
    }
    // The other one of two columns.
    const std::size_t other = columns_.name == 0 ? 1 : 0;
    if (!found && header_.size() == 2 && columns_.slot != other && columns_.quantity != other &&
        !heads_times(header_[other].text)) {
      return other;
    }
    return found;
  }

  [[nodiscard]] std::optional<std::size_t> named(const std::string& name) const {
    if (name == no_column) {
      return std::nullopt;
    }
    const auto found =
        find([&](const std::string& head) { return lower_case(head) == lower_case(name); });
    if (!found) {
      std::string heads;
      for (const Field& field : header_) {
        heads += field.text.empty() ? "" : (heads.empty() ? "" : ", ") + shown(field.text);
      }
      reader_->fail(header_.front(),
                    fmt::format("no column is called {}; there are {}", shown(name), heads));
    }
    if (found == columns_.name) {
      reader_->fail(header_[*found], fmt::format("the column {} has the names, and no costs",
                                                 shown(header_[*found].text)));
    }
    return found;
  }

  [[nodiscard]] std::string note() const {
    std::string text = fmt::format("{} is a header: names in {}", row_words(),
                                   shown(text_of(header_, columns_.name)));
    text += columns_.cost
                ? fmt::format(", change costs in {}", shown(text_of(header_, *columns_.cost)))
                : std::string(", no change costs");
    const auto add = [&](const std::optional<std::size_t>& column, std::string_view what) {
      text += column ? fmt::format(", {} in {}", what, shown(text_of(header_, *column))) : "";
    };
    add(columns_.slot, "slots");
    add(columns_.quantity, "quantities");
    std::string unused;
    for (std::size_t i = 0; i < header_.size(); ++i) {
      if (i != columns_.name && i != columns_.cost && i != columns_.slot &&
          i != columns_.quantity && !header_[i].text.empty()) {
        unused += (unused.empty() ? "" : ", ") + shown(header_[i].text);
      }
    }
    return text + (unused.empty() ? "" : "; not used: " + unused);
  }

  [[nodiscard]] std::string row_words() const {
    return header_.front().line <= 1 || reader_->is_given()
               ? "the first row"
               : fmt::format("row {}", header_.front().line);
  }

  std::span<const Row> rows_;
  const Row& header_;
  const RowReader* reader_;
  PartColumns columns_;
};

}  // namespace

PartColumns part_columns(const std::vector<Row>& rows, const PartListOptions& options,
                         const RowReader& reader) {
  const auto has = [&](std::string_view word) {
    return std::ranges::any_of(rows.front(),
                               [&](const Field& field) { return field.text == word; });
  };
  if (options.header == Header::guessed && has("step") && (has("take_out") || has("result"))) {
    reader.fail(rows.front().front(),
                "this is a run sheet and no list of parts; give it to --done");
  }
  const bool is_shown = options.header != Header::guessed || !options.cost_column.empty();
  const std::size_t above =
      options.header == Header::none || reader.is_given() ? 0 : rows_above(rows);
  const std::span<const Row> table = std::span(rows).subspan(above);
  std::string note;
  if (options.header == Header::none || (!is_shown && !is_header(table, reader, note))) {
    return {.cost = 1, .note = note};
  }
  PartColumns columns = ColumnFinder(table, reader).columns(options);
  columns.above = above;
  return columns;
}

}  // namespace changeover
