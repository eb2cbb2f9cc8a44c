// A design in memory, of a recipe that may come from a stranger.
#pragma once

#include "changeover/core/design.hpp"

namespace changeover {

/// As read_all(), and listens to the scope of this thread (run/control.hpp) on the way: what a
/// recipe makes may be larger than anything that it says. @throws MissingResource if the blocks
/// need more memory than the scope allows; Stopped; as read_all().
[[nodiscard]] Design read_within_memory(BlockSource& source);

}  // namespace changeover
