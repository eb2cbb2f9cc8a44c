// Computes the times of steps on benches: each as early as possible, in the order of the lists, as
// far as parts are available.
//
// Of the benches whose next step can begin, the one that can begin first continues; ties go to the
// lower number. A step begins when the step before it has ended, enough other benches have released
// its parts, and the day is long enough. If every bench waits for parts that waiting benches hold,
// the one that has waited longest gets what it lacks: benches that hold these parts give them up,
// those with the lowest numbers first, and put them in again later. So every step gets a time.
//
// Plans are made with this clock; the independent check, count_benches(), does not use it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

/// Whole units of time, which are also units of cost.
using Ticks = std::int64_t;

/// A step of a bench: its duration, and a bit for each part of its set-up.
struct ClockStep {
  Ticks cost = 0;
  const std::uint64_t* parts = nullptr;
};

/// A bench; the data that it refers to must outlive the run.
struct ClockBench {
  std::vector<ClockStep> steps;
  const std::uint64_t* start =
      nullptr;  ///< a bit for each part that is mounted before the first step
  const std::uint64_t* shared =
      nullptr;                    ///< a bit for each part that is scarce and not the bench's own
  std::span<const Ticks> change;  ///< by part: cost of putting it in again
  Ticks hours = 0;                ///< working hours per day; 0: it never rests
};

/// The times by bench and step, if requested.
struct ClockRecord {
  struct Time {
    Ticks begin = 0;
    Ticks end = 0;
    Block again;  ///< parts put in again; sorted
  };
  std::vector<std::vector<Time>> times;
};

class BenchClock {
 public:
  /// @param quantity by part: number of pieces
  /// @param day hours of a day; unused if no bench rests
  BenchClock(std::vector<std::uint64_t> quantity, Ticks day);

  struct Result {
    Ticks finish = 0;              ///< the end of the last step
    Ticks again = 0;               ///< cost of putting parts in again
    std::vector<Ticks> ends = {};  ///< by bench: end of its last step
  };
  /// O(steps · (v/64 + benches)), and the time for resolving waits.
  const Result& run(std::span<const ClockBench> benches, ClockRecord* record = nullptr);

  /// The result of the last run.
  [[nodiscard]] const Result& result() const { return result_; }

  /// The first time from `from` on at which a step of this cost may begin on a bench with these
  /// hours, and its end.
  struct Fit {
    Ticks begin = 0;
    Ticks end = 0;
  };
  [[nodiscard]] Fit fit(Ticks from, Ticks cost, Ticks hours) const;

 private:
  struct Course {  // of a bench
    std::size_t next = 0;
    Ticks free = 0;
    Ticks begin = 0;  // of the next step, if it can begin
    Ticks end = 0;
    bool blocked = false;       // by parts that are held without a known end
    bool waits = false;         // for parts: checked again after every step
    std::vector<Element> lost;  // given up, and to be put in again
  };
  struct Holders {
    std::uint64_t staying = 0;  // holders without a known end
    std::vector<Ticks> until;   // the ends of the others
  };

  void look_at(std::size_t bench);
  void advance(std::size_t bench, ClockRecord* record);
  void break_up();
  [[nodiscard]] bool is_new(std::size_t bench, Element x) const;
  [[nodiscard]] Ticks cost_of_next(std::size_t bench) const;
  template <typename Visit>
  void each_wanted(std::size_t bench, Visit&& visit) const;
  [[nodiscard]] const std::uint64_t* before(std::size_t bench) const;

  std::vector<std::uint64_t> quantity_;
  std::size_t words_;
  Ticks day_;
  std::span<const ClockBench> benches_;
  std::vector<Course> courses_;
  std::vector<Holders> held_;  // by part
  std::vector<Element> used_;  // parts with holders, to be cleared
  Result result_;
  Ticks now_ = 0;  // begin of the last step that was given a time
};

}  // namespace changeover
