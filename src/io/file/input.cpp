#include "changeover/io/input.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "changeover/core/error.hpp"
#include "io/file/remedies.hpp"

namespace changeover {
namespace {

[[noreturn]] void cannot_read(const std::string& name, int error) {
  throw MissingResource(
      fmt::format("{}: cannot read: {}; {}", name, std::strerror(error), how_to_read(error)));
}

class FileInput final : public Input {
 public:
  FileInput(const std::string& name, int descriptor, bool owned)
      : Input(name), descriptor_(descriptor), owned_(owned) {
    struct stat status = {};
    if (fstat(descriptor_, &status) == 0) {
      if (S_ISDIR(status.st_mode)) {
        close_owned();
        cannot_read(name, EISDIR);
      }
      start_ = S_ISREG(status.st_mode) ? lseek(descriptor_, 0, SEEK_CUR) : -1;
    }
  }
  ~FileInput() override { close_owned(); }
  FileInput(const FileInput&) = delete;
  FileInput& operator=(const FileInput&) = delete;

  std::size_t read(std::span<char> buffer) override {
    for (;;) {
      const ssize_t count = ::read(descriptor_, buffer.data(), buffer.size());
      if (count >= 0) {
        return static_cast<std::size_t>(count);
      }
      if (errno != EINTR) {
        cannot_read(name(), errno);
      }
    }
  }

  bool rewind() override { return start_ >= 0 && lseek(descriptor_, start_, SEEK_SET) == start_; }

 private:
  void close_owned() {
    if (owned_) {
      ::close(descriptor_);
    }
  }

  int descriptor_;
  bool owned_;
  off_t start_ = -1;  // where rewind() goes; −1 if it cannot
};

class TextInput final : public Input {
 public:
  TextInput(std::string text, std::string name) : Input(std::move(name)), text_(std::move(text)) {}

  std::size_t read(std::span<char> buffer) override {
    const std::size_t count = std::min(buffer.size(), text_.size() - position_);
    std::copy_n(text_.data() + position_, count, buffer.data());
    position_ += count;
    return count;
  }

  bool rewind() override {
    position_ = 0;
    return true;
  }

 private:
  std::string text_;
  std::size_t position_ = 0;
};

}  // namespace

std::unique_ptr<Input> open_input(const std::string& path) {
  if (path == "-") {
    return std::make_unique<FileInput>("<stdin>", STDIN_FILENO, false);
  }
  if (path.find('\0') != std::string::npos) {  // The system would open what is before it.
    cannot_read(path, ENOENT);
  }
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    cannot_read(path.empty() ? "''" : path, errno);
  }
  return std::make_unique<FileInput>(path, descriptor, true);
}

std::unique_ptr<Input> input_from_text(std::string text, std::string name) {
  return std::make_unique<TextInput>(std::move(text), std::move(name));
}

std::string read_to_end(Input& input, std::size_t limit, std::string_view how_to_mend) {
  constexpr std::size_t piece = std::size_t{1} << 18;
  std::string text;
  for (;;) {
    const std::size_t size = text.size();
    if (text.capacity() < size + piece) {
      text.reserve(std::max(size + piece, 2 * size));
    }
    text.resize(size + piece);
    const std::size_t count = input.read(std::span(text).subspan(size));
    text.resize(size + count);
    if (count == 0) {
      return text;
    }
    if (text.size() > limit) {
      throw MissingResource(fmt::format("{}: more than the {} MiB that are held in memory; {}",
                                        input.name(), limit >> 20, how_to_mend));
    }
  }
}

}  // namespace changeover
