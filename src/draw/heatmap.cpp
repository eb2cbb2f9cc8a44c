#include "changeover/draw/draw.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "changeover/core/error.hpp"
#include "core/words.hpp"
#include "draw/design/frame.hpp"

namespace changeover {
namespace {

constexpr double usual_grid_width = 1100;
constexpr double axis_font = 11;
constexpr double largest_ratio = 2;  // what is worse has the colour of this

class Heatmap {
 public:
  Heatmap(std::span<const KnownCell> cells, HeatMeasure measure)
      : cells_(cells), measure_(measure) {
    if (cells.empty()) {
      throw BadInput("a heat map of no cells; give at least one");
    }
    const Parameters& one = cells.front().parameters;
    v_from_ = v_to_ = one.v;
    k_from_ = k_to_ = one.k;
    std::set<std::pair<std::uint64_t, std::uint64_t>> seen;
    for (const KnownCell& cell : cells) {
      const Parameters& p = cell.parameters;
      if (p.kind != one.kind || p.change != one.change) {
        throw BadInput(fmt::format(
            "one heat map is of one kind and change number, not of {} and {}", name(one), name(p)));
      }
      if (!seen.insert({p.v, p.k}).second) {
        throw BadInput(fmt::format("{} is in a heat map twice", name(p)));
      }
      v_from_ = std::min(v_from_, p.v);
      v_to_ = std::max(v_to_, p.v);
      k_from_ = std::min(k_from_, p.k);
      k_to_ = std::max(k_to_, p.k);
      note_largest(cell);
    }
    const std::uint64_t columns = v_to_ - v_from_ + 1;
    const std::uint64_t rows = k_to_ - k_from_ + 1;
    if (columns > most_cells_of_a_heatmap || rows > most_cells_of_a_heatmap / columns) {
      throw BadInput(
          fmt::format("a heat map of v = {} to {} and k = {} to {} has more than {} cells; ask for "
                      "fewer",
                      v_from_, v_to_, k_from_, k_to_, most_cells_of_a_heatmap));
    }
    cell_ = std::clamp(usual_grid_width / static_cast<double>(columns), 7.0, 24.0);
    left_ = text_width(std::to_string(k_to_), axis_font) + 26;
    top_ = 2 * axis_font + 14;
  }

  Picture draw() {
    Picture content;
    content.width = left_ + cell_ * static_cast<double>(v_to_ - v_from_ + 1);
    content.height = top_ + cell_ * static_cast<double>(k_to_ - k_from_ + 1);
    Group squares;
    Group signs;
    for (const KnownCell& cell : cells_) {
      add(squares, signs, cell);
    }
    content.add({.shape = std::move(squares), .kind = "cells"});
    content.add({.shape = std::move(signs),
                 .kind = "signs",
                 .style = {.font_size = sign_font(), .anchor = Anchor::middle}});
    content.add(axes());
    const Parameters& p = cells_.front().parameters;
    const std::string what = change_name(p.change);
    content.description = fmt::format(
        "A square for each v from {} to {} and each k from {} to {}; its colour says {}.", v_from_,
        v_to_, k_from_, k_to_, words());
    return framed(
        {.headline = fmt::format("{} {} covering designs, best known", to_string(p.kind), what),
         .note = fmt::format("{} of {} proved minimum", minimum_, count_of(possible_, "cell"))},
        std::move(content), legend());
  }

 private:
  void note_largest(const KnownCell& cell) {
    if (cell.impossible) {
      return;
    }
    ++possible_;
    if (cell.best) {
      minimum_ += cell.status() == "minimum" ? 1U : 0U;
      gap_ = std::max(gap_, cell.best->b - cell.bound.blocks);
      ratio_ = std::max(ratio_, ratio(cell));
    }
  }

  static double ratio(const KnownCell& cell) {
    return static_cast<double>(cell.best->b) /
           static_cast<double>(std::max<std::uint64_t>(1, cell.bound.blocks));
  }

  std::string words() const {
    return measure_ == HeatMeasure::ratio ? "how many times the lower bound its blocks are"
           : measure_ == HeatMeasure::gap ? "how many blocks it has over the lower bound"
                                          : "what is known of it";
  }

  double sign_font() const { return std::min(11.0, 0.5 * cell_); }
  bool has_signs() const { return cell_ >= 12; }

  Paint paint_of(const KnownCell& cell) const {
    switch (measure_) {
      case HeatMeasure::ratio: {
        const double worst = std::min(ratio_, largest_ratio);
        return Paint::ramp(worst > 1 ? (ratio(cell) - 1) / (worst - 1) : 0);
      }
      case HeatMeasure::gap:
        // By ratios: one block more says much of a small gap and little of a large one.
        return Paint::ramp(gap_ == 0
                               ? 0
                               : std::log1p(static_cast<double>(cell.best->b - cell.bound.blocks)) /
                                     std::log1p(static_cast<double>(gap_)));
      case HeatMeasure::status:
        break;
    }
    return Paint::series(cell.status() == "minimum" ? 2 : 0);
  }

  void add(Group& squares, Group& signs, const KnownCell& cell) const {
    const Parameters& p = cell.parameters;
    const double gap = cell_ >= 10 ? 0.5 : 0.25;
    Mark mark{.kind = "cell",
              .title = title(cell),
              .data = {{"v", std::to_string(p.v)}, {"k", std::to_string(p.k)}}};
    const Rectangle square{.x = left_ + static_cast<double>(p.v - v_from_) * cell_ + gap,
                           .y = top_ + static_cast<double>(p.k - k_from_) * cell_ + gap,
                           .width = cell_ - 2 * gap,
                           .height = cell_ - 2 * gap};
    mark.shape = square;
    std::string sign;
    Paint ink = Paint::Role::soft;
    if (cell.impossible || !cell.best) {
      mark.style.fill = Paint(Paint::Role::ground);
      mark.style.stroke = Paint(cell.impossible ? Paint::Role::hairline : Paint::Role::soft);
      mark.style.stroke_width = 0.5;
      sign = cell.impossible ? "–" : "?";
    } else {
      mark.style.fill = paint_of(cell);
      ink = Paint::upon(*mark.style.fill);
      sign = measure_ == HeatMeasure::gap ? std::to_string(cell.best->b - cell.bound.blocks)
             : cell.status() == "minimum" ? "="
                                          : "";
    }
    squares.marks.push_back(std::move(mark));
    if (has_signs() && !sign.empty() && text_width(sign, sign_font()) <= square.width) {
      signs.marks.push_back(
          {.shape = Text{.at = {square.x + square.width / 2,
                                square.y + square.height / 2 + 0.36 * sign_font()},
                         .content = sign},
           .style = {.fill = ink}});
    }
  }

  static std::string title(const KnownCell& cell) {
    const std::string who = name(cell.parameters);
    if (cell.impossible) {
      return fmt::format("{}: none exists, {}", who, *cell.impossible);
    }
    if (!cell.best) {
      return fmt::format("{}: open, at least {}", who, count_of(cell.bound.blocks, "block"));
    }
    return fmt::format(
        "{}: {} by {}, {}", who, count_of(cell.best->b, "block"), cell.best->recipe.construction,
        cell.status() == "minimum" ? "minimum"
                                   : fmt::format("at least {} needed", cell.bound.blocks));
  }

  Mark axes() const {
    Group axes;
    const double room = text_width(std::to_string(v_to_), axis_font) + 6;
    const std::uint64_t step = axis_step(room / cell_);
    for (std::uint64_t v = v_from_; v <= v_to_; ++v) {
      const std::uint64_t next = (v / step + 1) * step;
      const bool first = v == v_from_ && static_cast<double>(next - v) * cell_ >= room;
      if (v % step == 0 || first) {
        const double x = left_ + (static_cast<double>(v - v_from_) + 0.5) * cell_;
        axes.marks.push_back({.shape = Text{.at = {x, top_ - 5}, .content = std::to_string(v)}});
      }
    }
    const std::uint64_t step_down = axis_step((axis_font + 1) / cell_);
    for (std::uint64_t k = k_from_; k <= k_to_; ++k) {
      if (k % step_down == 0) {
        const double y = top_ + (static_cast<double>(k - k_from_) + 0.5) * cell_ + 0.36 * axis_font;
        axes.marks.push_back({.shape = Text{.at = {left_ - 6, y}, .content = std::to_string(k)},
                              .style = {.anchor = Anchor::end}});
      }
    }
    axes.marks.push_back({.shape = Text{.at = {left_, axis_font}, .content = "v"},
                          .style = {.bold = true, .anchor = Anchor::start}});
    axes.marks.push_back(
        {.shape = Text{.at = {0, top_ + cell_ / 2 + 0.36 * axis_font}, .content = "k"},
         .style = {.bold = true, .anchor = Anchor::start}});
    return {
        .shape = std::move(axes),
        .kind = "axis",
        .style = {
            .fill = Paint(Paint::Role::soft), .font_size = axis_font, .anchor = Anchor::middle}};
  }

  std::vector<LegendEntry> legend() const {
    std::vector<LegendEntry> legend;
    if (measure_ == HeatMeasure::ratio) {
      const double worst = std::min(ratio_, largest_ratio);
      legend.push_back(
          ramp_legend("blocks / lower bound", "1",
                      fmt::format("{:.2f}{}", worst, ratio_ > worst ? " or more" : "")));
    } else if (measure_ == HeatMeasure::gap) {
      legend.push_back(ramp_legend("blocks over the lower bound", "0", std::to_string(gap_)));
    } else {
      legend.push_back(swatch(Paint::series(2), "= minimum"));
      legend.push_back(swatch(Paint::series(0), "best known"));
    }
    if (measure_ == HeatMeasure::ratio && has_signs()) {
      legend.push_back(remark("= minimum"));
    }
    if (has_signs()) {
      legend.push_back(remark("– none exists"));
      legend.push_back(remark("? no design known"));
    } else {
      legend.push_back(remark("empty: no design known, or none exists"));
    }
    return legend;
  }

  std::span<const KnownCell> cells_;
  HeatMeasure measure_;
  std::uint64_t v_from_ = 0, v_to_ = 0, k_from_ = 0, k_to_ = 0;
  std::uint64_t gap_ = 0;
  double ratio_ = 1;
  std::size_t minimum_ = 0, possible_ = 0;
  double cell_ = 0, left_ = 0, top_ = 0;
};

}  // namespace

std::string_view to_string(HeatMeasure measure) {
  constexpr std::array<std::string_view, 3> names = {"ratio", "status", "gap"};
  return names.at(static_cast<std::size_t>(measure));
}

std::optional<HeatMeasure> heat_measure_from_string(std::string_view name) {
  return named(name, {HeatMeasure::ratio, HeatMeasure::status, HeatMeasure::gap});
}

Picture draw_heatmap(std::span<const KnownCell> cells, HeatMeasure measure) {
  return Heatmap(cells, measure).draw();
}

}  // namespace changeover
