#include "changeover/draw/picture.hpp"

#include <algorithm>
#include <cmath>

#include "drawn.hpp"

namespace changeover::writers_test {
namespace {

// Relative luminance as WCAG 2.1 has it.
double luminance(const std::string& hex) {
  double sum = 0;
  for (const auto& [at, weight] : {std::pair{1U, 0.2126}, {3U, 0.7152}, {5U, 0.0722}}) {
    const double value = std::stoi(hex.substr(at, 2), nullptr, 16) / 255.0;
    sum += weight * (value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
  }
  return sum;
}

double contrast(const std::string& one, const std::string& other) {
  const auto [darker, lighter] = std::minmax({luminance(one), luminance(other)});
  return (lighter + 0.05) / (darker + 0.05);
}

TEST(ThemeTest, ColoursStandOutFromTheGround) {
  constexpr double of_marks = 3;
  constexpr double of_texts = 4.5;
  std::vector<Paint> marks;
  for (std::size_t i = 0; i < Paint::series_length; ++i) {
    marks.push_back(Paint::series(i));
  }
  for (int i = 0; i <= 100; ++i) {
    marks.push_back(Paint::ramp(i / 100.0));
  }
  for (const Theme theme : {Theme::light, Theme::dark}) {
    const std::string ground = Paint(Paint::Role::ground).hex(theme);
    for (const Paint::Role role :
         {Paint::Role::ink, Paint::Role::soft, Paint::Role::accent, Paint::Role::alarm}) {
      EXPECT_GE(contrast(Paint(role).hex(theme), ground), of_texts);
    }
    for (const Paint& mark : marks) {
      const std::string colour = mark.hex(theme);
      EXPECT_GE(contrast(colour, ground), of_marks) << colour;
      EXPECT_GE(contrast(Paint::upon(mark).hex(theme), colour), of_texts) << colour;
    }
  }
  EXPECT_EQ(theme_from_string("dark"), Theme::dark);
  EXPECT_EQ(theme_from_string("Dark"), std::nullopt);
}

TEST(ThemeTest, ARampGoesFromEndToEndByLightness) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    int before = -1;
    for (int i = 0; i <= 10; ++i) {
      const std::string hex = Paint::ramp(i / 10.0).hex(theme);
      const auto part = [&](std::size_t at) { return std::stoi(hex.substr(at, 2), nullptr, 16); };
      const int luma = 299 * part(1) + 587 * part(3) + 114 * part(5);
      EXPECT_GT(luma, before) << hex;
      before = luma;
    }
    EXPECT_EQ(Paint::ramp(-1).hex(theme), Paint::ramp(0).hex(theme));
    EXPECT_EQ(Paint::ramp(7).hex(theme), Paint::ramp(1).hex(theme));
  }
}

TEST(ThemeTest, SeriesAreDistinct) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    for (std::size_t i = 0; i < Paint::series_length; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_NE(Paint::series(i).hex(theme), Paint::series(j).hex(theme));
      }
    }
  }
  EXPECT_EQ(Paint::series(Paint::series_length), Paint::series(0));
}

Picture all_shapes() {
  Picture picture{.width = 100, .height = 50, .title = "A & <B>"};
  Group group;
  group.marks.push_back({.shape = Rectangle{.x = 1, .y = 2, .width = 3, .height = 4, .radius = 1},
                         .kind = "box",
                         .title = "\"box\"",
                         .data = {{"name", "<\"&>"}}});
  group.marks.push_back({.shape = Segment{{0, 0}, {10, 10}},
                         .style = {.stroke = Paint(Paint::Role::ink), .dash = 2}});
  group.marks.push_back({.shape = Disc{{5, 5}, 2.5}});
  group.marks.push_back(
      {.shape = Path{.parts = {{{0, 0}, {4, 0}, {4, 3}, {1, 2}}}, .closed = true}, .kind = "path"});
  group.marks.push_back({.shape = Text{.at = {50, 20},
                                       .content = "∞_s",
                                       .element = true,
                                       .introduced = true,
                                       .leaving = true},
                         .style = {.font_size = 10, .bold = true, .anchor = Anchor::middle}});
  picture.add({.shape = std::move(group), .style = {.fill = Paint::series(1)}});
  return picture;
}

TEST(SvgTest, EveryShapeIsWrittenWithWhatIsSaidOfIt) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    const Page page = read_svg(svg(all_shapes(), theme));
    EXPECT_EQ(page.title, "A & <B>");
    ASSERT_EQ(page.all("box").size(), 1U);
    const DrawnMark box = page.all("box")[0];
    EXPECT_EQ(box.title, "\"box\"");
    EXPECT_EQ(box.attributes.at("data-name"), "<\"&>");
    EXPECT_EQ(box.attributes.at("rx"), "1");
    EXPECT_EQ(page.all("path")[0].attributes.at("d"), "M0 0H4V3L1 2Z");
    ASSERT_EQ(page.texts.size(), 1U);
    EXPECT_EQ(page.texts[0].content, "∞s**");
    EXPECT_EQ(page.texts[0].attributes.at("fill"), Paint::series(1).hex(theme));
    EXPECT_EQ(page.count_with("ground", "fill", Paint(Paint::Role::ground).hex(theme)), 1U);
  }
  EXPECT_EQ(mark_count(all_shapes()), 5U);
}

TEST(SvgTest, WhatIsNoCharacterIsReplaced) {
  Picture picture{.width = 9, .height = 9, .title = "a\x01\xff\xE2\x80\xAE b"};
  EXPECT_EQ(read_svg(svg(picture)).title, "a\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD b");
}

TEST(TikzTest, EveryShapeIsWrittenAndStylesAreInherited) {
  const std::string text = tikz(all_shapes());
  check_tikz(text);
  EXPECT_EQ(count(text, "\\path["), 4U);
  EXPECT_EQ(count(text, "$\\infty_{\\mathrm{s}*}^{*}$") + count(text, "$\\infty_{s*}^{*}$"), 1U);
  const std::string colour = Paint::series(1).hex(Theme::light).substr(1);
  EXPECT_EQ(count(text, "fill=c" + colour), 3U);
  EXPECT_EQ(count(text, "text=c" + colour), 1U);
  EXPECT_TRUE(text.starts_with("% A \\& \\textless{}B\\textgreater{}\n"));
  // A dark ground is part of the picture.
  EXPECT_EQ(count(tikz(all_shapes(), Theme::dark), "\\path["), 5U);
}

TEST(TikzTest, WordsBesidesNamesHaveInfinityToo) {
  Picture picture{.width = 9, .height = 9, .title = "words"};
  picture.add({.shape = Text{.at = {1, 1}, .content = "B1 = ∞_s* 50%"}});
  EXPECT_EQ(count(tikz(picture), "{B1 = $\\infty$\\_s* 50\\%};"), 1U) << tikz(picture);
}

TEST(TikzTest, ATitleOfSeveralLinesStaysAComment) {
  Picture picture{.width = 9, .height = 9, .title = "a\nb\\end{tikzpicture}"};
  const std::string text = tikz(picture);
  EXPECT_EQ(text.substr(0, text.find('\n')), "% a b\\textbackslash{}end\\{tikzpicture\\}");
}

TEST(TikzTest, APictureThatTexCannotHoldIsRefused) {
  Picture picture{.width = 9, .height = 9, .title = "many"};
  picture.marks.resize(most_marks_of_tikz, {.shape = Disc{{1, 1}, 1}});
  check_tikz(tikz(picture));
  picture.add({.shape = Disc{{1, 1}, 1}});
  EXPECT_NE(message_of([&] { (void)tikz(picture); }).find("--from and --to"), std::string::npos);
}

TEST(SvgTest, TextsThatOverlapOrLeaveThePageAreNoticed) {
  const auto page = [](const std::vector<Point>& places) {
    Picture picture{.width = 100, .height = 50, .title = "texts"};
    for (const Point& place : places) {
      picture.add({.shape = Text{.at = place, .content = "word"}});
    }
    return read_svg(svg(picture)).overlap();
  };
  EXPECT_EQ(page({{10, 20}, {50, 20}, {10, 40}}), "");
  EXPECT_NE(page({{10, 20}, {30, 22}}), "");
  EXPECT_NE(page({{90, 20}}), "");
  EXPECT_NE(page({{10, 5}}), "");
}

TEST(TextWidthTest, ItGrowsWithTheTextAndTheFont) {
  EXPECT_NEAR(text_width("00", 10), 12.7, 0.1);
  EXPECT_GT(text_width("漢字", 10), 19);
  EXPECT_GT(text_width("ab", 10, true), text_width("ab", 10));
  EXPECT_EQ(text_width("", 10), 0);
  EXPECT_GT(text_width("\xff", 10), 5);
}

}  // namespace
}  // namespace changeover::writers_test
