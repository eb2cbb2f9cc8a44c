// A folder that appears whole at its place, or replaces an earlier one that was made here and was
// not changed.
//
//     Workshop workshop("public/designs");      // refuses a folder that holds anything else
//     workshop.write("data/a.json", text);
//     workshop.put_in_place();                  // and the earlier one is gone
//
// The folder keeps a list of its files (own_files.hpp). Where one stands at the place already, each
// of its files must be on its list and as it was written, at every depth; otherwise nothing is
// changed. Only files of a list are ever removed. The new folder has the permissions of the one
// that it replaces.
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "serve/export/own_files.hpp"

namespace changeover::serve {

/// A descriptor of a folder, which may be locked by it; -1 if there is none.
class OpenFolder {
 public:
  OpenFolder() = default;
  explicit OpenFolder(const std::filesystem::path& path);
  ~OpenFolder();
  OpenFolder(OpenFolder&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  OpenFolder& operator=(OpenFolder&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  OpenFolder(const OpenFolder&) = delete;
  OpenFolder& operator=(const OpenFolder&) = delete;
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_ = -1;
};

/// The new folder, beside its place; it goes away unless it is put there.
class Workshop {
 public:
  /// @throws MissingResource if what is at `place` is not an unchanged folder of this kind or an
  /// empty one, naming what else is there, or holds the current folder; or if nothing can be
  /// written beside it.
  explicit Workshop(const std::string& place);
  ~Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  /// A file below the folder; from any thread. @throws MissingResource
  void write(const std::string& name, std::string_view bytes);

  /// Writes the list and puts the folder at its place, on the disk; the earlier one goes. What
  /// another process put into that at the last moment, or what cannot be removed, stays beside the
  /// place; its folder is returned then.
  /// @throws MissingResource, also if what is at the place has changed since; Stopped.
  [[nodiscard]] std::optional<std::string> put_in_place();

  [[nodiscard]] std::uint64_t files() const { return list_.size(); }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

 private:
  void refuse_what_is_no_site();
  void refuse_where_we_are() const;
  void make_folder();
  void announce(const std::string& name);

  std::filesystem::path place_;
  std::filesystem::path work_;
  OpenFolder folder_;  // of it, locked
  bool there_ = false;
  std::string said_;  // the place in the words of the caller
  std::filesystem::perms mode_{};
  bool in_place_ = false;
  int announced_ = -1;
  std::mutex mutex_;
  OwnFiles::List list_;
  std::uint64_t bytes_ = 0;
};

}  // namespace changeover::serve
