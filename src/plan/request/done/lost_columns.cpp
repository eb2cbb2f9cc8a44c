#include "plan/request/done/lost_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/core/error.hpp"
#include "core/contains.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "plan/job/setups/first_noted.hpp"
#include "plan/job/setups/results.hpp"

namespace changeover {
namespace {

// A number that no column of parts has, though one has a higher number.
std::optional<std::uint64_t> missing_place(const std::vector<DonePlace>& places) {
  for (std::uint64_t number = 1; number <= places.size(); ++number) {
    if (std::ranges::find(places, number, &DonePlace::number) == places.end()) {
      return number;
    }
  }
  return std::nullopt;
}

// A done test with fewer parts in a slot than every set-up has, where its cells are empty.
void note_slots_that_lack(DoneList& list, const Job& job, const std::string& name) {
  FirstNoted lacking;
  for (const DoneRow& row : list.rows) {
    if (!was_run(row.result) || row.written.size() != list.places.size()) {
      continue;
    }
    for (const Slot& slot : job.slots) {
      std::uint64_t there = 0;
      std::optional<std::size_t> empty;
      for (std::size_t i = 0; i < row.written.size(); ++i) {
        if (list.places[i].slot == slot.name) {
          there += row.written[i].empty() ? 0U : 1U;
          empty = row.written[i].empty() && !empty ? std::optional(i) : empty;
        }
      }
      if (empty && there < slot.least) {
        lacking.add([&] {
          return fmt::format(
              "{}: the test in row {} has {} in slot {}, which needs {}, and an empty cell under "
              "slot_{} {}",
              name, row.line, count_of(there, "part"), slot.name, slot.least,
              list.places[*empty].number, slot.name);
        });
      }
    }
  }
  if (lacking) {
    list.notes.push_back(lacking.said("other case") +
                         "; write the part that was there: what was tested with it does not count");
  }
}

// The first test with a result and an empty place that lacks a part, where others have it.
std::optional<std::size_t> row_that_lost(const DoneList& list, Element x) {
  for (std::size_t i = 0; i < list.rows.size(); ++i) {
    const DoneRow& row = list.rows[i];
    const auto is_empty = [](const std::string& text) { return text.empty(); };
    if (!row.result.empty() && !contains(row.setup, x) &&
        std::ranges::any_of(row.written, is_empty)) {
      return i;
    }
  }
  return std::nullopt;
}

}  // namespace

void note_lost_columns(DoneList& list, const Job& job, bool has_benches, const std::string& name) {
  const auto note = [&](const std::string& what) {
    list.notes.push_back(fmt::format(
        "{}: {}; if a column was deleted, put it back: what was tested with it does not count",
        name, what));
  };
  const bool are_named =
      std::ranges::any_of(list.places, [](const DonePlace& place) { return !place.slot.empty(); });
  for (const Slot& slot : job.slots) {
    if (are_named && job.model == nullptr && slot.least > 0 &&
        std::ranges::find(list.places, slot.name, &DonePlace::slot) == list.places.end()) {
      const std::string what = fmt::format("no column has the parts in slot {}", slot.name);
      if (const auto missing = missing_place(list.places)) {
        throw BadInput(fmt::format("{}: {}, and none is called slot_{}; put that column back", name,
                                   what, *missing));
      }
      note(what);
    }
  }
  if (are_named && job.model == nullptr && !has_benches) {
    note_slots_that_lack(list, job, name);
  }
  for (const Element x : job.mounted) {
    if (!list.places.empty() && std::ranges::none_of(list.rows, [&](const DoneRow& row) {
          return contains(row.setup, x);
        })) {
      note(fmt::format("no test has {}, which stays mounted", shown(job.names[x])));
    } else if (const auto row = has_benches ? std::nullopt : row_that_lost(list, x)) {
      list.notes.push_back(
          fmt::format("{}: the test in row {} has an empty cell and lacks {}, which stays "
                      "mounted; if it was there, write it: what was tested with it does not count",
                      name, list.rows[*row].line, shown(job.names[x])));
    }
  }
}

}  // namespace changeover
