// What may stand before a design that was copied out of another program.
#pragma once

#include <string_view>

namespace changeover {

/// Skips blanks, and comments that begin with '#'.
void skip_comments(std::string_view& text);

/// Skips the prompt of GAP, Sage or Python ("gap>", "sage:", ">>>") and the blanks after it.
/// Returns whether it was there.
bool skip_prompt(std::string_view& text);

/// Skips "D :=" or "D =" and the blanks after it. Returns whether it was there.
bool skip_assignment(std::string_view& text);

/// Whether a name of GAP, Sage or Python may have this character.
[[nodiscard]] bool is_of_name(char c);

}  // namespace changeover
