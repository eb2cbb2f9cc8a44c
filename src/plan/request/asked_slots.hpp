// The slots of a request, and how many parts they hold together.
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/plan/job.hpp"
#include "plan/request/question.hpp"

namespace changeover {

/// The slots with their limits, of whichever key gives them; none if neither does. @throws as
/// read_slots() and parse_slots()
[[nodiscard]] std::vector<Slot> slots_asked(const Question& question);

/// The most parts that the slots of a job hold together; a slot without a limit holds all of its
/// parts. @throws BadOption, BadInput that at_once is missing if there are no slots, or if a part
/// is in none.
[[nodiscard]] std::uint64_t room_of_slots(const Job& job, const Question& question);

}  // namespace changeover
