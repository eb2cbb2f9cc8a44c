// Finds parts by their names or numbers.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/plan/job.hpp"
#include "core/printable.hpp"
#include "core/spelling.hpp"
#include "core/words.hpp"
#include "io/scan/place.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/model/model_names.hpp"

namespace changeover {

/// Whether a number that is not a name stands for a part.
enum class PartNumbers {
  count,  ///< it does
  /// It does not if the name of some part is a number: then it would be a wrong name.
  unless_names_are_so
};

/// The names of parts. The list and the model must outlive this.
struct PartNames {
  const std::vector<std::string>* names;
  const Model* model =
      nullptr;  ///< if set, parts are its values: they have further names, and no numbers

  PartNames(const std::vector<std::string>& all) : names(&all) {}
  PartNames(const Job& job) : names(&job.names), model(job.model.get()) {}
};

/// Parts by name or number.
class PartFinder {
 public:
  explicit PartFinder(const PartNames& all, PartNumbers numbers = PartNumbers::count)
      : names_(all.names), numbers_count_(true) {
    if (all.model != nullptr) {
      of_model_.emplace(*all.model);
    }
    numbers_count_ = !of_model_ && (numbers == PartNumbers::count || !has_number_as_name());
    const std::vector<std::string>& names = *names_;
    for (std::size_t i = 0; i < names.size(); ++i) {
      by_name_.emplace(names[i], static_cast<Element>(i));
      in_small_letters_.insert(lower_case(names[i]));
      if (const std::string look = visible(names[i]); look != names[i]) {
        by_look_.emplace(look, static_cast<Element>(i));
      }
    }
  }

  [[nodiscard]] std::optional<Element> find(const std::string& word) const {
    if (const auto found = by_name_.find(word); found != by_name_.end()) {
      return found->second;
    }
    if (of_model_) {
      return of_model_->part(word);
    }
    // A name with other kinds of blanks: no two names of a list look the same.
    if (!by_look_.empty()) {
      if (const auto found = by_look_.find(visible(word)); found != by_look_.end()) {
        return found->second;
      }
    }
    return numbers_count_ ? part_number(word) : std::nullopt;
  }

  // Finds the part of a cell, which has `text` if csv_cell() wrote it and not a spreadsheet.
  [[nodiscard]] std::optional<Element> find_cell(const std::string& cell, const std::string& text,
                                                 bool names_only) const {
    if (names_only && !of_model_) {
      const auto found = by_name_.find(is_name(text) ? text : cell);
      return found == by_name_.end() ? std::nullopt : std::optional(found->second);
    }
    const auto part = find(text);
    return part ? part : find(cell);
  }

  [[nodiscard]] bool has_number_as_name() const {
    return std::ranges::any_of(*names_, [](const std::string& name) {
      return name.find_first_not_of("0123456789") == std::string::npos;
    });
  }

  /// The names of the model whose values the parts are; null for other parts.
  [[nodiscard]] const ModelNames* model() const { return of_model_ ? &*of_model_ : nullptr; }
  [[nodiscard]] const std::string& name(Element part) const { return (*names_)[part]; }
  [[nodiscard]] bool is_name(const std::string& word) const { return by_name_.count(word) != 0; }
  [[nodiscard]] bool is_name_in_any_case(const std::string& word) const {
    return in_small_letters_.count(lower_case(word)) != 0;
  }
  [[nodiscard]] std::size_t size() const { return names_->size(); }
  // Whether it may be the name of a part that no longer exists: not a number, and no name that
  // differs only in case.
  [[nodiscard]] bool may_be_gone(const std::string& word) const {
    return word.find_first_not_of("0123456789") != std::string::npos && !find(word) &&
           !is_name_in_any_case(word);
  }
  // Whether one of these fields is such a name; these are added to `gone`, each once, on request
  // with their places. Rows that were sent are not an old list, so they have none.
  [[nodiscard]] bool some_gone(std::span<const Field> fields, const RowReader& reader,
                               std::vector<std::string>* gone, bool with_places = false) {
    if (gone == nullptr || reader.is_given()) {
      return false;
    }
    bool some = false;
    for (const Field& field : fields) {
      if (may_be_gone(field.text)) {
        some = true;
        if (gone_.insert(field.text).second) {
          gone->push_back(with_places ? fmt::format("{} ({})", field.text, reader.place(field))
                                      : field.text);
        }
      }
    }
    return some;
  }

  // Names that begin or end with blanks need quotes in text; in a workbook they are complete.
  void restore_blanks(Row& row) const {
    for (Field& field : row) {
      if (!field.in_full.empty() && is_name(field.in_full)) {
        field.text = field.in_full;
      }
    }
  }

  // The message for an unknown part; names a part that differs only in case, if there is one.
  [[nodiscard]] std::string complaint(const std::string& word) const {
    if (of_model_) {
      return of_model_->complaint(word);
    }
    for (const std::string& name : *names_) {
      if (lower_case(name) == lower_case(word)) {
        return fmt::format("there is no part {}; did you mean {}?", shown(word), shown(name));
      }
    }
    if (are_several(word)) {
      return fmt::format("{} is several parts; write one part per field", shown(word));
    }
    // To a short name or a number, every other one is near.
    constexpr std::size_t least_letters = 3;
    const bool is_word =
        word.size() >= least_letters && word.find_first_not_of("0123456789") != std::string::npos;
    if (const auto nearest = is_word ? nearest_word(word, *names_) : std::nullopt) {
      return fmt::format("there is no part {}; did you mean {}?", shown(word),
                         shown(without_piece(*nearest)));
    }
    // Where only names count, a number that another list could have is none.
    return numbers_count_ && !part_number(word)
               ? fmt::format(
                     "there is no part {}; give a name of the parts list or a number from 1 to {}",
                     shown(word), names_->size())
               : fmt::format("there is no part {}; give a name of the parts list", shown(word));
  }

  // The names of parts in a text between these separators; nothing if one of them is no name.
  [[nodiscard]] std::vector<std::string> names_between(const std::string& text,
                                                       std::string_view separators) const {
    std::vector<std::string> found;
    std::size_t begin = 0;
    while (begin <= text.size()) {
      const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
      const std::size_t first = std::min(text.find_first_not_of(' ', begin), end);
      const std::size_t last = text.find_last_not_of(' ', end - 1);
      found.push_back(first == end ? "" : text.substr(first, last + 1 - first));
      if (!is_name(found.back()) && !(of_model_ && find(found.back()))) {
        return {};
      }
      begin = end + 1;
    }
    return found;
  }

 private:
  // The part with this number, from 1.
  [[nodiscard]] std::optional<Element> part_number(const std::string& word) const {
    std::size_t number = 0;
    const char* const end = word.data() + word.size();
    const auto [rest, failure] = std::from_chars(word.data(), end, number);
    if (failure == std::errc() && rest == end && number >= 1 && number <= names_->size()) {
      return static_cast<Element>(number - 1);
    }
    return std::nullopt;
  }

  // The part of which this is a further piece: "DIMM A #2" without its number.
  [[nodiscard]] std::string without_piece(const std::string& name) const {
    const std::string part = name.substr(0, name.rfind(" #"));
    return is_name(part) ? part : name;
  }

  [[nodiscard]] bool are_several(const std::string& word) const {
    return names_between(word, ",;/+&").size() > 1;
  }

  const std::vector<std::string>* names_;
  bool numbers_count_;
  std::optional<ModelNames> of_model_;
  std::unordered_map<std::string, Element> by_name_;
  std::unordered_map<std::string, Element> by_look_;  // of names that do not look as written
  std::unordered_set<std::string> in_small_letters_;
  std::unordered_set<std::string> gone_;
};

/// The rule for these rows: rows that are not from a file come from a program, whose numbers may be
/// names.
[[nodiscard]] inline PartNumbers numbers_in(const RowReader& reader) {
  return reader.is_given() ? PartNumbers::unless_names_are_so : PartNumbers::count;
}

/// Splits parts that are separated by blanks only ("1 2 3") and come as one field; a part name with
/// blanks does, too.
inline void split_at_blanks(Row& row, const PartFinder& finder, const RowReader& reader) {
  if (row.size() == 1 && (!row.front().in_quotes || reader.is_workbook()) &&
      !finder.find(row.front().text)) {
    row = at_blanks(row.front(), reader);
  }
}

/// The parts of some fields, none twice; reports the field at fault. `find` is given its text.
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
      fail(field, fmt::format("{} occurs twice; remove one", shown(field.text)));
    }
    seen[*part] = true;
    parts.push_back(*part);
  }
  return parts;
}

}  // namespace changeover
