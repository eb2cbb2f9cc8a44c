// Truncate: one element fewer, as many blocks.
//
// Delete x. In each run of consecutive blocks that hold x, put in its place some element that is in none
// of them nor in the block before or after the run: the steps at both ends of the run then change as
// many elements as before, and no other pair is lost. The last element takes the name x.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/entry.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"

namespace changeover {
namespace {

/// The design without x; nullopt if some run leaves no element to put in its place. O(bk + runs·v).
std::optional<std::vector<Block>> without(const Design& design, Element x) {
  const std::size_t b = design.block_count();
  const auto k = static_cast<std::size_t>(design.k());
  const bool circular = design.parameters().kind == Kind::circular && b > 1;
  std::vector<Block> blocks;
  blocks.reserve(b);
  std::vector<std::size_t> place(b, k);  // of x in the block
  for (std::size_t i = 0; i < b; ++i) {
    const auto block = design.block(i);
    blocks.emplace_back(block.begin(), block.end());
    place[i] = static_cast<std::size_t>(std::find(block.begin(), block.end(), x) - block.begin());
  }
  std::size_t start = 0;  // a block without x, after which runs are looked for
  while (start < b && place[start] != k) {
    ++start;
  }
  if (start == b) {
    return std::nullopt;
  }
  if (!circular) {
    start = 0;
  }
  std::vector<std::size_t> used(static_cast<std::size_t>(design.v()), 0);
  std::size_t stamp = 0;
  for (std::size_t step = 0; step < b;) {
    const std::size_t first = (start + step) % b;
    if (place[first] == k) {
      ++step;
      continue;
    }
    std::size_t length = 1;
    while (step + length < b && place[(first + length) % b] != k) {
      ++length;
    }
    ++stamp;
    const auto mark = [&](std::size_t i) {
      for (const Element y : blocks[i]) {
        used[y] = stamp;
      }
    };
    for (std::size_t i = 0; i < length; ++i) {
      mark((first + i) % b);
    }
    if (circular || first > 0) {
      mark((first + b - 1) % b);
    }
    if (circular || first + length < b) {
      mark((first + length) % b);
    }
    const auto free =
        std::find_if(used.begin(), used.end(), [&](std::size_t s) { return s != stamp; });
    if (free == used.end()) {
      return std::nullopt;
    }
    for (std::size_t i = 0; i < length; ++i) {
      const std::size_t at = (first + i) % b;
      blocks[at][place[at]] = static_cast<Element>(free - used.begin());
    }
    step += length;
  }
  const auto last = static_cast<Element>(design.v() - 1);
  for (Block& block : blocks) {
    std::replace(block.begin(), block.end(), last, x);
  }
  return blocks;
}

class Truncate final : public Construction {
 public:
  std::string_view name() const override { return "truncate"; }
  std::string_view summary() const override {
    return "delete an element; other elements take its place, run by run";
  }
  std::string_view preconditions() const override {
    return "a design on v+1 elements in which each run of some element leaves another one free";
  }
  std::string_view guarantee() const override { return "as many blocks as the larger design"; }
  Citation citation() const override { return {}; }

  // A planner finds out which element can go; see construct/planner.hpp.
  std::optional<Offer> offer(const Parameters&, const Registry&) const override {
    return std::nullopt;
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    const Element x = deleted(recipe);
    const Design design = read_all(*registry.build(recipe.inputs.front()));
    std::optional<std::vector<Block>> blocks = without(design, x);
    if (!blocks) {
      throw BadInput(fmt::format("truncate: no element can take the place of {} everywhere", x));
    }
    return std::make_unique<BlockListSource>(recipe.parameters, *std::move(blocks));
  }

  std::string explain(const Recipe& recipe) const override {
    return fmt::format(
        "Delete element {} of the {}, others taking its place; the last element takes its name.",
        deleted(recipe), changeover::name(recipe.inputs.front().parameters));
  }

 private:
  static Element deleted(const Recipe& recipe) {
    const auto given = recipe.arguments.find("element");
    Parameters larger = recipe.parameters;
    ++larger.v;
    if (recipe.construction != "truncate" || recipe.inputs.size() != 1 || !recipe.blocks.empty() ||
        recipe.arguments.size() != 1 || given == recipe.arguments.end() || given->second < 0 ||
        static_cast<std::uint64_t>(given->second) >= larger.v ||
        recipe.inputs.front().parameters != larger) {
      throw BadInput(
          fmt::format("truncate to {} takes one input on {} elements and the element to delete",
                      changeover::name(recipe.parameters), larger.v));
    }
    return static_cast<Element>(given->second);
  }
};

}  // namespace

std::optional<Recipe> truncate_recipe(const Recipe& input, const Design& design) {
  if (design.v() <= design.k() + 1) {
    return std::nullopt;
  }
  for (auto x = static_cast<Element>(design.v()); x-- > 0;) {
    if (without(design, x)) {
      Parameters smaller = input.parameters;
      --smaller.v;
      return Recipe{"truncate", smaller, {{"element", x}}, {input}, {}};
    }
  }
  return std::nullopt;
}

const Construction& truncate_construction() {
  static const Truncate construction;
  return construction;
}

}  // namespace changeover
