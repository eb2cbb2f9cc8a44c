#include "loadorder/show/loads_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/workers.hpp"
#include "changeover/run/control.hpp"
#include "io/request/request_words.hpp"
#include "loadorder/order/in_rounds.hpp"
#include "loadorder/order/of_worker.hpp"

namespace changeover {
namespace {

// All steps are read before one worker's are written, if they show more than loads and new pairs,
// or depend on those of other workers.
bool is_worker_by_itself(const LoadRequest& request) {
  return request.worker && !(request.disjoint || request.fast_room || request.prefetch ||
                             request.write_back || request.spread);
}

bool starts_early(const LoadRequest& request) {
  return request.prefetch && (request.fast_room || request.fast_memory);
}

LoadsShown shown_as_asked(const CheckedLoads& asked) {
  const LoadRequest& request = asked.request();
  const std::uint64_t seed = request.seed.value_or(1);
  LoadsShown how{
      .format = {},
      .compute = {.ordered = request.ordered, .self = request.self},
      .new_pairs = request.new_pairs || starts_early(request),
      .early = starts_early(request),
      .write_back = request.write_back,
      .searched = request.seconds.has_value(),
      .seed = seed,
      .item_bytes = request.item_bytes,
      .item_bytes_key = spelled(option_of(load_table(), "item_bytes").record, asked.door()),
      .worker = request.worker,
      .worker_by_itself = is_worker_by_itself(request),
      .from_step = request.from_step,
      .beside = request.verify_beside};
  if (request.shuffle) {
    how.compute.shuffle = seed;
  }
  if (request.spread) {
    how.compute.spread = seed;
  }
  return how;
}

AnyLoads planned(const CheckedLoads& asked, LoadOrderOptions options) {
  const LoadRequest& request = asked.request();
  options.balance = !request.first_holder;
  options.pair_cost = asked.pair_cost();
  options.read_first = !request.verify_beside && !is_worker_by_itself(request);
  const WantedPairs& wanted = asked.wanted();
  const auto& sizes = asked.sizes();
  const std::uint64_t room = asked.room();
  const std::uint64_t workers = request.workers.value_or(1);
  // Each of these takes sizes and pairs, or pairs and rooms.
  const auto levels = [&](const auto&... given) -> AnyLoads {
    if (request.disjoint) {
      return plan_disjoint_levels(given..., workers, options);
    }
    if (request.workers) {
      return split_two_levels(given..., workers, options);
    }
    return plan_two_levels(given..., options);
  };
  const auto one_level = [&](const auto&... given) -> AnyLoads {
    if (request.disjoint) {
      return plan_disjoint_order(given..., workers, options);
    }
    if (request.workers) {
      return split_prefetch(given..., workers, options);
    }
    return plan_prefetch(given..., options);
  };
  if (request.fast_memory) {
    return levels(sizes, wanted);
  }
  if (request.fast_room) {
    return levels(wanted, room, *request.fast_room);
  }
  if (request.disjoint || request.prefetch) {
    return sizes ? one_level(sizes, wanted) : one_level(wanted, room);
  }
  if (request.workers) {
    return sizes ? split_sized_order(sizes, wanted, workers, options)
                 : split_load_order(wanted, room, workers, options);
  }
  return sizes ? plan_sized_order(sizes, wanted, options) : plan_load_order(wanted, room, options);
}

AnyLoads repeated(AnyLoads loads, std::uint64_t epochs) {
  struct Again {
    std::uint64_t epochs;
    AnyLoads operator()(LoadOrder& order) const { return repeat_order(std::move(order), epochs); }
    AnyLoads operator()(WorkerSplit& split) const {
      return repeat_shares(std::move(split), epochs);
    }
    AnyLoads operator()(PrefetchPlan& plan) const {
      return PrefetchPlan{repeat_order(std::move(plan.order), epochs), plan.spare};
    }
    AnyLoads operator()(PrefetchSplit& plan) const {
      return PrefetchSplit{repeat_shares(std::move(plan.order), epochs), plan.spare};
    }
  };
  return epochs == 1 ? std::move(loads) : std::visit(Again{epochs}, loads);
}

// Loads of two levels are a WorkerSplit or a LoadOrder.
AnyLoads started_early(AnyLoads loads) {
  if (auto* const split = std::get_if<WorkerSplit>(&loads)) {
    return start_loads_early(std::move(*split));
  }
  return start_loads_early(std::get<LoadOrder>(std::move(loads)));
}

// For workers in lockstep, an order with a small span forward may have a large one backward. So the
// better of two orders is taken: with a search, and without.
AnyLoads repeated_lockstep(const CheckedLoads& asked, const LoadOrderOptions& options) {
  const std::uint64_t epochs = *asked.request().epochs;
  AnyLoads without = repeated(planned(asked, fixed_work(options)), epochs);
  AnyLoads with = repeated(planned(asked, options), epochs);
  const auto span_of = [](const AnyLoads& loads) {
    const LoadOrderFacts& facts = std::get<LoadOrder>(loads).facts();
    return facts.sizes ? std::pair(facts.span_bytes, facts.bytes)
                       : std::pair(facts.span, facts.loads);
  };
  return span_of(with) < span_of(without) ? std::move(with) : std::move(without);
}

AnyLoads loads_for(const CheckedLoads& asked, const LoadOrderOptions& options) {
  const LoadRequest& request = asked.request();
  const bool one_level = !request.fast_room && !request.fast_memory;
  if (request.disjoint && one_level && request.epochs.value_or(1) > 1 && options.search_pairs) {
    return repeated_lockstep(asked, options);
  }
  AnyLoads loads = repeated(planned(asked, options), request.epochs.value_or(1));
  return starts_early(request) ? started_early(std::move(loads)) : std::move(loads);
}

LoadOrderOptions told_when_cut_short(LoadOrderOptions options, bool& is_cut_short) {
  options.on_cut_short = [&is_cut_short] { is_cut_short = true; };
  return options;
}

// When memory is full for the first time, all pairs in it are new.
void require_memory_for_a_step(const CheckedLoads& asked) {
  const LoadRequest& request = asked.request();
  if (!request.new_pairs) {
    return;
  }
  const RequestWords<LoadRequest> words(load_table(), request, asked.door());
  const std::uint64_t there = std::min(asked.room(), asked.items());
  const std::uint64_t pairs = std::min(there * (there - 1) / 2, asked.wanted().count());
  const std::uint64_t copies = request.ordered ? 3 : 2;  // as they are found, and as they are said
  require_memory(pairs * copies * sizeof(ItemPair),
                 fmt::format("a step of {} with {} {}", words.key("new_pairs"), words.key("room"),
                             asked.room()));
}

}  // namespace

LoadsAnswer::LoadsAnswer(CheckedLoads asked, const LoadOrderOptions& options)
    : asked_(std::move(asked)), room_(asked_.room()), how_(shown_as_asked(asked_)), loads_([&] {
        require_memory_for_a_step(asked_);
        return loads_for(asked_, told_when_cut_short(options, how_.time_is_up));
      }()) {
  if (how_.from_step) {
    const RequestWords<LoadRequest> words(load_table(), asked_.request(), asked_.door());
    try {
      static_cast<void>(order()->stream_from(*how_.from_step));
    } catch (const BadInput& fault) {
      words.refuse("from_step",
                   fmt::format("{} {}: {}", words.key("from_step"), *how_.from_step, fault.what()));
    }
  }
}

namespace {

std::unique_ptr<StepSource> with_work(const LoadOrder& order, const ScheduleRules& rules,
                                      std::optional<std::uint64_t> worker) {
  std::unique_ptr<StepSource> all = order.stream();
  if (rules.compute) {
    all = std::make_unique<StepWork>(std::move(all), rules);
  }
  return worker && order.facts().lockstep > 0 ? std::make_unique<OfWorker>(std::move(all), *worker)
                                              : std::move(all);
}

// What a worker computes may depend on the workers before it.
std::unique_ptr<StepSource> with_work(const WorkerSplit& split, const ScheduleRules& rules,
                                      std::optional<std::uint64_t> worker) {
  const bool alone = worker && (!rules.compute || split.owners() != nullptr);
  std::unique_ptr<StepSource> steps = alone ? split.stream(*worker) : split.stream();
  if (rules.compute) {
    steps = std::make_unique<StepWork>(std::move(steps), rules, split.owners());
  }
  return worker && !alone ? std::make_unique<OfWorker>(std::move(steps), *worker)
                          : std::move(steps);
}

}  // namespace

const LoadOrder* LoadsAnswer::order() const {
  const auto* const plan = std::get_if<PrefetchPlan>(&loads_);
  return plan != nullptr ? &plan->order : std::get_if<LoadOrder>(&loads_);
}

const WorkerSplit* LoadsAnswer::split() const {
  const auto* const plan = std::get_if<PrefetchSplit>(&loads_);
  return plan != nullptr ? &plan->order : std::get_if<WorkerSplit>(&loads_);
}

std::optional<std::uint64_t> LoadsAnswer::spare() const {
  const auto* const plan = std::get_if<PrefetchPlan>(&loads_);
  const auto* const shares = std::get_if<PrefetchSplit>(&loads_);
  return plan != nullptr     ? std::optional(plan->spare)
         : shares != nullptr ? std::optional(shares->spare)
                             : std::nullopt;
}

ScheduleRules LoadsAnswer::rules(const std::optional<ComputeRules>& compute) const {
  return split() != nullptr ? split()->rules(compute) : order()->rules(compute);
}

ScheduleRules LoadsAnswer::rules() const {
  ScheduleRules all = rules(shows_work() ? std::optional(how_.compute) : std::nullopt);
  all.room = room_;
  all.store = how_.write_back;
  all.overlap = spare().has_value();
  return all;
}

LoadBound LoadsAnswer::bound() const {
  return bound_of_loads(
      rules(std::nullopt), room_,
      split() != nullptr ? split()->facts().workers.size() : order()->facts().lockstep);
}

LoadBound LoadsAnswer::makespan_bound() const {
  const std::uint64_t kept = asked_.sizes() ? 0 : spare().value_or(0);
  return makespan_bound_of(*split(), split()->facts().room + kept);
}

std::unique_ptr<StepSource> LoadsAnswer::steps(std::optional<std::uint64_t> worker) const {
  // NOLINTNEXTLINE(clang-analyzer-cplusplus.NewDeleteLeaks): the caller owns it
  return split() != nullptr ? with_work(*split(), rules(), worker)
                            : with_work(*order(), rules(), worker);
}

std::string LoadsAnswer::fault() const {
  const ScheduleRules all = rules();
  CheckOptions options;
  options.all_pairs = all.items <= max_elements_in_memory || all.wanted.graph() != nullptr;
  const auto reader = steps(std::nullopt);
  const ScheduleVerdict verdict = check_schedule(*reader, all, options);
  return verdict.valid() ? "" : "the load order is wrong: " + verdict.fault + verdict.example;
}

void LoadsAnswer::write(const std::string& format, Sink& sink) const {
  LoadsShown how = how_;
  how.format = format;
  check_format(asked_, format);
  if (format == "marius" || format == "colmap") {
    how.new_pairs = true;
    how.write_back = how.beside = false;
  }
  if (format == "marius") {  // pairs are edge buckets
    how.compute.ordered = how.compute.self = true;
  }
  std::visit([&](const auto& loads) { show_loads(loads, how, sink); }, loads_);
}

std::string LoadsAnswer::head() const {
  StringSink sink;
  LoadsShown how = how_;
  how.format = "jsonl";
  how.head_only = true;
  std::visit([&](const auto& loads) { show_loads(loads, how, sink); }, loads_);
  std::string line = sink.text();
  line.pop_back();  // without the line end
  return line;
}

}  // namespace changeover
