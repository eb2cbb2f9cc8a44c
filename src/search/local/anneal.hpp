// Simulated annealing [KirkpatrickGelattVecchi1983] over any state of segment_swap.hpp.
//
//     SegmentPairs<std::uint8_t> state(design);
//     AnnealOutcome outcome = anneal(state, {.moves = 50'000'000}, random, control);
//     outcome.missing;                      // 0: the state is a design now
//
// Half of the moves are aimed at something uncovered. A move that uncovers `change` more is
// accepted with probability exp(−change/T). T falls geometrically from `hot` to `cold`, in units of
// missing(). For segment swaps one long run is better than many short ones. At T = 0.32 one move in
// 23 that uncovers one more is accepted, at 0.18 one in 260.
//
// The same state, schedule and random numbers give the same moves on every machine: probabilities
// are computed by additions, products and square roots in a fixed order, without the mathematics
// library.
#pragma once

#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

#include "changeover/run/control.hpp"
#include "run/random.hpp"
#include "search/local/segment_swap.hpp"

namespace changeover {

/// Length and temperatures of an annealing run.
struct AnnealSchedule {
  std::uint64_t moves = 0;  ///< limit for proposals
  double hot = 0.32;
  double cold = 0.18;
};

struct AnnealOutcome {
  std::uint64_t moves = 0;     ///< proposals made
  std::uint64_t accepted = 0;  ///< of them
  std::uint64_t missing = 0;   ///< in the final state
  std::uint64_t least = 0;     ///< least value of missing() during the run
  bool stopped = false;        ///< by the control or the watch, before the end of the schedule
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

  /// Whether to accept the change; draws a random number only if `change` > 0.
  [[nodiscard]] bool accepts(std::int32_t change, Random& random) const {
    return change <= 0 || (static_cast<std::size_t>(change) < thresholds_.size() &&
                           random.next32() < thresholds_[static_cast<std::size_t>(change)]);
  }

 private:
  std::array<std::uint32_t, 16> thresholds_{};
};

/// The control and the watch are called at least this often; more often where moves are slow.
inline constexpr std::uint64_t anneal_moves_between_questions = 2048;

/// The number of moves until the next call. It doubles if the last moves took little time, since a
/// move may cost 50 ns or, with long blocks and strength 4, a second. Calls do not influence the
/// moves.
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

/// Called now and then with the moves so far and the number of uncovered things; false stops.
using AnnealWatch = std::function<bool(std::uint64_t moves, std::uint64_t missing)>;

/// Reports `progress` to the control, with the moves added and the number missing now.
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

/// Anneals until nothing is missing, the schedule ends, or the control or the watch stops it; both
/// are called every anneal_moves_between_questions moves, or more often. O(moves · cost of a move).
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
