#include "loadorder/show/schedule_keys.hpp"

#include <algorithm>

#include "loadorder/show/bytes_moved.hpp"
#include "loadorder/show/worker_words.hpp"

namespace changeover {

std::uint64_t workers_of(const LoadOrderFacts& facts, const SplitFacts* split) {
  return split != nullptr ? split->workers.size() : facts.lockstep;
}

std::uint64_t bytes_of_moves(std::uint64_t count, const LoadsShown& how, const std::string& what) {
  return bytes_moved(count, *how.item_bytes, how.item_bytes_key, what + "s");
}

void ScheduleKeys::say_question(JsonWriter& json) const {
  json.key("items").value(facts_.items).key("room").value(facts_.room);
  if (facts_.epochs > 1) {
    json.key("epochs").value(facts_.epochs);
    json.key("epoch_loads").value(facts_.epoch_loads);
  }
  if (!facts_.wanted.are_all()) {
    json.key("wanted").value(facts_.wanted.describe());
    json.key("wanted_pairs").value(facts_.wanted.count());
  }
  if (facts_.fast_room) {
    json.key("fast_room").value(*facts_.fast_room);
  }
}

void ScheduleKeys::say_bytes(const ScheduleVerdict& checked, JsonWriter& json) const {
  if (!facts_.sizes) {
    return;
  }
  json.key("memory").value(facts_.sizes->memory);
  if (facts_.fast_room) {
    json.key("fast_memory").value(facts_.sizes->fast_memory);
    json.key("bytes_transferred").value(facts_.transfer_bytes);
    json.key("transfer_bytes_bound").value(facts_.transfer_byte_bound.loads);
    json.key("transfer_bytes_bound_reason").value(facts_.transfer_byte_bound.reason);
  }
  json.key("bytes_loaded").value(facts_.bytes);
  // With what leaves late, if steps were read so.
  json.key("most_bytes").value(std::max(facts_.most_bytes, checked.most_bytes));
  json.key("bytes_bound").value(facts_.byte_bound.loads);
  json.key("bytes_bound_reason").value(facts_.byte_bound.reason);
  WorkerWords(facts_, split_).say_bytes(json);
}

void ScheduleKeys::say_levels_or_method(JsonWriter& json) const {
  json.key("method").value(facts_.method);
  if (how_.item_bytes) {
    json.key("item_bytes").value(*how_.item_bytes);
    json.key("bytes_loaded").value(bytes_of_moves(facts_.loads, how_, "load"));
  }
  if (!facts_.fast_room) {
    return;
  }
  json.key("transfer_bound").value(facts_.transfer_bound.loads);
  json.key("transfer_bound_reason").value(facts_.transfer_bound.reason);
  if (how_.item_bytes) {
    json.key("bytes_transferred").value(bytes_of_moves(facts_.transfers, how_, "transfer"));
  }
  if (facts_.group_items > 0) {
    json.key("group_items").value(facts_.group_items);
  }
}

void ScheduleKeys::say_workers(JsonWriter& json) const {
  const std::uint64_t workers = workers_of(facts_, split_);
  if (workers > 0) {
    json.key("workers").value(workers).key("makespan").value(facts_.makespan());
    if (facts_.lockstep > 0) {
      json.key("span").value(facts_.span);
    }
    json.key("makespan_bound").value(facts_.makespan_bound.loads);
    json.key("makespan_bound_reason").value(facts_.makespan_bound.reason);
    WorkerWords(facts_, split_).say(json);
    if (how_.worker) {
      json.key("worker").value(*how_.worker);
    }
  }
  if (how_.from_step) {
    json.key("from_step").value(*how_.from_step);
  }
  if (split_ != nullptr && !facts_.fast_room) {
    json.key("groups").value(split_->groups);
  }
}

void ScheduleKeys::say_spare(std::uint64_t spare, const std::optional<LoadBound>& others,
                             const ScheduleVerdict& checked, JsonWriter& json) const {
  if (facts_.sizes) {
    json.key("order_memory").value(facts_.sizes->memory - spare);
  } else {
    json.key("order_room").value(facts_.room - spare);
  }
  if (others) {
    json.key("order_bound").value(others->loads).key("order_bound_reason").value(others->reason);
  }
  if (others && split_ != nullptr) {
    json.key("order_makespan_bound").value(split_->makespan_bound.loads);
    json.key("order_makespan_bound_reason").value(split_->makespan_bound.reason);
  }
  if (facts_.every_step_read) {
    json.key("pairs").value(checked.computed).key("overlapped").value(checked.overlapped);
  }
}

}  // namespace changeover
