// Pieces of pages to print.
#pragma once

#include <string>
#include <string_view>

#include "changeover/plan/sheet_formats.hpp"

namespace changeover {

/// A text in which nothing is markup.
[[nodiscard]] std::string html_text(std::string_view text);

/// The table of steps with boxes to tick.
[[nodiscard]] std::string html_steps(const SheetDocument& document);

/// A whole page with this heading and what stands below it.
[[nodiscard]] std::string html_page(const std::string& title, const std::string& body);

}  // namespace changeover
