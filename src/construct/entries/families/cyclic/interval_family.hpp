// What the cyclic families over Z_v have in common: base blocks of an interval A = {0, …, k−m−1}
// and m points each, with unchanged subsets A + j.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"
#include "construct/tools/cyclic.hpp"

namespace changeover {

/// A circular m-change family of cv blocks; subclasses say which, and name the points.
class IntervalFamily : public Family {
 public:
  // At position p = jc+i, 1 ≤ i < c, two blocks of a round meet in A+j; at p = jc, where
  // B_{c−1}+(j−1) holds A+j as well. So U_p = A + ⌊p/c⌋.
  std::optional<std::vector<UnchangedSubset>> expansion_set(const Recipe& recipe,
                                                            const Registry&) const override {
    const std::uint64_t c = base_block_count(required(recipe));
    const std::uint64_t n = recipe.parameters.k - change_;
    if (!has_interval_expansion_set(recipe.parameters.v, n)) {
      return std::nullopt;
    }
    return interval_expansion_set(c, recipe.parameters.v, n);
  }

  std::optional<BaseBlocks> base_blocks(const Recipe& recipe) const override {
    if (base_block_count(required(recipe)) > max_written_out_elements / recipe.parameters.k) {
      return std::nullopt;
    }
    return interval_base_blocks(recipe)->written_out();
  }

  std::optional<IntervalBaseBlocks> interval_base_blocks(const Recipe& recipe) const override {
    const Parameters& p = required(recipe);
    const std::uint64_t c = base_block_count(p);
    if (c > max_listed_points / change_) {
      return std::nullopt;
    }
    const auto m = static_cast<std::size_t>(change_);
    IntervalBaseBlocks base{p, 0, p.k - change_,
                            std::vector<Element>(static_cast<std::size_t>(c) * m)};
    const IntervalDevelopedSource::Points points = points_of(c, p);
    for (std::size_t i = 0; i < c; ++i) {
      points(i, std::span(base.points).subspan(i * m, m));
    }
    return base;
  }

 protected:
  IntervalFamily(const Description& description, std::uint64_t change, bool tight = true)
      : Family(description), change_(change), tight_(tight) {}

  /// c; 0 if p is not in the family.
  [[nodiscard]] virtual std::uint64_t base_block_count(const Parameters& p) const = 0;
  /// The m points of each base block, which outlives this object.
  [[nodiscard]] virtual IntervalDevelopedSource::Points points_of(std::uint64_t c,
                                                                  const Parameters& p) const = 0;

 private:
  std::optional<Promise> promise(const Parameters& p) const final {
    const std::uint64_t c = base_block_count(p);
    if (c == 0) {
      return std::nullopt;
    }
    return Promise{c * p.v, tight_, tight_, has_interval_expansion_set(p.v, p.k - change_)};
  }

  Recipe recipe_for(const Parameters& p) const final {
    return recipe_of(p, {{"c", static_cast<std::int64_t>(base_block_count(p))}});
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const final {
    const std::uint64_t c = base_block_count(p);
    return std::make_unique<IntervalDevelopedSource>(p, 0, p.k - change_, c, points_of(c, p));
  }

  std::string explanation(const Parameters& p) const final {
    const std::uint64_t c = base_block_count(p);
    return explain_development(p, p.k - change_, c, points_of(c, p));
  }

  std::uint64_t change_;
  bool tight_;
};

}  // namespace changeover
