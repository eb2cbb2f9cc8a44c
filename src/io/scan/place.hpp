// Places in a file, and the message for a malformed one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace changeover {

/// Line and column from 1; columns count bytes.
struct Place {
  std::uint64_t line = 1;
  std::uint64_t column = 1;
};

/// The place of the byte at `offset` in `text`. O(offset).
[[nodiscard]] Place place_of(std::string_view text, std::size_t offset);

/// @throws BadInput "name:line:column: what".
[[noreturn]] void fail(const std::string& name, Place place, std::string_view what);

/// A text without the byte order mark that some programs put before UTF-8.
[[nodiscard]] std::string_view without_byte_order_mark(std::string_view text);

}  // namespace changeover
