// Which parameters can help to a design with few blocks, by the rules that the planner applies: backwards
// from what is wanted to what a rule could make it from, as far as lower bounds allow.
#pragma once

#include <cstdint>
#include <map>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/planner.hpp"
#include "changeover/core/parameters.hpp"

namespace changeover {

/// Parameters, and the most blocks of a design with them that helps.
using Needs = std::map<Parameters, std::uint64_t>;

/// The goals and all that can help to reach them with the same change number, within `limits`: cut, fix, unfix,
/// truncate, close up and partial expansion. What a rule saves by dropping blocks after a cut, and what close up
/// saves, is allowed for generously and not proved.
[[nodiscard]] Needs spread(const Needs& goals, const PlanRange& limits);

/// A cover by as few of the available positions as there can be, all of them 0: no design's cover costs less.
[[nodiscard]] CoverPositions smallest_cover(const Parameters& p, std::uint64_t available);

/// `limits`, narrowed to these parameters.
[[nodiscard]] PlanRange narrowed(PlanRange limits, Needs needs);

}  // namespace changeover
