// Colours of the themes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "changeover/draw/picture.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

struct Colour {
  double red = 0, green = 0, blue = 0;  // 0 to 255
};

Colour colour_of(std::string_view hex) {
  const auto part = [&](std::size_t at) {
    int value = 0;
    std::from_chars(hex.data() + at, hex.data() + at + 2, value, 16);
    return static_cast<double>(value);
  };
  return {part(1), part(3), part(5)};
}

struct Palette {
  std::string_view ground, ink, soft, hairline, accent, alarm;
  std::array<std::string_view, Paint::series_length> series;
  double ramp_from, ramp_to;  // the part of viridis that stands out from the ground
};

// Okabe and Ito; on white, orange and sky blue are darkened until they stand out from it.
constexpr Palette light = {
    "#FFFFFF",
    "#1A1A1A",
    "#5A5A5A",
    "#D4D4D4",
    "#00629B",
    "#B03A00",
    {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#AD7800", "#2E8BC4", "#000000"},
    0,
    0.58};
constexpr Palette dark = {
    "#14171A",
    "#ECECEC",
    "#A8ADB2",
    "#3A4046",
    "#6CC4F5",
    "#FF9A5C",
    {"#2A8FD0", "#E8711A", "#00B585", "#D98CB6", "#E69F00", "#8CCFF5", "#FFFFFF"},
    0.38,
    1};

constexpr std::array<std::string_view, 11> viridis = {"#440154", "#482475", "#414487", "#355F8D",
                                                      "#2A788E", "#21918C", "#22A884", "#44BF70",
                                                      "#7AD151", "#BDDF26", "#FDE725"};

const Palette& palette(Theme theme) { return theme == Theme::light ? light : dark; }

std::string on_ramp(const Palette& palette, double value) {
  const double at = (palette.ramp_from + value * (palette.ramp_to - palette.ramp_from)) *
                    static_cast<double>(viridis.size() - 1);
  const auto lower = std::min(static_cast<std::size_t>(at), viridis.size() - 2);
  const double part = at - static_cast<double>(lower);
  const Colour a = colour_of(viridis[lower]);
  const Colour b = colour_of(viridis[lower + 1]);
  const auto mixed = [&](double x, double y) {
    return static_cast<int>(std::lround(x + part * (y - x)));
  };
  return fmt::format("#{:02X}{:02X}{:02X}", mixed(a.red, b.red), mixed(a.green, b.green),
                     mixed(a.blue, b.blue));
}

// Relative luminance and contrast as WCAG 2.1 has them.
double luminance(const Colour& colour) {
  const auto linear = [](double value) {
    value /= 255;
    return value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

double contrast(std::string_view one, std::string_view other) {
  const double a = luminance(colour_of(one));
  const double b = luminance(colour_of(other));
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

constexpr std::string_view black = "#000000", white = "#FFFFFF";

constexpr double steps_of_a_ramp = 1000;

}  // namespace

std::string_view to_string(Theme theme) { return theme == Theme::light ? "light" : "dark"; }

std::optional<Theme> theme_from_string(std::string_view name) {
  return named(name, {Theme::light, Theme::dark});
}

Paint Paint::series(std::size_t index) {
  Paint paint(Role::series);
  paint.index_ = static_cast<std::uint16_t>(index % series_length);
  return paint;
}

Paint Paint::ramp(double value) {
  Paint paint(Role::ramp);
  paint.index_ =
      static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0, 1.0) * steps_of_a_ramp));
  return paint;
}

Paint Paint::upon(Paint below) {
  below.upon_ = true;
  return below;
}

std::string Paint::hex(Theme theme) const {
  const Palette& shades = palette(theme);
  std::string colour;
  switch (role_) {
    case Role::none:
      return "";
    case Role::ground:
      colour = shades.ground;
      break;
    case Role::ink:
      colour = shades.ink;
      break;
    case Role::soft:
      colour = shades.soft;
      break;
    case Role::hairline:
      colour = shades.hairline;
      break;
    case Role::accent:
      colour = shades.accent;
      break;
    case Role::alarm:
      colour = shades.alarm;
      break;
    case Role::series:
      colour = shades.series[index_];
      break;
    case Role::ramp:
      colour = on_ramp(shades, index_ / steps_of_a_ramp);
      break;
  }
  if (upon_) {
    return std::string(contrast(colour, black) > contrast(colour, white) ? black : white);
  }
  return colour;
}

}  // namespace changeover
