// The same f new elements in every block: DCCD(v,k,b) → DCCD(v+f,k+f,b), for any m and both kinds.
//
// A closure rule on recipes: it makes no offers, lest offers recurse without end. Constructions
// that know which input to take compose it.
#include <fmt/format.h>

#include <utility>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/expansion.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/checked.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"

namespace changeover {
namespace {

class FixSource final : public BlockSource {
 public:
  FixSource(const Parameters& parameters, std::unique_ptr<BlockSource> source)
      : parameters_(parameters), source_(std::move(source)) {}

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return source_->block_count();
  }
  bool next(std::span<Element> block) override {
    const auto old = static_cast<std::size_t>(source_->parameters().k);
    auto element = static_cast<Element>(source_->parameters().v);
    for (Element& place : block.subspan(old)) {
      place = element++;
    }
    return source_->next(block.first(old));
  }
  bool rewind() override { return source_->rewind(); }

 private:
  Parameters parameters_;
  std::unique_ptr<BlockSource> source_;
};

class Fix final : public Construction {
 public:
  std::string_view name() const override { return "fix"; }
  std::string_view summary() const override { return "f new elements in every block of a design"; }
  std::string_view preconditions() const override {
    return "a design on (v-f,k-f) of the same kind and m, as input; f >= 1";
  }
  std::string_view guarantee() const override { return "as many blocks as the input"; }
  Citation citation() const override { return {}; }

  std::optional<Offer> offer(const Parameters&, const Registry&) const override {
    return std::nullopt;
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    (void)fixed(recipe);
    return std::make_unique<FixSource>(recipe.parameters, registry.build(recipe.inputs.front()));
  }

  std::string explain(const Recipe& recipe) const override {
    const std::uint64_t f = fixed(recipe);
    const Parameters& input = recipe.inputs.front().parameters;
    const std::uint64_t last = recipe.parameters.v - 1;
    const std::string added = f == 1   ? fmt::format("element {}", last)
                              : f == 2 ? fmt::format("elements {} and {}", last - 1, last)
                                       : fmt::format("elements {},…,{}", input.v, last);
    return fmt::format("Add the new {} to every block of the {}.", added, changeover::name(input));
  }

  std::vector<std::string> labels(const Recipe& recipe, const Registry& registry) const override {
    const std::uint64_t f = fixed(recipe);
    const Recipe& input = recipe.inputs.front();
    return expanded_labels(registry.construction_of(input).labels(input, registry), f);
  }

 private:
  // The number f of new elements, when the recipe fits; the input may be any of the right
  // parameters.
  std::uint64_t fixed(const Recipe& recipe) const {
    const Parameters& p = recipe.parameters;
    try {
      check(p);
    } catch (const ImpossibleParameters& fault) {
      throw BadInput(fmt::format("fix: {}", fault.what()));
    }
    const bool one = recipe.inputs.size() == 1;
    const std::uint64_t f = one && recipe.inputs.front().parameters.v < p.v
                                ? p.v - recipe.inputs.front().parameters.v
                                : 0;
    Parameters smaller = p;
    smaller.v -= f;
    smaller.k -= f;  // may wrap round, and is then no block size of the input either
    if (f == 0 || f >= p.k || recipe.inputs.front().parameters != smaller) {
      throw BadInput(fmt::format(
          "fix to {} takes one input with f >= 1 elements fewer in all and in a block, else alike",
          changeover::name(p)));
    }
    require_recipe(recipe, *this, fix_recipe(recipe.inputs.front(), f));
    return f;
  }
};

}  // namespace

Recipe fix_recipe(const Recipe& input, std::uint64_t f) {
  if (f == 0) {
    return input;
  }
  Parameters p = input.parameters;
  p.v = checked_add(p.v, f);
  p.k = checked_add(p.k, f);
  return {"fix", p, {{"f", static_cast<std::int64_t>(f)}}, {input}, {}};
}

const Construction& fix_construction() {
  static const Fix construction;
  return construction;
}

}  // namespace changeover
