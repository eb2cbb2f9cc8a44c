#include "loadorder/show/worker_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>
#include <vector>

#include "core/checked.hpp"
#include "core/words.hpp"

namespace changeover {

std::string over(std::uint64_t count, const LoadBound& bound) {
  return count == bound.loads
             ? "the fewest possible"
             : fmt::format(
                   "{:.2f} % over the lower bound {}",
                   100 * (static_cast<double>(count) / static_cast<double>(bound.loads) - 1),
                   bound.loads);
}

// Forward epochs after the first have equal loads, and so have backward ones.
std::string epochs_in_words(const LoadOrderFacts& facts) {
  const std::vector<std::uint64_t>& loads = facts.epoch_loads;
  if (facts.epochs == 1) {
    return "";
  }
  return loads.size() > 2 && loads[1] != loads[2]
             ? fmt::format("{} in the first epoch, then {} back and {} forth\n",
                           count_of(loads[0], "load"), loads[1], loads[2])
             : fmt::format("{} in the first epoch, then {} in each\n", count_of(loads[0], "load"),
                           loads[1]);
}

std::string say_that_time_is_up(JsonWriter& json) {
  json.key("time_is_up").value(true);
  return "the time was up before all was tried that is tried without --time; with more time there "
         "may be less to load\n";
}

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
    say_most(json, "pairs_per_worker", most_,
             static_cast<double>(all_) / static_cast<double>(workers_));
    json.key("pairs_per_worker_bound").value(ceil_div(all_, workers_));
  }
  if (split_ != nullptr && split_->has_costs) {
    say_most(json, "cost_per_worker", split_->most_cost,
             split_->all_costs / static_cast<double>(workers_));
  }
}

void WorkerWords::say_bytes(JsonWriter& json) const {
  if (workers_ == 0) {
    return;
  }
  const LoadBound& least =
      split_ != nullptr ? split_->makespan_bytes_bound : facts_.makespan_byte_bound;
  json.key("makespan_bytes")
      .value(split_ != nullptr ? split_->makespan_bytes : facts_.makespan_bytes());
  if (split_ == nullptr) {
    json.key("span_bytes").value(facts_.span_bytes);
  }
  json.key("makespan_bytes_bound").value(least.loads);
  json.key("makespan_bytes_bound_reason").value(least.reason);
}

std::string WorkerWords::in_lockstep(const std::string& what, const std::string& epochs,
                                     std::uint64_t steps, const LoadBound& bound) const {
  const std::string who = fmt::format("{}, {}", what, count_of(workers_, "worker"));
  const std::string loads = count_of(facts_.loads, "load");
  if (facts_.sizes) {
    return fmt::format(
               "{} with {} bytes of memory{}, no item at two of them: {} bytes in {} and {}, {}\n"
               "the busiest worker has {} bytes; the slowest of each step add up to {}, {}\n",
               who, facts_.sizes->memory, epochs, facts_.bytes, loads, count_of(steps, "step"),
               over(facts_.bytes, facts_.byte_bound), facts_.makespan_bytes(), facts_.span_bytes,
               over(facts_.span_bytes, facts_.makespan_byte_bound)) +
           text();
  }
  return fmt::format(
             "{} with room for {}{}, no item at two of them: {} in {}, {}\n"
             "the busiest worker has {}; the slowest of each step add up to {}, {}\n",
             who, facts_.room, epochs, loads, count_of(steps, "step"), over(facts_.loads, bound),
             count_of(facts_.makespan(), "load"), facts_.span,
             over(facts_.span, facts_.makespan_bound)) +
         text();
}

std::string WorkerWords::busiest() const {
  if (split_ == nullptr) {
    return "";
  }
  return fmt::format("{} for {}, the busiest has {}, {}\n{}", count_of(facts_.loads, "load"),
                     count_of(workers_, "worker"),
                     facts_.sizes ? fmt::format("{} bytes", split_->makespan_bytes)
                                  : count_of(facts_.makespan(), "load"),
                     facts_.sizes ? over(split_->makespan_bytes, split_->makespan_bytes_bound)
                                  : over(facts_.makespan(), facts_.makespan_bound),
                     text());
}

namespace {

// "12.26 % over the mean 281.5".
std::string over_the_mean(std::uint64_t most, std::uint64_t all, std::uint64_t workers) {
  const double mean = static_cast<double>(all) / static_cast<double>(workers);
  return fmt::format("{:.2f} % over the mean {}", 100 * (static_cast<double>(most) / mean - 1),
                     all % workers == 0 ? std::to_string(all / workers)
                                        : fmt::format("{:.{}f}", mean, mean < 1000 ? 1 : 0));
}

// A worker that does nothing has a number, too.
std::vector<std::uint64_t> of_all(std::vector<std::uint64_t> counts, std::uint64_t workers) {
  counts.resize(static_cast<std::size_t>(workers), 0);
  return counts;
}

}  // namespace

void WorkerWords::say_each(JsonWriter& json) const {
  if (split_ == nullptr && facts_.sizes) {
    json.key("worker_bytes").value(of_all(facts_.worker_bytes, workers_));
  }
  if (split_ != nullptr && facts_.sizes) {
    json.key("worker_bytes").value(split_->workers | std::views::transform(&WorkerFacts::bytes));
  }
  if (most_ == 0) {
    return;
  }
  if (split_ == nullptr) {
    json.key("worker_pairs").value(of_all(facts_.worker_pairs, workers_));
    return;
  }
  json.key("worker_pairs").value(split_->workers | std::views::transform(&WorkerFacts::pairs));
  if (split_->has_costs) {
    json.key("worker_costs").value(split_->workers | std::views::transform(&WorkerFacts::cost));
  }
}

std::string WorkerWords::text() const {
  std::string text;
  if (most_ > 0) {
    text = fmt::format("the worker with most pairs computes {} of {}, {}\n", most_, all_,
                       most_ == ceil_div(all_, workers_) ? "the fewest possible"
                                                         : over_the_mean(most_, all_, workers_));
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
