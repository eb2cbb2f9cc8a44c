// Shared by the annealing of plans: temperature, penalty, and the differences between attempts.
//
// If the penalty for what has not met is fixed, the temperature falls with the third power of the
// remaining part. Otherwise both are measured by the cost of a pair (or triple) that has met in the
// current lists, so one schedule suits all jobs. The temperature falls geometrically; in the second
// half the penalty rises whenever more is open than planned for this moment, which is nothing at
// the end.
#pragma once

#include <array>
#include <cstdint>

#include "run/portable_math.hpp"
#include "run/random.hpp"

namespace changeover {

class Cooling {
 public:
  /// A fixed penalty, and temperatures in the same unit; or no penalty, and temperatures in about
  /// three times the cost of a pair that has met.
  Cooling(double hot, double cold, double fixed_penalty);

  /// What has to meet, what has not met yet, and the cost per pair that has met.
  struct Measured {
    double needed = 0;
    double open = 0;
    double a_thing = 0;
  };
  /// Sets temperature and penalty for the moment when the part `done` of the schedule, from 0 to 1,
  /// is over.
  void cool(double done, const Measured& now);

  /// The penalty for one pair that has not met.
  [[nodiscard]] double penalty() const { return penalty_; }

  /// Whether to make a move that is this much worse.
  [[nodiscard]] bool accepts(double rise, Random& random) const {
    return rise <= 0 || rise <= most_rise(random);
  }
  /// How much worse a move may be.
  [[nodiscard]] double most_rise(Random& random) const {
    return temperature_ * log_table()[random.next() >> 52];
  }

 private:
  double hot_;
  double cold_;
  bool fixed_;
  double penalty_;
  double octaves_;  // between the first and the last temperature
  double temperature_ = 0;
  double done_ = 0;
  double raise_ = 1;
};

/// The part of a schedule that is over after these steps and this part of its time. As long as
/// possible only steps count: then the result is reproducible.
[[nodiscard]] double share_done(std::uint64_t step, std::uint64_t steps, double time_gone);

/// The temperatures of different attempts. Hot ones forget where they started; the warm one does
/// not.
struct HeatStyle {
  double hot;
  double cold;
};
inline constexpr std::array<HeatStyle, 4> heat_styles{
    {{0.8, 0.03}, {0.4, 0.05}, {0.6, 0.03}, {0.5, 0.04}}};
inline constexpr HeatStyle warm_style{0.16, 0.03};

}  // namespace changeover
