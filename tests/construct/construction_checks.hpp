// What the tests of constructions share: a promise held against the verifier and, on small designs,
// against the definition; recipes spoilt in every way.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/expansion.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/verify/difference.hpp"
#include "changeover/verify/verdict.hpp"
#include "naive_verdict.hpp"
#include "stays.hpp"

namespace changeover::test {

inline const Registry& standard() { return Registry::standard(); }

inline const Construction& construction(std::string_view name) {
  const Construction* found = standard().find(name);
  if (found == nullptr) {
    throw InternalError("the registry lacks " + std::string(name));
  }
  return *found;
}

inline std::optional<Offer> offer_of(std::string_view name, const Parameters& p) {
  return construction(name).offer(p, standard());
}

inline std::vector<Block> blocks_of(BlockSource& source) {
  std::vector<Block> blocks;
  for_each_block(source, [&](std::span<const Element> block) {
    blocks.emplace_back(block.begin(), block.end());
  });
  return blocks;
}

/// Expects these blocks of a stream that can be read again, however much of it was read.
inline void expect_blocks_however_often(BlockSource& source, const std::vector<Block>& expected) {
  Block block(static_cast<std::size_t>(source.parameters().k));
  for (std::size_t read = 0; read <= expected.size(); ++read) {
    ASSERT_TRUE(source.rewind());
    for (std::size_t i = 0; i < read; ++i) {
      ASSERT_TRUE(source.next(block));
      ASSERT_EQ(block, expected[i]);
    }
  }
  EXPECT_FALSE(source.next(block));
  ASSERT_TRUE(source.rewind());
  EXPECT_EQ(blocks_of(source), expected);
}

/// Expects that all pairs are covered, but not by a design, if another base block comes last.
inline void expect_link_block_is_last(const IntervalBaseBlocks& right) {
  const std::size_t c = static_cast<std::size_t>(right.base_block_count());
  const auto m = static_cast<std::ptrdiff_t>(right.parameters.change);
  for (std::size_t i = 0; i + 1 < c; ++i) {
    IntervalBaseBlocks wrong = right;
    const auto points = wrong.points.begin() + m * static_cast<std::ptrdiff_t>(i);
    std::swap_ranges(points, points + m, wrong.points.end() - m);
    const DifferenceVerdict verdict = verify_differences(wrong);
    EXPECT_EQ(verdict.uncovered, 0U);
    EXPECT_EQ(verdict.bad_steps, 1U);
    EXPECT_EQ(verdict.first_bad_step, c);
    EXPECT_FALSE(verdict.valid() || verdict.tight);
    IntervalDevelopedSource source(wrong);
    const Verdict full = verify(source);
    EXPECT_EQ(full.uncovered, 0U);
    EXPECT_EQ(full.bad_steps, wrong.parameters.v);
    EXPECT_FALSE(full.valid());
  }
}

inline std::string one_line_fault(const Recipe& recipe) {
  try {
    (void)standard().build(recipe);
  } catch (const BadInput& fault) {
    const std::string line = fault.what();
    return line.find('\n') == std::string::npos && !line.empty() ? "" : "not one line: " + line;
  }
  return "not refused";
}

/// Expects that building refuses the recipe with BadInput and a message of one line.
inline void expect_refused(const Recipe& recipe, const std::string& how) {
  EXPECT_EQ(one_line_fault(recipe), "")
      << recipe.construction << " " << name(recipe.parameters) << ": " << how;
}

/// What may be changed in a recipe so that it is another one that is right.
struct Freedom {
  std::set<std::string> arguments{};  ///< of free choice
  bool any_v = false;
  bool any_kind = false;
  bool any_input_kind = false;  ///< the input's construction has the same recipe for both
};

/// Spoils the recipe in one place at a time.
inline void expect_spoilt_recipes_refused(const Recipe& recipe, const Freedom& freedom = {}) {
  const auto spoil = [&](const std::string& how, const auto& change) {
    Recipe spoilt = recipe;
    change(spoilt);
    expect_refused(spoilt, how);
  };
  if (!freedom.any_v) {
    spoil("v + 1", [](Recipe& r) { ++r.parameters.v; });
    spoil("v - 1", [](Recipe& r) { --r.parameters.v; });
  }
  spoil("k + 1", [](Recipe& r) { ++r.parameters.k; });
  spoil("k - 1", [](Recipe& r) { --r.parameters.k; });
  spoil("v, k huge", [](Recipe& r) { r.parameters.v = r.parameters.k = ~std::uint64_t{0}; });
  spoil("v = k = 0", [](Recipe& r) { r.parameters.v = r.parameters.k = 0; });
  spoil("m + 1", [](Recipe& r) { ++r.parameters.change; });
  spoil("m = 0", [](Recipe& r) { r.parameters.change = 0; });
  spoil("t = 3", [](Recipe& r) { r.parameters.strength = 3; });
  if (!freedom.any_kind) {
    spoil("other kind", [](Recipe& r) {
      r.parameters.kind = r.parameters.kind == Kind::linear ? Kind::circular : Kind::linear;
    });
  }
  spoil("unknown argument", [](Recipe& r) { r.arguments["nonsense"] = 1; });
  spoil("one more input",
        [](Recipe& r) { r.inputs.push_back(r.inputs.empty() ? r : r.inputs[0]); });
  spoil("another block", [](Recipe& r) { r.blocks.push_back({0, 1}); });
  spoil("no construction", [](Recipe& r) { r.construction = ""; });
  for (const auto& [argument, value] : recipe.arguments) {
    spoil("no " + argument, [&key = argument](Recipe& r) { r.arguments.erase(key); });
    spoil(argument + " < 0", [&key = argument](Recipe& r) { r.arguments[key] = -1; });
    if (!freedom.arguments.contains(argument)) {
      spoil(argument + " + 1", [&key = argument](Recipe& r) { ++r.arguments[key]; });
      spoil(argument + " - 1", [&key = argument](Recipe& r) { --r.arguments[key]; });
    }
  }
  if (!recipe.inputs.empty()) {
    spoil("no input", [](Recipe& r) { r.inputs.clear(); });
    spoil("unknown input", [](Recipe& r) { r.inputs[0].construction = "nonsense"; });
    spoil("input of other v", [](Recipe& r) { ++r.inputs[0].parameters.v; });
    if (!freedom.any_input_kind) {
      spoil("input of other kind", [](Recipe& r) {
        Kind& kind = r.inputs[0].parameters.kind;
        kind = kind == Kind::linear ? Kind::circular : Kind::linear;
      });
    }
  }
}

/// Builds the offer and holds everything that it promises against the verifier.
inline void expect_as_promised(const Offer& offer) {
  const Recipe& recipe = offer.recipe;
  const Parameters& p = recipe.parameters;
  SCOPED_TRACE(recipe.construction + " " + name(p));
  const Construction& maker = standard().construction_of(recipe);

  const std::unique_ptr<BlockSource> source = standard().build(recipe);
  ASSERT_EQ(source->parameters(), p);
  ASSERT_EQ(source->block_count(), offer.b);
  const Verdict verdict = verify(*source);
  EXPECT_TRUE(verdict.valid());
  EXPECT_EQ(verdict.bad_steps, 0U);
  EXPECT_EQ(verdict.b, offer.b);
  EXPECT_TRUE(verdict.tight() || !offer.tight);
  EXPECT_TRUE(verdict.economical() || !offer.economical);

  Block block(static_cast<std::size_t>(p.k));
  EXPECT_FALSE(source->next(block));
  ASSERT_TRUE(source->rewind());
  const Design design = standard().build_design(recipe);
  EXPECT_EQ(blocks_of(*source), design.blocks());
  EXPECT_EQ(design.recipe, recipe);
  if (p.v > p.k) {
    EXPECT_EQ(broken_inequality_of_stays(p.v, p.k, p.strength, design.blocks()), std::nullopt);
  }
  if (p.v <= 12 && offer.b <= 40) {
    const NaiveVerdict naive = naive_verdict(design);
    EXPECT_TRUE(naive.valid);
    EXPECT_TRUE((naive.excess == 0 && naive.never_newly_covered == 0) || !offer.tight);
  }

  const auto set = maker.expansion_set(recipe, standard());
  ASSERT_TRUE(set.has_value() || !offer.expansion_set);  // The catalog promises none.
  if (set) {
    EXPECT_EQ(expansion_set_defect(design, *set), std::nullopt);
  }
  if (const auto base = maker.base_blocks(recipe)) {
    DevelopedSource developed(*base);
    EXPECT_EQ(blocks_of(developed), design.blocks());
    const DifferenceVerdict differences = verify_differences(*base);
    EXPECT_TRUE(differences.valid());
    EXPECT_TRUE(differences.tight || !offer.tight);
  }
  if (const auto base = maker.orbit_base_blocks(recipe)) {
    DevelopedSource developed(base->base, base->automorphism);
    EXPECT_EQ(blocks_of(developed), design.blocks());
    EXPECT_TRUE(verify_differences(base->base, base->automorphism).tight || !offer.tight);
  }
  EXPECT_FALSE(maker.explain(recipe).empty());
}

inline Parameters circular_single_change(std::uint64_t v, std::uint64_t k) {
  return {v, k, 1, Kind::circular, 2};
}

/// A family of circular single-change designs with 3v − 4k + more blocks: over all k from 2 to
/// most_k and v to 4k it serves what it should, within more − 1 of the bound.
template <typename Serves>
void expect_circular_family(const std::string& name, std::uint64_t most_k, std::uint64_t more,
                            Serves serves) {
  for (std::uint64_t k = 2; k <= most_k; ++k) {
    for (std::uint64_t v = k + 1; v <= 4 * k; ++v) {
      const auto offer = offer_of(name, circular_single_change(v, k));
      ASSERT_EQ(offer.has_value(), serves(v, k)) << v << ' ' << k;
      if (offer) {
        const std::uint64_t bound = lower_bound(circular_single_change(v, k)).blocks;
        EXPECT_EQ(offer->b, 3 * v - 4 * k + more);
        EXPECT_GE(offer->b, bound);
        EXPECT_LE(offer->b, bound + more - 1);
        if (k <= 14) {
          expect_as_promised(*offer);
        } else {
          EXPECT_TRUE(verify(*standard().build(offer->recipe)).valid()) << v << ' ' << k;
        }
      }
    }
  }
}

inline void expect_valid_circular(const std::string& name, const std::vector<std::uint64_t>& all_v,
                                  std::uint64_t k) {
  for (const std::uint64_t v : all_v) {
    const auto offer = offer_of(name, circular_single_change(v, k));
    ASSERT_TRUE(offer);
    EXPECT_TRUE(verify(*standard().build(offer->recipe)).valid()) << v;
  }
}

/// As expect_as_promised(), and that the design is not better than promised.
inline void expect_exactly_as_promised(const Offer& offer) {
  expect_as_promised(offer);
  const Verdict verdict = verify(*standard().build(offer.recipe));
  EXPECT_EQ(verdict.tight(), offer.tight);
  EXPECT_EQ(verdict.economical(), offer.economical);
}

}  // namespace changeover::test
