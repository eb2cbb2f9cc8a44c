#include "plan/request/done/done_places.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "core/each.hpp"
#include "plan/model/model_text.hpp"

namespace changeover {
namespace {

// The index of the place with this number in a list, added if necessary.
std::size_t index_of(std::vector<DonePlace>& places, const DonePlace& place) {
  const auto found = std::ranges::find_if(places, [&](const DonePlace& each) {
    return each.number == place.number && each.slot == place.slot;
  });
  const auto index = static_cast<std::size_t>(found - places.begin());
  if (found == places.end()) {
    places.push_back(place);
  }
  return index;
}

// The index of the place of a parameter, by its name: the numbers of those that the model has no
// more differ by sheet. Added if necessary, with a separate number.
std::size_t index_of_parameter(std::vector<DonePlace>& places, DonePlace place) {
  if (place.slot.empty()) {
    return index_of(places, place);
  }
  const auto found = std::ranges::find_if(
      places, [&](const DonePlace& each) { return same_word(each.slot, place.slot); });
  const auto index = static_cast<std::size_t>(found - places.begin());
  if (found == places.end()) {
    std::uint64_t last = 0;
    for (const DonePlace& each : places) {
      last = std::max(last, each.number);
    }
    if (std::ranges::find(places, place.number, &DonePlace::number) != places.end()) {
      place.number = last + 1;
    }
    places.push_back(std::move(place));
  }
  return index;
}

// What a row has by place, moved to other places.
template <class T>
std::vector<T> moved(std::vector<T> parts, const std::vector<std::size_t>& to, std::size_t places) {
  std::vector<T> all(places);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i] != T()) {
      all[to[i]] = std::move(parts[i]);
    }
  }
  return all;
}

}  // namespace

void append_done(DoneList& list, DoneList more, bool is_of_model) {
  const auto to = each_of<std::size_t>(more.places, [&](const DonePlace& place) {
    return is_of_model ? index_of_parameter(list.places, place) : index_of(list.places, place);
  });
  for (DoneRow& row : list.rows) {
    row.in_place.resize(list.places.size());
    row.written.resize(list.places.size());
  }
  for (DoneRow& row : more.rows) {
    row.in_place = moved(std::move(row.in_place), to, list.places.size());
    row.written = moved(std::move(row.written), to, list.places.size());
    list.rows.push_back(std::move(row));
  }
  std::ranges::move(more.notes, std::back_inserter(list.notes));
  for (std::string& name : more.gone) {
    if (std::ranges::find(list.gone, name) == list.gone.end()) {
      list.gone.push_back(std::move(name));
    }
  }
}

void record_test(DoneRecord& record, std::vector<DonePlace> places, const DoneRow& test,
                 const Job& job, const std::string& bench) {
  std::vector<std::string> parts = test.written;
  if (places.empty()) {
    parts = each_of<std::string>(test.setup, [&](Element x) { return job.names[x]; });
    parts.insert(parts.end(), test.gone.begin(), test.gone.end());
    while (places.size() < parts.size()) {
      places.push_back({.number = places.size() + 1});
    }
  }
  DoneRecord::Test& kept = record.tests.emplace_back();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t index = index_of(record.places, places[i]);
    kept.parts.resize(std::max(kept.parts.size(), index + 1));
    kept.parts[index] = parts[i];
  }
  kept.result = test.result.empty() ? "done" : test.result;
  kept.notes = test.notes;
  kept.bench = bench;
  kept.step = test.step;
}

std::vector<MountedPlace> places_after(const DoneList& list, std::size_t test, const Job& job,
                                       std::uint64_t room) {
  const bool slots_are_named =
      std::ranges::any_of(list.places, [](const DonePlace& place) { return !place.slot.empty(); });
  const auto slot_of = [&](Element x) { return job.slots.empty() ? no_slot : job.slot_of[x]; };
  std::vector<MountedPlace> places;
  for (std::size_t i = 0; i < list.places.size(); ++i) {
    const DonePlace& column = list.places[i];
    const auto& part = list.rows[test].in_place.at(i);
    const auto named = std::ranges::find(job.slots, column.slot, &Slot::name);
    const bool is_known = column.slot.empty() ? job.slots.empty() || slots_are_named || part
                                              : named != job.slots.end() || part;
    const bool is_there =
        std::ranges::find(places, column.number, &MountedPlace::number) != places.end();
    if (!is_known || is_there || column.number == 0) {
      continue;  // of a slot that no longer exists
    }
    MountedPlace place{.number = column.number};
    if (!column.slot.empty() && named != job.slots.end()) {
      place.slot = static_cast<std::uint32_t>(named - job.slots.begin());
    } else if (part && !(column.slot.empty() && slots_are_named)) {
      place.slot = slot_of(*part);
    }
    if (part && slot_of(*part) == place.slot &&
        std::ranges::find(job.start, *part) != job.start.end()) {
      place.part = part;
    }
    places.push_back(place);
  }
  for (std::size_t i = places.size(); i-- > 0 && places.size() > room && job.slots.empty();) {
    if (!places[i].part) {
      places.erase(places.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  return places;
}

}  // namespace changeover
