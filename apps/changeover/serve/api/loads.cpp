// Load orders for systems.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <ranges>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/core/pair_set.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/load_request.hpp"
#include "changeover/loadorder/workers.hpp"
#include "changeover/run/control.hpp"
#include "core/each.hpp"
#include "io/request/request_document.hpp"
#include "io/write/json_writer.hpp"
#include "loadorder/order/searched.hpp"
#include "loadorder/show/bytes_moved.hpp"
#include "loadorder/show/loads_answer.hpp"
#include "serve/api/request/query.hpp"
#include "serve/api/routes.hpp"

namespace changeover::serve {
namespace {

constexpr std::uint64_t most_items_of_a_page = 20'000;
constexpr std::uint64_t most_item_bytes = 1'000'000'000'000;
constexpr std::uint64_t most_steps = 10'000;
constexpr std::uint64_t most_samples = 2000;

void require_at_most(const LoadRequest& request, std::string_view key,
                     const std::optional<std::uint64_t>& value, std::uint64_t most) {
  if (value && (*value < 1 || *value > most)) {
    throw malformed(fmt::format("{}{}: write 1 to {}; changeover loadorder takes more",
                                request.places.before(key), key, most));
  }
}

CheckedLoads sent_loads(const Request& sent) {
  RequestDocument document(load_table().format, sent.body, std::string(name_of_body));
  document.for_server();
  document.rename("bytes_per_item", "item_bytes");  // its older name
  const LoadRequest request = read_request(load_table(), document);
  require_of_server(request, load_table());
  require_at_most(request, "items", request.items, most_items_of_a_page);
  require_at_most(request, "item_bytes", request.item_bytes, most_item_bytes);
  CheckedLoads asked = from_body([&] { return checked_loads(request, Door::document); });
  if (asked.items() > most_items_of_a_page) {
    throw Refusal{422, fmt::format("{} items; at most {} here; changeover loadorder takes more",
                                   asked.items(), most_items_of_a_page)};
  }
  return asked;
}

// Follows all steps: samples for curves, and the referee.
class Account {
 public:
  Account(const CheckedLoads& asked, std::uint64_t steps, const ScheduleRules& rules, bool epochs)
      : asked_(asked),
        come_(rules.fast_room ? &Step::fast_load : &Step::load),
        leave_(rules.fast_room ? &Step::fast_evict : &Step::evict),
        in_lockstep_(rules.lockstep > 0),
        one_by_one_(epochs && rules.lockstep == 0),
        every_(steps / most_samples + 1),
        met_(asked.items()),
        before_(one_by_one_ ? asked.items() : 0),
        ever_(before_),
        check_(rules) {}

  void read(const Step& step) {
    check_.read(step);
    workers_.resize(std::max<std::size_t>(workers_.size(), step.worker + 1));
    Memory& mine = workers_[static_cast<std::size_t>(step.worker)];
    mine.loads += step.load.size();
    mine.held = mine.held + step.load.size() - step.evict.size();
    for (const Element item : step.*leave_) {
      std::erase(mine.together, item);
    }
    if (step.worker != last_ && one_by_one_) {
      before_ = ever_;
      met_ = PairSet(asked_.items());
    }
    if (step.epoch != std::exchange(epoch_, step.epoch)) {
      met_ = PairSet(asked_.items());
    }
    if (step.epoch != std::exchange(mine.epoch, step.epoch)) {
      for (const Element item : std::exchange(mine.together, {})) {
        come(item, mine);
      }
    }
    for (const Element item : step.*come_) {
      come(item, mine);
    }
    if (asked_.sizes()) {
      for (const Element item : step.load) {
        mine.bytes += asked_.sizes()->bytes[item];
      }
    }
    if (count_++ % every_ == 0) {
      sample(mine);
      stop_if_asked();
    }
    last_ = step.worker;
  }

  /// @throws InternalError
  void finish(std::uint64_t loads) {
    const ScheduleVerdict verdict = check_.finish();
    if (!verdict.valid() || verdict.loads != loads) {
      throw InternalError(
          fmt::format("the load order is wrong: {}{}", verdict.fault, verdict.example));
    }
    if (held_.empty() || (count_ - 1) % every_ != 0) {
      sample(workers_.empty() ? Memory{} : workers_[static_cast<std::size_t>(last_)]);
    }
  }

  [[nodiscard]] std::uint64_t every() const { return every_; }
  [[nodiscard]] std::uint64_t pairs() const { return pairs_; }
  /// What each worker does.
  struct Memory {
    std::vector<Element> together;  // in memory, or of two levels on the accelerator
    std::uint64_t held = 0;
    std::uint64_t loads = 0;
    std::uint64_t bytes = 0;  // of items with sizes
    std::uint64_t pairs = 0;  // that no worker before had together in the epoch
    std::uint64_t epoch = 1;
  };
  [[nodiscard]] const std::vector<Memory>& workers() const { return workers_; }
  [[nodiscard]] const std::vector<std::uint64_t>& held() const { return held_; }
  [[nodiscard]] const std::vector<std::uint64_t>& done() const { return done_; }

 private:
  void come(Element item, Memory& mine) {
    for (const Element other : mine.together) {
      if (item != other && !met_.contains(item, other) &&
          !(one_by_one_ && before_.contains(item, other)) &&
          asked_.wanted().contains(item, other)) {
        met_.insert(item, other);
        if (one_by_one_) {
          ever_.insert(item, other);
        }
        ++pairs_;
        ++mine.pairs;
      }
    }
    mine.together.push_back(item);
  }

  // What is in memory: of the worker whose steps are read, or of all that step together.
  void sample(const Memory& mine) {
    std::uint64_t held = in_lockstep_ ? 0 : mine.held;
    for (std::size_t i = 0; in_lockstep_ && i < workers_.size(); ++i) {
      held += workers_[i].held;
    }
    held_.push_back(held);
    done_.push_back(pairs_);
  }

  const CheckedLoads& asked_;
  std::vector<Element> Step::*come_;
  std::vector<Element> Step::*leave_;
  bool in_lockstep_;
  bool one_by_one_;  // workers, through all epochs each
  std::uint64_t epoch_ = 1;
  std::uint64_t every_;
  PairSet met_;     // in this epoch; of workers one by one, by this one
  PairSet before_;  // then, by the workers before it: a worker has the same pairs in each epoch
  PairSet ever_;    // by it, too
  ScheduleCheck check_;
  std::uint64_t count_ = 0;
  std::uint64_t pairs_ = 0;
  std::vector<Memory> workers_;
  std::uint64_t last_ = 0;
  std::vector<std::uint64_t> held_;
  std::vector<std::uint64_t> done_;
};

// The first lines of a document, up to so many bytes; what follows is let through.
class FirstLines final : public Sink {
 public:
  FirstLines(std::uint64_t lines, std::size_t bytes) : lines_(lines), bytes_(bytes) {}

  void write(std::string_view bytes) override {
    stop_if_asked();
    while (lines_ > 0 && !bytes.empty()) {
      const std::size_t end = std::min(bytes.find('\n'), bytes.size() - 1) + 1;
      if (whole_ > 0 && text_.size() + end > bytes_) {
        text_.resize(whole_);
        lines_ = 0;
        break;
      }
      text_.append(bytes.substr(0, end));
      if (bytes[end - 1] == '\n') {
        whole_ = text_.size();
        --lines_;
      }
      bytes.remove_prefix(end);
    }
    truncated_ = truncated_ || !bytes.empty();
  }

  [[nodiscard]] bool truncated() const { return truncated_; }
  /// The first line, and the others as an array.
  [[nodiscard]] std::string head() const { return text_.substr(0, text_.find('\n')); }
  [[nodiscard]] std::string others() const {
    std::string list = text_.substr(std::min(text_.find('\n'), text_.size() - 1) + 1);
    std::ranges::replace(list, '\n', ',');
    list.resize(list.size() - std::min<std::size_t>(1, list.size()));
    return "[" + list + "]";
  }

 private:
  std::uint64_t lines_;  // that are still taken
  std::size_t bytes_;
  std::size_t whole_ = 0;  // bytes of whole lines
  bool truncated_ = false;
  std::string text_;
};

using Memories = std::vector<Account::Memory>;

void write_workers(JsonWriter& json, const LoadsAnswer& answer, const Memories& workers) {
  const WorkerSplit& split = *answer.split();
  const SplitFacts& facts = split.facts();
  json.key("makespan").value(facts.makespan);
  json.key("makespan_bound").value(answer.makespan_bound().loads);
  json.key("worker_loads").value(facts.workers | std::views::transform(&WorkerFacts::loads));
  if (split.order().facts().sizes != nullptr) {
    json.key("makespan_bytes").value(facts.makespan_bytes);
    json.key("makespan_bytes_bound").value(facts.makespan_bytes_bound.loads);
    json.key("worker_bytes").value(facts.workers | std::views::transform(&WorkerFacts::bytes));
  }
  json.key("worker_pairs").begin_array();
  for (std::size_t i = 0; i < facts.workers.size(); ++i) {
    const std::uint64_t met = i < workers.size() ? workers[i].pairs : 0;
    json.value(facts.pairs_are_known ? facts.workers[i].pairs : met);
  }
  json.end_array();
}

// Workers that step together and never hold one item twice.
void write_lockstep(JsonWriter& json, const LoadOrderFacts& facts, const Memories& workers) {
  const auto most = [&](std::uint64_t Account::Memory::*what) {
    return std::ranges::max(workers, {}, what).*what;
  };
  json.key("makespan").value(most(&Account::Memory::loads));
  json.key("makespan_bound").value(facts.makespan_bound.loads);
  json.list("worker_loads", workers, [&](const auto& worker) { json.value(worker.loads); });
  if (facts.sizes != nullptr) {
    json.key("makespan_bytes").value(most(&Account::Memory::bytes));
    json.key("makespan_bytes_bound").value(facts.makespan_byte_bound.loads);
    json.list("worker_bytes", workers, [&](const auto& worker) { json.value(worker.bytes); });
  }
  json.list("worker_pairs", workers, [&](const auto& worker) { json.value(worker.pairs); });
}

Response load_order(const Explorer& explorer, const Request& request) {
  const CheckedLoads asked = sent_loads(request);
  const LoadRequest& said = asked.request();
  const SearchTimes& times = load_table().times;
  const double seconds = search_seconds(said, times.server, times.most_of_server);
  // What is not done in this time is left out; the rest is for reading what has been found.
  RunControl limit(*RunScope::current(), explorer.limits.seconds / 2);
  const LoadsAnswer answer = from_body(
      [&] { return LoadsAnswer(asked, searched(seconds, said.seed.value_or(1), limit)); });
  stop_if_asked();  // The client may have gone.
  const WorkerSplit* const split = answer.split();
  const LoadOrder& order = split != nullptr ? split->order() : *answer.order();
  const LoadOrderFacts& facts = order.facts();
  const std::uint64_t loads = split != nullptr ? split->facts().loads : facts.loads;
  const std::uint64_t steps = split != nullptr
                                  ? sum_of(split->facts().workers, &WorkerFacts::steps)
                                  : facts.steps * std::max<std::uint64_t>(1, facts.lockstep);
  const LoadBound bound = answer.bound();
  FirstLines lines(most_steps + 1, explorer.limits.plan_bytes);
  answer.write("jsonl", lines);
  ScheduleRules rules = split != nullptr ? split->rules() : order.rules();
  rules.room = asked.room();
  Account account(asked, steps, rules, said.epochs.value_or(1) > 1);
  const auto stream = split != nullptr ? split->stream() : order.stream();
  for (Step step; stream->next(step);) {
    account.read(step);
  }
  account.finish(loads);
  JsonWriter json;
  json.begin_object().key("order").raw(lines.head()).key("loads").value(loads);
  json.key("lower_bound").value(bound.loads).key("reason").value(bound.reason);
  json.key("method").value(facts.method).key("explanation");
  json.value(split != nullptr ? split->facts().explanation : facts.explanation);
  const bool has_sizes = asked.sizes() != nullptr;
  const auto bytes_of = [&](std::uint64_t count) {
    return bytes_moved(count, said.item_bytes.value_or(1), "item_bytes", "loads");
  };
  json.key("bytes").value(has_sizes ? facts.bytes : bytes_of(loads));
  json.key("bytes_bound").value(has_sizes ? facts.byte_bound.loads : bytes_of(bound.loads));
  json.key("step_count").value(steps);
  json.key("steps").raw(lines.others()).key("truncated").value(lines.truncated());
  json.key("sample_every").value(account.every());
  json.key("memory").value(account.held()).key("pairs_done").value(account.done());
  json.key("pairs").value(account.pairs());
  if (split != nullptr) {
    write_workers(json, answer, account.workers());
  } else if (facts.lockstep > 0) {
    write_lockstep(json, facts, account.workers());
  }
  if (answer.spare()) {
    json.key("spare").value(*answer.spare());
  }
  json.key("time_is_up")
      .value(answer.time_is_up() || limit.why_stopped() == WhyStopped::time_limit);
  json.key("verified").value(true).end_object();
  return json_response(json.take() + "\n");
}

}  // namespace

void add_loads(Router& router, Explorer& explorer) {
  router.add(posted(explorer, "api/loadorder", {}, Body::json,
                    [&explorer](const Request& request) { return load_order(explorer, request); }));
}

}  // namespace changeover::serve
