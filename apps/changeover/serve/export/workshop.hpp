// A folder that appears whole at its place, or replaces an earlier one that was made here and that nobody changed.
//
//     Workshop workshop("public/designs");      // refuses a folder that holds anything else
//     workshop.write("data/a.json", text);
//     workshop.put_in_place();                  // and the earlier one is gone
//
// The folder keeps a list of its files with their checksums. Where one stands at the place already, each of its files must be on
// its list and as it was written, at every depth; otherwise nothing is changed. Only files of a list are ever removed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

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
  /// @throws MissingResource if what is at `place` is not an unchanged folder of this kind or an empty one, naming what else is
  /// there; or if nothing can be written beside it.
  explicit Workshop(const std::string& place);
  ~Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  /// A file below the folder; from any thread. @throws MissingResource
  void write(const std::string& name, std::string_view bytes);

  /// Writes the list and puts the folder at its place, on the disk; the earlier one goes. @throws MissingResource
  void put_in_place();

  [[nodiscard]] std::uint64_t files() const { return list_.size(); }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

 private:
  using List = std::map<std::string, std::string>;  // by name below the folder: its checksum

  void make_folder();
  void announce(const std::string& name);

  std::filesystem::path place_;
  std::filesystem::path work_;
  OpenFolder folder_;  // of it, locked
  bool there_ = false;
  List earlier_;  // what was at the place
  int announced_ = -1;
  std::mutex mutex_;
  List list_;
  std::uint64_t bytes_ = 0;
};

}  // namespace changeover::serve
