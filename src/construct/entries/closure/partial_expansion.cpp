// Partial expansion of designs whose cover by unchanged subsets is known in closed form.
//
// Excess. Going from v₀ to v = v₀ + w with ℓ intervals costs, w even and ℓ ≥ w − 1, an excess of
// (ℓ(k−2) − v₀)w + (ℓ−w+1)w/2, which is concave in w: it is least for few new elements and for
// about ℓ + 1 of them. So of the cyclic designs on c(4k−6)+1 elements only some with the largest c
// and some with v₀ + v₀/(k−2) + 1 near v are looked at, and an offer takes a fixed number of
// evaluations.
//
// A new element leaves one block after it came, so the result has neither an expansion set nor such
// a cover. Only one more element can be added, as the others can come beside it; this is known
// here, so this construction need not ask itself. Those that it asks must not ask the registry: it
// asks the families below by name.
#include "changeover/construct/expansion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"
#include "construct/expansion/partial_expansion_parts.hpp"
#include "construct/tools/cyclic.hpp"
#include "construct/trusted_entry.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"

namespace changeover::partial_expansion_entry {
namespace {

// The largest v that is offered: a cover lists v elements.
constexpr std::uint64_t largest_v = std::uint64_t{1} << 24;
// How many values of c are looked at below the largest one, and to either side of the other.
constexpr std::uint64_t values_of_c = 6;
// The most elements in the blocks of an input whose cover is searched for.
constexpr std::uint64_t most_searched = std::uint64_t{1} << 24;

// How the unchanged subsets of a family look.
enum class Family : std::uint8_t {
  interval,   // c base blocks over Z_v with an interval in common
  doubled,    // a circular SCCD(k−1, k/2, k−1) of that sort with two copies of every element
  fixed,      // one of those with one more element in every block
  partition,  // unchanged subsets partition its elements
};

struct Known {
  std::string_view name;
  std::uint64_t change;
  Family family;
};

constexpr std::array<Known, 7> known_families{{
    {"cyclic", 2, Family::interval},
    {"cyclic-paper", 2, Family::interval},
    {"cyclic-single-change", 1, Family::interval},
    {"mcsorley-circular", 1, Family::interval},
    {"stretched-orbits", 1, Family::partition},
    {"doubling", 2, Family::doubled},
    {"fixed-element", 2, Family::fixed},
}};

const Known* known_family(const Recipe& recipe) {
  for (const Known& known : known_families) {
    if (known.name == recipe.construction && known.change == recipe.parameters.change) {
      return &known;
    }
  }
  return nullptr;
}

// The SCCD that was doubled.
Parameters halved(const Parameters& p) { return {p.k / 2 * 2 - 1, p.k / 2, 1, p.kind, 2}; }

std::optional<IntervalCoverSize> cover_size(Family family, const Parameters& p, std::uint64_t b,
                                            std::uint64_t w) {
  if (family == Family::interval) {
    return interval_cover_size(p, b / p.v, w);
  }
  if (family == Family::partition) {
    const std::uint64_t n = p.k - p.change;
    return p.v % n == 0 && p.v <= max_elements_of_interval_expansion
               ? std::optional(IntervalCoverSize{p.v / n, false})
               : std::nullopt;
  }
  const Parameters half = halved(p);
  if (half.k < 2 || (w == 1 && p.v < p.k + 3)) {
    return std::nullopt;
  }
  const auto count = best_positions(p, interval_cover_size(half, 1, 1)->subsets, b, w);
  return count ? std::optional(IntervalCoverSize{*count, false}) : std::nullopt;
}

// The cover of a recipe of a known family; its b is known by its parameters.
std::optional<IntervalCoverSize> known_size(const Recipe& recipe, std::uint64_t w) {
  const Known* known = known_family(recipe);
  if (known == nullptr) {
    return std::nullopt;
  }
  const Parameters& p = recipe.parameters;
  const std::uint64_t period = p.change == 1 ? 2 * p.k - 2 : 4 * p.k - 6;
  return cover_size(known->family, p,
                    known->family == Family::interval ? (p.v - 1) / period * p.v : halved(p).v, w);
}

// The intervals of the SCCD with two copies of every element, and the fixed element if there is
// one.
UnchangedCover doubled_cover(const Parameters& p, std::uint64_t count, bool fixed) {
  const Parameters half = halved(p);
  UnchangedCover cover = interval_cover(half, 1, 1, {});
  for (std::uint64_t position = 1; cover.subsets.size() < count; ++position) {
    if (std::ranges::none_of(cover.subsets,
                             [&](const auto& subset) { return subset.position == position; })) {
      Block elements;
      for (std::uint64_t i = 0; i + 1 < half.k; ++i) {
        elements.push_back(static_cast<Element>((position + i) % half.v));
      }
      std::ranges::sort(elements);
      cover.subsets.push_back({static_cast<std::size_t>(position), std::move(elements)});
    }
  }
  std::ranges::sort(cover.subsets,
                    [](const auto& a, const auto& b) { return a.position < b.position; });
  for (UnchangedSubset& subset : cover.subsets) {
    Block copies;
    for (const Element x : subset.elements) {
      copies.push_back(2 * x);
      copies.push_back(2 * x + 1);
    }
    if (fixed) {
      copies.push_back(static_cast<Element>(p.v - 1));
    }
    subset.elements = std::move(copies);
  }
  return cover;
}

// The points of base blocks whose interval is {0, …, k−m−1}.
IntervalDevelopedSource::Points points_of(const Recipe& recipe, const Registry& registry) {
  const Construction& maker = registry.construction_of(recipe);
  if (auto listed = maker.interval_base_blocks(recipe)) {
    return [base = *std::move(listed)](std::uint64_t which, std::span<Element> points) {
      std::ranges::copy(base.points_of(static_cast<std::size_t>(which)), points.begin());
    };
  }
  if (auto written = maker.base_blocks(recipe)) {
    return [base = *std::move(written)](std::uint64_t which, std::span<Element> points) {
      std::ranges::copy(std::span(base.blocks[static_cast<std::size_t>(which)]).last(points.size()),
                        points.begin());
    };
  }
  throw BadInput(fmt::format("{} has too many base blocks to list; use another input",
                             name(recipe.parameters)));
}

constexpr std::string_view own_name = "partial-expansion";

constexpr Description description{
    .name = own_name,
    .summary = "w new elements inserted at positions whose unchanged subsets cover all elements",
    .preconditions = "circular, m = 2 and v > 4k-5, or m = 1 and v > 2k-1, and some smaller v",
    .guarantee = "l ceil(w/2) blocks more for m = 2 and l positions; often economical",
    .place = "docs/theorems.md, Theorem 3",
};

class PartialExpander final : public Described<Rule, description> {
 public:
  bool asks_registry() const override { return true; }

  std::optional<Offer> offer(const Parameters& p, const Registry& registry) const override {
    if (p.kind != Kind::circular || !asks_for_pairs(p, p.change) || p.change > 2 ||
        p.change == p.k || p.v > largest_v) {
      return std::nullopt;
    }
    std::optional<Offer> best;
    for (const Parameters& smaller : inputs(p)) {
      for (const Known& known : known_families) {
        if (known.change == p.change) {
          if (const Construction* maker = registry.find(known.name)) {
            const std::optional<Offer> input = maker->offer(smaller, registry);
            take_better(best, of_family(p, known.family, input));
            take_better(best, one_more(p, known.family, input));
          }
        }
      }
    }
    return best;
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    require_fit(recipe);
    const Recipe& input = recipe.inputs.front();
    const std::uint64_t w = recipe.parameters.v - input.parameters.v;
    if (!recipe.blocks.empty()) {
      const std::unique_ptr<BlockSource> source = registry.build(input);
      const Design design = read_within_memory(*source);
      UnchangedCover cover = written_cover(recipe, design);
      return expand_by(std::make_unique<BlockListSource>(input.parameters, design.blocks()),
                       std::move(cover), w);
    }
    std::unique_ptr<BlockSource> source = registry.build(input);
    UnchangedCover cover = cover_of(input, w, *source, registry);
    return expand_by(std::move(source), std::move(cover), w);
  }

  std::string explain(const Recipe& recipe) const override {
    require_fit(recipe);
    const Parameters& p = recipe.parameters;
    const Parameters& input = recipe.inputs.front().parameters;
    const std::uint64_t w = p.v - input.v;
    const std::string added = w == 1 ? fmt::format("the new element {}", input.v)
                              : w == 2
                                  ? fmt::format("the new elements {} and {}", input.v, input.v + 1)
                                  : fmt::format("the new elements {},…,{}", input.v, p.v - 1);
    const auto size =
        recipe.blocks.empty() ? known_size(recipe.inputs.front(), w) : written_size(recipe);
    const bool sweeps = size && takes_sweep(input, size->subsets, w);
    std::string how;
    if (w <= p.change) {
      how = w == p.change ? added
                          : fmt::format("{} and {} from neither block there", added,
                                        p.change - w == 1 ? "an old one" : "old ones");
    } else if (p.change == 1) {
      how = fmt::format("each of {} in turn", added);
    } else if (w % 2 == 0) {
      how = fmt::format("the edges of one 1-factor of K_{} on {}", w, added);
    } else {
      how = fmt::format(
          "the edges of one near-1-factor of K_{} on {}, and its unmatched element and an old one",
          w, added);
    }
    return fmt::format(
        "At each {} of a cover of the {} by unchanged subsets, insert the subset with {}{}.",
        size ? fmt::format("of the {} positions", size->subsets) : "position",
        changeover::name(input), how,
        sweeps ? "; at one of them, let all these meet one another" : "");
  }

  std::vector<std::string> labels(const Recipe& recipe, const Registry& registry) const override {
    require_fit(recipe);
    return labels_with_new(recipe, registry);
  }

 private:
  // The smaller parameters of the families that are worth a look; p.change is 1 or 2.
  static std::vector<Parameters> inputs(const Parameters& p) {
    std::vector<std::uint64_t> sizes;
    const std::uint64_t n = p.k - p.change;
    const std::uint64_t period = p.change == 1 ? 2 * n : 4 * n + 2;
    const std::uint64_t largest_c = p.v >= 2 ? (p.v - 2) / period : 0;
    const auto add = [&](std::uint64_t c) {
      if (c >= 1 && c <= largest_c) {
        sizes.push_back(c * period + 1);
      }
    };
    const std::uint64_t other = p.v * n / (n + 1) / period;
    // An odd number of unchanged subsets of k−1 elements partitions these.
    if (p.change == 1 && p.k % 2 == 0 && p.v > n) {
      const std::uint64_t most = (p.v - n - 1) / period;
      for (std::uint64_t i = 0; i <= std::min(values_of_c, most); ++i) {
        sizes.push_back((most - i) * period + n);
      }
    }
    for (std::uint64_t i = 0; i <= values_of_c; ++i) {
      add(largest_c - std::min(i, largest_c));
      add(other + i);
      add(other - std::min(i, other));
    }
    if (p.change == 2) {
      sizes.push_back(p.k % 2 == 0 ? 2 * p.k - 2 : 2 * p.k - 3);
    }
    std::ranges::sort(sizes, std::greater<>());
    sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
    std::vector<Parameters> result;
    for (const std::uint64_t v : sizes) {
      if (v < p.v && v > p.k) {
        result.push_back(p.on(v));
      }
    }
    return result;
  }

  static void take_better(std::optional<Offer>& best, std::optional<Offer> other) {
    if (other && (!best || other->b < best->b)) {
      best = std::move(other);
    }
  }

  // What an input makes with a cover of that size.
  std::optional<Offer> with(const Parameters& p, const Offer& input,
                            const IntervalCoverSize& size) const {
    const Parameters& smaller = input.recipe.parameters;
    const std::uint64_t w = p.v - smaller.v;
    std::uint64_t b = 0;
    if (__builtin_add_overflow(input.b, blocks_added(smaller, size.subsets, w, size.left_out),
                               &b)) {
      return std::nullopt;
    }
    const std::uint64_t pairs = binomial(p.v, 2);
    const std::uint64_t each = newly_covered_at_most(p);
    const bool economical = b == ceil_div(pairs, each);
    return Offer{with(input.recipe, w), b, input.tight && economical && pairs % each == 0,
                 economical, false};
  }

  std::optional<Offer> of_family(const Parameters& p, Family family,
                                 const std::optional<Offer>& input) const {
    if (!input) {
      return std::nullopt;
    }
    const Parameters& smaller = input->recipe.parameters;
    const auto size = cover_size(family, smaller, input->b, p.v - smaller.v);
    return size ? with(p, *input, *size) : std::nullopt;
  }

  // For w odd, m = 2: first w − 1 elements, then one.
  std::optional<Offer> one_more(const Parameters& p, Family family,
                                const std::optional<Offer>& input) const {
    if (!input || family != Family::interval || p.change != 2) {
      return std::nullopt;
    }
    const Parameters& smaller = input->recipe.parameters;
    const std::uint64_t c = input->b / smaller.v;
    const std::uint64_t w = p.v - smaller.v - 1;
    const auto count = w >= 2 ? interval_cover_for_one_more_size(smaller, c, w) : std::nullopt;
    if (!count) {
      return std::nullopt;
    }
    std::optional<Offer> first = with(p.on(p.v - 1), *input, *interval_cover_size(smaller, c, w));
    return first ? with(p, *first, {*count, true}) : std::nullopt;
  }

  // In closed form if it is known, else by search.
  static UnchangedCover cover_of(const Recipe& input, std::uint64_t w, BlockSource& source,
                                 const Registry& registry) {
    const Parameters& p = input.parameters;
    const std::optional<std::uint64_t> b = source.block_count();
    const Known* known = known_family(input);
    const auto size = known != nullptr && b ? cover_size(known->family, p, *b, w) : std::nullopt;
    if (size && p.v <= largest_v) {
      if (known->family == Family::partition) {
        return {.subsets = known_expansion_set(input, registry)};
      }
      if (known->family != Family::interval) {
        return doubled_cover(p, size->subsets, known->family == Family::fixed);
      }
      return interval_cover(
          p, *b / p.v, w,
          size->left_out ? points_of(input, registry) : IntervalDevelopedSource::Points{});
    }
    if (auto cover = cover_for_one_more(input, w, b, registry)) {
      return *std::move(cover);
    }
    if (!b || p.v > max_elements_in_memory || *b > most_searched / p.k) {
      throw BadInput(
          fmt::format("no cover by unchanged subsets is known of {} as made by {}; use "
                      "another input",
                      changeover::name(p), input.construction));
    }
    const std::unique_ptr<BlockSource> again = registry.build(input);
    CoverOptions options;
    options.new_elements = w;
    std::optional<UnchangedCover> found = find_cover(read_all(*again), options);
    if (!found) {
      throw BadInput(
          fmt::format("no unchanged subsets cover {} as made by {} for w = {}; use "
                      "another input or a smaller w",
                      changeover::name(p), input.construction, w));
    }
    return *std::move(found);
  }

  // The unchanged cover of a partial expansion of a cyclic design by an even number of elements.
  static std::optional<UnchangedCover> cover_for_one_more(const Recipe& input, std::uint64_t w,
                                                          std::optional<std::uint64_t> b,
                                                          const Registry& registry) {
    if (input.construction != own_name || w != 1 || !b || input.inputs.empty()) {
      return std::nullopt;
    }
    const Recipe& smallest = input.inputs.front();
    const Parameters& p = smallest.parameters;
    const Known* known = known_family(smallest);
    if (known == nullptr || known->family != Family::interval || p.v > largest_v) {
      return std::nullopt;
    }
    const std::uint64_t c = *registry.build(smallest)->block_count() / p.v;
    const std::uint64_t before = input.parameters.v - p.v;
    if (!interval_cover_for_one_more_size(p, c, before)) {
      return std::nullopt;
    }
    return interval_cover_for_one_more(p, c, before, points_of(smallest, registry));
  }

  // How many positions a recipe uses that names some, if no further ones are chosen.
  static std::optional<IntervalCoverSize> written_size(const Recipe& recipe) {
    const Parameters& p = recipe.inputs.front().parameters;
    const std::uint64_t named = recipe.blocks.front().size();
    const std::uint64_t w = recipe.parameters.v - p.v;
    return best_positions(p, named, std::numeric_limits<std::uint64_t>::max(), w) == named
               ? std::optional(IntervalCoverSize{named, false})
               : std::nullopt;
  }

  // The cover at the positions that the recipe names, and at further ones if w takes them.
  static UnchangedCover written_cover(const Recipe& recipe, const Design& design) {
    const std::uint64_t w = recipe.parameters.v - design.v();
    std::optional<UnchangedCover> cover = cover_at(design, recipe.blocks.front());
    if (!cover) {
      throw BadInput(fmt::format(
          "partial-expansion: the unchanged subsets at the named positions do not cover the {}; "
          "name others",
          changeover::name(design.parameters())));
    }
    const auto all = one_subset_a_position(design);
    const auto count = best_positions(design.parameters(), cover->subsets.size(), all.size(), w);
    if (!count || !add_positions(*cover, all, *count)) {
      throw BadInput(fmt::format("partial-expansion: {} {} more than {}; reduce w",
                                 count_of(w, "new element"), w == 1 ? "takes" : "take",
                                 count_of(all.size(), "position")));
    }
    return *std::move(cover);
  }

  void require_fit(const Recipe& recipe) const {
    Recipe bare = recipe;
    bare.blocks.clear();
    const std::uint64_t w = number(bare);
    if (recipe.blocks.size() > 1 || (recipe.blocks.size() == 1 && recipe.blocks.front().empty())) {
      throw BadInput("partial-expansion takes one list of positions, or none; remove the others");
    }
    try {
      (void)least_positions(recipe.inputs.front().parameters, w);
    } catch (const ImpossibleParameters& fault) {
      throw BadInput(fmt::format("partial-expansion: {}", fault.what()));
    }
  }

 protected:
  std::uint64_t number_between(const Parameters& small, const Parameters& large) const override {
    return small.v < large.v && large.k <= small.v && small.k == large.k &&
                   small.change == large.change
               ? large.v - small.v
               : 0;
  }
  Recipe with(const Recipe& input, std::uint64_t w) const override {
    return recipe_of(input.parameters.on(input.parameters.v + w),
                     {{"w", static_cast<std::int64_t>(w)}}, {input});
  }
  std::string_view needs() const override {
    return "with fewer elements and otherwise the same parameters";
  }
};

// Limit of the search for a cover, in nodes; a plan makes thousands of searches.
constexpr std::uint64_t cover_nodes = 200;
constexpr std::uint64_t most_elements_covered = 2000;

}  // namespace

const Construction& construction() { return only<PartialExpander>(); }

}  // namespace changeover::partial_expansion_entry

namespace changeover {

std::optional<CoverPositions> cover_positions(const Design& design) {
  const Parameters& p = design.parameters();
  if (p.strength != 2 || p.change >= p.k || p.v > partial_expansion_entry::most_elements_covered ||
      p.v <= p.k || (p.kind == Kind::circular && design.block_count() < 2)) {
    return std::nullopt;
  }
  CoverOptions options;
  options.new_elements = p.change;  // then nothing is left out
  options.limits.nodes = partial_expansion_entry::cover_nodes;
  const std::optional<UnchangedCover> cover = find_cover(design, options);
  if (!cover) {
    return std::nullopt;
  }
  CoverPositions result;
  for (const UnchangedSubset& subset : cover->subsets) {
    result.positions.push_back(static_cast<Element>(subset.position));
  }
  result.available = design.block_count() + (p.kind == Kind::linear ? 1 : 0);
  return result;
}

bool new_elements_fit(const Parameters& p, std::uint64_t w) {
  return p.strength == 2 && w > 0 && p.change < p.k && (p.change < 3 || w <= p.change) &&
         w <= std::numeric_limits<std::uint32_t>::max() - p.v &&
         (w >= p.change || p.v >= p.k + 2 * p.change - w);
}

std::optional<std::uint64_t> partial_expansion_count(const Parameters& p, std::uint64_t b,
                                                     const CoverPositions& cover, std::uint64_t w) {
  const auto count = best_positions(p, cover.positions.size(), cover.available, w);
  return count ? std::optional(checked_add(b, blocks_added(p, *count, w))) : std::nullopt;
}

Recipe partial_expansion_recipe(const Recipe& input, const CoverPositions& cover, std::uint64_t w) {
  return {std::string(partial_expansion_entry::own_name),
          input.parameters.on(checked_add(input.parameters.v, w)),
          {{"w", static_cast<std::int64_t>(w)}},
          {input},
          {cover.positions}};
}

}  // namespace changeover
