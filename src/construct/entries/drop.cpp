// Drop: leave out blocks that are not needed.
//
// A block may go if each of its pairs is in some other block and its neighbours differ in exactly m
// elements, or if it is the first or the last of a linear design. Blocks are tried from the ends inwards
// (linear) or in order (circular), again and again until none can go: deterministic, not always the most
// that could be dropped.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/entry.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/pair_set.hpp"
#include "changeover/core/transitions.hpp"

namespace changeover {
namespace {

/// Which blocks stay.
class Dropping {
 public:
  explicit Dropping(const Design& design)
      : design_(design),
        times_(static_cast<std::size_t>(binomial(design.v(), 2)), 0),
        next_(design.block_count()),
        previous_(design.block_count()) {
    const std::size_t b = design.block_count();
    for (std::size_t i = 0; i < b; ++i) {
      next_[i] = (i + 1) % b;
      previous_[i] = (i + b - 1) % b;
      for_each_pair(i, [&](std::uint32_t& times) { ++times; });
    }
    left_ = b;
  }

  std::vector<bool> run() {
    const std::size_t b = design_.block_count();
    const bool linear = design_.parameters().kind == Kind::linear;
    std::vector<bool> stays(b, true);
    std::size_t first = 0;
    std::size_t last = b - 1;
    for (bool more = true; more && left_ > 3;) {
      more = false;
      for (std::size_t i = 0; i < b && left_ > 3; ++i) {
        const bool end = linear && (i == first || i == last);
        if (!stays[i] || !redundant(i) ||
            !(end || differ(previous_[i], next_[i]) == design_.parameters().change)) {
          continue;
        }
        stays[i] = false;
        more = true;
        --left_;
        for_each_pair(i, [&](std::uint32_t& times) { --times; });
        next_[previous_[i]] = next_[i];
        previous_[next_[i]] = previous_[i];
        first = i == first ? next_[i] : first;
        last = i == last ? previous_[i] : last;
      }
    }
    return stays;
  }

 private:
  template <typename Visit>
  void for_each_pair(std::size_t i, Visit&& visit) {
    const auto block = design_.block(i);
    for (std::size_t a = 0; a < block.size(); ++a) {
      for (std::size_t c = 0; c < a; ++c) {
        visit(times_[static_cast<std::size_t>(PairSet::rank(block[a], block[c]))]);
      }
    }
  }

  bool redundant(std::size_t i) {
    bool all = true;
    for_each_pair(i, [&](const std::uint32_t& times) { all = all && times > 1; });
    return all;
  }

  std::uint64_t differ(std::size_t i, std::size_t j) const {
    return difference(design_.block(i), design_.block(j)).size();
  }

  const Design& design_;
  std::vector<std::uint32_t> times_;  // in how many blocks each pair is
  std::vector<std::size_t> next_;
  std::vector<std::size_t> previous_;
  std::size_t left_ = 0;
};

std::vector<Block> needed_blocks(const Design& design) {
  const std::vector<bool> stays = Dropping(design).run();
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < stays.size(); ++i) {
    if (stays[i]) {
      const auto block = design.block(i);
      blocks.emplace_back(block.begin(), block.end());
    }
  }
  return blocks;
}

class Drop final : public Construction {
 public:
  std::string_view name() const override { return "drop"; }
  std::string_view summary() const override { return "leave out blocks that are not needed"; }
  std::string_view preconditions() const override {
    return "a block whose pairs are elsewhere and whose neighbours differ in m elements";
  }
  std::string_view guarantee() const override { return "fewer blocks"; }
  Citation citation() const override { return {}; }

  // Which blocks can go is known only when they are there; see construct/planner.hpp.
  std::optional<Offer> offer(const Parameters&, const Registry&) const override {
    return std::nullopt;
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    if (recipe.construction != name() || recipe.inputs.size() != 1 || !recipe.blocks.empty() ||
        !recipe.arguments.empty() || recipe.inputs.front().parameters != recipe.parameters) {
      throw BadInput(fmt::format("drop takes one input, a {}, and no arguments",
                                 changeover::name(recipe.parameters)));
    }
    const Design design = read_all(*registry.build(recipe.inputs.front()));
    return std::make_unique<BlockListSource>(recipe.parameters, needed_blocks(design));
  }

  std::string explain(const Recipe& recipe) const override {
    return fmt::format("Leave out the blocks of the {} that are not needed.",
                       changeover::name(recipe.inputs.front().parameters));
  }

  std::vector<std::string> labels(const Recipe& recipe, const Registry& registry) const override {
    const Recipe& input = recipe.inputs.front();
    return registry.construction_of(input).labels(input, registry);
  }
};

}  // namespace

std::uint64_t needed_block_count(const Design& design) { return needed_blocks(design).size(); }

Recipe drop_recipe(const Recipe& input) { return {"drop", input.parameters, {}, {input}, {}}; }

const Construction& drop_construction() {
  static const Drop construction;
  return construction;
}

}  // namespace changeover
