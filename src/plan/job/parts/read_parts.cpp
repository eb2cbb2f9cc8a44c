// Reads parts lists.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <unordered_set>
#include <utility>

#include "changeover/plan/job.hpp"
#include "core/each.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/scan/place.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/parts/cost_reader.hpp"
#include "plan/job/parts/part_columns.hpp"

namespace changeover {
namespace {

constexpr std::size_t longest_name = 255;

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

// Whether a field says that there is nothing in it.
bool says_none(const std::string& text) {
  constexpr auto words =
      std::to_array<std::string_view>({"", "-", "–", "—", "n/a", "na", "n.a.", "none"});
  return std::ranges::find(words, lower_case(text)) != words.end();
}

// Reads a parts list row by row, once the columns are known.
class PartReader {
 public:
  PartReader(const Input& input, const RowReader& reader, const PartColumns& columns,
             std::size_t fields, bool costs_may_lack)
      : input_(&input),
        reader_(&reader),
        columns_(columns),
        fields_(fields),
        costs_may_lack_(costs_may_lack),
        costs_(reader) {}

  void take(const Row& row, bool after_blank) {
    check_fields(row);
    if (after_blank) {
      check_footnote(row);
    }
    if (fields_in(row) < 2) {
      only_full_ = false;
    }
    if (columns_.name >= row.size() || row[columns_.name].text.empty()) {
      reader_->fail(row.front(), "a row without a name; name the part");
    }
    const Field& name = row[columns_.name];
    take_name(name);
    if (!take_quantity(row, name)) {
      return;
    }
    if (list_.names.size() == max_parts) {
      reader_->fail(name, fmt::format("more than {} parts; plan for fewer at a time", max_parts));
    }
    list_.names.push_back(name.text);
    list_.change_costs.emplace_back();
    if (columns_.cost && *columns_.cost < row.size() && !has_no_cost(row[*columns_.cost].text)) {
      list_.change_costs.back() = costs_.read(row[*columns_.cost]);
    }
    if (columns_.slot) {
      const bool is_in_one = *columns_.slot < row.size() && !says_none(row[*columns_.slot].text);
      list_.slots.push_back(is_in_one ? row[*columns_.slot].text : "");
      if (!list_.slots.back().empty()) {
        check_name(*reader_, row[*columns_.slot]);
      }
    }
  }

  PartList finish() {
    leave_out_total();
    if (list_.names.empty()) {
      fail(input_->name(), {}, "no part is listed; write one per line");
    }
    list_.unit = costs_.unit() == CostUnit::none ? columns_.unit : costs_.unit();
    list_.note = note();
    return std::move(list_);
  }

 private:
  void check_fields(const Row& row) const {
    if (row.size() > fields_ && !columns_.header) {
      reader_->fail(
          row[fields_],
          "a third field; write a name and a change cost, or a header with a word for each "
          "column, and quote a name with a comma");
    }
    if (row.size() > fields_ &&
        !reader_->is_workbook()) {  // in a workbook that is a note beside the table
      reader_->fail(row[fields_], fmt::format("more fields than the {} of the header; quote those "
                                              "with a comma",
                                              fields_));
    }
  }

  [[nodiscard]] bool has_no_cost(const std::string& text) const {
    return text.empty() || (costs_may_lack_ && says_none(text));
  }

  static std::ptrdiff_t fields_in(const Row& row) {
    return std::ranges::count_if(row, [](const Field& field) { return !field.text.empty(); });
  }

  // A line alone below an empty one, where all parts above have more fields: the date of the list,
  // say, which would be a part with the cost of parts without one.
  void check_footnote(const Row& row) const {
    const bool is_shorter = reader_->is_workbook() || row.size() < fields_;
    if (columns_.header && !list_.names.empty() && only_full_ && is_shorter &&
        fields_in(row) == 1) {
      const Field& text =
          *std::ranges::find_if(row, [](const Field& f) { return !f.text.empty(); });
      reader_->fail(text,
                    fmt::format("{} stands alone below an empty line and may be a footnote or "
                                "a part; remove it, or the empty line",
                                shown(text.text)));
    }
  }

  void take_name(const Field& name) {
    check_name(*reader_, name);
    if (!seen_.insert(name.text).second) {
      reader_->fail(name, fmt::format("a second part is called {}; rename one", shown(name.text)));
    }
    const std::string look = visible(name.text);
    if (look.empty()) {
      reader_->fail(name, "the name has no visible character; name the part");
    }
    if (!looks_.insert(look).second) {
      reader_->fail(name, fmt::format("a second part looks like {}: the names differ in characters "
                                      "that cannot be seen; rename one",
                                      shown(look)));
    }
  }

  // Whether a text behind a number says that it counts pieces: "", "pcs", "x".
  static bool is_of_pieces(std::string_view rest) {
    constexpr auto words = std::to_array<std::string_view>(
        {"",    "x",    "×",     "pc",  "pcs", "pc.",  "pcs.",  "piece", "pieces", "off", "ea",
         "stk", "stk.", "stück", "st.", "pce", "unit", "units", "個",    "个",     "개"});
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    return std::ranges::find(words, lower_case(rest)) != words.end();
  }

  // Reads the quantity; false if there are no pieces of the part.
  bool take_quantity(const Row& row, const Field& name) {
    if (!columns_.quantity) {
      return true;
    }
    std::uint64_t quantity = 1;
    if (*columns_.quantity < row.size() && !says_none(row[*columns_.quantity].text)) {
      const Field& field = row[*columns_.quantity];
      const char* const end = field.text.data() + field.text.size();
      const auto [rest, failure] = std::from_chars(field.text.data(), end, quantity);
      if (failure != std::errc() || !is_of_pieces({rest, end})) {
        reader_->fail(field, fmt::format("{} is not a number of pieces; write a whole number, as 4",
                                         shown(field.text)));
      }
    }
    if (quantity == 0) {
      none_left_.push_back(name.text);
      return false;
    }
    list_.quantities.push_back(quantity);
    return true;
  }

  // A last row with the sum of the others is not a part.
  void leave_out_total() {
    constexpr auto words = std::to_array<std::string_view>(
        {"total", "totals", "sum", "summe", "gesamt", "totale", "somme", "suma", "soma", "totaal"});
    std::string name = list_.names.empty() ? "" : lower_case(list_.names.back());
    name.resize(name.find_last_not_of(" :") + 1);
    const auto& costs = list_.change_costs;
    if (!columns_.header || costs.size() < 3 || std::ranges::find(words, name) == words.end() ||
        !std::ranges::all_of(costs, [](const auto& cost) { return cost.has_value(); })) {
      return;
    }
    Amount sum;
    for (std::size_t i = 0; i + 1 < costs.size(); ++i) {
      sum += *costs[i];
    }
    if (sum == *costs.back()) {
      total_ = list_.names.back();
      list_.names.pop_back();
      list_.change_costs.pop_back();
      list_.slots.resize(std::min(list_.slots.size(), list_.names.size()));
      list_.quantities.resize(std::min(list_.quantities.size(), list_.names.size()));
    }
  }

  [[nodiscard]] std::string note() const {
    std::string text = reader_->is_given() ? "" : columns_.note;
    const auto add = [&](const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
    if (!total_.empty()) {
      add(fmt::format("the last row, {}, is a sum and no part", shown(total_)));
    }
    if (!none_left_.empty()) {
      add(fmt::format("left out, since there is none: {}", joined(none_left_, shown)));
    }
    return text.empty() ? "" : fmt::format("{}: {}", input_->name(), text);
  }

  const Input* input_;
  const RowReader* reader_;
  PartColumns columns_;
  std::size_t fields_;
  bool costs_may_lack_;
  CostReader costs_;
  PartList list_;
  std::unordered_set<std::string> seen_;
  std::unordered_set<std::string> looks_;
  std::vector<std::string> none_left_;
  std::string total_;
  bool only_full_ = true;  // all rows so far have more than one field
};

}  // namespace

PartList read_parts(Input& input, Header header) {
  return read_parts(input, PartListOptions{.header = header});
}

PartList read_parts(Input& input, const PartListOptions& options) {
  constexpr std::size_t most_above = 12;  // a header, and what is above it
  RowReader reader(input);
  std::vector<Row> rows;  // more than a header can need
  std::vector<bool> after_blank;
  while (auto next = rows.size() < max_parts + most_above ? reader.next() : std::nullopt) {
    rows.push_back(std::move(*next));
    after_blank.push_back(reader.after_blank());
  }
  if (rows.empty()) {
    fail(input.name(), {}, "no part is listed; write one per line");
  }
  const PartColumns columns = part_columns(rows, options, reader);
  constexpr std::size_t most_without_header = 2;
  PartReader parts(input, reader, columns,
                   columns.header ? rows[columns.above].size() : most_without_header,
                   options.costs_may_lack);
  for (std::size_t i = columns.above + (columns.header ? 1 : 0); i < rows.size(); ++i) {
    parts.take(rows[i], after_blank[i]);
  }
  return parts.finish();
}

}  // namespace changeover
