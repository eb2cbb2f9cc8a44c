// Load orders for systems.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "changeover/core/error.hpp"
#include "changeover/core/pair_set.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/load_request.hpp"
#include "changeover/loadorder/workers.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "io/request/request_document.hpp"
#include "io/write/json_writer.hpp"
#include "loadorder/show/loads_answer.hpp"
#include "loadorder/show/step_writer.hpp"
#include "serve/api/request_body.hpp"
#include "serve/api/routes.hpp"

namespace changeover::serve {
namespace {

constexpr std::uint64_t most_items_of_a_page = 20'000;
constexpr std::uint64_t most_steps = 5000;
constexpr std::uint64_t most_samples = 2000;

struct LoadQuestion {
  LoadRequest request;
  CheckedLoads loads;
  std::uint64_t bytes_per_item = 1;
};

// The page's own key, beside those of the document.
std::uint64_t take_bytes_per_item(RequestDocument& document) {
  constexpr std::uint64_t most_bytes = 1'000'000'000'000;
  const std::uint64_t bytes =
      document.take_number({.key = "bytes_per_item", .flags = "", .kind = ValueKind::number})
          .value_or(1);
  if (bytes < 1 || bytes > most_bytes) {
    throw Refusal{422, fmt::format("bytes_per_item: write 1 to {}", most_bytes)};
  }
  return bytes;
}

LoadQuestion question_of(const Request& sent) {
  RequestDocument document(load_table().format, sent.body, "");
  const std::uint64_t bytes = take_bytes_per_item(document);
  const auto request = read_request(load_table(), document);
  require_of_server(request, load_table());
  if (request.items.value_or(1) > most_items_of_a_page) {
    throw Refusal{422, fmt::format("items: write 1 to {}; changeover loadorder takes more",
                                   most_items_of_a_page)};
  }
  LoadQuestion question{.request = request,
                        .loads = from_body([&] { return checked_loads(request, Door::document); }),
                        .bytes_per_item = bytes};
  if (question.loads.items() > most_items_of_a_page) {
    throw Refusal{422, fmt::format("{} items; at most {} here; changeover loadorder takes more",
                                   question.loads.items(), most_items_of_a_page)};
  }
  return question;
}

// Follows all steps: samples for curves, and the referee.
class Account {
 public:
  Account(const CheckedLoads& asked, std::uint64_t steps)
      : asked_(asked),
        every_(steps / most_samples + 1),
        met_(asked.items()),
        check_({.items = asked.items(), .room = asked.room(), .wanted = asked.wanted()}) {}

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
        if (item != other && !met_.contains(item, other) && asked_.wanted().contains(item, other)) {
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
  const CheckedLoads& asked_;
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
  const LoadQuestion question = question_of(request);
  const CheckedLoads& asked = question.loads;
  const LoadsAnswer answer(asked, question.request, {});
  const auto* const split = std::get_if<WorkerSplit>(&answer.loads());
  const auto* const order = std::get_if<LoadOrder>(&answer.loads());
  const LoadOrderFacts& facts = split != nullptr ? split->order().facts() : order->facts();
  const std::uint64_t loads = split != nullptr ? split->facts().loads : facts.loads;
  const LoadBound bound = asked.wanted().are_all() ? load_lower_bound(asked.items(), asked.room())
                                                   : load_lower_bound(asked.wanted(), asked.room());
  std::uint64_t steps = facts.steps;
  if (split) {
    steps = 0;
    for (const WorkerFacts& worker : split->facts().workers) {
      steps += worker.steps;
    }
  }
  JsonWriter json;
  json.begin_object()
      .key("order")
      .raw(answer.head())
      .key("loads")
      .value(loads)
      .key("lower_bound")
      .value(bound.loads);
  json.key("reason").value(bound.reason).key("method").value(facts.method);
  json.key("explanation").value(split ? split->facts().explanation : facts.explanation);
  json.key("bytes").value(checked_multiply(loads, question.bytes_per_item));
  json.key("bytes_bound").value(checked_multiply(bound.loads, question.bytes_per_item));
  json.key("step_count").value(steps);
  Account account(asked, steps);
  std::uint64_t read = 0;
  StringSink lines;
  std::vector<Column> columns{Column::step, Column::load, Column::evict};
  if (split) {
    columns.insert(columns.begin(), Column::worker);
  }
  const PairGraph* const graph = asked.wanted().graph();
  StepWriter writer(lines, "jsonl", graph != nullptr ? &graph->names() : nullptr, columns);
  const auto stream = split ? split->stream() : order->stream();
  for (Step step; stream->next(step);) {
    account.read(step);
    if (read++ < most_steps) {
      writer.write(step);
    }
  }
  writer.end();
  account.finish(loads);
  std::string shown = lines.take();
  std::ranges::replace(shown, '\n', ',');
  shown.resize(shown.size() - std::min<std::size_t>(1, shown.size()));
  json.key("steps").raw("[" + shown + "]").key("truncated").value(read > most_steps);
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
