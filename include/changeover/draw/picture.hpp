// Pictures before they are written: marks that say what they are, in groups, and two writers for
// them.
//
//     Picture picture{.width = 200, .height = 40, .title = "One stay"};
//     picture.add({.shape = Rectangle{.x = 10, .y = 10, .width = 120, .height = 20},
//                  .kind = "stay",
//                  .title = "element 3 stays for blocks 2 to 5",
//                  .data = {{"element", "3"}, {"from", "2"}, {"to", "5"}},
//                  .style = {.fill = Paint::series(0)}});
//     std::string page = svg(picture, Theme::dark);       // a whole SVG file
//     std::string figure = tikz(picture);                 // one tikzpicture, for \usepackage{tikz}
//
// Lengths are CSS pixels (of TeX 3/4 bp), x to the right, y downwards. A mark has no colour but a
// *paint*, a role that the theme turns into a colour when the picture is written, so one picture
// serves light and dark grounds. Colours of series are those of Okabe and Ito, those of a ramp are
// viridis; both as far as they stand out from the ground: every mark by 3:1, every text by 4.5:1
// (WCAG 2.1).
//
// SVG has presentation attributes and classes only: no style sheet, no style attribute, no script,
// no ids, no link. So it can be put into a page under the strictest policy, several of them into
// one page. Texts from outside are escaped; what is no character is shown as U+FFFD.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace changeover {

/// What the picture stands on.
enum class Theme : std::uint8_t { light, dark };

/// "light" or "dark".
[[nodiscard]] std::string_view to_string(Theme theme);

/// The theme of that name; nullopt for any other word.
[[nodiscard]] std::optional<Theme> theme_from_string(std::string_view name);

/// The role of a colour. Colours of texts: ink, soft, accent, alarm, and upon().
class Paint {
 public:
  enum class Role : std::uint8_t { none, ground, ink, soft, hairline, accent, alarm, series, ramp };

  Paint(Role role = Role::none) : role_(role) {}  // NOLINT(google-explicit-constructor)

  /// One of seven that can be told apart; from the eighth on the seven repeat (add dashes).
  [[nodiscard]] static Paint series(std::size_t index);
  static constexpr std::size_t series_length = 7;

  /// From 0 to 1 by lightness; what lies beyond is cut to that.
  [[nodiscard]] static Paint ramp(double value);

  /// Black or white, whichever can be read on a mark of that paint.
  [[nodiscard]] static Paint upon(Paint below);

  [[nodiscard]] Role role() const { return role_; }

  /// "#RRGGBB"; empty for none.
  [[nodiscard]] std::string hex(Theme theme) const;

  bool operator==(const Paint&) const = default;

 private:
  Role role_;
  bool upon_ = false;
  std::uint16_t index_ = 0;  // of the series, or thousandths of the ramp
};

enum class Anchor : std::uint8_t { start, middle, end };

/// How a mark looks; what is not said is as in the group around it.
struct Style {
  std::optional<Paint> fill = {};           ///< at first ink
  std::optional<Paint> stroke = {};         ///< at first none
  std::optional<double> stroke_width = {};  ///< at first 1
  std::optional<double> dash = {};          ///< length of dashes and gaps; 0, as at first: none
  std::optional<double> font_size = {};     ///< at first 12
  std::optional<bool> bold = {};
  std::optional<Anchor> anchor = {};

  bool operator==(const Style&) const = default;
};

struct Point {
  double x = 0;
  double y = 0;

  bool operator==(const Point&) const = default;
};

struct Rectangle {
  double x = 0, y = 0, width = 0, height = 0;
  double radius = 0;  ///< of its corners
};

struct Segment {
  Point from, to;
};

struct Disc {
  Point centre;
  double radius = 0;
};

/// Lines through points, one for each part; filled as one shape.
struct Path {
  std::vector<std::vector<Point>> parts = {};
  bool closed = false;
};

/// One line of text on a baseline.
struct Text {
  Point at = {};
  std::string content = {};
  bool element = false;     ///< the name of an element: in TeX, ∞_s is a symbol with a subscript
  bool introduced = false;  ///< a star above follows it
  bool leaving = false;     ///< a star below follows it
};

struct Mark;

/// Marks that share a style and what is said of them.
struct Group {
  std::vector<Mark> marks;  // Not "= {}": clang would ask what a mark is.
};

/// One thing in a picture.
struct Mark {
  std::variant<Group, Rectangle, Segment, Disc, Path, Text> shape = {};
  std::string kind = {};   ///< its class: letters and hyphens; may be empty
  std::string title = {};  ///< what a reader is told who points at it; may be empty
  std::vector<std::pair<std::string, std::string>> data = {};  ///< attributes data-NAME
  Style style = {};
};

struct Picture {
  double width = 0;
  double height = 0;
  std::string title = {};        ///< the name of the picture, for readers who do not see it
  std::string description = {};  ///< what it shows
  std::vector<Mark> marks = {};

  void add(Mark mark) { marks.push_back(std::move(mark)); }
};

/// The number of marks that are no groups.
[[nodiscard]] std::size_t mark_count(const Picture& picture);

/// How wide a line of text may become in a usual font without serifs: an upper bound, as pictures
/// leave room for it.
[[nodiscard]] double text_width(std::string_view text, double font_size, bool bold = false);

/// A complete SVG file. O(its length).
[[nodiscard]] std::string svg(const Picture& picture, Theme theme = Theme::light);

/// TeX has a limited memory: the greatest number of marks of a picture for it.
inline constexpr std::size_t most_marks_of_tikz = 10'000;

/// One tikzpicture. @throws BadInput if the picture has more than most_marks_of_tikz marks.
[[nodiscard]] std::string tikz(const Picture& picture, Theme theme = Theme::light);

}  // namespace changeover
