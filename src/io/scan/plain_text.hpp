// Which texts can stand in a list.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace changeover {

struct TextDefect {
  std::size_t offset = 0;  ///< of the first byte that is at fault
  std::string what;        ///< what it is and how to mend it, without a place
};

/// The first byte that is not UTF-8, control character, end of a line or character that turns the
/// direction of writing around; nothing if there is none. Tabs are control characters unless allowed.
[[nodiscard]] std::optional<TextDefect> first_defect(std::string_view text, bool allow_tabs);

/// What is seen of a name: without characters that take no room, and with a blank for each blank of another kind.
[[nodiscard]] std::string visible(std::string_view name);

}  // namespace changeover
