#include "loadorder/show/worker_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/checked.hpp"

namespace changeover {

WorkerWords::WorkerWords(const LoadOrderFacts& facts, const SplitFacts* split)
    : facts_(facts),
      split_(split),
      workers_(split != nullptr ? split->workers.size() : facts.lockstep) {
  if (split != nullptr) {
    all_ = split->pairs_are_known ? split->all_pairs : 0;
    most_ = split->pairs_are_known ? split->most_pairs : 0;
    return;
  }
  for (const std::uint64_t pairs : facts.worker_pairs) {
    all_ += pairs;
    most_ = std::max(most_, pairs);
  }
}

void WorkerWords::say(JsonWriter& json) const {
  if (all_ > 0 || most_ > 0) {
    json.key("pairs_per_worker")
        .begin_object()
        .key("max")
        .value(most_)
        .key("mean")
        .value(static_cast<double>(all_) / static_cast<double>(workers_))
        .end_object();
    json.key("pairs_per_worker_bound").value(ceil_div(all_, workers_));
  }
  if (split_ != nullptr && split_->has_costs) {
    json.key("cost_per_worker")
        .begin_object()
        .key("max")
        .value(split_->most_cost)
        .key("mean")
        .value(split_->all_costs / static_cast<double>(workers_))
        .end_object();
  }
}

void WorkerWords::say_each(JsonWriter& json) const {
  if (split_ != nullptr && facts_.sizes) {
    json.list("worker_bytes", split_->workers,
              [&](const WorkerFacts& worker) { json.value(worker.bytes); });
  }
  if (most_ == 0) {
    return;
  }
  if (split_ == nullptr) {
    json.key("worker_pairs").value(facts_.worker_pairs);
    return;
  }
  json.list("worker_pairs", split_->workers,
            [&](const WorkerFacts& worker) { json.value(worker.pairs); });
  if (split_->has_costs) {
    json.list("worker_costs", split_->workers,
              [&](const WorkerFacts& worker) { json.value(worker.cost); });
  }
}

std::string WorkerWords::text() const {
  std::string text;
  if (most_ > 0) {
    const std::uint64_t least = ceil_div(all_, workers_);
    text = fmt::format("the worker with most pairs computes {} of {}, {}\n", most_, all_,
                       most_ == least ? std::string("the fewest possible")
                                      : fmt::format("{:.2f} % over the mean {}",
                                                    100 * (static_cast<double>(most_) *
                                                               static_cast<double>(workers_) /
                                                               static_cast<double>(all_) -
                                                           1),
                                                    least));
  }
  if (split_ != nullptr && split_->has_costs) {
    const double mean = split_->all_costs / static_cast<double>(workers_);
    text += fmt::format(
        "the one whose pairs cost most has {:.6g} of {:.6g}, {:.2f} % over the mean {:.6g}\n",
        split_->most_cost, split_->all_costs, mean > 0 ? 100 * (split_->most_cost / mean - 1) : 0.0,
        mean);
  }
  return text;
}

}  // namespace changeover
