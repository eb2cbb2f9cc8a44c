// Internal: the bytes of so many moves of items of equal size.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <string>

#include "changeover/core/error.hpp"

namespace changeover {

/// moves · each, where `option` is what says `each`, and `what` is moved. @throws
/// ImpossibleParameters that names them if that exceeds 64 bits
[[nodiscard]] inline std::uint64_t bytes_moved(std::uint64_t moves, std::uint64_t each,
                                               const std::string& option, const std::string& what) {
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  if (moves > 0 && each > most / moves) {
    throw ImpossibleParameters(
        fmt::format("{} {}: {} {} have more bytes than 64 bits can count; "
                    "give at most {}",
                    option, each, moves, what, most / moves));
  }
  return moves * each;
}

}  // namespace changeover
