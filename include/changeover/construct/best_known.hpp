// The best known recipe for every (v, k, kind) of a range at once.
//
//     BestKnownTable plan =
//         best_known_table(registry, {.v_from = 5, .v_to = 24, .k_from = 3, .k_to = 6});
//     const KnownCell& cell = plan.at({.v = 20, .k = 5, .kind = Kind::circular});
//     cell.best->b;  cell.bound.blocks;  cell.status();
//
// One function answers for a cell: a cell of a plan says what best_known() says, whatever range it
// is in.
//
// The registry's constructions promise what they give without building it. On top of them closure
// rules that act on designs are applied, some levels of them:
//   cut       a circular design is a linear one
//   fix       (v,k) → (v+1, k+1)
//   unfix     (v+1,k+1) → (v,k), where an element is in every block
//   truncate  (v+i,k) → (v,k), where some elements can go
//   close up  (v+i,k) → (v,k), linear and m = 1, with fewer blocks
//   partial expansion  (v,k) → (v+w,k), for every w, where unchanged subsets cover all elements
//   join ends a linear design with a way back is a circular one
//   drop      blocks that are not needed go, after a cut above all
// and those that lead from one change number to another:
//   blow up      (v/s,k/s,m/s) → (v,k,m)
//   coarsen      (v,k−m+1,1) → (v,k,m), linear
//   interpolate  (v,k,2) → (v,k,1)
// Most of them look at blocks, so designs are built, and each that is built is verified; one that
// does not keep its promise is an InternalError. Cells that the catalog comes with
// (is_stored_cell()) were looked for when it was made, and are looked up; what the user's own
// designs make better is followed.
//
// Bound by: outside of the catalog's cells, building and verifying; neighbours share most of it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover {

// What constructions answer when they are asked for a design, and how they explain it.
//
//     const Registry& registry = Registry::standard();
//     const std::vector<Parameters> asked = {{.v = 8, .k = 5, .kind = Kind::circular},
//                                            {.v = 8, .k = 5}};
//     const auto offer = best_offer(registry, asked);  // of both kinds, the one with fewer blocks
//     const RecipeNode tree = explained(registry, offer->recipe);
//     std::cout << tree.explanation << ' ' << tree.citation << '\n';
//
// The tree of a recipe has a node for each construction that takes part; the designs that one works
// on are its inputs.

/// The best offer for any of some parameters, the first among equals: what best_known() has, or, if
/// `only` is given, what that construction offers. nullopt if nothing serves them. @throws as
/// best_known().
[[nodiscard]] std::optional<Offer> best_offer(const Registry& registry,
                                              std::span<const Parameters> asked,
                                              const Construction* only = nullptr);

/// How one design of a recipe is made.
struct RecipeNode {
  const Construction* construction = nullptr;  ///< of the registry
  Parameters parameters;
  std::optional<std::uint64_t> b;  ///< blocks, if they are counted without making them
  std::string explanation;
  std::string citation;
  std::vector<RecipeNode> inputs;
};

/// The tree of a recipe. Each node is built as far as it takes to count its blocks, none is
/// verified.
/// @throws BadInput as Registry::construction_of() and Registry::build().
[[nodiscard]] RecipeNode explained(const Registry& registry, const Recipe& recipe);

/// The largest v of a range, and the most cells that it can have, both kinds counted.
inline constexpr std::uint64_t largest_v_of_a_range = 1000;
inline constexpr std::uint64_t most_cells_of_a_range = 1'000'000;

struct CellRange {
  std::uint64_t v_from = 0;
  std::uint64_t v_to = 0;
  std::uint64_t k_from = 0;
  std::uint64_t k_to = 0;
  std::uint64_t change = 2;
  std::optional<Kind> kind = {};  ///< only these cells; nullopt: both kinds
};

/// What is known of one set of parameters.
struct KnownCell {
  Parameters parameters;
  std::optional<std::string> impossible;  ///< why there is no design
  Bound bound;                            ///< the largest lower bound; of no meaning if impossible
  std::optional<Offer> best;              ///< nothing if no recipe is known

  /// "impossible", "minimum" (b is the bound), "best-known" or "open" (no recipe).
  [[nodiscard]] std::string status() const;
};

/// What is assumed about the cells of the shipped catalog.
enum class Stored : std::uint8_t {
  as_shipped,  ///< they were looked for when it was built
  anew  ///< nothing: rules are applied to them like to all others, which makes the next catalog
};

class BestKnownTable {
 public:
  /// Fills the table that best_known_table() returns; the range must be valid.
  BestKnownTable(const Registry& registry, const CellRange& range, Stored stored);

  [[nodiscard]] const CellRange& range() const { return range_; }

  /// All cells, by kind (circular first), k, v.
  [[nodiscard]] const std::vector<KnownCell>& cells() const { return cells_; }

  /// The cell of these parameters.
  /// @throws BadInput if it is outside the range.
  [[nodiscard]] const KnownCell& at(const Parameters& p) const;

 private:
  [[nodiscard]] std::optional<std::size_t> index(const Parameters& p) const;

  CellRange range_;
  std::vector<KnownCell> cells_;
};

/// Plans a range.
/// @throws ImpossibleParameters if the range is empty, has k < 2 or v > 1000, or more than 10⁶
/// cells; InternalError if a construction does not keep its promise.
[[nodiscard]] BestKnownTable best_known_table(const Registry& registry, const CellRange& range,
                                              Stored stored = Stored::as_shipped);

/// The best recipe that is known for p: the answer that each door gives. Beyond strength 2, k ≥ 2
/// and v ≤ 1000 that is the registry's best offer; else also what the closure rules make of the
/// parameters around. nullopt if nothing serves p. @throws as check(); InternalError as
/// best_known_table().
[[nodiscard]] std::optional<Offer> best_known(const Registry& registry, const Parameters& p);

/// The design of an offer of the standard registry, built. Listens to the scope of this thread
/// (run/control.hpp).
/// @throws MissingResource if it is too large; InternalError if it does not verify.
[[nodiscard]] VerifiedDesign built_design(const Offer& offer);

/// The best design that is known without search, built; nullopt if there is no recipe. @throws as
/// best_known() and built_design().
[[nodiscard]] std::optional<VerifiedDesign> best_known_design(const Parameters& p);

}  // namespace changeover
