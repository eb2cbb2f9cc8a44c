// Internal: where the symbolic links of a path end.
#pragma once

#include <filesystem>
#include <optional>
#include <system_error>

namespace changeover {

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
