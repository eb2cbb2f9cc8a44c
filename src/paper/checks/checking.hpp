// What the checks of the report share: collecting comparisons into an item, and short ways to say
// and to build things.
//
//     Check check("Table 9", "the base blocks cover every difference", "designs");
//     check.expect(verdict.tight, {"tight", "not tight", "verified"});
//     return std::move(check).finish();         // reproduced, unless a comparison failed
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "changeover/construct/expansion.hpp"
#include "changeover/core/design.hpp"
#include "changeover/verify/verdict.hpp"
#include "core/sorted.hpp"
#include "paper/print/formula.hpp"
#include "paper/report.hpp"

namespace changeover {

/// One item in the making.
class Check {
 public:
  Check(std::string place, std::string what, std::string unit);

  /// Counts one comparison, or `weight` of them; if it does not hold, `finding` says what does.
  bool expect(bool holds, PaperFinding finding, std::uint64_t weight = 1) {
    return expect(
        holds, [&] { return std::move(finding); }, weight);
  }
  /// The same with a finding that takes long to make, or that is there only if it does not hold.
  template <std::invocable Finding>
  bool expect(bool holds, Finding&& finding, std::uint64_t weight = 1) {
    item_.checked += weight;
    if (!holds) {
      add(std::forward<Finding>(finding)());
    }
    return holds;
  }

  void note(std::string remark) { item_.notes.push_back(std::move(remark)); }

  /// What fails is not the print but the statement: a finding is a counterexample.
  Check& of_a_statement();

  /// If it fails, it does so for the reason of another item, at that place.
  Check& follows(std::string place);

  /// What holds, holds of nothing.
  void is_vacuous() { item_.status = PaperStatus::vacuous; }

  /// A reader should know this before the rest.
  Check& comes_first();

  /// Makes the item not checkable: a construction that it needs is not in the registry.
  void lacks(std::string_view construction);

  /// That construction; nullptr, said as by lacks(), if the registry does not have it.
  const Construction* finds(const Registry& registry, std::string_view construction);

  [[nodiscard]] PaperItem finish() &&;

 private:
  void add(PaperFinding finding);

  PaperItem item_;
  PaperStatus failed_ = PaperStatus::differs;
  std::uint64_t untold_ = 0;  // findings beyond those that are listed
  std::string follows_;       // from what, if it fails
};

/// A claim that is not checked, and why.
[[nodiscard]] PaperItem not_checkable(std::string place, std::string what, std::string reason);

/// "{0,1,4}", elements by number or by the names of the design.
[[nodiscard]] std::string braces(std::span<const Element> block);
[[nodiscard]] std::string braces(std::span<const Element> block, const Design& design);
[[nodiscard]] std::string braces(const std::vector<std::string>& names);

/// A block's name as the paper sets it: "B_{0,9}" for "B0,9", "block 3" for one without a name.
[[nodiscard]] std::string block_name(const ParsedTable& table, std::size_t index);

/// The parameters of a double-change design.
[[nodiscard]] inline Parameters linear(std::uint64_t v, std::uint64_t k) {
  return {.v = v, .k = k, .change = 2, .kind = Kind::linear};
}
[[nodiscard]] inline Parameters circular(std::uint64_t v, std::uint64_t k) {
  return {.v = v, .k = k, .change = 2, .kind = Kind::circular};
}

/// "DCCD(61,4,366)".
[[nodiscard]] std::string dccd(std::uint64_t v, std::uint64_t k, std::uint64_t b);

/// "valid, tight, 35 blocks", or what is wrong with it.
[[nodiscard]] std::string in_words(const Verdict& verdict);

/// The formula's value, 0 if that is no whole number.
[[nodiscard]] std::uint64_t count_of(std::string_view formula, const Values& values);

/// g₁ or g₂ of Theorem 1, as printed.
[[nodiscard]] Fraction printed_bound(const Paper& paper, std::uint64_t v, std::uint64_t k,
                                     Kind kind);

/// g₁ or g₂ from pairs that are counted one by one: all, those of a first block, those that a step
/// newly covers.
[[nodiscard]] Fraction counted_bound(std::uint64_t v, std::uint64_t k, Kind kind);

/// How often each pair is covered in the paper's sense, by PairSet::rank(), counted block by block.
[[nodiscard]] std::vector<std::uint64_t> times_covered(const Design& design);

/// All blocks, in braces.
[[nodiscard]] std::string all_blocks(const Design& design);

/// The design that a construction of the registry makes for these parameters; nullopt if the
/// registry has no such construction or it offers nothing.
[[nodiscard]] std::optional<Design> construct(const Registry& registry,
                                              std::string_view construction,
                                              const Parameters& parameters);

/// The design with fewest blocks that the registry knows for these parameters, verified; nullopt if
/// it knows none. The closure rules are asked only if what the constructions offer is above the
/// lower bound.
[[nodiscard]] std::optional<Design> best_design(const Registry& registry,
                                                const Parameters& parameters);

/// The design with `count` new elements in every block.
[[nodiscard]] Design with_fixed_elements(const Design& design, std::uint64_t count);

/// Verified designs to try general statements on, with 3 ≤ k ≤ 8 and v ≤ 24: those of the paper's
/// own constructions and tables; circular ones also with up to eight elements added to every block,
/// linear ones being all circular ones read as linear too. In order of their parameters.
[[nodiscard]] std::vector<Design> designs_to_try(const Registry& registry, Kind kind);

/// A design of Theorem 10 with its expansion set in closed form, k−2 dividing 2c+1.
struct CyclicWithSet {
  std::uint64_t c = 0;
  Design design;
  ExpansionSet set;
};

/// All of them with c up to `largest_c` and block size up to `largest_k`, by c and then by k, made
/// by the construction "cyclic-paper". Empty if the registry has none.
[[nodiscard]] std::vector<CyclicWithSet> cyclic_with_sets(const Registry& registry,
                                                          std::uint64_t largest_c,
                                                          std::uint64_t largest_k);

/// The expansion set that a table's carets mark: the unchanged subsets at those positions, or those
/// printed beneath it. Positions are as in construct/expansion.hpp.
[[nodiscard]] ExpansionSet marked_expansion_set(const PrintedTable& table);

/// What Theorem 2 makes of a printed design, its marked expansion set and the printed
/// 1-factorization of that place, elements without names; nullopt if that cannot be done.
[[nodiscard]] std::optional<Design> expanded_as_printed(const Paper& paper, std::string_view table,
                                                        Kind kind, std::string_view factorization);

/// What is said of a design besides its parameters.
struct Claim {
  std::uint64_t b = 0;
  bool tight = false;
};

/// Verifies a design against a claim and against the lower bound; a failure becomes a finding.
/// @returns whether everything holds. Counts one comparison.
bool expect_design(Check& check, const Design& design, const Claim& claim);

}  // namespace changeover
