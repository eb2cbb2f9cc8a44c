// The answer to a load request, for every door: the requested schedule, and its formats.
//
//     const LoadsAnswer answer(asked, options);
//     answer.write("jsonl", sink);   // the output of --json
//     answer.head();                 // its first line
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "changeover/io/output.hpp"
#include "changeover/loadorder/load_request.hpp"
#include "loadorder/show/show_loads.hpp"

namespace changeover {

using AnyLoads = std::variant<LoadOrder, WorkerSplit, PrefetchPlan, PrefetchSplit>;

/// The document "changeover-loads/1": an object for the head, then one for each step, one per line
/// (docs/schema/changeover-loads-1.json).
class LoadsAnswer {
 public:
  /// Plans the schedule. @throws as plan_load_order(), split_load_order(), plan_disjoint_order(),
  /// plan_two_levels() and plan_prefetch(); BadInput if it has fewer steps than the one that it is
  /// to begin at; MissingResource if the new pairs of a step need more memory than this thread may
  /// use (run/control.hpp)
  LoadsAnswer(CheckedLoads asked, const LoadOrderOptions& options);

  /// The order, or null if it is one for workers one after another, which is split().
  [[nodiscard]] const LoadOrder* order() const;
  [[nodiscard]] const WorkerSplit* split() const;
  /// With prefetch: how many places of the room are for what is on its way.
  [[nodiscard]] std::optional<std::uint64_t> spare() const;
  [[nodiscard]] std::uint64_t room() const { return room_; }

  /// Whether LoadOrderOptions::time_in_all left out something that is tried without a search.
  [[nodiscard]] bool time_is_up() const { return how_.time_is_up; }

  /// A lower bound on the loads of such a schedule.
  [[nodiscard]] LoadBound bound() const;

  /// The same on those of the busiest of several workers, of which there must be shares.
  [[nodiscard]] LoadBound makespan_bound() const;

  /// Reads all steps, with what they compute if that is shown. Returns the fault, empty if there is
  /// none. Thread-safe.
  [[nodiscard]] std::string fault() const;

  /// Whether a step shows more than evictions and loads.
  [[nodiscard]] bool shows_work() const {
    return how_.new_pairs || how_.write_back || spare().has_value();
  }

  /// The steps that are written, of all workers or of one, with pairs and stores if these are
  /// shown. They must not outlive this object.
  /// @throws BadInput if there is no such worker
  [[nodiscard]] std::unique_ptr<StepSource> steps(std::optional<std::uint64_t> worker) const;

  /// Writes the format "jsonl", "csv", "text", "colmap" (show/step_writer.hpp) or "marius"
  /// (show/marius_writer.hpp). @throws as check_format(); InternalError if a step is wrong
  void write(const std::string& format, Sink& sink) const;

  /// The first line of "jsonl", without its line end.
  [[nodiscard]] std::string head() const;

 private:
  [[nodiscard]] ScheduleRules rules(const std::optional<ComputeRules>& compute) const;
  [[nodiscard]] ScheduleRules rules() const;

  CheckedLoads asked_;
  std::uint64_t room_;
  LoadsShown how_;
  AnyLoads loads_;
};

}  // namespace changeover
