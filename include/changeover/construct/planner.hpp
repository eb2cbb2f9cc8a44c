// The best known recipe for every (v, k, kind) of a range at once.
//
//     Plan plan = plan_range(registry, {.v_from = 5, .v_to = 24, .k_from = 3, .k_to = 6});
//     const PlannedCell& cell = plan.at({.v = 20, .k = 5, .kind = Kind::circular});
//     cell.best->b;  cell.bound.blocks;  cell.status();
//
// The registry's constructions promise what they give without building it. On top of them the planner
// applies the closure rules that act on designs, fewest blocks first; a cell that becomes better is looked at again:
//   cut       a circular design is a linear one
//   fix       (v,k) → (v+1, k+1)
//   unfix     (v+1,k+1) → (v,k), where an element is in every block
//   truncate  (v+1,k) → (v,k), where some element can go
//   close up  (v+1,k) → (v,k), linear and m = 1, with fewer blocks
//   partial expansion  (v,k) → (v+w,k), for every w, where unchanged subsets cover all elements
//   drop      blocks that are not needed go, after a cut above all
// and before them those that lead from one change number to another:
//   blow up      (v/s,k/s,m/s) → (v,k,m)
//   coarsen      (v,k−m+1,1) → (v,k,m), linear
//   interpolate  (v,k,2) → (v,k,1)
// Most of them look at blocks, so the designs of the cells in question are built. Every cell's design is
// built and verified in the end; one that does not keep its promise is an InternalError.
//
// Bound by: building and verifying, about a millisecond a cell for v ≤ 100.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/verify/verified_design.hpp"

namespace changeover {

/// The largest v of a range, and the most cells that it can have, both kinds counted.
inline constexpr std::uint64_t largest_v_of_a_plan = 1000;
inline constexpr std::uint64_t most_cells_of_a_plan = 1'000'000;

struct PlanRange {
  std::uint64_t v_from = 0;
  std::uint64_t v_to = 0;
  std::uint64_t k_from = 0;
  std::uint64_t k_to = 0;
  std::uint64_t change = 2;
  bool alone = false;  ///< without the rules that lead from other change numbers
  /// Only these cells are planned, all if null; each for designs with at most so many blocks. Others count as
  /// impossible.
  std::shared_ptr<const std::map<Parameters, std::uint64_t>> only = {};
};

/// What is known of one set of parameters.
struct PlannedCell {
  Parameters parameters;
  std::optional<std::string> impossible;  ///< why there is no design
  Bound bound;                            ///< the largest lower bound; of no meaning if impossible
  std::optional<Offer> best;              ///< nothing if no recipe is known

  /// "impossible", "minimum" (b is the bound), "best-known" or "open" (no recipe).
  [[nodiscard]] std::string status() const;
};

class Plan {
 public:
  /// Cells with bounds and without recipes; see plan_range().
  explicit Plan(const PlanRange& range);

  [[nodiscard]] const PlanRange& range() const { return range_; }

  /// All cells, by kind (circular first), k, v.
  [[nodiscard]] const std::vector<PlannedCell>& cells() const { return cells_; }

  /// The cell of these parameters, or nullptr if it is outside the range.
  [[nodiscard]] PlannedCell* find(const Parameters& p);
  /// @throws BadInput if it is outside the range.
  [[nodiscard]] const PlannedCell& at(const Parameters& p) const;

 private:
  [[nodiscard]] std::optional<std::size_t> index(const Parameters& p) const;

  PlanRange range_;
  std::vector<PlannedCell> cells_;
};

/// Plans a range.
/// @throws ImpossibleParameters if the range is empty, has k < 2 or v > 1000, or more than 10⁶ cells;
/// InternalError if a construction does not keep its promise.
[[nodiscard]] Plan plan_range(const Registry& registry, const PlanRange& range);

/// The largest v for which best_known() applies the closure rules unless it is told another: a second or two.
inline constexpr std::uint64_t largest_planned_v = 120;

/// The largest v for which those who ask for one cell have it planned like a cell of a table; at the upper end that
/// takes up to some ten seconds where the catalog has no answer.
inline constexpr std::uint64_t largest_answered_v = 160;

/// The range to plan for a table: what is outside helps inside. Larger designs can be truncated and smaller blocks
/// extended; an element less comes with a smaller block only, so few smaller v can matter.
[[nodiscard]] PlanRange range_of_a_table(const PlanRange& shown);

/// The best recipe that is known for p: the registry's best offer; if that is not the lower bound, k ≥ 2, v ≤
/// largest_v and the strength is 2, also what the closure rules make of the parameters around.
/// nullopt if nothing serves p. @throws as plan_range() and check().
[[nodiscard]] std::optional<Offer> best_known(const Registry& registry, const Parameters& p,
                                              std::uint64_t largest_v = largest_planned_v);

/// The best design that is known without search, built; nullopt if there is no recipe. Listens to the scope of
/// this thread (run/scope.hpp). @throws as check(); MissingResource if it is too large; InternalError if it
/// does not verify.
[[nodiscard]] std::optional<VerifiedDesign> best_known_design(const Parameters& p);

}  // namespace changeover
