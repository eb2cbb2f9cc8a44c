// Enumerates all designs with given parameters and number of blocks, each once up to renaming its
// elements.
//
//     RunControl control({.threads = 2});
//     auto result = enumerate_designs({.v = 12, .k = 4, .change = 1}, 21, control,
//                                     [&](const Design&) { ++seen; });
//     result.forms;                     // 2554, if result.why_stopped is WhyStopped::exhausted
//
//     auto classes = classify_designs({.v = 9, .k = 4, .change = 1, .kind = Kind::circular}, 12,
//                                     {}, control);
//     classes.standard_forms;           // 16 sequences
//     classes.classes;                  // 2 [McSorley1999]
//
// A *standard form* is a sequence of blocks up to renaming elements (isomorphism/isomorphism.hpp).
// A circular design of b blocks has b rotations, which are b standard forms unless it has
// symmetries; a design and its reversal are two standard forms, too. A *class* is the set of
// designs that are the same up to renaming, rotation (if circular) and, on request, reversal.
//
// Method: depth first, one block after another. Elements that were in the same blocks so far are
// twins; of twins the lowest come first into a block, so each standard form occurs exactly once. A
// partial design is pruned as soon as
//   excess   pairs were covered repeatedly more often than b blocks allow;
//   degree   the introductions and stays in the remaining blocks cannot cover what each element
//            misses: the least excess that whole numbers of them cause, summed over the elements,
//            is too large (with prices of 0 to 3 for an introduction, as their total is known);
//   reach    some missing pair is in no set of k elements whose other pairs are within the limit: a
//            covered pair that was separated adds to the excess when it meets again.
//
// A circular design has its last unchanged subset fixed from the start. Classes of circular designs
// are found from sequences that begin with a longest run, in which nothing stays longer. Designs
// with f ≥ 2 elements in every block, whose pairs are never newly covered, are made from designs on
// v − f elements.
//
// Contract. Strength 2, v ≤ 64, b ≤ 4096. Every design passes verify() before it is passed on. The
// order of the designs and all counts are independent of the number of threads, unless a limit
// stopped the search. Each of several processes takes the prefixes of its WorkShare; their counts
// add up.
//
// Time: exponential in b. Tight designs are easy up to v ≈ 13; every unit of excess costs a factor
// of about 5 to 20.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

/// The largest v and b of an enumeration.
inline constexpr std::uint64_t max_enumeration_elements = 64;
inline constexpr std::uint64_t max_enumeration_blocks = 4096;

struct EnumerationRun {
  /// `exhausted` if all standard forms were found; otherwise what stopped the search: there may be
  /// more forms.
  WhyStopped why_stopped = WhyStopped::running;
  std::uint64_t forms = 0;          ///< standard forms passed on
  std::uint64_t nodes = 0;          ///< partial designs that were not pruned
  std::uint64_t prefixes = 0;       ///< number of parts of the work, over all shares; 0 if it
                                    ///< stopped before it was cut into them
  std::uint64_t prefixes_done = 0;  ///< parts that this share explored to their end
};

/// Passes every standard form of a design with exactly b blocks to `on_design`, one at a time,
/// never from two threads at once. Zero forms are not an error. @throws ImpossibleParameters as
/// check(), and if the strength is not 2 or v or b is too large; and what `on_design` throws.
EnumerationRun enumerate_designs(const Parameters& p, std::uint64_t b, RunControl& control,
                                 const std::function<void(const Design&)>& on_design = {});

/// One class of equivalent designs.
struct DesignClass {
  Design representative;        ///< the canonical form of the class
  std::uint64_t forms = 0;      ///< standard forms in the class
  std::string group_order;      ///< of the automorphism group, in decimal
  std::uint64_t rotations = 1;  ///< rotations that are automorphisms, including the identity
  bool reflections = false;  ///< whether a reversal is an automorphism; only if reversal is allowed
  std::uint64_t fixed = 0;   ///< number of elements that are in every block
  bool tight = false;
  bool economical = false;
};

struct ClassifyOptions {
  bool reversal = false;     ///< whether a design and its reversal are in the same class
  std::uint64_t keep = 100;  ///< number of classes to keep in the result; all are counted
  /// Called for every class, in a fixed order, never from two threads at once.
  std::function<void(const DesignClass&)> on_class = {};
};

struct Classification {
  WhyStopped why_stopped = WhyStopped::running;
  std::uint64_t standard_forms = 0;  ///< in all classes found
  std::uint64_t classes = 0;
  std::uint64_t tight = 0;  ///< classes of tight designs
  std::uint64_t nodes = 0;
  /// Number of parts of the work: further shares would have nothing to do. 0 if it stopped before
  /// it was cut into them.
  std::uint64_t prefixes = 0;
  std::uint64_t prefixes_done = 0;  ///< parts that this share explored to their end
  std::map<std::string, std::uint64_t> group_orders = {};  ///< number of classes by group order
  std::vector<DesignClass> kept;                           ///< the first `keep` classes
};

/// Finds the classes of designs with exactly b blocks. Memory does not grow with the number of
/// classes, since classes are told apart without storing them. @throws as enumerate_designs().
[[nodiscard]] Classification classify_designs(const Parameters& p, std::uint64_t b,
                                              const ClassifyOptions& options, RunControl& control);

}  // namespace changeover
