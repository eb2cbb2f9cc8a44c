// Writes places of parts as JSON.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "io/write/json_writer.hpp"
#include "plan/sheet/clock.hpp"
#include "plan/sheet/places.hpp"

namespace changeover {

/// The places by number, with their parts.
class PlacesInJson {
 public:
  PlacesInJson(const Job& job, const std::vector<const RunSheet*>& sheets)
      : PlacesInJson(std::vector<const Job*>(sheets.size(), &job), sheets, job) {}
  /// With a job for each sheet, and the common job.
  PlacesInJson(const std::vector<const Job*>& jobs, const std::vector<const RunSheet*>& sheets,
               const Job& all)
      : job_(&all), placed_(placed(jobs, sheets)), order_(placed_.places.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::sort(order_, {}, [&](std::size_t i) { return placed_.places[i].number; });
  }

  void write_all(JsonWriter& json) const {
    json.key("places").begin_array();
    for (const std::size_t i : order_) {
      const MountedPlace& place = placed_.places[i];
      json.begin_object().key("number").value(place.number).key("slot");
      place.slot == no_slot ? json.null() : json.value(job_->slots[place.slot].name);
      json.end_object();
    }
    json.end_array();
  }

  void write(JsonWriter& json, std::size_t sheet, std::size_t step) const {
    json.key("places").begin_array();
    for (const std::size_t i : order_) {
      const auto& part = placed_.sheets[sheet].steps[step][i];
      part ? json.value(job_->names[*part]) : json.null();
    }
    json.end_array();
  }

 private:
  const Job* job_;
  PlacedSheets placed_;
  std::vector<std::size_t> order_;
};

inline void write_unit(JsonWriter& json, const Job& job) {
  json.key("cost_unit");
  job.cost_unit == CostUnit::none ? json.null() : json.value(word_of(job.cost_unit));
}

}  // namespace changeover
