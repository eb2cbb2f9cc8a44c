// Minimum m-change covering designs for small v: b = 2p+1 blocks, p = ⌈(v−k)/m⌉, which no design
// goes below ("end to end" in bounds/lower_bound.hpp). With d = v − k = mp − r, 0 ≤ r < m,
// and s = 2k − v:
//
//   circular  s ≥ m; if r ≥ 1 also p = 2, s ≥ max(m−r, r) and p ≥ 3, s ≥ m−r
//   linear    as circular; also p = 2, r ≥ 1, s ≥ max(m−r, ⌈m/2⌉) and p ≥ 3, s ≥ 0, that is v ≤ 2k
//
// In particular all k+m ≤ v ≤ 2k−m. Designs with the least s are *cores*: f fixed elements raise s
// by f and leave d, and a circular design may be cut. For r = 0 the circular core is McSorley's
// SCCD(2p+1,p+1,2p+1) with m copies of every element, and the linear one `held` below. Other cores
// are *layers* side by side: designs with 2p+1 blocks each, several copies of each. Their m add up,
// so all that remains to be shown is that elements meet, within a layer and across two. Blocks are
// numbered from 0, modulo b if circular.
//
// Circular, p ≥ 3: m−r copies of `windows`, McSorley's SCCD, and r of `fewer_windows`, an
// SCCD(2p−2,p−1,2p+1). No absence is longer than p blocks. So an element that is absent once, as
// all in `windows` are, meets every other: two absences do not fill 2p+1 blocks, nor does one hold
// all blocks of an element. To make `fewer_windows` (p ≥ 4) take the absences of `windows`, p
// blocks from each t on, and exchange the ends of three: 0 gets that of p+2, which gets that of 3,
// which gets that of 0. They last 1, 1 and p−3 blocks now. Make one element of the absences from 0
// and 2, one of those from p+2 and p+4, one of those from 3 and p+1: these three meet in blocks 1,
// p and p+3. The list for p = 3 is of the same kind.
//
// Linear, p ≥ 3: m−r copies of `held`, an SCCD(2p,p,2p+1), and r of `fewer_held`, an
// SCCD(2p−2,p−1,2p+1). All but one place is held up to block p while the rest pass through it, and
// meet what is held; then what is held goes one by one and the rest come back, and meet in the
// last block, 2p.
//   - In `held` one of those held makes way in block 2, comes back in block p+1 and goes last,
//     after block 2p−2; its replacement stays until block 2p−1. Of those that pass, those of blocks
//     0 and 1 are the last to come back, in blocks 2p−1 and 2p: they met the former, and the very
//     last was in block 2 with the replacement. All others come back early enough to meet both.
//   - In `fewer_held` that of block 2 is back from block p+1, makes way in block 2p−1 for that of
//     block 0, and returns in block 2p for that of block 1, which was there from block p on and so
//     misses only the last to come back in `held`; those two meet in block 1.
//
// p = 2: five blocks. If 2r ≤ m, m−2r copies of `windows` and r of `seven`, a DCCD(7,4,5). If
// 2r > m, m−r of `seven` and, circular, 2r−m of `three`, an SCCD(3,2,5); linear, half as many of
// `five`, a DCCD(5,3,5), and one of `three` if 2r−m is odd. Every element is in three or more
// blocks, but one of `seven` in just 0 and 3; and none is in just 1, 2 and 4, so all meet.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"

namespace changeover::small_v_entry {
namespace {

constexpr std::string_view own_name = "small-v";

// Consecutive blocks that contain an element, numbered from 0, modulo b.
struct Run {
  std::uint64_t first = 0;
  std::uint64_t length = 0;
};

// All blocks that contain an element; unused runs have length 0.
using Runs = std::array<Run, 3>;

enum class Part : std::uint8_t { windows, fewer_windows, held, fewer_held, seven, five, three };

struct Layer {
  Part part;
  std::uint64_t copies;
};

// d = v − k = mp − r.
struct Shape {
  std::uint64_t m, d, p, r;

  [[nodiscard]] std::uint64_t blocks() const { return 2 * p + 1; }
};

Shape shape_of(const Parameters& p) {
  const std::uint64_t d = p.v - p.k;
  const std::uint64_t reach = ceil_div(d, p.change);
  return {p.change, d, reach, reach * p.change - d};
}

// The m-change covering design that a part is.
Parameters parameters_of(Part part, std::uint64_t p) {
  switch (part) {
    case Part::windows:
      return {2 * p + 1, p + 1, 1, Kind::circular, 2};
    case Part::fewer_windows:
      return {2 * p - 2, p - 1, 1, Kind::circular, 2};
    case Part::held:
      return {2 * p, p, 1, Kind::linear, 2};
    case Part::fewer_held:
      return {2 * p - 2, p - 1, 1, Kind::linear, 2};
    case Part::seven:
      return {7, 4, 2, Kind::circular, 2};
    case Part::five:
      return {5, 3, 2, Kind::linear, 2};
    case Part::three:
      break;
  }
  return {3, 2, 1, Kind::circular, 2};
}

Runs fewer_windows(std::uint64_t p, std::uint64_t i) {
  if (p == 3) {
    constexpr std::array<Runs, 4> runs{
        {{{{2, 2}, {5, 1}}}, {{{1, 1}, {4, 3}}}, {{{0, 1}, {3, 2}}}, {{{6, 4}}}}};
    return runs.at(i);
  }
  switch (i) {
    case 0:
      return {{{1, 1}, {p + 2, p - 1}}};
    case 1:
      return {{{p + 3, 1}, {3, p - 1}}};
    case 2:
      return {{{p, 1}, {0, 3}}};
    default:
      break;
  }
  // The absence from t on, t the (i−3)-th of 0, …, 2p but 0, 2, 3, p+1, p+2, p+4.
  std::uint64_t t = i - 3;
  for (const std::uint64_t taken :
       {std::uint64_t{0}, std::uint64_t{2}, std::uint64_t{3}, p + 1, p + 2, p + 4}) {
    t += t >= taken ? 1 : 0;
  }
  return {{{t + p, p + 1}}};
}

Runs held(std::uint64_t p, std::uint64_t i) {
  if (i < p - 2) {
    return {{{0, p + 1 + i}}};  // leaves after block p + i
  }
  switch (i - (p - 2)) {
    case 0:
      return {{{0, 2}, {p + 1, p - 2}}};  // makes way early
    case 1:
      return {{{2, 2 * p - 2}}};  // replaces it
    case 2:
      return {{{0, 1}, {2 * p - 1, 2}}};
    case 3:
      return {{{1, 2}, {2 * p, 1}}};
    case 4:
      return {{{p, p + 1}}};
    default:
      break;
  }
  const std::uint64_t j = i - (p + 3) + 2;  // 2, …, p−2
  return {{{j + 1, 1}, {p + j, p + 1 - j}}};
}

Runs fewer_held(std::uint64_t p, std::uint64_t i) {
  if (i < p - 2) {
    return {{{0, p + 1 + i}}};
  }
  const std::uint64_t j = i - (p - 2);  // 0, …, p−1: passes in block j
  switch (j) {
    case 0:
      return {{{0, 1}, {2 * p - 1, 2}}};
    case 1:
      return {{{1, 1}, {p, p}}};
    case 2:
      return {{{2, 1}, {p + 1, p - 2}, {2 * p, 1}}};
    default:
      return {{{j, 1}, {p + j - 1, p + 2 - j}}};
  }
}

// The blocks that contain element i of a part.
Runs runs_of(Part part, std::uint64_t p, std::uint64_t i) {
  constexpr std::array<Runs, 7> seven{{{{{0, 3}}},
                                       {{{0, 1}, {3, 1}}},
                                       {{{1, 3}}},
                                       {{{0, 2}, {4, 1}}},
                                       {{{0, 1}, {2, 1}, {4, 1}}},
                                       {{{1, 1}, {3, 2}}},
                                       {{{2, 3}}}}};
  constexpr std::array<Runs, 5> five{{{{{0, 2}, {3, 1}}},
                                      {{{1, 3}}},
                                      {{{0, 1}, {2, 1}, {4, 1}}},
                                      {{{0, 1}, {2, 1}, {4, 1}}},
                                      {{{1, 1}, {3, 2}}}}};
  constexpr std::array<Runs, 3> three{{{{{1, 1}, {3, 2}}}, {{{0, 1}, {2, 1}, {4, 1}}}, {{{0, 4}}}}};
  switch (part) {
    case Part::windows:
      return {{{i, p + 1}}};
    case Part::fewer_windows:
      return fewer_windows(p, i);
    case Part::held:
      return held(p, i);
    case Part::fewer_held:
      return fewer_held(p, i);
    case Part::seven:
      return seven.at(i);
    case Part::five:
      return five.at(i);
    case Part::three:
      break;
  }
  return three.at(i);
}

// The layers of a core; p ≥ 2, and r ≥ 1 if circular or p = 2. Those without copies are left out.
std::vector<Layer> layers_of(const Shape& shape, Kind kind) {
  const auto [m, d, p, r] = shape;
  std::vector<Layer> layers;
  const auto add = [&layers](Part part, std::uint64_t copies) {
    if (copies > 0) {
      layers.push_back({part, copies});
    }
  };
  if (p >= 3) {
    add(kind == Kind::circular ? Part::windows : Part::held, m - r);
    add(kind == Kind::circular ? Part::fewer_windows : Part::fewer_held, r);
  } else if (2 * r <= m) {
    add(Part::windows, m - 2 * r);
    add(Part::seven, r);
  } else {
    add(Part::seven, m - r);
    add(Part::five, kind == Kind::circular ? 0 : (2 * r - m) / 2);
    add(Part::three, kind == Kind::circular ? 2 * r - m : m % 2);
  }
  return layers;
}

// The least s = 2k − v that is served with this d.
std::uint64_t least_circular(const Shape& shape) {
  if (shape.p == 1 || shape.r == 0) {
    return shape.m;
  }
  return shape.p == 2 ? std::max(shape.m - shape.r, shape.r) : shape.m - shape.r;
}

std::uint64_t least_linear(const Shape& shape) {
  if (shape.p >= 3) {
    return 0;
  }
  return shape.p == 2 && shape.r > 0 ? std::max(shape.m - shape.r, ceil_div(shape.m, 2)) : shape.m;
}

Recipe layered(const Shape& shape, std::uint64_t s, Kind kind) {
  return {std::string(own_name), {2 * shape.d + s, shape.d + s, shape.m, kind, 2}, {}, {}, {}};
}

// A circular core with at most this s, from constructions of their own name where there are some.
Recipe circular_core(const Shape& shape, std::uint64_t s) {
  const Parameters single{2 * shape.p + 1, shape.p + 1, 1, Kind::circular, 2};
  const Parameters twice{2 * shape.d + 2, shape.d + 2, 2, Kind::circular, 2};
  const Recipe mcsorley{"mcsorley-circular", single, {}, {}, {}};
  if (shape.r == 0) {
    return shape.m == 2 ? Recipe{"doubling", twice, {}, {mcsorley}, {}}
                        : blow_up_recipe(mcsorley, shape.m);
  }
  if (shape.m == 2 && s >= 2) {
    return {"short-long-runs", twice, {}, {}, {}};
  }
  return layered(shape, least_circular(shape), Kind::circular);
}

Recipe linear_core(const Shape& shape) {
  if (shape.r == 0) {
    return blow_up_recipe(layered({1, shape.p, shape.p, 0}, 0, Kind::linear), shape.m);
  }
  return layered(shape, least_linear(shape), Kind::linear);
}

bool known(const Recipe& recipe, const Registry& registry) {
  return registry.find(recipe.construction) != nullptr &&
         std::ranges::all_of(recipe.inputs,
                             [&](const Recipe& input) { return known(input, registry); });
}

// The recipe for these parameters: a layered core without inputs, or one input that makes it.
std::optional<Recipe> recipe_for(const Parameters& p) {
  if (!asks_for_pairs(p, p.change) || p.v - p.k < p.change || p.v - p.k > p.k) {
    return std::nullopt;
  }
  const Shape shape = shape_of(p);
  const std::uint64_t s = p.k - shape.d;
  Recipe recipe;
  if (s >= least_circular(shape)) {
    const Recipe core = circular_core(shape, s);
    recipe = fix_recipe(core, p.k - core.parameters.k);
    if (p.kind == Kind::linear) {
      recipe = Recipe{"cut", p, {{"at", 0}}, {std::move(recipe)}, {}};
    }
  } else if (p.kind == Kind::linear && s >= least_linear(shape)) {
    const Recipe core = linear_core(shape);
    recipe = fix_recipe(core, p.k - core.parameters.k);
  } else {
    return std::nullopt;
  }
  if (recipe.construction != own_name) {
    recipe = Recipe{std::string(own_name), p, {}, {std::move(recipe)}, {}};
  }
  return recipe;
}

// A core block by block, without memory for its elements.
std::unique_ptr<BlockSource> layered(const Parameters& p) {
  const Shape shape = shape_of(p);
  const auto write = [shape, layers = layers_of(shape, p.kind)](std::uint64_t index,
                                                                std::span<Element> block) {
    const std::uint64_t b = shape.blocks();
    const auto is_in = [&](const Run& run) { return (index + b - run.first % b) % b < run.length; };
    std::size_t filled = 0;
    std::uint64_t element = 0;
    for (const auto& [part, copies] : layers) {
      const std::uint64_t elements = parameters_of(part, shape.p).v;
      for (std::uint64_t i = 0; i < elements; ++i, element += copies) {
        if (std::ranges::any_of(runs_of(part, shape.p, i), is_in)) {
          for (std::uint64_t copy = 0; copy < copies; ++copy) {
            block[filled++] = static_cast<Element>(element + copy);
          }
        }
      }
    }
  };
  return numbered(p, shape.blocks(), write);
}

// Whether b blocks are tight, and economical; some number of elements are in every block.
std::pair<bool, bool> quality(const Parameters& p, std::uint64_t b, std::uint64_t fixed) {
  const std::uint64_t most = newly_covered_at_most(p);
  const bool circular = p.kind == Kind::circular;
  const std::uint64_t pairs = binomial(p.v, 2) - (circular ? 0 : binomial(p.k, 2));
  const std::uint64_t blocks = circular ? b : b - 1;
  const bool tight = pairs % most == 0 && pairs / most == blocks && (!circular || fixed < 2);
  return {tight, ceil_div(pairs, most) == blocks};
}

std::uint64_t fixed_elements(const Recipe& recipe) {
  std::uint64_t fixed = 0;
  for (const Recipe* at = &recipe;; at = &at->inputs.front()) {
    if (at->construction == "fix") {
      fixed += at->parameters.k - at->inputs.front().parameters.k;
    }
    if (at->inputs.empty()) {
      return fixed;
    }
  }
}

constexpr Description description{
    .name = own_name,
    .summary = "designs of 2*ceil((v-k)/m)+1 blocks, the fewest that there can be",
    .preconditions = "k+m <= v <= 2k-m; linear also v <= 2k if v > k+2m; a few more up to v = 2k",
    .guarantee = "a minimum design, by the end-to-end bound",
};

class SmallV final : public Described<Entry, description> {
 public:
  std::optional<Offer> offer(const Parameters& p, const Registry& registry) const override {
    std::optional<Recipe> recipe = recipe_for(p);
    if (!recipe || !known(*recipe, registry)) {
      return std::nullopt;
    }
    const std::uint64_t b = shape_of(p).blocks();
    const auto [tight, economical] = quality(p, b, fixed_elements(*recipe));
    return Offer{*std::move(recipe), b, tight, economical, false};
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    require_recipe(recipe, *this, recipe_for(recipe.parameters));
    if (recipe.inputs.empty()) {
      return layered(recipe.parameters);
    }
    return registry.build(recipe.inputs.front());
  }

  std::string explain(const Recipe& recipe) const override {
    require_recipe(recipe, *this, recipe_for(recipe.parameters));
    const Parameters& p = recipe.parameters;
    const Shape shape = shape_of(p);
    if (!recipe.inputs.empty()) {
      const std::string ends = shape.p == 1 ? "block" : fmt::format("{} blocks", shape.p);
      return fmt::format(
          "No design has fewer blocks: some element is absent from the first {0}, some "
          "other from the last {0}, and they meet in one more.",
          ends);
    }
    if (p.change == 1) {
      return fmt::format(
          "Keep {0} elements up to block {2} while {1} others pass one by one, then let them go "
          "one by one while those come back; from block 3 to {2} put one more in place of one of "
          "the {0}, and keep it up to block {3}.",
          p.k - 1, p.k, p.k + 1, 2 * p.k);
    }
    const std::vector<Layer> layers = layers_of(shape, p.kind);
    std::string list;
    if (layers.size() == 1 && layers.front().copies == 1) {
      const std::unique_ptr<BlockSource> source = layered(p);
      for_each_block(*source, [&](std::span<const Element> block) {
        list += fmt::format("{}{{{}}}", list.empty() ? "" : ", ", fmt::join(block, ","));
      });
      return fmt::format("The {} blocks {}.", shape.blocks(), list);
    }
    for (const auto& [part, copies] : layers) {
      list += fmt::format("{}{} with {} of every element", list.empty() ? "a " : " and a ",
                          changeover::name(parameters_of(part, shape.p)),
                          count_of(copies, "copy", "copies"));
    }
    return fmt::format("Write side by side, {} blocks each: {}.", shape.blocks(), list);
  }

  std::vector<std::string> labels(const Recipe& recipe, const Registry& registry) const override {
    require_recipe(recipe, *this, recipe_for(recipe.parameters));
    if (recipe.inputs.empty()) {
      return {};
    }
    return labels_of_input(recipe, registry);
  }
};

}  // namespace

const Construction& construction() { return only<SmallV>(); }

}  // namespace changeover::small_v_entry
