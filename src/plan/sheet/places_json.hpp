// What run sheets for one bench and for several share as JSON.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

#include "io/write/json_writer.hpp"
#include "plan/sheet/clock.hpp"
#include "plan/sheet/places.hpp"
#include "plan/sheet/sheet_words.hpp"

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
    json.objects("places", order_, [&](std::size_t i) {
      const MountedPlace& place = placed_.places[i];
      json.key("number").value(place.number).key("slot");
      place.slot == no_slot ? json.null() : json.value(job_->slots[place.slot].name);
    });
  }

  void write(JsonWriter& json, std::size_t sheet, std::size_t step) const {
    json.list("places", order_, [&](std::size_t i) {
      const auto& part = placed_.sheets[sheet].steps[step][i];
      part ? json.value(job_->names[*part]) : json.null();
    });
  }

 private:
  const Job* job_;
  PlacedSheets placed_;
  std::vector<std::size_t> order_;
};

/// What the pairs that were needed and tested weigh; null if all weigh the same.
inline void write_weight(JsonWriter& json, const Job& job, Amount needed, Amount tested,
                         const std::optional<Amount>& most) {
  json.key("weight");
  if (job.weights.empty()) {
    json.null();
    return;
  }
  json.begin_object().key("needed").raw(to_string(needed)).key("tested").raw(to_string(tested));
  json.key("most");
  most ? json.raw(to_string(*most)) : json.null();
  json.end_object();
}

inline void write_changes(JsonWriter& json, const Job& job, const RunStep& step) {
  json.key("take_out").value(names_of(job, step.take_out));
  json.key("put_in").value(names_of(job, step.put_in));
  json.key("set_up").value(names_of(job, step.setup));
}

/// If costs depend on what is replaced.
inline void write_replaced(JsonWriter& json, const Job& job, const RunStep& step) {
  if (job.replaces()) {
    json.list("replaced", step.replaced, [&](const auto& pair) {
      json.value(names_of(job, {pair.first, pair.second}));
    });
  }
}

inline void write_unit(JsonWriter& json, const Job& job) {
  json.key("cost_unit");
  job.cost_unit == CostUnit::none ? json.null() : json.value(word_of(job.cost_unit));
}

}  // namespace changeover
