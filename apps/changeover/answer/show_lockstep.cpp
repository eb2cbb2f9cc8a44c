#include "answer/show_lockstep.hpp"

#include <fmt/format.h>

#include <vector>

#include "answer/answer.hpp"
#include "answer/step_writer.hpp"
#include "changeover/core/error.hpp"
#include "io/write/json_writer.hpp"

namespace changeover::cli {
namespace {

// One line about the check. @throws InternalError
std::string verify(const DisjointOrder& order, const LockstepShown& how) {
  const DisjointFacts& facts = order.facts();
  LockstepCheck check(facts.items, facts.room, facts.workers, how.work);
  LockstepWork work(order, how.work);
  for (std::vector<WorkStep> steps; work.next(steps);) {
    check.read(steps);
  }
  const LockstepVerdict verdict = check.finish();
  if (!verdict.valid() || verdict.loads != facts.loads || verdict.span != facts.span) {
    throw InternalError(
        fmt::format("the order of the workers is wrong: {} missing, {} repeated; {}",
                    verdict.missing, verdict.repeated, verdict.fault));
  }
  return fmt::format("every step read: no item is held by two workers, {} computed, each once",
                     count_of(verdict.computed, "pair"));
}

}  // namespace

void show_lockstep(const DisjointOrder& order, const LockstepShown& how, OutputFile& out) {
  const DisjointFacts& facts = order.facts();
  const std::string verified = how.new_pairs ? verify(order, how) : facts.certificate;
  JsonWriter json;
  json.begin_object().key("items").value(facts.items).key("room").value(facts.room);
  json.key("loads").value(facts.loads).key("steps").value(facts.steps);
  json.key("lower_bound").value(facts.bound.loads);
  json.key("lower_bound_reason").value(facts.bound.reason);
  json.key("method").value(facts.method).key("explanation").value(facts.explanation);
  json.key("workers").value(facts.workers).key("makespan").value(facts.makespan);
  json.key("span").value(facts.span);
  json.key("makespan_bound").value(facts.makespan_bound.loads);
  json.key("makespan_bound_reason").value(facts.makespan_bound.reason);
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
                  "{}: {}\nbound: {}\nbound of the busiest: {}\nverified: {}\n"
                  "each step: all evict, wait for each other, load, compute\n",
                  count_of(facts.items, "item"), count_of(facts.workers, "worker"), facts.room,
                  count_of(facts.loads, "load"), count_of(facts.steps, "step"),
                  over(facts.loads, facts.bound.loads), count_of(facts.makespan, "load"),
                  facts.span, over(facts.span, facts.makespan_bound.loads), facts.method,
                  facts.explanation, facts.bound.reason, facts.makespan_bound.reason, verified),
      std::string("worker,step,load,evict") + (how.new_pairs ? ",new_pairs" : ""));
  LockstepWork work(order, how.work);
  for (std::vector<WorkStep> steps; work.next(steps);) {
    for (std::size_t w = 0; w < steps.size(); ++w) {
      writer.write(steps[w].loads, w, how.new_pairs ? &steps[w].pairs : nullptr);
    }
  }
  writer.end();
}

}  // namespace changeover::cli
