// The image of the catalog that comes with the program; the build makes it from the lines in
// catalog/.
#pragma once

#include <cstddef>
#include <span>

namespace changeover {

[[nodiscard]] std::span<const std::byte> shipped_catalog();

}  // namespace changeover
