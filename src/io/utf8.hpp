// Just enough of UTF-8.
#pragma once

#include <cstddef>
#include <string_view>

namespace changeover::io_detail {

struct CodePoint {
  char32_t value = 0;
  std::size_t bytes = 1;  ///< how many to skip: at least 1
  bool valid = false;
};

/// The code point at the front of a text that is not empty. Overlong forms, surrogates and values
/// above U+10FFFF are not valid; one byte is then skipped.
[[nodiscard]] CodePoint first_code_point(std::string_view text);

}  // namespace changeover::io_detail
