#include "request/inputs.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

namespace changeover::cli {

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
    const std::string read = path == "-" ? "/dev/stdin" : path;
    if (replaces && !read.empty() && std::filesystem::equivalent(output.path, read, ignored)) {
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
