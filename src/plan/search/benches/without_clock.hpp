// How much time the search for lists without the clock gets.
#pragma once

#include "changeover/run/control.hpp"
#include "plan/search/lists/lists.hpp"

namespace changeover {

/// The share of the time that is left: as long as it takes to part benches that want the same
/// scarce parts. Then the search with the clock does more; but where time is short, it needs half
/// of it for lists as long as these.
[[nodiscard]] double share_without_clock(const ListsJob& job, const BenchLists& lists,
                                         const RunControl& control);

}  // namespace changeover
