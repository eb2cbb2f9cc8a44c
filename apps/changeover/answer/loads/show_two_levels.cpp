#include "answer/loads/show_two_levels.hpp"

#include <fmt/format.h>

#include "answer/answer.hpp"
#include "answer/loads/step_writer.hpp"
#include "core/checked.hpp"
#include "io/write/json_writer.hpp"

namespace changeover::cli {
namespace {

// What is said of a level: how often items move, the fewest there can be, the bytes.
std::string level(std::uint64_t count, const std::string& what, const LoadBound& bound,
                  std::optional<std::uint64_t> item_bytes) {
  const std::string bytes =
      item_bytes ? fmt::format(" ({} bytes)", checked_multiply(count, *item_bytes)) : "";
  if (count == bound.loads) {
    return fmt::format("{}{}, the fewest possible", count_of(count, what), bytes);
  }
  return fmt::format("{}{}, {:.2f} % over the lower bound {}", count_of(count, what), bytes,
                     100.0 * static_cast<double>(count) / static_cast<double>(bound.loads) - 100,
                     bound.loads);
}

}  // namespace

void show_two_levels(const TwoLevelOrder& order, const std::string& format,
                     std::optional<std::uint64_t> item_bytes, bool new_pairs, OutputFile& out) {
  const TwoLevelFacts& facts = order.facts();
  JsonWriter json;
  json.begin_object().key("items").value(facts.items).key("room").value(facts.room);
  json.key("fast_room").value(facts.fast_room).key("loads").value(facts.loads);
  json.key("transfers").value(facts.transfers).key("steps").value(facts.steps);
  json.key("lower_bound").value(facts.load_bound.loads);
  json.key("lower_bound_reason").value(facts.load_bound.reason);
  json.key("transfer_bound").value(facts.transfer_bound.loads);
  json.key("transfer_bound_reason").value(facts.transfer_bound.reason);
  if (item_bytes) {
    json.key("item_bytes").value(*item_bytes);
    json.key("bytes_loaded").value(checked_multiply(facts.loads, *item_bytes));
    json.key("bytes_transferred").value(checked_multiply(facts.transfers, *item_bytes));
  }
  if (facts.group_items > 0) {
    json.key("group_items").value(facts.group_items);
  }
  json.key("explanation").value(facts.explanation);
  json.key("verified").value(facts.certificate).end_object();
  StepWriter writer(out, format, nullptr);
  writer.begin(
      json.take(),
      fmt::format(
          "{}, room for {} in memory and {} of them on the accelerator: {}\n"
          "from the disk: {}\nto the accelerator: {}\n{}\n"
          "bound of the loads: {}\nbound of the transfers: {}\nverified: {}\n"
          "each step: fast evict, evict, load, fast load, compute\n",
          count_of(facts.items, "item"), facts.room, facts.fast_room, count_of(facts.steps, "step"),
          level(facts.loads, "load", facts.load_bound, item_bytes),
          level(facts.transfers, "transfer", facts.transfer_bound, item_bytes), facts.explanation,
          facts.load_bound.reason, facts.transfer_bound.reason, facts.certificate),
      std::string("step,fast_evict,evict,load,fast_load") + (new_pairs ? ",new_pairs" : ""));
  TwoLevelStep step;
  for (const auto steps = order.stream(); steps->next(step);) {
    writer.write(step, new_pairs);
  }
  writer.end();
}

}  // namespace changeover::cli
