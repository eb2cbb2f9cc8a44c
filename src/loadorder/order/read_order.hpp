// Internal: verifies an order before it is returned.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

/// Longer orders are not read, since that would take longer than a minute.
inline constexpr std::uint64_t most_loads_read = 200'000'000;

/// Checks that all pairs meet; for few items also that StepWork computes each pair once, which
/// takes most of the time. `compute` leaves that out, as for orders whose pairs are checked when
/// they are written. @throws InternalError if the steps are wrong; `what` names the order.
[[nodiscard]] ScheduleVerdict read_order(const LoadOrder::Maker& maker, ScheduleRules rules,
                                         const std::string& what, bool compute = true);

/// What is known before there is an order: the pairs, both rooms and the bounds of one worker.
/// @throws BadInput if the accelerator has more room than memory
[[nodiscard]] LoadOrderFacts facts_before(const WantedPairs& wanted, std::uint64_t room,
                                          std::optional<std::uint64_t> fast_room = {});

/// The order that `maker` makes, once it has been read as read_order() does; `certificate` says
/// what was seen, `memory` what the order is for. @throws InternalError also if fewer bytes move
/// than the bounds in `facts` say
[[nodiscard]] LoadOrder read_in_full(
    LoadOrderFacts facts, LoadOrder::Maker maker, const std::string& memory,
    const std::function<std::string(const ScheduleVerdict&)>& certificate);

/// "all 6 pairs met", "the pair met"; of none "no pair is wanted".
[[nodiscard]] std::string all_met(std::uint64_t pairs, std::string_view one = "pair");

/// What such a verdict says of all pairs: "6 pairs computed on the accelerator, each once".
[[nodiscard]] std::string pairs_read(const ScheduleVerdict& verdict, std::uint64_t all,
                                     const std::string& where = "");

/// The certificate of two levels, whose room is counted in items or in bytes.
[[nodiscard]] std::string levels_read(const ScheduleVerdict& verdict, std::uint64_t all,
                                      bool by_bytes);

}  // namespace changeover
