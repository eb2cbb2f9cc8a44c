// When long work stops, how much memory it may take, and where it reports its progress.
//
//     RunControl control({.time = std::chrono::seconds(60), .threads = 2, .seed = 7,
//                         .on_progress = [](const Progress& p) { std::cerr << p.phase << '\n'; }});
//     while (!control.stop_wanted()) {       // what a search does with it
//       take_steps(control);
//     }
//     control.why_stopped();                 // e.g. WhyStopped::time_limit
//
// One control is shared by all threads of a search. The inner loop asks stop_wanted() every few
// thousand steps; a call costs a relaxed load and a look at the clock. Searches never print and
// never install signal handlers: the program that handles Ctrl-C sets the flag that `interrupted`
// points to. Work deep below a search, or without one above it, uses a RunScope (below).
//
// With threads = 1 a search is deterministic in its seed as long as no clock stops it.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace changeover {

// The outcome of a search.
//
//     to_string(Outcome::none);          // "none"

enum class Outcome : std::uint8_t {
  found,
  none,     ///< there is none; the search says who proved it
  unknown,  ///< stopped before it was known; RunControl::why_stopped() says why
};

/// "found", "none", "unknown".
[[nodiscard]] constexpr std::string_view to_string(Outcome outcome) {
  return outcome == Outcome::found ? "found" : outcome == Outcome::none ? "none" : "unknown";
}

/// Why a search ended.
enum class WhyStopped : std::uint8_t {
  running,      ///< it has not
  found,        ///< what was looked for was found
  exhausted,    ///< every case was tried, or a proof was found
  time_limit,   ///< the time was up
  step_limit,   ///< the allowed number of steps was used up
  interrupted,  ///< the user stopped it
  elsewhere,    ///< another process that shares the search found it
  fault,        ///< one of its threads threw; the caller gets the exception
};

/// "time limit", …
[[nodiscard]] std::string_view to_string(WhyStopped why);

/// Progress of running work.
struct Progress {
  std::string phase;                       ///< what it is doing, e.g. "annealing with 40 blocks"
  std::uint64_t steps = 0;                 ///< done so far, over all threads
  std::string_view unit = "moves";         ///< what a step is
  std::optional<std::uint64_t> best = {};  ///< blocks of the best design so far
  std::optional<std::uint64_t> lower_bound = {};  ///< of the number of blocks
  std::optional<std::uint64_t> missing =
      {};  ///< what the current attempt still lacks, e.g. uncovered pairs
  std::chrono::duration<double> elapsed{};  ///< set by the control
  std::optional<std::chrono::duration<double>> left =
      {};  ///< of the time limit; set by the control
};

/// A limit of work that no clock changes: how often stop_wanted() answers no.
struct Questions {
  std::uint64_t most = 0;
};

/// The longest time limit: 36500 days.
inline constexpr std::uint64_t most_seconds = 3'153'600'000;

/// The most threads of one search.
inline constexpr std::uint64_t most_threads = 1024;

/// The part of a search that this process takes when several share it: every `of`-th, from `index`.
struct WorkShare {
  std::uint64_t index = 0;
  std::uint64_t of = 1;
};

class RunControl {
 public:
  using Clock = std::chrono::steady_clock;

  struct Settings {
    std::optional<std::chrono::duration<double>> time = {};  ///< nullopt: no limit
    std::optional<std::uint64_t> memory_bytes =
        {};  ///< for one table or formula; nullopt: no limit
    unsigned threads = 1;
    std::uint64_t seed = 1;
    WorkShare share = {};                            ///< of several processes
    const std::atomic<bool>* interrupted = nullptr;  ///< set by a signal handler
    std::function<bool()> found_elsewhere =
        {};  ///< called now and then, never by two threads at once
    std::function<void(const Progress&)> on_progress = {};  ///< never called by two threads at once
    std::chrono::duration<double> progress_interval{0.5};
  };

  /// The clock of the time limit starts now.
  explicit RunControl(Settings settings);

  /// A control for one phase of a longer search: it stops with its parent, or after `time`. It
  /// shares the parent's settings, except for its own seed and callback; stopping it does
  /// not stop the parent.
  RunControl(RunControl& parent, std::chrono::duration<double> time,
             std::optional<std::uint64_t> seed = {});

  /// A control for one phase of a longer search with a limit of work instead of time: the result
  /// does not depend on a clock.
  RunControl(RunControl& parent, Questions questions);

  /// For work that the parent's own limit, of time or of questions, does not cut short: it stops
  /// with what stops the parent otherwise.
  [[nodiscard]] static std::unique_ptr<RunControl> beyond_limit(RunControl& parent);

  /// Whether this control or one of its parents was made by beyond_limit(): work that is stopped
  /// then ends with the best so far.
  [[nodiscard]] bool keeps_best() const {
    return !parents_limit_counts_ || (parent_ != nullptr && parent_->keeps_best());
  }

  /// A control for one of several attempts that run side by side: for `threads` threads, without
  /// its own time limit and without a callback.
  RunControl(RunControl& parent, unsigned threads);

  RunControl(const RunControl&) = delete;
  RunControl& operator=(const RunControl&) = delete;

  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] unsigned threads() const { return settings_.threads == 0 ? 1 : settings_.threads; }
  [[nodiscard]] std::uint64_t seed() const { return settings_.seed; }

  /// Whether to stop now. Thread-safe; call it every 10 to 100 microseconds at most.
  [[nodiscard]] bool stop_wanted();

  /// Checks that `bytes` for a table, a formula, … are allowed. `what` names it in the message,
  /// as in "the formula of DCCD(60,5)". @throws MissingResource with one line if it is more than
  /// memory_bytes.
  void require_memory(std::uint64_t bytes, std::string_view what) const;

  /// Stops the search for this reason, unless it was stopped before. Thread-safe.
  void stop(WhyStopped why);

  /// `running` until stop() or a limit.
  [[nodiscard]] WhyStopped why_stopped() const { return why_.load(std::memory_order_relaxed); }

  /// Whether a time limit stopped this work, or a part of it that had its own limit: what was
  /// found then depends on the clock.
  [[nodiscard]] bool time_was_up() const { return time_was_up_.load(std::memory_order_relaxed); }

  [[nodiscard]] std::chrono::duration<double> elapsed() const { return Clock::now() - begin_; }
  /// The time until the limit of this control or its parent; nullopt if there is no limit.
  [[nodiscard]] std::optional<std::chrono::duration<double>> time_left() const;

  /// Whether tell() would reach the callback now: enough time has passed.
  [[nodiscard]] bool progress_due() const;

  /// Calls the callback if it is due, or if `now`. Thread-safe.
  void tell(Progress progress, bool now = false);

 private:
  // Whether to stop now; whether its own limit counts.
  bool stops(bool by_its_limit);

  Settings settings_;
  RunControl* parent_ = nullptr;
  bool parents_limit_counts_ = true;
  std::optional<std::uint64_t> questions_;
  std::atomic<std::uint64_t> asked_{0};
  bool quiet_ = false;
  Clock::time_point begin_ = Clock::now();
  std::optional<Clock::time_point> end_;
  std::atomic<WhyStopped> why_{WhyStopped::running};
  std::atomic<bool> time_was_up_{false};
  std::atomic<Clock::rep> next_progress_{0};
  std::atomic<Clock::rep> next_question_{0};
  std::mutex asking_;
  std::mutex telling_;
};

// A RunScope lets work that has no RunControl argument obey the control of its caller.
//
//     RunScope scope(control);                 // for this thread, until the end of the block
//     const Bound bound = lower_bound(p);      // stops with the control, and reports to it
//
// Bounds, constructions and verification are called by searches that have a limit and by programs
// that have none, often several calls deep. Their loops call stop_if_asked(), which without a scope
// only looks at one pointer. Scopes nest: the innermost counts. Threads that the library starts
// have the scope of their control.
//
// *Stopping* is an exception, Stopped, but not a fault: it ends the work under way. The code that
// opened the scope catches it, keeps what was found before, and asks the control why it stopped.

/// Thrown by stop_if_asked(). Not an Error: nothing is wrong.
class Stopped : public std::exception {
 public:
  explicit Stopped(WhyStopped why) : why_(why) {}
  [[nodiscard]] WhyStopped why() const { return why_; }
  [[nodiscard]] const char* what() const noexcept override { return "stopped"; }

 private:
  WhyStopped why_;
};

/// Makes a control the one that this thread listens to. The control must outlive the scope.
class RunScope {
 public:
  explicit RunScope(RunControl& control);
  ~RunScope();
  RunScope(const RunScope&) = delete;
  RunScope& operator=(const RunScope&) = delete;

  /// The control of the innermost scope of this thread; nullptr if there is none.
  [[nodiscard]] static RunControl* current();

 private:
  RunControl* outer_;
};

/// @throws Stopped if the control of this thread's scope wants to stop. Costs a look at the clock,
/// some 30 ns; nothing without a scope.
void stop_if_asked();

/// Checks that this many bytes are within the memory limit of this thread's scope. @throws
/// MissingResource if not; `what` begins its message.
void require_memory(std::uint64_t bytes, std::string_view what);

/// Whether report_progress() would call a callback now; ask before making a long text.
[[nodiscard]] bool progress_due();

/// RunControl::tell() of this thread's scope.
void report_progress(const Progress& progress);

}  // namespace changeover
