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
#include <optional>
#include <string>
#include <system_error>

namespace changeover {

/// Locks an open temporary; returns false if another process took it for an abandoned one and
/// removed it. Where the file system has no locks nothing is locked, and nothing removed.
[[nodiscard]] bool claim_temporary(int descriptor, const std::string& path);

/// Removes abandoned temporaries of the file `name` in `folder`, at the first call for it in this
/// process.
void remove_left_behind(const std::filesystem::path& folder, const std::string& name);

// Internal: where the symbolic links of a path end.

/// The path that the links of `path` end in; the file itself may be missing. Nothing if they lead
/// in a circle.
inline std::optional<std::filesystem::path> behind_links(std::filesystem::path path) {
  constexpr int most_links = 40;  // as the system has it
  std::error_code error;
  for (int links = 0; std::filesystem::is_symlink(path, error); ++links) {
    if (links == most_links) {
      return std::nullopt;
    }
    path = path.parent_path() / std::filesystem::read_symlink(path, error);
  }
  return path;
}

}  // namespace changeover
