#include "loadorder/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "changeover/core/error.hpp"

namespace changeover {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
  throw MissingResource(fmt::format("{}: {}: {}", path, what, std::strerror(errno)));
}

// The name of a new file is in its folder, which must reach the disk too.
void sync_folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY);
  if (descriptor >= 0) {
    static_cast<void>(::fsync(descriptor));
    ::close(descriptor);
  }
}

std::string read_all(int file, const std::string& path) {
  std::string text;
  char piece[65536];
  while (true) {
    const ssize_t got = ::read(file, piece, sizeof piece);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got < 0) {
      refuse(path, "the journal cannot be read");
    }
    if (got == 0) {
      return text;
    }
    text.append(piece, static_cast<std::size_t>(got));
  }
}

}  // namespace

Journal::Journal(const std::string& path, const std::string& identity) : path_(path) {
  const std::string head = "changeover journal: " + identity + "\n";
  file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) {
    refuse(path, "the journal cannot be opened");
  }
  try {
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
      throw MissingResource(path + ": another process writes this journal; wait for its end");
    }
    const std::string text = read_all(file_, path);
    std::size_t good = 0;  // bytes of whole lines
    if (text.size() < head.size() && head.compare(0, text.size(), text) == 0) {
      // New, or cut off in its first line.
    } else if (text.compare(0, head.size(), head) == 0) {
      good = head.size();
      for (std::size_t end = text.find('\n', good); end != std::string::npos;
           end = text.find('\n', good)) {
        const std::string_view line = std::string_view(text).substr(good, end - good);
        if (line != fmt::format("step {}", last_ + 1)) {
          throw BadInput(
              fmt::format("{}: 'step {}' is expected where it says '{}'; remove the "
                          "journal to begin anew",
                          path, last_ + 1, line.substr(0, 40)));
        }
        ++last_;
        good = end + 1;
      }
    } else {
      throw BadInput(fmt::format(
          "{}: is the journal of another job, or none; name another file, or remove it", path));
    }
    if (::ftruncate(file_, static_cast<off_t>(good)) != 0 || ::lseek(file_, 0, SEEK_END) < 0) {
      refuse(path, "the journal cannot be written");
    }
    if (good == 0) {
      append(head);
      sync_folder_of(path);
    }
  } catch (...) {
    ::close(file_);
    throw;
  }
}

Journal::~Journal() { ::close(file_); }

void Journal::append(const std::string& text) {
  std::string_view rest = text;
  while (!rest.empty()) {
    const ssize_t written = ::write(file_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written < 0) {
      refuse(path_, "the journal cannot be written");
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::fdatasync(file_) != 0) {
    refuse(path_, "the journal cannot be written");
  }
}

void Journal::record(std::uint64_t step) {
  append(fmt::format("step {}\n", step));
  last_ = step;
}

}  // namespace changeover
