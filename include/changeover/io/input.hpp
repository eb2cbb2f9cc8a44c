// Bytes from outside: a file, standard input, or a string.
//
//     std::unique_ptr<Input> input = open_input("mine.txt");    // "-": standard input
//     Design design = read_text(*input);
//
// Everything is read through one buffer of the reader, so no Input needs memory for its contents.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace changeover {

/// A stream of bytes with a name for messages.
class Input {
 public:
  virtual ~Input() = default;

  /// What messages call it: the path, or "<stdin>".
  [[nodiscard]] const std::string& name() const { return name_; }

  /// Fills the front of `buffer` and returns how many bytes it got; 0 only at the end.
  /// @throws MissingResource if the system fails to read.
  virtual std::size_t read(std::span<char> buffer) = 0;

  /// Starts over at the first byte; false, and no change, if that is impossible.
  virtual bool rewind() { return false; }

 protected:
  explicit Input(std::string name) : name_(std::move(name)) {}
  Input(const Input&) = default;
  Input& operator=(const Input&) = default;

 private:
  std::string name_;
};

/// Opens a file, or standard input for "-". A FIFO is waited for until somebody writes to it.
/// @throws MissingResource with one line if it is missing, unreadable or a directory.
[[nodiscard]] std::unique_ptr<Input> open_input(const std::string& path);

/// A string as input.
[[nodiscard]] std::unique_ptr<Input> input_from_text(std::string text, std::string name = "<text>");

/// All bytes to the end. @throws MissingResource as read(), and if there are more than `limit`.
[[nodiscard]] std::string read_to_end(Input& input, std::size_t limit = std::size_t{1} << 32);

}  // namespace changeover
