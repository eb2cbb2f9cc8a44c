// What is around a picture: headline, note, legend.
//
//     Picture content;  // drawn from (0,0), with its width and height
//     return framed({.headline = "DCCD(6,4), 3 blocks"}, std::move(content),
//                   {swatch(Paint::series(0), "first stay")});
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/draw/draw.hpp"
#include "changeover/draw/picture.hpp"

namespace changeover {

struct Heading {
  std::string headline;
  std::string note = {};  ///< empty: none
};

/// A sample of `width`, drawn with its baseline at a point, and what it means.
struct LegendEntry {
  std::function<Mark(Point)> sample;
  double width = 0;
  std::string text;
};

inline constexpr double legend_font = 11;

/// A square of that paint.
[[nodiscard]] LegendEntry swatch(Paint paint, std::string text);

/// The colours of the ramp, between what its ends mean.
[[nodiscard]] LegendEntry ramp_legend(const std::string& what, const std::string& least,
                                      const std::string& most);

/// Words without a sample.
[[nodiscard]] LegendEntry remark(std::string text);

/// `content` with headline and note above it and the legend below, which breaks into lines; title
/// and description of the content stay, the title is the headline if it has none.
[[nodiscard]] Picture framed(const Heading& heading, Picture content,
                             const std::vector<LegendEntry>& legend = {});

/// Pictures below each other as one, which has the title of the first; there is one at least.
[[nodiscard]] Picture stacked(std::vector<Picture> pictures);

/// Moves marks.
void shift(std::vector<Mark>& marks, double right, double down);

/// The least of 1, 2, 5, 10, 20, … that is at least so large: how far apart the numbers of an axis
/// stand.
[[nodiscard]] std::uint64_t axis_step(double least);

// One function a kind of picture: see changeover/draw/draw.hpp. The sources may be read from where
// they stand, the limits were held.

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
