#include "draw/design/stays_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "core/words.hpp"
#include "draw/design/frame.hpp"
#include "draw/text/measure.hpp"

namespace changeover {
namespace {

// In a circular design that is drawn whole, the stay that is there at its end is the one that is
// there at its beginning.
void close_circle(std::vector<DrawnStay>& stays) {
  if (stays.empty() || !stays.front().began_before || !stays.back().goes_on) {
    return;
  }
  DrawnStay stay = stays.back();
  stay.over_the_end = true;
  if (stays.size() > 1) {
    stay.to = stays.front().to;
    stay.length += stays.front().length;
    stays.pop_back();
  }
  stay.began_before = stay.goes_on = false;
  stays.front() = stay;
}

}  // namespace

DrawnStays stays_of(const Drawing& drawing) {
  DrawnStays stays;
  stays.of.resize(static_cast<std::size_t>(drawing.parameters().v));
  stays.first = drawing.options.from;
  std::vector<bool> there(stays.of.size());
  bool whole = stays.first == 1;
  Transitions steps(drawing.source);
  while (steps.next()) {
    if (drawing.beyond_range(steps.index())) {
      whole = false;
      break;
    }
    if (!drawing.in_range(steps.index())) {
      continue;
    }
    const std::uint64_t number = steps.index() + 1;
    stays.last = number;
    drawing.require_fits(number + 1 - stays.first);
    for (const Element x : steps.block()) {
      if (!there[x]) {
        stays.of[x].push_back(
            {.from = number, .to = number, .began_before = true, .goes_on = true});
        there[x] = true;
      }
      stays.of[x].back().to = number;
      ++stays.of[x].back().length;
    }
    for (const Element x : steps.introduced()) {
      stays.of[x].back().began_before = false;
    }
    for (const Element x : steps.leaving()) {
      stays.of[x].back().goes_on = false;
      there[x] = false;
    }
  }
  drawing.require_range(stays.last);
  if (whole && drawing.parameters().kind == Kind::circular) {
    for (std::vector<DrawnStay>& each : stays.of) {
      close_circle(each);
    }
  }
  return stays;
}

DrawnStays stays_of(const std::vector<std::vector<Element>>& steps, std::size_t rows) {
  if (steps.empty()) {
    throw InternalError("no step to draw");
  }
  DrawnStays stays{
      .of = std::vector<std::vector<DrawnStay>>(rows), .first = 1, .last = steps.size()};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (const Element x : steps[i]) {
      if (x >= rows) {
        throw InternalError(fmt::format("step {} has row {} of {}", i + 1, x, rows));
      }
      std::vector<DrawnStay>& own = stays.of[x];
      if (own.empty() || own.back().to < i) {
        own.push_back({.from = i + 1});
      }
      own.back().to = i + 1;
      own.back().length = i + 2 - own.back().from;
    }
  }
  return stays;
}

std::vector<Element> ordered(const DrawnStays& stays, ElementOrder order) {
  std::vector<Element> elements(stays.of.size());
  std::iota(elements.begin(), elements.end(), Element{0});
  if (order == ElementOrder::given) {
    return elements;
  }
  // The first block that holds it and the last of that stay. What goes over the end is there from
  // the first block on.
  const auto entry = [&](Element x) {
    constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();
    const std::vector<DrawnStay>& own = stays.of[x];
    return own.empty() ? std::pair(never, never)
                       : std::pair(own.front().over_the_end ? stays.first : own.front().from,
                                   own.front().to);
  };
  const auto before = [&](Element x, Element y) {
    const std::size_t a = stays.of[x].size();
    const std::size_t b = stays.of[y].size();
    if (order == ElementOrder::stays && a != b && a > 0 && b > 0) {
      return a < b;
    }
    return entry(x) < entry(y);
  };
  std::ranges::stable_sort(elements, before);
  return elements;
}

// A row an element, a bar a stay.

namespace {

constexpr double field_width = 900, field_height = 560;  // of the field of bars
constexpr double small_font = 8, usual_font = 11;
constexpr double longest_bar_name = 120;
constexpr double beyond = 5;  // by so much a bar that goes on stands out of the frame
constexpr double axis_height = 18;
constexpr double thinnest_bar = 1.8;  // of a bar

class Stays {
 public:
  explicit Stays(const StaysFigure& figure)
      : figure_(figure),
        stays_(figure.stays),
        order_(ordered(stays_, figure.order)),
        blocks_(static_cast<double>(stays_.last - stays_.first + 1)),
        unit_(std::clamp(field_width / blocks_, 1.0, 24.0)),
        row_(std::clamp(field_height / static_cast<double>(order_.size()), 3.0, 18.0)) {
    font_ = row_ >= usual_font + 2 ? usual_font : small_font;
    for (const Element x : order_) {
      widest_ = std::max(widest_, text_width(figure.names[x], font_));
      for (const DrawnStay& stay : stays_.of[x]) {
        longest_ = std::max(longest_, stay.length);
        ++count_;
      }
      most_ = std::max(most_, stays_.of[x].size());
    }
    left_ = std::min(widest_, longest_bar_name) + 6 + beyond;
  }

  Picture draw() {
    const double height = row_ * static_cast<double>(order_.size());
    Picture content;
    content.width = left_ + blocks_ * unit_ + beyond;
    content.height = axis_height + height;
    add_axis(content, height);
    content.add(
        {.shape =
             Rectangle{.x = left_, .y = axis_height, .width = blocks_ * unit_, .height = height},
         .kind = "field",
         .style = {.fill = Paint(Paint::Role::none), .stroke = Paint(Paint::Role::soft)}});
    Group names;
    const auto every = static_cast<std::size_t>(std::ceil((font_ + 1) / row_));
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const double y = axis_height + row_ * static_cast<double>(i);
      content.add(bars(order_[i], y));
      if (i % every == 0) {
        const std::string name = figure_.names[order_[i]];
        names.marks.push_back(
            {.shape = Text{.at = {left_ - beyond - 4, y + row_ / 2 + 0.36 * font_},
                           .content = fitted(name, longest_bar_name, font_),
                           .element = true},
             .title = name});
      }
    }
    content.add({.shape = std::move(names),
                 .kind = "names",
                 .style = {.font_size = font_, .anchor = Anchor::end}});
    content.description = fmt::format(
        "{}: a row for each {}, a bar for each of its {}; the longest takes {}.", figure_.summary,
        figure_.row, count_of(count_, "stay"), count_of(longest_, figure_.step));
    return framed(figure_.heading, std::move(content), legend());
  }

 private:
  double x_of(std::uint64_t block) const {
    return left_ + static_cast<double>(block - stays_.first) * unit_;
  }

  void add_axis(Picture& content, double height) {
    Group numbers;
    Group lines;
    const double room = text_width(std::to_string(stays_.last), usual_font) + 8;
    const std::uint64_t step = axis_step(room / unit_);
    for (std::uint64_t i = stays_.first; i <= stays_.last; ++i) {
      const std::uint64_t next = (i / step + 1) * step;
      const bool first = i == stays_.first && static_cast<double>(next - i) * unit_ >= room;
      if (i % step != 0 && !first) {
        continue;
      }
      const double x = x_of(i) + unit_ / 2;
      numbers.marks.push_back(
          {.shape = Text{.at = {x, axis_height - 6}, .content = std::to_string(i)}});
      lines.marks.push_back({.shape = Segment{{x, axis_height - 3}, {x, axis_height + height}}});
    }
    content.add({.shape = std::move(lines),
                 .kind = "grid",
                 .style = {.stroke = Paint(Paint::Role::hairline), .stroke_width = 0.75}});
    content.add(
        {.shape = std::move(numbers),
         .kind = "axis",
         .style = {
             .fill = Paint(Paint::Role::soft), .font_size = usual_font, .anchor = Anchor::middle}});
  }

  Paint paint_of(const DrawnStay& stay, std::size_t ordinal) const {
    if (figure_.colour == StayColour::ordinal) {
      return Paint::series(ordinal);
    }
    // By ratios: one block more says much of a short stay and little of a long one.
    return Paint::ramp(longest_ > 1 ? std::log(static_cast<double>(stay.length)) /
                                          std::log(static_cast<double>(longest_))
                                    : 0);
  }

  // A bar from the left of one block to the right of another, out of the frame where it goes on.
  Rectangle bar(std::uint64_t from, std::uint64_t to, bool before, bool after, double y) const {
    const double gap = std::min(0.15 * row_, 2.0);
    // A stay of one block is seen however narrow blocks are.
    const double wider =
        std::max(0.0, thinnest_bar - static_cast<double>(to - from + 1) * unit_) / 2;
    const double left = x_of(from) - (before ? beyond : wider);
    const double right = x_of(to) + unit_ + (after ? beyond : wider);
    return {.x = left, .y = y + gap, .width = right - left, .height = row_ - 2 * gap};
  }

  Mark bars(Element x, double y) const {
    const std::string& name = figure_.names[x];
    const std::vector<DrawnStay>& own = stays_.of[x];
    Group row;
    for (std::size_t i = 0; i < own.size(); ++i) {
      const DrawnStay& stay = own[i];
      Mark mark{.kind = "stay",
                .title = title(name, stay),
                .data = {{"from", std::to_string(stay.from)},
                         {"to", std::to_string(stay.to)},
                         {"length", std::to_string(stay.length)}},
                .style = {.fill = paint_of(stay, i)}};
      if (stay.over_the_end && stay.length < stays_.last - stays_.first + 1) {
        mark.shape = Group{{{.shape = bar(stay.from, stays_.last, false, true, y)},
                            {.shape = bar(stays_.first, stay.to, true, false, y)}}};
      } else {
        mark.shape = bar(stay.from, stay.to, stay.began_before || stay.over_the_end,
                         stay.goes_on || stay.over_the_end, y);
      }
      row.marks.push_back(std::move(mark));
    }
    return {.shape = std::move(row), .kind = "element", .data = {{"element", name}}};
  }

  std::string title(const std::string& name, const DrawnStay& stay) const {
    if (stay.over_the_end && stay.from <= stay.to) {
      return fmt::format("{}: in every {}", name, figure_.step);
    }
    return fmt::format("{}: {}s {} to {}{} ({})", name, figure_.step, stay.from, stay.to,
                       stay.over_the_end ? ", over the end" : "", stay.length);
  }

  std::vector<LegendEntry> legend() const {
    std::vector<LegendEntry> legend;
    bool goes_on = false;
    for (const std::vector<DrawnStay>& each : stays_.of) {
      for (const DrawnStay& stay : each) {
        goes_on = goes_on || stay.over_the_end || stay.began_before || stay.goes_on;
      }
    }
    if (figure_.colour == StayColour::length) {
      legend.push_back(ramp_legend(figure_.step + "s of a stay", "1", std::to_string(longest_)));
    } else {
      for (std::size_t i = 0; i < std::min(most_, Paint::series_length); ++i) {
        const bool again = i + Paint::series_length < most_;
        legend.push_back(
            swatch(Paint::series(i), fmt::format("stay {}{}", i + 1, again ? ", …" : "")));
      }
    }
    if (goes_on) {
      legend.push_back(remark(figure_.circular ? "a bar over the frame goes on at the other side"
                                               : "a bar over the frame goes on"));
    }
    return legend;
  }

  const StaysFigure& figure_;
  const DrawnStays& stays_;
  std::vector<Element> order_;
  double blocks_, unit_, row_;
  double font_ = 0, widest_ = 0, left_ = 0;
  std::uint64_t longest_ = 0;
  std::size_t count_ = 0, most_ = 0;
};

}  // namespace

Picture draw_stays(const StaysFigure& figure) { return Stays(figure).draw(); }

Picture draw_stays(const Drawing& drawing) {
  StaysFigure figure{.stays = stays_of(drawing),
                     .names = {},
                     .heading = drawing.heading(),
                     .summary = drawing.summary(),
                     .order = drawing.options.order,
                     .colour = drawing.options.colour,
                     .circular = drawing.parameters().kind == Kind::circular};
  for (std::size_t x = 0; x < figure.stays.of.size(); ++x) {
    figure.names.push_back(drawing.name(static_cast<Element>(x)));
  }
  return draw_stays(figure);
}

}  // namespace changeover
