// The examples of the headers of draw/, as they stand there.
#include "example_support.hpp"

namespace changeover::test::draw_examples_test {
namespace {

TEST(DrawExamples, Draw) {
  Design design(Parameters{.v = 6, .k = 4, .kind = Kind::circular},
                std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}});
  std::string array = svg(draw(design));
  std::string stays = svg(draw(design, {.picture = PictureKind::stays}), Theme::dark);
  EXPECT_THAT(array, HasSubstr("<title>circular DCCD(6,4), 3 blocks</title>"));
  EXPECT_THAT(stays, HasSubstr("class=\"stay\""));
}

TEST(DrawExamples, Figures) {
  FactorFigure k8 = factor_figure(one_factorization(8), 7);
  std::string page = svg(draw_factors(k8));
  EXPECT_THAT(page, HasSubstr("<svg"));
  EXPECT_THAT(page, HasSubstr("1-factorization of K_8"));

  CircleFigure circle{.v = 11, .blocks = {{{0, 1, 2, 5}, {2, 5}}, {{1, 2, 3, 6}, {3, 6}}}};
  std::string figure = tikz(draw_circle(circle));
  EXPECT_THAT(figure, HasSubstr("\\begin{tikzpicture}"));
}

TEST(DrawExamples, Heatmap) {
  const BestKnownTable plan =
      best_known_table(Registry::standard(), {.v_from = 5, .v_to = 12, .k_from = 3, .k_to = 5});
  std::vector<KnownCell> cells;
  for (const KnownCell& cell : plan.cells()) {
    if (cell.parameters.kind == Kind::linear) {
      cells.push_back(cell);
    }
  }
  std::string page = svg(draw_heatmap(cells, HeatMeasure::gap));
  EXPECT_THAT(page, HasSubstr("data-v=\"12\" data-k=\"5\""));
}

TEST(DrawExamples, PictureOfMarks) {
  Picture picture{.width = 200, .height = 40, .title = "One stay"};
  picture.add({.shape = Rectangle{.x = 10, .y = 10, .width = 120, .height = 20},
               .kind = "stay",
               .title = "element 3 stays for blocks 2 to 5",
               .data = {{"element", "3"}, {"from", "2"}, {"to", "5"}},
               .style = {.fill = Paint::series(0)}});
  std::string page = svg(picture, Theme::dark);
  std::string figure = tikz(picture);
  EXPECT_THAT(page, HasSubstr("data-element=\"3\""));
  EXPECT_THAT(figure, HasSubstr("rectangle"));
}

}  // namespace
}  // namespace changeover::test::draw_examples_test
