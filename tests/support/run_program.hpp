// Runs a shell command and keeps what it said.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace changeover::test {

struct Outcome {
  int code = -1;
  std::string out;
  std::string err;
};

/// A folder that goes away with its owner.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern =
        (std::filesystem::temp_directory_path() / "changeover-test-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

inline std::string slurp(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline void spit(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// A bare machine may have no /dev/full; whoever writes to it there makes a file of that name.
inline bool has_full_device() {
  std::error_code ignored;
  return std::filesystem::is_character_file("/dev/full", ignored);
}

/// Runs `command` with bash; $changeover and $checkdesign are the programs, $all_pairs the
/// example that is built beside them. Its folder is `folder`.
inline Outcome run(const std::string& command, const std::filesystem::path& folder) {
  const TemporaryFolder streams;
  const std::string script = "export changeover='" + std::string(CHANGEOVER_PROGRAM) +
                             "' checkdesign='" + std::string(CHECKDESIGN_PROGRAM) +
                             "' all_pairs='" +
                             std::filesystem::path(CHANGEOVER_PROGRAM).parent_path().string() +
                             "/examples/all_pairs'; cd '" + folder.string() + "'; " + command;
  spit(streams.file("script"), script);
  const std::string line = "bash '" + streams.file("script") + "' >'" + streams.file("out") +
                           "' 2>'" + streams.file("err") + "' </dev/null";
  const int status = std::system(line.c_str());
  Outcome outcome;
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.out = slurp(streams.file("out"));
  outcome.err = slurp(streams.file("err"));
  return outcome;
}

}  // namespace changeover::test
