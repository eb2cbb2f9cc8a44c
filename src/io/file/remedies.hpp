// How to mend what the system refuses to do with a file, and folders that are made.
#pragma once

#include <string>
#include <string_view>

namespace changeover {

/// The last part of a message, by errno: what to do about a file that cannot be read, or written.
[[nodiscard]] std::string_view how_to_read(int error);
[[nodiscard]] std::string_view how_to_write(int error);

/// Makes the folder and those above it; one that is there stays as it is.
/// @throws MissingResource "FOLDER: cannot make the folder: WHY; REMEDY"
void make_folder(const std::string& path, std::string_view remedy = "name another one");

}  // namespace changeover
