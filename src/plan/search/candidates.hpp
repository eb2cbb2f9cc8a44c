// Lists of set-ups counted and compared.
#pragma once

#include "changeover/plan/run_plan.hpp"
#include "plan/search/starts.hpp"

namespace changeover {

/// A list as the referee counts it; one that is a change covering design must pass the verifier too. Counting is short, and
/// is not stopped: nothing is shown without it. @throws InternalError if it breaks a constraint.
[[nodiscard]] Candidate counted(const Job& job, const Start& start);

/// The same for a list that must do the job. @throws InternalError if it leaves anything untested.
[[nodiscard]] Candidate counted_complete(const Job& job, const Start& start);

/// Orders of candidates: the cheapest first; those that test the most weight, triples or pairs first.
[[nodiscard]] bool cheaper(const Candidate& a, const Candidate& b);
[[nodiscard]] bool tests_more(const Candidate& a, const Candidate& b);

/// The longest beginning of a plan that is within the budget.
[[nodiscard]] Start affordable(const Job& job, const Candidate& plan, Amount budget);

}  // namespace changeover
