// Lists of blocks that are not designs yet: repair them, or complete them.
//
//     RunControl control({.time = std::chrono::seconds(10)});
//     RepairResult mended = repair(list, {}, control);       // few blocks changed
//     mended.kept;  mended.design->block_count();
//
//     ExtendResult longer = extend(beginning, {.blocks = 40}, control);   // the beginning stays
//     longer.design;  longer.why_stopped;
//
// *Repair* takes any list of blocks of the right shape. First its steps: a block that fits neither
// of its neighbours is replaced by the one nearest to it that fits both, a repeated block goes, and
// across any other wrong step the shortest way is inserted (construct/tools/path.hpp). Then what is
// uncovered: the list is annealed (local_search.hpp), briefly first, as every move changes blocks,
// and longer only if that does not do; if nothing does, blocks are added at the end.
//
// *Extend* keeps the given blocks as the first ones, in their order, and appends as few as it can
// until everything is covered: it anneals what follows the given blocks, with ever fewer blocks.
//
// Both use one thread and are deterministic in the seed while no clock stops them. When they are
// stopped they have a second to finish the simple way, by adding blocks; if that takes longer there
// is no design, never an unfinished one. A list too large for annealing is completed the simple way
// at once. Every result is verified.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "changeover/core/design.hpp"
#include "changeover/run/control.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover {

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
      {};  ///< altogether, that are enough; nothing: as few as possible
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
