#include "plan/job/setups/extra_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ranges>

#include "changeover/core/error.hpp"
#include "core/contains.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/write/csv_cell.hpp"
#include "plan/job/setups/results.hpp"

namespace changeover {
namespace {

bool is_filled(const Field& field) { return !field.text.empty(); }

const std::string& text_at(const Row& row, std::size_t column) {
  static const std::string none;
  return column < row.size() ? row[column].text : none;
}

// Whether two rows say the same, in whatever case; a row may lack empty fields at its end.
bool say_the_same(const Row& one, const Row& other) {
  for (std::size_t i = 0; i < std::max(one.size(), other.size()); ++i) {
    if (lower_case(text_at(one, i)) != lower_case(text_at(other, i))) {
      return false;
    }
  }
  return true;
}

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789.") == std::string::npos;
}

// Whether a row may be a header by one look at it: most rows are not.
bool may_be_heads(const Row& row, const Row& header, const SetupColumns& columns,
                  const PartFinder& finder) {
  const std::size_t parts = columns.list            ? *columns.list
                            : columns.slots.empty() ? 0
                                                    : columns.slots.front();
  const std::string& first = text_at(row, parts);
  const auto has_its_head = [&](std::optional<std::size_t> column) {
    return column && is_filled(header[*column]) && text_at(row, *column) == header[*column].text;
  };
  return place_in(first) || first == "set_up" || has_its_head(columns.step) ||
         has_its_head(columns.result) ||
         (finder.model() != nullptr && finder.model()->parameter(csv_text(first)));
}

// Whether a row has something in a column of parts.
bool has_parts(const Row& row, const SetupColumns& columns) {
  return (columns.list && !text_at(row, *columns.list).empty()) ||
         std::ranges::any_of(columns.slots,
                             [&](std::size_t at) { return !text_at(row, at).empty(); });
}

// Whether a word heads a line of sums.
bool heads_sums(std::string_view text) {
  constexpr auto words = std::to_array<std::string_view>(
      {"total", "totals", "sum", "sums", "subtotal", "summe", "gesamt", "somme", "suma", "totale"});
  std::string word = lower_case(text);
  while (word.ends_with(':') || word.ends_with(' ')) {
    word.pop_back();
  }
  return contains(words, std::string_view(word));
}

// Whether the columns of parts of a row have one word, and that of a line of sums.
bool is_of_sums(const Row& row, const SetupColumns& columns, const PartFinder& finder) {
  const std::string* only = nullptr;
  std::size_t filled = 0;
  for (const std::size_t at : columns.slots) {
    only = text_at(row, at).empty() ? only : &text_at(row, at);
    filled += text_at(row, at).empty() ? 0U : 1U;
  }
  return filled == 1 && heads_sums(*only) && !finder.is_name_in_any_case(*only);
}

// Whether a row is one word that is no part and no number, as the name of a day is.
bool is_title(const Row& row, const PartFinder& finder) {
  const auto word = std::ranges::find_if(row, is_filled);
  return std::ranges::count_if(row, is_filled) == 1 && !is_number(word->text) &&
         !finder.find(word->text) && !finder.find(std::string(csv_text(word->text))) &&
         !finder.is_name_in_any_case(word->text);
}

}  // namespace

ExtraRows::Kind ExtraRows::take(const Row& row, const Row& header, const SetupColumns& columns,
                                const PartFinder& finder, const RowReader& reader) {
  const auto skip = [&](Kind kind, const std::string& what) {
    const std::string place = reader.place(row.front());
    first_ = names_.empty() ? place : first_;
    names_.push_back(fmt::format("{}{}", row.front().line, what.empty() ? "" : " (" + what + ")"));
    return kind;
  };
  if (say_the_same(row, header)) {
    return skip(Kind::heads, "the heads again");
  }
  if (may_be_heads(row, header, columns, finder) && setup_columns(row, finder, false).header) {
    reader.fail(row.front(),
                fmt::format("these headings differ from those in row {}; give one sheet at a "
                            "time, or order its columns as those above",
                            header.front().line));
  }
  const std::string& result = columns.result ? text_at(row, *columns.result) : std::string();
  const bool has_result = was_run(result);
  if (is_title(row, finder) && !has_result) {
    return skip(Kind::other, shown(std::ranges::find_if(row, is_filled)->text));
  }
  const bool is_cut = !columns.slots.empty() && row.size() <= columns.slots.back();
  if ((has_parts(row, columns) && !is_of_sums(row, columns, finder)) || is_cut) {
    return Kind::test;
  }
  if (has_result) {
    reader.fail(row[*columns.result],
                fmt::format("the result {}, but the row has no set-up; write its parts, or remove "
                            "the result",
                            shown(result)));
  }
  const std::string& step = columns.step ? text_at(row, *columns.step) : std::string();
  if (is_number(step) && !numbered_) {
    numbered_ = reader.place(row.front());
  }
  const auto word = std::ranges::find_if(
      row, [](const Field& field) { return is_filled(field) && !is_number(field.text); });
  return skip(Kind::other, word == row.end() ? "" : shown(word->text));
}

void ExtraRows::say(DoneList& list) const {
  if (names_.empty()) {
    return;
  }
  if (numbered_ && !list.has_results()) {
    throw BadInput(*numbered_ + ": a row without a set-up; remove it or complete it");
  }
  constexpr std::size_t few = 10;
  std::string rows = joined(names_ | std::views::take(few));
  if (names_.size() > few) {
    rows += fmt::format(" and {} more", names_.size() - few);
  }
  const bool is_one = names_.size() == 1;
  list.notes.push_back(fmt::format("{}: skipped, as {}: {} {}", first_,
                                   is_one ? "it is not a test" : "they are not tests",
                                   is_one ? "row" : "rows", rows));
}

}  // namespace changeover
