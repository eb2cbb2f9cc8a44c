// Linear single-change designs one after the other, and rings of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "bounds/counting_bound.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/construct/closure.hpp"
#include "construct/tools/concatenation/pieces.hpp"
#include "construct/tools/short_blocks.hpp"
#include "construction_checks.hpp"
#include "core/sorted.hpp"
#include "message_of.hpp"

namespace changeover::concatenate_test {
namespace {

using namespace test;

Parameters single(std::uint64_t v, std::uint64_t k, Kind kind = Kind::linear) {
  return {v, k, 1, kind, 2};
}

// Four times the blocks over the counting bound, before rounding, for k = 5; one for each pair
// too many.
std::uint64_t waste(const Parameters& p, std::uint64_t b) {
  const std::uint64_t pairs = p.v * (p.v - 1) / 2;
  return p.kind == Kind::linear ? 4 * (b - 1) + 10 - pairs : 4 * b - pairs;
}

// The recipes of concatenate and ring in a tree.
void collect(const Recipe& recipe, const std::string& name, std::vector<Recipe>& found) {
  if (recipe.construction == name) {
    found.push_back(recipe);
  }
  for (const Recipe& input : recipe.inputs) {
    collect(input, name, found);
  }
}

std::uint64_t blocks_in(const Recipe& recipe) {
  return standard().build(recipe)->block_count().value();
}

TEST(Concatenate, IsAsPromisedForBlocksOfFive) {
  std::size_t built = 0;
  for (std::uint64_t v = 5; v <= 120; ++v) {
    const auto offer = offer_of("concatenate", single(v, 5));
    EXPECT_EQ(offer.has_value(), v >= 17) << v;
    if (offer) {
      expect_as_promised(*offer);
      ++built;
    }
    EXPECT_FALSE(offer_of("concatenate", single(v, 6)));
    EXPECT_FALSE(offer_of("concatenate", single(v, 5, Kind::circular)));
  }
  EXPECT_EQ(built, 104U);
}

TEST(Concatenate, AddsUpWaste) {
  for (std::uint64_t v = 33; v <= 90; ++v) {
    std::vector<Recipe> made;
    collect(offer_of("concatenate", single(v, 5))->recipe, "concatenate", made);
    ASSERT_FALSE(made.empty());
    for (const Recipe& recipe : made) {
      const Recipe& first = recipe.inputs[0];
      const Recipe& second = recipe.inputs[1];
      const auto times = static_cast<std::uint64_t>(recipe.arguments.at("times"));
      EXPECT_EQ(waste(recipe.parameters, blocks_in(recipe)),
                waste(first.parameters, blocks_in(first)) +
                    times * waste(second.parameters, blocks_in(second)));
    }
  }
}

// Theorem 14 of docs/theorems.md: every linear one, and circular ones but for a block.
TEST(Concatenate, SettlesEveryClassModuloSixteen) {
  for (std::uint64_t v = 5; v <= 300; ++v) {
    const Parameters p = single(v, 5);
    const auto best = standard().best(p);
    ASSERT_TRUE(best);
    EXPECT_EQ(best->b, v <= 10 ? 2 * v - 9 : v <= 15 ? 3 * v - 19 : counting_bound(p)) << v;
  }
}

// Theorem 14; the path of 16 new elements has half a block more than a perfect one.
TEST(Ring, AttainsTheCountingBoundForBlocksOfFive) {
  std::size_t built = 0;
  for (std::uint64_t v = 15; v <= 300; ++v) {
    const Parameters p = single(v, 5, Kind::circular);
    const auto best = standard().best(p);
    ASSERT_TRUE(best);
    if (v >= 28) {  // Some smaller ones are in the catalog only.
      EXPECT_EQ(best->b, counting_bound(p)) << v;
    }
    const auto offer = offer_of("ring", p);
    ASSERT_TRUE(offer || v < 32) << v;
    if (v >= 32) {
      const bool attains = v % 8 == 2 || v % 8 == 4 || v % 8 == 5 || v % 8 == 7;
      EXPECT_EQ(offer->b, counting_bound(p) + (attains ? 0 : 1)) << v;
    }
    if (offer && v <= 100) {
      expect_as_promised(*offer);
      const Recipe& input = offer->recipe.inputs.front();
      EXPECT_EQ(waste(p, offer->b), waste(input.parameters, blocks_in(input)) + 2);
      ++built;
    }
  }
  EXPECT_GE(built, 65U);
  EXPECT_FALSE(offer_of("ring", single(50, 5)));
  EXPECT_FALSE(offer_of("ring", single(50, 4, Kind::circular)));
}

// Any two designs that fit: each of the tight ones for k = 3, 4 with a partition that leaves out
// k−1 elements of an end, after any design.
TEST(Concatenate, TakesAnyTwoDesignsThatFit) {
  std::size_t built = 0;
  std::size_t reversed = 0;
  for (const auto& [k, w] :
       {std::pair<std::uint64_t, std::uint64_t>{3, 6}, {3, 10}, {4, 12}, {4, 18}}) {
    const auto second = standard().best(single(w, k));
    ASSERT_TRUE(second);
    const Design design = standard().build_design(second->recipe);
    const ExpansionSearch search = find_expansion_sets(design, {.how_many = 200});
    for (const ExpansionSet& set : search.sets) {
      const bool at_first = set.front().position == 0;
      const bool at_last = set.back().position == design.block_count();
      if (at_first == at_last) {
        continue;
      }
      std::vector<Element> positions;
      for (const UnchangedSubset& part : set) {
        if (part.position > 0 && part.position < design.block_count()) {
          positions.push_back(static_cast<Element>(part.position));
        }
      }
      for (std::uint64_t v = k; v <= 3 * k; ++v) {
        const auto first = standard().best(single(v, k));
        const Recipe recipe =
            concatenate_recipe(first->recipe, second->recipe, positions, 1 + v % 3);
        EXPECT_EQ(recipe.parameters.v, v + (1 + v % 3) * (w - k + 1));
        const Design made = standard().build_design(recipe);
        EXPECT_TRUE(verify(made).valid());
        EXPECT_EQ(made.block_count(), blocks_in(recipe));
        if (made.v() <= 16) {
          EXPECT_TRUE(naive_verdict(made).valid);
        }
        ++built;
        reversed += at_last ? 1U : 0U;
      }
    }
  }
  EXPECT_GE(built, 50U);
  EXPECT_GE(reversed, 10U);
}

TEST(Concatenate, StreamsAMillionElementsAtOnce) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    const Parameters p = single(1'000'000, 5, kind);
    const auto offer = offer_of(kind == Kind::linear ? "concatenate" : "ring", p);
    ASSERT_TRUE(offer);
    EXPECT_LE(offer->b, counting_bound(p) + 1);
    const auto source = standard().build(offer->recipe);
    EXPECT_EQ(source->block_count(), offer->b);
    Block before(5);
    Block block(5);
    ASSERT_TRUE(source->next(before));
    for (int i = 0; i < 100'000; ++i) {
      ASSERT_TRUE(source->next(block));
      ASSERT_EQ(difference(block, before).size(), 1U);
      before = block;
    }
  }
}

TEST(Concatenate, CanBeReadAgainFromAnywhere) {
  for (const char* name : {"concatenate", "ring"}) {
    const auto offer =
        offer_of(name, single(37, 5, name[0] == 'r' ? Kind::circular : Kind::linear));
    ASSERT_TRUE(offer);
    const auto source = standard().build(offer->recipe);
    expect_blocks_however_often(*source, blocks_of(*standard().build(offer->recipe)));
    Block block(5);
    while (source->next(block)) {
    }
    EXPECT_FALSE(source->next(block));
    EXPECT_FALSE(source->next(block));
  }
}

TEST(Concatenate, RefusesSpoiltRecipes) {
  const auto chain = offer_of("concatenate", single(60, 5));
  const auto ring = offer_of("ring", single(60, 5, Kind::circular));
  ASSERT_TRUE(chain && ring);
  expect_spoilt_recipes_refused(chain->recipe);
  expect_spoilt_recipes_refused(ring->recipe);
  const auto spoil = [](Recipe recipe, const std::string& how, const auto& change) {
    change(recipe);
    expect_refused(recipe, how);
  };
  for (const Recipe& recipe : {chain->recipe, ring->recipe}) {
    spoil(recipe, "no positions", [](Recipe& r) { r.blocks.clear(); });
    spoil(recipe, "position 0", [](Recipe& r) { r.blocks[0][0] = 0; });
    spoil(recipe, "another position", [](Recipe& r) { r.blocks[0][0] = 1; });
    spoil(recipe, "falling positions",
          [](Recipe& r) { std::swap(r.blocks[0][0], r.blocks[0][1]); });
    spoil(recipe, "position beyond", [](Recipe& r) { r.blocks[0].back() = 1000; });
    spoil(recipe, "a position less", [](Recipe& r) { r.blocks[0].pop_back(); });
  }
  spoil(ring->recipe, "no path", [](Recipe& r) { r.blocks.resize(1); });
  spoil(ring->recipe, "a short block", [](Recipe& r) { r.blocks[3].pop_back(); });
  spoil(ring->recipe, "a large element", [](Recipe& r) { r.blocks[3][0] = ~Element{0}; });
  spoil(ring->recipe, "an element twice", [](Recipe& r) { r.blocks[3][0] = r.blocks[3][1]; });
  spoil(ring->recipe, "a gap", [](Recipe& r) {
    for (std::size_t i = 1; i < r.blocks.size(); ++i) {
      std::ranges::replace(r.blocks[i], Element{0}, Element{40});
    }
  });
  spoil(ring->recipe, "a block less", [](Recipe& r) { r.blocks.erase(r.blocks.begin() + 3); });
}

// The ends of a design that begins as it ends are no anchors of a ring.
TEST(Ring, RefusesADesignWhoseEndsMeet) {
  Recipe recipe = offer_of("ring", single(32, 5, Kind::circular))->recipe;
  Recipe& input = recipe.inputs.front();
  Design design = standard().build_design(input);
  std::vector<Block> blocks = design.blocks();
  blocks.push_back(blocks.front());
  input = literal_recipe(Design(design.parameters(), blocks));
  const auto source = standard().build(recipe);
  EXPECT_REFUSAL((void)read_all(*source), BadInput, "have too many elements in common for a ring");
}

// The waste is that of the list with open ends alone, since the copied design is tight.
TEST(RingOfCopies, IsAsPromisedForBlocksOfFive) {
  std::size_t built = 0;
  for (std::uint64_t v = 14; v <= 120; ++v) {
    const Parameters p = single(v, 5, Kind::circular);
    const auto offer = offer_of("ring-of-copies", p);
    const bool reached = std::ranges::any_of(open_lists(), [v](const WrittenPiece& list) {
      return v >= list.w + 12 && (v - list.w - 12) % 16 == 0;
    });
    ASSERT_EQ(offer.has_value(), reached) << v;
    if (offer) {
      expect_as_promised(*offer);
      EXPECT_EQ(offer->b, counting_bound(p)) << v;
      ++built;
    }
    EXPECT_FALSE(offer_of("ring-of-copies", single(v, 5)));
    EXPECT_FALSE(offer_of("ring-of-copies", single(v, 4, Kind::circular)));
  }
  EXPECT_GE(built, 6U);
}

// A linear design with its first block's k−1 smallest elements first and k−1 of its last block's
// last; nullopt if its ends have elements in common.
std::optional<std::vector<Block>> with_ends_in_place(const Design& design) {
  const std::uint64_t n = design.k() - 1;
  Block order = sorted(design.blocks().front());
  order.resize(n);
  const Block end = sorted(difference(sorted(design.blocks().back()), order));
  if (end.size() < n) {
    return std::nullopt;
  }
  const Block last(end.end() - static_cast<std::ptrdiff_t>(n), end.end());
  for (Element x = 0; x < design.v(); ++x) {
    if (std::ranges::find(order, x) == order.end() && std::ranges::find(last, x) == last.end()) {
      order.push_back(x);
    }
  }
  order.insert(order.end(), last.begin(), last.end());
  Block name(design.v());
  for (Element i = 0; i < design.v(); ++i) {
    name[order[i]] = i;
  }
  std::vector<Block> blocks = design.blocks();
  for (Block& block : blocks) {
    std::ranges::transform(block, block.begin(), [&](Element x) { return name[x]; });
    std::ranges::sort(block);
  }
  return blocks;
}

// Any list and any design that fit: that of the list need not be missing pairs.
TEST(RingOfCopies, TakesAnyThatFit) {
  std::size_t built = 0;
  for (const auto& [k, w] :
       {std::pair<std::uint64_t, std::uint64_t>{3, 6}, {3, 8}, {3, 10}, {4, 12}, {4, 15}}) {
    const auto second = standard().best(single(w, k));
    ASSERT_TRUE(second);
    const Design design = standard().build_design(second->recipe);
    for (const ExpansionSet& set : find_expansion_sets(design, {.how_many = 200}).sets) {
      const Block begin = sorted(design.blocks().front());
      if (set.front().position != 0 || set.back().position != design.block_count() ||
          !intersection(begin, set.back().elements).empty()) {
        continue;
      }
      std::vector<Block> list{{}};
      for (const UnchangedSubset& part : set) {
        if (part.position > 0 && part.position < design.block_count()) {
          list.front().push_back(static_cast<Element>(part.position));
        }
      }
      for (std::uint64_t v = 2 * k; v <= 3 * k + 1; ++v) {
        const auto blocks =
            with_ends_in_place(standard().build_design(standard().best(single(v, k))->recipe));
        if (!blocks || list.front().empty() || blocks->front().back() + k > v ||
            blocks->back().front() + 1 < k) {
          continue;
        }
        for (std::uint64_t times = 1; times <= 5; ++times) {
          Recipe recipe{"ring-of-copies",
                        single(v + w - 2 * (k - 1) + (times - 1) * (w - k + 1), k, Kind::circular),
                        {{"times", static_cast<std::int64_t>(times)}},
                        {second->recipe},
                        list};
          recipe.blocks.insert(recipe.blocks.end(), blocks->begin(), blocks->end());
          const Design made = standard().build_design(recipe);
          EXPECT_TRUE(verify(made).valid()) << name(made.parameters());
          EXPECT_EQ(made.block_count(), blocks_in(recipe));
          if (made.v() <= 20) {
            EXPECT_TRUE(naive_verdict(made).valid);
          }
          ++built;
        }
      }
    }
  }
  EXPECT_GE(built, 30U);
}

TEST(RingOfCopies, RefusesSpoiltRecipes) {
  const auto offer = offer_of("ring-of-copies", single(51, 5, Kind::circular));
  ASSERT_TRUE(offer);
  expect_spoilt_recipes_refused(offer->recipe);
  const auto spoil = [&](const std::string& how, const auto& change) {
    Recipe recipe = offer->recipe;
    change(recipe);
    expect_refused(recipe, how);
  };
  spoil("no list", [](Recipe& r) { r.blocks.resize(1); });
  spoil("no times", [](Recipe& r) { r.arguments.clear(); });
  spoil("other times", [](Recipe& r) { r.arguments["times"] += 1; });
  spoil("times 0", [](Recipe& r) { r.arguments["times"] = 0; });
  spoil("a position less", [](Recipe& r) { r.blocks[0].pop_back(); });
  spoil("another position", [](Recipe& r) { r.blocks[0][0] = 1; });
  spoil("a short first block", [](Recipe& r) { r.blocks[1].pop_back(); });
  spoil("a short block", [](Recipe& r) { r.blocks[5].pop_back(); });
  spoil("another first block", [](Recipe& r) { std::swap(r.blocks[1], r.blocks[5]); });
  spoil("ends that meet", [](Recipe& r) { r.blocks.back() = {0, 19, 20, 21, 22}; });
  spoil("another last block", [](Recipe& r) { std::swap(r.blocks.back(), r.blocks[5]); });
  spoil("a large element", [](Recipe& r) { r.blocks[5][0] = ~Element{0}; });
}

TEST(Pieces, AreWhatTheySay) {
  for (const auto* pieces : {&open_pieces(), &closing_pieces(), &copied_pieces()}) {
    for (const WrittenPiece& written : *pieces) {
      const bool open = pieces == &open_pieces();
      const Piece piece = open ? open_piece(short_blocks(written.blocks), written.positions)
                               : closing_piece(short_blocks(written.blocks), written.positions);
      EXPECT_EQ(piece.blocks.size(), written.b);
      EXPECT_EQ(piece.fresh.size(), written.fresh);
      EXPECT_EQ(piece.fresh.size() + piece.anchors(), written.w);
      EXPECT_EQ(piece.parts.size() * (written.k - 1), written.fresh);
    }
  }
}

// By definition: all pairs but those of the ends with each other, and one change at each step.
TEST(OpenLists, AreWhatTheySay) {
  for (const WrittenPiece& list : open_lists()) {
    const std::vector<Block> blocks = short_blocks(list.blocks);
    EXPECT_EQ(blocks.size(), list.b);
    std::set<std::pair<Element, Element>> together;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const Block block = sorted(blocks[i]);
      ASSERT_EQ(block.size(), list.k);
      if (i > 0) {
        EXPECT_EQ(difference(block, sorted(blocks[i - 1])).size(), 1U);
      }
      for (const Element x : block) {
        for (const Element y : block) {
          together.emplace(x, y);
        }
      }
    }
    for (Element x = 0; x < list.w; ++x) {
      for (Element y = x; y < list.w; ++y) {
        const bool of_ends = x + 1 < list.k && y + list.k > list.w;
        EXPECT_TRUE(together.contains({x, y}) || of_ends) << x << ' ' << y;
      }
    }
  }
}

}  // namespace
}  // namespace changeover::concatenate_test
