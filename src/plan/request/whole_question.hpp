// The lists of a request as rows, so that a question stands by itself, without the files that it
// was made of.
#pragma once

#include <string>
#include <vector>

#include "changeover/plan/job_request.hpp"

namespace changeover {

/// The parts of a list with the costs that they have in the job; its first parts are those of the
/// list.
[[nodiscard]] RequestList part_rows(const PartList& list, const Job& job);
[[nodiscard]] RequestList slot_rows(const std::vector<Slot>& slots);
/// Pairs by name, with why where that is said.
[[nodiscard]] RequestList pair_rows(const PairSet& pairs, const Job& job,
                                    const PairReasons& why = {});
[[nodiscard]] RequestList weight_rows(const Job& job);
[[nodiscard]] RequestList setup_rows(const std::vector<Block>& setups, const Job& job);
/// The square table of what changes cost by what is replaced, of the parts that are no further
/// pieces of others.
[[nodiscard]] RequestList change_cost_rows(const Job& job);
/// What setting each value of a model costs, and where that depends on what is replaced.
[[nodiscard]] RequestList value_cost_rows(const Job& job);

}  // namespace changeover
