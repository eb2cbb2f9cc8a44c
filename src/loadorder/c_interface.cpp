#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/core/version.hpp"
#include "changeover/loadorder/changeover_loadorder.h"
#include "changeover/loadorder/workers.hpp"
#include "changeover/run/control.hpp"
#include "loadorder/order/of_worker.hpp"
#include "loadorder/order/searched.hpp"
#include "loadorder/pairs/listed_rows.hpp"

struct changeover_loadorder {
  changeover_loadorder(std::variant<changeover::LoadOrder, changeover::WorkerSplit> given,
                       bool shows_pairs)
      : plan(std::move(given)), with_pairs(shows_pairs) {
    begin();
  }

  /// Continues with the first step of the worker, or with another step of a single worker.
  void begin(std::uint64_t from = 1) {
    step = {};
    pairs.clear();
    if (const auto* const split = std::get_if<changeover::WorkerSplit>(&plan)) {
      reader = split->stream(worker);
      if (with_pairs) {
        begin_with_pairs(*split);
      }
    } else {
      const auto& order = std::get<changeover::LoadOrder>(plan);
      if (facts().lockstep == 0) {
        reader = from == 1 ? order.stream() : order.stream_from(from);
      } else if (with_pairs) {
        const changeover::ScheduleRules rules = order.rules(changeover::ComputeRules{});
        reader = std::make_unique<changeover::OfWorker>(
            std::make_unique<changeover::StepWork>(order.stream(), rules), worker);
      } else {
        reader = order.stream(worker);
      }
    }
  }

  [[nodiscard]] const changeover::LoadOrderFacts& facts() const {
    const auto* const split = std::get_if<changeover::WorkerSplit>(&plan);
    return split != nullptr ? split->order().facts()
                            : std::get<changeover::LoadOrder>(plan).facts();
  }
  [[nodiscard]] const changeover::WorkerSplit* split() const {
    return std::get_if<changeover::WorkerSplit>(&plan);
  }

  std::variant<changeover::LoadOrder, changeover::WorkerSplit> plan;
  std::unique_ptr<changeover::StepSource> reader;
  std::uint64_t worker = 0;
  bool with_pairs = false;
  changeover::Step step;
  std::vector<std::uint32_t> pairs;
  std::string error;

 private:
  // If what a worker computes depends on the workers before it, their steps are read first.
  void begin_with_pairs(const changeover::WorkerSplit& all) {
    using changeover::StepWork;
    const changeover::ScheduleRules rules = all.rules(changeover::ComputeRules{});
    if (all.owners() != nullptr || worker == 0) {
      reader = std::make_unique<StepWork>(std::move(reader), rules, all.owners());
      return;
    }
    reader = std::make_unique<changeover::OfWorker>(std::make_unique<StepWork>(all.stream(), rules),
                                                    worker);
  }
};

namespace {

// Copies the text, cut to the given size and always terminated.
void say(char* error, std::size_t size, const char* text) {
  if (error != nullptr && size > 0) {
    const std::size_t length = std::min(std::strlen(text), size - 1);
    std::memcpy(error, text, length);
    error[length] = '\0';
  }
}

int fail(changeover_loadorder* order, const char* text) noexcept {
  try {
    order->error = text;
  } catch (...) {
    order->error.clear();  // the return value still reports the error
  }
  return CHANGEOVER_LOADORDER_ERROR;
}

// Returns the result of `act`; an exception becomes one line that is passed to `tell`.
template <typename Act, typename Tell>
auto without_throwing(const Act& act, const Tell& tell) noexcept -> decltype(act()) {
  try {
    return act();
  } catch (const std::bad_alloc&) {
    return tell("not enough memory for these parameters; give smaller ones");
  } catch (const std::length_error&) {
    return tell("not enough memory for these parameters; give smaller ones");
  } catch (const changeover::Stopped&) {
    return tell("cancelled");
  } catch (const std::exception& fault) {
    return tell(fault.what());
  } catch (...) {
    return tell("something unknown went wrong");
  }
}

// Options of the size of any header: members that a program does not know are 0.
// @throws BadInput for a size that no header has, and for an option that is newer than this library
changeover_loadorder_options options_in(const changeover_loadorder_options* given) {
  using changeover::BadInput;
  changeover_loadorder_options options{};
  if (given == nullptr) {
    return options;
  }
  // The smallest ends before `pairs`; nothing is read behind the largest.
  constexpr std::size_t most = 4096;
  const std::size_t size = given->size;
  if (size < offsetof(changeover_loadorder_options, pairs) || size > most) {
    throw BadInput("the size of the options is " + std::to_string(size) +
                   "; set it to sizeof (changeover_loadorder_options)");
  }
  const std::size_t known = std::min(size, sizeof options);
  std::memcpy(&options, given, known);
  const auto* const bytes = reinterpret_cast<const unsigned char*>(given);
  if (std::any_of(bytes + known, bytes + size, [](unsigned char byte) { return byte != 0; })) {
    throw BadInput("an option is set that version " + std::string(changeover::version) +
                   " does not know; leave it out, or use a newer library");
  }
  return options;
}

// The pairs within groups. @throws BadInput if there are none, or too many
std::shared_ptr<const changeover::PairGraph> groups_in(const changeover_loadorder_options& asked,
                                                       std::uint64_t items) {
  using namespace changeover;
  if (asked.group_sizes == nullptr) {
    throw BadInput("the groups have items, but group_sizes is NULL");
  }
  ListedRows rows(true);
  const std::uint32_t* next = asked.group_items;
  for (std::size_t g = 0; g < asked.group_count; ++g) {
    const std::span<const Element> group(next, asked.group_sizes[g]);
    next += group.size();
    if (!group.empty() && !rows.add(group)) {
      throw BadInput("group " + std::to_string(g) + " brings the wanted pairs to more than " +
                     std::to_string(most_pairs_in_groups) + "; give smaller groups");
    }
  }
  if (rows.pairs() == 0) {
    throw BadInput("no pair is in a group; give groups of two items or more");
  }
  return std::make_shared<const PairGraph>(
      items, [&](const PairGraph::Visit& visit) { rows.each_pair(visit); },
      std::vector<std::string>());
}

// The wanted pairs. @throws BadInput for more than one choice, or items that do not exist.
changeover::WantedPairs wanted_by(const changeover_loadorder_options& asked, std::uint64_t items) {
  using namespace changeover;
  const bool listed = asked.pairs != nullptr;
  const bool grouped = asked.group_items != nullptr;
  if ((listed ? 1 : 0) + (grouped ? 1 : 0) + (asked.against > 0 ? 1 : 0) +
          (asked.done_items > 0 ? 1 : 0) >
      1) {
    throw BadInput("give one of pairs, groups, against and done_items");
  }
  // A forgotten list is not all pairs.
  if (!listed && asked.pair_count > 0) {
    throw BadInput("pair_count is " + std::to_string(asked.pair_count) +
                   ", but pairs is NULL; give both");
  }
  if (!grouped && asked.group_count > 0) {
    throw BadInput("group_count is " + std::to_string(asked.group_count) +
                   ", but group_items is NULL; give both");
  }
  if (grouped) {
    return WantedPairs::listed(groups_in(asked, items));
  }
  if (listed) {
    std::vector<ItemPair> pairs;
    pairs.reserve(asked.pair_count);
    for (std::size_t i = 0; i < asked.pair_count; ++i) {
      pairs.emplace_back(asked.pairs[2 * i], asked.pairs[2 * i + 1]);
    }
    return WantedPairs::listed(std::make_shared<const PairGraph>(items, pairs));
  }
  return asked.against > 0      ? WantedPairs::between(items, asked.against)
         : asked.done_items > 0 ? WantedPairs::beyond(asked.done_items, items)
                                : WantedPairs(items);
}

// @throws BadInput if disjoint workers are asked for something that they cannot have
void check_disjoint_options(const changeover_loadorder_options& asked) {
  using changeover::BadInput;
  if (asked.workers == 0) {
    throw BadInput("disjoint needs workers; set workers to 1 or more");
  }
  const char* const other = asked.first_holder != 0      ? "first_holder"
                            : asked.pair_cost != nullptr ? "pair_cost"
                            : asked.unread != 0          ? "unread"
                                                         : nullptr;
  if (other != nullptr) {
    throw BadInput(std::string(other) + " has no meaning with disjoint; leave it out");
  }
}

changeover_loadorder* opened(std::uint64_t items, std::uint64_t room,
                             const changeover_loadorder_options& asked) {
  using namespace changeover;
  RunControl control({.found_elsewhere = [&] {
    return asked.cancelled != nullptr && asked.cancelled(asked.data) != 0;
  }});
  const RunScope scope(control);
  if (asked.disjoint != 0) {
    check_disjoint_options(asked);
  }
  if (!std::isfinite(asked.seconds) || asked.seconds < 0) {
    throw BadInput("seconds is not a number of seconds, 0 or more; correct it");
  }
  const WantedPairs wanted = wanted_by(asked, items);
  constexpr double most_seconds = 1e9;
  const std::uint64_t seed = asked.seed == 0 ? 1 : asked.seed;
  LoadOrderOptions options;
  options.seed = seed;
  if (asked.seconds > 0) {
    options = searched(std::min(asked.seconds, most_seconds), seed, control);
  }
  options.balance = asked.first_holder == 0;
  options.read_first = asked.unread == 0;
  if (asked.pair_cost != nullptr) {
    options.pair_cost = [&](Element x, Element y) { return asked.pair_cost(x, y, asked.data); };
  }
  const bool with_pairs = asked.with_pairs != 0;
  if (asked.disjoint != 0) {
    return new changeover_loadorder(plan_disjoint_order(wanted, room, asked.workers, options),
                                    with_pairs);
  }
  if (asked.workers > 1 || with_pairs) {
    const std::uint64_t workers = std::max<std::uint64_t>(1, asked.workers);
    return new changeover_loadorder(split_load_order(wanted, room, workers, options), with_pairs);
  }
  return new changeover_loadorder(plan_load_order(wanted, room, options), false);
}

}  // namespace

changeover_loadorder* changeover_loadorder_open(uint64_t items, uint64_t room, char* error,
                                                size_t error_size) {
  return changeover_loadorder_open_with(items, room, nullptr, error, error_size);
}

changeover_loadorder* changeover_loadorder_open_with(uint64_t items, uint64_t room,
                                                     const changeover_loadorder_options* options,
                                                     char* error, size_t error_size) {
  say(error, error_size, "");
  return without_throwing([&] { return opened(items, room, options_in(options)); },
                          [&](const char* text) -> changeover_loadorder* {
                            say(error, error_size, text);
                            return nullptr;
                          });
}

int changeover_loadorder_next(changeover_loadorder* order, changeover_loadorder_step* step) {
  if (order == nullptr || step == nullptr) {
    return order == nullptr ? CHANGEOVER_LOADORDER_ERROR
                            : fail(order, "step is NULL; give the address of a step");
  }
  return without_throwing(
      [&]() -> int {
        order->pairs.clear();
        if (!order->reader->next(order->step)) {
          return CHANGEOVER_LOADORDER_END;
        }
        const changeover::Step& next = order->step;
        for (const auto& [x, y] : next.compute) {
          order->pairs.push_back(x);
          order->pairs.push_back(y);
        }
        *step = {next.number, next.evict.data(), next.evict.size(), next.load.data(),
                 next.load.size()};
        return CHANGEOVER_LOADORDER_STEP;
      },
      [&](const char* text) { return fail(order, text); });
}

namespace {

// Makes another step the next one.
template <typename Act>
int go_to(changeover_loadorder* order, const Act& act) {
  if (order == nullptr) {
    return CHANGEOVER_LOADORDER_ERROR;
  }
  return without_throwing(
      [&]() -> int {
        act();
        return CHANGEOVER_LOADORDER_END;
      },
      [&](const char* text) { return fail(order, text); });
}

}  // namespace

int changeover_loadorder_rewind(changeover_loadorder* order) {
  return go_to(order, [&] { order->begin(); });
}

int changeover_loadorder_take_worker(changeover_loadorder* order, uint64_t worker) {
  return go_to(order, [&] {
    const std::uint64_t workers = changeover_loadorder_workers(order);
    if (worker >= workers) {
      throw changeover::BadInput("there is no worker " + std::to_string(worker) + "; give 0" +
                                 (workers == 1 ? "" : " to " + std::to_string(workers - 1)));
    }
    order->worker = worker;
    order->begin();
  });
}

int changeover_loadorder_seek(changeover_loadorder* order, uint64_t number) {
  return go_to(order, [&] {
    if (order->split() != nullptr || order->facts().lockstep > 0) {
      throw changeover::BadInput(
          "steps of several workers, and with pairs, are read from the first");
    }
    if (number == 0 || number > order->facts().steps) {
      throw changeover::BadInput("there is no step " + std::to_string(number) + "; give 1 to " +
                                 std::to_string(order->facts().steps));
    }
    order->begin(number);
  });
}

const uint32_t* changeover_loadorder_pairs(const changeover_loadorder* order, size_t* count) {
  if (count != nullptr) {
    *count = order == nullptr ? 0 : order->pairs.size() / 2;
  }
  return order == nullptr ? nullptr : order->pairs.data();
}

uint64_t changeover_loadorder_loads(const changeover_loadorder* order) {
  return order == nullptr            ? 0
         : order->split() != nullptr ? order->split()->facts().loads
                                     : order->facts().loads;
}

uint64_t changeover_loadorder_steps(const changeover_loadorder* order) {
  if (order == nullptr) {
    return 0;
  }
  if (order->split() == nullptr) {
    return order->facts().steps * std::max<uint64_t>(1, order->facts().lockstep);
  }
  uint64_t steps = 0;
  for (const changeover::WorkerFacts& worker : order->split()->facts().workers) {
    steps += worker.steps;
  }
  return steps;
}

uint64_t changeover_loadorder_lower_bound(const changeover_loadorder* order) {
  return order == nullptr ? 0 : order->facts().bound.loads;
}

uint64_t changeover_loadorder_workers(const changeover_loadorder* order) {
  return order == nullptr            ? 0
         : order->split() == nullptr ? std::max<uint64_t>(1, order->facts().lockstep)
                                     : order->split()->facts().workers.size();
}

uint64_t changeover_loadorder_worker_loads(const changeover_loadorder* order, uint64_t worker) {
  if (worker >= changeover_loadorder_workers(order)) {
    return 0;
  }
  const auto index = static_cast<std::size_t>(worker);
  return order->split() != nullptr      ? order->split()->facts().workers[index].loads
         : order->facts().lockstep == 0 ? order->facts().loads
                                        : order->facts().worker_loads[index];
}

uint64_t changeover_loadorder_worker_pairs(const changeover_loadorder* order, uint64_t worker) {
  if (worker >= changeover_loadorder_workers(order)) {
    return 0;
  }
  const auto index = static_cast<std::size_t>(worker);
  if (order->split() != nullptr) {
    return order->split()->facts().workers[index].pairs;
  }
  const changeover::LoadOrderFacts& facts = order->facts();
  return facts.lockstep == 0                 ? facts.wanted.among(facts.items).count()
         : index < facts.worker_pairs.size() ? facts.worker_pairs[index]
                                             : 0;
}

uint64_t changeover_loadorder_makespan_bound(const changeover_loadorder* order) {
  return order == nullptr               ? 0
         : order->split() != nullptr    ? order->split()->facts().makespan_bound.loads
         : order->facts().lockstep == 0 ? order->facts().bound.loads
                                        : order->facts().makespan_bound.loads;
}

const char* changeover_loadorder_error(const changeover_loadorder* order) {
  return order == nullptr ? "there is no order" : order->error.c_str();
}

const char* changeover_loadorder_version(void) {
  // A string_view of a literal, so it is terminated.
  return changeover::version.data();
}

void changeover_loadorder_close(changeover_loadorder* order) { delete order; }
