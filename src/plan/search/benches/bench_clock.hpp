// Computes the times of steps on benches: each as early as possible, in the order of the lists, as
// far as parts are available.
//
// Of the benches whose next step can begin, the one that can begin first continues; ties go to the
// lower number. A step begins when the step before it has ended, enough other benches have released
// its parts, and the day is long enough. If every bench waits for parts that waiting benches hold,
// the one that has waited longest gets what it lacks: benches that hold these parts give them up,
// those with the lowest numbers first, and put them in again later. So every step gets a time.
//
// A search changes a few steps at a time. The clock keeps what it knew at some moments of the run
// that was kept last, and a run goes on from the last of them that no changed step can affect.
//
//     BenchClock clock(benches, quantity, day);
//     clock.steps(0) = {…};
//     clock.change(0, 0);       // steps from this one on are others
//     clock.run().finish;
//     clock.keep();             // later changes are compared with this run
//
// Plans are made with this clock; the independent check, count_benches(), does not use it.
#pragma once

#include <algorithm>
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

/// A bench; the data that it refers to must outlive the clock.
struct ClockBench {
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
  BenchClock(std::vector<ClockBench> benches, const std::vector<std::uint64_t>& quantity,
             Ticks day);

  /// The steps of a bench, to be changed; change() must be told.
  [[nodiscard]] std::vector<ClockStep>& steps(std::size_t bench) { return steps_[bench]; }
  /// The steps of a bench from this one on, or their number, may be others than in the kept run.
  void change(std::size_t bench, std::size_t first) {
    changed_[bench] = std::min(changed_[bench], first);
  }

  struct Result {
    Ticks finish = 0;              ///< the end of the last step
    Ticks again = 0;               ///< cost of putting parts in again
    std::vector<Ticks> ends = {};  ///< by bench: end of its last step
  };
  /// O(steps · (v/64 + benches)) from the first changed step on, and the time for resolving waits.
  const Result& run(ClockRecord* record = nullptr);
  /// The last run is what later ones go on from.
  void keep();
  /// The steps are again those of the kept run.
  void undo();

  /// The result of the last run, or of the kept one after undo().
  [[nodiscard]] const Result& result() const { return result_; }

 private:
  static constexpr Ticks never = std::numeric_limits<Ticks>::max();
  static constexpr std::size_t unchanged = std::numeric_limits<std::size_t>::max();

  struct Course {  // of a bench
    std::size_t next = 0;
    Ticks free = 0;
    Ticks begin = never;  // of the next step; never: its parts are held without a known end
    Ticks end = 0;
    Ticks morning = 0;          // of the day that was looked at last
    std::vector<Element> lost;  // given up, and to be put in again
  };
  // What is known at a moment: see snapshot().
  struct Moments {
    std::vector<Ticks> data;
    std::size_t count = 0;
  };

  [[nodiscard]] bool has_more(std::size_t bench) const {
    return courses_[bench].next < steps_[bench].size();
  }
  void begin_anew();
  bool go_on_from_kept();
  void snapshot();
  void look_at(std::size_t bench);
  void fit(Course& course, Ticks from, Ticks cost, Ticks hours) const;
  void advance(std::size_t bench, ClockRecord* record);
  void break_up();
  [[nodiscard]] Ticks cost_of_next(std::size_t bench) const;
  [[nodiscard]] const std::uint64_t* before(std::size_t bench) const;
  [[nodiscard]] Ticks available(Element x) const;
  void take(Element x, Ticks until);
  void release(Element x, Ticks at);
  template <typename Visit>
  void each_bit(std::uint64_t bits, std::size_t word, Visit&& visit) const;

  std::vector<ClockBench> benches_;
  std::vector<std::vector<ClockStep>> steps_;  // by bench
  std::vector<std::size_t> changed_;           // by bench: the first changed step
  std::size_t words_;
  Ticks day_;
  std::vector<std::size_t> first_piece_;  // by part, and one more
  std::vector<Ticks> pieces_;  // when each piece is free, sorted for each part; never: it stays
  std::vector<Course> courses_;
  std::vector<std::uint64_t> wanted_;   // by bench: the scarce parts that its next step puts in
  std::vector<std::uint64_t> touched_;  // parts that the last step took or released
  std::size_t losing_ = 0;              // benches that have lost parts
  std::size_t moment_;                  // the size of a moment
  std::size_t stride_;                  // steps between moments
  Moments kept_;
  Moments new_;             // of the last run
  std::size_t shared_ = 0;  // moments of the kept run that the last run has, too
  Result result_;
  Result kept_result_;
  bool has_run_ = false;  // since keep() or undo()
  bool has_kept_ = false;
  Ticks now_ = 0;  // begin of the last step that was given a time
};

}  // namespace changeover
