#include "serve/export/workshop.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <set>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/core/sha256.hpp"
#include "changeover/core/version.hpp"
#include "core/printable.hpp"
#include "io/file/left_behind.hpp"

namespace changeover::serve {
namespace {

namespace fs = std::filesystem;

// The list: a line about the program, then a line a file, its checksum and its name.
constexpr const char* list_name = ".changeover-explorer";
// In a folder that an export works in, and in an earlier one that it removes: the names of the files that it is about to write.
// Whoever finds such a folder unlocked may remove these, and those of its list.
constexpr const char* unfinished = ".changeover-unfinished";

constexpr std::string_view before_random = ".new-";
constexpr std::size_t random_letters = 6;  // of mkdtemp
constexpr std::size_t checksum_digits = 64;

[[noreturn]] void cannot(const std::string& what, const fs::path& path, int why) {
  throw MissingResource(
      fmt::format("cannot {} {}: {}", what, printable(path.string()), std::strerror(why)));
}

bool is_file(const fs::path& path) {
  std::error_code none;
  return fs::is_regular_file(fs::symlink_status(path, none));
}

std::string checksum_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  Sha256 hash;
  std::vector<char> buffer(std::size_t{1} << 16);
  while (file.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) ||
         file.gcount() > 0) {
    hash.add(std::string_view(buffer.data(), static_cast<std::size_t>(file.gcount())));
  }
  return to_hex(hash.finish());
}

// A name that stays below the folder.
bool stays_below(const std::string& name) {
  const fs::path path(name);
  return !name.empty() && path.is_relative() &&
         std::ranges::none_of(path, [](const fs::path& part) { return part == ".."; });
}

std::map<std::string, std::string> list_of(const fs::path& folder) {
  std::map<std::string, std::string> list;
  if (!is_file(folder / list_name)) {
    return list;
  }
  std::ifstream file(folder / list_name);
  std::string line;
  std::getline(file, line);  // about the program
  while (std::getline(file, line)) {
    if (line.size() > checksum_digits + 2) {
      list.emplace(line.substr(checksum_digits + 2), line.substr(0, checksum_digits));
    }
  }
  return list;
}

std::set<std::string> announced_in(const fs::path& folder) {
  std::set<std::string> names;
  if (is_file(folder / unfinished)) {
    std::ifstream file(folder / unfinished);
    for (std::string line; std::getline(file, line);) {
      names.insert(line);
    }
  }
  return names;
}

// Removes these files, then the folders that are empty then; the marks last: it can be killed. What else is there stays.
void remove_files(const fs::path& folder, const std::set<std::string>& names) {
  std::error_code ignored;
  std::set<fs::path> folders;
  for (const std::string& name : names) {
    if (stays_below(name) && is_file(folder / name)) {
      fs::remove(folder / name, ignored);
    }
    for (fs::path above = fs::path(name).parent_path(); !above.empty() && stays_below(name);
         above = above.parent_path()) {
      folders.insert(above);
    }
  }
  // The innermost first: a folder sorts before what is in it.
  for (auto at = folders.rbegin(); at != folders.rend(); ++at) {
    ::rmdir((folder / *at).c_str());
  }
  std::size_t others = 0;
  for (fs::directory_iterator at(folder, ignored), end; !ignored && at != end;
       at.increment(ignored)) {
    const fs::path name = at->path().filename();
    others += name != list_name && name != unfinished ? 1U : 0U;
  }
  if (others == 0) {
    fs::remove(folder / list_name, ignored);
    fs::remove(folder / unfinished, ignored);
    ::rmdir(folder.c_str());
  }
}

template <typename List>
std::set<std::string> names_of(const List& list) {
  std::set<std::string> names;
  for (const auto& [name, checksum] : list) {
    names.insert(name);
  }
  return names;
}

// Removes what exports to `place` left that were killed. Whoever makes a site has its folder locked, as the temporaries of files
// are (io/file/left_behind.hpp).
void remove_left_behind(const fs::path& place) {
  const std::string front = place.filename().string() + std::string(before_random);
  std::vector<fs::path> found;
  std::error_code fault;
  for (fs::directory_iterator at(place.parent_path(), fault), end; !fault && at != end;
       at.increment(fault)) {
    const std::string name = at->path().filename().string();
    if (name.starts_with(front) && name.size() == front.size() + random_letters) {
      found.push_back(at->path());
    }
  }
  for (const fs::path& path : found) {
    const OpenFolder folder(path);
    if (folder.descriptor() < 0 || ::flock(folder.descriptor(), LOCK_EX | LOCK_NB) != 0) {
      continue;
    }
    if (is_file(path / unfinished)) {
      std::set<std::string> names = announced_in(path);
      names.merge(names_of(list_of(path)));
      remove_files(path, names);
    } else {
      ::rmdir(path.c_str());  // if it is empty
    }
  }
}

// What stands at the place and is not of an earlier export, or is not as that wrote it; nothing if all is.
std::optional<std::string> what_else(const fs::path& place,
                                     const std::map<std::string, std::string>& list) {
  std::set<std::string> folders;
  for (const auto& [name, checksum] : list) {
    for (fs::path above = fs::path(name).parent_path(); !above.empty();
         above = above.parent_path()) {
      folders.insert(above.string());
    }
  }
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(place)) {
    const std::string name = entry.path().lexically_relative(place).string();
    const fs::file_status status = entry.symlink_status();
    if (fs::is_directory(status)) {
      if (!folders.contains(name)) {
        return name + " is";
      }
      continue;
    }
    const bool is_mark = name == list_name || name == unfinished;
    if (!fs::is_regular_file(status) || (!is_mark && !list.contains(name))) {
      return name + " is";
    }
    if (!is_mark && checksum_of(entry.path()) != list.at(name)) {
      return name + " was changed and is";
    }
  }
  return std::nullopt;
}

}  // namespace

OpenFolder::OpenFolder(const fs::path& path)
    : descriptor_(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC)) {}

OpenFolder::~OpenFolder() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

Workshop::Workshop(const std::string& place) : place_(fs::absolute(place).lexically_normal()) {
  if (!place_.has_filename()) {
    place_ = place_.parent_path();
  }
  std::error_code fault;
  const fs::file_status status = fs::status(place_, fault);
  there_ = fs::exists(status);
  if (there_ && !fs::is_directory(status)) {
    throw MissingResource(
        fmt::format("--export {}: it is no folder; name a new one", printable(place)));
  }
  if (there_) {
    place_ = fs::canonical(place_);
    if (!fs::is_empty(place_) && !is_file(place_ / list_name)) {
      throw MissingResource(
          fmt::format("--export {}: the folder holds other things; name a new one, or an empty one",
                      printable(place)));
    }
    earlier_ = list_of(place_);
    if (!fs::is_empty(place_) && earlier_.empty()) {
      throw MissingResource(
          fmt::format("--export {}: an older program made this site and kept no list of its files; "
                      "name a new folder, or remove this one",
                      printable(place)));
    }
    if (const auto other = what_else(place_, earlier_)) {
      throw MissingResource(fmt::format(
          "--export {}: {} not of the earlier export and would be lost; export to a new folder, or "
          "put it elsewhere",
          printable(place), printable(*other)));
    }
  }
  remove_left_behind(place_);
  make_folder();
}

void Workshop::make_folder() {
  do {
    std::string pattern =
        fmt::format("{}{}{}", place_.string(), before_random, std::string(random_letters, 'X'));
    if (::mkdtemp(pattern.data()) == nullptr) {
      cannot("make a folder beside", place_, errno);
    }
    work_ = pattern;
    folder_ = OpenFolder(work_);
    if (folder_.descriptor() < 0 && errno != ENOENT) {
      cannot("open", work_, errno);
    }
    // Another export may have taken it for one that was left.
  } while (folder_.descriptor() < 0 || !claim_temporary(folder_.descriptor(), work_.string()));
  constexpr auto as_folders_are = fs::perms::owner_all | fs::perms::group_read |
                                  fs::perms::group_exec | fs::perms::others_read |
                                  fs::perms::others_exec;
  fs::permissions(work_, as_folders_are);
  constexpr mode_t as_files_are = 0644;
  announced_ = ::open((work_ / unfinished).c_str(),
                      O_WRONLY | O_APPEND | O_CREAT | O_NOFOLLOW | O_CLOEXEC, as_files_are);
  if (announced_ < 0) {
    const int why = errno;
    ::rmdir(work_.c_str());
    cannot("write", work_ / unfinished, why);
  }
}

Workshop::~Workshop() {
  ::close(announced_);
  std::set<std::string> names = announced_in(work_);
  names.merge(names_of(list_of(work_)));
  remove_files(work_, names);
}

// Before it is there: what is killed leaves nothing without a name.
void Workshop::announce(const std::string& name) {
  const std::string line = name + "\n";
  if (::write(announced_, line.data(), line.size()) != static_cast<ssize_t>(line.size())) {
    cannot("write", work_ / unfinished, errno);
  }
}

void Workshop::write(const std::string& name, std::string_view bytes) {
  const fs::path path = work_ / name;
  {
    const std::scoped_lock lock(mutex_);
    announce(name);
  }
  std::error_code fault;
  fs::create_directories(path.parent_path(), fault);
  constexpr mode_t as_files_are = 0644;
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, as_files_are);
  if (file < 0) {
    cannot("write", path, errno);
  }
  for (std::string_view rest = bytes; !rest.empty();) {
    const ssize_t wrote = ::write(file, rest.data(), rest.size());
    if (wrote < 0 && errno != EINTR) {
      const int why = errno;
      ::close(file);
      cannot("write", path, why);
    }
    rest.remove_prefix(wrote > 0 ? static_cast<std::size_t>(wrote) : 0);
  }
  if (::close(file) != 0) {
    cannot("write", path, errno);
  }
  Sha256 hash;
  hash.add(bytes);
  const std::scoped_lock lock(mutex_);
  list_[name] = to_hex(hash.finish());
  bytes_ += bytes.size();
}

void Workshop::put_in_place() {
  std::string list = fmt::format("changeover {}\n", version);
  for (const auto& [name, checksum] : list_) {
    list += fmt::format("{}  {}\n", checksum, name);
  }
  write(list_name, list);
  if (::syncfs(folder_.descriptor()) != 0) {
    cannot("write", work_, errno);
  }
  const unsigned how = there_ ? RENAME_EXCHANGE : RENAME_NOREPLACE;
  if (::renameat2(AT_FDCWD, work_.c_str(), AT_FDCWD, place_.c_str(), how) != 0) {
    cannot("put the site at", place_, errno);
  }
  std::error_code ignored;
  fs::remove(place_ / unfinished, ignored);
  if (there_) {
    // The earlier one is beside the place now: its files are those of its list, and if this is killed, the next export goes on.
    constexpr mode_t as_files_are = 0644;
    const int mark = ::open((work_ / unfinished).c_str(),
                            O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, as_files_are);
    if (mark >= 0) {
      ::close(mark);
    }
  }
}

}  // namespace changeover::serve
