#include "changeover/io/input.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "changeover/io/formats.hpp"
#include "core/printable.hpp"
#include "io/read/declared.hpp"
#include "io/scan/peeked_input.hpp"
#include "io/scan/place.hpp"

namespace changeover {
namespace {

// A design in memory as a DesignInput.
class MemoryInput final : public DesignInput {
 public:
  explicit MemoryInput(Design design) : design_(std::move(design)), source_(design_) {}
  MemoryInput(const MemoryInput&) = delete;
  MemoryInput& operator=(const MemoryInput&) = delete;

  const Parameters& parameters() const override { return design_.parameters(); }
  std::optional<std::uint64_t> block_count() const override { return design_.block_count(); }
  std::span<const Element> read(std::span<Element> room) override { return source_.read(room); }
  bool rewind() override { return source_.rewind(); }
  const std::vector<std::string>& labels() const override { return design_.labels(); }
  const std::optional<Recipe>& recipe() const override { return design_.recipe; }

 private:
  Design design_;
  DesignSource source_;
};

struct Opened {
  std::unique_ptr<Input> input;
  Format format;
};

// All formats but text are read whole first, which would take long for a device or a large file of
// another kind.
void refuse_binary(const PeekedInput& input) {
  const std::string_view beginning = input.beginning();
  const auto control = std::ranges::find_if(beginning, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7f;
  });
  if (control != beginning.end()) {
    fail(input.name(), place_of(beginning, static_cast<std::size_t>(control - beginning.begin())),
         control_byte_defect(*control));
  }
}

Opened look_at(std::unique_ptr<Input> input) {
  auto peeked = std::make_unique<PeekedInput>(std::move(input));
  const Format format = guess_format(peeked->beginning());
  if (format != Format::text) {
    refuse_binary(*peeked);
  }
  return {std::move(peeked), format};
}

// The design in any format but text, which is streamed.
std::optional<Design> read_whole(const Opened& opened, const ReadOptions& options) {
  switch (opened.format) {
    case Format::json:
      return read_json(*opened.input, options);
    case Format::csv:
      return read_csv(*opened.input, options);
    case Format::xml:
      return read_designtheory(*opened.input, options);
    case Format::literal:
      return read_literal(*opened.input, options);
    case Format::brackets:
      return read_brackets(*opened.input, options);
    case Format::text:
      break;
  }
  return std::nullopt;
}

}  // namespace

Format guess_format(std::string_view beginning) {
  beginning = without_byte_order_mark(beginning);
  const std::size_t start = beginning.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) {
    return Format::text;
  }
  if (begins_like_brackets(beginning)) {
    return Format::brackets;
  }
  if (beginning[start] == '{' || beginning[start] == '[') {
    return Format::json;
  }
  if (beginning[start] == '<') {
    return Format::xml;
  }
  if (begins_like_a_literal(beginning)) {
    return Format::literal;
  }
  if (beginning.substr(start).starts_with("# changeover design") || table_defect(beginning)) {
    return Format::text;
  }
  std::string_view rest = beginning.substr(start);
  while (rest.starts_with('#')) {
    const std::size_t line_end = std::min(rest.find('\n'), rest.size());
    rest.remove_prefix(line_end);
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
  }
  const std::string_view line = rest.substr(0, rest.find('\n'));
  return line.substr(0, line.find('#')).find_first_of(",;") == std::string_view::npos ? Format::text
                                                                                      : Format::csv;
}

Design read_design(std::unique_ptr<Input> input, const ReadOptions& options) {
  Opened opened = look_at(std::move(input));
  auto design = read_whole(opened, options);
  return design ? std::move(*design) : read_text(std::move(opened.input), options);
}

Design read_design(const std::string& path, const ReadOptions& options) {
  return read_design(open_input(path), options);
}

std::unique_ptr<DesignInput> open_design(std::unique_ptr<Input> input, const ReadOptions& options) {
  Opened opened = look_at(std::move(input));
  if (auto design = read_whole(opened, options)) {
    return std::make_unique<MemoryInput>(std::move(*design));
  }
  return open_text(std::move(opened.input), options);
}

std::unique_ptr<DesignInput> open_design(const std::string& path, const ReadOptions& options) {
  return open_design(open_input(path), options);
}

}  // namespace changeover
