// Kinds as numbers, as a catalog's database has them.
#pragma once

#include <cstdint>

#include "changeover/core/parameters.hpp"

namespace changeover {

inline std::uint64_t code_of(Kind kind) { return kind == Kind::linear ? 0 : 1; }

}  // namespace changeover
