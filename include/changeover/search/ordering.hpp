// Orderings: given blocks, in which order do they change as wanted, or as little as possible.
//
//     RunControl control({.time = std::chrono::seconds(10)});
//     // The 12 blocks of a Steiner triple system on 9 points, consecutive ones sharing one point:
//     const ChangeOrder order = order_for_change(triples, {.v = 9, .m = 2, .kind = Kind::circular},
//                                                {}, control);
//     if (order.outcome == Outcome::found) {
//       arranged(triples, order.order);
//     }
//
//     // Batches of any sizes, as few loads in total as possible:
//     const LeastChangeOrder least = order_for_least_change(batches, {.v = 5000}, {}, control);
//     least.cost;              // elements introduced in all, the first block's included
//     least.lower_bound;       // no order has less
//
// order_for_change looks for a Hamiltonian path (linear) or cycle (circular) in the graph of the
// pairs of blocks that differ in exactly m elements: first by rotations and extensions of a path
// [Posa1976], then, for few blocks, by SAT with a cut for every set of blocks that a model leaves
// by itself. That answers "none" too: as the solver's statement, or with a reason that is a short
// argument.
//
// order_for_least_change is a travelling salesman problem. A step from A to B costs |B∖A| = |B| −
// |A∩B|, the elements introduced. That is not symmetric if sizes differ, but a whole order costs
// the sum of all sizes less the overlaps of neighbours (and less the first block's size if that is
// free), so only the choice of the first block depends on the direction. Up to `exact_blocks`
// blocks: dynamic programming over sets [HeldKarp1962]. Beyond: nearest neighbours, then 2-opt and
// Or-opt moves with neighbour lists, then random double bridges in a small window, kept unless they
// are worse [JohnsonMcGeoch1997]. The lower bound is that of spanning trees, with multipliers where
// time allows [HeldKarp1970].
//
// Every order is recounted from the blocks before it is returned. The same seed and step limits
// give the same order. One thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

/// The blocks in the given order. @throws BadInput if a place is not below the number of blocks.
[[nodiscard]] std::vector<Block> arranged(std::span<const Block> blocks,
                                          std::span<const std::size_t> order);

/// What is asked of neighbours.
struct ChangeWanted {
  std::uint64_t v = 0;         ///< elements are below v
  std::uint64_t m = 2;         ///< elements in which neighbours differ, at least 1
  Kind kind = Kind::circular;  ///< circular: the last and the first block are neighbours too
};

struct ChangeOrderOptions {
  std::uint64_t rotations = 2'000'000;  ///< of the path, at most
  std::size_t sat_blocks = 150;         ///< SAT for at most so many blocks
  std::uint64_t conflicts = 1'000'000;  ///< of the SAT solver, at most
};

struct ChangeOrder {
  Outcome outcome = Outcome::unknown;
  std::vector<std::size_t> order;  ///< places in the input, if found
  std::string reason;              ///< why none, in one line
  std::uint64_t rotations = 0;
  std::uint64_t conflicts = 0;
  WhyStopped why_stopped = WhyStopped::running;
};

/// An order in which consecutive blocks differ in exactly m elements. A single block is in order.
/// @throws BadInput if there is no block, or blocks are not distinct elements below v, of one size;
/// ImpossibleParameters if m is 0. O(b²·v/64) for the graph.
[[nodiscard]] ChangeOrder order_for_change(std::span<const Block> blocks,
                                           const ChangeWanted& wanted,
                                           const ChangeOrderOptions& options, RunControl& control);

/// What is to be least.
struct LeastChangeWanted {
  std::uint64_t v = 0;  ///< elements are below v
  Kind kind = Kind::linear;
  /// The elements of the first block of a linear order count as introduced; as a run must load
  /// them.
  bool first_counts = true;
};

struct LeastChangeOptions {
  std::size_t exact_blocks = 15;             ///< dynamic programming up to here; at most 20
  std::size_t neighbours = 12;               ///< of each block, in the local search
  std::optional<std::uint64_t> kicks = {};   ///< double bridges; nothing: 50 a block
  std::uint64_t bound_effort = 300'000'000;  ///< overlaps counted for the lower bound, about
};

struct LeastChangeOrder {
  std::vector<std::size_t> order;  ///< places in the input
  std::uint64_t cost = 0;          ///< elements introduced in all
  std::uint64_t lower_bound = 0;   ///< of the cost of any order
  std::uint64_t first_cost = 0;    ///< of the blocks in the order in which they were given
  std::uint64_t kicks = 0;
  WhyStopped why_stopped = WhyStopped::running;  ///< exhausted: the order is a least one

  [[nodiscard]] bool least() const { return cost == lower_bound; }
};

/// An order that introduces few elements. Blocks may be of different sizes, empty, or repeated.
/// @throws BadInput if there is no block, or a block is not distinct elements below v;
/// MissingResource if the blocks as bit sets would need more than 4 GiB. O(2ᵇb²) up to
/// `exact_blocks`, beyond that O(b²·v/64) at worst, besides the kicks and the lower bound.
[[nodiscard]] LeastChangeOrder order_for_least_change(std::span<const Block> blocks,
                                                      const LeastChangeWanted& wanted,
                                                      const LeastChangeOptions& options,
                                                      RunControl& control);

/// What an order costs, counted from the blocks: elements introduced, from the last to the first
/// block too if it is circular. @throws BadInput unless `order` is a permutation of the blocks. O(b
/// + sizes).
[[nodiscard]] std::uint64_t change_cost(std::span<const Block> blocks,
                                        std::span<const std::size_t> order,
                                        const LeastChangeWanted& wanted);

}  // namespace changeover
