// Simulated annealing [KirkpatrickGelattVecchi1983] over any state of segment_swap.hpp.
//
//     SegmentPairs<std::uint8_t> state(design);
//     AnnealOutcome outcome = anneal(state, {.moves = 50'000'000}, random, control);
//     outcome.missing;                      // 0: the state is a design now
//
// Half of the moves are aimed at something uncovered. A move that leaves `change` more uncovered is
// accepted with probability exp(−change/T), and T falls geometrically from `hot` to `cold`, in
// units of what missing() counts: for segment swaps one long run is worth more than many short
// ones. At T = 0.38 one move in 14 that uncovers one more is accepted, at 0.15 one in 800.
//
// The same state, schedule and random numbers give the same moves everywhere: the probabilities
// come from additions, products and square roots in a fixed order, not from the mathematics
// library.
#pragma once

#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>

#include "changeover/run/control.hpp"
#include "run/random.hpp"
#include "search/local/segment_swap.hpp"

namespace changeover {

/// How long and how hot.
struct AnnealSchedule {
  std::uint64_t moves = 0;  ///< proposals, at most
  double hot = 0.38;
  double cold = 0.15;
};

struct AnnealOutcome {
  std::uint64_t moves = 0;     ///< proposals made
  std::uint64_t accepted = 0;  ///< of them
  std::uint64_t missing = 0;   ///< in the state as it is left
  std::uint64_t least = 0;     ///< of missing() on the way
  bool stopped = false;        ///< by the control or the watch, before the schedule was through
};

/// exp(−change/T) for change = 0, 1, …, as thresholds for 32 random bits.
class AcceptanceTable {
 public:
  /// For a temperature above 0, in units of missing().
  explicit AcceptanceTable(double temperature) {
    // exp(−1/T) by its series at a small argument, then squared up again.
    constexpr int halvings = 12;
    const double small = -1.0 / temperature / (1 << halvings);
    double one = 1.0 + small * (1.0 + small / 2.0 * (1.0 + small / 3.0));
    for (int i = 0; i < halvings; ++i) {
      one *= one;
    }
    double probability = 1.0;
    for (std::uint32_t& threshold : thresholds_) {
      threshold = static_cast<std::uint32_t>(probability * 4294967295.0);
      probability *= one;
    }
  }

  /// Whether to accept; draws only if `change` > 0.
  [[nodiscard]] bool accepts(std::int32_t change, Random& random) const {
    return change <= 0 || (static_cast<std::size_t>(change) < thresholds_.size() &&
                           random.next32() < thresholds_[static_cast<std::size_t>(change)]);
  }

 private:
  std::array<std::uint32_t, 16> thresholds_{};
};

/// How often control and watch are asked, at least; more often where moves are slow.
inline constexpr std::uint64_t anneal_moves_between_questions = 2048;

/// How many moves may pass before the next question: twice as many as before if they took no time
/// to speak of, for a move may cost 50 ns or, with long blocks and strength 4, a second. Asking
/// changes no move.
class QuestionPace {
 public:
  [[nodiscard]] std::uint64_t next() {
    const auto now = RunControl::Clock::now();
    constexpr std::chrono::microseconds quick{200};
    if (now - last_ < quick) {
      moves_ = moves_ < anneal_moves_between_questions ? 2 * moves_ : moves_;
    } else if (now - last_ > 10 * quick) {
      moves_ = 1;
    }
    last_ = now;
    return moves_;
  }

 private:
  std::uint64_t moves_ = 1;
  RunControl::Clock::time_point last_ = RunControl::Clock::now();
};

/// Asked now and then with the moves so far and what is uncovered; false stops.
using AnnealWatch = std::function<bool(std::uint64_t moves, std::uint64_t missing)>;

/// Tells the control what `progress` says, with the moves besides those in it and what is missing
/// now.
[[nodiscard]] inline AnnealWatch telling(RunControl& control, Progress progress) {
  return [&control, progress = std::move(progress)](std::uint64_t moves, std::uint64_t missing) {
    if (control.progress_due()) {
      Progress now = progress;
      now.steps += moves;
      now.missing = missing;
      control.tell(std::move(now));
    }
    return true;
  };
}

/// Anneals until nothing is missing, the schedule is through, or control or watch say stop; both
/// are asked every anneal_moves_between_questions moves, or more often. O(moves · cost of a move).
template <typename State>
AnnealOutcome anneal(State& state, const AnnealSchedule& schedule, Random& random,
                     RunControl& control, const AnnealWatch& watch = {}) {
  constexpr int halvings = 10;  // 1024 temperatures
  constexpr std::uint64_t levels = 1 << halvings;
  double ratio = schedule.cold / schedule.hot;
  for (int i = 0; i < halvings; ++i) {
    ratio = std::sqrt(ratio);
  }
  AnnealOutcome outcome;
  outcome.missing = outcome.least = state.missing();
  double temperature = schedule.hot;
  QuestionPace pace;
  std::uint64_t question = 1;
  for (std::uint64_t level = 0; level < levels && outcome.missing > 0; ++level) {
    const AcceptanceTable table(temperature);
    const std::uint64_t end =
        schedule.moves / levels * (level + 1) + schedule.moves % levels * (level + 1) / levels;
    while (outcome.moves < end && outcome.missing > 0) {
      ++outcome.moves;
      const SegmentSwap move =
          random.one_in_two() ? state.propose(random) : state.propose_aimed(random);
      if (move.length > 0 &&
          state.attempt(move, [&](std::int32_t change) { return table.accepts(change, random); })) {
        ++outcome.accepted;
        outcome.missing = state.missing();
        outcome.least = outcome.missing < outcome.least ? outcome.missing : outcome.least;
      }
      if (outcome.moves >= question) {
        question += pace.next();
        if (outcome.missing > 0 &&
            (control.stop_wanted() || (watch && !watch(outcome.moves, outcome.missing)))) {
          outcome.stopped = true;
          return outcome;
        }
      }
    }
    temperature *= ratio;
  }
  return outcome;
}

}  // namespace changeover
