// Another block in the place of one of a list.
#pragma once

#include <optional>

#include "changeover/core/design.hpp"

namespace changeover {

/// The list with one block replaced, so that everything is covered and all steps are right; of all
/// such blocks one that keeps the most elements of the given one, and of these the first in the
/// list. Returns nullopt if there is none, if the list has fewer than two blocks, or if v has too
/// many t-subsets to count how often each is covered. Not verified. The scope of this thread
/// (run/control.hpp) can stop it. O(C(v,t) + b C(k,t)), and a byte for each t-subset.
///
/// Why it is exact: in block i must stay what no other block covers. Let W be the elements of these
/// subsets. With its neighbors P and N the elements are of four kinds (in both, in P only, in N
/// only, in neither), and a block fits if and only if it has W and as many of each kind as make k
/// elements, k−m of P and k−m of N. The number in both settles the other three.
[[nodiscard]] std::optional<Design> with_another_block(const Design& list);

}  // namespace changeover
