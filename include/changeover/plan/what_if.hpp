// Which plan is cheapest when changes become dearer or cheaper against tests: where it breaks even.
//
//     WhatIf answer = what_if(job, plan, {}, control);
//     for (const WhatIf::Range& range : answer.ranges) …   // by ratio, without gaps
//
// A plan with T tests and C changes costs T + rC tests at the ratio r of the change cost to the test cost: a
// line in r. The cheapest plans are the lower envelope of the lines of all candidates. Where change costs
// differ from part to part, r is the factor by which all of them are multiplied, and C the cost of all
// changes in units of the test cost.
//
// At every break-even ratio, and far out on both sides, the search of plan/run_plan.hpp is run again at
// that ratio; a cheaper list joins the candidates, until nothing is cheaper or the control says stop.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// A non-negative ratio, not reduced.
struct Ratio {
  std::uint64_t over = 0;
  std::uint64_t under = 1;

  /// In decimals, four digits of it: "0.625", "12.5".
  [[nodiscard]] std::string to_string() const;
};

struct WhatIf {
  struct Range {
    std::optional<Ratio> from;  ///< nothing: from 0
    std::optional<Ratio> to;    ///< nothing: without end
    Candidate plan;             ///< cheapest between them; at both ends as cheap as its neighbour
  };
  bool by_factor = false;  ///< change costs differ: ratios are factors of all change costs
  std::vector<Range> ranges;
  std::optional<Ratio> asked;           ///< where the job stands; nothing if its tests cost nothing
  std::optional<std::string> shortage;  ///< as in RunPlan
};

/// The envelope of some candidates, without any search. O(n log n).
/// @throws ImpossibleParameters if costs overflow.
[[nodiscard]] WhatIf envelope(const Job& job, const std::vector<Candidate>& candidates);

/// The envelope of the candidates of a plan and of what searching at its break-even ratios finds.
/// @throws as make_run_plan(), which is what it costs for each ratio.
[[nodiscard]] WhatIf what_if(const Job& job, const RunPlan& plan, const PlanOptions& options,
                             RunControl& control);

}  // namespace changeover
