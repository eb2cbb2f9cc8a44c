#include "serve/export/workshop.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/core/sha256.hpp"
#include "core/printable.hpp"
#include "io/file/left_behind.hpp"
#include "serve/export/own_files.hpp"

namespace changeover::serve {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view before_random = ".new-";
constexpr std::size_t random_letters = 6;  // of mkdtemp
constexpr mode_t as_files_are = 0644;

[[noreturn]] void cannot(const std::string& what, const fs::path& path, int why) {
  throw MissingResource(fmt::format("cannot {} {}: {}; name another folder with --export", what,
                                    printable(path.string()), std::strerror(why)));
}

fs::perms as_new_folders_are() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return fs::perms{0777 & ~mask};
}

// What a stopped export leaves may have half a list, or none: then its files are those that it
// announced.
OwnFiles own_files_of_stopped(const fs::path& folder) {
  try {
    return OwnFiles::of(folder);
  } catch (const MissingResource&) {
    return OwnFiles::announced_only(folder);
  }
}

// Removes what exports to `place` left that were killed. The process that makes a site has its
// folder locked, as the temporaries of files are (io/file/left_behind.hpp).
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
    if (is_file(path / unfinished_name)) {
      own_files_of_stopped(path).remove();
    } else {
      ::rmdir(path.c_str());  // if it is empty
    }
  }
}

}  // namespace

OpenFolder::OpenFolder(const fs::path& path)
    : descriptor_(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC)) {}

OpenFolder::~OpenFolder() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

Workshop::Workshop(const std::string& place) : said_(place) {
  std::error_code fault;
  place_ = fs::absolute(place, fault).lexically_normal();
  if (fault) {
    throw MissingResource(
        fmt::format("--export {}: the current folder is gone; change to another, or give the whole "
                    "path",
                    printable(place)));
  }
  if (!place_.has_filename()) {
    place_ = place_.parent_path();
  }
  refuse_what_is_no_site();
  remove_left_behind(place_);
  make_folder();
}

void Workshop::refuse_what_is_no_site() {
  std::error_code fault;
  const fs::file_status status = fs::status(place_, fault);
  there_ = fs::exists(status);
  if (!there_ && fs::is_symlink(fs::symlink_status(place_, fault))) {
    throw MissingResource(fmt::format("--export {}: it is a link that leads nowhere; name a folder",
                                      printable(said_)));
  }
  if (there_ && !fs::is_directory(status)) {
    throw MissingResource(
        fmt::format("--export {}: it is not a folder; name a new one", printable(said_)));
  }
  if (!there_) {
    return;
  }
  place_ = fs::canonical(place_);
  mode_ = fs::status(place_).permissions();
  const bool is_empty = fs::is_empty(place_, fault);
  if (fault) {
    throw MissingResource(
        fmt::format("cannot read {}: {}; allow reading there, or name a new folder",
                    printable(place_.string()), fault.message()));
  }
  if (!is_empty && !is_file(place_ / list_name)) {
    throw MissingResource(
        fmt::format("--export {}: the folder holds other things; name a new one, or an empty one",
                    printable(said_)));
  }
  const OwnFiles earlier = OwnFiles::of(place_);
  if (!is_empty && earlier.empty()) {
    throw MissingResource(
        fmt::format("--export {}: an older program made this site and kept no list of its files; "
                    "name a new folder, or remove this one",
                    printable(said_)));
  }
  if (const auto other = earlier.what_else()) {
    throw MissingResource(fmt::format(
        "--export {}: {} not of the earlier export and would be lost; export to a new folder, or "
        "put it elsewhere",
        printable(said_), printable(*other)));
  }
  refuse_where_we_are();
}

// The new folder takes the place of the one that is there, which goes: a process in it would be
// nowhere.
void Workshop::refuse_where_we_are() const {
  std::error_code fault;
  const fs::path here = fs::canonical(".", fault);
  if (!fault &&
      std::mismatch(place_.begin(), place_.end(), here.begin(), here.end()).first == place_.end()) {
    throw MissingResource(fmt::format(
        "--export {}: you are in this folder, which a new one would replace; change to another, "
        "and give the whole path: --export {}",
        printable(said_), printable(place_.string())));
  }
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
  announced_ = ::open((work_ / unfinished_name).c_str(),
                      O_WRONLY | O_APPEND | O_CREAT | O_NOFOLLOW | O_CLOEXEC, as_files_are);
  if (announced_ < 0) {
    const int why = errno;
    ::rmdir(work_.c_str());
    cannot("write", work_ / unfinished_name, why);
  }
}

Workshop::~Workshop() {
  ::close(announced_);
  if (!in_place_) {
    own_files_of_stopped(work_).remove();
  }
}

// Before it is there: what is killed leaves nothing without a name.
void Workshop::announce(const std::string& name) {
  const std::string line = name + "\n";
  if (::write(announced_, line.data(), line.size()) != static_cast<ssize_t>(line.size())) {
    cannot("write", work_ / unfinished_name, errno);
  }
}

void Workshop::write(const std::string& name, std::string_view bytes) {
  if (!can_be_listed(name)) {
    throw MissingResource(
        fmt::format("a site has no file called '{}'; give it another name", printable(name)));
  }
  const fs::path path = work_ / name;
  {
    const std::scoped_lock lock(mutex_);
    announce(name);
  }
  std::error_code fault;
  fs::create_directories(path.parent_path(), fault);
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

std::optional<std::string> Workshop::put_in_place() {
  write(list_name, OwnFiles::text_of(list_));
  if (there_) {
    // Long work: another process may have put something there meanwhile.
    refuse_what_is_no_site();
  }
  fs::permissions(work_, there_ ? mode_ : as_new_folders_are());
  if (::syncfs(folder_.descriptor()) != 0) {
    cannot("write", work_, errno);
  }
  if (there_) {
    // Beside the place, the earlier one is what the next export removes if this is killed.
    const int mark = ::open((place_ / unfinished_name).c_str(),
                            O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, as_files_are);
    if (mark < 0) {
      cannot("write", place_ / unfinished_name, errno);
    }
    ::close(mark);
  }
  const unsigned how = there_ ? RENAME_EXCHANGE : RENAME_NOREPLACE;
  if (::renameat2(AT_FDCWD, work_.c_str(), AT_FDCWD, place_.c_str(), how) != 0) {
    const int why = errno;
    std::error_code ignored;
    if (there_) {
      fs::remove(place_ / unfinished_name, ignored);
    }
    cannot("put the site at", place_, why);
  }
  in_place_ = true;
  std::error_code ignored;
  fs::remove(place_ / unfinished_name, ignored);
  return !there_ || own_files_of_stopped(work_).remove() ? std::nullopt
                                                         : std::optional(work_.string());
}

}  // namespace changeover::serve
