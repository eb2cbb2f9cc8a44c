// Encodes how many of some literals hold, and which of two lists of literals is greater.
//
//     // at_least[j] ⟺ j + 1 or more hold, j < 3
//     const auto at_least = unary_count(cnf, literals, 3);
//     require_exactly(cnf, literals, 2);
//
// Counts are unary and made by merging: the literals are halved, each half is counted, and the
// counts are added (a totalizer [BailleuxBoufkhad2003]). Unit propagation then finds every literal
// that a full or an exhausted count forces. O(n·limit·log n) clauses of at most three literals.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "search/sat/cnf.hpp"

namespace changeover {

/// Returns literals for "at least 1, 2, …, min(limit, n) of the given literals hold", encoded in
/// both directions. @throws as Cnf::add(), and Stopped as stop_if_asked(), like the other
/// functions.
[[nodiscard]] std::vector<Literal> unary_count(Cnf& cnf, std::span<const Literal> literals,
                                               std::size_t limit);

/// Requires that exactly `number` of the literals hold. If there are fewer literals, the formula
/// becomes unsatisfiable.
void require_exactly(Cnf& cnf, std::span<const Literal> literals, std::size_t number);

/// Requires that at most `number` of the literals hold.
void require_at_most(Cnf& cnf, std::span<const Literal> literals, std::size_t number);

/// Requires at most one of the literals. Pairwise if they are few, otherwise by a chain of new
/// variables.
void at_most_one(Cnf& cnf, std::span<const Literal> literals);

/// Requires a ≥ b as binary numbers of the same length, with the highest digit first.
void require_not_less(Cnf& cnf, std::span<const Literal> a, std::span<const Literal> b);

/// The size of what the first three functions add to a formula. @throws ImpossibleParameters if it
/// is beyond 64 bits. O(log² literals).
[[nodiscard]] CnfSize unary_count_size(std::uint64_t literals, std::uint64_t limit);
[[nodiscard]] CnfSize exactly_size(std::uint64_t literals, std::uint64_t number);
[[nodiscard]] CnfSize at_most_size(std::uint64_t literals, std::uint64_t number);

}  // namespace changeover
