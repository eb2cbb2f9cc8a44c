#include "plan/request/workbook/emptied_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "changeover/core/error.hpp"
#include "core/contains.hpp"
#include "core/printable.hpp"
#include "plan/job/bench_list.hpp"
#include "plan/job/setups/results.hpp"

namespace changeover {
namespace {

// What every set-up of a bench has.
struct Needs {
  std::vector<Slot> slots;
  Block mounted;
};

Needs needs_of(const Job& job, const Bench* bench) {
  Needs needs{.slots = job.slots, .mounted = job.mounted};
  if (bench != nullptr) {
    needs.mounted = bench->mounted.value_or(needs.mounted);
    for (const Slot& own : bench->slots) {
      const auto slot = std::ranges::find(needs.slots, own.name, &Slot::name);
      if (slot != needs.slots.end()) {
        *slot = own;
      }
    }
  }
  return needs;
}

// The first empty place of a row in a slot, or in any.
std::optional<std::size_t> empty_place(const DoneList& list, const DoneRow& row,
                                       const std::string* slot) {
  for (std::size_t i = 0; i < row.written.size() && i < list.places.size(); ++i) {
    if (row.written[i].empty() && !row.in_place[i] &&
        (slot == nullptr || list.places[i].slot == *slot)) {
      return i;
    }
  }
  return std::nullopt;
}

// Whether no column has the parts of a slot, though others say of which they are.
bool lost_column(const DoneList& list, const std::string& slot) {
  return std::ranges::any_of(list.places, [](const DonePlace& at) { return !at.slot.empty(); }) &&
         std::ranges::find(list.places, slot, &DonePlace::slot) == list.places.end();
}

std::string called(const Job& job, const Slot& slot) {
  return job.model != nullptr ? fmt::format("a value of {}", shown(slot.name))
         : slot.least == 1    ? fmt::format("a part in slot {}", shown(slot.name))
                              : fmt::format("{} parts in slot {}", slot.least, shown(slot.name));
}

// What a row lacks where it has an empty cell or no column: "a cell is empty, but every planned
// test has a part in slot 'disk'; write what was there".
std::optional<std::string> lacking(const DoneList& list, const DoneRow& row, const Job& job,
                                   const Needs& needs) {
  constexpr std::string_view emptied =
      "a cell is empty, but every planned test has {}; write what was there";
  for (const Slot& slot : needs.slots) {
    const auto s = static_cast<std::uint32_t>(std::ranges::find(job.slots, slot.name, &Slot::name) -
                                              job.slots.begin());
    const auto there = static_cast<std::uint64_t>(
        std::ranges::count_if(row.setup, [&](Element x) { return job.slot_of[x] == s; }));
    if (there < slot.least && empty_place(list, row, &slot.name)) {
      return fmt::format(emptied, called(job, slot));
    }
    if (there < slot.least && lost_column(list, slot.name)) {
      return fmt::format("the column of {} is missing, which every planned test has; put it back",
                         shown(slot.name));
    }
  }
  for (const Element x : needs.mounted) {
    if (!contains(row.setup, x) && empty_place(list, row, nullptr)) {
      return fmt::format(emptied, shown(job.names[x]));
    }
  }
  return std::nullopt;
}

}  // namespace

void refuse_emptied_places(const std::string& sheet, const DoneList& list, const Job& job,
                           const std::vector<Bench>& benches) {
  for (const DoneRow& row : list.rows) {
    if (!row.step || !was_run(row.result) || !row.gone.empty()) {
      continue;
    }
    const auto bench = find_bench(benches, row.bench);
    if (const auto lost =
            lacking(list, row, job, needs_of(job, bench ? &benches[*bench] : nullptr))) {
      throw BadInput(
          fmt::format("{}: row {}: {}, or remove the number of the step if this was another test",
                      sheet, row.line, *lost));
    }
  }
}

}  // namespace changeover
