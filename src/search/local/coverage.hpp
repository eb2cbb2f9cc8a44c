// Counts how often each thing is covered, and lists the uncovered ones, to draw one at random.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "changeover/run/control.hpp"

namespace changeover {

/// Things 0, 1, … below 2³². All but the constructor is O(1).
class Coverage {
 public:
  Coverage() = default;
  /// Starts with the numbers in `times`. Stops with the scope of this thread (run/control.hpp).
  explicit Coverage(std::vector<std::uint32_t> times)
      : times_(std::move(times)), place_(times_.size()) {
    constexpr std::uint32_t between_questions = 1 << 16;
    for (std::uint32_t thing = 0; thing < times_.size(); ++thing) {
      if (thing % between_questions == 0) {
        stop_if_asked();
      }
      if (times_[thing] == 0) {
        enlist(thing);
      }
    }
  }

  [[nodiscard]] std::uint32_t times(std::size_t thing) const { return times_[thing]; }
  /// For a change that is undone at once: the list of uncovered things is not updated.
  [[nodiscard]] std::uint32_t& times(std::size_t thing) { return times_[thing]; }
  [[nodiscard]] std::uint32_t missing() const {
    return static_cast<std::uint32_t>(uncovered_.size());
  }
  /// One of the missing() uncovered things.
  [[nodiscard]] std::uint32_t uncovered(std::size_t which) const { return uncovered_[which]; }

  void add(std::size_t thing) {
    if (times_[thing]++ == 0) {
      const std::uint32_t last = uncovered_.back();
      uncovered_[place_[thing]] = last;
      place_[last] = place_[thing];
      uncovered_.pop_back();
    }
  }

  void remove(std::size_t thing) {
    if (--times_[thing] == 0) {
      enlist(static_cast<std::uint32_t>(thing));
    }
  }

 private:
  void enlist(std::uint32_t thing) {
    place_[thing] = static_cast<std::uint32_t>(uncovered_.size());
    uncovered_.push_back(thing);
  }

  std::vector<std::uint32_t> times_;
  std::vector<std::uint32_t> uncovered_;  // in any order
  std::vector<std::uint32_t> place_;      // in uncovered_, for uncovered things
};

}  // namespace changeover
