// Concatenation with groups: classes, hinges, pieces with holes, and what comes of all three.
#include "construct/tools/concatenation/groups.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "changeover/construct/best_known.hpp"
#include "construction_checks.hpp"

namespace changeover::groups_test {
namespace {

using namespace test;

std::uint64_t pairs(std::uint64_t x) { return x * (x - 1) / 2; }

// Pairs that are newly covered too often, or inside the first block of a linear design: Theorem 15.
std::int64_t waste(const Parameters& p, std::uint64_t b) {
  const std::uint64_t a_block = pairs(p.k) - pairs(p.k - p.change);
  const std::uint64_t most = p.kind == Kind::linear ? pairs(p.k) + a_block * (b - 1) : a_block * b;
  return static_cast<std::int64_t>(most) - static_cast<std::int64_t>(pairs(p.v));
}

std::set<Element> set_of(std::span<const Element> elements) {
  return {elements.begin(), elements.end()};
}

// Whether they are partitions into m-subsets that have each two elements of different groups once,
// or once and more.
void check_classes(const Groups& groups, std::uint64_t m, std::uint64_t classes, bool repeats) {
  const auto [q, g] = groups;
  SCOPED_TRACE(fmt::format("{} groups of {}, m = {}", q, g, m));
  std::set<std::pair<Element, Element>> met;
  for (std::uint64_t i = 0; i < classes; ++i) {
    std::set<Element> all;
    for (const Block& block : group_class(groups, m, i)) {
      EXPECT_EQ(block.size(), m);
      for (const Element x : block) {
        EXPECT_LT(x, q * g);
        EXPECT_TRUE(all.insert(x).second);
        for (const Element y : block) {
          if (x < y) {
            EXPECT_NE(x / g, y / g);
            EXPECT_TRUE(met.emplace(x, y).second || repeats);
          }
        }
      }
    }
    EXPECT_EQ(all.size(), q * g);
  }
  EXPECT_EQ(met.size(), pairs(q) * g * g);
}

TEST(Groups, ClassesArePartitionsWithEachPairOfTwoGroupsOnce) {
  std::map<std::uint64_t, std::size_t> tried;
  for (std::uint64_t m = 2; m <= 5; ++m) {
    for (std::uint64_t q = 1; q <= 9; ++q) {
      for (std::uint64_t g = 0; g <= 12; ++g) {
        const std::uint64_t classes = class_count({q, g}, m);
        if (classes == 0) {
          EXPECT_TRUE(m > 2 || q < 2 || g == 0 || (q % 2 == 1 && g % 2 == 1));
          continue;
        }
        const bool repeats = m == 3 && q == 3 && g == 6;
        EXPECT_EQ(classes * (m - 1), (q - 1) * (repeats ? 7 : g));
        check_classes({q, g}, m, classes, repeats);
        ++tried[m];
      }
    }
  }
  EXPECT_EQ(tried, (std::map<std::uint64_t, std::size_t>{{2, 72}, {3, 39}, {4, 7}, {5, 6}}));
}

// Up to 120 elements: what is written, and what lines make of it. Those that cannot be are not
// there.
TEST(Groups, TriplesOfMoreThanThreeGroups) {
  std::size_t known = 0;
  std::size_t possible = 0;
  for (std::uint64_t q = 4; q <= 120; ++q) {
    for (std::uint64_t g = 1; q * g <= 120; ++g) {
      const bool can = q * g % 3 == 0 && g * (q - 1) % 2 == 0 && !(g == 2 && q == 6);
      const std::uint64_t classes = class_count({q, g}, 3);
      possible += can ? 1 : 0;
      if (classes > 0) {
        EXPECT_TRUE(can);
        EXPECT_EQ(2 * classes, g * (q - 1));
        check_classes({q, g}, 3, classes, false);
        ++known;
      } else {
        EXPECT_TRUE(group_class({q, g}, 3, 0).empty());
      }
    }
  }
  EXPECT_EQ(std::pair(known, possible), std::pair(std::size_t{75}, std::size_t{119}));
  for (const std::uint64_t huge : {UINT64_MAX, UINT64_MAX / 3, std::uint64_t{1} << 40}) {
    EXPECT_EQ(class_count({4, huge}, 3), 0U);
    EXPECT_EQ(class_count({huge, 6}, 3), 0U);
    EXPECT_TRUE(group_class({huge, 6}, 3, 0).empty());
  }
}

// Designs of the catalog, not all alike.
std::vector<Offer> some_designs() {
  std::vector<Offer> designs;
  for (std::uint64_t m = 2; m <= 3; ++m) {
    for (std::uint64_t k = m + 2; k <= m + 4; ++k) {
      for (std::uint64_t v = k + 2; v <= 34; v += 3) {
        for (const Kind kind : {Kind::linear, Kind::circular}) {
          if (auto offer = best_known(Registry::standard(), {v, k, m, kind, 2})) {
            designs.push_back(*std::move(offer));
          }
        }
      }
    }
  }
  return designs;
}

TEST(Hinges, StayAtTheirPositionAndPartsAreDisjoint) {
  std::size_t with_parts = 0;
  for (const Offer& offer : some_designs()) {
    Design design = standard().build_design(offer.recipe);
    const std::size_t n = design.k() - design.parameters().change;
    const bool linear = design.parameters().kind == Kind::linear;
    SCOPED_TRACE(name(design.parameters()));
    for (const Hinge& hinge : hinges(design)) {
      std::vector<Block> blocks = design.blocks();
      if (hinge.reversed) {
        EXPECT_TRUE(linear);
        std::reverse(blocks.begin(), blocks.end());
      }
      const auto stays = [&](std::uint64_t position) {
        return set_of(intersection(blocks.at(position - 1), blocks[position % blocks.size()]));
      };
      const std::set<Element> elements = set_of(hinge.elements);
      EXPECT_EQ(elements.size(), n);
      if (linear && hinge.at == blocks.size()) {
        EXPECT_TRUE(holds_all(blocks.back(), hinge.elements));
      } else {
        EXPECT_EQ(stays(hinge.at), elements);
      }
      std::set<Element> taken = elements;
      for (const Element position : hinge.positions) {
        EXPECT_TRUE(!linear || position < blocks.size());
        EXPECT_EQ(stays(position).size(), n);
        for (const Element x : stays(position)) {
          EXPECT_TRUE(taken.insert(x).second);
        }
      }
      with_parts += hinge.positions.empty() ? 0U : 1U;
    }
  }
  EXPECT_GT(with_parts, 100U);
}

// The windows of a cyclic design fill the circle, but for what is left over; a greedy search alone
// leaves more.
TEST(Hinges, HaveAsManyPartsAsThereCanBe) {
  for (const auto& [v, k] :
       {std::pair{31U, 4U}, {61U, 4U}, {91U, 4U}, {43U, 5U}, {71U, 5U}, {37U, 6U}, {55U, 6U}}) {
    const Parameters p{.v = v, .k = k, .kind = Kind::circular};
    const std::optional<Offer> offer = standard().best(p);
    ASSERT_TRUE(offer);
    std::size_t most = 0;
    for (const Hinge& hinge : hinges(standard().build_design(offer->recipe))) {
      most = std::max(most, hinge.positions.size() + 1);
    }
    EXPECT_EQ(most, v / (k - 2)) << name(p);
  }
}

TEST(OpenedPiece, MeetsItsHoleAtTheEndsOnly) {
  std::size_t found = 0;
  for (const Offer& offer : some_designs()) {
    const Design design = standard().build_design(offer.recipe);
    const Parameters& p = design.parameters();
    for (std::uint64_t h = p.k - p.change; h < p.v; ++h) {
      for (std::uint64_t dropped = 0; dropped <= most_dropped(h, p); ++dropped) {
        const auto piece = opened(design, h, dropped);
        if (!piece) {
          continue;
        }
        ++found;
        SCOPED_TRACE(fmt::format("{} hole {} dropped {}", name(p), h, dropped));
        const std::set<Element> hole = set_of(piece->hole);
        ASSERT_EQ(hole.size(), h);
        ASSERT_EQ(piece->count + dropped, design.block_count());
        std::set<std::pair<Element, Element>> met;
        for (std::size_t i = 0; i < piece->count; ++i) {
          const auto block = design.block((piece->start + i) % design.block_count());
          for (const Element x : block) {
            for (const Element y : block) {
              met.emplace(x, y);
            }
          }
          const std::set<Element> inside = set_of(intersection(block, piece->hole));
          if (i == 0) {
            EXPECT_EQ(inside, set_of(piece->first));
          }
          if (i + 1 == piece->count && p.kind == Kind::circular) {
            EXPECT_EQ(inside, set_of(piece->last));
          }
        }
        for (Element x = 0; x < p.v; ++x) {
          for (Element y = 0; y < x; ++y) {
            EXPECT_TRUE(met.contains({x, y}) || (hole.contains(x) && hole.contains(y)));
          }
        }
      }
    }
  }
  EXPECT_GT(found, 500U);
  EXPECT_EQ(most_dropped(5, {20, 6, 2}), 0U);
  EXPECT_EQ(most_dropped(6, {20, 6, 2}), 1U);
  EXPECT_EQ(most_dropped(7, {20, 6, 2}), 1U);
  EXPECT_EQ(most_dropped(8, {20, 6, 2}), 2U);
}

// Everything that fits on these designs: valid, with as many blocks as counted beforehand, and with
// the waste that Theorem 15 says. Then spoilt.
TEST(ConcatenateGroups, AddsUpWaste) {
  std::size_t made = 0;
  std::size_t open_ends = 0;
  std::size_t shorter = 0;
  for (const Offer& offer : some_designs()) {
    const Design base = standard().build_design(offer.recipe);
    const Parameters& w = base.parameters();
    const std::uint64_t n = w.k - w.change;
    for (const Hinge& hinge : hinges(base)) {
      for (std::uint64_t q = 2; q <= 5; ++q) {
        for (std::uint64_t g = 1; g <= 6; ++g) {
          const std::uint64_t classes = class_count({q, g}, w.change);
          if (classes == 0 || classes > hinge.positions.size()) {
            continue;
          }
          const std::uint64_t parts = std::min<std::uint64_t>(hinge.positions.size(), classes + 1);
          const std::uint64_t h = w.v - n * parts;
          Parameters p = w;
          p.v += q * g;
          const auto best = [&](Kind kind) -> std::optional<Offer> {
            const Parameters of{g + h, w.k, w.change, kind, 2};
            return of.v > of.k ? best_known(Registry::standard(), of) : std::nullopt;
          };
          const bool at_end = w.kind == Kind::linear && hinge.at == base.block_count();
          for (const bool open : {false, true}) {
            for (const std::uint64_t dropped :
                 {std::uint64_t{0}, q - q % 2 - (open ? 2 - q % 2 : 0)}) {
              if (open && !at_end) {
                continue;
              }
              const auto ring = best(Kind::circular);
              const auto tail = open ? best(Kind::linear) : std::nullopt;
              Grouping how{{q, g}, hinge, dropped};
              how.hinge.positions.resize(parts);
              const auto blocks =
                  piece_blocks(p, how, h, ring ? std::optional(ring->b) : std::nullopt,
                               tail ? std::optional(tail->b) : std::nullopt, open);
              const std::uint64_t less = most_dropped(h, w);
              const auto fits = [&](const std::optional<Offer>& piece, std::uint64_t without) {
                return !piece || opened(standard().build_design(piece->recipe), h, without);
              };
              if (!blocks || (ring && !(fits(ring, 0) && (dropped == 0 || fits(ring, less)))) ||
                  (open && (!tail || !fits(tail, less)))) {
                continue;
              }
              const auto recipe_of = [](const std::optional<Offer>& piece) {
                return piece ? std::optional(piece->recipe) : std::nullopt;
              };
              const Recipe recipe =
                  concatenate_groups_recipe(p, how, offer.recipe, recipe_of(ring), recipe_of(tail));
              SCOPED_TRACE(fmt::format("{} + {} groups of {}, hole {}, dropped {}{}", name(w), q, g,
                                       h, dropped, open ? ", open" : ""));
              const Design design = standard().build_design(recipe);
              ASSERT_EQ(design.block_count(), offer.b + parts * q * g / w.change + *blocks);
              ASSERT_TRUE(verify(design).valid());
              if (design.v() <= 20) {
                ASSERT_TRUE(naive_verdict(design).valid);
              }
              const auto a_block = static_cast<std::int64_t>(pairs(p.k) - pairs(n));
              const auto repeated = static_cast<std::int64_t>(
                  (parts - (q - 1) * g / (w.change - 1)) * q * g / w.change * pairs(w.change));
              EXPECT_EQ(waste(p, design.block_count()),
                        waste(w, offer.b) + a_block * static_cast<std::int64_t>(*blocks) +
                            repeated - static_cast<std::int64_t>(q * (pairs(g + h) - pairs(h))));
              if (made++ % 40 == 0) {
                // A circular W with whole pieces serves for linear designs, too.
                expect_spoilt_recipes_refused(
                    recipe, {.arguments = {"at", "dropped", "reversed"},
                             .any_kind = w.kind == Kind::circular,
                             .any_input_kind = offer.recipe.construction == "held-factors"});
              }
              open_ends += open ? 1U : 0U;
              shorter += dropped > 0 ? 1U : 0U;
            }
          }
        }
      }
    }
  }
  EXPECT_GT(made, 200U);
  EXPECT_GT(open_ends, 50U);
  EXPECT_GT(shorter, 20U);
}

TEST(ConcatenateGroups, MakesMinimumDesigns) {
  for (const std::uint64_t v : {28U, 32U, 42U, 48U, 64U, 74U, 88U}) {
    const Parameters p{v, 4, 2, Kind::circular, 2};
    const auto best = best_known(Registry::standard(), p);
    ASSERT_TRUE(best);
    EXPECT_EQ(best->recipe.construction, "concatenate-groups");
    EXPECT_LT(waste(p, best->b), 5) << v;
    const std::string said = construction("concatenate-groups").explain(best->recipe);
    EXPECT_NE(said.find("disjoint unchanged subsets"), std::string::npos) << said;
  }
}

TEST(ConcatenateGroups, RefusesWhatDoesNotFit) {
  const auto best = best_known(Registry::standard(), {28, 4, 2, Kind::circular, 2});
  const Recipe& good = best->recipe;
  ASSERT_EQ(good.construction, "concatenate-groups");
  const auto expect = [&](const std::string& how, auto change) {
    Recipe bad = good;
    change(bad);
    expect_refused(bad, how);
  };
  expect("a part twice", [](Recipe& r) { r.blocks[0][1] = r.blocks[0][0]; });
  expect("a part too few", [](Recipe& r) { r.blocks[0].pop_back(); });
  expect("a part far away", [](Recipe& r) { r.blocks[0].back() = 1U << 20; });
  expect("another hinge", [](Recipe& r) { r.blocks[1][0] ^= 1U; });
  expect("a hinge nowhere", [](Recipe& r) { r.arguments["at"] = 0; });
  expect("a circular design reversed", [](Recipe& r) { r.arguments["reversed"] = 1; });
  expect("no groups", [](Recipe& r) { r.arguments["groups"] = 0; });
  expect("too many pieces without blocks", [](Recipe& r) { r.arguments["dropped"] = 99; });
  expect("single-change", [](Recipe& r) { r.parameters.change = 1; });
}

}  // namespace
}  // namespace changeover::groups_test
