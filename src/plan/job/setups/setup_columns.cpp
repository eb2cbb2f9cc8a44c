#include "plan/job/setups/setup_columns.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "core/each.hpp"
#include "core/words.hpp"
#include "io/write/csv_cell.hpp"
#include "plan/job/parts/heading_words.hpp"
#include "plan/model/model_text.hpp"

namespace changeover {

std::optional<DonePlace> place_in(std::string_view head) {
  constexpr std::string_view word = "slot";
  if (lower_case(head.substr(0, word.size())) != word) {
    return std::nullopt;
  }
  head.remove_prefix(word.size());
  if (head.starts_with('_') || head.starts_with(' ') || head.starts_with('-')) {
    head.remove_prefix(1);
  }
  DonePlace place;
  const char* const end = head.data() + head.size();
  const auto [rest, failure] = std::from_chars(head.data(), end, place.number);
  if (failure != std::errc() || (rest != end && *rest != ' ')) {
    return std::nullopt;
  }
  place.slot = rest == end ? "" : std::string(rest + 1, end);
  return place;
}

namespace {

// A head as the program writes its own: "New pairs" as "new_pairs".
std::string in_our_letters(std::string_view head) {
  std::string text = lower_case(head);
  std::ranges::replace(text, ' ', '_');
  return text;
}

// The first column that is not taken and whose head is as asked.
template <class Is>
std::optional<std::size_t> first_column(const Heads& heads, const std::vector<bool>& taken,
                                        Is&& is) {
  for (std::size_t i = 0; i < heads.size(); ++i) {
    if ((i >= taken.size() || !taken[i]) && is(heads[i])) {
      return i;
    }
  }
  return std::nullopt;
}

// Whether a head is one of ours that is so.
auto is_own(bool OwnHead::*so) {
  return [so](std::string_view head) {
    const OwnHead* const own = own_head_meant(head);
    return own != nullptr && own->*so;
  };
}

bool heads_a_setup(std::string_view text) {
  const std::string head = in_our_letters(text);
  return head == "set_up" || head == "put_in" || head == "set" || place_in(text).has_value();
}

// The column that follows the figures, if there is one of them that no list but a run sheet has.
std::optional<std::size_t> column_after_figures(const Heads& heads,
                                                const std::vector<bool>& taken) {
  const auto last = std::ranges::find_if(heads.rbegin(), heads.rend(), is_own(&OwnHead::is_figure));
  auto column = static_cast<std::size_t>(heads.rend() - last);
  while (column < heads.size() && heads_occasions(heads[column])) {
    ++column;
  }
  const bool is_free = column < heads.size() && lower_case(heads[column]) != "notes" &&
                       (column >= taken.size() || !taken[column]);
  return is_free && std::ranges::any_of(heads, is_own(&OwnHead::counts_new)) ? std::optional(column)
                                                                             : std::nullopt;
}

// The parameter of a column, with the heading that sheets give it: "slot_3 cost" if another column
// has its name.
struct HeadedParameter {
  std::size_t parameter = 0;
  bool by_slot = false;
};

std::optional<HeadedParameter> headed_parameter(const ModelNames& model, const std::string& cell) {
  const std::string head(csv_text(cell));
  if (const auto place = place_in(head); place && !place->slot.empty()) {
    if (const auto found = model.parameter(place->slot)) {
      return HeadedParameter{*found, true};
    }
  }
  const auto found = model.parameter(head);
  return found ? std::optional(HeadedParameter{*found, false}) : std::nullopt;
}

// The columns beside the set-up.
void find_beside(const Row& first, const std::vector<bool>& taken, SetupColumns& columns) {
  const Heads heads = each_of<std::string>(first, &Field::text);
  const auto called = [&](std::string_view word) {
    return first_column(heads, taken,
                        [&](const std::string& head) { return lower_case(head) == word; });
  };
  columns.step = step_column(heads, taken);
  columns.result = result_column(heads, taken);
  columns.notes = called("notes");
  columns.bench = called("bench");
}

// A first row that has more names of parameters than values.
SetupColumns parameter_columns(const Row& first, const PartFinder& finder) {
  struct Column {
    std::size_t at = 0;
    bool by_slot = false;
  };
  std::map<std::size_t, Column> by_parameter;
  SetupColumns columns;
  std::size_t values = 0;
  // A run sheet has "slot_1 Step" beside its own column step, which is never the parameter.
  const Heads heads = each_of<std::string>(first, &Field::text);
  const bool is_planned = shape_of(heads) == SheetShape::steps ||
                          std::ranges::any_of(heads, [&](const std::string& head) {
                            const auto headed = headed_parameter(*finder.model(), head);
                            return headed && headed->by_slot;
                          });
  std::map<std::size_t, std::size_t> missing;  // by parameter: the column that only looks like it
  for (std::size_t i = 0; i < first.size(); ++i) {
    const std::string& head = first[i].text;
    values += finder.find(head) ? 1U : 0U;
    const auto headed = headed_parameter(*finder.model(), head);
    if (headed && !headed->by_slot && is_planned && is_head_beside_values(head)) {
      missing.emplace(headed->parameter, i);
    } else if (headed) {
      const auto [known, is_new] =
          by_parameter.emplace(headed->parameter, Column{i, headed->by_slot});
      if (!is_new && headed->by_slot && !known->second.by_slot) {
        known->second = {i, true};
      }
    }
  }
  const auto lost = std::ranges::find_if(
      missing, [&](const auto& each) { return by_parameter.count(each.first) == 0; });
  if (lost != missing.end()) {
    columns.lost = SetupColumns::Lost{.parameter = lost->first, .column = lost->second};
  }
  std::vector<std::size_t> of_column(first.size());
  for (const auto& [parameter, column] : by_parameter) {
    of_column[column.at] = parameter;
    columns.slots.push_back(column.at);
  }
  std::ranges::sort(columns.slots);
  for (const std::size_t at : columns.slots) {
    columns.parameters.push_back(of_column[at]);
  }
  std::vector<bool> taken(first.size(), false);
  for (const std::size_t at : columns.slots) {
    taken[at] = true;
  }
  find_beside(first, taken, columns);
  columns.header = columns.slots.size() > values;
  return columns.header ? columns : SetupColumns();
}

}  // namespace

// A first row with such words is the header of a sheet, unless they are names of parts; then only
// if it is certainly a header.
SetupColumns setup_columns(const Row& first, const PartFinder& finder, bool is_given) {
  if (finder.model() != nullptr && !is_given) {
    SetupColumns columns = parameter_columns(first, finder);
    if (columns.header) {
      return columns;
    }
  }
  const auto has_all = [&](std::initializer_list<std::string_view> words) {
    return std::ranges::all_of(words, [&](std::string_view word) {
      return std::ranges::any_of(first, [&](const Field& field) { return field.text == word; });
    });
  };
  const bool beyond_doubt = has_all({"step", "take_out", "put_in", "cost_so_far"}) ||
                            has_all({"step", "result", "notes"});
  SetupColumns columns;
  std::vector<bool> taken(first.size(), false);
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (finder.is_name(first[i].text) && !beyond_doubt) {
      taken[i] = true;
    } else if (first[i].text == "set_up") {
      columns.list = i;
      taken[i] = true;
    } else if (place_in(first[i].text)) {
      columns.slots.push_back(i);
      taken[i] = true;
    }
  }
  find_beside(first, taken, columns);
  columns.header = beyond_doubt || columns.list || !columns.slots.empty();
  return columns.header ? columns : SetupColumns();
}

std::vector<DonePlace> places_of(const SetupColumns& columns, const Row& header,
                                 const PartFinder& finder) {
  std::vector<DonePlace> places;
  std::size_t next = columns.parameters.empty() ? 0 : finder.model()->model().parameters.size();
  for (std::size_t i = 0; i < columns.slots.size(); ++i) {
    const std::string& head = header[columns.slots[i]].text;
    if (columns.parameters.empty()) {
      places.push_back(*place_in(head));
    } else if (columns.is_gone(i)) {
      places.push_back({.number = ++next, .slot = parameter_in(head)});
    } else {
      const std::size_t p = columns.parameters[i];
      places.push_back({.number = p + 1, .slot = finder.model()->model().parameters[p].name});
    }
  }
  return places;
}

std::vector<std::string> parameters_without_column(const SetupColumns& columns,
                                                   const Model& model) {
  std::vector<std::string> without;
  for (std::size_t p = 0; p < model.parameters.size(); ++p) {
    if (!contains(columns.parameters, p)) {
      without.push_back(model.parameters[p].name);
    }
  }
  return without;
}

std::string parameter_in(std::string_view head) {
  const std::string text(csv_text(head));
  const auto place = place_in(text);
  return place && !place->slot.empty() ? place->slot : text;
}

const OwnHead* own_head(std::string_view head) {
  static constexpr auto heads = std::to_array<OwnHead>({
      {.head = "take_out", .is_planned = true},
      {.head = "put_in", .is_planned = true},
      {.head = "hand_over", .is_planned = true},
      {.head = "set", .is_planned = true},
      {.head = "set_up"},
      {.head = "new_pairs", .is_figure = true, .counts_new = true},
      {.head = "new_triples", .is_figure = true, .counts_new = true},
      {.head = "cost", .is_figure = true},
      {.head = "cost_so_far", .is_figure = true, .is_planned = true},
      {.head = "clock", .is_figure = true, .is_planned = true},
      {.head = "weight_so_far", .is_figure = true, .is_planned = true},
      {.head = "day"},
      {.head = "date"},
      {.head = "from_hour"},
      {.head = "to_hour"},
  });
  const auto found = std::ranges::find(heads, head, &OwnHead::head);
  return found == heads.end() ? nullptr : &*found;
}

const OwnHead* own_head_meant(std::string_view head) { return own_head(in_our_letters(head)); }

bool is_head_beside_values(std::string_view name) {
  constexpr auto beside = std::to_array<std::string_view>(
      {"step", "set", "take_out", "put_in", "new_pairs", "new_triples", "cost", "cost_so_far",
       "result", "notes", "bench"});
  return std::ranges::any_of(beside, [&](std::string_view head) { return same_word(head, name); });
}

SheetShape shape_of(const Heads& heads) {
  const bool has_figures = std::ranges::any_of(heads, is_own(&OwnHead::counts_new));
  const bool has_setups = std::ranges::any_of(heads, heads_a_setup);
  const bool are_planned =
      step_column(heads) && std::ranges::any_of(heads, is_own(&OwnHead::is_planned));
  // The columns of a model have its own heads; beside figures and results they need no others.
  const bool is_filled_in =
      step_column(heads) && first_column(heads, {}, heads_results).has_value();
  if ((has_setups || is_filled_in) && (has_figures || are_planned)) {
    return SheetShape::steps;
  }
  return has_setups && first_column(heads, {}, heads_results) ? SheetShape::done
                                                              : SheetShape::other;
}

std::optional<std::size_t> result_column(const Heads& heads, const std::vector<bool>& taken) {
  const auto ours = first_column(
      heads, taken, [](const std::string& head) { return lower_case(head) == "result"; });
  // "slot_2 Outcome" is a parameter, which the model may have no more.
  const auto meant = ours ? ours : first_column(heads, taken, [](const std::string& head) {
    return heads_results(head) && !place_in(head);
  });
  return meant ? meant : column_after_figures(heads, taken);
}

std::optional<std::size_t> step_column(const Heads& heads, const std::vector<bool>& taken) {
  const auto ours = first_column(
      heads, taken, [](const std::string& head) { return lower_case(head) == "step"; });
  const auto meant = ours ? ours : first_column(heads, taken, heads_steps);
  // "Nr" beside the figures of steps, which no list but a run sheet has.
  return meant || std::ranges::none_of(heads, is_own(&OwnHead::counts_new))
             ? meant
             : first_column(heads, taken, heads_row_numbers);
}

}  // namespace changeover
