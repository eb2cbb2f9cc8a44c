#include "changeover/construct/registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "bounds/counting_bound.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "construct/trusted_entry.hpp"

namespace changeover {
namespace {

bool nested_deeper(const Recipe& recipe, std::size_t depth) {
  return depth == 0 || std::ranges::any_of(recipe.inputs, [&](const Recipe& in) {
           return nested_deeper(in, depth - 1);
         });
}

// Whether check() would accept p, without the cost of an exception.
bool can_be_written_down(const Parameters& p) {
  return p.k >= 1 && p.k <= p.v && p.v <= std::numeric_limits<std::uint32_t>::max() &&
         p.change <= p.k && p.strength <= p.k;
}

}  // namespace

std::string Citation::to_string() const {
  if (key.empty()) {
    return place.empty() ? "[elementary]" : fmt::format("[{}]", place);
  }
  return place.empty() ? fmt::format("[{}]", key) : fmt::format("[{}, {}]", key, place);
}

std::optional<std::vector<UnchangedSubset>> Construction::expansion_set(const Recipe&,
                                                                        const Registry&) const {
  return std::nullopt;
}

std::optional<BaseBlocks> Construction::base_blocks(const Recipe&) const { return std::nullopt; }

std::optional<OrbitBaseBlocks> Construction::orbit_base_blocks(const Recipe&) const {
  return std::nullopt;
}

std::optional<IntervalBaseBlocks> Construction::interval_base_blocks(const Recipe&) const {
  return std::nullopt;
}

std::unique_ptr<FanSource> Construction::fans(const Recipe&, const Registry&) const {
  return nullptr;
}

std::string Construction::explain(const Recipe&) const { return std::string(summary()); }

std::vector<std::string> Construction::labels(const Recipe&, const Registry&) const { return {}; }

const Registry& Registry::standard() {
  static const Registry registry(registry_entries(), &standard_catalog());
  return registry;
}

Registry::Registry(std::vector<const Construction*> constructions, const Catalog* catalog)
    : constructions_(std::move(constructions)), catalog_(catalog) {
  std::ranges::sort(constructions_,
                    [](const auto* a, const auto* b) { return a->name() < b->name(); });
  const auto twin = std::ranges::adjacent_find(
      constructions_, [](const auto* a, const auto* b) { return a->name() == b->name(); });
  if (twin != constructions_.end()) {
    throw BadInput(fmt::format("two constructions are named '{}'", (*twin)->name()));
  }
}

const Construction* Registry::find(std::string_view name) const {
  const auto place = std::lower_bound(
      constructions_.begin(), constructions_.end(), name,
      [](const auto* construction, auto key) { return construction->name() < key; });
  return place != constructions_.end() && (*place)->name() == name ? *place : nullptr;
}

const Construction& Registry::construction_of(const Recipe& recipe) const {
  if (nested_deeper(recipe, max_recipe_depth)) {
    throw BadInput(fmt::format("the recipe is nested deeper than {}", max_recipe_depth));
  }
  if (const Construction* construction = find(recipe.construction)) {
    return *construction;
  }
  throw BadInput(fmt::format("no construction is named '{}'; changeover constructions lists them",
                             recipe.construction));
}

std::vector<Offer> Registry::offers(const Parameters& p) const {
  if (impossibility(p)) {
    return {};
  }
  std::vector<Offer> offers;
  for (const Construction* construction : constructions_) {
    if (std::optional<Offer> offer = construction->offer(p, *this)) {
      offers.push_back(*std::move(offer));
    }
  }
  // Among equal offers, designs that are written down come last: the others say how they are made.
  std::ranges::stable_sort(offers, [](const Offer& a, const Offer& b) {
    const auto rank = [](const Offer& offer) {
      return std::pair(offer.b, offer.recipe.construction == "found");
    };
    return rank(a) < rank(b);
  });
  if (catalog_ != nullptr) {
    // Designs that carry their blocks are offered by "found" already.
    for (auto known = catalog_->fewest(p); known && (offers.empty() || known->b < offers.front().b);
         known = catalog_->fewest(p)) {
      if (auto entry = trusted_entry(*catalog_, known->label)) {
        Offer offer{std::move(entry->recipe), entry->b, false, false, false};
        offer.economical = offer.b == counting_bound(p);
        offers.insert(offers.begin(), std::move(offer));
      }
    }
  }
  return offers;
}

std::optional<Offer> Registry::best(const Parameters& p) const {
  std::vector<Offer> all = offers(p);
  return all.empty() ? std::nullopt : std::optional<Offer>(std::move(all.front()));
}

std::unique_ptr<BlockSource> Registry::build(const Recipe& recipe) const {
  return construction_of(recipe).build(recipe, *this);
}

std::unique_ptr<FanSource> Registry::fans(const Recipe& recipe) const {
  if (auto fans = construction_of(recipe).fans(recipe, *this)) {
    return fans;
  }
  return fans_of(build(recipe));
}

Design Registry::build_design(const Recipe& recipe) const {
  const Construction& construction = construction_of(recipe);
  const std::unique_ptr<BlockSource> source = construction.build(recipe, *this);
  Design design = read_within_memory(*source);
  design.set_labels(construction.labels(recipe, *this));
  design.recipe = recipe;
  return design;
}

std::vector<Offer> Registry::nearest(const Parameters& p, std::size_t limit,
                                     std::uint64_t radius) const {
  check(p);
  radius = std::min<std::uint64_t>(radius, std::numeric_limits<std::uint32_t>::max());
  std::vector<Offer> found;
  // Rings of growing distance; in each, v′ from the smallest. Sums stay below 2³⁴.
  for (std::uint64_t distance = 0; distance <= 2 * radius && found.size() < limit; ++distance) {
    const std::uint64_t reach = std::min(distance, radius);
    for (std::uint64_t v = p.v > reach ? p.v - reach : 0; v <= p.v + reach && found.size() < limit;
         ++v) {
      const std::uint64_t rest = distance - (v > p.v ? v - p.v : p.v - v);
      if (rest > radius) {
        continue;
      }
      for (const bool above : {false, true}) {
        if ((above && rest == 0) || (!above && rest > p.k) || found.size() == limit) {
          continue;
        }
        Parameters near = p.on(v);
        near.k = above ? p.k + rest : p.k - rest;
        if (!can_be_written_down(near)) {
          continue;
        }
        stop_if_asked();
        if (std::optional<Offer> offer = best(near)) {
          found.push_back(*std::move(offer));
        }
      }
    }
  }
  return found;
}

}  // namespace changeover
