// Any bytes, read as the JSON of a recipe and built within limits: each build gives the same
// blocks, and what is made of constructions alone is a design.
#include <algorithm>
#include <chrono>

#include "changeover/catalog/entry.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/io/formats.hpp"
#include "changeover/run/control.hpp"
#include "changeover/verify/verdict.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::recipe_fuzz {
namespace {

constexpr std::uint64_t most_v_here = 400;
constexpr std::uint64_t most_blocks_here = 20'000;

// Whether it has no given blocks, which a recipe cannot know to be a design.
bool is_made_of_constructions(const Recipe& recipe) {
  return recipe.blocks.empty() && recipe.construction != "literal" &&
         recipe.construction != "developed" &&
         std::ranges::all_of(recipe.inputs, is_made_of_constructions);
}

// The blocks from a stream, as far as they are looked at.
std::optional<Design> some_blocks(BlockSource& source, bool& all) {
  const Parameters& p = source.parameters();
  Design design(p);
  std::vector<Element> room(p.k * 16);
  for (;;) {
    const std::span<const Element> read = source.read(room);
    if (read.empty()) {
      all = true;
      return design;
    }
    must(read.size() % p.k == 0, "a stream hands out whole blocks");
    for (std::size_t at = 0; at < read.size(); at += p.k) {
      design.append(read.subspan(at, p.k));
    }
    if (design.block_count() > most_blocks_here) {
      return design;
    }
  }
}

void build(const Recipe& recipe) {
  const Registry& registry = Registry::standard();
  bool all = false;
  const auto source = registry.build(recipe);
  must(source->parameters() == recipe.parameters, "a recipe makes what it says");
  if (recipe.parameters.v > most_v_here) {
    return;
  }
  const auto design = some_blocks(*source, all);
  bool all_again = false;
  must(some_blocks(*registry.build(recipe), all_again)->blocks() == design->blocks(),
       "a recipe makes the same blocks again");
  const auto labels = registry.construction_of(recipe).labels(recipe, registry);
  must(labels.empty() || labels.size() == recipe.parameters.v, "there is a name for each element");
  must(is_plain(registry.construction_of(recipe).explain(recipe)), "an explanation is plain text");
  if (all && is_made_of_constructions(recipe)) {
    must(verify(*design).valid(), "a recipe of constructions makes a design");
  }
}

const Target target("recipe", [](const std::string& bytes) {
  Recipe recipe;
  if (!accepts([&] { recipe = recipe_from_json(bytes); })) {
    return;
  }
  const std::string json = recipe_to_json(recipe);
  must(recipe_from_json(json) == recipe, "a recipe is read as it was written");
  RunControl control(
      {.time = std::chrono::milliseconds(500), .memory_bytes = std::uint64_t{64} << 20U});
  const RunScope scope(control);
  try {
    accepts([&] { build(recipe); });
  } catch (const Stopped&) {
    must(control.why_stopped() == WhyStopped::time_limit, "only the time stops it");
  }
});

}  // namespace
}  // namespace changeover::fuzz::recipe_fuzz
