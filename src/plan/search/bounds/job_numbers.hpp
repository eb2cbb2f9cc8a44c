// The numbers of a job that its cost bound needs, named as in docs/theorems.md, Theorem 23.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover {

struct JobNumbers {
  std::uint64_t room = 0;             // K
  std::uint64_t pairs = 0;            // P
  std::vector<Element> parts;         // F
  std::vector<std::uint64_t> degree;  // by part: number of needed pairs
  std::vector<std::uint64_t> inner;   // by part: number of needed pairs within F
  std::vector<bool> at_start;         // by part: whether it is there at the start
  std::uint64_t start = 0;            // |S| or more: parts without a needed pair count
  std::uint64_t start_pairs = 0;      // needed pairs within S
  Amount mounting;                    // cost of the parts that stay mounted
  std::uint64_t mounted_introductions = 0;
  std::vector<std::uint32_t> slot_of;  // by part; slots.size() for none
  std::vector<std::uint64_t>
      most;                 // by slot, the last one for no slot: most parts of F in a set-up
  std::uint64_t first = 0;  // e of (8)
};

/// Linear in the needed pairs, and quadratic in the parts for slots and forbidden pairs.
[[nodiscard]] JobNumbers numbers_of(const Job& job);

/// The most that `tests` steps with `introductions` introductions bring together: a first step with
/// j of them brings first(j), any other brought(j), which is concave, so those after the first are
/// as equal as possible.
template <typename First, typename Brought>
[[nodiscard]] std::uint64_t most_by_steps(std::uint64_t room, std::uint64_t tests,
                                          std::uint64_t introductions, First&& first,
                                          Brought&& brought) {
  std::uint64_t most = 0;
  for (std::uint64_t j = 0; j <= std::min(room, introductions); ++j) {
    std::uint64_t sum = first(j);
    if (tests > 1) {
      const std::uint64_t rest = std::min(introductions - j, room * (tests - 1));
      const std::uint64_t each = rest / (tests - 1);
      const std::uint64_t more = rest % (tests - 1);
      sum += (tests - 1 - more) * brought(each) + (more == 0 ? 0 : more * brought(each + 1));
    }
    most = std::max(most, sum);
  }
  return most;
}

/// (1): the most pairs that `tests` steps with `introductions` introductions cover.
[[nodiscard]] std::uint64_t most_pairs(const JobNumbers& n, std::uint64_t tests,
                                       std::uint64_t introductions);

/// What divides all costs of a job, in millionths; 0 if all are 0.
[[nodiscard]] std::uint64_t unit_of_costs(const Job& job);

/// The cost rounded up to a multiple of what divides all costs: every list costs one.
[[nodiscard]] Amount rounded_up(const Job& job, Amount cost);

}  // namespace changeover
