// Reads lists of pairs: needed or forbidden ones, and weights.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"
#include "core/printable.hpp"
#include "io/scan/place.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/part_finder.hpp"
#include "plan/job/parts/heading_words.hpp"

namespace changeover {
namespace {

// The fields of a row that are the pair, and the one with a remark on it.
struct PairColumns {
  bool header = false;
  std::size_t one = 0;
  std::size_t other = 1;
  std::optional<std::size_t> third = 2;
};

// A header has two words that are column names of parts, neither of which is a part in any case,
// and no part.
PairColumns pair_columns(const Row& first, bool (*heads_third)(std::string_view),
                         const PartFinder& finder, const RowReader& reader) {
  std::vector<std::size_t> parts;
  std::optional<std::size_t> third;
  std::optional<std::size_t> rest;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const std::string& text = first[i].text;
    if (parts.size() < 2 && heads_part_of_pair(text) && !heads_third(text) && !finder.find(text) &&
        !finder.is_name_in_any_case(text)) {
      parts.push_back(i);
    } else if (!text.empty()) {
      third = third || !heads_third(text) ? third : i;
      rest = rest ? rest : i;
    }
  }
  const bool has_part = std::ranges::any_of(
      first, [&](const Field& field) { return finder.find(field.text).has_value(); });
  if (reader.is_given() || parts.size() < 2 || has_part) {
    return {};
  }
  return {true, parts[0], parts[1], third ? third : rest};
}

class PairReader {
 public:
  PairReader(Input& input, const PartNames& names)
      : reader_(input, {.blanks = true}), finder_(names, numbers_in(reader_)) {}

  [[nodiscard]] const RowReader& reader() const { return reader_; }

  // The next row after the header.
  std::optional<Row> next(bool (*heads_third)(std::string_view)) {
    auto row = reader_.next();
    if (row && std::exchange(is_first_, false)) {
      finder_.restore_blanks(*row);
      Row words = *row;
      split_at_blanks(words, finder_, reader_);
      columns_ =
          pair_columns(words.size() == row->size() ? *row : words, heads_third, finder_, reader_);
      fields_ = row->size();
      if (columns_.header) {
        row = reader_.next();
      }
    }
    if (row) {
      finder_.restore_blanks(*row);
      came_in_fields_ = row->size() > 1;
      split_at_blanks(*row, finder_, reader_);
      if (columns_.header && row->size() > fields_ && !reader_.is_workbook()) {
        reader_.fail((*row)[fields_],
                     fmt::format("more fields than the {} of the header; quote those with a comma",
                                 fields_));
      }
    }
    return row;
  }

  // The field with the remark on the pair, if there is one.
  [[nodiscard]] const Field* third(const Row& row) const {
    const bool is_there = columns_.third && *columns_.third < row.size() && came_in_fields_;
    return is_there && !row[*columns_.third].text.empty() ? &row[*columns_.third] : nullptr;
  }
  [[nodiscard]] bool is_part(const Field& field) const {
    return finder_.find(field.text).has_value();
  }
  [[nodiscard]] bool has_header() const { return columns_.header; }
  [[nodiscard]] std::size_t parts() const { return finder_.size(); }

  // Whether the pair has a part that no longer exists; its names are added to `gone`.
  [[nodiscard]] bool is_gone(const Row& row, std::vector<std::string>* gone) {
    bool some = false;
    for (const std::size_t i : {columns_.one, columns_.other}) {
      if (i < row.size() && came_in_fields_) {
        some = finder_.some_gone({&row[i], 1}, reader_, gone, true) || some;
      }
    }
    return some;
  }

  // The pair; `example` is shown if the row has none.
  [[nodiscard]] std::pair<Element, Element> pair(const Row& row, std::string_view example) const {
    Row parts;
    for (const std::size_t i : {columns_.one, columns_.other}) {
      if (i < row.size()) {
        parts.push_back(row[i]);
      }
    }
    const Block pair = find_parts(
        finder_, parts, [&](const std::string& word) { return finder_.find(word); },
        [&](const Field& field, const std::string& what) { reader_.fail(field, what); });
    if (pair.size() != 2) {
      reader_.fail(row.front(), fmt::format("only one part; write a pair as {}", example));
    }
    return {pair[0], pair[1]};
  }

 private:
  RowReader reader_;
  PartFinder finder_;
  PairColumns columns_;
  std::size_t fields_ = 0;
  bool is_first_ = true;
  bool came_in_fields_ = false;
};

// A decimal comma is allowed if commas do not separate fields.
std::optional<Amount> weight_in(const Field& field, const RowReader& reader) {
  std::string text = field.text;
  if (reader.separator() != ',' && std::ranges::count(text, ',') == 1) {
    text[text.find(',')] = '.';
  }
  try {
    return parse_amount(text);
  } catch (const Error&) {
    return std::nullopt;
  }
}

PairSet pairs_in(Input& input, const PartNames& names, PairReasons* why,
                 std::vector<std::string>* gone) {
  PairReader rows(input, names);
  PairSet pairs(rows.parts());
  while (const auto row = rows.next(heads_reasons)) {
    const Field* const third = rows.third(*row);
    constexpr std::size_t most_fields = 3;
    const bool has_reason = third != nullptr && (rows.has_header() || rows.reader().is_given() ||
                                                 !rows.is_part(*third));
    if (!rows.has_header() &&
        (row->size() > most_fields ||
         (row->size() == most_fields && !has_reason && third != nullptr) ||
         (row->size() == most_fields && third == nullptr && !row->back().text.empty()))) {
      rows.reader().fail(row->front(), "more than two parts; write a pair as A,B");
    }
    if (rows.is_gone(*row, gone)) {
      continue;
    }
    const auto [one, other] = rows.pair(*row, "A,B");
    pairs.insert(one, other);
    if (why != nullptr && has_reason) {
      why->set(one, other, third->text);
    }
  }
  return pairs;
}

}  // namespace

PairSet read_pairs(Input& input, const std::vector<std::string>& names, PairReasons* why,
                   std::vector<std::string>* gone) {
  return pairs_in(input, names, why, gone);
}

PairSet read_pairs(Input& input, const Job& job, PairReasons* why) {
  return pairs_in(input, job, why, nullptr);
}

PairWeights read_priorities(Input& input, const std::vector<std::string>& names,
                            std::vector<std::string>* gone) {
  PairReader rows(input, names);
  PairWeights weights;
  std::set<std::uint64_t> seen;
  while (const auto row = rows.next(heads_weights)) {
    constexpr std::size_t fields = 3;
    if (!rows.has_header() && row->size() != fields) {
      rows.reader().fail(row->front(),
                         "expected a pair with its weight; write A,B,5, one pair per line");
    }
    const Field& said =
        rows.has_header() && rows.third(*row) != nullptr ? *rows.third(*row) : row->back();
    if (weight_in(said, rows.reader()) && rows.is_gone(*row, gone)) {
      continue;
    }
    const auto [one, other] = rows.pair(*row, "A,B,5");
    const auto weight = weight_in(said, rows.reader());
    if (!weight) {
      rows.reader().fail(said, fmt::format("{} is not a weight; write a number from 0 to 9e12, "
                                           "with at most six decimals, as in A,B,2.5",
                                           shown(said.text)));
    }
    if (!seen.insert(PairSet::rank(one, other)).second && weights(one, other) != *weight) {
      rows.reader().fail(
          said,
          fmt::format("{} and {} have the weight {} on an earlier line; remove one of the two",
                      names[one], names[other], to_string(weights(one, other))));
    }
    weights.set(one, other, *weight);
  }
  if (weights.empty() && (gone == nullptr || gone->empty())) {
    fail(input.name(), {}, "no pair is listed; write A,B,5, one pair and its weight per line");
  }
  return weights;
}

}  // namespace changeover
