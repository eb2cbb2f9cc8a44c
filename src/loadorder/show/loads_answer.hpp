// The answer to a load request, for every door: the schedule of the kind that is asked for, and how
// it is written.
//
//     const LoadsAnswer answer(asked, request, options);
//     answer.write("jsonl", sink);   // what --json says
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

/// The document "changeover-loads/1": an object for the head, then one for each step, a line each
/// (docs/schema/changeover-loads-1.json).
class LoadsAnswer {
 public:
  /// Plans it; `request` is the one that was checked. @throws as plan_load_order(),
  /// split_load_order(), plan_disjoint_order(), plan_two_levels() and plan_prefetch()
  LoadsAnswer(const CheckedLoads& asked, const LoadRequest& request,
              const LoadOrderOptions& options);

  [[nodiscard]] const AnyLoads& loads() const { return loads_; }
  [[nodiscard]] std::uint64_t room() const { return room_; }

  /// No schedule of this kind has fewer loads.
  [[nodiscard]] LoadBound bound() const;

  /// Reads all steps, with what they compute if that is said: what is wrong with them, empty if
  /// nothing is. For any thread.
  [[nodiscard]] std::string fault() const;

  /// Whether there is more to a step than what it evicts and loads.
  [[nodiscard]] bool says_work() const {
    return how_.new_pairs || how_.write_back || std::holds_alternative<PrefetchPlan>(loads_) ||
           std::holds_alternative<PrefetchSplit>(loads_);
  }

  /// The steps that are written, of all workers or of one, with what they compute and store if that
  /// is said. They may not outlive this.
  /// @throws BadInput if there is no such worker
  [[nodiscard]] std::unique_ptr<StepSource> steps(std::optional<std::uint64_t> worker) const;

  /// In the format "jsonl", "csv", "text" or "marius" (show/marius_writer.hpp; one worker and one
  /// level, otherwise @throws BadInput). @throws InternalError if a step is wrong
  void write(const std::string& format, Sink& sink) const;

  /// The first line of "jsonl", without its end.
  [[nodiscard]] std::string head() const;

 private:
  [[nodiscard]] ScheduleRules rules() const;

  std::uint64_t room_;
  LoadsShown how_;
  AnyLoads loads_;
};

}  // namespace changeover
