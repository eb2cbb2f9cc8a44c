// Temporary files that killed processes left: the next process that writes to the same place
// removes them.
//
//     .mine.json.4711-0.tmp                   the temporary of mine.json, of process 4711
//
// The process that writes to a temporary file holds a lock of the system on it (flock), which ends
// with the process in any case. So a file whose lock is free, and whose process is gone or has our
// number, has no owner.
#pragma once

#include <filesystem>
#include <string>

namespace changeover {

/// Locks an open temporary; returns false if another process took it for an abandoned one and
/// removed it. Where the file system has no locks nothing is locked, and nothing removed.
[[nodiscard]] bool claim_temporary(int descriptor, const std::string& path);

/// Removes abandoned temporaries of the file `name` in `folder`, at the first call for it in this
/// process.
void remove_left_behind(const std::filesystem::path& folder, const std::string& name);

}  // namespace changeover
