#include "changeover/draw/draw.hpp"

#include "changeover/core/developed.hpp"
#include "drawn.hpp"

namespace changeover::figures_test {
namespace {

FactorFigure circle_factors(std::uint32_t order) {
  FactorFigure figure{.order = order, .centre = order - 1};
  const std::uint32_t around = order - 1;
  for (std::uint32_t i = 0; i < around; ++i) {
    auto& factor = figure.factors.emplace_back();
    factor.emplace_back(i, around);
    for (std::uint32_t j = 1; j < order / 2; ++j) {
      factor.emplace_back((i + j) % around, (i + around - j) % around);
    }
  }
  return figure;
}

TEST(FiguresTest, AFactorizationHasAColourAFactorAndAVertexInTheCentre) {
  const FactorFigure figure = circle_factors(8);
  const Page page = read_svg(svg(draw_factors(figure)));
  EXPECT_EQ(page.count("pair"), 28U);
  EXPECT_EQ(page.count_with("pair", "stroke", Paint::series(0).hex(Theme::light)), 4U);
  EXPECT_EQ(page.count("point"), 8U);
  EXPECT_EQ(page.count_with("point", "cx", "240"), 2U);  // the centre and the top
  EXPECT_EQ(page.title, "1-factorization of K_8");
  EXPECT_EQ(page.count_with("pair", "stroke-dasharray", "4 4"), 0U);
  const std::string tex = tikz(draw_factors(figure));
  check_tikz(tex);
  EXPECT_EQ(count(tex, " -- "), 28U);
  EXPECT_EQ(count(tex, "\\node["), 8U);
  EXPECT_EQ(
      read_svg(svg(draw_factors(circle_factors(10)))).count_with("pair", "stroke-dasharray", "4 4"),
      10U);
}

TEST(FiguresTest, ABlockAndItsSuccessorShowNewPairsAndTheUnchangedSubset) {
  const BaseBlocks base{{.v = 11, .k = 4, .kind = Kind::circular}, {{0, 1, 2, 5}}};
  DevelopedSource source(base);
  const CircleFigure figure = circle_figure(read_all(source), 0, 2);
  ASSERT_EQ(figure.blocks.size(), 2U);
  EXPECT_EQ(figure.blocks[0].introduced, (Block{2, 5}));
  const Page page = read_svg(svg(draw_circle(figure)));
  EXPECT_EQ(page.count("pair"), 10U);
  EXPECT_EQ(page.count_with("pair", "stroke", Paint::series(0).hex(Theme::light)), 5U);
  EXPECT_EQ(page.count_with("pair", "stroke", Paint::series(1).hex(Theme::light)), 5U);
  EXPECT_EQ(page.count_with("point", "fill", Paint::series(6).hex(Theme::light)), 2U);  // 1 and 2
  check_tikz(tikz(draw_circle(figure)));
}

TEST(FiguresTest, AsManyBlocksAsThereAreAreDrawn) {
  const BaseBlocks base{{.v = 11, .k = 4, .kind = Kind::circular}, {{0, 1, 2, 5}}};
  DevelopedSource source(base);
  const Design design = read_all(source);
  EXPECT_EQ(circle_figure(design, 9, 5).blocks.size(), 2U);
  EXPECT_EQ(circle_figure(design, 11, 5).blocks.size(), 0U);
  EXPECT_EQ(read_svg(svg(draw_circle(circle_figure(design, 3, 1)))).count("pair"), 5U);
}

TEST(FiguresTest, NamesAndTitlesAreEscaped) {
  CircleFigure figure{.v = 2, .blocks = {}, .names = {"<a&\"", "∞_s\xff"}, .title = "1 < 2\n& %"};
  const Page page = read_svg(svg(draw_circle(figure)));
  EXPECT_EQ(page.texts.at(0).content, "<a&\"");
  EXPECT_EQ(page.texts.at(1).content, "∞s\xEF\xBF\xBD");
  const std::string tex = tikz(draw_circle(figure));
  EXPECT_TRUE(tex.starts_with("% 1 \\textless{} 2 \\& \\%\n")) << tex;
}

TEST(FiguresTest, ManyPointsAreDrawnSmall) {
  CircleFigure figure{.v = 1000, .blocks = {{{0, 1, 500}, {500}}}};
  const Page page = read_svg(svg(draw_circle(figure)));
  EXPECT_EQ(page.texts.size(), 2U);  // 1 has no room for its name beside 0
  EXPECT_EQ(page.overlap(), "");
  check_tikz(tikz(draw_circle(figure)));
}

TEST(FiguresTest, WhatDoesNotFitIsRefused) {
  EXPECT_EQ(message_of([] { (void)draw_factors(FactorFigure{.order = 1}); }),
            "order 1: a picture has 2 to 1000 vertices");
  EXPECT_EQ(message_of([] { (void)draw_factors(FactorFigure{.order = 4, .centre = 4}); }),
            "the centre 4 is not a vertex of K_4");
  EXPECT_EQ(message_of([] {
              (void)draw_factors(FactorFigure{.order = 4, .factors = {{{0, 4}}}});
            }),
            "{0,4} is not an edge of K_4");
  EXPECT_EQ(message_of([] { (void)draw_factors(FactorFigure{.order = 4, .names = {"a"}}); }),
            "1 name for 4 points; give one each");
  EXPECT_EQ(message_of([] { (void)draw_circle(CircleFigure{.v = 1001}); }),
            "v = 1001: a picture has 1 to 1000 points");
  EXPECT_NE(message_of([] { (void)draw_circle(CircleFigure{.v = 3, .blocks = {{{3}, {}}}}); }), "");
}

}  // namespace
}  // namespace changeover::figures_test
