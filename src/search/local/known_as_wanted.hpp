// Known designs that have the properties a construction needs, or have them once their elements are
// renumbered: no search is needed where one of them does.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/search/local_search.hpp"

namespace changeover {

/// A design as it is wanted.
struct AsWanted {
  Design design;
  std::vector<std::size_t> positions;  ///< of the unchanged subsets that are a partition
};

/// The design with its elements renumbered, and reversed if need be, so that it has the required
/// properties; nullopt if none is found. Blocks that must be contained are not looked for.
///
/// An exact cover: an element is in an unchanged subset, or it is renumbered to be one of those
/// wanted in the first or the last block. A limit of nodes ends it; so does the scope of this
/// thread (run/control.hpp).
[[nodiscard]] std::optional<AsWanted> as_wanted(const Design& design, const Wanted& wanted);

/// The one with the fewest blocks of the designs that are known to this program: the best one, the
/// best that a construction gives with an expansion set, and pieces for concatenation. @throws
/// Stopped.
[[nodiscard]] std::optional<AsWanted> known_as_wanted(const Parameters& p, const Wanted& wanted);

}  // namespace changeover
