// Which texts can stand in a list.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace changeover {

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
