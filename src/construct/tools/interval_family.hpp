// What the cyclic families over Z_v have in common: base blocks of an interval A = {0, …, k−m−1} and m
// points each, with unchanged subsets A + j.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "changeover/construct/cyclic.hpp"
#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"

namespace changeover {

/// A tight circular m-change family of cv blocks; subclasses say which, and name the points.
class IntervalFamily : public Construction {
 public:
  std::optional<Offer> offer(const Parameters& p, const Registry&) const override {
    std::optional<Recipe> recipe = recipe_for(p);
    if (!recipe) {
      return std::nullopt;
    }
    return Offer{*std::move(recipe), base_block_count(p) * p.v, true, true,
                 has_interval_expansion_set(p.v, p.k - change_)};
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe, const Registry&) const override {
    const std::uint64_t c = required_count(recipe);
    const std::uint64_t k = recipe.parameters.k;
    return std::make_unique<IntervalDevelopedSource>(recipe.parameters, 0, k - change_, c,
                                                     points_of(c, k));
  }

  // At position p = jc+i, 1 ≤ i < c, two blocks of a round meet in A+j; at p = jc, where B_{c−1}+(j−1)
  // holds A+j as well, too. Hence U_p = A + ⌊p/c⌋.
  std::optional<std::vector<UnchangedSubset>> expansion_set(const Recipe& recipe,
                                                            const Registry&) const override {
    const std::uint64_t c = required_count(recipe);
    const std::uint64_t n = recipe.parameters.k - change_;
    if (!has_interval_expansion_set(recipe.parameters.v, n)) {
      return std::nullopt;
    }
    return interval_expansion_set(c, recipe.parameters.v, n);
  }

  std::optional<BaseBlocks> base_blocks(const Recipe& recipe) const override {
    if (required_count(recipe) > max_written_out_elements / recipe.parameters.k) {
      return std::nullopt;
    }
    return interval_base_blocks(recipe)->written_out();
  }

  std::optional<IntervalBaseBlocks> interval_base_blocks(const Recipe& recipe) const override {
    const std::uint64_t c = required_count(recipe);
    if (c > max_listed_points / change_) {
      return std::nullopt;
    }
    return interval_blocks(c, recipe.parameters.k);
  }

  std::string explain(const Recipe& recipe) const override {
    const std::uint64_t c = required_count(recipe);
    const std::uint64_t k = recipe.parameters.k;
    return explain_development(recipe.parameters, k - change_, c, points_of(c, k));
  }

 protected:
  explicit IntervalFamily(std::uint64_t change) : change_(change) {}

  /// c; 0 if p is not in the family.
  [[nodiscard]] virtual std::uint64_t base_block_count(const Parameters& p) const = 0;
  /// The m points of each base block, which outlives this object.
  [[nodiscard]] virtual IntervalDevelopedSource::Points points_of(std::uint64_t c,
                                                                  std::uint64_t k) const = 0;
  [[nodiscard]] virtual IntervalBaseBlocks interval_blocks(std::uint64_t c,
                                                           std::uint64_t k) const = 0;

 private:
  [[nodiscard]] std::optional<Recipe> recipe_for(const Parameters& p) const {
    const std::uint64_t c = base_block_count(p);
    if (c == 0) {
      return std::nullopt;
    }
    return Recipe{std::string(name()), p, {{"c", static_cast<std::int64_t>(c)}}, {}, {}};
  }

  // c, of a recipe of this construction.
  [[nodiscard]] std::uint64_t required_count(const Recipe& recipe) const {
    require_recipe(recipe, *this, recipe_for(recipe.parameters));
    return base_block_count(recipe.parameters);
  }

  std::uint64_t change_;
};

}  // namespace changeover
