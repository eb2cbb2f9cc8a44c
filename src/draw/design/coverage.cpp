// Each pair: the block of its first meeting, and how often it is newly covered.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "changeover/core/design.hpp"
#include "core/words.hpp"
#include "draw/design/frame.hpp"
#include "draw/design/stays_of.hpp"
#include "draw/text/measure.hpp"

namespace changeover {
namespace {

constexpr double usual_width = 640;
constexpr double longest_row_name = 120;
constexpr std::size_t most_with_titles = 100;  // of more elements, pairs of one colour are one mark
constexpr std::size_t steps_of_colour = 48;

struct Meeting {
  std::uint64_t first = 0;  // a block; 0: none
  std::uint64_t times = 0;  // newly covered
};

class Meetings {
 public:
  explicit Meetings(std::uint64_t v) : pairs_(static_cast<std::size_t>(v * (v - 1) / 2)) {}

  [[nodiscard]] Meeting& of(Element x, Element y) {
    const std::size_t high = std::max(x, y);
    return pairs_[high * (high - 1) / 2 + std::min(x, y)];
  }

  // All pairs of a block, or those with an introduced element.
  void meet(std::span<const Element> block, const std::vector<bool>& introduced, bool all,
            std::uint64_t number) {
    for (std::size_t a = 1; a < block.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const bool is_new = introduced[block[a]] || introduced[block[b]];
        if (is_new || all) {
          Meeting& meeting = of(block[a], block[b]);
          meeting.first = meeting.first == 0 ? number : meeting.first;
          meeting.times += is_new ? 1 : 0;
        }
      }
    }
  }

 private:
  std::vector<Meeting> pairs_;
};

class Coverage {
 public:
  explicit Coverage(const Drawing& drawing)
      : drawing_(drawing), v_(static_cast<std::size_t>(drawing.parameters().v)), meetings_(v_) {
    read();
    cell_ = std::clamp(usual_width / static_cast<double>(v_), 1.3, 22.0);
    font_ = cell_ >= 13 ? 11 : 8;
    for (const Element x : order_) {
      widest_ = std::max(widest_, text_width(drawing.name(x), font_));
    }
    widest_ = std::min(widest_, longest_row_name);
    left_ = widest_ + 6;
    top_ = font_ + 6;
  }

  Picture draw() {
    const double side = cell_ * static_cast<double>(v_);
    Picture content;
    content.width = left_ + side;
    content.height = top_ + side;
    content.add({.shape = Rectangle{.x = left_, .y = top_, .width = side, .height = side},
                 .kind = "field",
                 .style = {.fill = Paint(Paint::Role::none), .stroke = Paint(Paint::Role::soft)}});
    content.add(
        {.shape = Segment{{left_, top_}, {left_ + side, top_ + side}},
         .kind = "diagonal",
         .style = {.stroke = Paint(Paint::Role::soft), .stroke_width = std::min(1.0, cell_ / 4)}});
    Group pairs;
    v_ <= most_with_titles ? add_pairs(pairs) : add_colours(pairs);
    content.add({.shape = std::move(pairs), .kind = "pairs"});
    add_names(content);
    content.description = fmt::format(
        "{}: below the diagonal the block in which each pair first meets, above it how often it "
        "is newly covered if that is not once. Newly covered more than once: {}; in no block: {}.",
        drawing_.summary(), count_of(repeated_, "pair"), count_of(uncovered_, "pair"));
    return framed(drawing_.heading(), std::move(content), legend());
  }

 private:
  void read() {
    const std::uint64_t from = drawing_.options.from;
    std::vector<bool> introduced(v_);
    // The order is that of the stays, which are read on the way.
    DrawnStays stays;
    stays.of.resize(v_);
    stays.first = from;
    for (Transitions steps(drawing_.source); steps.next();) {
      if (drawing_.beyond_range(steps.index())) {
        break;
      }
      if (!drawing_.in_range(steps.index())) {
        continue;
      }
      last_ = steps.index() + 1;
      const bool first = last_ == from;
      // If a part of the design is drawn, what is before its first block does not count.
      const std::span<const Element> entering =
          first && !drawing_.is_whole() ? steps.block() : steps.introduced();
      for (const Element x : entering) {
        introduced[x] = true;
      }
      meetings_.meet(steps.block(), introduced, first, last_);
      for (const Element x : entering) {
        introduced[x] = false;
        stays.of[x].push_back({.from = last_, .to = last_});
      }
      if (first) {
        for (const Element x : steps.block()) {
          if (stays.of[x].empty()) {
            stays.of[x].push_back({.from = last_, .to = last_, .over_the_end = true});
          }
        }
      }
    }
    drawing_.require_range(last_);
    for (std::vector<DrawnStay>& own : stays.of) {
      if (own.size() > 1 && own.front().over_the_end) {
        own.pop_back();  // the two are one
      }
    }
    order_ = ordered(stays, drawing_.options.order);
    for (Element x = 1; x < v_; ++x) {
      for (Element y = 0; y < x; ++y) {
        const Meeting& meeting = meetings_.of(x, y);
        uncovered_ += meeting.first == 0 ? 1U : 0U;
        always_ += meeting.first > 0 && meeting.times == 0 ? 1U : 0U;
        repeated_ += meeting.times > 1 ? 1U : 0U;
        if (meeting.times > 1) {
          seen_[std::min<std::uint64_t>(meeting.times, 4) - 2] = true;
        }
      }
    }
  }

  Paint first_paint(std::uint64_t block) const {
    const std::uint64_t from = drawing_.options.from;
    return Paint::ramp(
        last_ > from ? static_cast<double>(block - from) / static_cast<double>(last_ - from) : 0);
  }

  static Paint times_paint(std::uint64_t times) {
    return times == 0   ? Paint(Paint::Role::soft)
           : times == 2 ? Paint::series(5)
           : times == 3 ? Paint::series(0)
                        : Paint(Paint::Role::ink);
  }

  // The square in a row and a column, both from 0.
  Rectangle square(std::size_t row, std::size_t column) const {
    const double gap = cell_ >= 6 ? 0.5 : 0;
    return {.x = left_ + static_cast<double>(column) * cell_ + gap,
            .y = top_ + static_cast<double>(row) * cell_ + gap,
            .width = cell_ - 2 * gap,
            .height = cell_ - 2 * gap};
  }

  void add_pairs(Group& pairs) {
    for (std::size_t row = 1; row < v_; ++row) {
      for (std::size_t column = 0; column < row; ++column) {
        add_pair(pairs, row, column);
      }
    }
  }

  void add_pair(Group& pairs, std::size_t row, std::size_t column) {
    const Element x = order_[column];
    const Element y = order_[row];
    const Meeting& meeting = meetings_.of(x, y);
    const std::string name = fmt::format("{{{},{}}}", drawing_.name(x), drawing_.name(y));
    Mark below{.shape = square(row, column)};
    if (meeting.first == 0) {
      below.kind = "uncovered";
      below.title = name + ": in no block";
      below.style.fill = Paint(Paint::Role::alarm);
      pairs.marks.push_back(below);
      const Rectangle r = square(row, column);
      const double inset = 0.25 * r.width;
      pairs.marks.push_back(
          {.shape = Path{.parts = {{{r.x + inset, r.y + inset},
                                    {r.x + r.width - inset, r.y + r.height - inset}},
                                   {{r.x + inset, r.y + r.height - inset},
                                    {r.x + r.width - inset, r.y + inset}}}},
           .style = {.fill = Paint(Paint::Role::none),
                     .stroke = Paint::upon(Paint::Role::alarm),
                     .stroke_width = std::max(0.75, cell_ / 12)}});
      return;
    }
    const std::string often = meeting.times == 0   ? "in every block"
                              : meeting.times == 1 ? "once"
                                                   : fmt::format("{} times", meeting.times);
    below.kind = "pair";
    below.title =
        fmt::format("{}: first in block {}, newly covered {}", name, meeting.first, often);
    below.data = {{"first", std::to_string(meeting.first)},
                  {"times", std::to_string(meeting.times)}};
    below.style.fill = first_paint(meeting.first);
    pairs.marks.push_back(below);
    if (meeting.times == 1) {
      return;
    }
    const Rectangle above = square(column, row);
    const Paint paint = times_paint(meeting.times);
    pairs.marks.push_back({.shape = above,
                           .kind = meeting.times == 0 ? "always" : "excess",
                           .title = fmt::format("{}: newly covered {}", name, often),
                           .data = {{"times", std::to_string(meeting.times)}},
                           .style = {.fill = paint}});
    const std::string number = std::to_string(meeting.times);
    if (meeting.times > 1 && text_width(number, 9) < above.width && above.height > 9) {
      pairs.marks.push_back(
          {.shape = Text{.at = {above.x + above.width / 2, above.y + above.height / 2 + 3.2},
                         .content = number},
           .style = {.fill = Paint::upon(paint), .font_size = 9, .anchor = Anchor::middle}});
    }
  }

  // One path for each colour.
  void add_colours(Group& pairs) {
    std::map<std::size_t, Path> first;
    std::map<std::uint64_t, Path> times;
    Path uncovered{.closed = true};
    const auto add = [&](Path& path, std::size_t row, std::size_t column) {
      const Rectangle r = square(row, column);
      path.closed = true;
      path.parts.push_back({{r.x, r.y},
                            {r.x + r.width, r.y},
                            {r.x + r.width, r.y + r.height},
                            {r.x, r.y + r.height}});
    };
    const std::uint64_t from = drawing_.options.from;
    for (std::size_t row = 1; row < v_; ++row) {
      for (std::size_t column = 0; column < row; ++column) {
        const Meeting& meeting = meetings_.of(order_[column], order_[row]);
        if (meeting.first == 0) {
          add(uncovered, row, column);
          continue;
        }
        add(first[static_cast<std::size_t>((meeting.first - from) * (steps_of_colour - 1) /
                                           std::max<std::uint64_t>(1, last_ - from))],
            row, column);
        if (meeting.times != 1) {
          add(times[std::min<std::uint64_t>(4, meeting.times)], column, row);
        }
      }
    }
    for (auto& [step, path] : first) {
      pairs.marks.push_back(
          {.shape = std::move(path),
           .kind = "pair",
           .style = {.fill = Paint::ramp(static_cast<double>(step) / (steps_of_colour - 1))}});
    }
    for (auto& [number, path] : times) {
      pairs.marks.push_back({.shape = std::move(path),
                             .kind = number == 0 ? "always" : "excess",
                             .style = {.fill = times_paint(number)}});
    }
    if (!uncovered.parts.empty()) {
      pairs.marks.push_back({.shape = std::move(uncovered),
                             .kind = "uncovered",
                             .style = {.fill = Paint(Paint::Role::alarm)}});
    }
  }

  void add_names(Picture& content) {
    Group rows;
    Group columns;
    const auto every_row = static_cast<std::size_t>(std::ceil((font_ + 1) / cell_));
    const auto every_column = static_cast<std::size_t>(std::ceil((widest_ + 4) / cell_));
    for (std::size_t i = 0; i < v_; ++i) {
      const std::string name = drawing_.name(order_[i]);
      const double middle = (static_cast<double>(i) + 0.5) * cell_;
      if (i % every_row == 0) {
        rows.marks.push_back({.shape = Text{.at = {left_ - 5, top_ + middle + 0.36 * font_},
                                            .content = fitted(name, widest_, font_),
                                            .element = true},
                              .title = name});
      }
      if (i % every_column == 0 && middle + widest_ / 2 <= cell_ * static_cast<double>(v_) + 16) {
        columns.marks.push_back({.shape = Text{.at = {left_ + middle, top_ - 5},
                                               .content = fitted(name, widest_, font_),
                                               .element = true},
                                 .title = name});
      }
    }
    content.add({.shape = std::move(rows),
                 .kind = "names",
                 .style = {.font_size = font_, .anchor = Anchor::end}});
    content.add({.shape = std::move(columns),
                 .kind = "names",
                 .style = {.font_size = font_, .anchor = Anchor::middle}});
  }

  std::vector<LegendEntry> legend() const {
    std::vector<LegendEntry> legend = {ramp_legend("below, first meeting: block",
                                                   std::to_string(drawing_.options.from),
                                                   std::to_string(last_))};
    if (uncovered_ > 0) {
      legend.push_back(swatch(Paint::Role::alarm, fmt::format("in no block ({})", uncovered_)));
    }
    if (repeated_ == 0) {
      legend.push_back(remark("above, more than once: no pair"));
    } else {
      legend.push_back(remark(fmt::format("above, more than once ({}):", repeated_)));
      const std::array<std::string, 3> words = {"twice", "three times", "more often"};
      for (std::size_t i = 0; i < words.size(); ++i) {
        if (seen_[i]) {
          legend.push_back(swatch(times_paint(i + 2), words[i]));
        }
      }
    }
    if (always_ > 0) {
      legend.push_back(
          swatch(times_paint(0), fmt::format("together in every block ({})", always_)));
    }
    return legend;
  }

  const Drawing& drawing_;
  std::size_t v_;
  Meetings meetings_;
  std::vector<Element> order_;
  std::uint64_t last_ = 0;
  double cell_ = 0, font_ = 0, widest_ = 0, left_ = 0, top_ = 0;
  std::size_t uncovered_ = 0, repeated_ = 0, always_ = 0;
  std::array<bool, 3> seen_ = {};  // pairs that are newly covered twice, three times, more often
};

}  // namespace

Picture draw_coverage(const Drawing& drawing) { return Coverage(drawing).draw(); }

}  // namespace changeover
