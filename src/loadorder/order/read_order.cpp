#include "loadorder/order/read_order.hpp"

#include <fmt/format.h>

#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"

namespace changeover {

ScheduleVerdict read_order(const LoadOrder::Maker& maker, ScheduleRules rules,
                           const std::string& what, bool compute) {
  constexpr std::uint64_t most_pairs = 30'000'000;
  std::unique_ptr<StepSource> steps = maker();
  if (compute &&
      checked_multiply(rules.wanted.among(rules.items).count(), rules.epochs) <= most_pairs) {
    rules.compute = ComputeRules{};
    steps = std::make_unique<StepWork>(std::move(steps), rules);
  }
  ScheduleVerdict verdict = check_schedule(*steps, rules);
  if (!verdict.valid()) {
    throw InternalError(fmt::format("the order of {} is wrong: {}{} {} missing", what,
                                    verdict.fault, verdict.example,
                                    count_of(verdict.missing, "pair")));
  }
  return verdict;
}

LoadOrderFacts facts_before(const WantedPairs& wanted, std::uint64_t room,
                            std::optional<std::uint64_t> fast_room) {
  LoadOrderFacts facts;
  facts.items = wanted.items();
  facts.room = room;
  facts.fast_room = fast_room;
  facts.wanted = wanted.are_all() ? WantedPairs() : wanted;
  facts.bound = load_lower_bound(wanted, room);
  if (fast_room) {
    facts.transfer_bound = load_lower_bound(wanted, *fast_room);
    if (*fast_room > room) {
      throw BadInput(fmt::format(
          "the accelerator has room for {} items, but memory only for {}; give less, or one level",
          *fast_room, room));
    }
  }
  return facts;
}

LoadOrder read_in_full(LoadOrderFacts facts, LoadOrder::Maker maker, const std::string& memory,
                       const std::function<std::string(const ScheduleVerdict&)>& certificate) {
  const std::string pairs =
      facts.wanted.are_all() ? count_of(facts.items, "item") : facts.wanted.describe();
  const std::string what = fmt::format("{} {}", pairs, memory);
  const ScheduleVerdict verdict = read_order(maker, LoadOrder(facts, maker).rules(), what);
  static_cast<ScheduleFacts&>(facts) = static_cast<const ScheduleFacts&>(verdict);
  if (facts.bytes < facts.byte_bound.loads || facts.span_bytes < facts.makespan_byte_bound.loads ||
      facts.transfer_bytes < facts.transfer_byte_bound.loads) {
    throw InternalError(fmt::format("the order of {} moves fewer bytes than its bound", what));
  }
  facts.every_step_read = true;
  facts.certificate = certificate(verdict);
  return {std::move(facts), std::move(maker)};
}

std::string all_met(std::uint64_t pairs, std::string_view one) {
  return pairs == 0 ? "no pair is wanted" : all_of(pairs, one) + " met";
}

std::string pairs_read(const ScheduleVerdict& verdict, std::uint64_t all,
                       const std::string& where) {
  return verdict.computed == all && all > 0
             ? fmt::format("{} computed{}, each once", count_of(all, "pair"), where)
             : all_met(all) + where;
}

std::string levels_read(const ScheduleVerdict& verdict, std::uint64_t all, bool by_bytes) {
  return fmt::format("every step read: {} at both levels, {}", by_bytes ? "bytes" : "room",
                     pairs_read(verdict, all, " on the accelerator"));
}

}  // namespace changeover
