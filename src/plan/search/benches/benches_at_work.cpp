#include "plan/search/benches/benches_at_work.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/words.hpp"

namespace changeover {

BenchesAtWork most_at_a_time(const BenchField& field, const Job& easiest) {
  BenchesAtWork at_work{field.size(), {}};
  for (const Element m : easiest.mounted) {
    if (const std::uint64_t holders = std::max<std::uint64_t>(field.most_holders(m), 1);
        holders < at_work.most) {
      at_work = {holders,
                 fmt::format("only {} can have {} at a time, which stays mounted",
                             count_of(holders, "bench", "benches"), field.asked().names[m])};
    }
  }
  for (std::uint32_t s = 0; s < easiest.slots.size(); ++s) {
    const Slot& slot = easiest.slots[s];
    const auto there = [&](std::uint64_t benches) {
      std::uint64_t pieces = 0;
      for (Element x = 0; x < easiest.parts(); ++x) {
        pieces += easiest.slot_of[x] == s ? std::min(field.most_holders(x), benches) : 0;
      }
      return pieces;
    };
    std::uint64_t most = at_work.most;
    while (most > 1 && there(most) < most * slot.least) {
      --most;
    }
    if (most < at_work.most) {
      at_work = {most, fmt::format("only {} can work at a time: slot {} needs {} on each, no two "
                                   "alike, and {} could have only {}",
                                   count_of(most, "bench", "benches"), slot.name,
                                   count_of(slot.least, "part"),
                                   count_of(most + 1, "bench", "benches"), there(most + 1))};
    }
  }
  return at_work;
}

}  // namespace changeover
