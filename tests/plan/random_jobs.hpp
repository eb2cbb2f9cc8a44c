// Jobs of all sorts, small and without defects.
#pragma once

#include "changeover/plan/job.hpp"
#include "run/random.hpp"

namespace changeover::test {

/// A job of up to `most` parts with whatever constraints the numbers say. Always the same for a
/// seed.
inline Job random_job(std::uint64_t seed, std::uint32_t most, bool constraints = true) {
  for (std::uint64_t stream = 0;; ++stream) {
    Random random(seed, stream);
    const std::uint32_t v = 3 + random.below(most - 2);
    const std::uint32_t k = 2 + random.below(v - 2);
    Job job = make_job(v, k, Amount{random.below(6) * 1'000'000ULL}, Amount{});
    const bool one_cost = random.one_in_two();
    for (Amount& cost : job.change_costs) {
      cost = one_cost ? Amount{(1 + seed % 5) * 500'000} : Amount{random.below(9) * 750'000ULL};
    }
    if (constraints) {
      if (random.one_in_two()) {  // forbidden pairs
        for (std::uint32_t i = random.below(3); i > 0; --i) {
          const std::uint32_t x = random.below(v);
          const std::uint32_t y = random.below(v);
          if (x != y) {
            job.never.insert(x, y);
          }
        }
        job.needed = all_pairs_but(job.never);
      }
      if (random.one_in_two()) {  // only some pairs
        PairSet some(v);
        job.needed.for_each(1000, [&](Element x, Element y) {
          if (random.below(3) > 0) {
            some.insert(x, y);
          }
        });
        job.needed = some;
      }
      for (Element x = 0; x < v; ++x) {
        if (random.below(6) == 0) {
          job.mounted.push_back(x);
        }
        if (random.below(4) == 0 && job.start.size() < k) {
          job.start.push_back(x);
        }
      }
    }
    if (defects(job).empty()) {
      return job;
    }
  }
}

/// The same with slots, some of which need parts and some of which hold few.
inline Job random_job_with_slots(std::uint64_t seed, std::uint32_t most) {
  for (std::uint64_t turn = 0;; ++turn) {
    Job job = random_job(seed + 1'000'000 * turn, most, turn % 2 == 0);
    Random random(seed, 77 + turn);
    const std::uint32_t slots = 1 + random.below(3);
    for (std::uint32_t s = 0; s < slots; ++s) {
      const std::uint64_t least = random.below(2);
      job.slots.push_back({"s" + std::to_string(s), least, least + 1 + random.below(2)});
    }
    for (Element x = 0; x < job.parts(); ++x) {
      const std::uint32_t slot = random.below(slots + 1);
      job.slot_of.push_back(slot == slots ? no_slot : slot);
    }
    if (random.below(3) > 0) {
      job.slots.front().most = std::max<std::uint64_t>(1, job.slots.front().least);
    }
    drop_needed(job, cannot_meet(job));
    if (defects(job).empty() && job.needed.size() > 0) {
      return job;
    }
  }
}

}  // namespace changeover::test
