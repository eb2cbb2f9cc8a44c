#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/search/exact.hpp"
#include "core/parsed.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/scan/row_reader.hpp"
#include "io/table/table.hpp"
#include "io/write/csv_cell.hpp"
#include "io/write/json_writer.hpp"
#include "io/write/latex_prose.hpp"

namespace changeover {
namespace {

constexpr std::string_view head =
    "strength,change,kind,k,v,on_paper,lower,upper,by,seconds,solve_seconds,check_seconds,"
    "proof_bytes,proof_steps,limit";

// One row, cell by cell.
class MinimaCells {
 public:
  MinimaCells(const std::string& name, const Row& row) : name_(name), row_(row) {}

  std::string_view cell() {
    if (next_ == row_.size()) {
      fail("the row is too short");
    }
    return row_[next_++].text;
  }

  /// The next field, of the column `name`.
  template <typename Number>
  Number number(std::string_view name) {
    const std::string_view digits = cell();
    const auto value = parsed<Number>(digits);
    if (!value) {
      fail(std::is_floating_point_v<Number>
               ? fmt::format("{}: '{}' is not a number", name, digits)
               : fmt::format("{}: '{}' is not a whole number from 0 to {}", name, digits,
                             std::numeric_limits<Number>::max()));
    }
    return *value;
  }

  void end() const {
    if (next_ < row_.size()) {
      fail("the row is too long");
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw BadInput(fmt::format("{}:{}: {}; remove the row, and changeover minima fills it in again",
                               name_, row_.front().line, what));
  }

 private:
  const std::string& name_;
  const Row& row_;
  std::size_t next_ = 0;
};

MinimaRow row_from(MinimaCells& reader) {
  MinimaRow row;
  Parameters& p = row.parameters;
  p.strength = reader.number<std::uint32_t>("strength");
  p.change = reader.number<std::uint64_t>("change");
  const auto kind = kind_from_string(reader.cell());
  if (!kind) {
    reader.fail("the kind must be linear or circular");
  }
  p.kind = *kind;
  p.k = reader.number<std::uint64_t>("k");
  p.v = reader.number<std::uint64_t>("v");
  row.start = reader.number<std::uint64_t>("on_paper");
  row.lower = reader.number<std::uint64_t>("lower");
  if (const auto upper = reader.number<std::uint64_t>("upper"); upper != 0) {
    row.upper = upper;
  }
  row.by = csv_text(reader.cell());
  row.seconds = reader.number<double>("seconds");
  row.solve_seconds = reader.number<double>("solve_seconds");
  row.check_seconds = reader.number<double>("check_seconds");
  row.proof_bytes = reader.number<std::uint64_t>("proof_bytes");
  row.proof_steps = reader.number<std::uint64_t>("proof_steps");
  row.limit = reader.number<std::uint64_t>("limit");
  reader.end();
  return row;
}

// Why a row is impossible; empty if it is possible.
std::string defect(const MinimaRow& row) {
  try {
    check(row.parameters);
  } catch (const ImpossibleParameters& fault) {
    return fault.what();
  }
  if (row.start > row.lower || (row.upper && row.lower > *row.upper)) {
    return fmt::format("the bounds {}, {} and {} decrease", row.start, row.lower,
                       row.upper.value_or(0));
  }
  for (const double seconds : {row.seconds, row.solve_seconds, row.check_seconds}) {
    if (!std::isfinite(seconds) || seconds < 0) {
      return fmt::format("{} seconds", seconds);
    }
  }
  return is_printable(row.by) ? "" : "a name with unprintable characters";
}

std::string interval(const MinimaRow& row) {
  if (!row.upper) {
    return fmt::format(">= {}", row.lower);
  }
  return row.settled() ? fmt::format("{}", row.lower)
                       : fmt::format("{}..{}", row.lower, *row.upper);
}

// "12", "12 s" if the design comes from search, "12 p" if smaller numbers were excluded by proofs.
std::string grid_cell(const MinimaRow& row) {
  std::string text = interval(row);
  if (row.settled() && row.by == "SAT") {
    text += " s";
  }
  if (row.lower > row.start) {
    text += " p";
  }
  return text;
}

std::string title(const Parameters& p) {
  const std::string what = change_name(p.change);
  return fmt::format("{} {} covering designs{}", to_string(p.kind), what,
                     p.strength == 2 ? "" : fmt::format(" of strength {}", p.strength));
}

using Rows = std::vector<const MinimaRow*>;

// The style of headings, sentences and tables.
struct Style {
  std::string (*heading)(const std::string& words, unsigned level);
  std::string (*prose)(const std::string& words);
  std::string (*table)(const Table& table);
};

constexpr Style in_markdown_style{[](const std::string& words, unsigned level) {
                                    return std::string(level, '#') + " " + words + "\n\n";
                                  },
                                  [](const std::string& words) { return words + "\n\n"; },
                                  table_markdown};

constexpr Style in_latex_style{[](const std::string& words, unsigned level) {
                                 return fmt::format("\\{}section*{{{}}}\n\n",
                                                    level < 3 ? "" : "sub", latex_prose(words));
                               },
                               [](const std::string& words) {
                                 std::string plain = words;
                                 std::erase(plain, '`');
                                 return latex_prose(plain) + "\n\n";
                               },
                               table_latex};

std::string grid(const Rows& rows, const Style& style) {
  std::set<std::uint64_t> ks;
  std::map<std::uint64_t, std::map<std::uint64_t, std::string>> cells;
  for (const MinimaRow* row : rows) {
    ks.insert(row->parameters.k);
    cells[row->parameters.v][row->parameters.k] = grid_cell(*row);
  }
  std::vector<std::pair<std::string, ColumnStyle>> heads{{"v", number_column}};
  for (const std::uint64_t k : ks) {
    heads.emplace_back(fmt::format("k={}", k), number_column);
  }
  std::vector<std::vector<std::string>> lines;
  for (auto& [v, row] : cells) {
    lines.push_back({std::to_string(v)});
    for (const std::uint64_t k : ks) {
      lines.back().push_back(row[k]);
    }
  }
  return style.heading(title(rows.front()->parameters), 3) +
         style.table(table_of(std::move(heads), std::move(lines))) + "\n";
}

std::string proofs(const Rows& rows, const Style& style) {
  std::vector<std::vector<std::string>> lines;
  for (const MinimaRow* row : rows) {
    lines.push_back({name(row->parameters), std::to_string(row->start), interval(*row), row->by,
                     fmt::format("{:.2f}", row->solve_seconds),
                     fmt::format("{:.2f}", row->check_seconds), std::to_string(row->proof_bytes),
                     std::to_string(row->proof_steps)});
  }
  return style.table(table_of({{"design", {}},
                               {"bound on paper", number_column},
                               {"minimum", number_column},
                               {"design by", {}},
                               {"solving, s", number_column},
                               {"checking, s", number_column},
                               {"proof, bytes", number_column},
                               {"proof, steps", number_column}},
                              std::move(lines))) +
         "\n";
}

std::string open(const Rows& rows, const Style& style) {
  std::vector<std::vector<std::string>> lines;
  for (const MinimaRow* row : rows) {
    lines.push_back({name(row->parameters), std::to_string(row->start), interval(*row), row->by,
                     std::to_string(row->limit)});
  }
  return style.table(table_of({{"design", {}},
                               {"bound on paper", number_column},
                               {"between", number_column},
                               {"design by", {}},
                               {"conflicts a step", number_column}},
                              std::move(lines))) +
         "\n";
}

std::string minima_text(const std::vector<MinimaRow>& rows, const Style& style) {
  std::map<std::tuple<std::uint32_t, std::uint64_t, Kind>, Rows> tables;
  Rows excluded;
  Rows unsettled;
  std::size_t settled = 0;
  std::size_t by_search = 0;
  for (const MinimaRow& row : rows) {
    const Parameters& p = row.parameters;
    tables[{p.strength, p.change, p.kind}].push_back(&row);
    settled += row.settled() ? 1U : 0U;
    by_search += row.settled() && row.by == "SAT" ? 1U : 0U;
    if (row.lower > row.start) {
      excluded.push_back(&row);
    }
    if (!row.settled()) {
      unsettled.push_back(&row);
    }
  }
  std::string text = style.heading("Minima", 1);
  text += style.prose(fmt::format(
      "The least number of blocks, for {} sets of parameters: {} are settled, {} of them by a "
      "design that only search found, and for {} a checked proof goes beyond the bounds on paper.",
      rows.size(), settled, by_search, excluded.size()));
  text += style.prose(
      "`12`: a bound on paper is met by a construction. `s`: the design was found by SAT. `p`: "
      "fewer blocks were excluded by SAT, and the DRAT proofs checked (docs/trust.md). `12..14`: "
      "open between these.");
  for (const auto& [which, members] : tables) {
    text += grid(members, style);
  }
  if (!excluded.empty()) {
    text += style.heading("Excluded with checked proofs", 2);
    text += style.prose(
        "Times are of one processor; a proof's size is that of its text, for all numbers of blocks "
        "from the bound on paper up to the minimum. `changeover search V K --exact --proof DIR` "
        "with --change and --linear or --circular writes the formulas and proofs again.");
    text += proofs(excluded, style);
  }
  if (!unsettled.empty()) {
    text += style.heading("Open", 2) + open(unsettled, style);
  }
  text.pop_back();
  return text;
}

}  // namespace

std::string minima_json(const std::vector<MinimaRow>& rows) {
  JsonWriter json;
  json.begin_object();
  json.objects("minima", rows, [&](const MinimaRow& row) {
    json.cell(row.parameters).key("strength").value(row.parameters.strength);
    json.key("settled").value(row.settled()).key("bound_on_paper").value(row.start);
    json.key("lower_bound").value(row.lower).key("upper_bound").value(row.upper);
    json.key("design_by").value(row.by).key("seconds").value(row.seconds);
    json.key("proof_bytes").value(row.proof_bytes).key("proof_steps").value(row.proof_steps);
    json.key("conflicts").value(row.limit);
  });
  json.end_object();
  return json.take() + "\n";
}

void write_minima(const std::vector<MinimaRow>& rows, Sink& sink) {
  sink.write(fmt::format("{}\n", head));
  for (const MinimaRow& row : rows) {
    const Parameters& p = row.parameters;
    sink.write(fmt::format("{},{},{},{},{},{},{},{},{},{:.2f},{:.2f},{:.2f},{},{},{}\n", p.strength,
                           p.change, to_string(p.kind), p.k, p.v, row.start, row.lower,
                           row.upper.value_or(0), csv_cell(row.by), row.seconds, row.solve_seconds,
                           row.check_seconds, row.proof_bytes, row.proof_steps, row.limit));
  }
}

std::vector<MinimaRow> read_minima(Input& input) {
  constexpr std::size_t most_bytes = std::size_t{1} << 26;
  const auto text =
      input_from_text(read_to_end(input, most_bytes, "name another file"), input.name());
  RowReader lines(*text);
  if (!lines.next_line()) {
    return {};
  }
  if (lines.line() != head) {
    throw BadInput(fmt::format("{}:1: the first line is not '{}'; name a file that minima wrote",
                               input.name(), head));
  }
  const auto place = [](const MinimaRow& row) {
    const Parameters& p = row.parameters;
    return std::tuple(p.strength, p.change, p.kind, p.k, p.v);
  };
  std::vector<MinimaRow> rows;
  std::set<decltype(place(rows.front()))> places;
  while (const auto cells = lines.next()) {
    MinimaCells reader(input.name(), *cells);
    MinimaRow row = row_from(reader);
    if (const std::string wrong = defect(row); !wrong.empty()) {
      reader.fail(wrong);
    }
    if (!places.insert(place(row)).second) {
      reader.fail(name(row.parameters) + " occurs twice");
    }
    rows.push_back(std::move(row));
  }
  std::ranges::sort(rows,
                    [&](const MinimaRow& a, const MinimaRow& b) { return place(a) < place(b); });
  return rows;
}

std::string minima_markdown(const std::vector<MinimaRow>& rows) {
  return minima_text(rows, in_markdown_style);
}

std::string minima_latex(const std::vector<MinimaRow>& rows) {
  return minima_text(rows, in_latex_style);
}

}  // namespace changeover
