// Designs that are sent: read as the command line reads files, and verified.
#pragma once

#include <string>

#include "changeover/core/design.hpp"
#include "changeover/io/input.hpp"
#include "serve/http/message.hpp"

namespace changeover::serve {

/// ?v=&k=&change=&kind=&strength=, as the sender of a design declares it. @throws Refusal 400
[[nodiscard]] ReadOptions reading_of(const Request& request);

/// {"valid","verdict","bound","details","bad_steps","uncovered_pairs","design"}: what `verify
/// --json` says, the first bad steps and uncovered pairs, and the design as it was understood.
[[nodiscard]] std::string verified_json(const Design& design);

}  // namespace changeover::serve
