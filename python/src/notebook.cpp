// What notebooks show besides HTML, which Python writes: LaTeX, and pictures of what comes and goes
// and of tables.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "bind.hpp"
#include "changeover/core/error.hpp"
#include "changeover/draw/draw.hpp"
#include "changeover/io/tables.hpp"
#include "construct/known_tables.hpp"
#include "core/each.hpp"
#include "draw/design/stays_of.hpp"
#include "io/write/latex_prose.hpp"
#include "long_work.hpp"

namespace changeover::python {
namespace {

Theme theme_of(const std::string& word) {
  if (const auto theme = theme_from_string(word)) {
    return *theme;
  }
  throw BadInput("theme is 'light' or 'dark', not '" + word + "'");
}

// A table of texts, with the kind of each column: "number", "prose" or "names".
std::string table_in_latex(const std::vector<std::pair<std::string, std::string>>& heads,
                           const std::vector<std::vector<std::vector<std::string>>>& rows) {
  Table table{.rows = rows.size(), .columns = {}};
  for (std::size_t i = 0; i < heads.size(); ++i) {
    const auto& [head, kind] = heads[i];
    table.columns.push_back({head,
                             [&rows, i](std::size_t row) { return TableCell(rows[row][i]); },
                             {.kind = kind == "number"  ? ColumnKind::number
                                      : kind == "prose" ? ColumnKind::remark
                                                        : ColumnKind::list}});
  }
  return table_latex(table);
}

// Headline, note, names of the rows, and which of them are there, by step.
using Panel = std::tuple<std::string, std::string, std::vector<std::string>,
                         std::vector<std::vector<Element>>>;

DrawnPicture stays(const std::vector<Panel>& panels, const std::string& row,
                   const std::string& step, const std::string& theme) {
  const Theme ground = theme_of(theme);
  if (panels.empty()) {
    throw InternalError("no panel to draw");
  }
  return stoppable([&] {
    return written(stacked(each_of<Picture>(panels,
                                            [&](const Panel& panel) {
                                              const auto& [headline, note, names, steps] = panel;
                                              return draw_stays(StaysFigure{
                                                  .stays = stays_of(steps, names.size()),
                                                  .names = names,
                                                  .heading = {.headline = headline, .note = note},
                                                  .summary = headline,
                                                  .row = row,
                                                  .step = step});
                                            })),
                   ground);
  });
}

// Cells of one change number: v, k, kind.
using Place = std::tuple<std::uint64_t, std::uint64_t, std::string>;

// By kind, circular first, then k, v.
std::vector<std::vector<KnownCell>> cells_at(const std::vector<Place>& places,
                                             std::uint64_t change) {
  std::map<Kind, std::vector<std::pair<std::uint64_t, std::uint64_t>>> by_kind;
  for (const auto& [v, k, kind] : places) {
    by_kind[kind_of(kind)].emplace_back(k, v);
  }
  std::vector<std::vector<KnownCell>> cells;
  for (const Kind kind : kinds_of(std::nullopt)) {
    std::vector<std::pair<std::uint64_t, std::uint64_t>>& of_kind = by_kind[kind];
    if (of_kind.empty()) {
      continue;
    }
    std::ranges::sort(of_kind);
    CellRange range{.v_from = of_kind.front().second,
                    .v_to = of_kind.front().second,
                    .k_from = of_kind.front().first,
                    .k_to = of_kind.back().first,
                    .change = change,
                    .kind = kind};
    for (const auto& [k, v] : of_kind) {
      range.v_from = std::min(range.v_from, v);
      range.v_to = std::max(range.v_to, v);
    }
    const BestKnownTable known = best_known_table(Registry::standard(), range);
    cells.emplace_back();
    for (const auto& [k, v] : of_kind) {
      cells.back().push_back(known.at({.v = v, .k = k, .change = change, .kind = kind}));
    }
  }
  return cells;
}

// Whether they are all cells of a range, each once, by k, then v.
bool is_whole(const std::vector<KnownCell>& cells) {
  const Parameters& first = cells.front().parameters;
  const Parameters& last = cells.back().parameters;
  if (last.v < first.v) {
    return false;
  }
  const std::uint64_t rows = last.v - first.v + 1;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Parameters& p = cells[i].parameters;
    if (p.v != first.v + i % rows || p.k != first.k + i / rows) {
      return false;
    }
  }
  return last.v == first.v + (cells.size() - 1) % rows;
}

std::optional<std::string> table_with_keys(const std::vector<Place>& places, std::uint64_t change,
                                           bool cited) {
  return stoppable([&]() -> std::optional<std::string> {
    std::string text;
    for (const std::vector<KnownCell>& known : cells_at(places, change)) {
      if (!is_whole(known)) {
        return std::nullopt;
      }
      text += known_grid_latex(
          each_of<const KnownCell*>(known, [](const KnownCell& cell) { return &cell; }),
          cited ? Citations::cited : Citations::written);
    }
    return text;
  });
}

DrawnPicture heatmap(const std::vector<Place>& places, std::uint64_t change,
                     const std::string& measure, const std::string& theme) {
  const auto says = heat_measure_from_string(measure);
  const Theme ground = theme_of(theme);
  if (!says) {
    throw BadInput("measure is 'ratio', 'status' or 'gap', not '" + measure + "'");
  }
  return stoppable([&] {
    return written(stacked(each_of<Picture>(cells_at(places, change),
                                            [&](const std::vector<KnownCell>& cells) {
                                              return draw_heatmap(cells, *says);
                                            })),
                   ground);
  });
}

}  // namespace

DrawnPicture written(const Picture& picture, Theme theme) {
  std::string for_tex;
  std::string defect;
  try {
    for_tex = tikz(picture);
  } catch (const BadInput& fault) {
    defect = fault.what();
  }
  return {svg(picture, theme), for_tex, defect, picture.title};
}

void bind_notebook(py::module_& module) {
  module.def("latex_escaped", [](const std::string& text) { return latex_escaped(text); });
  module.def("latex_prose", [](const std::string& text) { return latex_prose(text); });
  module.def("html_prose", [](const std::string& text) { return html_prose(text); });
  module.def("latex_table", &table_in_latex);
  module.def("latex_grid", &table_with_keys);
  module.def("draw_stays", &stays);
  module.def("draw_heatmap", &heatmap);
}

}  // namespace changeover::python
