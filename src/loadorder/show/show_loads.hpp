// Writes schedules of all kinds: the head, then the steps.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "changeover/io/output.hpp"
#include "changeover/loadorder/workers.hpp"

namespace changeover {

struct LoadsShown {
  std::string format;
  ComputeRules compute = {};
  bool new_pairs = false;   ///< whether to show what is computed
  bool early = false;       ///< of two levels: loads start early
  bool write_back = false;  ///< whether to show what is stored
  bool searched = false;    ///< whether a search for fewer loads was requested
  bool time_is_up = false;  ///< whether what is tried without a search was cut short
  std::uint64_t seed =
      1;  ///< seed for choosing the items that are tracked while an unverified order is written
  std::optional<std::uint64_t> item_bytes = {};  ///< to say how many bytes are moved
  std::string item_bytes_key = {};               ///< what messages call it
  bool head_only = false;                        ///< omits the steps
  std::optional<std::uint64_t> worker = {};      ///< only the steps of this worker
  bool worker_by_itself = false;  ///< and only its steps are checked, while they are written
  std::optional<std::uint64_t> from_step = {};  ///< for one worker: steps from this one on
  bool beside = false;  ///< all steps are checked while they are written, not before
};

/// A lower bound on the loads of any schedule with these rules and this room, for its epochs and
/// workers.
[[nodiscard]] LoadBound bound_of_loads(const ScheduleRules& rules, std::uint64_t room,
                                       std::uint64_t workers);

/// A lower bound on the loads of the busiest worker of any shares for this room. These ones may be
/// for less, if places are kept for what is loading.
[[nodiscard]] LoadBound makespan_bound_of(const WorkerSplit& split, std::uint64_t room);

// What the steps compute and store is checked first, in the form in which it is written. @throws
// InternalError

/// In lockstep, the steps of all workers with the same number are adjacent. @throws
/// ImpossibleParameters if bytes exceed 64 bits
void show_loads(const LoadOrder& order, const LoadsShown& how, Sink& out);
/// One worker after another.
void show_loads(const WorkerSplit& split, const LoadsShown& how, Sink& out);
/// With the whole room, of which the order may leave some.
void show_loads(const PrefetchPlan& plan, const LoadsShown& how, Sink& out);
void show_loads(const PrefetchSplit& plan, const LoadsShown& how, Sink& out);

}  // namespace changeover
