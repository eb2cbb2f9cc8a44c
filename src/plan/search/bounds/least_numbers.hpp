// Numbers that something is at least, and why: how many tests and introductions a job needs, by the
// proof at cost_bound().
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plan/search/bounds/job_numbers.hpp"
#include "plan/search/bounds/stays_cost.hpp"

namespace changeover {

/// The largest lower bound so far, with its reason; the first of equals.
struct LeastNumber {
  std::uint64_t number = 0;
  std::string why;

  void at_least(std::uint64_t other, const std::string& reason) {
    if (other > number) {
      number = other;
      why = reason;
    }
  }
};

/// (5): the least that so many introductions of parts of F can cost.
class IntroductionCosts {
 public:
  IntroductionCosts(const Job& job, const JobNumbers& n) {
    std::vector<Element> by_cost = n.parts;
    std::stable_sort(by_cost.begin(), by_cost.end(), [&](Element x, Element y) {
      return job.change_costs[x] < job.change_costs[y];
    });
    for (const Element x : by_cost) {
      const std::uint32_t slot = n.slot_of[x];
      constexpr std::uint64_t any_number = std::uint64_t{1} << 40U;
      std::uint64_t spare =
          slot < job.slots.size() && job.slots[slot].least > 0 ? any_number : n.degree[x];
      if (!n.at_start[x]) {
        ++once_;
        base_ += job.change_costs[x];
        --spare;
      }
      extra_.push_back({job.change_costs[x], spare});
    }
  }

  [[nodiscard]] std::uint64_t once() const { return once_; }

  /// nullopt if the limits do not allow so many.
  [[nodiscard]] std::optional<Amount> operator()(std::uint64_t introductions) const {
    Amount cost = base_;
    std::uint64_t left = introductions - std::min(introductions, once_);
    for (const Extra& extra : extra_) {
      const std::uint64_t taken = std::min(left, extra.spare);
      cost += extra.cost * taken;
      left -= taken;
      if (left == 0) {
        return cost;
      }
    }
    return left == 0 ? std::optional(cost) : std::nullopt;
  }

 private:
  struct Extra {
    Amount cost;
    std::uint64_t spare = 0;
  };
  std::uint64_t once_ = 0;
  Amount base_;
  std::vector<Extra> extra_;
};

/// (7): parts of which every two must meet, chosen greedily, those with most pairs first.
[[nodiscard]] std::vector<Element> all_meeting(const Job& job, const JobNumbers& n);

/// (7): of all introductions of parts of F.
[[nodiscard]] StaysCost least_by_stays(const Job& job, const JobNumbers& n);

[[nodiscard]] LeastNumber least_tests(const Job& job, const JobNumbers& n);

/// The least number of introductions of parts of F, of which so many come in any case; `by_stays`
/// is the number of (7).
[[nodiscard]] LeastNumber least_introductions(const JobNumbers& n, std::uint64_t once,
                                              std::uint64_t by_stays);

}  // namespace changeover
