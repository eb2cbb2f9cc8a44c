// Better designs by local search, for parameters beyond the reach of exact methods.
//
//     RunControl control({.time = std::chrono::seconds(60), .seed = 7});
//     ImproveResult found = improve({.v = 30, .k = 6, .change = 2}, {.moves = 1'000'000}, control);
//     found.design->block_count();          // at most found.started_from, the best that was known
//     found.how;                            // "best recipe", or how a better one was found
//     found.why_stopped;                    // a limit, here that of the moves
//
// Contract. The result is verified, and has at most as many blocks as the best known recipe
// (construct/best_known.hpp). If there is no memory for the search, or v is too large for it, the
// design of that recipe is returned and `unsearched` says why. There is no result only if `control`
// stops a second before that design is built. The search aims for `target` blocks, or for the lower
// bound. With one thread and a limit of moves the result depends only on the parameters, the
// options and the seed.
//
// Method. Kinds of attempts compete, each with a budget of moves that doubles when it fails:
//   - blocks without symmetry, from random lists (internal: src/search/local/), at two ranges of
//     temperature;
//   - the best design so far less one block, annealed at lower temperatures;
//   - for linear designs, the best circular one known, begun at each of its blocks in turn, without
//     as many blocks at the end as are too many, annealed at the lowest temperatures;
//   - base blocks under an imposed automorphism, for every order n and 0 to 2 fixed
//     elements on v elements, and without fixed elements on v + 1 … v + 3, whose designs are
//     truncated. A linear design is cut from the circular one where fewest blocks are needed.
//
// An attempt first aims far below the best design, and closer to it after each failure. The next
// attempt is the one that has cost least so far, weighted by how much it missed its aim the last
// time, so that more moves go where the aim is near. Threads take attempts from one list. Each of
// several processes starts at another place of the list and with other random numbers (WorkShare).
//
// Strength 3 and 4 use blocks without symmetry only. Time: the rate of moves,
// about 15 million per second and core at (30,6).
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/run/control.hpp"
#include "changeover/search/wanted.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover {

struct ImproveOptions {
  std::optional<std::uint64_t> target =
      {};  ///< number of blocks that is enough; nullopt: the lower bound
  std::optional<std::uint64_t> moves = {};  ///< limit for the moves of this run, over all threads
  std::optional<Design> start = {};         ///< a known design besides the recipes; must be valid
  bool imposed = true;                      ///< whether to try automorphisms
  std::string checkpoint =
      {};  ///< file to continue from and to write to (checkpoint.hpp); empty for none
  std::chrono::duration<double> checkpoint_interval{5.0};
};

struct ImproveResult {
  std::optional<VerifiedDesign> design;  ///< nullopt if stopped before there was one
  std::uint64_t lower_bound = 0;
  std::optional<std::uint64_t> started_from;  ///< blocks of the best design known beforehand
  std::string unsearched;                     ///< one line: why no attempt was made; else empty
  /// One line: why the checkpoint is behind the search; else empty.
  std::string checkpoint_fault;
  std::string how;  ///< one line: how the design was found; "best recipe" if not by this search
  std::uint64_t moves = 0;     ///< proposed, over all threads and, with a checkpoint, all runs
  std::uint64_t attempts = 0;  ///< annealing runs, likewise
  std::chrono::duration<double> elapsed{};       ///< of this run
  double moves_per_second = 0;                   ///< of this run, over all threads
  WhyStopped why_stopped = WhyStopped::running;  ///< `found` if the target is reached
};

/// Searches until the target is reached, or until `control` or the limit of moves stops it. Each
/// thread has its share of the memory that `control` allows; kinds of attempts that need more are
/// left out. v above 4096 is not searched. @throws ImpossibleParameters as check(), or if no such
/// design exists; BadInput if the start is not a valid design with these parameters, or for a
/// checkpoint of other parameters or a damaged one; MissingResource if no design fits into memory,
/// another process uses the checkpoint, or it cannot be written at the start (if that fails later
/// the search continues: checkpoint_fault); InternalError if a result fails verification.
[[nodiscard]] ImproveResult improve(const Parameters& p, const ImproveOptions& options,
                                    RunControl& control);

// Designs with a property that constructions need, found by local search with locked cells.
//
//     RunControl control({.time = std::chrono::seconds(20)});
//     LockedResult found =
//         search_locked({.v = 12, .k = 4, .change = 1},
//                       {.first = {0, 1, 2}, .expansion_set = true}, {.blocks = 21}, control);
//     found.design->block_count();  // 21
//     found.parts.size();           // 3: unchanged subsets that hold the nine other elements
//
// Concatenation, rings and expansion need more than few blocks: disjoint unchanged subsets that
// hold all elements except some of the first or of the last block. The search begins with the best
// of the known designs that have them, its elements renumbered. Then it draws places for such
// subsets and locks their cells in the blocks beside them; the other cells are annealed as above. A
// subset that a third block holds may move there. If all fails, the search draws other places.
// Given blocks (`contained`) are drawn beside a subset, and in the first or the last block where
// these have required elements, hardly ever. So only a design that is found means something.
//
// Time: the rate of moves, about 10 million per second and core at (20,5).

struct LockedOptions {
  std::optional<std::uint64_t>
      blocks{};  ///< the number that is enough, and the most; nullopt: as few as possible
  std::optional<std::uint64_t> moves{};  ///< limit for the moves, over all threads
  /// Begins with the best of the known designs that have the properties, if there is one; otherwise
  /// from random lists.
  bool from_known = true;
};

struct LockedResult {
  std::optional<VerifiedDesign> design;
  std::vector<UnchangedSubset> parts;  ///< of the design, with expansion_set
  std::uint64_t lower_bound = 0;
  bool known = false;          ///< the design was known before, renumbered
  std::uint64_t moves = 0;     ///< proposed, over all threads
  std::uint64_t attempts = 0;  ///< annealing runs
  std::chrono::duration<double> elapsed{};
  WhyStopped why_stopped = WhyStopped::running;
};

/// Searches until `blocks` or the lower bound is reached, or until `control` or the limit of moves
/// stops it. With one thread and a limit of moves the result depends only on the arguments and the
/// seed. v ≤ 4096. @throws BadInput if wanted_defect() finds one or v is larger;
/// ImpossibleParameters as check(), or if no design exists; MissingResource if the counters do not
/// fit into the memory that `control` allows; InternalError if a result lacks a property.
[[nodiscard]] LockedResult search_locked(const Parameters& p, const Wanted& wanted,
                                         const LockedOptions& options, RunControl& control);

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
  std::size_t sat_blocks = 150;         ///< SAT for at most this many blocks
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
  std::optional<std::uint64_t> kicks = {};   ///< double bridges; nullopt: 50 per block
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

// Lists of blocks that are not designs yet: repair them, or complete them.
//
//     RunControl control({.time = std::chrono::seconds(10)});
//     RepairResult mended = repair(list, {}, control);       // few blocks changed
//     mended.kept;  mended.design->block_count();
//
//     ExtendResult longer = extend(beginning, {.blocks = 40}, control);   // the beginning stays
//     longer.design;  longer.why_stopped;
//
// *Repair* takes any list of blocks of the right shape. If one change does (two blocks exchanged, a
// block elsewhere, one element, a block less), that is the answer. Else first its steps: a block
// that fits neither of its neighbours is replaced by the one nearest to it that fits both, a
// repeated block goes, and across any other wrong step the shortest way is inserted.
// Then what is uncovered: the list is annealed, briefly first, as every
// move changes blocks, and longer only if that does not do; if nothing does, blocks are added at
// the end.
//
// *Extend* keeps the given blocks as the first ones, in their order, and appends as few as it can
// until everything is covered: it anneals what follows the given blocks, with ever fewer blocks.
//
// Both use one thread and are deterministic in the seed while no clock stops them. When they are
// stopped they have a second to finish the simple way, by adding blocks; if that takes longer there
// is no design, never an unfinished one. A list too large for annealing is completed the simple way
// at once. Every result is verified.

struct RepairOptions {
  std::uint64_t moves = std::uint64_t{1} << 24;  ///< to anneal with, before blocks are added
};

struct RepairResult {
  /// With the labels of the list; nothing if stopped too early.
  std::optional<VerifiedDesign> design;
  std::uint64_t given = 0;      ///< blocks of the list
  std::uint64_t kept = 0;       ///< of them, those that are blocks of the design
  std::uint64_t bad_steps = 0;  ///< of the list
  std::uint64_t uncovered = 0;  ///< t-subsets that the list did not cover
  std::uint64_t moves = 0;
  std::string
      unsearched;  ///< why nothing was annealed though it should have been, in one line; else empty
  WhyStopped why_stopped = WhyStopped::running;  ///< `found`, or why blocks had to be added
};

/// A design that has much of the list. A valid list is returned as it is.
/// @throws ImpossibleParameters if there is no design with the list's parameters; BadInput if it
/// has no block; MissingResource if even its subsets cannot be counted in memory; InternalError if
/// the result fails verification. Bound by: options.moves.
[[nodiscard]] RepairResult repair(const Design& list, const RepairOptions& options,
                                  RunControl& control);

struct ExtendOptions {
  std::optional<std::uint64_t> blocks =
      {};  ///< altogether, that are enough; nullopt: as few as possible
  std::optional<std::uint64_t> moves = {};  ///< the most moves
};

struct ExtendResult {
  /// Begins with the given blocks; nothing if stopped too early.
  std::optional<VerifiedDesign> design;
  std::uint64_t lower_bound = 0;  ///< of any design that begins so, by counting
  std::uint64_t moves = 0;
  std::string unsearched;  ///< as in RepairResult
  /// `found`: as many blocks as are enough, or as the lower bound says.
  WhyStopped why_stopped = WhyStopped::running;
};

/// A design that begins with these blocks. Without a limit in `control` or `options` it ends only
/// when enough is found.
/// @throws BadInput if there is no block or a step is wrong, naming the first; ImpossibleParameters
/// MissingResource and InternalError as repair(). Bound by: the limits.
[[nodiscard]] ExtendResult extend(const Design& beginning, const ExtendOptions& options,
                                  RunControl& control);

}  // namespace changeover
