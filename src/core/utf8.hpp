// Just enough of UTF-8.
//
//     first_code_point("∞_s")        // {U+221E, 3 bytes, valid}
//     first_code_point("\xff")       // {0, 1 byte, not valid}
#pragma once

#include <cstddef>
#include <string_view>

namespace changeover {

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

}  // namespace changeover
