// The symmetries of a design: all maps that carry it to itself.
//
//     const AutomorphismGroup group = automorphisms(design);
//     group.order;                  // "11" for the cyclic circular DCCD(11,4,11)
//     group.rotations;              // 11: every rotation of the blocks extends to the elements
//     group.generators;             // maps to check with carries(map, design, design)
//
// A map is known by what it does to positions, up to exchanging twins (elements that are in the same
// blocks). So the group has (number of rotations and reflections that extend to the elements) times
// (product of n! over the classes of n twins) members, and nothing has to be searched but rotations.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/isomorphism/isomorphism.hpp"

namespace changeover {

struct AutomorphismGroup {
  std::string order;            ///< exact, in decimal
  std::uint64_t rotations = 1;  ///< rotations of the blocks, the identity among them, that extend
  bool reflections = false;     ///< whether a reversal extends; then as many as rotations do
  std::vector<std::vector<Element>> twins;  ///< classes of two or more elements, each increasing
  /// Generate the group: exchanges of two twins, the shortest rotation, one reversal. Each is checked.
  std::vector<Isomorphism> generators;

  /// How many position maps extend to elements.
  [[nodiscard]] std::uint64_t position_maps() const { return rotations * (reflections ? 2 : 1); }
};

/// The maps of the kind that `same` allows. O(n·bk) as find_isomorphism(), and O(v) for each twin.
/// @throws InternalError if a generator fails its check.
[[nodiscard]] AutomorphismGroup automorphisms(const Design& design, const Sameness& same = {});

/// How many standard forms the class of the design has: rotations and reversals that differ by more than
/// the names of elements. b, or 2b with reversal, over position_maps() if circular; 1 or 2 if linear.
/// `group` must be that of the design under `same`. O(1).
[[nodiscard]] std::uint64_t standard_forms_in_class(const Design& design,
                                                    const AutomorphismGroup& group,
                                                    const Sameness& same = {});

}  // namespace changeover
