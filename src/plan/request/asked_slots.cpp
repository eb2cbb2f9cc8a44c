#include "plan/request/asked_slots.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace changeover {

std::vector<Slot> slots_asked(const Question& question) {
  if (question->slots.is_given()) {
    return read_slots(*question.open("slots", question->slots));
  }
  return question->slot.empty()
             ? std::vector<Slot>()
             : question.value_of("slot", [&] { return parse_slots(question->slot); });
}

std::uint64_t room_of_slots(const Job& job, const Question& question) {
  const std::string give =
      fmt::format("give {}, how many parts fit at once", question.with_value("at_once"));
  if (job.slots.empty()) {
    question.refuse("at_once", give);
  }
  std::uint64_t room = 0;
  for (std::size_t s = 0; s < job.slots.size(); ++s) {
    const auto members =
        static_cast<std::uint64_t>(std::ranges::count(job.slot_of, std::uint32_t(s)));
    room += std::min(job.slots[s].most, members);
  }
  const auto free = std::ranges::find(job.slot_of, no_slot);
  if (free != job.slot_of.end()) {
    question.refuse("at_once", fmt::format("{}: {} is in no slot", give,
                                           job.names[std::size_t(free - job.slot_of.begin())]));
  }
  return room;
}

}  // namespace changeover
