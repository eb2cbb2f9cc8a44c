// "There is a change covering design with these parameters and b blocks" as a formula.
//
//     const DesignFormula formula = encode_design({.v = 9, .k = 4, .change = 1}, 11);
//     formula.cnf();                          // no solution: no linear SCCD(9,4) has 11 blocks
//     formula.decode(is_true);                // the blocks of a solution
//
// Variables x(i,e): block i holds element e. Clauses, for any m, both kinds and strength t:
//   - every block has k elements; m are introduced and m leave at every step, the one from the last
//     block to the first included if the design is circular and b > 1;
//   - every t-subset is in some block: one variable for each block and t-subset, which implies its
//     elements, and one clause for each t-subset.
// These clauses are the definition. The following ones keep at least one design, if there is any:
//   - *order*: the columns x(·,0), x(·,1), … are in decreasing lexicographic order. Elements of any
//     design can be renamed so; this fixes the first two blocks. If something is wanted besides,
//     only the columns of elements that are alike are ordered (exact_wanted.hpp).
//   - *degrees*: an element x that is introduced i times and is in r blocks newly meets
//     i·C(k−1,t−1) + (r − i)·(C(k−1,t−1) − C(k−1−m,t−1)) t-subsets. Each of the C(v−1,t−1) must be
//     met at least once, except those that consist of fixed elements of a circular design. So i and
//     r are counted, and r is at least what i leaves. The total of newly covered t-subsets is
//     known, so no element can have more repetitions than all have together, less those that the
//     others must have.
//   - *budget*: for pairs, if few repetitions are possible, each newly covered pair has a variable
//     and the repetitions are counted.
// A pair of elements that are in every block of a circular design is never newly covered; where
// counting does not exclude two such elements, the clauses of the last two kinds allow for them or
// are left out.
//
// docs/trust.md says what remains to be trusted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/search/exact.hpp"
#include "changeover/search/wanted.hpp"
#include "search/exact/exact_wanted.hpp"
#include "search/sat/cnf.hpp"

namespace changeover {

class DesignFormula {
 public:
  /// Has no clauses yet; encode_design() adds them.
  DesignFormula(const Parameters& p, std::uint64_t b) : parameters_(p), b_(b) {}

  /// The variables of what is wanted besides.
  [[nodiscard]] const WantedVariables& wanted() const { return wanted_; }
  [[nodiscard]] WantedVariables& wanted() { return wanted_; }

  [[nodiscard]] const Parameters& parameters() const { return parameters_; }
  [[nodiscard]] std::uint64_t blocks() const { return b_; }
  [[nodiscard]] const Cnf& cnf() const { return cnf_; }
  [[nodiscard]] Cnf& cnf() { return cnf_; }

  /// The literal for "block `block` contains `element`", both from 0.
  [[nodiscard]] Literal holds(std::uint64_t block, std::uint64_t element) const {
    return static_cast<Literal>(block * parameters_.v + element + 1);
  }

  /// The design of a solution; nothing is verified. @throws BadInput if a block does not have k
  /// elements.
  [[nodiscard]] Design decode(const std::function<bool(Literal)>& is_true) const;

  /// The positions of the unchanged subsets that a solution chose, as parts_as_wanted() takes them.
  [[nodiscard]] std::vector<std::size_t> chosen_positions(
      const std::function<bool(Literal)>& is_true) const;

 private:
  Parameters parameters_;
  std::uint64_t b_;
  Cnf cnf_;
  WantedVariables wanted_;
};

/// The exact size of the formula of encode_design(), without building it. @throws
/// ImpossibleParameters as check(); MissingResource if Cnf cannot hold it. O(b) at worst, and then
/// b is below 10⁸.
[[nodiscard]] CnfSize design_formula_size(const Parameters& p, std::uint64_t b,
                                          const EncodingOptions& options = {},
                                          const Wanted& wanted = {});

/// A name for messages: "the formula of DCCD(60,5) with 253 blocks".
[[nodiscard]] std::string formula_name(const Parameters& p, std::uint64_t b);

/// The formula for exactly b ≥ 1 blocks, with O(b·C(v,t)) clauses and those of the counts. @throws
/// as design_formula_size(), and Stopped as stop_if_asked().
[[nodiscard]] DesignFormula encode_design(const Parameters& p, std::uint64_t b,
                                          const EncodingOptions& options = {},
                                          const Wanted& wanted = {});

}  // namespace changeover
