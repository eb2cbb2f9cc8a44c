#include "answer/converter.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string_view>

#include "changeover/core/error.hpp"

namespace changeover::cli {
namespace {

constexpr const char* converter_name = "rsvg-convert";

struct Closer {
  void operator()(std::FILE* file) const { static_cast<void>(std::fclose(file)); }
};
using File = std::unique_ptr<std::FILE, Closer>;

// A file without a name. What goes to and comes from another program goes through such, so that
// none waits for the other.
File nameless_file() {
  File file(std::tmpfile());
  if (!file) {
    throw MissingResource(
        fmt::format("a temporary file cannot be made: {}; free some space for temporary files",
                    std::strerror(errno)));
  }
  return file;
}

std::string contents(const File& file) {
  std::rewind(file.get());
  std::string text;
  std::array<char, 65536> buffer;
  while (const std::size_t read = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
    text.append(buffer.data(), read);
  }
  return text;
}

class Actions {
 public:
  Actions() { posix_spawn_file_actions_init(&actions_); }
  ~Actions() { posix_spawn_file_actions_destroy(&actions_); }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;

  void connect(const File& file, int stream) {
    posix_spawn_file_actions_adddup2(&actions_, fileno(file.get()), stream);
  }
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

// Whether a file of that format begins and ends so: half a picture is none.
bool is_whole(std::string_view file, const std::string& format) {
  using namespace std::string_view_literals;
  if (format == "png") {
    return file.starts_with("\x89PNG\r\n\x1a\n"sv) &&
           file.ends_with("\0\0\0\0IEND\xae\x42\x60\x82"sv);
  }
  constexpr std::string_view end = "%%EOF";
  const std::size_t last = file.find_last_not_of("\r\n");
  return file.starts_with("%PDF-") && last != std::string_view::npos &&
         file.substr(0, last + 1).ends_with(end);
}

// The first line of what a program complained of, as much as fits into a message.
std::string first_line(const std::string& said) {
  constexpr std::size_t most_bytes = 300;
  return said.empty() ? "it says nothing" : said.substr(0, std::min(said.find('\n'), most_bytes));
}

}  // namespace

std::string converter_path() {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "/usr/local/bin:/usr/bin:/bin" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::string file = (folder.empty() ? "." : folder) + "/" + converter_name;
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0) {
      return file;
    }
  }
  return {};
}

std::string converted(const std::string& svg, const std::string& format, unsigned zoom) {
  const File input = nameless_file();
  const File output = nameless_file();
  const File complaints = nameless_file();
  if (std::fwrite(svg.data(), 1, svg.size(), input.get()) != svg.size() ||
      std::fflush(input.get()) != 0) {
    throw MissingResource(fmt::format(
        "a temporary file of {} bytes cannot be written: {}; free some space for temporary files",
        svg.size(), std::strerror(errno)));
  }
  std::rewind(input.get());

  Actions actions;
  actions.connect(input, STDIN_FILENO);
  actions.connect(output, STDOUT_FILENO);
  actions.connect(complaints, STDERR_FILENO);
  std::array<std::string, 5> words = {converter_name, "--format", format, "--zoom",
                                      std::to_string(zoom)};
  std::array<char*, 6> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) {
    arguments[i] = words[i].data();
  }
  pid_t process = 0;
  const int failure =
      posix_spawnp(&process, converter_name, actions.get(), nullptr, arguments.data(), environ);
  int status = 0;
  if (failure == 0) {
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
  }
  // A shell's way to say that there is no such program; posix_spawnp may say so itself or leave it
  // to the child.
  constexpr int not_there = 127;
  if (failure != 0 || (WIFEXITED(status) && WEXITSTATUS(status) == not_there)) {
    throw MissingResource(fmt::format(
        "--format {} needs {}, which is not installed; install the Debian package librsvg2-bin, "
        "or write svg",
        format, converter_name));
  }
  std::string picture = contents(output);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || picture.empty()) {
    throw MissingResource(fmt::format("{} could not write {}: {}; write an .svg file",
                                      converter_name, format, first_line(contents(complaints))));
  }
  if (!is_whole(picture, format)) {
    throw MissingResource(
        fmt::format("{} wrote {} bytes that are not a whole {}; write an .svg file", converter_name,
                    picture.size(), format));
  }
  return picture;
}

}  // namespace changeover::cli
