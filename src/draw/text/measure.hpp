// Room for texts: see text_width() in changeover/draw/picture.hpp.
//
//     fitted("a-very-long-name", 40, 10)         // "a-ver…"
#pragma once

#include <string>
#include <string_view>

namespace changeover {

/// As much of the beginning of a text as has room, with "…" behind it if that is not all. (Of too
/// little room only "…" is left.)
[[nodiscard]] std::string fitted(std::string_view text, double room, double font_size,
                                 bool bold = false);

/// The part of the font size by which a star above or below is smaller, and the room that it takes.
inline constexpr double star_size = 0.8;
[[nodiscard]] inline double star_width(double font_size) { return 0.5 * star_size * font_size; }

}  // namespace changeover
