// Makes a design of blocks whose elements are numbers, as other programs write them.
//
// Such formats have no place for the change number, the kind, the strength and names; our own files
// have them in comments, with the same words as in text (io/formats.hpp): "changeover design v=7
// k=3 change=1 kind=circular", "labels: a b c".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/io/input.hpp"
#include "io/scan/place.hpp"

namespace changeover {

/// Such a text is held in memory as a whole.
inline constexpr std::size_t most_foreign_bytes = std::size_t{1} << 30;

class PointBlocks {
 public:
  /// Messages name places in this text; text and name must outlive this.
  PointBlocks(std::string_view text, const std::string& name) : text_(text), name_(&name) {}

  /// Reads a comment; ignores it unless it begins with our words. @throws BadInput if it does and
  /// is malformed.
  void comment(std::string_view words, std::size_t offset);

  /// Sets the number of points that the design declares. @throws BadInput if it is not one, or
  /// declared twice.
  void declare_v(std::string_view number, std::size_t offset);

  /// Adds a point to the block. @throws BadInput if it is not a number.
  void add(std::string_view number, std::size_t offset);
  void add(std::uint32_t number, std::size_t offset);
  void end_block(std::size_t offset);

  [[nodiscard]] bool has_blocks() const { return !ends_.empty(); }
  [[nodiscard]] std::optional<std::uint64_t> v() const { return v_; }
  [[nodiscard]] std::uint32_t least() const { return least_; }
  [[nodiscard]] std::uint32_t greatest() const { return greatest_; }

  /// The design, whose points are numbered from `first` on. @throws BadInput as io/input.hpp says.
  [[nodiscard]] Design finish(const ReadOptions& options, std::uint32_t first);

  [[noreturn]] void fail(std::size_t offset, std::string_view what) const {
    changeover::fail(*name_, place_of(text_, offset), what);
  }

 private:
  void read_labels(std::string_view words, std::size_t offset);

  struct Point {
    std::uint32_t number = 0;
    std::uint32_t offset = 0;  // the text is no longer than that
  };

  std::string_view text_;
  const std::string* name_;
  ReadOptions file_;
  std::size_t header_ = 0;
  std::optional<std::vector<std::string>> labels_;
  std::size_t labels_offset_ = 0;
  std::optional<std::uint64_t> v_;  // as the design declares
  std::size_t v_offset_ = 0;
  std::vector<Point> points_;
  std::vector<Point> ends_;  // of each block: how many points there are up to it, and where
  std::uint32_t least_ = UINT32_MAX;
  std::uint32_t greatest_ = 0;
};

}  // namespace changeover
