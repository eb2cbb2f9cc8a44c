// What is around a picture: headline, note, legend.
//
//     Picture content;  // drawn from (0,0), with its width and height
//     return framed({.headline = "DCCD(6,4), 3 blocks"}, std::move(content),
//                   {swatch(Paint::series(0), "first stay")});
#pragma once

#include <functional>
#include <string>
#include <vector>

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

/// Moves marks.
void shift(std::vector<Mark>& marks, double right, double down);

/// The least of 1, 2, 5, 10, 20, … that is at least so large: how far apart the numbers of an axis
/// stand.
[[nodiscard]] std::uint64_t axis_step(double least);

}  // namespace changeover
