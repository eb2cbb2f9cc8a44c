// Counts and compares lists of set-ups.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "changeover/plan/run_plan.hpp"
#include "plan/search/starts/starts.hpp"

namespace changeover {

/// Counts a list by run_sheet(); a list that is a change covering design must also pass the
/// verifier. Counting takes little time and is not stopped, since no list is shown without it.
/// @throws InternalError if the list breaks a constraint.
[[nodiscard]] Candidate counted(const Job& job, const Start& start);

/// The same for a list that must do the job. @throws InternalError if it leaves anything untested.
[[nodiscard]] Candidate counted_complete(const Job& job, const Start& start);

/// The remaining set-ups of the current plan (PlanOptions::rest) that break no constraint; if there
/// are more than pairs to meet, only those that test something new. O(tests · at_once²), and one
/// count of the list.
[[nodiscard]] std::vector<Block> sound_rest(const Job& job, const PlanOptions& options);

/// A list made of them: nothing changed, or with what it lacked and without what is too much.
[[nodiscard]] Start rest_as_it_is(std::vector<Block> rest);
[[nodiscard]] Start rest_mended(std::vector<Block> setups);

/// Orders of candidates: the cheapest first; those that test the most weight, triples or pairs
/// first.
using CandidateOrder = std::function<bool(const Candidate&, const Candidate&)>;
[[nodiscard]] bool cheaper(const Candidate& a, const Candidate& b);
[[nodiscard]] bool tests_more(const Candidate& a, const Candidate& b);

/// Adds a list that must do the job to the candidates, and passes it to PlanOptions::on_better, if
/// it is the first one or better than all others in this order. A list whose cost overflows is left
/// out, unless it is the first. @throws InternalError if it leaves anything untested, or is below
/// the bound.
void add_complete(const Job& job, RunPlan& plan, const PlanOptions& options, const Start& start,
                  const CandidateOrder& better = cheaper);

/// The longest beginnings of these plans that are within the budget, that which tests most first;
/// of the first plans only if the control says stop.
[[nodiscard]] std::vector<Candidate> affordable(const Job& job, const std::vector<Candidate>& plans,
                                                Amount budget, RunControl& control);

/// @throws InternalError if a plan costs more than the budget, or tests more than is possible.
void check_within(const std::vector<Candidate>& plans, Amount budget,
                  std::optional<Amount> most_weight);

/// Runs work that may be stopped, or may lack memory: the plan keeps its results so far, and
/// records what was missing.
void keep_what_there_is(RunPlan& plan, const std::function<void()>& work);

/// Sets the sheet of the first candidate, and why the search ended.
void settle(const Job& job, RunPlan& plan, const RunControl& control);

}  // namespace changeover
