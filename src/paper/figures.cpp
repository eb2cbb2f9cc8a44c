#include "paper/figures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "changeover/draw/draw.hpp"

namespace changeover {
namespace {

// "Figure 4a" becomes "figure-4a".
std::string file_name(const std::string& place, std::string_view extension) {
  const std::size_t blank = std::min(place.find(' '), place.size() - 1);
  return fmt::format("figure-{}.{}", place.substr(blank + 1), extension);
}

void add(std::vector<PaperFigure>& figures, const std::string& place, const Picture& picture) {
  figures.push_back({file_name(place, "svg"), svg(picture)});
  figures.push_back({file_name(place, "tex"), tikz(picture)});
}

FactorFigure printed_figure(const PrintedFactorization& printed) {
  const OneFactorization factorization = parse(printed);
  FactorFigure figure = factor_figure(factorization);
  figure.names = printed.vertices;
  figure.title = fmt::format("{}: 1-factorization of K_{}", printed.place, factorization.order);
  if (factorization.order == 8) {
    figure.centre = 7;  // the paper draws 15 in the middle
  }
  return figure;
}

// The place of a block in a table.
std::uint64_t index_of(const Design& design, Block block, const std::string& place) {
  std::sort(block.begin(), block.end());
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    if (std::is_permutation(block.begin(), block.end(), design.block(i).begin(),
                            design.block(i).end())) {
      return i;
    }
  }
  throw BadInput(fmt::format("{}: its first block is not in the table", place));
}

CircleFigure drawn_circle(const Paper& paper, const PrintedCircle& printed) {
  for (const PrintedTable& table : paper.tables) {
    const std::vector<Block> first = blocks_in(printed.first);
    if (table.parameters.v != printed.v || first.empty()) {
      continue;
    }
    const Design design = printed_design(table, Kind::circular);
    CircleFigure figure = circle_figure(design, index_of(design, first.front(), printed.place), 2);
    figure.title =
        fmt::format("{}: two consecutive blocks of the {}", printed.place, name(table.parameters));
    return figure;
  }
  throw BadInput(fmt::format("{}: no table over Z_{}", printed.place, printed.v));
}

}  // namespace

std::vector<PaperFigure> paper_figures(const Paper& paper) {
  std::vector<PaperFigure> figures;
  for (const PrintedFactorization& printed : paper.factorizations) {
    if (printed.place.starts_with("Figure")) {
      add(figures, printed.place, draw_factors(printed_figure(printed)));
    }
  }
  for (const PrintedCircle& printed : paper.circles) {
    add(figures, printed.place, draw_circle(drawn_circle(paper, printed)));
  }
  return figures;
}

}  // namespace changeover
