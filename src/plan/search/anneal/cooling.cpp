#include "plan/search/anneal/cooling.hpp"

#include <algorithm>
#include <cmath>

namespace changeover {

Cooling::Cooling(double hot, double cold, double fixed_penalty)
    : hot_(hot), cold_(cold), fixed_(fixed_penalty > 0), penalty_(fixed_penalty) {
  constexpr double parts = 1024;
  octaves_ = std::round(natural_log(hot / cold) / natural_log(2) * parts) / parts;
}

void Cooling::cool(double done, const Measured& now) {
  if (fixed_) {
    const double left = 1.0 - done;
    temperature_ = cold_ + (hot_ - cold_) * left * left * left;
    return;
  }
  constexpr double at_first = 2.0;  // initially, until the lists have this temperature
  constexpr double later = 2.8;
  constexpr double moment = 0.05;
  const double base = now.a_thing * (done < moment ? at_first : later);
  temperature_ = hot_ * base * two_to_minus(octaves_ * done);
  // In the second part, this much may be open.
  constexpr double second = 0.5;
  constexpr double speed = 5.0;
  constexpr double none_from = 0.9;
  const double left = std::max(0.0, none_from - done);
  const double allowed = 0.1 * now.needed * left * left;
  if (done > second) {
    const double excess = (now.open - allowed) / (now.open + allowed + 1.0);
    raise_ *= 1.0 + std::clamp(speed * (done - done_) * excess, -0.5, 0.5);
  }
  raise_ = std::max(1.0, raise_);
  penalty_ = base * raise_;
  done_ = done;
}

double share_done(std::uint64_t step, std::uint64_t steps, double time_gone) {
  const double share = static_cast<double>(step) / static_cast<double>(steps);
  constexpr double early = 0.1;
  return std::min(1.0, time_gone < early ? share : std::max(time_gone, share));
}

}  // namespace changeover
