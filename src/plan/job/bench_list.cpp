#include "plan/job/bench_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/each.hpp"
#include "core/printable.hpp"
#include "core/spelling.hpp"
#include "core/words.hpp"
#include "io/request/request_rows.hpp"
#include "io/scan/place.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/part_finder.hpp"
#include "plan/job/parts/heading_words.hpp"

namespace changeover {
namespace {

enum class BenchColumn : std::uint8_t {
  name,
  at_once,
  test_cost,
  change_factor,
  slots,
  mounted,
  start,
  own,
  without,
  hours,
  down
};

// Lower case, with underscores between words.
std::string plain_heading(std::string_view text) {
  std::string plain = lower_case(text);
  std::ranges::replace_if(
      plain, [](char c) { return c == ' ' || c == '-'; }, '_');
  return plain;
}

std::optional<BenchColumn> bench_column(std::string_view text) {
  const std::string heading = plain_heading(text);
  constexpr std::array<std::pair<std::string_view, BenchColumn>, 6> others{
      {{"bench", BenchColumn::name},
       {"benches", BenchColumn::name},
       {"room", BenchColumn::at_once},
       {"hours_a_day", BenchColumn::hours},
       {"slot", BenchColumn::slots},
       {"cannot_have", BenchColumn::without}}};
  for (const auto& [word, column] : others) {
    if (heading == word) {
      return column;
    }
  }
  const auto& columns = bench_columns();
  const auto found = std::ranges::find(columns, heading);
  return found == columns.end() ? std::nullopt
                                : std::optional(static_cast<BenchColumn>(found - columns.begin()));
}

class BenchReader {
 public:
  BenchReader(Input& input, const PartNames& names, std::vector<std::string>* gone)
      : rows_(input), finder_(names, numbers_in(rows_)), gone_(gone) {}

  // The heads of columns that say nothing of benches.
  [[nodiscard]] const std::vector<std::string>& unused() const { return unused_; }

  // Whether the benches are rows of a document and not of a file.
  [[nodiscard]] bool is_given() const { return rows_.is_given(); }

  std::vector<Bench> read() {
    std::vector<Bench> benches;
    std::vector<std::optional<BenchColumn>> columns;
    while (const auto row = rows_.next()) {
      if (columns.empty()) {
        columns = columns_of(*row);
        if (!only_names_) {
          continue;
        }
      }
      if (benches.size() == max_benches) {
        rows_.fail(row->front(), fmt::format("more than {} benches; plan for fewer", max_benches));
      }
      benches.push_back(bench_of(*row, columns));
    }
    return benches;
  }

 private:
  std::vector<std::optional<BenchColumn>> columns_of(const Row& header) {
    std::vector<std::optional<BenchColumn>> columns;
    for (const Field& field : header) {
      const auto column = bench_column(field.text);
      if (!column && header.size() == 1) {
        only_names_ = true;
        return {BenchColumn::name};
      }
      if (!column) {
        pass_over(field);
      } else if (std::ranges::find(columns, column) != columns.end()) {
        rows_.fail(field, fmt::format("a second column {}; remove one", shown(field.text)));
      }
      columns.push_back(column);
    }
    if (std::ranges::none_of(columns, [](const auto& column) { return column.has_value(); })) {
      no_such_column(header.front());
    }
    return columns;
  }

  [[noreturn]] void no_such_column(const Field& field) const {
    rows_.fail(field, fmt::format("there is no column {} of benches; there are {}",
                                  shown(field.text), fmt::join(bench_columns(), ", ")));
  }

  // A column of another kind, as of a parts list; but no misspelled one, whose rules would be lost.
  void pass_over(const Field& field) {
    const std::vector<std::string> known(bench_columns().begin(), bench_columns().end());
    const auto nearest = nearest_word(plain_heading(field.text), known);
    if (nearest) {
      rows_.fail(field, fmt::format("there is no column {} of benches; did you mean {}?",
                                    shown(field.text), *nearest));
    }
    if (rows_.is_given()) {
      no_such_column(field);
    }
    if (!field.text.empty()) {
      unused_.push_back(field.text);
    }
  }

  Bench bench_of(const Row& row, const std::vector<std::optional<BenchColumn>>& columns) {
    Bench bench;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i >= columns.size()) {
        if (!row[i].text.empty() && !rows_.is_workbook()) {
          rows_.fail(row[i], fmt::format("more fields than the {} of the header; quote those with "
                                         "a comma",
                                         columns.size()));
        }
      } else if (columns[i] && !row[i].text.empty()) {
        take(bench, *columns[i], row[i]);
      }
    }
    return bench;
  }

  template <typename Read>
  auto at(const Field& field, Read&& read) {
    try {
      return read();
    } catch (const BadInput& fault) {
      rows_.fail(field, fault.what());
    } catch (const ImpossibleParameters& fault) {
      rows_.fail(field, fault.what());
    }
  }

  void take(Bench& bench, BenchColumn column, const Field& field) {
    switch (column) {
      case BenchColumn::name:
        bench.name = field.text;
        break;
      case BenchColumn::at_once:
        bench.at_once = number(field);
        break;
      case BenchColumn::test_cost:
        bench.test_cost = amount(field);
        break;
      case BenchColumn::change_factor:
        bench.change_factor = amount(field, "factor");
        break;
      case BenchColumn::hours:
        bench.hours = amount(without_hours(field), "number of hours");
        break;
      case BenchColumn::slots:
        bench.slots = at(field, [&] { return parse_slots(field.text); });
        break;
      case BenchColumn::mounted:
        bench.mounted = parts(field);
        break;
      case BenchColumn::start:
        bench.start = parts(field);
        break;
      case BenchColumn::own:
        bench.own = parts(field);
        break;
      case BenchColumn::without:
        bench.without = parts(field);
        break;
      case BenchColumn::down:
        bench.down = is_down(field);
        break;
    }
  }

  std::uint64_t number(const Field& field) {
    std::uint64_t value = 0;
    const char* const end = field.text.data() + field.text.size();
    const auto [rest, failure] = std::from_chars(field.text.data(), end, value);
    if (failure != std::errc() || rest != end) {
      rows_.fail(field, fmt::format("{} is not a number of parts; write a whole number",
                                    shown(field.text)));
    }
    return value;
  }

  Amount amount(const Field& field, std::string_view what = "cost") {
    std::string text = field.text;
    if (rows_.separator() != ',' && std::ranges::count(text, ',') == 1) {
      text[text.find(',')] = '.';
    }
    return at(field, [&] { return parse_measure(text, what); });
  }

  // The field without a sign of hours, as in "8 h".
  static Field without_hours(Field field) {
    const std::size_t end = field.text.find_last_of("0123456789");
    const std::string sign = end == std::string::npos ? "" : field.text.substr(end + 1);
    if (unit_in_heading("(" + sign + ")") == CostUnit::hours) {
      field.text.resize(end + 1);
    }
    return field;
  }

  bool is_down(const Field& field) {
    const std::string word = lower_case(field.text);
    constexpr std::array<std::string_view, 6> yes{"yes", "true", "1", "x", "down", "y"};
    constexpr std::array<std::string_view, 6> no{"no", "false", "0", "up", "n", "-"};
    if (std::ranges::find(yes, word) != yes.end()) {
      return true;
    }
    if (std::ranges::find(no, word) == no.end()) {
      rows_.fail(field, fmt::format("{} is not yes; write yes if the bench is down, or nothing",
                                    shown(field.text)));
    }
    return false;
  }

  Block parts(const Field& field) {
    Row words = at(field, [&] { return split_row(field.text); });
    if (words.size() == 1 && !finder_.find(field.text)) {
      between_semicolons(field, words);
    }
    for (Field& word : words) {
      word.offset = field.offset;
      word.line = field.line;
    }
    if (finder_.some_gone(words, rows_, gone_, true)) {
      std::erase_if(words, [&](const Field& word) { return finder_.may_be_gone(word.text); });
    }
    return find_parts(
        finder_, words, [&](const std::string& word) { return finder_.find(word); },
        [&](const Field&, const std::string& what) { rows_.fail(field, what); });
  }

  // Several parts with semicolons between them.
  void between_semicolons(const Field& field, Row& words) const {
    const std::vector<std::string> names = finder_.names_between(field.text, ";");
    if (!names.empty()) {
      words.clear();
      for (const std::string& name : names) {
        words.push_back({.text = name});
      }
    }
  }

  RowReader rows_;
  PartFinder finder_;
  std::vector<std::string>* gone_;
  std::vector<std::string> unused_;
  bool only_names_ = false;
};

}  // namespace

Amount parse_measure(std::string_view text, std::string_view what) {
  if (what == "cost") {
    return parse_amount(text);
  }
  try {
    return parse_amount(text);
  } catch (const Error&) {
    throw BadInput(fmt::format("{} is not a {}; write it as 12 or 12.50", shown(text), what));
  }
}

const std::vector<std::string_view>& bench_columns() { return row_keys(RowShape::benches); }

std::vector<Bench> read_benches(Input& input, const PartNames& names,
                                std::vector<std::string>* gone, std::vector<std::string>* notes) {
  BenchReader reader(input, names, gone);
  std::vector<Bench> benches = reader.read();
  if (benches.empty() && reader.is_given()) {
    throw BadInput(input.name() +
                   ": no bench is listed; give a name for each, or how many there are");
  }
  if (benches.empty()) {
    fail(input.name(), {}, "no bench is listed; write one per line below a header");
  }
  if (notes != nullptr && !reader.unused().empty()) {
    notes->push_back(fmt::format("{}: not used of the benches: {}", input.name(),
                                 joined(reader.unused(), shown)));
  }
  return benches;
}

std::optional<std::size_t> find_bench(const std::vector<Bench>& benches, const std::string& word) {
  for (std::size_t i = 0; i < benches.size() && !word.empty(); ++i) {
    if (benches[i].name == word || name_of(benches, i) == word) {
      return i;
    }
  }
  std::size_t number = 0;
  const auto [rest, failure] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool whole = failure == std::errc() && rest == word.data() + word.size();
  return whole && number >= 1 && number <= benches.size() ? std::optional(number - 1)
                                                          : std::nullopt;
}

}  // namespace changeover
