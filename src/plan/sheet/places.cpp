#include "plan/sheet/places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <span>

#include "changeover/core/error.hpp"

namespace changeover {
namespace {

std::uint32_t slot_of(const Job& job, Element x) {
  return job.slot_of.empty() ? no_slot : job.slot_of[x];
}

// Slots in their order, then no slot.
std::vector<std::uint32_t> slots_of(const Job& job) {
  std::vector<std::uint32_t> slots(job.slots.size() + 1, no_slot);
  for (std::uint32_t s = 0; s < job.slots.size(); ++s) {
    slots[s] = s;
  }
  return slots;
}

// The number of places of a slot that some parts need.
std::size_t count_in(const Job& job, const Block& parts, std::uint32_t slot) {
  return static_cast<std::size_t>(
      std::ranges::count_if(parts, [&](Element x) { return slot_of(job, x) == slot; }));
}

// The known places and further ones that the sheets need; each new one gets the smallest free
// number.
std::vector<MountedPlace> all_places(const std::vector<ShownSheet>& sheets) {
  std::map<std::uint64_t, std::uint32_t> known;  // slots by number
  for (const ShownSheet& shown : sheets) {
    for (const MountedPlace& place : shown.job->places) {
      known.emplace(place.number, place.slot);
    }
  }
  std::set<std::uint64_t> numbers;
  std::ranges::transform(known, std::inserter(numbers, numbers.end()),
                         [](const auto& place) { return place.first; });
  std::uint64_t next = 1;
  std::vector<MountedPlace> places;
  for (const std::uint32_t slot : slots_of(*sheets.front().job)) {
    std::size_t width = 0;
    for (const ShownSheet& shown : sheets) {
      width = std::max(width, count_in(*shown.job, shown.job->start, slot));
      for (const RunStep& step : shown.sheet->steps) {
        width = std::max(width, count_in(*shown.job, step.setup, slot));
      }
    }
    const std::size_t begin = places.size();
    for (const auto& [number, of] : known) {
      if (of == slot) {
        places.push_back({number, slot, {}});
      }
    }
    while (places.size() < begin + width) {
      while (!numbers.insert(next).second) {
        ++next;
      }
      places.push_back({next, slot, {}});
    }
    std::ranges::sort(std::span(places).subspan(begin), {}, &MountedPlace::number);
  }
  return places;
}

// One bench during its steps.
class BenchPlaces {
 public:
  BenchPlaces(const Job& job, const std::vector<MountedPlace>& places)
      : job_(&job), places_(&places), now_(places.size()), last_(job.names.size()) {
    for (const MountedPlace& known : job.places) {
      if (known.part && std::ranges::count(job.start, *known.part) != 0) {
        put(*known.part, index_of(known.number));
      }
    }
    for (const Element x : job.start) {
      if (!last_[x]) {
        put(x, free_place(x, {}));
      }
    }
  }

  [[nodiscard]] const MountedParts& now() const { return now_; }

  void take(const RunStep& step) {
    MountedParts emptied(now_.size());  // by place: the removed part
    for (const Element x : step.take_out) {
      emptied[*last_[x]] = x;
      now_[*last_[x]].reset();
    }
    Block others;
    for (const Element x : step.put_in) {
      const auto pair =
          std::ranges::find(step.replaced, x, [](const auto& both) { return both.second; });
      const auto place = pair == step.replaced.end() ? std::nullopt : last_[pair->first];
      place&& takes(*place, x) ? put(x, *place) : others.push_back(x);
    }
    std::stable_partition(others.begin(), others.end(),
                          [&](Element x) { return last_[x] && takes(*last_[x], x); });
    for (const Element x : others) {
      put(x, last_[x] && takes(*last_[x], x) ? *last_[x] : free_place(x, emptied));
    }
  }

 private:
  [[nodiscard]] std::size_t index_of(std::uint64_t number) const {
    return static_cast<std::size_t>(std::ranges::find(*places_, number, &MountedPlace::number) -
                                    places_->begin());
  }
  [[nodiscard]] bool takes(std::size_t place, Element x) const {
    return !now_[place] && places_->at(place).slot == slot_of(*job_, x);
  }
  // A free place of the slot, preferably one that was just emptied.
  [[nodiscard]] std::size_t free_place(Element x, const MountedParts& emptied) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < now_.size(); ++i) {
      if (!takes(i, x)) {
        continue;
      }
      if (!emptied.empty() && emptied[i]) {
        return i;
      }
      found = found.value_or(i);
    }
    if (!found) {
      throw InternalError(fmt::format("there is no free place for {}", job_->names[x]));
    }
    return *found;
  }
  void put(Element x, std::size_t place) {
    now_.at(place) = x;
    last_[x] = place;
  }

  const Job* job_;
  const std::vector<MountedPlace>* places_;
  MountedParts now_;
  std::vector<std::optional<std::size_t>> last_;  // by part: its current or last place
};

}  // namespace

std::string PlacedSheets::head(const Job& job, std::size_t place) const {
  const MountedPlace& at = places[place];
  return at.slot == no_slot ? fmt::format("slot_{}", at.number)
                            : fmt::format("slot_{} {}", at.number, job.slots[at.slot].name);
}

PlacedSheets placed(const std::vector<ShownSheet>& sheets) {
  PlacedSheets made{.places = all_places(sheets), .sheets = {}};
  for (const ShownSheet& shown : sheets) {
    BenchPlaces bench(*shown.job, made.places);
    PlacedSheet& list = made.sheets.emplace_back();
    list.before = bench.now();
    for (const RunStep& step : shown.sheet->steps) {
      bench.take(step);
      list.steps.push_back(bench.now());
    }
  }
  if (const auto faults = place_faults(sheets, made); !faults.empty()) {
    throw InternalError("places of parts: " + faults.front());
  }
  return made;
}

}  // namespace changeover
