#include "plan/job/setups/gone_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "core/contains.hpp"
#include "core/each.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/write/csv_cell.hpp"
#include "plan/job/parts/heading_words.hpp"
#include "plan/job/setups/hidden_tests.hpp"
#include "plan/model/model_names.hpp"

namespace changeover {
namespace {

// Whether a head is that of a column which is no parameter.
bool is_of_the_users_own(const std::string& head) {
  return own_head_meant(head) != nullptr || heads_results(head) || heads_steps(head) ||
         heads_occasions(head) || heads_remarks(head);
}

// Whether something says that the program wrote the sheet. A list by hand has columns of the user's
// own anywhere.
bool is_run_sheet(const Heads& heads, const SetupColumns& columns) {
  return columns.step || std::ranges::any_of(heads, [](const std::string& head) {
           const OwnHead* const own = own_head_meant(head);
           return (own != nullptr && (own->is_planned || own->counts_new)) ||
                  place_in(csv_text(head));
         });
}

// Where unknown heads are those of parameters: behind what the program writes before them, and
// before what it writes behind them. Beyond that, columns are of the user's own.
std::pair<std::size_t, std::size_t> among_parameters(const Heads& heads,
                                                     const SetupColumns& columns) {
  const auto is_other = [&](std::size_t i) {
    return (columns.have(i) && !contains(columns.slots, i)) || is_of_the_users_own(heads[i]);
  };
  std::size_t begin = columns.slots.front();
  for (std::size_t i = begin; i-- > 0;) {
    const OwnHead* const own = own_head_meant(heads[i]);
    if (i == columns.step || (own != nullptr && own->is_planned)) {
      begin = i + 1;
      break;
    }
  }
  std::size_t end = columns.slots.back() + 1;
  while (end < heads.size() && !is_other(end)) {
    ++end;
  }
  return {begin, end < heads.size() ? end : columns.slots.back() + 1};
}

void refuse_a_slip(const Field& head, const std::string& name,
                   const std::vector<std::string>& parameters, const RowReader& reader) {
  if (const auto meant = parameter_meant(name, parameters)) {
    reader.fail(head, fmt::format("no parameter is called {}; did you mean {}? if it is "
                                  "another one, rename the column",
                                  shown(name), shown(*meant)));
  }
}

}  // namespace

void GoneParameters::find(const Row& header, const PartFinder& finder, const RowReader& reader,
                          SetupColumns& columns) {
  if (columns.parameters.empty()) {
    return;
  }
  names_ = finder.model();
  const Heads heads = each_of<std::string>(header, &Field::text);
  const std::vector<std::string> others = parameters_without_column(columns, names_->model());
  std::vector<std::size_t> may_be;
  for (const std::string& name : others) {
    may_be.push_back(*names_->parameter(name));
  }
  is_by_hand_ = !is_run_sheet(heads, columns);
  const auto is_users = [&](const std::string& head) {
    return is_of_the_users_own(head) || (is_by_hand_ && heads_times(head));
  };
  const auto [begin, end] = among_parameters(heads, columns);
  for (std::size_t i = 0; i < heads.size(); ++i) {
    const std::string name = parameter_in(heads[i]);
    const bool is_among = begin <= i && i < end && !name.empty();
    if ((!is_among && name == csv_text(heads[i])) || columns.have(i) || names_->parameter(name) ||
        own_head_meant(heads[i]) != nullptr) {
      continue;
    }
    refuse_a_slip(header[i], name, others, reader);
    if (is_users(heads[i]) && !place_in(csv_text(heads[i]))) {
      continue;
    }
    const auto at = std::ranges::lower_bound(columns.slots, i) - columns.slots.begin();
    columns.slots.insert(columns.slots.begin() + at, i);
    columns.parameters.insert(columns.parameters.begin() + at, SetupColumns::gone);
    columns_.push_back({.slot = 0, .head = &header[i], .may_be = may_be});
  }
  for (std::size_t i = 0; i < heads.size(); ++i) {
    const bool is_known =
        columns.have(i) || heads[i].empty() || is_users(heads[i]) || heads_row_numbers(heads[i]);
    const bool is_before = i < columns.slots.front();
    if (!is_known && is_before) {
      before_.push_back(&header[i]);
    }
    if (!is_known && is_by_hand_ && (is_before || !columns.result)) {
      beside_.push_back(i);
    }
  }
  std::size_t next = 0;
  for (std::size_t slot = 0; slot < columns.slots.size(); ++slot) {
    if (columns.is_gone(slot)) {
      columns_[next++].slot = slot;
    }
  }
}

void GoneParameters::take(std::size_t slot, const std::string& text) {
  Column& column = *std::ranges::find(columns_, slot, &Column::slot);
  if (!text.empty()) {
    column.has_values = true;
    std::erase_if(column.may_be, [&](std::size_t p) { return !names_->value(p, text); });
  }
}

void GoneParameters::look_beside(const Row& row, const PartFinder& finder, DoneRow& done) const {
  for (const std::size_t i : beside_) {
    if (i < row.size() && row[i].text.find(' ') == std::string::npos) {
      keep_if_hiding(finder, row[i].text, std::nullopt, done);
    }
  }
}

void GoneParameters::say(const RowReader& reader, DoneList& list) const {
  for (const Column& column : columns_) {
    std::string instead;
    if (column.has_values && !column.may_be.empty()) {
      const std::string& name = names_->model().parameters[column.may_be.front()].name;
      instead = fmt::format("; if it is {}, whose values it has, head it so", shown(name));
    }
    list.notes.push_back(
        is_by_hand_ ? not_read(*column.head, reader) + instead
                    : fmt::format("{}: the parameter {} is no longer in the model, so its column "
                                  "is not read{}",
                                  reader.place(*column.head),
                                  shown(parameter_in(column.head->text)), instead));
  }
  for (const Field* const head : before_) {
    list.notes.push_back(not_read(*head, reader));
  }
}

std::string GoneParameters::not_read(const Field& head, const RowReader& reader) const {
  return fmt::format(
      "{}: the column {} is not read; if it is a parameter that the model had, head it {}",
      reader.place(head), shown(head.text),
      shown(fmt::format("slot_{} {}", names_->model().parameters.size() + 1, head.text)));
}

void note_unread_columns(const Row& header, const PartFinder& finder, const RowReader& reader,
                         const SetupColumns& columns, std::vector<std::string>& notes) {
  if (columns.parameters.empty()) {
    return;
  }
  const std::vector<std::string> others =
      parameters_without_column(columns, finder.model()->model());
  for (std::size_t i = 0; i < header.size() && !others.empty(); ++i) {
    const std::string name = parameter_in(header[i].text);
    if (name.empty() || columns.have(i) || own_head_meant(name) != nullptr ||
        finder.model()->parameter(name)) {
      continue;
    }
    refuse_a_slip(header[i], name, others, reader);
    notes.push_back(fmt::format(
        "{}: no parameter is called {}, so its column is not read, and no column has the values "
        "of {}",
        reader.place(header[i]), shown(name), joined(others, shown)));
  }
}

}  // namespace changeover
