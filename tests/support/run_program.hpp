// Runs a shell command and keeps what it said.
#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
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

/// A bare machine may have no /dev/full; a program that writes to it there makes a file of that
/// name.
inline bool has_full_device() {
  std::error_code ignored;
  return std::filesystem::is_character_file("/dev/full", ignored);
}

/// Runs `command` with bash; $changeover and $checkdesign are the programs, $all_pairs the
/// example that is built beside them. Its folder is `folder`.
inline Outcome run(const std::string& command, const std::filesystem::path& folder) {
  const TemporaryFolder streams;
  const std::string out = streams.file("out");
  const std::string err = streams.file("err");
  // No other shell before it, and none that waits for its last command: each takes as long as the
  // program.
  std::string script = "export changeover='" + std::string(CHANGEOVER_PROGRAM) + "' checkdesign='" +
                       std::string(CHECKDESIGN_PROGRAM) + "' all_pairs='" +
                       std::filesystem::path(CHANGEOVER_PROGRAM).parent_path().string() +
                       "/examples/all_pairs'; cd '" + folder.string() + "'; " + command;
  std::string bash = "bash";
  std::string words = "-c";
  const std::array<char*, 4> arguments{bash.data(), words.data(), script.data(), nullptr};
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  constexpr int made = O_WRONLY | O_CREAT | O_TRUNC;
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), made, 0600);
  ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), made, 0600);
  pid_t process = 0;
  int status = -1;
  const int fault =
      ::posix_spawnp(&process, bash.c_str(), &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (fault != 0) {
    return {.code = -1, .out = {}, .err = std::strerror(fault)};
  }
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return {.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          .out = slurp(out),
          .err = slurp(err)};
}

}  // namespace changeover::test
