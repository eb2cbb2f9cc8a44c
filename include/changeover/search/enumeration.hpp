// All designs with given parameters and number of blocks, each once up to the names of its
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
// A *standard form* is a sequence of blocks up to renaming elements (isomorphism/isomorphism.hpp):
// the b rotations of a circular design are b standard forms unless it has symmetries, and so are a
// design and its reversal. A *class* holds the designs that are the same up to renaming, rotation
// (if circular) and, if asked for, reversal.
//
// How it searches. Block after block, depth first. Elements that were in the same blocks so far are
// twins, and of twins the lowest come first into a block, so each standard form is met exactly
// once. A partial design is given up as soon as
//   excess   the pairs that were covered again exceed what b blocks can afford;
//   degree   some whole numbers of introductions and stays within the blocks left must cover what
//            is missing at each element, and at each element this costs an excess; the sum is too
//            large (with prices of 0 to 3 for an introduction, as their total is known);
//   reach    some missing pair is in no set of k elements whose other pairs can be afforded: a
//            covered pair that has been separated costs an excess when it meets again.
// A circular design fixes its last unchanged subset from the start. Classes of circular designs are
// found from sequences that begin a longest run, in which nothing stays longer. Designs with f ≥ 2
// elements in every block, whose pairs are never newly covered, come from designs on v − f
// elements.
//
// Contract. Strength 2, v ≤ 64, b ≤ 4096. Every design passes verify() before it is handed out.
// Designs come in an order that does not depend on the number of threads; so do all counts, unless
// a limit stopped the search. Of several processes each takes the prefixes of its WorkShare: their
// counts add up.
//
// Bound by: exponential in b. Tight designs are easy up to v ≈ 13; every unit of excess costs a
// factor of about 5 to 20.
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
  /// exhausted: these are all; otherwise what stopped the search, and these are some.
  WhyStopped why_stopped = WhyStopped::running;
  std::uint64_t forms = 0;     ///< standard forms handed out
  std::uint64_t nodes = 0;     ///< partial designs that were not given up at once
  std::uint64_t prefixes = 0;  ///< into which the work was split, over all shares
};

/// Hands out every standard form of a design with exactly b blocks, one at a time, never by two
/// threads at once. Nothing is no error: zero forms. @throws ImpossibleParameters as check(), and
/// if the strength is not 2 or v or b is too large; whatever `on_design` throws.
EnumerationRun enumerate_designs(const Parameters& p, std::uint64_t b, RunControl& control,
                                 const std::function<void(const Design&)>& on_design = {});

/// One class of designs that are the same.
struct DesignClass {
  Design representative;        ///< the canonical form of the class
  std::uint64_t forms = 0;      ///< standard forms in the class
  std::string group_order;      ///< of the automorphism group, in decimal
  std::uint64_t rotations = 1;  ///< rotations that are automorphisms, the identity among them
  bool reflections = false;     ///< whether a reversal is one; only if reversal is allowed
  std::uint64_t fixed = 0;      ///< elements in every block
  bool tight = false;
  bool economical = false;
};

struct ClassifyOptions {
  bool reversal = false;     ///< whether a design and its reversal are the same
  std::uint64_t keep = 100;  ///< how many classes to keep in the answer; all are counted
  /// Called for every class, in a fixed order, never by two threads at once.
  std::function<void(const DesignClass&)> on_class = {};
};

struct Classification {
  WhyStopped why_stopped = WhyStopped::running;
  std::uint64_t standard_forms = 0;  ///< over all classes found
  std::uint64_t classes = 0;
  std::uint64_t tight = 0;  ///< classes of tight designs
  std::uint64_t nodes = 0;
  std::uint64_t prefixes = 0;  ///< into which the work was split: more shares have nothing to do
  std::map<std::string, std::uint64_t> group_orders = {};  ///< how many classes have each order
  std::vector<DesignClass> kept;                           ///< the first `keep` classes
};

/// The classes of designs with exactly b blocks. Nothing has to be remembered to tell classes
/// apart, so memory does not grow with their number. @throws as enumerate_designs().
[[nodiscard]] Classification classify_designs(const Parameters& p, std::uint64_t b,
                                              const ClassifyOptions& options, RunControl& control);

}  // namespace changeover
