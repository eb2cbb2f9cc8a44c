// The size of a formula, counted before it is built, and the memory needed to decide it.
//
//     CnfSize size = design_formula_size(p, b);  // search/exact/exact_encoding.hpp
//     size += exactly_size(30, 5);               // search/sat/cardinality.hpp
//     control.require_memory(solving_bytes(size, {.proof = true}), "the formula of DCCD(60,5)");
//
// Counts are exact: the formula built afterwards has as many variables, clauses and literals. Bytes
// are an upper estimate for large formulas, with measured constants (src/search/sat/cnf_size.cpp).
// What a solver learns comes on top of it; compared with a large formula it is little.
#pragma once

#include <cstdint>
#include <string_view>

namespace changeover {

/// The limits of search/sat/cnf.hpp.
inline constexpr std::uint64_t most_variables = 100'000'000;
inline constexpr std::uint64_t most_literals = std::uint64_t{1} << 31;

struct CnfSize {
  std::uint64_t variables = 0;
  std::uint64_t clauses = 0;
  std::uint64_t literals = 0;  ///< including the 0 that ends each clause, as in Cnf::literals()

  /// @throws ImpossibleParameters if a count does not fit in 64 bits, like the others.
  CnfSize& operator+=(const CnfSize& other);
  friend CnfSize operator+(CnfSize a, const CnfSize& b) { return a += b; }
  /// The size of `times` formulas of the same size.
  friend CnfSize operator*(std::uint64_t times, const CnfSize& size) { return size.times(times); }

  bool operator==(const CnfSize&) const = default;

 private:
  [[nodiscard]] CnfSize times(std::uint64_t factor) const;
};

/// `count` clauses of `length` literals each.
[[nodiscard]] CnfSize clauses_of(std::uint64_t count, std::uint64_t length);

/// How a formula is used.
struct SolvingNeeds {
  bool proof = true;     ///< a proof is written and checked
  bool split = false;    ///< it is split into cubes first
  unsigned threads = 1;  ///< solvers at the same time
};

/// Bytes for the formula and the programs that work on it: the solvers, or the checkers of their
/// proofs if these need more, or the splitter. The largest number if 64 bits do not hold it. O(1).
[[nodiscard]] std::uint64_t solving_bytes(const CnfSize& size, const SolvingNeeds& needs);

/// Checks that Cnf holds a formula of this size. @throws MissingResource with one line that begins
/// with `what`.
void require_representable(const CnfSize& size, std::string_view what);

}  // namespace changeover
