// Better designs by local search, beyond the reach of exact methods.
//
//     RunControl control({.time = std::chrono::seconds(60), .seed = 7});
//     ImproveResult found = improve({.v = 30, .k = 6, .change = 2}, {.moves = 1'000'000}, control);
//     found.design->block_count();          // at most found.started_from, the best that was known
//     found.how;                            // "best recipe", or how a better one was found
//     found.why_stopped;                    // a limit, here that of the moves
//
// Contract. The result is verified, and has no more blocks than the best recipe that is known (by
// construct/best_known.hpp), whatever happens: if there is no memory for the search, or v is too
// large for it, that design is handed out and `unsearched` says why. Only if `control` says stop a
// second before even that is built there is none. What is sought is a design with `target` blocks,
// or with as many as the lower bound says. With one thread and a limit of moves the answer depends
// on the parameters, the options and the seed alone.
//
// How. Three kinds of attempts compete, each with a budget of moves that doubles when it fails:
//   - blocks without any symmetry, from random lists (segment_pairs.hpp);
//   - the best design so far less one block, annealed at lower temperatures;
//   - base blocks under an imposed automorphism (imposed.hpp), for every order n and 0 to 2 fixed
//     elements on v elements, and without fixed elements on v + 1 … v + 3, whose designs are
//     truncated. A linear design is cut from the circular one where fewest blocks are needed.
// An attempt first aims far below the best design, and nearer when it fails. The next one is that
// which has cost least, weighted by how much it missed the last time, so that the budget goes where
// the goal is near. Threads take attempts from one list. Of several processes, each begins at
// another place of the list and with other random numbers (WorkShare).
//
// Strength 3 and 4 use blocks without symmetry only (segment_subsets.hpp). Bound by: the rate of
// moves, about 15 million a second a core at (30,6).
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/run/control.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover {

struct ImproveOptions {
  std::optional<std::uint64_t> target = {};  ///< blocks that are enough; nothing: the lower bound
  std::optional<std::uint64_t> moves = {};   ///< the most moves of this run, over all threads
  std::optional<Design> start = {};  ///< a design that is known besides the recipes; must be valid
  bool imposed = true;               ///< try automorphisms
  std::string checkpoint = {};       ///< a file to go on from and to write to (checkpoint.hpp)
  std::chrono::duration<double> checkpoint_interval{5.0};
};

struct ImproveResult {
  std::optional<VerifiedDesign> design;  ///< nothing if it was stopped before there was one
  std::uint64_t lower_bound = 0;
  std::optional<std::uint64_t> started_from;  ///< blocks of the best design known beforehand
  std::string unsearched;  ///< why no attempt was made at all, in one line; else empty
  /// Why the checkpoint is not as far as the search, in one line; else empty.
  std::string checkpoint_fault;
  std::string how;             ///< how the design was found, one line; "best recipe" if not here
  std::uint64_t moves = 0;     ///< proposals, over all threads and, from a checkpoint, all runs
  std::uint64_t attempts = 0;  ///< anneals, likewise
  std::chrono::duration<double> elapsed{};       ///< of this run
  double moves_per_second = 0;                   ///< of this run, over all threads
  WhyStopped why_stopped = WhyStopped::running;  ///< `found` if the target is reached
};

/// Searches until the target is reached or `control` or the limit of moves says stop. Of the memory
/// that `control` allows each thread has its share; kinds of attempts that need more are left out.
/// v above 4096 is not searched.
/// @throws ImpossibleParameters as check(), or if no such design exists; BadInput if the start is
/// not a valid design with these parameters, or for a checkpoint that is of other parameters or
/// damaged; MissingResource if no design fits into memory, or if another process works with the
/// checkpoint, or it cannot be written from the beginning (later the search goes on:
/// checkpoint_fault); InternalError if a result fails verification.
[[nodiscard]] ImproveResult improve(const Parameters& p, const ImproveOptions& options,
                                    RunControl& control);

// Designs with a property that constructions need, by local search with locked cells.
//
//     RunControl control({.time = std::chrono::seconds(20)});
//     LockedResult found =
//         search_locked({.v = 12, .k = 4, .change = 1},
//                       {.first = {0, 1, 2}, .expansion_set = true}, {.blocks = 21}, control);
//     found.design->block_count();  // 21
//     found.parts.size();           // 3: unchanged subsets that hold the nine other elements
//
// Concatenation, rings and expansion ask for more than few blocks: disjoint unchanged subsets that
// hold all elements but some of the first or of the last block. Places for such subsets are drawn,
// the blocks beside them hold them, and moves leave these cells as they are; all others are
// annealed as above. When that fails, other places are drawn.
//
// Bound by: the rate of moves, about 10 million a second a core at (20,5).

/// What a design is to have, all of it.
struct Wanted {
  Block first{};  ///< elements of the first block, at most k; linear designs only
  Block last{};   ///< elements of the last block
  bool expansion_set =
      false;  ///< unchanged subsets partition the elements not in `first` or `last`
  std::vector<Block>
      contained{};  ///< consecutive blocks, in this order or, if circular, across the end
};

/// Why no design with these parameters has it, or it makes no sense, in one line; else empty.
/// O(vk).
[[nodiscard]] std::string wanted_defect(const Parameters& p, const Wanted& wanted);

/// The unchanged subsets that partition the elements not in `first` or `last`, in order of
/// position; nullopt if `design` has not all that is wanted. `positions`: where the subsets are;
/// without expansion_set they are ignored. O(bk).
[[nodiscard]] std::optional<std::vector<UnchangedSubset>> parts_as_wanted(
    const Design& design, const Wanted& wanted, const std::vector<std::size_t>& positions);

struct LockedOptions {
  std::optional<std::uint64_t>
      blocks{};  ///< so many are enough, and no more are tried; nothing: as few as possible
  std::optional<std::uint64_t> moves{};  ///< the most moves, over all threads
};

struct LockedResult {
  std::optional<VerifiedDesign> design;
  std::vector<UnchangedSubset> parts;  ///< of the design, with expansion_set
  std::uint64_t lower_bound = 0;
  std::uint64_t moves = 0;     ///< proposals, over all threads
  std::uint64_t attempts = 0;  ///< anneals
  std::chrono::duration<double> elapsed{};
  WhyStopped why_stopped = WhyStopped::running;
};

/// Searches until `blocks`, or the lower bound, is reached or `control` or the limit of moves says
/// stop. With one thread and a limit of moves the answer depends on the arguments and the seed
/// alone. v ≤ 4096.
/// @throws BadInput if wanted_defect() finds one or v is larger; ImpossibleParameters as check(),
/// or if there is no design at all; MissingResource if the counters do not fit into the memory that
/// `control` allows; InternalError if a result is not as wanted.
[[nodiscard]] LockedResult search_locked(const Parameters& p, const Wanted& wanted,
                                         const LockedOptions& options, RunControl& control);

}  // namespace changeover
