// Bytes from outside: a file, standard input, or a string.
//
//     std::unique_ptr<Input> input = open_input("mine.txt");    // "-": standard input
//     Design design = read_text(std::move(input));
//
// Everything is read through one buffer of the reader, so no Input needs memory for its contents.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"

namespace changeover {

/// A stream of bytes with a name for messages.
class Input {
 public:
  virtual ~Input() = default;

  /// Its name in messages: the path, or "<stdin>".
  [[nodiscard]] const std::string& name() const { return name_; }

  /// Fills the front of `buffer` and returns how many bytes it got; 0 only at the end.
  /// @throws MissingResource if the system fails to read.
  virtual std::size_t read(std::span<char> buffer) = 0;

  /// Starts over at the first byte; returns false and changes nothing if that is impossible.
  virtual bool rewind() { return false; }

 protected:
  explicit Input(std::string name) : name_(std::move(name)) {}
  Input(const Input&) = default;
  Input& operator=(const Input&) = default;

 private:
  std::string name_;
};

/// Opens a file, or standard input for "-". For a FIFO it waits until a process writes to it.
/// @throws MissingResource with one line if it is missing, unreadable or a directory.
[[nodiscard]] std::unique_ptr<Input> open_input(const std::string& path);

/// Opens a list: a file as open_input() opens it, or one sheet of a workbook. "parts.xlsx:Costs"
/// means the sheet Costs of parts.xlsx, unless there is a file with this whole name. @throws as
/// open_input(); reading throws if there is no such sheet.
[[nodiscard]] std::unique_ptr<Input> open_list(const std::string& path);
/// The path of the file: "parts.xlsx".
[[nodiscard]] std::string list_file(const std::string& path);

/// A string as input.
[[nodiscard]] std::unique_ptr<Input> input_from_text(std::string text, std::string name = "<text>");

/// All bytes to the end. @throws MissingResource as read(), and if there are more than `limit`; the
/// line then ends with `how_to_mend`.
[[nodiscard]] std::string read_to_end(
    Input& input, std::size_t limit = std::size_t{1} << 32,
    std::string_view how_to_mend = "write it as text with a first line '# changeover design v=…'");

// The rules of all readers: how blocks from outside become a design.
//
// A file from another program rarely has all of its parameters. They come, in this order, from the
// caller
// (ReadOptions), from the file, and from these rules:
//   - k is the number of elements of the first block; every other block must agree.
//   - change is the number of elements in which the first two blocks differ (2 if there is one
//     block or they are equal), kind is linear, strength is 2.
//   - Elements are *numbers* (plain decimals: digits, no needless leading zero) or *labels*. If the
//     file lists its labels, each element is looked up there. If it declares v, either all elements
//     are numbers below v, or all are labels, numbered as they first occur, at most v of them. If
//     it does not, the elements that occur are the whole set: numbers 0 … n−1 stay as they are,
//     other numbers become labels in increasing order, anything else labels in the order of
//     occurrence.
//   - At most 65,535 elements, in a block and altogether; in every format a name has at most 255
//     bytes and no label_defect(): UTF-8 without control characters.
//
// A violation is BadInput with one line: `NAME:LINE:COLUMN: what is wrong; how to correct it`.
// Lines and columns count from 1, columns in bytes. If an option of the caller is at fault (v or k
// that no file can have, a change of 0 or of more than k elements, a strength above k), it is
// BadOption without a place.

/// Parameters from the caller; they override those of the file.
struct ReadOptions {
  std::optional<std::uint64_t> v = {};
  std::optional<std::uint64_t> k = {};
  std::optional<std::uint64_t> change = {};
  std::optional<Kind> kind = {};
  std::optional<std::uint32_t> strength = {};
  bool no_other = false;  ///< a file that declares another of these numbers is refused
};

/// A design from outside as a stream.
class DesignInput : public BlockSource {
 public:
  /// One name per element, or empty if elements are numbers; complete once next() has said false.
  [[nodiscard]] virtual const std::vector<std::string>& labels() const = 0;

  /// The recipe that came with the blocks, if any. It is a claim: it may make other blocks.
  [[nodiscard]] virtual const std::optional<Recipe>& recipe() const = 0;
};

/// The whole stream with its labels and recipe. @throws as next().
[[nodiscard]] Design read_all(DesignInput& input);

// A design from a file of any known format.
//
//     Design design = read_design("mine.txt");                      // "-": standard input
//     auto stream = open_design("huge.txt", {.kind = Kind::circular});
//     Verdict verdict = verify(*stream);
//
// The first byte that is not blank decides: `{` or `[` is JSON, unless it can only be blocks in
// brackets; `<` is XML of designtheory.org. Otherwise, a text that begins like a design of GAP or
// Sage, or like blocks in brackets (io/formats.hpp), is one, a first line with a comma or semicolon
// (before any `#`) is CSV, and all else is text. File names do not matter.

enum class Format : std::uint8_t { text, json, csv, xml, literal, brackets };

/// The format of a file that begins with these bytes; a few hundred are enough.
[[nodiscard]] Format guess_format(std::string_view beginning);

/// The whole design with labels and recipe.
/// @throws MissingResource with one line if the file cannot be read; BadInput as io/input.hpp
/// says.
[[nodiscard]] Design read_design(const std::string& path, const ReadOptions& options = {});
[[nodiscard]] Design read_design(std::unique_ptr<Input> input, const ReadOptions& options = {});

/// The design as a stream: text is read as it is needed (see io/formats.hpp for when it is kept),
/// all other formats are held in memory. @throws as read_design(), from here or from next().
[[nodiscard]] std::unique_ptr<DesignInput> open_design(const std::string& path,
                                                       const ReadOptions& options = {});
[[nodiscard]] std::unique_ptr<DesignInput> open_design(std::unique_ptr<Input> input,
                                                       const ReadOptions& options = {});

}  // namespace changeover
