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

}  // namespace changeover
