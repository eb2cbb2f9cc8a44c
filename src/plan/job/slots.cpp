// Slots and their limits, and which pairs they exclude.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"
#include "changeover/run/control.hpp"
#include "core/each.hpp"
#include "core/printable.hpp"
#include "core/spelling.hpp"
#include "core/words.hpp"
#include "io/scan/place.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/choices.hpp"
#include "plan/job/fitting.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/job/parts/heading_words.hpp"

namespace changeover {
namespace {

constexpr const char* write_a_number = "write a number, as in CPU,1,1";

std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [rest, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  return failure == std::errc() && rest == text.data() + text.size() ? std::optional(value)
                                                                     : std::nullopt;
}

using Range = std::pair<std::uint64_t, std::uint64_t>;

// "2", "2..4", "2..", "..4".
std::optional<Range> range_of(std::string_view text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string_view::npos) {
    const auto both = number(text);
    return both ? std::optional(std::pair(*both, *both)) : std::nullopt;
  }
  const std::string_view from = text.substr(0, dots);
  const std::string_view to = text.substr(dots + 2);
  const auto least = from.empty() ? std::optional(std::uint64_t{0}) : number(from);
  const auto most = to.empty() ? std::optional(Slot{}.most) : number(to);
  return least && most && !(from.empty() && to.empty()) ? std::optional(std::pair(*least, *most))
                                                        : std::nullopt;
}

// The same in a cell, where "2-4" and "2–4" are no other numbers.
std::optional<Range> range_in_cell(std::string_view text) {
  for (const std::string_view hyphen : {"-", "–"}) {
    const std::size_t at = text.find(hyphen);
    const auto least = number(text.substr(0, std::min(at, text.size())));
    const auto most =
        at == std::string_view::npos ? std::nullopt : number(text.substr(at + hyphen.size()));
    if (least && most) {
      return Range(*least, *most);
    }
  }
  return range_of(text);
}

// The columns of a list of slots.
struct SlotTable {
  bool header = false;
  std::optional<std::size_t> name = 0;
  std::optional<std::size_t> least = 1;
  std::optional<std::size_t> most = 2;
  std::optional<std::size_t> exactly = {};
};

// A header has no numbers, but a word for a limit; other columns are ignored.
SlotTable slot_table(const Row& first, const RowReader& reader) {
  const auto find = [&](auto&& heads) -> std::optional<std::size_t> {
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (heads(first[i].text)) {
        return i;
      }
    }
    return std::nullopt;
  };
  SlotTable table{.header = true,
                  .name = find(heads_slots),
                  .least = find(heads_least),
                  .most = find(heads_most),
                  .exactly = find(heads_quantities)};
  const bool has_number = find([](const std::string& text) {
                            return number(text) || (!text.empty() && is_missing_number(text));
                          }) != std::nullopt;
  if (reader.is_given() || has_number || !(table.least || table.most || table.exactly)) {
    return {};
  }
  if (!table.name) {
    table.name = find([&](const std::string& text) {
      return !text.empty() && !heads_least(text) && !heads_most(text) && !heads_quantities(text);
    });
  }
  return table.name ? table : SlotTable();
}

// The slot of this name, or else the only one whose name differs in case alone.
std::optional<std::size_t> slot_called(const std::vector<Slot>& slots, const std::string& name) {
  std::optional<std::size_t> alike;
  bool several = false;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (slots[i].name == name) {
      return i;
    }
    if (lower_case(slots[i].name) == lower_case(name)) {
      several = alike.has_value();
      alike = i;
    }
  }
  return several ? std::nullopt : alike;
}

}  // namespace

std::vector<Slot> read_slots(Input& input) {
  RowReader reader(input);
  std::vector<Slot> slots;
  SlotTable table;
  bool first = true;
  while (const auto next = reader.next()) {
    const Row& row = *next;
    if (std::exchange(first, false)) {
      table = slot_table(row, reader);
      if (table.header) {
        continue;
      }
    }
    const auto field = [&](const std::optional<std::size_t>& column) -> const Field* {
      return column && *column < row.size() && !row[*column].text.empty() ? &row[*column] : nullptr;
    };
    const Field* const name = field(table.name);
    if (name == nullptr || (!table.header && (row.size() < 2 || row.size() > 3))) {
      reader.fail(
          row[0],
          "expected a slot with its least and most parts; write one slot per line, as in CPU,1,1");
    }
    const auto limit = [&](const Field& said) {
      const auto value = number(said.text);
      if (!value) {
        reader.fail(
            said, fmt::format("{} is not a number of parts; {}", shown(said.text), write_a_number));
      }
      return *value;
    };
    Slot slot{.name = name->text};
    if (const Field* const exactly = field(table.exactly)) {
      const auto range = range_in_cell(exactly->text);
      if (!range) {
        reader.fail(*exactly, fmt::format("{} is not a number of parts; write one as 2, or a range "
                                          "as 2..4",
                                          shown(exactly->text)));
      }
      std::tie(slot.least, slot.most) = *range;
    }
    if (const Field* const least = field(table.least)) {
      slot.least = limit(*least);
    }
    if (const Field* const most = field(table.most)) {
      slot.most = limit(*most);
    }
    if (slot.least > slot.most) {
      const Field* const least = field(table.least);
      reader.fail(least == nullptr ? *name : *least,
                  fmt::format("slot {} has at least {} and at most {}; write the least first",
                              shown(slot.name), slot.least, slot.most));
    }
    if (std::ranges::any_of(slots, [&](const Slot& other) { return other.name == slot.name; })) {
      reader.fail(*name, fmt::format("{} occurs twice; remove one", shown(slot.name)));
    }
    if (slots.size() == max_parts) {
      reader.fail(*name, fmt::format("more than {} slots; use fewer", max_parts));
    }
    slots.push_back(std::move(slot));
  }
  if (slots.empty()) {
    fail(input.name(), {}, "no slot is listed; write one slot per line, as in CPU,1,1");
  }
  return slots;
}

std::vector<Slot> parse_slots(std::string_view text) {
  std::vector<Slot> slots;
  for (const Field& field : split_row(text)) {
    const std::size_t is = field.text.rfind('=');
    const auto range = is == std::string::npos
                           ? std::nullopt
                           : range_of(std::string_view(field.text).substr(is + 1));
    if (!range || is == 0) {
      throw BadInput(
          fmt::format("{} is not a slot with its number of parts; write CPU=1 or disk=2..4",
                      shown(field.text)));
    }
    const std::string name = field.text.substr(0, is);
    if (range->first > range->second) {
      throw BadInput(fmt::format("{}: at least {} and at most {}; write the least first",
                                 shown(field.text), range->first, range->second));
    }
    if (std::ranges::any_of(slots, [&](const Slot& s) { return s.name == name; })) {
      throw BadInput(fmt::format("{} occurs twice; remove one", shown(name)));
    }
    slots.push_back({name, range->first, range->second});
  }
  return slots;
}

void set_slots(Job& job, const std::vector<std::string>& of_parts, std::vector<Slot> slots) {
  std::vector<std::uint32_t> slot_of(job.names.size(), no_slot);
  if (of_parts.size() != job.names.size()) {
    throw BadInput(
        "slots are limited, but no part has one; give the parts list a column slot, or a column "
        "with the names of the slots");
  }
  std::string known;
  for (std::size_t x = 0; x < of_parts.size(); ++x) {
    if (of_parts[x].empty()) {
      continue;
    }
    const auto found = slot_called(slots, of_parts[x]);
    if (!found) {
      const std::vector<std::string> names = each_of<std::string>(slots, &Slot::name);
      const auto nearest = nearest_word(of_parts[x], names);
      throw BadInput(
          fmt::format("{} is in slot {}, which has no limits; {}give least and most, or "
                      "leave its field empty",
                      job.names[x], shown(of_parts[x]),
                      nearest ? fmt::format("did you mean {}? if not, ", shown(*nearest)) : ""));
    }
    slot_of[x] = static_cast<std::uint32_t>(*found);
  }
  job.slots = std::move(slots);
  job.slot_of = std::move(slot_of);
}

PairSet cannot_meet(const Job& job) {
  PairSet pairs(job.parts());
  if (job.slots.empty()) {
    return pairs;
  }
  if (job.model != nullptr) {
    return apart_in_choices(job);
  }
  const Fitting fitting(job);
  job.needed.for_each(all_of_them, [&](Element x, Element y) {
    stop_if_asked();
    if (!fitting.simplest(with_mounted(job, {x, y})).setup) {
      pairs.insert(x, y);
    }
  });
  return pairs;
}

void drop_needed(Job& job, const PairSet& pairs) {
  PairSet rest(job.parts());
  job.needed.for_each(all_of_them, [&](Element x, Element y) {
    if (!pairs.contains(x, y)) {
      rest.insert(x, y);
    }
  });
  job.needed = std::move(rest);
}

}  // namespace changeover
