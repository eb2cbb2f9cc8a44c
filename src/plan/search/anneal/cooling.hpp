// What annealings of plans share: how temperature and penalty change, and how attempts differ.
//
// Where the penalty of what has not met is fixed, the temperature falls with the third power of
// what is left. Else both are measured by what a thing that has met costs in the lists as they are
// now, so one schedule suits all jobs: the temperature falls geometrically; in the second half the
// penalty rises whenever more is open than the schedule has for this moment, nothing in the end.
#pragma once

#include <array>
#include <cstdint>

#include "run/portable_math.hpp"
#include "run/random.hpp"

namespace changeover {

class Cooling {
 public:
  /// A fixed penalty and temperatures in one unit; or no penalty, and temperatures in about three
  /// times what a thing that has met costs.
  Cooling(double hot, double cold, double fixed_penalty);

  /// What has to meet, what of it has not, and what a thing that has met costs.
  struct Measured {
    double needed = 0;
    double open = 0;
    double a_thing = 0;
  };
  /// Sets temperature and penalty for the moment when so much is done, from 0 to 1.
  void cool(double done, const Measured& now);

  /// Of one thing that has not met.
  [[nodiscard]] double penalty() const { return penalty_; }

  /// Whether a move that makes this much worse is to be made.
  [[nodiscard]] bool accepts(double rise, Random& random) const {
    return rise <= 0 || rise <= temperature_ * log_table()[random.next() >> 52];
  }

 private:
  double hot_;
  double cold_;
  bool fixed_;
  double penalty_;
  double octaves_;  // between the first temperature and the last
  double temperature_ = 0;
  double done_ = 0;
  double raise_ = 1;
};

/// How much of a schedule is done after these of its steps and this share of its time. Steps alone
/// decide as long as they may do: then the result is the same again.
[[nodiscard]] double share_done(std::uint64_t step, std::uint64_t steps, double time_gone);

/// How attempts differ in their temperatures. Hot ones forget where they started; the warm one does
/// not.
struct HeatStyle {
  double hot;
  double cold;
};
inline constexpr std::array<HeatStyle, 4> heat_styles{
    {{0.8, 0.03}, {0.4, 0.05}, {0.6, 0.03}, {0.5, 0.04}}};
inline constexpr HeatStyle warm_style{0.16, 0.03};

}  // namespace changeover
