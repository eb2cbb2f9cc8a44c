#include "answer/loads/show_lockstep.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "answer/answer.hpp"
#include "answer/loads/step_writer.hpp"
#include "changeover/core/error.hpp"
#include "changeover/loadorder/write_back.hpp"
#include "io/write/json_writer.hpp"

namespace changeover::cli {
namespace {

// Calls take(steps) for the steps of all workers; with write-back for one more, in which everything goes.
template <typename Take>
void each(const DisjointOrder& order, const LockstepShown& how, Take&& take) {
  const DisjointFacts& facts = order.facts();
  const auto workers = static_cast<std::size_t>(facts.workers);
  std::vector<WriteBack> backs(how.write_back ? workers : 0, WriteBack(facts.items));
  std::vector<StoredStep> stored(workers);
  LockstepWork work(order, how.work);
  for (std::vector<WorkStep> steps; work.next(steps);) {
    for (std::size_t w = 0; w < workers; ++w) {
      std::swap(stored[w].work, steps[w]);
      if (how.write_back) {
        backs[w].read(stored[w]);
      }
    }
    take(stored);
  }
  if (how.write_back) {
    for (std::size_t w = 0; w < workers; ++w) {
      backs[w].finish(stored[w]);
    }
    take(stored);
  }
}

struct Verified {
  std::string text;  // one line about the check
  std::uint64_t stores = 0;
};

// @throws InternalError
Verified verify(const DisjointOrder& order, const LockstepShown& how) {
  const DisjointFacts& facts = order.facts();
  if (!how.new_pairs && !how.write_back) {
    return {facts.certificate};
  }
  Verified verified;
  LockstepCheck check(facts.items, facts.room, facts.workers, how.work);
  StoreCheck stores(facts.items);
  std::vector<WorkStep> works;
  each(order, how, [&](const std::vector<StoredStep>& steps) {
    works.clear();
    for (const StoredStep& step : steps) {
      works.push_back(step.work);
      verified.stores += step.store.size();
    }
    check.read(works);
    stores.read(steps);
  });
  const LockstepVerdict verdict = check.finish();
  const std::string lost = how.write_back ? stores.finish() : "";
  if (!verdict.valid() || verdict.loads != facts.loads || verdict.span != facts.span ||
      !lost.empty()) {
    throw InternalError(
        fmt::format("the order of the workers is wrong: {} missing, {} repeated; {}{}",
                    verdict.missing, verdict.repeated, verdict.fault, lost));
  }
  verified.text =
      fmt::format("every step read: no item held twice at once, {} computed, each once{}",
                  count_of(verdict.computed, "pair"), how.write_back ? "; no change is lost" : "");
  return verified;
}

}  // namespace

void show_lockstep(const DisjointOrder& order, const LockstepShown& how, OutputFile& out) {
  const DisjointFacts& facts = order.facts();
  const Verified checked = verify(order, how);
  const std::string& verified = checked.text;
  JsonWriter json;
  json.begin_object().key("items").value(facts.items).key("room").value(facts.room);
  const std::uint64_t count = facts.steps + (how.write_back ? 1 : 0);
  json.key("loads").value(facts.loads).key("steps").value(count);
  json.key("lower_bound").value(facts.bound.loads);
  json.key("lower_bound_reason").value(facts.bound.reason);
  json.key("method").value(facts.method).key("explanation").value(facts.explanation);
  json.key("workers").value(facts.workers).key("makespan").value(facts.makespan);
  json.key("span").value(facts.span);
  json.key("makespan_bound").value(facts.makespan_bound.loads);
  json.key("makespan_bound_reason").value(facts.makespan_bound.reason);
  const LoadBound store_bound = store_lower_bound(facts.bound, {}, facts.items, how.work.self);
  std::string stored;
  if (how.write_back) {
    json.key("stores").value(checked.stores).key("store_bound").value(store_bound.loads);
    stored = fmt::format("{}, at least {}: {}\n", count_of(checked.stores, "store"),
                         store_bound.loads, store_bound.reason);
  }
  json.key("disjoint").value(true).key("verified").value(verified).key("worker_loads");
  json.begin_array();
  for (const std::uint64_t loads : facts.worker_loads) {
    json.value(loads);
  }
  const auto over = [](std::uint64_t loads, std::uint64_t bound) {
    return loads == bound
               ? std::string("the fewest possible")
               : fmt::format("{:.2f} % over the lower bound {}",
                             100.0 * static_cast<double>(loads) / static_cast<double>(bound) - 100,
                             bound);
  };
  StepWriter writer(out, how.format, nullptr);
  writer.begin(
      json.end_array().end_object().take(),
      fmt::format("{}, {} with room for {}, no item at two of them: {} in {}, {}\n"
                  "the busiest worker has {}; the slowest of each step add up to {}, {}\n"
                  "{}{}: {}\nbound: {}\nbound of the busiest: {}\nverified: {}\n"
                  "each step: all {}evict, wait for each other, load, compute\n",
                  count_of(facts.items, "item"), count_of(facts.workers, "worker"), facts.room,
                  count_of(facts.loads, "load"), count_of(count, "step"),
                  over(facts.loads, facts.bound.loads), count_of(facts.makespan, "load"),
                  facts.span, over(facts.span, facts.makespan_bound.loads), stored, facts.method,
                  facts.explanation, facts.bound.reason, facts.makespan_bound.reason, verified,
                  how.write_back ? "store and " : ""),
      std::string("worker,step,load,evict") + (how.write_back ? ",store" : "") +
          (how.new_pairs ? ",new_pairs" : ""));
  each(order, how, [&](const std::vector<StoredStep>& steps) {
    for (std::size_t w = 0; w < steps.size(); ++w) {
      writer.write(steps[w].work.loads, w, how.new_pairs ? &steps[w].work.pairs : nullptr,
                   how.write_back ? &steps[w].store : nullptr);
    }
  });
  writer.end();
}

}  // namespace changeover::cli
