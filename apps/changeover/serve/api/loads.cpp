// Load orders for systems.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "changeover/core/error.hpp"
#include "changeover/core/pair_set.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/workers.hpp"
#include "changeover/run/scope.hpp"
#include "core/checked.hpp"
#include "io/write/json_writer.hpp"
#include "serve/api/json_body.hpp"
#include "serve/api/routes.hpp"

namespace changeover::serve {
namespace {

constexpr std::uint64_t most_items_of_a_page = 20'000;
constexpr std::uint64_t most_steps = 5000;
constexpr std::uint64_t most_samples = 2000;

struct Asked {
  std::uint64_t items = 0;
  std::uint64_t room = 0;
  std::uint64_t bytes_per_item = 1;
  std::uint64_t workers = 1;
  WantedPairs wanted = {};
};

WantedPairs pairs_of(const nlohmann::json& list, std::uint64_t items) {
  std::vector<ItemPair> pairs;
  if (!list.is_array()) {
    throw Refusal{422, "pairs: write [[a,b],…]"};
  }
  for (const nlohmann::json& pair : list) {
    const bool two = pair.is_array() && pair.size() == 2 && pair[0].is_number_unsigned() &&
                     pair[1].is_number_unsigned();
    if (!two || pair[0].get<std::uint64_t>() >= items || pair[1].get<std::uint64_t>() >= items) {
      throw Refusal{422, fmt::format("pairs: write [a,b] with two items from 0 to {}", items - 1)};
    }
    const auto x = pair[0].get<Element>();
    const auto y = pair[1].get<Element>();
    pairs.emplace_back(std::min(x, y), std::max(x, y));
  }
  return WantedPairs::listed(std::make_shared<const PairGraph>(items, pairs));
}

Asked asked_of(const Request& request) {
  JsonBody body(request.body);
  Asked asked;
  asked.items = body.needed_number("items");
  asked.room = body.needed_number("room");
  asked.bytes_per_item = body.number("bytes_per_item").value_or(1);
  asked.workers = body.number("workers").value_or(1);
  if (asked.items < 1 || asked.items > most_items_of_a_page) {
    throw Refusal{422, fmt::format("items: write 1 to {}; changeover loadorder takes more",
                                   most_items_of_a_page)};
  }
  if (asked.room < 2) {
    throw Refusal{422, "room: no pair can meet; write at least 2"};
  }
  if (asked.workers < 1 || asked.workers > most_workers) {
    throw Refusal{422, fmt::format("workers: write 1 to {}", most_workers)};
  }
  constexpr std::uint64_t most_bytes = 1'000'000'000'000;
  if (asked.bytes_per_item < 1 || asked.bytes_per_item > most_bytes) {
    throw Refusal{422, fmt::format("bytes_per_item: write 1 to {}", most_bytes)};
  }
  if (const nlohmann::json* const pairs = body.find("pairs")) {
    asked.wanted = pairs_of(*pairs, asked.items);
  }
  body.finish();
  return asked;
}

// Follows all steps: samples for curves, and the referee.
class Account {
 public:
  Account(const Asked& asked, std::uint64_t steps)
      : asked_(asked),
        every_(steps / most_samples + 1),
        met_(asked.items),
        check_({.items = asked.items, .room = asked.room, .wanted = asked.wanted}) {}

  void read(const Step& step) {
    check_.read(step);
    if (step.number == 1) {
      memory_.clear();
    }
    for (const Element item : step.evict) {
      std::erase(memory_, item);
    }
    for (const Element item : step.load) {
      for (const Element other : memory_) {
        if (item != other && !met_.contains(item, other) && asked_.wanted.contains(item, other)) {
          met_.insert(item, other);
          ++pairs_;
        }
      }
      memory_.push_back(item);
    }
    if (count_++ % every_ == 0) {
      held_.push_back(memory_.size());
      done_.push_back(pairs_);
      stop_if_asked();
    }
  }

  /// @throws InternalError
  void finish(std::uint64_t loads) {
    const ScheduleVerdict verdict = check_.finish();
    if (!verdict.valid() || verdict.loads != loads) {
      throw InternalError(
          fmt::format("the load order is wrong: {}{}", verdict.fault, verdict.example));
    }
    if (held_.empty() || (count_ - 1) % every_ != 0) {
      held_.push_back(memory_.size());
      done_.push_back(pairs_);
    }
  }

  [[nodiscard]] std::uint64_t every() const { return every_; }
  [[nodiscard]] std::uint64_t pairs() const { return pairs_; }
  [[nodiscard]] const std::vector<std::uint64_t>& held() const { return held_; }
  [[nodiscard]] const std::vector<std::uint64_t>& done() const { return done_; }

 private:
  const Asked& asked_;
  std::uint64_t every_;
  std::vector<Element> memory_;
  PairSet met_;
  ScheduleCheck check_;
  std::uint64_t count_ = 0;
  std::uint64_t pairs_ = 0;
  std::vector<std::uint64_t> held_;
  std::vector<std::uint64_t> done_;
};

Response load_order(const Request& request) {
  const Asked asked = asked_of(request);
  const bool all = asked.wanted.are_all();
  std::optional<WorkerSplit> split;
  if (asked.workers > 1) {
    split.emplace(all ? split_load_order(asked.items, asked.room, asked.workers)
                      : split_load_order(asked.wanted, asked.room, asked.workers));
  }
  std::optional<LoadOrder> order;
  if (!split) {
    order.emplace(all ? plan_load_order(asked.items, asked.room)
                      : plan_load_order(asked.wanted, asked.room));
  }
  const LoadOrderFacts& facts = split ? split->order().facts() : order->facts();
  const std::uint64_t loads = split ? split->facts().loads : facts.loads;
  const LoadBound bound =
      all ? load_lower_bound(asked.items, asked.room) : load_lower_bound(asked.wanted, asked.room);
  std::uint64_t steps = facts.steps;
  if (split) {
    steps = 0;
    for (const WorkerFacts& worker : split->facts().workers) {
      steps += worker.steps;
    }
  }
  JsonWriter json;
  json.begin_object().key("loads").value(loads).key("lower_bound").value(bound.loads);
  json.key("reason").value(bound.reason).key("method").value(facts.method);
  json.key("explanation").value(split ? split->facts().explanation : facts.explanation);
  json.key("bytes").value(checked_multiply(loads, asked.bytes_per_item));
  json.key("bytes_bound").value(checked_multiply(bound.loads, asked.bytes_per_item));
  json.key("step_count").value(steps).key("steps").begin_array();
  Account account(asked, steps);
  std::uint64_t written = 0;
  const auto stream = split ? split->stream() : order->stream();
  for (Step step; stream->next(step);) {
    account.read(step);
    if (written++ < most_steps) {
      json.begin_object().key("step").value(step.number);
      if (split) {
        json.key("worker").value(step.worker);
      }
      json.key("load").value(step.load).key("evict").value(step.evict).end_object();
    }
  }
  account.finish(loads);
  json.end_array().key("truncated").value(written > most_steps);
  json.key("sample_every").value(account.every());
  json.key("memory").value(account.held()).key("pairs_done").value(account.done());
  json.key("pairs").value(account.pairs());
  if (split) {
    json.key("makespan").value(split->facts().makespan);
    json.key("makespan_bound").value(split->facts().makespan_bound.loads);
    json.key("worker_loads").begin_array();
    for (const WorkerFacts& worker : split->facts().workers) {
      json.value(worker.loads);
    }
    json.end_array();
  }
  json.key("verified").value(true).end_object();
  return json_response(json.take() + "\n");
}

}  // namespace

void add_loads(Router& router, Explorer& explorer) {
  router.add(posted(explorer, "api/loadorder", {}, Body::json, load_order));
}

}  // namespace changeover::serve
