#include "request/input_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "cli/cli.hpp"

namespace changeover::cli {

void refuse_to_overwrite_inputs(const std::string& output, const std::vector<InputFile>& inputs) {
  std::error_code ignored;
  if (output.empty() || output == "-" || !std::filesystem::is_regular_file(output, ignored)) {
    return;  // Terminals and the like are read and written at once.
  }
  for (const auto& [what, path] : inputs) {
    const std::string read = path == "-" ? "/dev/stdin" : path;
    if (!read.empty() && std::filesystem::equivalent(output, read, ignored)) {
      throw UsageError{
          fmt::format("--output {} is the same file as {}; write elsewhere", output, what)};
    }
  }
}

}  // namespace changeover::cli
