// The files of a folder that an export made: known by a list with their checksums, at every depth.
//
//     OwnFiles files = OwnFiles::of("public");             // reads its list; refuses a damaged one
//     if (auto other = files.what_else()) { … }            // "data/mine is": leave all of it alone
//     bool all = files.remove();                           // what is still as it was written
//
// Nothing is followed out of the folder: no link, no name with `..`.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace changeover::serve {

/// The list: a line about the program, then one line per file, its checksum and its name, in order.
constexpr const char* list_name = ".changeover-explorer";
/// In a folder that an export works in, and in an earlier one that it is about to replace: the
/// names of files that it is about to write. A process that finds such a folder unlocked may remove
/// these, and those of its list.
constexpr const char* unfinished_name = ".changeover-unfinished";

/// Whether the name leads to a place below the folder, and no link is above it there.
[[nodiscard]] bool stays_below(const std::filesystem::path& folder, const std::string& name);

/// Whether a name can be on a list: relative, plain, one line.
[[nodiscard]] bool can_be_listed(const std::string& name);

class OwnFiles {
 public:
  using List = std::map<std::string, std::string>;  // by name below the folder: its checksum

  /// An empty list where the folder has none.
  /// @throws MissingResource in one line, with the place, for a list that cannot be read or that no
  /// export wrote.
  [[nodiscard]] static OwnFiles of(const std::filesystem::path& folder);

  /// No list: only what is announced there.
  [[nodiscard]] static OwnFiles announced_only(const std::filesystem::path& folder) {
    return {folder, {}};
  }

  [[nodiscard]] static std::string text_of(const List& list);

  [[nodiscard]] bool empty() const { return list_.empty(); }

  /// What stands there and is not on the list, or is not as it was written; nothing if all is.
  /// Listens to the scope.
  /// @throws MissingResource for what cannot be read; Stopped.
  [[nodiscard]] std::optional<std::string> what_else() const;

  /// Removes the files of the list that are as they were written, those that were announced, then
  /// folders that are empty, the marks last: it can be killed. What else is there stays, and then
  /// so does the folder, and it is false. Never throws.
  bool remove() const noexcept;

 private:
  OwnFiles(std::filesystem::path folder, List list)
      : folder_(std::move(folder)), list_(std::move(list)) {}

  std::filesystem::path folder_;
  List list_;
};

/// Whether it is a regular file, and no link to one.
[[nodiscard]] bool is_file(const std::filesystem::path& path);

}  // namespace changeover::serve
