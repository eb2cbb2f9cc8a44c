// Text from outside, safe to show on one line of a terminal.
//
//     printable("B\x1b[2J.txt")      // B\x1b[2J.txt, as twelve visible characters
//     printable("a\nb")              // a\nb, on one line
//     printable("\xff")              // \xff
//     is_printable("∞_s")            // true
//
// A file name or a label can hold characters that a terminal obeys: escape sequences, a carriage
// return that hides the text before it, marks that turn the direction of writing. Every message of
// an Error goes through printable(), and a label must be printable; code that prints other text
// from outside calls it, too. It keeps backslashes, so that calling it twice does no harm.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace changeover {

/// Returns the text with all that is not a visible character escaped: control characters (U+0000 to
/// U+001F, U+007F to U+009F), line and paragraph separators (U+2028, U+2029), marks that override
/// the direction of writing (U+202A to U+202E, U+2066 to U+2069), and bytes that are not UTF-8. \n,
/// \r and \t for these, \xNN for other bytes, \u{NNNN} above.
[[nodiscard]] std::string printable(std::string_view text);

/// Whether printable() would leave it as it is.
[[nodiscard]] bool is_printable(std::string_view text);

// Just enough of UTF-8.
//
//     first_code_point("∞_s")        // {U+221E, 3 bytes, valid}
//     first_code_point("\xff")       // {0, 1 byte, not valid}

struct CodePoint {
  char32_t value = 0;
  std::size_t bytes = 1;  ///< how many to skip: at least 1
  bool valid = false;
};

/// The code point at the front of a text that is not empty. Overlong forms, surrogates and values
/// above U+10FFFF are not valid; one byte is then skipped.
[[nodiscard]] CodePoint first_code_point(std::string_view text);

/// Whether it is a visible character as in printable.hpp: not a control, separator or override.
[[nodiscard]] bool is_printable(const CodePoint& point);

/// A word of the input for a message: in quotes, on one line, not too long.
[[nodiscard]] std::string shown(std::string_view word);

// Which texts can stand in a list.

/// The message for a control byte.
[[nodiscard]] std::string control_byte_defect(char byte);

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
