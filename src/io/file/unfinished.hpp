// Files that this process must not leave behind when a signal ends it: temporaries of outputs, and
// locks. Their paths are where a signal handler can find them.
#pragma once

#include <string>

namespace changeover {

/// Notes `path` as one to remove. Returns its slot, or −1 if there is no room: the file is then not
/// removed on a signal.
[[nodiscard]] int note_unfinished(const std::string& path);

/// Forgets what `slot` notes; does nothing for −1.
void forget_unfinished(int slot) noexcept;

}  // namespace changeover
