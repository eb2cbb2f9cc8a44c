#include "io/file/remedies.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <optional>

#include "changeover/core/error.hpp"

namespace changeover {
namespace {

// What does not depend on what is done with the file.
std::optional<std::string_view> how_in_any_case(int error) {
  switch (error) {
    case EISDIR:
      return "name a file in it";
    case ELOOP:
      return "correct the symbolic link, which leads back to itself";
    case EMFILE:
    case ENFILE:
      return "close some files, or raise the limit on open ones (ulimit -n)";
    case ENAMETOOLONG:
      return "use a shorter name";
    default:
      return std::nullopt;
  }
}

}  // namespace

std::string_view how_to_read(int error) {
  switch (error) {
    case ENOENT:
    case ENOTDIR:
      return "check how the path is spelt";
    case EACCES:
    case EPERM:
      return "allow reading it";
    default:
      return how_in_any_case(error).value_or("try again or copy it elsewhere");
  }
}

std::string_view how_to_write(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "free some space or write elsewhere";
    case ENOENT:
    case ENOTDIR:
      return "make the directory first, or check how the path is spelt";
    case EACCES:
    case EPERM:
    case EROFS:
      return "allow writing there, or write elsewhere";
    case EPIPE:
    case ECONNRESET:
      return "keep the program that reads it running";
    case EFBIG:
      return "raise the limit on the size of files (ulimit -f), or write elsewhere";
    case EBADF:
      return "keep the stream open, or name a file";
    case EIO:
      return "write to another device";
    default:
      return how_in_any_case(error).value_or("write elsewhere");
  }
}

void make_folder(const std::string& path, std::string_view remedy) {
  std::error_code failure;
  std::filesystem::create_directories(path, failure);
  if (failure) {
    throw MissingResource(
        fmt::format("{}: cannot make the folder: {}; {}", path, failure.message(), remedy));
  }
}

}  // namespace changeover
