// Which pictures an option is for: of changeover draw, and of the server.
//
//     picture_option_defect("from", "recipe", "--");
//                                // "--from has no meaning with --picture recipe; it is for …"
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace changeover::cli {

/// Why the option has no meaning with that picture, in one line with `dashes` before the names of
/// both; nothing if it has one.
[[nodiscard]] std::optional<std::string> picture_option_defect(std::string_view option,
                                                               std::string_view picture,
                                                               std::string_view dashes);

}  // namespace changeover::cli
