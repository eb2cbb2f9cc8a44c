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

std::string pairs_read(const ScheduleVerdict& verdict, std::uint64_t all,
                       const std::string& where) {
  const std::string pairs = count_of(all, "pair");
  return verdict.computed == all ? fmt::format("{} computed{}, each once", pairs, where)
                                 : fmt::format("all {} met{}", pairs, where);
}

std::string levels_read(const ScheduleVerdict& verdict, std::uint64_t all, bool by_bytes) {
  return fmt::format("every step read: {} at both levels, {}", by_bytes ? "bytes" : "room",
                     pairs_read(verdict, all, " on the accelerator"));
}

}  // namespace changeover
