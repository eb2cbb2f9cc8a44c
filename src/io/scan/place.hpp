// Places in a file, and the message for a malformed one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
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

/// The message for a control byte.
[[nodiscard]] std::string control_byte_defect(char byte);

/// A word of the input for a message: in quotes, on one line, not too long.
[[nodiscard]] std::string shown(std::string_view word);

// Which texts can stand in a list.

/// What is wrong with texts that an old Macintosh wrote. In a comment it is a fault, too: lines
/// would hide behind it.
inline constexpr std::string_view lone_carriage_return =
    "carriage return inside a line; end lines with LF or CR LF";

struct TextDefect {
  std::size_t offset = 0;  ///< of the first byte that is at fault
  std::string what;        ///< what it is and how to correct it, without a place
};

/// The first fault: a byte that is not UTF-8, a control character, a line end, or a character that
/// reverses the direction of writing; nothing if there is none. Tabs are control characters unless
/// allowed.
[[nodiscard]] std::optional<TextDefect> first_defect(std::string_view text, bool allow_tabs);

/// A name as it looks: without characters of no width, and with a plain blank for each other blank.
[[nodiscard]] std::string visible(std::string_view name);

}  // namespace changeover
