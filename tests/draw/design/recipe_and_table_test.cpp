#include "changeover/draw/draw.hpp"
#include "drawn.hpp"

namespace changeover::recipe_and_table_test {
namespace {

std::size_t nodes_of(const Recipe& recipe) {
  std::size_t nodes = 1;
  for (const Recipe& input : recipe.inputs) {
    nodes += nodes_of(input);
  }
  return nodes;
}

TEST(RecipePictureTest, EveryConstructionIsANodeWithItsBlocks) {
  const Registry& registry = Registry::standard();
  for (const Parameters& p :
       {Parameters{.v = 253, .k = 13}, Parameters{.v = 61, .k = 4, .kind = Kind::circular},
        Parameters{.v = 4096, .k = 5}, Parameters{.v = 100, .k = 12}}) {
    const auto offer = registry.best(p);
    ASSERT_TRUE(offer);
    const Picture picture = draw_recipe(offer->recipe);
    expect_legible(picture);
    const Page page = read_svg(svg(picture));
    EXPECT_EQ(page.count("node"), nodes_of(offer->recipe));
    EXPECT_EQ(page.count("edge"), nodes_of(offer->recipe) - 1);
    EXPECT_GE(page.count_with("node", "data-b", std::to_string(offer->b)), 1U);
    for (const DrawnMark& node : page.all("node")) {
      EXPECT_NE(node.title, "");
      EXPECT_NE(registry.find(node.attributes.at("data-construction")), nullptr);
    }
  }
}

TEST(RecipePictureTest, WorksAreNamedAndNotTheirKeysOrFiles) {
  const auto offer =
      Registry::standard().best({.v = 40, .k = 6, .change = 2, .kind = Kind::circular});
  ASSERT_TRUE(offer);
  const std::string drawn = svg(draw_recipe(offer->recipe));
  for (
      const char* right :
      {">Changeover, Theorem 15<", ">Chafee and Stevens 2025, Theorem 3<",
       "A. L. Chafee and B. Stevens. Recursive and Cyclic Constructions for Double-Change Covering "
       "Designs. Journal of Combinatorial Designs (2025), Theorem 3"}) {
    EXPECT_NE(drawn.find(right), std::string::npos) << right;
  }
  for (const char* wrong : {"ChafeeStevens", "docs/", "src/", "elementary", "McSorley1999"}) {
    EXPECT_EQ(drawn.find(wrong), std::string::npos) << wrong;
  }
}

TEST(RecipePictureTest, InputsStandSideBySide) {
  const auto leaf = Registry::standard().best({.v = 7, .k = 3, .kind = Kind::circular});
  ASSERT_TRUE(leaf);
  Recipe wrong{"no-such-construction", {.v = 7, .k = 3}, {}, {}, {}};
  EXPECT_NE(message_of([&] { (void)draw_recipe(wrong); }), "");
  Design design = Registry::standard().build_design(leaf->recipe);
  EXPECT_EQ(read_svg(svg(draw(design, {.picture = PictureKind::recipe}))).count("node"),
            nodes_of(leaf->recipe));
}

std::vector<KnownCell> some_cells(std::uint64_t v_from, std::uint64_t v_to, std::uint64_t k_from,
                                  std::uint64_t k_to) {
  std::vector<KnownCell> cells;
  for (std::uint64_t v = v_from; v <= v_to; ++v) {
    for (std::uint64_t k = k_from; k <= k_to; ++k) {
      KnownCell& cell = cells.emplace_back();
      cell.parameters = {.v = v, .k = k};
      cell.bound.blocks = v + k;
      if ((v + k) % 7 == 0) {
        cell.impossible = "it is so";
      } else if ((v + k) % 5 != 0) {
        cell.best.emplace();
        cell.best->b = v + k + (v * k) % 4;
        cell.best->recipe.construction = "some";
      }
    }
  }
  return cells;
}

TEST(HeatmapTest, EveryCellIsASquareThatSaysWhatIsKnown) {
  for (const HeatMeasure measure : {HeatMeasure::ratio, HeatMeasure::status, HeatMeasure::gap}) {
    for (const auto& cells : {some_cells(5, 40, 3, 9), some_cells(5, 200, 3, 9),
                              some_cells(9, 9, 4, 4), some_cells(95, 105, 3, 60)}) {
      const Picture picture = draw_heatmap(cells, measure);
      expect_legible(picture);
      const Page page = read_svg(svg(picture));
      ASSERT_EQ(page.count("cell"), cells.size());
      for (std::size_t i = 0; i < cells.size(); ++i) {
        const DrawnMark mark = page.all("cell")[i];
        EXPECT_EQ(mark.attributes.at("data-v"), std::to_string(cells[i].parameters.v));
        EXPECT_EQ(mark.attributes.at("data-k"), std::to_string(cells[i].parameters.k));
        const std::string known = cells[i].impossible ? "none exists"
                                  : cells[i].best
                                      ? fmt::format("{} blocks by some", cells[i].best->b)
                                      : "open";
        EXPECT_NE(mark.title.find(known), std::string::npos) << mark.title;
        if (cells.size() > 300) {
          break;  // looking each of them up is slow
        }
      }
    }
    EXPECT_EQ(heat_measure_from_string(to_string(measure)), measure);
  }
}

TEST(HeatmapTest, SignsSayWhatColoursSay) {
  const std::vector<KnownCell> cells = some_cells(5, 20, 3, 9);
  std::size_t minimum = 0;
  std::size_t impossible = 0;
  std::size_t open = 0;
  for (const KnownCell& cell : cells) {
    minimum += cell.status() == "minimum" ? 1U : 0U;
    impossible += cell.impossible ? 1U : 0U;
    open += !cell.impossible && !cell.best ? 1U : 0U;
  }
  const Page page = read_svg(svg(draw_heatmap(cells, HeatMeasure::status)));
  const auto signs = [&](const std::string& sign) {
    return static_cast<std::size_t>(
        std::count_if(page.texts.begin(), page.texts.end(),
                      [&](const auto& text) { return text.content == sign; }));
  };
  EXPECT_GT(minimum * impossible * open, 0U);
  EXPECT_EQ(signs("="), minimum);
  EXPECT_EQ(signs("–"), impossible);
  EXPECT_EQ(signs("?"), open);
}

TEST(HeatmapTest, WhatIsNoTableIsRefused) {
  std::vector<KnownCell> cells;
  EXPECT_EQ(message_of([&] { (void)draw_heatmap(cells, HeatMeasure::gap); }),
            "a heat map of no cells; give at least one");
  cells = some_cells(5, 6, 3, 4);
  cells.push_back(cells.front());
  EXPECT_NE(message_of([&] {
              (void)draw_heatmap(cells, HeatMeasure::gap);
            }).find("linear DCCD(5,3) is in a heat map twice"),
            std::string::npos);
  cells.back().parameters.kind = Kind::circular;
  EXPECT_NE(message_of([&] {
              (void)draw_heatmap(cells, HeatMeasure::gap);
            }).find("one heat map is of one kind and change number, not of "),
            std::string::npos);
  cells.resize(2);
  cells[1].parameters.v = 1'000'000;
  EXPECT_NE(
      message_of([&] {
        (void)draw_heatmap(cells, HeatMeasure::gap);
      }).find("a heat map of v = 5 to 1000000 and k = 3 to 4 has more than 20000 cells; ask for fewer"),
      std::string::npos);
}

}  // namespace
}  // namespace changeover::recipe_and_table_test
