// Labels: names of cells and of designs that last.
//
//     const Parameters p{.v = 20, .k = 5, .change = 2, .kind = Kind::linear};
//     cell_label(p);                                             // "20.5.2.linear"
//     DesignLabel label = parse_design_label("20.5.2.linear.39.3fa9c1d2").value();
//     label.b;                                                   // 39
//
// A *cell* is v.k.m.kind, with .t3 behind it if the strength is 3 and not 2. A *design* is named by its cell, its number of
// blocks, and the first eight digits of the SHA-256 of its blocks: a line a block, elements as numbers separated by a
// blank, in the order in which they are written. That is what is left of a design's text without its comments:
//
//   changeover catalog show 26.4.2.circular.65 --format text | grep -v '^#' | sha256sum
//
// So a label is made of nothing but the design: two people who publish the same list of blocks give it the same label, two
// databases never give one label to two designs, and nothing has to be counted. The same design in another order of blocks or with
// other names has another label.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "changeover/core/block.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/core/sha256.hpp"

namespace changeover {

/// "61.4.2.circular", "6.4.1.linear.t3".
[[nodiscard]] std::string cell_label(const Parameters& p);

/// The parameters of a cell; nullopt if the text is not what cell_label() writes.
[[nodiscard]] std::optional<Parameters> parse_cell_label(std::string_view text);

/// How many digits of a checksum a label shows.
inline constexpr std::size_t label_digits = 8;

/// What the label of a design says.
struct DesignLabel {
  Parameters parameters;
  std::uint64_t b = 0;
  std::string digits;  ///< the first eight of the checksum

  bool operator==(const DesignLabel&) const = default;
};

/// "20.5.2.linear.39.3fa9c1d2".
[[nodiscard]] std::string design_label(const Parameters& p, std::uint64_t b,
                                       const Checksum& checksum);

/// nullopt if the text is not what design_label() writes.
[[nodiscard]] std::optional<DesignLabel> parse_design_label(std::string_view text);

/// Whether a reader could take the text for a label or the beginning of one, of a cell or of a
/// design: "20", "20.5.2.linear.29". Small letters, large ones and blanks make no difference. No
/// alias is such a text.
[[nodiscard]] bool reads_as_label(std::string_view text);

/// The checksum of a list of blocks as it is read, and how many there were.
struct DesignDigest {
  Checksum checksum = {};
  std::uint64_t b = 0;
};

/// Reads the stream to its end. O(bk); constant memory. @throws as BlockSource::read().
[[nodiscard]] DesignDigest design_digest(BlockSource& source);

}  // namespace changeover
