// Schedules of all kinds, as they are said: the head, then the steps.
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
  bool new_pairs = false;   ///< whether it is said what is computed
  bool write_back = false;  ///< whether it is said what is stored
  bool searched = false;    ///< whether a search for fewer loads was asked for
  std::uint64_t seed =
      1;  ///< of the items that are followed while an order is written that was not read before
  std::optional<std::uint64_t> item_bytes = {};  ///< of two levels
  bool head_only = false;                        ///< without the steps
  std::optional<std::uint64_t> worker = {};      ///< the steps of this one only
  bool worker_by_itself = false;  ///< and they alone are checked, while they are written
  std::optional<std::uint64_t> from_step = {};  ///< of one worker: steps from this one on
  bool beside = false;  ///< all steps are checked while they are written, not before
};

/// No schedule with such rules has fewer loads, in epochs and of several workers, with this room.
[[nodiscard]] LoadBound bound_of_loads(const ScheduleRules& rules, std::uint64_t room,
                                       std::uint64_t workers);

// What the steps compute and store is checked first, as it will be written. @throws InternalError

/// In lockstep the steps of all workers with the same number come after one another. @throws
/// ImpossibleParameters if bytes exceed 64 bits
void show_loads(const LoadOrder& order, const LoadsShown& how, Sink& out);
/// One worker after another.
void show_loads(const WorkerSplit& split, const LoadsShown& how, Sink& out);
/// With the whole room, of which the order may leave some.
void show_loads(const PrefetchPlan& plan, const LoadsShown& how, Sink& out);
void show_loads(const PrefetchSplit& plan, const LoadsShown& how, Sink& out);

}  // namespace changeover
