// Designs that are printed in the paper and that no theorem of it gives: the DCCD(9,3,12) of Preece
// et al., with the elements 1, …, 9, and the DCCD(7,3,7).
//
// Both can be read as linear and as circular, and are tight either way. Read as linear, the
// DCCD(7,3,7) has an expansion set that uses both ends; read as circular it has none, for element 2
// is then in no unchanged subset. The DCCD(9,3,12) has none: its inner unchanged subsets and two
// ends meet at most 7 elements.
#include <array>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"

namespace changeover::printed_entry {
namespace {

struct Printed {
  std::uint64_t v, k;
  std::vector<Block> blocks;
  std::string_view origin;
};

const Printed* printed(const Parameters& p) {
  static const std::array<Printed, 2> designs{{
      {7,
       3,
       {{0, 1, 2}, {0, 4, 5}, {2, 4, 3}, {0, 6, 3}, {1, 6, 4}, {5, 6, 2}, {5, 3, 1}},
       "The seven blocks of [ChafeeStevens2025, Table 2]."},
      {9,
       3,
       {{0, 1, 2},
        {0, 3, 6},
        {0, 4, 8},
        {0, 5, 7},
        {3, 5, 4},
        {2, 5, 8},
        {1, 5, 6},
        {2, 4, 6},
        {7, 8, 6},
        {7, 1, 4},
        {7, 2, 3},
        {1, 8, 3}},
       "The twelve blocks of [PreeceEtAl1995] as in [ChafeeStevens2025, Table 1]."},
  }};
  for (const Printed& design : designs) {
    if (p.v == design.v && p.k == design.k && p.change == 2 && p.strength == 2) {
      return &design;
    }
  }
  return nullptr;
}

bool has_expansion_set(const Parameters& p) { return p.v == 7 && p.kind == Kind::linear; }

constexpr Description description{
    .name = "printed",
    .summary = "a design printed in the literature",
    .preconditions = "m = 2, (v,k) = (7,3) or (9,3)",
    .guarantee = "a tight DCCD(7,3,7) or DCCD(9,3,12), linear or circular",
    .cited = "ChafeeStevens2025",
    .place = "Tables 1 and 2",
};

class PrintedTables final : public Described<Family, description> {
 public:
  // The set that the paper marks. Element 6 could be taken at position 4 as well.
  std::optional<std::vector<UnchangedSubset>> expansion_set(const Recipe& recipe,
                                                            const Registry&) const override {
    if (!has_expansion_set(required(recipe))) {
      return std::nullopt;
    }
    return std::vector<UnchangedSubset>{{0, {2}}, {1, {0}}, {2, {4}}, {3, {3}},
                                        {5, {6}}, {6, {5}}, {7, {1}}};
  }

  std::vector<std::string> labels(const Recipe& recipe, const Registry&) const override {
    if (required(recipe).v == 9) {
      return {"1", "2", "3", "4", "5", "6", "7", "8", "9"};
    }
    return {};
  }

 protected:
  Recipe recipe_for(const Parameters& p) const override {
    Recipe recipe = recipe_of(p);
    recipe.blocks = printed(p)->blocks;
    return recipe;
  }

  std::optional<Promise> promise(const Parameters& p) const override {
    const Printed* design = printed(p);
    if (design == nullptr) {
      return std::nullopt;
    }
    return Promise{design->blocks.size(), true, true, has_expansion_set(p)};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    return std::make_unique<BlockListSource>(p, printed(p)->blocks);
  }

  std::string explanation(const Parameters& p) const override {
    return std::string(printed(p)->origin);
  }
};

}  // namespace

const Construction& construction() { return only<PrintedTables>(); }

}  // namespace changeover::printed_entry
