// Lists of set-ups counted and compared.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "changeover/plan/run_plan.hpp"
#include "plan/search/starts/starts.hpp"

namespace changeover {

/// A list as the referee counts it; one that is a change covering design must pass the verifier
/// too. Counting is short, and is not stopped: nothing is shown without it. @throws InternalError
/// if it breaks a constraint.
[[nodiscard]] Candidate counted(const Job& job, const Start& start);

/// The same for a list that must do the job. @throws InternalError if it leaves anything untested.
[[nodiscard]] Candidate counted_complete(const Job& job, const Start& start);

/// The set-ups of the plan under way (PlanOptions::rest) that break no constraint; of more than
/// there is to meet, those that bring something new. O(tests · at_once²), besides one count of the
/// list.
[[nodiscard]] std::vector<Block> sound_rest(const Job& job, const PlanOptions& options);

/// A list made of them: nothing changed, or with what it lacked and without what is too much.
[[nodiscard]] Start rest_as_it_is(std::vector<Block> rest);
[[nodiscard]] Start rest_mended(std::vector<Block> setups);

/// Orders of candidates: the cheapest first; those that test the most weight, triples or pairs
/// first.
[[nodiscard]] bool cheaper(const Candidate& a, const Candidate& b);
[[nodiscard]] bool tests_more(const Candidate& a, const Candidate& b);

/// Tells PlanOptions::on_better of the last candidate, if it is the first one or comes before all
/// others in this order.
void tell_if_best(const RunPlan& plan, const PlanOptions& options,
                  const std::function<bool(const Candidate&, const Candidate&)>& before);

/// The longest beginnings of these plans that are within the budget, that which tests most first;
/// of the first plans only if the control says stop.
[[nodiscard]] std::vector<Candidate> affordable(const Job& job, const std::vector<Candidate>& plans,
                                                Amount budget, RunControl& control);

/// @throws InternalError if a plan costs more than the budget, or tests more than can be.
void check_within(const std::vector<Candidate>& plans, Amount budget,
                  std::optional<Amount> most_weight);

/// Does what may go on for long, or want more than there is: what the plan has by then stays, and
/// it says what was missing.
void keep_what_there_is(RunPlan& plan, const std::function<void()>& work);

/// The sheet of the first candidate, and why the search ended.
void settle(const Job& job, RunPlan& plan, const RunControl& control);

}  // namespace changeover
