// Text for man(1), in the macros of man(7).
//
//     roff_text("1-factorizations with --near");      // 1-factorizations with \-\-near
//
// A hyphen inside a word stays one; all other minus signs are written so that what is copied from
// the page can be typed. No text can be taken for a macro or an escape.
#pragma once

#include <string>
#include <string_view>

namespace changeover::cli {

/// Words of a paragraph, one line of the source.
[[nodiscard]] std::string roff_text(std::string_view text);
/// What is typed as it stands there.
[[nodiscard]] std::string roff_literal(std::string_view text);
[[nodiscard]] std::string roff_bold(std::string_view text);
[[nodiscard]] std::string roff_italic(std::string_view text);

}  // namespace changeover::cli
