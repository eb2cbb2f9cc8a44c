// One price a part, in place of costs that depend on what is replaced.
#pragma once

#include <string>

#include "changeover/plan/job.hpp"

namespace changeover {

/// Of what putting in a part may cost: at its own change cost, or in place of any other part of its
/// slot that does not stay mounted.
enum class Price {
  least,    ///< of all of them
  mean,     ///< of those in place of another part, rounded
  dearest,  ///< of all of them
};

/// The same job with a price for each part, whatever it replaces; the job itself if it does not
/// ask. No list costs less than at the least prices, and none more than at the dearest, since what
/// stays mounted is never taken out. O(v²).
[[nodiscard]] Job at_prices(const Job& job, Price price);

/// @throws BadInput for a job with replace_costs: `what` is not done for it.
void refuse_replacing(const Job& job, const std::string& what);
/// @throws BadInput for a job with triples: `what` is not done for it.
void refuse_triples(const Job& job, const std::string& what);

}  // namespace changeover
