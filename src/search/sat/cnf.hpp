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
#include <vector>

#include "changeover/io/output.hpp"
#include "search/sat/cnf_size.hpp"

namespace changeover {

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
