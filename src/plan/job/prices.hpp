// One price per part, instead of costs that depend on what is replaced.
#pragma once

#include <string>

#include "changeover/plan/job.hpp"

namespace changeover {

/// Which cost to take of those for putting in a part: its own change cost, and the costs in place
/// of any other part of its slot that does not stay mounted.
enum class Price {
  least,  ///< the least of all
  mean,   ///< the mean of those in place of another part, rounded
};

/// The same job with one price per part, whatever it replaces; the job itself if its costs do not
/// depend on that. A list costs at least as much as at the least prices, since parts that stay
/// mounted are never taken out. O(v²).
[[nodiscard]] Job at_prices(const Job& job, Price price);

/// @throws BadInput for a job with replace_costs, since `what` does not support them.
void refuse_replacing(const Job& job, const std::string& what);
/// @throws BadInput for a job with triples, since `what` does not support them.
void refuse_triples(const Job& job, const std::string& what);

}  // namespace changeover
