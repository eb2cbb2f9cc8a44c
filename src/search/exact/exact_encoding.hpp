// "There is a change covering design with these parameters and b blocks" as a formula.
//
//     const DesignFormula formula = encode_design({.v = 9, .k = 4, .change = 1}, 11);
//     formula.cnf();                          // no solution: no linear SCCD(9,4) has 11 blocks
//     formula.decode(is_true);                // the blocks of a solution
//
// Variables x(i,e): block i holds element e. Clauses, for any m, both kinds and strength t:
//   - every block has k elements; m are introduced and m leave at every step, the one from the last
//     block to the first included if the design is circular and b > 1;
//   - every t-subset is in some block: one variable for each block and t-subset, which implies the
//     elements, and one clause for each t-subset.
// These alone are the definition. What follows leaves a design if there was one:
//   - *order*: the columns x(·,0), x(·,1), … are in decreasing lexicographic order. Elements can be
//     renamed so that they are, whatever the design; the first two blocks are thereby fixed.
//   - *degrees*: an element x that is introduced i times and is in r blocks meets i·C(k−1,t−1) + (r
//     − i)·(C(k−1,t−1) − C(k−1−m,t−1)) t-subsets newly, and each of the C(v−1,t−1) at least once,
//     unless it is of fixed elements of a circular design only. So i and r are counted, and r is at
//     least what i leaves. In total the newly covered t-subsets are as many as the blocks cover, so
//     that no element can have more repetitions than all have together less what the others are
//     forced to.
//   - *budget*: for pairs, if few repetitions are possible, each newly covered pair has a variable
//     and the repetitions are counted.
// A pair of elements that are in every block of a circular design is never newly covered; where
// counting does not exclude two such elements, the clauses of the last two kinds allow for them or
// are left out.
//
// docs/trust.md says what remains to be trusted.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/search/exact.hpp"
#include "search/sat/cnf.hpp"
#include "search/sat/cnf_size.hpp"

namespace changeover {

class DesignFormula {
 public:
  /// Without clauses yet; encode_design() adds them.
  DesignFormula(const Parameters& p, std::uint64_t b) : parameters_(p), b_(b) {}

  [[nodiscard]] const Parameters& parameters() const { return parameters_; }
  [[nodiscard]] std::uint64_t blocks() const { return b_; }
  [[nodiscard]] const Cnf& cnf() const { return cnf_; }
  [[nodiscard]] Cnf& cnf() { return cnf_; }

  /// Block `block` holds `element`, both from 0.
  [[nodiscard]] Literal holds(std::uint64_t block, std::uint64_t element) const {
    return static_cast<Literal>(block * parameters_.v + element + 1);
  }

  /// The design of a solution; nothing is verified. @throws BadInput if a block has not k elements.
  [[nodiscard]] Design decode(const std::function<bool(Literal)>& is_true) const;

 private:
  Parameters parameters_;
  std::uint64_t b_;
  Cnf cnf_;
};

/// How large encode_design() makes the formula, exactly, without building it. @throws
/// ImpossibleParameters as check(); MissingResource if it is more than Cnf holds. O(b) at worst,
/// and then b is below 10⁸.
[[nodiscard]] CnfSize design_formula_size(const Parameters& p, std::uint64_t b,
                                          const EncodingOptions& options = {});

/// "the formula of DCCD(60,5) with 253 blocks", for messages.
[[nodiscard]] std::string formula_name(const Parameters& p, std::uint64_t b);

/// The formula for exactly b ≥ 1 blocks, of O(b·C(v,t)) clauses and those of the counts.
/// @throws as design_formula_size(), and Stopped as stop_if_asked().
[[nodiscard]] DesignFormula encode_design(const Parameters& p, std::uint64_t b,
                                          const EncodingOptions& options = {});

}  // namespace changeover
