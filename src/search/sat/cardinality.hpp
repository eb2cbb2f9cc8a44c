// How many of some literals hold, and which of two lists of them is greater, as a formula.
//
//     // at_least[j] ⟺ j + 1 or more hold, j < 3
//     const auto at_least = unary_count(cnf, literals, 3);
//     require_exactly(cnf, literals, 2);
//
// Counts are unary and made by merging: the literals are halved, each half is counted, and the
// counts are added (a totalizer [BailleuxBoufkhad2003]). Unit propagation alone then finds every
// literal that a full or an exhausted count forces. O(n·limit·log n) clauses of at most three
// literals.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "search/sat/cnf.hpp"

namespace changeover {

/// Literals that say whether at least 1, 2, …, min(limit, n) of the given ones hold, in both
/// directions.
/// @throws as Cnf::add(), and Stopped as stop_if_asked(), like the others.
[[nodiscard]] std::vector<Literal> unary_count(Cnf& cnf, std::span<const Literal> literals,
                                               std::size_t limit);

/// Exactly `number` of the literals hold. If that is more than there are, the formula has no
/// solution.
void require_exactly(Cnf& cnf, std::span<const Literal> literals, std::size_t number);

/// At most `number` of the literals hold.
void require_at_most(Cnf& cnf, std::span<const Literal> literals, std::size_t number);

/// At most one of the literals. Pairwise if they are few, else by a chain of new variables.
void at_most_one(Cnf& cnf, std::span<const Literal> literals);

/// a ≥ b as numbers in base 2, the first literal being the highest digit; of the same length.
void require_not_less(Cnf& cnf, std::span<const Literal> a, std::span<const Literal> b);

/// What the first three add to a formula, for so many literals. @throws ImpossibleParameters if it
/// is beyond 64 bits. O(log² literals).
[[nodiscard]] CnfSize unary_count_size(std::uint64_t literals, std::uint64_t limit);
[[nodiscard]] CnfSize exactly_size(std::uint64_t literals, std::uint64_t number);
[[nodiscard]] CnfSize at_most_size(std::uint64_t literals, std::uint64_t number);

}  // namespace changeover
