#include "changeover/io/figures.hpp"

#include "changeover/core/developed.hpp"
#include "random_designs.hpp"

namespace changeover {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t number = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) {
    ++number;
  }
  return number;
}

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

// Every element is closed in order, attributes are quoted, and no bare & or < is left.
void check_xml(const std::string& text) {
  std::vector<std::string> open;
  for (std::size_t at = 0; at < text.size(); ++at) {
    ASSERT_NE(text[at], '>') << text.substr(at);
    if (text[at] == '&') {
      const std::string entity = text.substr(at, text.find(';', at) - at);
      ASSERT_TRUE(entity == "&amp" || entity == "&lt" || entity == "&gt" || entity == "&quot");
    }
    if (text[at] != '<') {
      continue;
    }
    const std::size_t end = text.find('>', at);
    ASSERT_NE(end, std::string::npos);
    const std::string tag = text.substr(at + 1, end - at - 1);
    ASSERT_EQ(std::count(tag.begin(), tag.end(), '"') % 2, 0) << tag;
    if (tag[0] == '/') {
      ASSERT_FALSE(open.empty());
      ASSERT_EQ(open.back(), tag.substr(1));
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(tag.substr(0, tag.find(' ')));
    }
    at = end;
  }
  EXPECT_TRUE(open.empty());
}

void check_tikz(const std::string& text) {
  EXPECT_TRUE(text.find("\\begin{tikzpicture}\n") != std::string::npos);
  EXPECT_TRUE(text.ends_with("\\end{tikzpicture}\n"));
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\') {
      ++i;
      continue;
    }
    depth += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
    ASSERT_GE(depth, 0);
  }
  EXPECT_EQ(depth, 0);
}

TEST(FiguresTest, AFactorizationHasAColourAFactorAndAVertexInTheCentre) {
  const FactorFigure figure = circle_factors(8);
  const std::string svg = to_svg(figure);
  check_xml(svg);
  EXPECT_EQ(count(svg, "<line "), 28U);
  EXPECT_EQ(count(svg, "stroke=\"#0072B2\""), 4U);
  EXPECT_EQ(count(svg, "<circle "), 8U);
  EXPECT_EQ(count(svg, "cx=\"240.00\" cy=\"240.00\""), 1U);
  EXPECT_EQ(count(svg, "<title>1-factorization of K_8</title>"), 1U);
  EXPECT_EQ(count(svg, "dasharray"), 0U);
  const std::string tikz = to_tikz(figure);
  check_tikz(tikz);
  EXPECT_EQ(count(tikz, "\\draw["), 28U);
  EXPECT_EQ(count(tikz, "\\node["), 8U);
  EXPECT_EQ(count(to_svg(circle_factors(10)), "dasharray"), 10U);
}

TEST(FiguresTest, ABlockAndItsSuccessorShowNewPairsAndTheUnchangedSubset) {
  const BaseBlocks base{{.v = 11, .k = 4, .kind = Kind::circular}, {{0, 1, 2, 5}}};
  DevelopedSource source(base);
  const CircleFigure figure = circle_figure(read_all(source), 0, 2);
  ASSERT_EQ(figure.blocks.size(), 2U);
  EXPECT_EQ(figure.blocks[0].introduced, (Block{2, 5}));
  const std::string svg = to_svg(figure);
  check_xml(svg);
  EXPECT_EQ(count(svg, "<line "), 10U);
  EXPECT_EQ(count(svg, "stroke=\"#0072B2\""), 5U);
  EXPECT_EQ(count(svg, "stroke=\"#D55E00\""), 5U);
  EXPECT_EQ(count(svg, "r=\"19.00\" fill=\"#000000\""), 2U);  // 1 and 2
  check_tikz(to_tikz(figure));
  EXPECT_EQ(count(to_tikz(figure), "fill=factor6"), 2U);
}

TEST(FiguresTest, AsManyBlocksAsThereAreAreDrawn) {
  const BaseBlocks base{{.v = 11, .k = 4, .kind = Kind::circular}, {{0, 1, 2, 5}}};
  DevelopedSource source(base);
  const Design design = read_all(source);
  EXPECT_EQ(circle_figure(design, 9, 5).blocks.size(), 2U);
  EXPECT_EQ(circle_figure(design, 11, 5).blocks.size(), 0U);
  check_xml(to_svg(circle_figure(design, 3, 1)));
}

TEST(FiguresTest, NamesAndTitlesAreEscaped) {
  CircleFigure figure{.v = 2, .blocks = {}, .names = {"<a&\"", "∞_s\xff"}, .title = "1 < 2\n& %"};
  const std::string svg = to_svg(figure);
  check_xml(svg);
  EXPECT_EQ(count(svg, "&lt;a&amp;&quot;"), 1U);
  EXPECT_EQ(count(svg, "\xff"), 0U);
  const std::string tikz = to_tikz(figure);
  EXPECT_TRUE(tikz.starts_with("% 1 \\textless{} 2 \\& \\%\n")) << tikz;
}

TEST(FiguresTest, ManyPointsAreDrawnSmall) {
  CircleFigure figure{.v = 1000, .blocks = {{{0, 1, 500}, {500}}}};
  check_xml(to_svg(figure));
  EXPECT_EQ(count(to_svg(figure), "<text "), 3U);
  check_tikz(to_tikz(figure));
}

TEST(FiguresTest, WhatDoesNotFitIsRefused) {
  EXPECT_NE(message_of([] { (void)to_svg(FactorFigure{.order = 1}); }), "");
  EXPECT_NE(message_of([] { (void)to_svg(FactorFigure{.order = 4, .centre = 4}); }), "");
  EXPECT_NE(message_of([] { (void)to_svg(FactorFigure{.order = 4, .factors = {{{0, 4}}}}); }), "");
  EXPECT_NE(message_of([] { (void)to_svg(FactorFigure{.order = 4, .names = {"a"}}); }), "");
  EXPECT_NE(message_of([] { (void)to_tikz(CircleFigure{.v = 1001}); }), "");
  EXPECT_NE(message_of([] { (void)to_tikz(CircleFigure{.v = 3, .blocks = {{{3}, {}}}}); }), "");
}

}  // namespace
}  // namespace changeover
