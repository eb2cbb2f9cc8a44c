// Bytes as text in the letters of base64 [RFC 4648].
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace changeover {

/// With padding, in one line.
[[nodiscard]] std::string base64_of(std::string_view bytes);

/// The bytes, with or without padding; nothing for other letters, a length that no bytes have, or
/// bits that say nothing and are not 0.
[[nodiscard]] std::optional<std::string> from_base64(std::string_view text);

}  // namespace changeover
