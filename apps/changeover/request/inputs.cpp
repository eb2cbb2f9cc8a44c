#include "request/inputs.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

namespace changeover::cli {
namespace {

// Standard input is asked for what it is: not every system has /dev/stdin.
bool is_standard_input(const std::string& path) {
  struct stat named {};
  struct stat input {};
  return ::stat(path.c_str(), &named) == 0 && ::fstat(STDIN_FILENO, &input) == 0 &&
         named.st_dev == input.st_dev && named.st_ino == input.st_ino;
}

bool is_read_from(const std::string& output, const std::string& input) {
  std::error_code ignored;
  return input == "-" ? is_standard_input(output)
                      : !input.empty() && std::filesystem::equivalent(output, input, ignored);
}

// The file that a path names when it is written: links are followed, also to where nothing is yet.
std::filesystem::path written_file(std::filesystem::path path) {
  constexpr int most_links = 40;
  std::error_code ignored;
  for (int links = 0; links < most_links && std::filesystem::is_symlink(path, ignored); ++links) {
    path = path.parent_path() / std::filesystem::read_symlink(path, ignored);
  }
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const std::filesystem::path real = std::filesystem::weakly_canonical(folder, ignored);
  return (real.empty() ? folder : real) / path.filename();
}

// Whether two paths lead to one file, or would if it were there.
bool same_file(const std::string& one, const std::string& other) {
  std::error_code ignored;
  return std::filesystem::equivalent(one, other, ignored) ||
         written_file(one) == written_file(other);
}

}  // namespace

void check_kept(const std::string& output, const InputFile& kept) {
  const auto& [what, path] = kept;
  std::error_code ignored;
  const auto status = std::filesystem::status(output, ignored);
  if (output.empty() || output == "-" || path.empty() ||
      (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))) {
    return;
  }
  for (const std::string beside : {"", ".lock", "-wal", "-shm", "-journal"}) {
    if (same_file(output, path + beside)) {
      throw UsageError{
          fmt::format("--output {} would replace {}, {}; write elsewhere", output, what, path)};
    }
  }
}

void check_inputs(const OutputRequest& output, const std::vector<InputFile>& inputs) {
  std::string from_stdin;
  std::error_code ignored;
  // Terminals and the like are read and written at once.
  const bool replaces = !output.path.empty() && output.path != "-" &&
                        std::filesystem::is_regular_file(output.path, ignored);
  for (const auto& [what, path] : inputs) {
    if (path == "-" && !from_stdin.empty()) {
      throw UsageError{fmt::format(
          "{} and {} cannot both come from standard input; name a file for one", from_stdin, what)};
    }
    from_stdin = path == "-" ? what : from_stdin;
    if (replaces && is_read_from(output.path, path)) {
      throw UsageError{
          fmt::format("--output {} is the same file as {}; write elsewhere", output.path, what)};
    }
  }
}

void require_file(const std::string& option, const std::string& path, const std::string& why) {
  if (path == "-") {
    throw UsageError{fmt::format("{} -: {}; name a file", option, why)};
  }
}

}  // namespace changeover::cli
