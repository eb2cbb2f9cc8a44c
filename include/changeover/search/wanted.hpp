// What constructions need of a design besides few blocks: elements in its first and its last block,
// given blocks in it, unchanged subsets that hold all other elements.
//
//     const Wanted wanted{.first = {0, 1, 2}, .expansion_set = true};
//     wanted_defect({.v = 12, .k = 4, .change = 1}, wanted);  // "": a design may have that
//     wanted_words(wanted);  // " that begins with {0,1,2} and has disjoint unchanged subsets …"
//
// Local search keeps such cells as they are (search/local_search.hpp, search_locked()). Exact
// search has them as clauses (search/exact.hpp).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"

namespace changeover {

/// The required properties, all of them.
struct Wanted {
  Block first{};  ///< elements of the first block, at most k; linear designs only
  Block last{};   ///< elements of the last block
  bool expansion_set =
      false;  ///< unchanged subsets partition the elements not in `first` or `last`
  std::vector<Block>
      contained{};  ///< consecutive blocks, in this order or, if circular, across the end

  /// Whether anything is required.
  [[nodiscard]] bool any() const {
    return expansion_set || !(first.empty() && last.empty() && contained.empty());
  }
};

/// One line on why no design with these parameters can have the properties, or why they make no
/// sense; else empty. O(vk).
[[nodiscard]] std::string wanted_defect(const Parameters& p, const Wanted& wanted);

/// The largest lower bound that is known for designs with the properties: that of p, the number of
/// given blocks, or the steps that a partition takes. wanted_defect() must find none. O(vk), and
/// lower_bound().
[[nodiscard]] Bound wanted_bound(const Parameters& p, const Wanted& wanted);

/// The largest lower bound for designs with the properties, given a bound that is known for p.
[[nodiscard]] Bound wanted_bound(const Parameters& p, const Wanted& wanted, Bound known);

/// The elements that must be in unchanged subsets with expansion_set: those not in `first` or
/// `last`. Increasing.
[[nodiscard]] Block in_parts(const Parameters& p, const Wanted& wanted);

/// The unchanged subsets that partition the elements not in `first` or `last`, in order of
/// position; nullopt if `design` lacks a required property. `positions` are the places of the
/// subsets; they are ignored without expansion_set. O(bk).
[[nodiscard]] std::optional<std::vector<UnchangedSubset>> parts_as_wanted(
    const Design& design, const Wanted& wanted, const std::vector<std::size_t>& positions);

/// The properties after "a design": " that begins with {0,1} and contains {0,1,2}, {1,2,3} one
/// after another"; empty if there are none. Of more given blocks than `shown`, the first, and how
/// many more.
[[nodiscard]] std::string wanted_words(const Wanted& wanted, std::size_t shown = 4);

}  // namespace changeover
