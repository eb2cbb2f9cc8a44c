// The files of the example: files in memory to compare with, and what has to be looked at before
// files are written.
//
//     const Mapping data("vectors.f32");
//     data.as<float>()[0];
//
// All throw changeover::MissingResource, one line that names the file.
#pragma once

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>

#include "changeover/core/error.hpp"

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

// a · b. @throws changeover::ImpossibleParameters if it does not fit in 64 bits.
inline std::uint64_t product(std::uint64_t a, std::uint64_t b) {
  if (b != 0 && a > std::numeric_limits<std::uint64_t>::max() / b) {
    throw changeover::ImpossibleParameters(
        "these parameters are too large, a count exceeds 64 bits; give smaller ones");
  }
  return a * b;
}

// Refuses what the disk has no space for, before it is filled up with a part of it.
inline void require_space(const std::string& path, std::uint64_t bytes) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  struct statvfs status {};
  if (::statvfs(folder.empty() ? "." : folder.c_str(), &status) != 0) {
    return;  // opening the file gives the better message
  }
  const auto pages = static_cast<std::uint64_t>(status.f_bavail);
  if (status.f_frsize != 0 && bytes / status.f_frsize >= pages) {
    throw changeover::MissingResource(
        fmt::format("{}: {} bytes are needed and {} are free; free some space or write elsewhere",
                    path, bytes, pages * status.f_frsize));
  }
}

// Whether two paths name the same file, or would if it were there.
inline bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  return std::filesystem::equivalent(a, b, error) ||
         std::filesystem::weakly_canonical(a, error) == std::filesystem::weakly_canonical(b, error);
}
