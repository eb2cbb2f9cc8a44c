// What callers of the library are told, and no recipe reaches.
#include <gmock/gmock.h>

#include <functional>
#include <string>
#include <vector>

#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/closure.hpp"
#include "changeover/construct/expansion.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "construct/tools/exact_cover.hpp"
#include "construction_checks.hpp"
#include "message_of.hpp"

namespace changeover::refusals_test {
namespace {

using namespace test;
using ::testing::HasSubstr;

const Parameters seven{7, 3, 2, Kind::circular, 2};

Design cyclic() {
  return standard().build_design(standard().find("cyclic")->offer(seven, standard())->recipe);
}

/// A source that can be read once and does not know how many blocks it has.
class Once final : public BlockSource {
 public:
  explicit Once(Design design) : design_(std::move(design)), source_(design_) {}
  const Parameters& parameters() const override { return source_.parameters(); }
  std::span<const Element> read(std::span<Element> room) override { return source_.read(room); }

 private:
  Design design_;
  DesignSource source_;
};

/// A construction of a stranger, who makes such sources.
class Stranger final : public Construction {
 public:
  std::string_view name() const override { return "stranger"; }
  std::string_view summary() const override { return "blocks that come once"; }
  std::string_view preconditions() const override { return "none"; }
  std::string_view guarantee() const override { return "none"; }
  Citation citation() const override { return {}; }
  std::optional<Offer> offer(const Parameters&, const Registry&) const override {
    return std::nullopt;
  }
  std::unique_ptr<BlockSource> build(const Recipe& recipe, const Registry&) const override {
    Design design(recipe.parameters);
    for (const Block& block : recipe.blocks) {
      design.append(block);
    }
    return std::make_unique<Once>(std::move(design));
  }
};

TEST(Refusals, SayWhatIsWrongWithACall) {
  const Design design = cyclic();
  const Stranger stranger;
  const Registry registry({&stranger, standard().find("cut"), standard().find("hold-and-stream")});
  const Recipe once{"stranger", seven, {}, {}, design.blocks()};
  struct Case {
    std::function<void()> call;
    std::string words;
  };
  for (const auto& [call, words] : std::vector<Case>{
           {[&] { (void)registry.build_design(cut_recipe(once, 2)); },
            "cut needs a list of blocks that can be read twice"},
           {[&] { (void)registry.build_design(cut_recipe(once, 8)); },
            "cut after block 8: there are only 7"},
           {[&] {
              (void)registry.build({"hold-and-stream",
                                    {14, 4, 1, Kind::linear, 2},
                                    {{"rounds", 1}, {"blocks", 9}},
                                    {{"stranger", {11, 4, 1, Kind::linear, 2}, {}, {}, {}}},
                                    {}});
            },
            "hold-and-stream: the design at the end must know its number of blocks"},
           {[&] { (void)standard().find("cyclic")->build(once, standard()); },
            "a recipe of 'stranger' cannot be built by 'cyclic'"},
           {[&] { (void)enlarge(design, {.set = 1000, .limits = {.nodes = 1}}); },
            "the search stopped at its limit; allow more"},
           {[&] { (void)expand_by(design, *find_cover(design, {.new_elements = 2}), 23); },
            "23 new elements take at least 23 positions: there are only 7"},
           {[] {
              ExactCover cover(2);
              (void)cover.count_solutions(std::vector<std::uint64_t>(5, 1));
            },
            "5 multiplicities for 0 rows"},
           {[] { (void)ExactCover(4'000'000'000U, 294'967'295U); },
            "4000000000 primary and 294967295 secondary columns are too many"},
           {[] {
              ExactCover cover(0xffff'fffd, 0);
              (void)cover.add_row(std::vector<std::uint32_t>{0});
            },
            "row 0 is too much: 4294967297 links in all"}}) {
    EXPECT_THAT(message_of<Error>(call), HasSubstr(words));
  }
}

TEST(Refusals, SayWhyASetDoesNotServe) {
  const Design design = cyclic();
  EXPECT_EQ(expansion_set_defect(design, {{1, {1}}}), "element 0 is in no subset of the set");
  ExpansionSet all;
  for (Element x = 0; x < 7; ++x) {
    all.push_back({x + 1U, {x}});
  }
  EXPECT_EQ(expansion_set_defect(Design(seven), all), "the design has no blocks");
}

TEST(Refusals, SayWhyACoverDoesNotServe) {
  const Design design = cyclic();
  UnchangedCover none;
  EXPECT_EQ(cover_defect(design, none, 2), "0 subsets: 2 new elements take at least 1 position");
  UnchangedCover cover = *find_cover(design, {.new_elements = 1});
  cover.beside.assign(cover.subsets.size(), {});
  EXPECT_EQ(cover_defect(design, cover, 1),
            "element 0 is in no subset of the cover, nor beside every new element");
  cover.beside.front() = {9};
  EXPECT_THAT(*cover_defect(design, cover, 1),
              HasSubstr("the elements beside new ones at position "));
  UnchangedCover all;
  for (std::size_t position = 1; position <= 7; ++position) {
    for (const Element x : design.block(position - 1)) {
      for (const Element y : design.block(position % 7)) {
        if (x == y) {
          all.subsets.push_back({position, {x}});
        }
      }
    }
  }
  all.beside.assign(7, {});
  for (const Element x : design.block(0)) {
    if (x != all.subsets.front().elements.front()) {
      all.beside.front() = {x};
    }
  }
  EXPECT_EQ(cover_defect(design, all, 1),
            "an element beside new ones at position 1 is in a block there");
  Design slow({4, 3, 2, Kind::circular, 2});
  for (const Block& block : std::vector<Block>{{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}}) {
    slow.append(block);
  }
  UnchangedCover four;
  for (Element x = 0; x < 4; ++x) {
    four.subsets.push_back({x + 1U, {x}});
  }
  EXPECT_EQ(cover_defect(slow, four, 2), "the blocks at position 1 do not differ in 2 elements");
}

TEST(Refusals, TheCatalogIsChosenBeforeItIsUsed) {
  EXPECT_GT(standard_catalog().size().cells, 0U);
  EXPECT_REFUSAL(choose_catalog(""), BadOption,
                 "choose_catalog() must be called before the catalog is first used");
}

}  // namespace
}  // namespace changeover::refusals_test
