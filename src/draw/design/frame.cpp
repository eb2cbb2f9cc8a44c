#include "draw/design/frame.hpp"

#include <algorithm>

#include "draw/text/measure.hpp"

namespace changeover {
namespace {

constexpr double margin = 16;
constexpr double headline_font = 14;
constexpr double note_font = 11;
constexpr double narrowest = 360;  // a headline has room
constexpr double legend_line = 18;

void move(Point& point, double right, double down) {
  point.x += right;
  point.y += down;
}

struct Mover {
  double right, down;

  void operator()(Group& group) const { shift(group.marks, right, down); }
  void operator()(Rectangle& shape) const {
    shape.x += right;
    shape.y += down;
  }
  void operator()(Segment& shape) const {
    move(shape.from, right, down);
    move(shape.to, right, down);
  }
  void operator()(Disc& shape) const { move(shape.centre, right, down); }
  void operator()(Path& shape) const {
    for (std::vector<Point>& part : shape.parts) {
      for (Point& point : part) {
        move(point, right, down);
      }
    }
  }
  void operator()(Text& shape) const { move(shape.at, right, down); }
};

}  // namespace

void shift(std::vector<Mark>& marks, double right, double down) {
  for (Mark& mark : marks) {
    std::visit(Mover{right, down}, mark.shape);
  }
}

std::uint64_t axis_step(double least) {
  for (std::uint64_t ten = 1;; ten *= 10) {
    for (const std::uint64_t step : {ten, 2 * ten, 5 * ten}) {
      if (static_cast<double>(step) >= least) {
        return step;
      }
    }
  }
}

LegendEntry swatch(Paint paint, std::string text) {
  constexpr double size = 11;
  return {[paint](Point at) {
            return Mark{
                .shape = Rectangle{.x = at.x, .y = at.y - 9.5, .width = size, .height = size},
                .style = {.fill = paint}};
          },
          size, std::move(text)};
}

LegendEntry ramp_legend(const std::string& what, const std::string& least,
                        const std::string& most) {
  constexpr int steps = 40;
  constexpr double step = 2.5, gap = 5;
  const std::string before = what + ": " + least;
  const double start = text_width(before, legend_font) + gap;
  const double end = start + steps * step + gap;
  const auto sample = [=](Point at) {
    Group group;
    group.marks.push_back({.shape = Text{.at = at, .content = before}});
    for (int i = 0; i < steps; ++i) {
      group.marks.push_back({.shape = Rectangle{.x = at.x + start + i * step,
                                                .y = at.y - 9.5,
                                                .width = step + (i + 1 < steps ? 0.3 : 0),
                                                .height = 11},
                             .style = {.fill = Paint::ramp(i / (steps - 1.0))}});
    }
    group.marks.push_back({.shape = Text{.at = {at.x + end, at.y}, .content = most}});
    return Mark{.shape = std::move(group)};
  };
  return {sample, end + text_width(most, legend_font), ""};
}

LegendEntry remark(std::string text) { return {nullptr, 0, std::move(text)}; }

Picture stacked(std::vector<Picture> pictures) {
  Picture all = std::move(pictures.front());
  for (Picture& next : std::span(pictures).subspan(1)) {
    shift(next.marks, 0, all.height);
    all.width = std::max(all.width, next.width);
    all.height += next.height;
    all.description += " " + next.title + ": " + next.description;
    std::ranges::move(next.marks, std::back_inserter(all.marks));
  }
  return all;
}

Picture framed(const Heading& heading, Picture content, const std::vector<LegendEntry>& legend) {
  const double width = std::max(content.width, narrowest);
  double y = margin + headline_font;
  Group words;
  words.marks.push_back(
      {.shape =
           Text{.at = {margin, y}, .content = fitted(heading.headline, width, headline_font, true)},
       .kind = "headline",
       .title = heading.headline,
       .style = {.font_size = headline_font, .bold = true}});
  if (!heading.note.empty()) {
    y += 1.6 * note_font;
    words.marks.push_back(
        {.shape = Text{.at = {margin, y}, .content = fitted(heading.note, width, note_font)},
         .kind = "note",
         .title = heading.note,
         .style = {.fill = Paint(Paint::Role::soft), .font_size = note_font}});
  }
  y += margin;
  shift(content.marks, margin, y);
  y += content.height;

  Group entries;
  double x = margin;
  if (!legend.empty()) {
    y += margin + legend_font;
  }
  for (const LegendEntry& entry : legend) {
    const double gap = entry.width > 0 && !entry.text.empty() ? 6 : 0;
    const std::string text = fitted(entry.text, width - entry.width - gap, legend_font);
    const double needs = entry.width + gap + text_width(text, legend_font);
    if (x > margin && x + needs > margin + width) {
      x = margin;
      y += legend_line;
    }
    if (entry.sample) {
      entries.marks.push_back(entry.sample({x, y}));
    }
    if (!text.empty()) {
      entries.marks.push_back({.shape = Text{.at = {x + entry.width + gap, y}, .content = text}});
    }
    x += needs + 18;
  }
  Picture picture = std::move(content);
  picture.width = width + 2 * margin;
  picture.height = y + (legend.empty() ? 0 : 4) + margin;
  if (picture.title.empty()) {
    picture.title = heading.headline;
  }
  picture.marks.insert(picture.marks.begin(), {.shape = std::move(words), .kind = "heading"});
  if (!entries.marks.empty()) {
    picture.add({.shape = std::move(entries),
                 .kind = "legend",
                 .style = {.fill = Paint(Paint::Role::ink), .font_size = legend_font}});
  }
  return picture;
}

}  // namespace changeover
