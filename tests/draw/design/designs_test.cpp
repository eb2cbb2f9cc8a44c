#include <random>
#include <set>

#include "changeover/core/developed.hpp"
#include "changeover/draw/draw.hpp"
#include "changeover/io/tables.hpp"
#include "drawn.hpp"

namespace changeover::designs_test {
namespace {

Design three_blocks() {
  return {Parameters{.v = 6, .k = 4, .kind = Kind::circular},
          std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}}};
}

// A list that changes some elements per step, rarely a design.
Design wandering(std::uint64_t v, std::uint64_t k, std::size_t b, Kind kind, std::uint32_t seed) {
  std::mt19937 random(seed);
  Design design(Parameters{.v = v, .k = k, .kind = kind});
  Block all(v);
  for (Element x = 0; x < v; ++x) {
    all[x] = x;
  }
  std::shuffle(all.begin(), all.end(), random);
  for (std::size_t i = 0; i < b; ++i) {
    for (auto changes = random() % 3; changes > 0; --changes) {
      std::swap(all[random() % k], all[k + random() % (v - k)]);
    }
    design.append(std::span(all).first(k));
  }
  return design;
}

std::vector<Design> some_designs() {
  std::vector<Design> designs = {three_blocks()};
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    designs.push_back(wandering(7 + seed % 4, 2 + seed % 4, 2 + seed * seed,
                                seed % 2 == 0 ? Kind::circular : Kind::linear, seed));
  }
  return designs;
}

// What the blocks themselves say, without Transitions.
std::set<Element> set_of(const Design& design, std::size_t i) {
  return {design.block(i).begin(), design.block(i).end()};
}

bool introduced(const Design& design, std::size_t i, Element x) {
  const std::size_t b = design.block_count();
  const bool linear = design.parameters().kind == Kind::linear;
  return set_of(design, i).contains(x) &&
         ((i == 0 && linear) || !set_of(design, (i + b - 1) % b).contains(x));
}

bool leaves(const Design& design, std::size_t i, Element x) {
  const std::size_t b = design.block_count();
  const bool linear = design.parameters().kind == Kind::linear;
  return set_of(design, i).contains(x) &&
         ((i + 1 == b && linear) || !set_of(design, (i + 1) % b).contains(x));
}

struct Counts {
  std::size_t introductions = 0, leavings = 0, bad_steps = 0;
};

Counts counts_of(const Design& design) {
  Counts counts;
  const std::size_t b = design.block_count();
  for (std::size_t i = 0; i < b; ++i) {
    std::size_t changes = 0;
    for (Element x = 0; x < design.v(); ++x) {
      changes += introduced(design, i, x) ? 1U : 0U;
      counts.leavings += leaves(design, i, x) ? 1U : 0U;
    }
    counts.introductions += changes;
    const bool is_step = i > 0 || (design.parameters().kind == Kind::circular && b > 1);
    counts.bad_steps += is_step && changes != design.parameters().change ? 1U : 0U;
  }
  return counts;
}

TEST(ArrayTest, StarsAreAsManyAsIntroductionsAndLeavings) {
  for (const Design& design : some_designs()) {
    const Picture picture = draw(design, {.leaving = true});
    expect_legible(picture);
    const Page page = read_svg(svg(picture));
    const Counts counts = counts_of(design);
    EXPECT_EQ(page.count("block"), design.block_count());
    EXPECT_EQ(page.count("introduced"), counts.introductions);
    EXPECT_EQ(page.count("bad-step"), counts.bad_steps);
    std::size_t stars = 0;
    for (const DrawnText& text : page.texts) {
      if (!text.content.starts_with("x*")) {  // of the legend
        stars +=
            static_cast<std::size_t>(std::count(text.content.begin(), text.content.end(), '*'));
      }
    }
    EXPECT_EQ(stars, counts.introductions + counts.leavings);
    EXPECT_EQ(read_svg(svg(draw(design))).count("introduced"), counts.introductions);
  }
}

TEST(ArrayTest, APartShowsItsBlocksWithTheMarksOfTheWhole) {
  const Design design = wandering(9, 4, 60, Kind::circular, 5);
  const Page page = read_svg(svg(draw(design, {.from = 11, .to = 30})));
  EXPECT_EQ(page.count("block"), 20U);
  std::size_t introductions = 0;
  for (std::size_t i = 10; i < 30; ++i) {
    for (Element x = 0; x < design.v(); ++x) {
      introductions += introduced(design, i, x) ? 1U : 0U;
    }
  }
  EXPECT_EQ(page.count("introduced"), introductions);
  EXPECT_NE(page.title.find("blocks 11 to 30"), std::string::npos) << page.title;
  EXPECT_EQ(read_svg(svg(draw(design, {.from = 60}))).count("block"), 1U);
  EXPECT_EQ(message_of([&] { (void)draw(design, {.from = 61}); }),
            "--from 61: there are fewer blocks; give a smaller number");
  for (const PictureKind kind :
       {PictureKind::array, PictureKind::stays, PictureKind::coverage, PictureKind::circle}) {
    EXPECT_EQ(message_of([&] { (void)draw(design, {.picture = kind, .from = 60, .to = 60}); }), "");
    EXPECT_EQ(message_of([&] { (void)draw(design, {.picture = kind, .from = 59, .to = 61}); }),
              "--to 61: there are only 60 blocks; give a smaller number");
    EXPECT_EQ(message_of([&] { (void)draw(design, {.picture = kind, .from = 70, .to = 71}); }),
              "--from 70: there are fewer blocks; give a smaller number");
  }
}

TEST(ArrayTest, AnExpansionSetHasACaretAtEachPosition) {
  const Design design = three_blocks();
  const std::vector<UnchangedSubset> subsets = unchanged_subsets(design);
  const Picture picture = draw(design, {.expansion_set = subsets});
  expect_legible(picture);
  const Page page = read_svg(svg(picture));
  ASSERT_EQ(page.count("caret"), 3U);
  EXPECT_EQ(page.all("caret")[0].title, "unchanged subset after block 1: {2,3}");
  // At the front of a linear design, before the first band; each once, however the bands break.
  Design linear = wandering(9, 4, 130, Kind::linear, 3);
  std::vector<UnchangedSubset> all;
  for (std::size_t i = 0; i <= 130; ++i) {
    all.push_back({.position = i, .elements = {0}});
  }
  const Page many = read_svg(svg(draw(linear, {.expansion_set = all})));
  EXPECT_EQ(many.count("caret"), 131U);
  EXPECT_GT(many.count("band"), 1U);
}

TEST(ArrayTest, LongAndForeignNamesAreCutAndNeverOverlap) {
  Design design = wandering(8, 3, 30, Kind::linear, 8);
  design.set_labels({"∞_s", "a-name-that-is-much-longer-than-a-column", "漢字漢字漢字漢字漢字漢字",
                     "0_l", "<&>", "WWWWWWWWWWWWWWWWWWWWWWW", "é", "\\begin{x}"});
  for (const PictureKind kind :
       {PictureKind::array, PictureKind::stays, PictureKind::coverage, PictureKind::circle}) {
    const Picture picture = draw(design, {.picture = kind});
    expect_legible(picture);
    bool whole_name = false;
    for (const DrawnMark& mark : read_svg(svg(picture)).marks) {
      whole_name = whole_name || mark.title == design.label(1);
    }
    EXPECT_TRUE(whole_name) << to_string(
        kind);  // where it is cut, the whole name is shown on hover
  }
}

TEST(ArrayTest, TwoThousandBlocksStayLegible) {
  const Design design = wandering(40, 5, 2000, Kind::linear, 1);
  for (const PictureKind kind : {PictureKind::array, PictureKind::stays, PictureKind::coverage}) {
    const Page page = read_svg(svg(draw(design, {.picture = kind})));
    EXPECT_EQ(page.overlap(), "") << to_string(kind);
    EXPECT_EQ(page.count("block"), kind == PictureKind::array ? 2000U : 0U);
  }
}

// The stays of an element as runs of a row of blocks, closed to a circle or not.
std::size_t runs(const Design& design, Element x) {
  std::size_t starts = 0;
  std::size_t blocks = 0;
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    starts += introduced(design, i, x) ? 1U : 0U;
    blocks += set_of(design, i).contains(x) ? 1U : 0U;
  }
  return starts == 0 && blocks > 0 ? 1 : starts;
}

TEST(StaysTest, BarsAreAsManyAsRunsOfBlocks) {
  for (const Design& design : some_designs()) {
    for (const ElementOrder order :
         {ElementOrder::first, ElementOrder::stays, ElementOrder::given}) {
      const Picture picture = draw(design, {.picture = PictureKind::stays, .order = order});
      expect_legible(picture);
      const Page page = read_svg(svg(picture));
      std::size_t stays = 0;
      std::size_t cells = 0;
      for (Element x = 0; x < design.v(); ++x) {
        stays += runs(design, x);
      }
      for (const DrawnMark& stay : page.all("stay")) {
        cells += std::stoul(stay.attributes.at("data-length"));
      }
      EXPECT_EQ(page.count("stay"), stays);
      EXPECT_EQ(cells, design.block_count() * design.k());
      EXPECT_EQ(page.count("element"), design.v());
    }
  }
}

std::vector<std::string> elements_in_order(const Page& page) {
  std::vector<std::pair<double, std::string>> names;
  for (const DrawnText& text : page.texts) {
    if (text.attributes.contains("class") && text.attributes.at("class") == "names") {
      names.emplace_back(text.top, text.content);
    }
  }
  std::sort(names.begin(), names.end());
  std::vector<std::string> order;
  for (const auto& [top, name] : names) {
    order.push_back(name);
  }
  return order;
}

TEST(StaysTest, AStayOverTheEndIsOneAndOrdersAreAsTheySay) {
  // 0 stays over the end; 3 is in every block; 5 in none.
  const Design design(Parameters{.v = 6, .k = 3, .change = 1, .kind = Kind::circular},
                      std::vector<Block>{{0, 1, 3}, {2, 1, 3}, {2, 4, 3}, {0, 4, 3}});
  const Picture picture = draw(design, {.picture = PictureKind::stays});
  const Page page = read_svg(svg(picture));
  EXPECT_EQ(page.count("stay"), 5U);
  EXPECT_EQ(page.all("stay").size(), 5U);
  std::set<std::string> titles;
  for (const DrawnMark& stay : page.all("stay")) {
    titles.insert(stay.title);
  }
  EXPECT_EQ(titles, (std::set<std::string>{"0: blocks 4 to 1, over the end (2)",
                                           "1: blocks 1 to 2 (2)", "2: blocks 2 to 3 (2)",
                                           "4: blocks 3 to 4 (2)", "3: in every block"}));
  EXPECT_EQ(elements_in_order(page), (std::vector<std::string>{"0", "1", "3", "2", "4", "5"}));
  const Page given =
      read_svg(svg(draw(design, {.picture = PictureKind::stays, .order = ElementOrder::given})));
  EXPECT_EQ(elements_in_order(given), (std::vector<std::string>{"0", "1", "2", "3", "4", "5"}));
  // Of a part nothing is closed: 0 has a stay at each end.
  const Page part =
      read_svg(svg(draw(design, {.picture = PictureKind::stays, .from = 2, .to = 4})));
  EXPECT_EQ(part.count("stay"), 5U);
  EXPECT_EQ(part.count_with("stay", "data-from", "4"), 1U);
}

TEST(StaysTest, ColoursSayLengthOrOrdinal) {
  const Design design = wandering(8, 3, 40, Kind::linear, 2);
  const Page page =
      read_svg(svg(draw(design, {.picture = PictureKind::stays, .colour = StayColour::ordinal})));
  std::set<Element> present;
  for (const Element x : design.elements()) {
    present.insert(x);
  }
  // Each element that occurs has a first stay; more of that colour come with the eighth.
  EXPECT_GE(page.count_with("stay", "fill", Paint::series(0).hex(Theme::light)), present.size());
  const Page by_length = read_svg(svg(draw(design, {.picture = PictureKind::stays})));
  EXPECT_GE(by_length.count_with("stay", "fill", Paint::ramp(1).hex(Theme::light)), 1U);
}

TEST(CoverageTest, PairsAreCountedAsTheBlocksSay) {
  for (const Design& design : some_designs()) {
    const Picture picture = draw(design, {.picture = PictureKind::coverage});
    expect_legible(picture);
    const Page page = read_svg(svg(picture));
    std::size_t uncovered = 0;
    std::size_t excess = 0;
    std::size_t always = 0;
    std::map<std::size_t, std::size_t> first;
    for (Element x = 0; x < design.v(); ++x) {
      for (Element y = 0; y < x; ++y) {
        std::size_t times = 0;
        std::size_t meeting = 0;
        for (std::size_t i = 0; i < design.block_count(); ++i) {
          const std::set<Element> block = set_of(design, i);
          if (block.contains(x) && block.contains(y)) {
            meeting = meeting == 0 ? i + 1 : meeting;
            times += introduced(design, i, x) || introduced(design, i, y) ? 1U : 0U;
          }
        }
        uncovered += meeting == 0 ? 1U : 0U;
        excess += times > 1 ? 1U : 0U;
        always += meeting > 0 && times == 0 ? 1U : 0U;
        ++first[meeting];
      }
    }
    EXPECT_EQ(page.count("uncovered"), uncovered);
    EXPECT_EQ(page.count("excess"), excess);
    EXPECT_EQ(page.count("always"), always);
    for (const auto& [block, pairs] : first) {
      if (block > 0) {
        EXPECT_EQ(page.count_with("pair", "data-first", std::to_string(block)), pairs);
      }
    }
  }
}

TEST(CoverageTest, ManyElementsAreDrawnByColourAndLoseNoPair) {
  const Design design = wandering(150, 9, 400, Kind::linear, 4);
  const Page page = read_svg(svg(draw(design, {.picture = PictureKind::coverage})));
  EXPECT_EQ(page.overlap(), "");
  std::set<std::pair<Element, Element>> covered;
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    for (const Element x : design.block(i)) {
      for (const Element y : design.block(i)) {
        if (x < y) {
          covered.insert({x, y});
        }
      }
    }
  }
  std::size_t squares = 0;
  for (const DrawnMark& mark : page.all("pair")) {
    squares += count(mark.attributes.at("d"), "M");
  }
  EXPECT_EQ(squares, covered.size());
  ASSERT_EQ(page.all("uncovered").size(), 1U);
  EXPECT_EQ(count(page.all("uncovered")[0].attributes.at("d"), "M"),
            150U * 149 / 2 - covered.size());
}

TEST(CircleTest, BaseBlocksAreFoundByRotation) {
  const BaseBlocks base{{.v = 11, .k = 4, .kind = Kind::circular}, {{0, 1, 2, 5}}};
  DevelopedSource source(base);
  const Design design = read_all(source);
  const auto found = find_rotation(design);
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, (FoundRotation{{.n = 11, .cycles = 1}, 1, {{0, 1, 2, 5}}}));
  const Picture picture = draw(design, {.picture = PictureKind::circle});
  expect_legible(picture);
  const Page page = read_svg(svg(picture));
  EXPECT_EQ(page.count("point"), 11U);
  std::string words;
  for (const DrawnText& text : page.texts) {
    words += text.content + "\n";
  }
  EXPECT_NE(words.find("1 base block over Z_11, developed by +1\n"), std::string::npos) << words;
  EXPECT_NE(words.find("new differences: 1 2 3 4 5\n"), std::string::npos) << words;
}

TEST(CircleTest, AShortRotationAndOneWithAFixedElementAreFoundAndNothingElseIs) {
  EXPECT_EQ(find_rotation(three_blocks()),
            (FoundRotation{{.n = 6, .cycles = 1}, 2, {{0, 1, 2, 3}}}));
  // {0,1,6} over Z_6 with 6 fixed.
  const Design fixed(
      Parameters{.v = 7, .k = 3, .change = 1, .kind = Kind::circular},
      std::vector<Block>{{0, 1, 6}, {1, 2, 6}, {2, 3, 6}, {3, 4, 6}, {4, 5, 6}, {5, 0, 6}});
  EXPECT_EQ(find_rotation(fixed),
            (FoundRotation{{.n = 6, .cycles = 1, .fixed = 1}, 1, {{0, 1, 6}}}));
  expect_legible(draw(fixed, {.picture = PictureKind::circle}));
  Design spoilt(fixed.parameters());
  for (std::size_t i = 0; i < fixed.block_count(); ++i) {
    spoilt.append(fixed.block(i == 4 ? 3 : i));
  }
  EXPECT_EQ(find_rotation(spoilt), std::nullopt);
  Design linear = fixed;
  linear.set_kind(Kind::linear);
  EXPECT_EQ(find_rotation(linear), std::nullopt);
  // Of a list without a rotation the first blocks are drawn, or those that are named.
  const Page page =
      read_svg(svg(draw(linear, {.picture = PictureKind::circle, .from = 2, .to = 3})));
  EXPECT_EQ(page.count("pair"), 4U);
}

TEST(CircleTest, ARotationWithSeveralCyclesIsFound) {
  // Two cycles of length 5 and a fixed element.
  const Automorphism pi{.n = 5, .cycles = 2, .fixed = 1};
  const BaseBlocks base{{.v = 11, .k = 4, .kind = Kind::circular}, {{0, 1, 5, 10}, {0, 2, 6, 10}}};
  DevelopedSource source(base, pi);
  const Design design = read_all(source);
  EXPECT_EQ(find_rotation(design), (FoundRotation{pi, 1, base.blocks}));
  const Picture picture = draw(design, {.picture = PictureKind::circle});
  expect_legible(picture);
  std::string words;
  for (const DrawnText& text : read_svg(svg(picture)).texts) {
    words += text.content + "\n";
  }
  EXPECT_NE(words.find("2 base blocks, 2 cycles of length 5\n"), std::string::npos) << words;
  EXPECT_NE(words.find("10 stays where it is (∞)\n"), std::string::npos) << words;
  // The second block keeps 0 and 10: {0,2}, {0,6}, {2,6} and two pairs with 10 are new.
  EXPECT_NE(words.find("new differences: 0:2 0-1:1 0-1:4 ∞ ∞\n"), std::string::npos) << words;
}

TEST(LimitsTest, WhatIsTooMuchIsSaidInOneLine) {
  const Parameters p{.v = 100, .k = 4};
  const auto defect = [&](const Parameters& asked, std::uint64_t b, PictureKind kind) {
    return draw_defect(asked, b, {.picture = kind}).value_or("");
  };
  EXPECT_EQ(defect(p, 20'000, PictureKind::array), "");
  EXPECT_NE(defect(p, 20'001, PictureKind::array).find("--from and --to"), std::string::npos);
  EXPECT_NE(defect(p, 1'000'000'000, PictureKind::stays).find("--from and --to"),
            std::string::npos);
  EXPECT_EQ(draw_defect(p, 1'000'000'000, {.from = 999'000, .to = 999'100}), std::nullopt);
  EXPECT_NE(defect({.v = 501, .k = 4}, 5, PictureKind::coverage), "");
  EXPECT_NE(defect({.v = 2001, .k = 4}, 5, PictureKind::stays), "");
  EXPECT_NE(defect({.v = 1001, .k = 4}, 5, PictureKind::circle), "");
  EXPECT_NE(defect(p, 1'000'000'000, PictureKind::circle)
                .find("blocks of 4 elements are too many to look for a rotation in them"),
            std::string::npos);
  EXPECT_NE(draw_defect(p, 9, {.from = 0}).value_or(""), "");
  EXPECT_NE(draw_defect(p, 9, {.from = 5, .to = 4}).value_or(""), "");
  const Design none(p);
  for (const PictureKind kind :
       {PictureKind::array, PictureKind::stays, PictureKind::coverage, PictureKind::circle}) {
    EXPECT_EQ(message_of([&] { (void)draw(none, {.picture = kind}); }), "there is no block to draw")
        << to_string(kind);
    EXPECT_EQ(picture_kind_from_string(to_string(kind)), kind);
  }
  EXPECT_NE(message_of([&] { (void)draw(three_blocks(), {.picture = PictureKind::recipe}); }), "");
  EXPECT_EQ(picture_kind_from_string("arrays"), std::nullopt);
}

// A stream that does not know how long it is is refused once it is too long.
class Endless final : public BlockByBlock<Endless> {
 public:
  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  bool make(std::span<Element> block) {
    block[0] = next_++ % 2;
    block[1] = 2;
    return true;
  }

 private:
  Parameters parameters_{.v = 3, .k = 2, .change = 1};
  Element next_ = 0;
};

TEST(LimitsTest, AStreamWithoutEndIsRefusedOrDrawnInPart) {
  for (const PictureKind kind : {PictureKind::array, PictureKind::stays}) {
    Endless endless;
    EXPECT_NE(message_of([&] { (void)draw(endless, {.picture = kind}); }).find("--from and --to"),
              std::string::npos);
    Endless again;
    expect_legible(draw(again, {.picture = kind, .from = 3, .to = 12}));
  }
}

}  // namespace
}  // namespace changeover::designs_test
