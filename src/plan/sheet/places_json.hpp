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
  explicit PlacesInJson(const std::vector<ShownSheet>& sheets)
      : sheets_(sheets), placed_(placed(sheets)), order_(placed_.places.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::sort(order_, {}, [&](std::size_t i) { return placed_.places[i].number; });
  }

  void write_all(JsonWriter& json) const {
    json.objects("places", order_, [&](std::size_t i) {
      const MountedPlace& place = placed_.places[i];
      json.key("number").value(place.number).key("slot");
      place.slot == no_slot ? json.null() : json.value(sheets_.front().job->slots[place.slot].name);
    });
  }

  /// The steps of one sheet. Sheets of one bench and of several differ in what stands behind the
  /// number of a step (`first`, of its index), behind its places (`met`, of the step) and at its
  /// end (`last`, of its index).
  template <typename First, typename Met, typename Last>
  void write_steps(JsonWriter& json, std::size_t of, const Money& money, First&& first, Met&& met,
                   Last&& last) const {
    const Job& job = *sheets_[of].job;
    std::size_t at = 0;
    json.objects("steps", sheets_[of].sheet->steps, [&](const RunStep& step) {
      json.key("step").value(job.steps_before() + at + 1);
      first(at);
      json.key("take_out").value(names_of(job, step.take_out));
      json.key("put_in").value(names_of(job, step.put_in));
      json.key("set_up").value(names_of(job, step.setup));
      json.list("places", order_, [&](std::size_t i) {
        const auto& part = placed_.sheets[of].steps[at][i];
        part ? json.value(job.names[*part]) : json.null();
      });
      met(step);
      if (job.replaces()) {
        json.list("replaced", step.replaced, [&](const auto& pair) {
          json.value(names_of(job, {pair.first, pair.second}));
        });
      }
      json.key("cost").raw(money(step.cost)).key("cost_so_far").raw(money(step.cost_so_far));
      last(at++);
    });
  }

 private:
  std::vector<ShownSheet> sheets_;
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

inline void write_unit(JsonWriter& json, const Job& job) {
  json.key("cost_unit");
  job.cost_unit == CostUnit::none ? json.null() : json.value(word_of(job.cost_unit));
}

}  // namespace changeover
