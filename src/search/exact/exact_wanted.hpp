// What is wanted of a design besides (search/wanted.hpp), as clauses of its formula.
//
//   - Elements of the first and of the last block are unit clauses.
//   - Given blocks: one variable for each place where they may begin, which implies their elements;
//     one of these variables holds. A circular list is turned so that they begin in its first
//     block: then they are unit clauses.
//   - Unchanged subsets: s(i) chooses the step from block i to the next one, and w(i,e) says that
//     the step is chosen and both blocks hold e. An element of `first` or `last` is in no chosen
//     step. Each other element has w in exactly one step. So the number of chosen steps is known;
//     it is required, too, and the first of these requirements follows from it.
//
// These clauses are the definition of what is wanted. The others of the formula are true of every
// design, but for the order of the columns: elements may be renamed only where that leaves alone
// what is wanted. Elements are *alike* if they are in the same ones of `first`, `last` and the
// given blocks. Renaming among them changes neither these sets nor which elements have to be in a
// part, so the order of columns is required of elements that are alike, and of no others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "changeover/core/parameters.hpp"
#include "changeover/search/wanted.hpp"
#include "search/sat/cnf.hpp"

namespace changeover {

/// The next greater element that is alike, for each element; p.v for the last one of a class.
[[nodiscard]] std::vector<std::uint64_t> next_alike(const Parameters& p, const Wanted& wanted);

/// The variables of what is wanted in a formula.
struct WantedVariables {
  std::vector<Literal> begins = {};  ///< the given blocks begin at block i; empty if units say it
  std::vector<Literal> chosen = {};  ///< the step from block i to the next one is chosen
};

/// Adds the clauses to the formula of b ≥ 1 blocks. `holds` gives the literal for "block holds
/// element". Needs wanted_defect() to find none. O(vb) clauses and those of the counts.
[[nodiscard]] WantedVariables add_wanted(
    Cnf& cnf, const Parameters& p, std::uint64_t b, const Wanted& wanted,
    const std::function<Literal(std::uint64_t block, std::uint64_t element)>& holds);

/// The size of what add_wanted() adds. @throws ImpossibleParameters if 64 bits do not hold it.
[[nodiscard]] CnfSize wanted_size(const Parameters& p, std::uint64_t b, const Wanted& wanted);

/// What the variables mean, a line each, for readers of the formula.
[[nodiscard]] std::vector<std::string> lines_of(const WantedVariables& variables);

}  // namespace changeover
