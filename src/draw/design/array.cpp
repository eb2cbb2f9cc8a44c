// Blocks as columns, elements in the row in which they stay.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "changeover/io/tables.hpp"
#include "core/words.hpp"
#include "draw/design/frame.hpp"
#include "draw/text/measure.hpp"

namespace changeover {
namespace {

// Sizes in units of the font's.
constexpr double line_height = 1.45;
constexpr double longest_name = 12;
constexpr double between_columns = 0.9;
constexpr double between_bands = 1.5;
constexpr double number_size = 0.75;

constexpr std::size_t many_blocks = 200;  // from here on everything is smaller

class Array {
 public:
  explicit Array(const Drawing& drawing) : drawing_(drawing), options_(drawing.options) {
    const std::uint64_t last = options_.to ? *options_.to - 1 : most_drawn_blocks + options_.from;
    columns_ = aligned_rows(drawing.source, options_.from - 1, last);
    drawing.require_range(columns_.empty() ? 0 : options_.from - 1 + columns_.size());
    drawing.require_fits(columns_.size());
    const bool many = columns_.size() > many_blocks;
    font_ = many ? 10 : 13;
    page_ = many ? 1280 : 960;
    for (const UnchangedSubset& subset : options_.expansion_set) {
      carets_.insert({subset.position, &subset});
    }
    measure();
  }

  Picture draw() {
    Picture content;
    const auto room = std::clamp<std::size_t>(
        static_cast<std::size_t>((page_ - margin_before()) / column_), 1, columns_.size());
    const std::size_t bands = (columns_.size() + room - 1) / room;
    const std::size_t per_band =
        (columns_.size() + bands - 1) / bands;  // the last is as long as the others
    double y = 0;
    for (std::size_t start = 0; start < columns_.size(); start += per_band) {
      if (start > 0) {
        y += between_bands * font_ / 2;
        content.add(
            {.shape =
                 Segment{{0, y}, {margin_before() + column_ * static_cast<double>(per_band), y}},
             .kind = "rule",
             .style = {.stroke = Paint(Paint::Role::hairline)}});
        y += between_bands * font_ / 2;
      }
      content.add(band(start, std::min(start + per_band, columns_.size()), y));
      y += band_height();
    }
    content.width = margin_before() + column_ * static_cast<double>(per_band);
    content.height = y;
    content.description = fmt::format(
        "{}: the blocks as columns, each element in one row while it stays. {} introductions are "
        "marked by a star above{}.",
        drawing_.summary(), introductions_,
        options_.leaving ? fmt::format(", {} leavings by a star below", leavings_) : std::string());
    return framed(drawing_.heading(), std::move(content), legend());
  }

 private:
  void measure() {
    double widest = 0;
    std::set<Element> seen;
    for (const AlignedBlock& column : columns_) {
      for (const MarkedElement& cell : column) {
        introductions_ += cell.introduced ? 1U : 0U;
        leavings_ += cell.leaving ? 1U : 0U;
        if (seen.insert(cell.element).second) {
          widest = std::max(widest, text_width(drawing_.name(cell.element), font_, true));
        }
      }
    }
    name_room_ = std::min(widest, longest_name * font_);
    const std::uint64_t last = options_.from + columns_.size() - 1;
    const double number = text_width(fmt::format("B{}", last), number_size * font_);
    column_ = std::max(name_room_ + star_width(font_), number) + between_columns * font_;
  }

  double margin_before() const { return carets_.contains(0) ? 0.8 * font_ : 0; }
  double band_height() const {
    const auto rows = static_cast<double>(drawing_.parameters().k);
    return (rows + 1) * line_height * font_ + (carets_.empty() ? 0 : 0.6 * font_);
  }

  Mark band(std::size_t start, std::size_t stop, double top) {
    Group band;
    for (std::size_t i = start; i < stop; ++i) {
      const double x = margin_before() + column_ * static_cast<double>(i - start);
      band.marks.push_back(block(i, {x, top}));
      add_step(band, i, x, top);
    }
    add_carets(band, start, stop, top);
    return {.shape = std::move(band),
            .kind = "band",
            .style = {.fill = Paint(Paint::Role::soft), .font_size = font_}};
  }

  Mark block(std::size_t i, Point at) {
    const std::uint64_t number = options_.from + i;
    Group block;
    double y = at.y + font_;
    block.marks.push_back(
        {.shape = Text{.at = {at.x, y}, .content = fmt::format("B{}", number)},
         .kind = "number",
         .style = {.fill = Paint(Paint::Role::ink), .font_size = number_size * font_}});
    std::vector<Element> introduced;
    for (const MarkedElement& cell : columns_[i]) {
      y += line_height * font_;
      const std::string name = drawing_.name(cell.element);
      Mark mark{.shape = Text{.at = {at.x, y},
                              .content = fitted(name, name_room_, font_, true),
                              .element = true,
                              .introduced = cell.introduced,
                              .leaving = options_.leaving && cell.leaving}};
      if (std::get<Text>(mark.shape).content != name) {
        mark.title = name;
      }
      if (cell.introduced) {
        introduced.push_back(cell.element);
        mark.kind = "introduced";
        mark.style = {.fill = Paint(Paint::Role::accent), .bold = true};
      }
      block.marks.push_back(std::move(mark));
    }
    return {.shape = std::move(block),
            .kind = "block",
            .title = fmt::format("block {}: introduces {}", number, drawing_.set(introduced)),
            .data = {{"block", std::to_string(number)}}};
  }

  // The step into block i, if it changes too many or too few elements: a bar before it.
  void add_step(Group& band, std::size_t i, double x, double top) {
    const std::uint64_t number = options_.from + i;
    const Parameters& p = drawing_.parameters();
    if (number == 1 && (p.kind == Kind::linear || columns_.size() == 1)) {
      return;
    }
    std::uint64_t changes = 0;
    for (const MarkedElement& cell : columns_[i]) {
      changes += cell.introduced ? 1U : 0U;
    }
    if (changes == p.change) {
      return;
    }
    ++bad_steps_;
    const double middle = x - 0.45 * between_columns * font_;
    band.marks.push_back(
        {.shape = Rectangle{.x = std::max(-4.0, middle - 1.5),
                            .y = top + 0.2 * font_,
                            .width = 3,
                            .height =
                                (static_cast<double>(p.k) + 1) * line_height * font_ - 0.6 * font_},
         .kind = "bad-step",
         .title = number == 1
                      ? fmt::format("the step from the last block to block 1 changes {}, not {}",
                                    count_of(changes, "element"), p.change)
                      : fmt::format("the step from block {} to block {} changes {}, not {}",
                                    number - 1, number, count_of(changes, "element"), p.change),
         .data = {{"block", std::to_string(number)}, {"changes", std::to_string(changes)}},
         .style = {.fill = Paint(Paint::Role::alarm)}});
  }

  void add_carets(Group& band, std::size_t start, std::size_t stop, double top) {
    const double y = top + (static_cast<double>(drawing_.parameters().k) + 1) * line_height * font_;
    for (std::size_t i = start; i <= stop; ++i) {
      const std::uint64_t position = options_.from - 1 + i;
      // A gap between bands belongs to the one before it; only position 0 stands before its band.
      const auto caret = carets_.find(position);
      if (caret == carets_.end() || (i == start && position > 0)) {
        continue;
      }
      const double x = margin_before() + column_ * static_cast<double>(i - start) -
                       0.5 * between_columns * font_;
      const double half = 0.28 * font_;
      band.marks.push_back({.shape = Path{.parts = {{{x - half, y + 0.45 * font_},
                                                     {x, y - 0.15 * font_},
                                                     {x + half, y + 0.45 * font_}}}},
                            .kind = "caret",
                            .title = fmt::format("unchanged subset after block {}: {}", position,
                                                 drawing_.set(caret->second->elements)),
                            .data = {{"position", std::to_string(position)}},
                            .style = {.fill = Paint(Paint::Role::none),
                                      .stroke = Paint(Paint::Role::alarm),
                                      .stroke_width = 1.6}});
    }
  }

  std::vector<LegendEntry> legend() const {
    std::vector<LegendEntry> legend;
    const auto sample = [&](bool introduced, const std::string& text) {
      legend.push_back({[introduced](Point at) {
                          Mark mark{.shape = Text{.at = at,
                                                  .content = "x",
                                                  .element = true,
                                                  .introduced = introduced,
                                                  .leaving = !introduced}};
                          mark.style.fill =
                              Paint(introduced ? Paint::Role::accent : Paint::Role::soft);
                          mark.style.bold = introduced;
                          return mark;
                        },
                        14, text});
    };
    sample(true, "introduced");
    if (options_.leaving) {
      sample(false, "leaves");
    }
    if (!carets_.empty()) {
      legend.push_back(
          {[](Point at) {
             return Mark{
                 .shape = Path{.parts = {{{at.x, at.y}, {at.x + 4, at.y - 8}, {at.x + 8, at.y}}}},
                 .style = {.fill = Paint(Paint::Role::none),
                           .stroke = Paint(Paint::Role::alarm),
                           .stroke_width = 1.6}};
           },
           8, "unchanged subset of an expansion set"});
    }
    if (bad_steps_ > 0) {
      legend.push_back(
          {[](Point at) {
             return Mark{.shape = Rectangle{.x = at.x, .y = at.y - 9.5, .width = 3, .height = 11},
                         .style = {.fill = Paint(Paint::Role::alarm)}};
           },
           3, fmt::format("wrong step ({})", bad_steps_)});
    }
    return legend;
  }

  const Drawing& drawing_;
  const DrawOptions& options_;
  std::vector<AlignedBlock> columns_;
  std::map<std::uint64_t, const UnchangedSubset*> carets_;
  double font_ = 0, page_ = 0, name_room_ = 0, column_ = 0;
  std::size_t introductions_ = 0, leavings_ = 0, bad_steps_ = 0;
};

}  // namespace

Picture draw_array(const Drawing& drawing) { return Array(drawing).draw(); }

}  // namespace changeover
