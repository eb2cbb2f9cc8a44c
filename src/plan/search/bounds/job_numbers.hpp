// The numbers of a job from which its cost bound is computed: those of the proof at cost_bound().
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover {

struct JobNumbers {
  std::uint64_t room = 0;             // K
  std::uint64_t pairs = 0;            // P
  std::vector<Element> parts;         // of F with a needed pair
  std::vector<std::uint64_t> degree;  // by part: all needed pairs
  std::vector<std::uint64_t> inner;   // by part: needed pairs within F
  std::vector<bool> at_start;         // by part: in S
  std::uint64_t start = 0;            // |S|
  std::uint64_t start_pairs = 0;      // needed pairs within S
  Amount mounting;                    // of the parts that stay mounted
  std::uint64_t mounted_introductions = 0;
  std::vector<std::uint32_t> slot_of;  // by part; slots.size() if it has none
  std::vector<std::uint64_t>
      most;                 // by slot, the last for no slot: parts of F that a set-up holds at most
  std::uint64_t first = 0;  // e of (8)
};

/// Linear in the needed pairs, and quadratic in the parts for what slots and forbidden pairs allow.
[[nodiscard]] JobNumbers numbers_of(const Job& job);

/// (1): the most pairs that `tests` steps with `introductions` cover.
[[nodiscard]] std::uint64_t most_pairs(const JobNumbers& n, std::uint64_t tests,
                                       std::uint64_t introductions);

/// The cost rounded up to a multiple of what divides all costs: every list costs one.
[[nodiscard]] Amount rounded_up(const Job& job, Amount cost);

}  // namespace changeover
