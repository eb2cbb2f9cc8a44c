// What an experimenter wants: parts to be tested in pairs, room for some of them at once, and what a
// test and a change cost.
//
//     Job job = make_job(9, 3, parse_amount("1"), parse_amount("5"));   // nine parts, three at a time
//     job.never.insert(2, 7);                                           // these two must not meet …
//     job.needed = all_pairs_but(job.never);                            // … and all others must
//     check(job);
//
// A *set-up* is a set of at most `at_once` parts that are mounted together and tested once. A list of
// set-ups does the job if every needed pair is in some set-up, no pair of `never` is in any, and the
// `mounted` parts are in all. It costs
//     (number of set-ups) · test_cost + Σ over all introductions of the change cost of the part,
// where a part is introduced in a set-up if it was not in the one before; the first set-up introduces all
// its parts but those of `start`, which are on the bench already. Taking parts out costs nothing. These
// are the costs of [ChafeeStevens2025, Section 1].
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/pair_set.hpp"
#include "changeover/plan/amount.hpp"

namespace changeover {

/// The most parts of a job.
inline constexpr std::uint64_t max_parts = 1000;

struct Job {
  std::vector<std::string> names;    ///< of the parts, which are the elements 0, 1, …
  std::uint64_t at_once = 0;         ///< how many parts fit
  Amount test_cost;                  ///< of running one test
  std::vector<Amount> change_costs;  ///< of mounting each part once
  PairSet needed{0};                 ///< pairs that must meet
  PairSet never{0};                  ///< pairs that must not be in one set-up
  Block mounted;                     ///< parts that are in every set-up
  Block start;                       ///< parts that are mounted before the first test
  std::uint64_t tests_done = 0;      ///< tests before the first; only for numbering

  [[nodiscard]] std::uint64_t parts() const { return names.size(); }
  /// The most parts that a set-up can have: at_once, however large, but no more than there are.
  [[nodiscard]] std::uint64_t room() const { return at_once < parts() ? at_once : parts(); }
  /// All change costs are the same.
  [[nodiscard]] bool one_change_cost() const;
};

/// Why a text cannot stand on a run sheet, as the name of a part or as its title: it is not UTF-8, or has
/// control characters or those that turn the direction of writing around, which would make a sheet say
/// something else than it holds. Nothing if it can.
[[nodiscard]] std::optional<std::string> text_defect(std::string_view text);

/// A job with parts "1", …, "v" in which all pairs must meet. @throws BadInput if v > max_parts.
[[nodiscard]] Job make_job(std::uint64_t v, std::uint64_t at_once, Amount test_cost,
                           Amount change_cost);

/// All pairs of elements but these. O(v²).
[[nodiscard]] PairSet all_pairs_but(const PairSet& pairs);

/// Why no list of set-ups can do the job, or why the job is malformed: a line for each reason, at most
/// ten; none if there is one. The reasons are complete: without one, a set-up for each needed pair, of
/// this pair and the mounted parts, does the job. O(v²).
[[nodiscard]] std::vector<std::string> defects(const Job& job);

/// @throws BadInput with the first of defects() and how many more there are.
void check(const Job& job);

/// Takes tests that were already done off a job: their pairs are needed no more, and unless the job says
/// what is mounted at the start, the last of them is. @throws BadInput if one is larger than at_once, has a
/// part twice or names none of the parts; the job is then as it was. O(v² + tests · at_once · v/64). Stopped
/// if the scope of this thread (run/scope.hpp) wants to stop; the job is then as it was.
void mark_done(Job& job, const std::vector<Block>& setups);

}  // namespace changeover
