// Jobs for comparisons of run sheets: parts that differ in price, all pairs, always the same for a seed.
#pragma once

#include <cstdint>
#include <string>

#include "changeover/plan/job.hpp"
#include "run/random.hpp"

namespace changeover::bench {

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

}  // namespace changeover::bench
