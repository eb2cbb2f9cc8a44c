// Slots: which there are, how many parts of each a set-up has, and what that forbids.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"
#include "changeover/run/control.hpp"
#include "io/scan/place.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/fitting.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/job/part_columns.hpp"

namespace changeover {
namespace {

constexpr const char* write_a_number = "write a number, as in CPU,1,1";

std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [rest, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  return failure == std::errc() && rest == text.data() + text.size() ? std::optional(value)
                                                                     : std::nullopt;
}

// "2", "2..4", "2..", "..4".
std::optional<std::pair<std::uint64_t, std::uint64_t>> range_of(std::string_view text) {
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

}  // namespace

std::vector<Slot> read_slots(Input& input) {
  RowReader reader(input);
  std::vector<Slot> slots;
  bool first = true;
  while (const auto next = reader.next()) {
    const Row& row = *next;
    const bool header = std::exchange(first, false) && !reader.is_given() &&
                        lower(row[0].text) == "slot" && row.size() > 1 &&
                        lower(row[1].text) == "least";
    if (header) {
      continue;
    }
    constexpr std::size_t fields = 3;
    if (row[0].text.empty() || row.size() < 2 || row.size() > fields) {
      reader.fail(row[0],
                  "no slot with its least and most parts; write a slot a line, as in CPU,1,1");
    }
    Slot slot{.name = row[0].text};
    if (!row[1].text.empty()) {
      const auto least = number(row[1].text);
      if (!least) {
        reader.fail(row[1], fmt::format("{} is no number of parts; {}", shown(row[1].text),
                                        write_a_number));
      }
      slot.least = *least;
    }
    if (row.size() == fields && !row[2].text.empty()) {
      const auto most = number(row[2].text);
      if (!most) {
        reader.fail(row[2], fmt::format("{} is no number of parts; {}", shown(row[2].text),
                                        write_a_number));
      }
      slot.most = *most;
    }
    if (slot.least > slot.most) {
      reader.fail(row[1],
                  fmt::format("slot {} has at least {} and at most {}; write the least first",
                              shown(slot.name), slot.least, slot.most));
    }
    if (std::any_of(slots.begin(), slots.end(),
                    [&](const Slot& other) { return other.name == slot.name; })) {
      reader.fail(row[0], fmt::format("{} stands here twice; remove one", shown(slot.name)));
    }
    if (slots.size() == max_parts) {
      reader.fail(row[0], fmt::format("more than {} slots", max_parts));
    }
    slots.push_back(std::move(slot));
  }
  if (slots.empty()) {
    fail(input.name(), {}, "no slot is listed; write a slot a line, as in CPU,1,1");
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
          fmt::format("{} is no slot with its parts; write CPU=1 or disk=2..4", shown(field.text)));
    }
    const std::string name = field.text.substr(0, is);
    if (range->first > range->second) {
      throw BadInput(fmt::format("{}: at least {} and at most {}; write the least first",
                                 shown(field.text), range->first, range->second));
    }
    if (std::any_of(slots.begin(), slots.end(), [&](const Slot& s) { return s.name == name; })) {
      throw BadInput(fmt::format("{} stands here twice; remove one", shown(name)));
    }
    slots.push_back({name, range->first, range->second});
  }
  return slots;
}

void set_slots(Job& job, const std::vector<std::string>& of_parts, std::vector<Slot> slots) {
  std::vector<std::uint32_t> slot_of(job.names.size(), no_slot);
  if (of_parts.size() != job.names.size()) {
    throw BadInput(
        "slots are limited, but no part has one; give the parts list a header with a column slot");
  }
  std::string known;
  for (std::size_t x = 0; x < of_parts.size(); ++x) {
    if (of_parts[x].empty()) {
      continue;
    }
    const auto found = std::find_if(slots.begin(), slots.end(),
                                    [&](const Slot& slot) { return slot.name == of_parts[x]; });
    if (found == slots.end()) {
      throw BadInput(
          fmt::format("{} is in slot {}, which has no limits; give least and most, or "
                      "leave its field empty",
                      job.names[x], shown(of_parts[x])));
    }
    slot_of[x] = static_cast<std::uint32_t>(found - slots.begin());
  }
  job.slots = std::move(slots);
  job.slot_of = std::move(slot_of);
}

PairSet cannot_meet(const Job& job) {
  PairSet pairs(job.parts());
  if (job.slots.empty()) {
    return pairs;
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
  job.needed.for_each(std::numeric_limits<std::uint64_t>::max(), [&](Element x, Element y) {
    if (!pairs.contains(x, y)) {
      rest.insert(x, y);
    }
  });
  job.needed = std::move(rest);
}

}  // namespace changeover
