// Unfix: take away an element that is in every block, the converse of fix. The steps change what they
// changed and the other pairs are where they were, so a design on (v+1, k+1) becomes one on (v, k).
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"

namespace changeover {
namespace {

class UnfixSource final : public BlockSource {
 public:
  UnfixSource(const Parameters& parameters, std::unique_ptr<BlockSource> source, Element fixed)
      : parameters_(parameters),
        source_(std::move(source)),
        fixed_(fixed),
        larger_(static_cast<std::size_t>(parameters.k) + 1) {}

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return source_->block_count();
  }
  bool next(std::span<Element> block) override {
    if (!source_->next(larger_)) {
      return false;
    }
    std::size_t at = 0;
    for (const Element x : larger_) {
      if (x != fixed_ && at < block.size()) {
        block[at++] = x > fixed_ ? x - 1 : x;
      }
    }
    if (at != block.size() || std::find(larger_.begin(), larger_.end(), fixed_) == larger_.end()) {
      throw BadInput(fmt::format("unfix: element {} is not in every block", fixed_));
    }
    return true;
  }
  bool rewind() override { return source_->rewind(); }

 private:
  Parameters parameters_;
  std::unique_ptr<BlockSource> source_;
  Element fixed_;
  Block larger_;
};

class Unfix final : public Construction {
 public:
  std::string_view name() const override { return "unfix"; }
  std::string_view summary() const override {
    return "take away an element that is in every block";
  }
  std::string_view preconditions() const override {
    return "a design on (v+1, k+1), m <= k, with a fixed element";
  }
  std::string_view guarantee() const override { return "as many blocks"; }
  Citation citation() const override { return {}; }

  // Whether an element is in every block is known only when they are there; see construct/planner.hpp.
  std::optional<Offer> offer(const Parameters&, const Registry&) const override {
    return std::nullopt;
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    const Element fixed = taken(recipe);
    return std::make_unique<UnfixSource>(recipe.parameters, registry.build(recipe.inputs.front()),
                                         fixed);
  }

  std::string explain(const Recipe& recipe) const override {
    return fmt::format(
        "Take element {} out of every block of the {}; larger elements move up by one.",
        taken(recipe), changeover::name(recipe.inputs.front().parameters));
  }

 private:
  Element taken(const Recipe& recipe) const {
    const auto given = recipe.arguments.find("element");
    Parameters larger = recipe.parameters;
    ++larger.v;
    ++larger.k;
    if (recipe.construction != name() || recipe.inputs.size() != 1 || !recipe.blocks.empty() ||
        recipe.arguments.size() != 1 || given == recipe.arguments.end() || given->second < 0 ||
        static_cast<std::uint64_t>(given->second) >= larger.v ||
        recipe.inputs.front().parameters != larger) {
      throw BadInput(fmt::format("unfix to {} takes one input, a {}, and the element to take away",
                                 changeover::name(recipe.parameters), changeover::name(larger)));
    }
    return static_cast<Element>(given->second);
  }
};

}  // namespace

std::optional<Recipe> unfix_recipe(const Recipe& input, const Design& design) {
  const Parameters& p = input.parameters;
  if (design.block_count() == 0 || p.k <= p.change || p.k <= p.strength) {
    return std::nullopt;
  }
  std::vector<std::size_t> blocks(static_cast<std::size_t>(p.v), 0);
  for (const Element x : design.elements()) {
    ++blocks[x];
  }
  const auto fixed = std::find(blocks.begin(), blocks.end(), design.block_count());
  if (fixed == blocks.end()) {
    return std::nullopt;
  }
  Parameters smaller = p;
  --smaller.v;
  --smaller.k;
  return Recipe{"unfix", smaller, {{"element", fixed - blocks.begin()}}, {input}, {}};
}

const Construction& unfix_construction() {
  static const Unfix construction;
  return construction;
}

}  // namespace changeover
