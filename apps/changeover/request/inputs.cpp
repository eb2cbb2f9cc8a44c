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

}  // namespace

void check_inputs(const OutputRequest& output, const std::vector<InputFile>& inputs) {
  std::string from_stdin;
  std::error_code ignored;
  // Terminals and the like are read and written at once.
  const bool replaces = !output.path.empty() && output.path != "-" &&
                        std::filesystem::is_regular_file(output.path, ignored);
  for (const auto& [what, path] : inputs) {
    if (path == "-" && !from_stdin.empty()) {
      throw UsageError{
          fmt::format("{} and {} cannot both come from standard input", from_stdin, what)};
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
