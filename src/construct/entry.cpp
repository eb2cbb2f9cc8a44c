#include "construct/entry.hpp"

#include "changeover/construct/closure.hpp"
#include "changeover/construct/expansion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/each.hpp"

namespace changeover {
namespace {

std::string arguments_text(const Recipe& recipe) {
  if (recipe.arguments.empty()) {
    return "no arguments";
  }
  std::string text = recipe.arguments.size() == 1 ? "the argument" : "the arguments";
  for (const auto& [name, value] : recipe.arguments) {
    text += fmt::format(" {} = {}", name, value);
  }
  return text;
}

std::string inputs_text(const Recipe& recipe) {
  if (recipe.inputs.empty()) {
    return "no input";
  }
  const Recipe& input = recipe.inputs.front();
  return fmt::format("the one input {} of {}, as offered", input.construction,
                     name(input.parameters));
}

class MappedSource final : public BlockSource {
 public:
  using Map = std::function<void(std::span<const Element> from, std::span<Element> to)>;

  MappedSource(const Parameters& parameters, std::unique_ptr<BlockSource> source, Map map)
      : parameters_(parameters), source_(std::move(source)), map_(std::move(map)) {}

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return source_->block_count();
  }
  std::span<const Element> read(std::span<Element> room) override {
    const auto k = static_cast<std::size_t>(parameters_.k);
    const auto small_k = static_cast<std::size_t>(source_->parameters().k);
    from_.resize(room.size() / k * small_k);
    const std::span<const Element> blocks = source_->read(from_);
    std::size_t filled = 0;
    for (std::size_t at = 0; at < blocks.size(); at += small_k, filled += k) {
      map_(blocks.subspan(at, small_k), room.subspan(filled, k));
    }
    return room.first(filled);
  }
  bool rewind() override { return source_->rewind(); }

 private:
  Parameters parameters_;
  std::unique_ptr<BlockSource> source_;
  Map map_;
  std::vector<Element> from_;
};

class NumberedSource final : public BlockByBlock<NumberedSource> {
 public:
  using Write = std::function<void(std::uint64_t number, std::span<Element> block)>;

  NumberedSource(const Parameters& parameters, std::uint64_t count, Write write)
      : parameters_(parameters), count_(count), write_(std::move(write)) {}

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override { return count_; }
  bool make(std::span<Element> block) {
    if (number_ == count_) {
      return false;
    }
    write_(number_++, block);
    return true;
  }
  bool rewind() override {
    number_ = 0;
    return true;
  }

 private:
  Parameters parameters_;
  std::uint64_t count_;
  Write write_;
  std::uint64_t number_ = 0;
};

}  // namespace

std::optional<Offer> Family::offer(const Parameters& p, const Registry&) const {
  const std::optional<Promise> promised = promise(p);
  if (!promised) {
    return std::nullopt;
  }
  return Offer{recipe_for(p), promised->b, promised->tight, promised->economical,
               promised->expansion_set};
}

std::unique_ptr<BlockSource> Family::build(const Recipe& recipe, const Registry&) const {
  return blocks(required(recipe));
}

std::string Family::explain(const Recipe& recipe) const { return explanation(required(recipe)); }

const Parameters& Family::required(const Recipe& recipe) const {
  const Parameters& p = recipe.parameters;
  require_recipe(recipe, *this, promise(p) ? std::optional(recipe_for(p)) : std::nullopt);
  return p;
}

void Entry::require_input(const Recipe& recipe, const std::optional<Parameters>& smaller,
                          const std::map<std::string, std::int64_t>& arguments) const {
  if (smaller && (recipe.inputs.size() != 1 || recipe.inputs.front().parameters != *smaller)) {
    throw BadInput(fmt::format("{} to {} takes one input, a {}; correct the recipe", name(),
                               changeover::name(recipe.parameters), changeover::name(*smaller)));
  }
  require_recipe(recipe, *this,
                 smaller ? std::optional(recipe_of(recipe.parameters, arguments, recipe.inputs))
                         : std::nullopt);
}

Element Entry::element_of(const Recipe& recipe, const Parameters& larger,
                          std::string_view takes) const {
  const auto given = recipe.arguments.find("element");
  if (recipe.construction != name() || recipe.inputs.size() != 1 || !recipe.blocks.empty() ||
      recipe.arguments.size() != 1 || given == recipe.arguments.end() || given->second < 0 ||
      static_cast<std::uint64_t>(given->second) >= larger.v ||
      recipe.inputs.front().parameters != larger) {
    throw BadInput(fmt::format("{} to {} takes {}; correct the recipe", name(),
                               changeover::name(recipe.parameters), takes));
  }
  return static_cast<Element>(given->second);
}

std::uint64_t Rule::number(const Recipe& recipe) const {
  const Parameters& p = recipe.parameters;
  try {
    check(p);
  } catch (const ImpossibleParameters& fault) {
    throw BadInput(fmt::format("{}: {}", name(), fault.what()));
  }
  const Recipe* input = recipe.inputs.size() == 1 ? &recipe.inputs.front() : nullptr;
  const bool alike = input != nullptr && input->parameters.kind == p.kind &&
                     input->parameters.strength == p.strength;
  const std::uint64_t number = alike ? number_between(input->parameters, p) : 0;
  if (number == 0) {
    throw BadInput(fmt::format("{} to {} takes one input {}; correct the recipe", name(),
                               changeover::name(p), needs()));
  }
  require_recipe(recipe, *this, with(*input, number));
  return number;
}

bool asks_for_pairs(const Parameters& p, std::uint64_t change) {
  return p.strength == 2 && p.change == change && p.change >= 1 && p.k >= 2 && p.change <= p.k &&
         p.k <= p.v && p.v <= std::numeric_limits<std::uint32_t>::max();
}

void require_recipe(const Recipe& recipe, const Construction& construction,
                    const std::optional<Recipe>& expected) {
  if (recipe.construction != construction.name()) {
    throw BadInput(fmt::format("a recipe of '{}' cannot be built by '{}'; correct the recipe",
                               recipe.construction, construction.name()));
  }
  const std::string asked = name(recipe.parameters);
  if (!expected) {
    throw BadInput(fmt::format("{} does not make {}; it needs: {}", construction.name(), asked,
                               construction.preconditions()));
  }
  std::string needs;
  if (recipe.arguments != expected->arguments) {
    needs = arguments_text(*expected);
  } else if (recipe.inputs != expected->inputs) {
    needs = inputs_text(*expected);
  } else if (recipe.blocks != expected->blocks) {
    needs = expected->blocks.empty() ? "no blocks" : "its own blocks (others: use 'literal')";
  } else {
    return;
  }
  throw BadInput(
      fmt::format("{} of {} takes {}; correct the recipe", construction.name(), asked, needs));
}

std::size_t recipe_size(const Recipe& recipe) {
  std::size_t size = 1;
  for (const Recipe& input : recipe.inputs) {
    size += recipe_size(input);
  }
  return size;
}

std::optional<Offer> best_input(const Parameters& p, Need need, const Construction& asking,
                                const Registry& registry) {
  const auto rank = [](const Offer& offer) {
    return std::tuple(offer.b, !offer.tight, !offer.expansion_set, recipe_size(offer.recipe));
  };
  std::optional<Offer> best;
  for (const Construction* construction : registry.constructions()) {
    if (construction == &asking) {
      continue;
    }
    std::optional<Offer> offer = construction->offer(p, registry);
    if (offer && (need == Need::blocks || offer->expansion_set) &&
        (!best || rank(*offer) < rank(*best))) {
      best = std::move(offer);
    }
  }
  return best;
}

std::optional<Offer> best_that_asks_none(const Parameters& p, Need need, const Registry& registry) {
  std::optional<Offer> best;
  for (const Construction* construction : registry.constructions()) {
    if (!construction->asks_registry()) {
      std::optional<Offer> offer = construction->offer(p, registry);
      if (offer && (need == Need::blocks || offer->expansion_set) &&
          (!best || offer->b < best->b)) {
        best = std::move(offer);
      }
    }
  }
  return best;
}

std::optional<Offer> best_leaf(const Parameters& p, const Registry& registry) {
  std::optional<Offer> best = best_that_asks_none(p, Need::blocks, registry);
  if (p.kind == Kind::linear) {
    std::optional<Offer> cut = best_that_asks_none(p.as(Kind::circular), Need::blocks, registry);
    if (cut && (!best || cut->b < best->b)) {
      best = std::move(cut);
      best->recipe = cut_recipe(std::move(best->recipe));
      best->tight = false;
    }
  }
  return best;
}

std::string first_elements(std::uint64_t count) {
  if (count > 6) {
    return fmt::format("0,…,{}", count - 1);
  }
  return joined(std::views::iota(std::uint64_t{0}, count), ",",
                [](std::uint64_t x) { return std::to_string(x); });
}

std::vector<UnchangedSubset> known_expansion_set(const Recipe& input, const Registry& registry) {
  auto set = registry.construction_of(input).expansion_set(input, registry);
  if (!set) {
    throw BadInput(fmt::format("no expansion set is known of {} as made by {}; use another input",
                               name(input.parameters), input.construction));
  }
  return *std::move(set);
}

std::vector<std::string> labels_of_input(const Recipe& recipe, const Registry& registry) {
  const Recipe& input = recipe.inputs.front();
  return registry.construction_of(input).labels(input, registry);
}

std::vector<std::string> labels_with_new(const Recipe& recipe, const Registry& registry) {
  return expanded_labels(labels_of_input(recipe, registry),
                         recipe.parameters.v - recipe.inputs.front().parameters.v);
}

std::unique_ptr<BlockSource> mapped(
    const Parameters& parameters, std::unique_ptr<BlockSource> source,
    std::function<void(std::span<const Element> from, std::span<Element> to)> map) {
  return std::make_unique<MappedSource>(parameters, std::move(source), std::move(map));
}

std::unique_ptr<BlockSource> numbered(
    const Parameters& parameters, std::uint64_t count,
    std::function<void(std::uint64_t number, std::span<Element> block)> write) {
  return std::make_unique<NumberedSource>(parameters, count, std::move(write));
}

void blow_up(std::span<const Element> from, std::uint64_t copies, std::span<Element> to) {
  std::size_t filled = 0;
  for (const Element x : from) {
    for (std::uint64_t i = 0; i < copies; ++i) {
      to[filled++] = static_cast<Element>(copies * x + i);
    }
  }
}

std::unique_ptr<BlockSource> blown_up(const Parameters& parameters,
                                      std::unique_ptr<BlockSource> source, std::uint64_t copies) {
  return mapped(parameters, std::move(source),
                [copies](std::span<const Element> from, std::span<Element> to) {
                  blow_up(from, copies, to);
                });
}

std::unique_ptr<BlockSource> with_fixed(const Parameters& parameters,
                                        std::unique_ptr<BlockSource> source) {
  return mapped(parameters, std::move(source),
                [v = parameters.v](std::span<const Element> from, std::span<Element> to) {
                  const auto added = to.subspan(from.size());
                  std::ranges::copy(from, to.begin());
                  std::iota(added.begin(), added.end(), static_cast<Element>(v - added.size()));
                });
}

BlockListSource::BlockListSource(const Parameters& parameters, std::vector<Block> blocks)
    : parameters_(parameters), blocks_(std::move(blocks)) {
  try {
    check(parameters_);
  } catch (const ImpossibleParameters& fault) {
    throw BadInput(fault.what());
  }
  if (blocks_.empty()) {
    throw BadInput("the list of blocks is empty; give at least one block");
  }
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    Block sorted = blocks_[i];
    std::ranges::sort(sorted);
    if (sorted.size() != parameters_.k || sorted.back() >= parameters_.v ||
        std::ranges::adjacent_find(sorted) != sorted.end()) {
      throw BadInput(
          fmt::format("block {} does not have k = {} distinct elements below v = {}; "
                      "correct the block",
                      i + 1, parameters_.k, parameters_.v));
    }
  }
}

bool BlockListSource::make(std::span<Element> block) {
  if (position_ == blocks_.size()) {
    return false;
  }
  const Block& from = blocks_[position_++];
  std::ranges::copy(from, block.begin());
  return true;
}

}  // namespace changeover
