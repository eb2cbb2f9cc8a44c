// The files of the example: results that are written at any place, and files in memory to compare with.
//
//     const Output gram("vectors.gram", 0);
//     gram.write(&value, sizeof value, offset);          // by any thread
//     gram.sync();                                       // it is on the disk
//     const Mapping data("vectors.f32");
//     data.as<float>()[0];
//
// Both throw changeover::MissingResource, one line that names the file.
#pragma once

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

#include "changeover/core/error.hpp"

// A file that is written in pieces, at any place.
class Output {
 public:
  Output(std::string path, int flags) : path_(std::move(path)) {
    file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | flags, 0666);
    if (file_ < 0) {
      refuse();
    }
  }
  ~Output() { ::close(file_); }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  // Cuts off what an earlier result had beyond it.
  void resize(std::uint64_t bytes) const {
    if (::ftruncate(file_, static_cast<off_t>(bytes)) != 0) {
      refuse();
    }
  }

  void write(const void* bytes, std::size_t count, std::uint64_t offset) const {
    const auto* from = static_cast<const char*>(bytes);
    while (count > 0) {
      const ssize_t written = ::pwrite(file_, from, count, static_cast<off_t>(offset));
      if (written < 0 && errno != EINTR) {
        refuse();
      }
      const auto done = static_cast<std::size_t>(written < 0 ? 0 : written);
      from += done;
      offset += done;
      count -= done;
    }
  }

  void sync() const {
    if (::fdatasync(file_) != 0) {
      refuse();
    }
  }

 private:
  [[noreturn]] void refuse() const {
    throw changeover::MissingResource(
        fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
  }

  std::string path_;
  int file_ = -1;
};

// A file in memory as far as the system likes.
class Mapping {
 public:
  explicit Mapping(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const off_t end = file < 0 ? -1 : ::lseek(file, 0, SEEK_END);
    if (end > 0) {
      bytes_ = static_cast<std::size_t>(end);
      start_ = ::mmap(nullptr, bytes_, PROT_READ, MAP_PRIVATE, file, 0);
    }
    if (file >= 0) {
      ::close(file);
    }
    if (start_ == MAP_FAILED) {
      throw changeover::MissingResource(fmt::format("{}: cannot be mapped into memory", path));
    }
  }
  ~Mapping() { ::munmap(start_, bytes_); }
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;

  template <typename T>
  [[nodiscard]] const T* as() const {
    return static_cast<const T*>(start_);
  }

 private:
  void* start_ = MAP_FAILED;
  std::size_t bytes_ = 0;
};
