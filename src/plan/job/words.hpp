// Numbers in sentences.
#pragma once

#include <cstdint>
#include <string>

namespace changeover {

/// "1 test", "2 tests".
[[nodiscard]] std::string count_of(std::uint64_t n, const std::string& singular);

}  // namespace changeover
