// What must be true of many readers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/output.hpp"
#include "support/target.hpp"

namespace changeover::fuzz {

/// Whether a text is one line of UTF-8 that no terminal obeys.
[[nodiscard]] bool is_one_plain_line(std::string_view text);

/// A text that may have several lines.
[[nodiscard]] bool is_plain(std::string_view text);

/// Whether the bytes are JSON, and plain.
[[nodiscard]] bool is_plain_json(const std::string& text);

/// Runs it; false if it refused what it was given, which it must have done in one plain line.
template <typename Work>
bool accepts(Work&& work) {
  std::string line;
  try {
    work();
    return true;
  } catch (const BadInput& fault) {
    line = fault.what();
  } catch (const ImpossibleParameters& fault) {
    line = fault.what();
  } catch (const MissingResource& fault) {
    line = fault.what();
  }
  must(is_one_plain_line(line), "what is refused is refused in one line, not: " + line);
  return false;
}

/// The parts of an input between lines that are "----": exactly `count`, empty ones for those that
/// are missing; the last has the rest.
[[nodiscard]] std::vector<std::string> parts_of(const std::string& bytes, std::size_t count);

/// What `write` writes of it.
template <typename Thing, typename Write>
std::string written(const Thing& thing, Write&& write) {
  StringSink sink;
  write(thing, sink);
  return sink.take();
}

/// `read` makes a design of a string, `write` writes one to a sink: what is read and written is
/// read as it was and written as it was.
template <typename Read, typename Write>
void read_write_read(const std::string& bytes, Read&& read, Write&& write) {
  std::string once;
  if (accepts([&] { once = written(read(bytes), write); })) {
    must(written(read(once), write) == once, "what was written is read and written as it was");
  }
}

/// A folder of this process, gone with it.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }

  /// Removes all files, and writes these.
  void empty() const;
  void put(const std::string& name, const std::string& bytes) const;
  /// The bytes of a file; nothing if there is none.
  [[nodiscard]] std::optional<std::string> bytes(const std::string& name) const;

 private:
  std::string path_;
};

}  // namespace changeover::fuzz
