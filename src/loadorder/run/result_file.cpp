#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/all_pairs.hpp"
#include "io/file/remedies.hpp"

// *Locks.* A process that has the file open holds two locks on single bytes far behind its end,
// where there are no results. One is shared by the shares of the same job, on a byte given by the
// checksum of the job. The other is exclusive, on a byte given by the share. Another job is
// detected by its lock on another byte. Each process locks before it checks, so of two that start
// at the same time at least one detects the other; if both do, both check again after a while. The
// locks belong to the open file (F_OFD_SETLK), so they end with it, and not with any descriptor.
// All processes also hold a shared flock(), because journals are locked by flock(): no file can be
// both.

namespace changeover {
namespace {

constexpr off_t jobs_from = off_t{1} << 61;
constexpr off_t jobs = off_t{1} << 60;
constexpr off_t shares_from = jobs_from + jobs;

struct flock range(short type, off_t from, off_t bytes) {
  struct flock lock {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  lock.l_start = from;
  lock.l_len = bytes;
  return lock;
}

}  // namespace

ResultFile::~ResultFile() { close(); }

void ResultFile::close() noexcept {
  if (file_ >= 0) {
    ::close(file_);
    file_ = -1;
  }
}

void ResultFile::refuse(const std::string& what) const {
  throw MissingResource(
      fmt::format("{}: {}: {}; {}", path_, what, std::strerror(errno), how_to_write(errno)));
}

bool ResultFile::is_named() const {
  struct stat mine {};
  struct stat named {};
  return ::fstat(file_, &mine) == 0 && ::stat(path_.c_str(), &named) == 0 &&
         mine.st_ino == named.st_ino && mine.st_dev == named.st_dev;
}

void ResultFile::open_unlocked() {
  file_ = ::open(path_.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
  created_ = false;
  if (file_ < 0 && errno == ENOENT) {
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    created_ = file_ >= 0;
    if (file_ < 0 && errno == EEXIST) {  // another share was faster
      file_ = ::open(path_.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
    }
  }
  struct stat status {};
  if (file_ < 0 || ::fstat(file_, &status) != 0) {
    refuse("cannot be opened for writing");
  }
  if (!S_ISREG(status.st_mode)) {
    throw BadInput(path_ +
                   ": is not a regular file, so results cannot be written into it; name another");
  }
}

void ResultFile::lock(const ResultsClaim& claim) const {
  off_t chosen = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    chosen = (chosen << 7) | (claim.job[i] & 0x7f);
  }
  const off_t mine = jobs_from + chosen;
  const auto is_other_job = [&](off_t from, off_t bytes) {
    struct flock lock = range(F_WRLCK, from, bytes);
    if (bytes == 0) {
      return false;
    }
    if (::fcntl(file_, F_OFD_GETLK, &lock) != 0) {
      refuse("cannot be locked");
    }
    return lock.l_type != F_UNLCK;
  };
  if (::flock(file_, LOCK_SH | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK) {
      refuse("cannot be locked");
    }
    throw MissingResource(path_ + ": is locked as a journal; name another file for one of them");
  }
  constexpr int attempts = 5;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    struct flock shared = range(F_RDLCK, mine, 1);
    if (::fcntl(file_, F_OFD_SETLK, &shared) != 0) {
      refuse("cannot be locked");
    }
    if (!is_other_job(jobs_from, chosen) && !is_other_job(mine + 1, jobs - chosen - 1)) {
      const auto share = static_cast<off_t>(claim.share.index % static_cast<std::uint64_t>(jobs));
      struct flock alone = range(F_WRLCK, shares_from + share, 1);
      if (::fcntl(file_, F_OFD_SETLK, &alone) == 0) {
        return;
      }
      if (errno != EAGAIN && errno != EACCES) {
        refuse("cannot be locked");
      }
      throw MissingResource(fmt::format(
          "{}: another process computes share {} of {} of this job; wait until it finishes", path_,
          claim.share.index, claim.share.of));
    }
    struct flock none = range(F_UNLCK, mine, 1);
    static_cast<void>(::fcntl(file_, F_OFD_SETLK, &none));
    // Different times for different jobs.
    std::this_thread::sleep_for(std::chrono::milliseconds(1 + chosen % 16));
  }
  throw MissingResource(path_ + ": another job writes its results there; wait until it finishes");
}

void ResultFile::reserve(std::uint64_t bytes) const {
  struct stat status {};
  if (::fstat(file_, &status) != 0) {
    refuse("cannot be read");
  }
  const auto length = static_cast<off_t>(bytes);
  if (bytes > 0 && ::fallocate(file_, 0, 0, length) != 0 && errno != EOPNOTSUPP &&
      errno != ENOSYS) {
    const int error = errno;
    // Removes what was added in vain.
    static_cast<void>(::ftruncate(file_, status.st_size));
    errno = error;
    refuse(fmt::format("there is no space for {} bytes of results", bytes));
  }
  if (::ftruncate(file_, length) != 0) {
    refuse(fmt::format("cannot be made {} bytes long", bytes));
  }
}

void ResultFile::open(std::uint64_t bytes, const ResultsClaim& claim) {
  if (bytes > static_cast<std::uint64_t>(jobs_from)) {
    throw MissingResource(
        fmt::format("{}: no file can hold {} bytes of results; compute fewer", path_, bytes));
  }
  try {
    // A process that could not start removes the file that it has made, perhaps just now.
    for (int attempt = 0; attempt < 100; ++attempt) {
      open_unlocked();
      lock(claim);
      if (is_named()) {
        break;
      }
      close();
    }
    if (file_ < 0) {
      throw MissingResource(
          path_ + ": other processes keep replacing this file; stop them, or name another file");
    }
    reserve(bytes);
    bytes_ = bytes;
  } catch (...) {
    // Another job may have found and locked the file meanwhile: then it belongs to that job.
    struct flock all = range(F_WRLCK, 0, 0);
    if (created_ && file_ >= 0 && ::fcntl(file_, F_OFD_SETLK, &all) == 0 && is_named()) {
      ::unlink(path_.c_str());
    }
    close();
    throw;
  }
}

void ResultFile::write(const void* bytes, std::size_t count, std::uint64_t offset) const {
  const auto* from = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t written = ::pwrite(file_, from, count, static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written < 0) {
      refuse("cannot be written");
    }
    from += written;
    offset += static_cast<std::uint64_t>(written);
    count -= static_cast<std::size_t>(written);
  }
}

void ResultFile::read(void* bytes, std::size_t count, std::uint64_t offset) const {
  auto* to = static_cast<char*>(bytes);
  while (count > 0) {
    const ssize_t got = ::pread(file_, to, count, static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got < 0) {
      refuse("cannot be read");
    }
    if (got == 0) {
      throw MissingResource(path_ + ": has become shorter while it was written; leave it alone");
    }
    to += got;
    offset += static_cast<std::uint64_t>(got);
    count -= static_cast<std::size_t>(got);
  }
}

void ResultFile::sync() const {
  if (::fdatasync(file_) != 0) {
    refuse("cannot be written");
  }
  struct stat status {};
  if (!is_named() || ::fstat(file_, &status) != 0 ||
      static_cast<std::uint64_t>(status.st_size) != bytes_) {
    throw MissingResource(path_ +
                          ": was removed, replaced or resized while it was written; start again");
  }
}

}  // namespace changeover
