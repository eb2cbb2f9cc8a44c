#include "answer/deliver.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "changeover/core/error.hpp"
#include "cli/process.hpp"
#include "cli/status_line.hpp"
#include "request/request.hpp"

namespace changeover::cli {
namespace {

using Write = std::function<void(OutputFile&)>;

void write_to(const std::string& path, const Write& write) {
  OutputFile out(path);
  if (out.is_standard_output()) {
    status_line().end();
  }
  write(out);
  out.commit();
}

// A name in the current folder that nothing has yet, like that of the target.
std::string free_name(const std::string& target) {
  std::string name = std::filesystem::path(target).filename().string();
  if (name.empty() || name == "-" || name == "." || name == "..") {
    name = "changeover-answer";
  }
  std::error_code ignored;
  std::string free = name;
  for (int i = 1; std::filesystem::exists(std::filesystem::symlink_status(free, ignored)); ++i) {
    free = fmt::format("{}.{}", name, i);
  }
  return free;
}

}  // namespace

void deliver(const OutputRequest& output, const Write& write) {
  if (!output.precious) {
    write_to(output.path, write);
    return;
  }
  std::string fault;
  try {
    write_to(output.path, write);
    return;
  } catch (const ReaderGone& failure) {
    leave_with_the_reader();  // Nobody wants it, unless the parent said not to end for that.
    fault = failure.what();
  } catch (const MissingResource& failure) {
    fault = failure.what();
  }
  const std::string elsewhere = free_name(output.path);
  bool printed = false;
  try {
    write_to(elsewhere, write);
  } catch (const MissingResource&) {
    try {
      write_to("-", write);
      printed = true;
    } catch (const MissingResource& last) {
      throw MissingResource(fault +
                            "; nor can the current folder be written, nor standard output (" +
                            last.what() + "): the answer is lost");
    }
  }
  throw MissingResource(fault + (printed
                                     ? "; the answer was written to standard output instead"
                                     : "; the answer was written to ./" + elsewhere + " instead"));
}

void deliver(const std::string& text, const OutputRequest& output) {
  deliver(output, [&](OutputFile& out) { out.write(text); });
}

void deliver(const std::string& text, const std::string& path) {
  write_to(path, [&](OutputFile& out) { out.write(text); });
}

}  // namespace changeover::cli
