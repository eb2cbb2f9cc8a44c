// When the steps of benches can be: each as early as it can, in the order in which they come, as
// far as there are parts.
//
// Of the benches whose next step can begin, the one goes on that can begin first, the lower number
// among equals. A step begins when the step before it has ended, enough benches no longer hold what
// it puts in, and the day is long enough. Where every bench waits for parts that others hold while
// they wait, the one that has waited longest gets what it lacks: benches that hold it give it up,
// those with the lowest numbers, and put it in again later. So there always is a time for every
// step.
//
// Plans are made with this; the referee (count_benches) does not know it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

/// Whole units of time, and of cost.
using Ticks = std::int64_t;

/// A step of a bench: how long it takes, and a bit for each part of its set-up.
struct ClockStep {
  Ticks cost = 0;
  const std::uint64_t* parts = nullptr;
};

/// A bench; what this refers to must outlive the run.
struct ClockBench {
  std::vector<ClockStep> steps;
  const std::uint64_t* start =
      nullptr;  ///< a bit for each part that is mounted before the first step
  const std::uint64_t* shared =
      nullptr;                    ///< a bit for each part that is scarce and not the bench's own
  std::span<const Ticks> change;  ///< by part: what putting it in again costs
  Ticks hours = 0;                ///< of work a day; 0: it never rests
};

/// What is found, by bench and step, if that is asked for.
struct ClockRecord {
  struct Time {
    Ticks begin = 0;
    Ticks end = 0;
    Block again;  ///< put in again; sorted
  };
  std::vector<std::vector<Time>> times;
};

class BenchClock {
 public:
  /// @param quantity  by part: how many there are of it
  /// @param day  hours of a day; of no importance where no bench rests
  BenchClock(std::vector<std::uint64_t> quantity, Ticks day);

  struct Result {
    Ticks finish = 0;              ///< the end of the last step
    Ticks again = 0;               ///< what putting in again costs
    std::vector<Ticks> ends = {};  ///< by bench: of its last step
  };
  /// O(steps · (v/64 + benches)), and what parts that are waited for take.
  const Result& run(std::span<const ClockBench> benches, ClockRecord* record = nullptr);

  /// That of the last run.
  [[nodiscard]] const Result& result() const { return result_; }

  /// The first time from `from` on at which a step of this cost may begin on a bench with so many
  /// hours, and when it ends.
  struct Fit {
    Ticks begin = 0;
    Ticks end = 0;
  };
  [[nodiscard]] Fit fit(Ticks from, Ticks cost, Ticks hours) const;

 private:
  struct Course {  // of a bench
    std::size_t next = 0;
    Ticks free = 0;
    Ticks begin = 0;  // of the next step, if it can
    Ticks end = 0;
    bool blocked = false;       // by parts that are held without an end in sight
    bool waits = false;         // for parts: to be looked at again after every step
    std::vector<Element> lost;  // given up, and still to be put in again
  };
  struct Holders {
    std::uint64_t staying = 0;  // without an end in sight
    std::vector<Ticks> until;   // the others
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
  std::vector<Element> used_;  // parts with holders: to be cleared
  Result result_;
  Ticks now_ = 0;  // when the last step that was given its time begins
};

}  // namespace changeover
