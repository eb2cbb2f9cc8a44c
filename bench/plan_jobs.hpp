// Jobs for comparisons of run sheets: parts that differ in price, all pairs, always the same for a
// seed.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "changeover/plan/job.hpp"
#include "run/random.hpp"

namespace changeover::bench {

/// While this is true, the library's clock is the processor time of this program (plan_bench.cpp).
extern std::atomic<bool> clock_of_processor;

/// The change costs are multiples of 0.50 from 0.50 to 9.50, each as likely.
inline Job priced_job(std::uint64_t parts, std::uint64_t at_once, const std::string& test_cost,
                      std::uint64_t seed) {
  Job job = make_job(parts, at_once, parse_amount(test_cost), Amount{});
  Random random(seed, parts);
  for (Amount& cost : job.change_costs) {
    cost = Amount{(1 + random.below(19)) * 500'000ULL};
  }
  return job;
}

/// 8 to 40 parts in 2 to 6 slots; half of the jobs have room for one part of each slot, as with
/// parameters, the others for up to four. The change costs are one for all, multiples of 0.50 to
/// 9.50, or a few expensive ones; half of the jobs have forbidden pairs; a test costs 0.2 to 20
/// times
/// what a change does.
inline Job slotted_job(std::uint64_t seed) {
  for (std::uint64_t turn = 0;; ++turn) {
    Random random(seed, 1000 + turn);
    const std::uint32_t slots = 2 + random.below(5);
    const std::uint32_t parts = std::max(2 * slots, 8 + random.below(33));
    Job job = make_job(parts, parts, Amount{}, Amount{});
    const std::uint32_t profile = random.below(3);
    const bool one_each = random.one_in_two();
    for (std::uint32_t s = 0; s < slots; ++s) {
      const std::uint64_t most = one_each ? 1 : 1 + random.below(4);
      const std::uint64_t least =
          random.below(5) < 3 ? most : random.below(static_cast<std::uint32_t>(most) + 1);
      job.slots.push_back({"S" + std::to_string(s), least, most});
    }
    job.at_once = 0;
    for (const Slot& slot : job.slots) {
      job.at_once += slot.most;
    }
    std::uint64_t all = 0;
    for (Element x = 0; x < parts; ++x) {
      job.slot_of.push_back(x < slots ? x : random.below(slots));
      const std::uint64_t halves = profile == 0   ? 2
                                   : profile == 1 ? 1 + random.below(19)
                                                  : (random.below(4) == 0 ? 20 : 2);
      job.change_costs[x] = Amount{halves * 500'000};
      all += halves * 500'000;
    }
    constexpr std::uint64_t fifths[] = {1, 5, 10, 25, 100};
    job.test_cost = Amount{all / parts * fifths[random.below(5)] / 5 / 100'000 * 100'000};
    for (std::uint32_t i = random.one_in_two() ? random.below(parts) : 0; i > 0; --i) {
      const Element x = random.below(parts);
      const Element y = random.below(parts);
      if (job.slot_of[x] != job.slot_of[y]) {
        job.never.insert(x, y);
      }
    }
    job.needed = all_pairs_but(job.never);
    drop_needed(job, cannot_meet(job));
    if (defects(job).empty() && job.needed.size() > 0) {
      return job;
    }
  }
}

/// A job for two to four benches with less of some parts than there are benches, of 10 to 50 parts:
/// every third with slots, half of the others with forbidden pairs. No search was tuned for these.
struct HeldOutJob {
  Job job;
  std::uint32_t benches = 2;
  std::size_t scarce = 0;  ///< so many parts are scarce
};

inline HeldOutJob held_out_job(std::uint64_t seed) {
  Random random(seed, 20'000);
  HeldOutJob made;
  if (seed % 3 == 0) {
    made.job = slotted_job(500 + seed);
  } else {
    const std::uint64_t parts = 10 + random.below(41);
    const std::uint64_t room = 3 + random.below(static_cast<std::uint32_t>(parts / 8 + 2));
    constexpr const char* tests[] = {"0.5", "2", "6", "15", "50"};
    made.job = priced_job(parts, room, tests[random.below(5)], 500 + seed);
    for (std::uint64_t i = random.one_in_two() ? parts / 2 : 0; i > 0; --i) {
      const Element x = random.below(static_cast<std::uint32_t>(parts));
      const Element y = random.below(static_cast<std::uint32_t>(parts));
      if (x != y) {
        made.job.never.insert(x, y);
      }
    }
    made.job.needed = all_pairs_but(made.job.never);
  }
  made.benches = 2 + random.below(3);
  const std::uint32_t share = 1 + random.below(6);  // of ten parts
  for (std::uint64_t x = 0; x < made.job.parts(); ++x) {
    const bool scarce = random.below(10) < share;
    made.job.quantities.push_back(scarce ? 1 + random.below(made.benches - 1) : enough_for_all);
    made.scarce += scarce ? 1 : 0;
  }
  return made;
}

}  // namespace changeover::bench
