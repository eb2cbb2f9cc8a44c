// A propositional formula in conjunctive normal form.
//
//     Cnf cnf;
//     const Literal a = cnf.new_variable(), b = cnf.new_variable();
//     cnf.add({a, b});                     // a or b
//     cnf.add({-a, -b});                   // not both
//     write_dimacs(cnf, {}, {"exactly one of two"}, sink);
//
// Literals are as in DIMACS: variables are 1, 2, …, their negations −1, −2, …
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/io/output.hpp"

namespace changeover {

// The size of a formula, counted before it is built, and the memory needed to decide it.
//
//     CnfSize size = design_formula_size(p, b);  // search/exact/exact_encoding.hpp
//     size += exactly_size(30, 5);               // search/sat/cardinality.hpp
//     control.require_memory(solving_bytes(size, {.proof = true}), "the formula of DCCD(60,5)");
//
// Counts are exact: the formula built afterwards has as many variables, clauses and literals. Bytes
// are an upper estimate for large formulas, with measured constants (src/search/sat/cnf_size.cpp).
// What a solver learns comes on top of it; compared with a large formula it is little.

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

/// A variable, or its negation.
using Literal = std::int32_t;

class Cnf {
 public:
  /// The next variable, a positive number. @throws MissingResource beyond most_variables.
  Literal new_variable();

  /// Adds a clause: at least one of the literals holds. An empty clause makes the formula
  /// unsatisfiable. @throws InternalError if a literal is 0 or has no variable; MissingResource
  /// beyond most_literals.
  void add(std::span<const Literal> clause);
  void add(std::initializer_list<Literal> clause) { add({clause.begin(), clause.size()}); }

  /// Reserves memory for a formula of this size, so that it is never held twice while it grows.
  void reserve(const CnfSize& size);

  [[nodiscard]] std::size_t variables() const { return variables_; }
  [[nodiscard]] std::size_t clauses() const { return clauses_; }
  [[nodiscard]] CnfSize size() const { return {variables_, clauses_, literals_.size()}; }

  /// The clauses one after another, each ended by 0.
  [[nodiscard]] std::span<const Literal> literals() const { return literals_; }

 private:
  std::vector<Literal> literals_;
  std::size_t variables_ = 0;
  std::size_t clauses_ = 0;
};

/// Writes the formula in DIMACS: the comments, one per line, the header, the clauses, and
/// `assumptions` as unit clauses. @throws as Sink::write().
void write_dimacs(const Cnf& cnf, std::span<const Literal> assumptions,
                  const std::vector<std::string>& comments, Sink& sink);

}  // namespace changeover
