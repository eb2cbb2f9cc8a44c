// The external representation of designtheory.org.
#include <fmt/format.h>

#include <string>

#include "changeover/io/formats.hpp"
#include "core/printable.hpp"
#include "io/read/point_blocks.hpp"
#include "io/scan/xml_events.hpp"

namespace changeover {
namespace {

// "&#63;" and "&amp;" in our instruction, which must not contain "?>".
std::string without_marks(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = text.substr(at);
    const bool question = rest.starts_with("&#63;");
    const bool ampersand = rest.starts_with("&amp;");
    result += question ? '?' : ampersand ? '&' : rest.front();
    at += question || ampersand ? 5 : 1;
  }
  return result;
}

class DesignTheory final : public XmlHandler {
 public:
  DesignTheory(std::string_view text, const std::string& name)
      : points_(text, name), reader_(name, *this) {}

  Design read(std::string_view text, const ReadOptions& options) {
    reader_.feed(text);
    reader_.finish();
    if (!points_.has_blocks()) {
      points_.fail(0, "no block_design with blocks; add it, or name another file");
    }
    if (!points_.v()) {
      points_.fail(0, "block_design has no attribute v; give the number of points");
    }
    return points_.finish(options, 0);
  }

  void begin(std::string_view name, const XmlAttributes& attributes) override {
    ++depth_;
    if (depth_ == 1 && name != "list_of_designs") {
      fail(fmt::format("the file begins with {}; put the design into a list_of_designs",
                       shown(name)));
    }
    if (name == "block_design") {
      if (designs_++ > 0) {
        fail("a second design; give one design per file");
      }
      design_depth_ = depth_;
      if (const auto v = attributes.find("v")) {
        points_.declare_v(*v, reader_.offset());
      }
    } else if (name == "blocks" && depth_ == design_depth_ + 1 && designs_ > 0) {
      in_blocks_ = true;
    } else if (in_blocks_ && name == "block" && !in_block_) {
      in_block_ = true;
    } else if (in_block_ && name == "z") {
      in_point_ = true;
      point_offset_ = reader_.offset();
      word_.clear();
    } else if (in_blocks_) {
      fail(fmt::format("{} among the blocks; write points as <z>0</z>", shown(name)));
    }
  }

  void end(std::string_view name) override {
    --depth_;
    if (in_point_) {
      in_point_ = false;
      points_.add(word_, point_offset_);
    } else if (in_block_) {
      in_block_ = false;
      points_.end_block(reader_.offset());
    } else if (name == "blocks") {
      in_blocks_ = false;
    }
  }

  void text(std::string_view piece) override {
    for (const char c : piece) {
      const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
      if (in_point_ && !blank) {
        word_ += c;
      } else if (in_blocks_ && !blank) {
        fail("text among the blocks; write points as <z>0</z>");
      }
    }
    constexpr std::size_t longest = 30;
    if (word_.size() > longest) {
      fail("not a point; points are whole numbers");
    }
  }

  void instruction(std::string_view target, std::string_view words) override {
    if (target == "changeover") {
      const std::string plain = without_marks(words);
      points_.comment((plain.starts_with("design") ? "changeover " : "") + plain, reader_.offset());
    }
  }

 private:
  [[noreturn]] void fail(std::string_view what) const { points_.fail(reader_.offset(), what); }

  PointBlocks points_;
  XmlReader reader_;
  std::size_t depth_ = 0;
  std::size_t design_depth_ = 0;
  std::size_t designs_ = 0;
  bool in_blocks_ = false;
  bool in_block_ = false;
  bool in_point_ = false;
  std::size_t point_offset_ = 0;
  std::string word_;
};

}  // namespace

Design read_designtheory(Input& input, const ReadOptions& options) {
  const std::string text =
      read_to_end(input, most_foreign_bytes, "write it as text, one block per line");
  return DesignTheory(text, input.name()).read(text, options);
}

}  // namespace changeover
