// One function a kind of picture: see changeover/draw/draw.hpp. The sources may be read from where
// they stand, the limits were held.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/draw/draw.hpp"
#include "changeover/draw/picture.hpp"
#include "draw/design/frame.hpp"

namespace changeover {

/// What is drawn, and how its parts are called.
struct Drawing {
  BlockSource& source;
  const DrawOptions& options;
  const std::vector<std::string>& labels;

  [[nodiscard]] const Parameters& parameters() const { return source.parameters(); }
  [[nodiscard]] std::string name(Element x) const {
    return labels.empty() ? std::to_string(x) : labels[x];
  }
  [[nodiscard]] std::string set(const std::vector<Element>& elements) const;

  /// Whether a block, counted from 0, is in the range that is drawn.
  [[nodiscard]] bool in_range(std::uint64_t index) const {
    return index + 1 >= options.from && (!options.to || index < *options.to);
  }
  [[nodiscard]] bool beyond_range(std::uint64_t index) const {
    return options.to && index >= *options.to;
  }

  /// Whether the range is known to be all of it.
  [[nodiscard]] bool is_whole() const {
    const std::optional<std::uint64_t> b = source.block_count();
    return options.from == 1 && (!options.to || (b && *options.to >= *b));
  }

  /// The name, the number of blocks if it is known, and the range.
  [[nodiscard]] Heading heading() const;

  /// "6 elements in 3 blocks" and the like, for those who cannot see the picture.
  [[nodiscard]] std::string summary() const;

  /// `last` is the number of the last block that there is, as far as the range goes; 0: there is
  /// none.
  /// @throws BadInput unless the range is all there.
  void require_range(std::uint64_t last) const;

  /// @throws BadInput with the defect if so many blocks are too many.
  void require_fits(std::uint64_t drawn) const;
};

[[nodiscard]] Picture draw_array(const Drawing& drawing);
[[nodiscard]] Picture draw_stays(const Drawing& drawing);
[[nodiscard]] Picture draw_coverage(const Drawing& drawing);
[[nodiscard]] Picture draw_design_circle(const Drawing& drawing);

}  // namespace changeover
