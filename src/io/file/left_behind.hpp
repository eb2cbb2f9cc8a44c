// Temporary files that killed processes left: taken away by whoever writes to the same place next.
//
//     .mine.json.4711-0.tmp                   the temporary of mine.json, of process 4711
//
// Who writes to a temporary file holds the lock of the system on it (flock), which ends with the process however that ends. So a file
// whose lock is free, and whose process is not there or has our number, is nobody's.
#pragma once

#include <filesystem>
#include <string>

namespace changeover {

/// Locks an open temporary; false if somebody took it for one that was left, so that its name is gone. Where the file system has no
/// locks nothing is locked, and nothing taken away.
[[nodiscard]] bool claim_temporary(int descriptor, const std::string& path);

/// Removes what was left of the temporaries for the file `name` in `folder`; the first time in this process that it is asked.
void remove_left_behind(const std::filesystem::path& folder, const std::string& name);

}  // namespace changeover
