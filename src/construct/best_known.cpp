#include <fmt/format.h>

#include <memory>
#include <optional>
#include <utility>

#include "changeover/construct/best_known.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "construct/known_designs.hpp"
#include "core/checked.hpp"

namespace changeover {
std::string KnownCell::status() const {
  if (impossible) {
    return "impossible";
  }
  if (!best) {
    return "open";
  }
  return best->b == bound.blocks ? "minimum" : "best-known";
}

BestKnownTable::BestKnownTable(const Registry& registry, const CellRange& range, Stored stored)
    : range_(range) {
  KnownDesigns known(registry, stored);
  for (const Kind kind : {Kind::circular, Kind::linear}) {
    if (range.kind && *range.kind != kind) {
      continue;
    }
    for (std::uint64_t k = range.k_from; k <= range.k_to; ++k) {
      for (std::uint64_t v = range.v_from; v <= range.v_to; ++v) {
        stop_if_asked();
        KnownCell cell;
        cell.parameters = {.v = v, .k = k, .change = range.change, .kind = kind};
        if (v < k) {
          cell.impossible = "a block has at most v elements";
        } else if (range.change > k) {
          cell.impossible = "a block has at least m elements";
        } else {
          cell.impossible = impossibility(cell.parameters);
        }
        cells_.push_back(std::move(cell));
      }
    }
  }
  std::uint64_t answered = 0;
  for (KnownCell& cell : cells_) {
    if (!cell.impossible) {
      cell.bound = known.bound(cell.parameters);
      cell.best = known.best(cell.parameters);
    }
    ++answered;
    if (progress_due()) {
      report_progress({.phase = fmt::format("looking for the best of {} cells", cells_.size()),
                       .steps = answered,
                       .unit = "cells"});
    }
  }
}

std::optional<std::size_t> BestKnownTable::index(const Parameters& p) const {
  if (p.v < range_.v_from || p.v > range_.v_to || p.k < range_.k_from || p.k > range_.k_to ||
      p.change != range_.change || p.strength != 2 || (range_.kind && *range_.kind != p.kind)) {
    return std::nullopt;
  }
  const std::uint64_t vs = range_.v_to - range_.v_from + 1;
  const std::uint64_t ks = range_.k_to - range_.k_from + 1;
  const std::uint64_t kind = range_.kind || p.kind == Kind::circular ? 0 : 1;
  return static_cast<std::size_t>((kind * ks + (p.k - range_.k_from)) * vs + (p.v - range_.v_from));
}

const KnownCell& BestKnownTable::at(const Parameters& p) const {
  const auto at = index(p);
  if (!at) {
    throw BadInput(fmt::format("{} is outside the range", name(p)));
  }
  return cells_[*at];
}

BestKnownTable best_known_table(const Registry& registry, const CellRange& range, Stored stored) {
  if (range.v_from > range.v_to || range.k_from > range.k_to || range.k_from < 2) {
    throw ImpossibleParameters(fmt::format("the range v = {}..{}, k = {}..{} is empty or has k < 2",
                                           range.v_from, range.v_to, range.k_from, range.k_to));
  }
  if (range.v_to > largest_v_of_a_range) {
    throw ImpossibleParameters(fmt::format("v = {} exceeds {}, the most that is looked at at once",
                                           range.v_to, largest_v_of_a_range));
  }
  if (range.change < 1) {
    throw ImpossibleParameters("change = 0: consecutive blocks must differ in at least 1 element");
  }
  if (range.k_to - range.k_from >= most_cells_of_a_range / 2 / (range.v_to - range.v_from + 1)) {
    throw ImpossibleParameters(
        fmt::format("the range has more than {} cells; give a smaller one", most_cells_of_a_range));
  }
  return {registry, range, stored};
}

std::optional<Offer> best_known(const Registry& registry, const Parameters& p) {
  return KnownDesigns(registry).best(p);
}

VerifiedDesign built_design(const Offer& offer) {
  const Registry& registry = Registry::standard();
  const Parameters& p = offer.recipe.parameters;
  require_memory(checked_multiply(checked_multiply(offer.b, p.k), sizeof(Element)),
                 "the best design that is known, the " + name(p) + ",");
  const std::unique_ptr<BlockSource> blocks = registry.build(offer.recipe);
  Design design(p);
  design.reserve(static_cast<std::size_t>(offer.b));
  Block block(static_cast<std::size_t>(p.k));
  while (blocks->next(block)) {
    stop_if_asked();
    design.append(block);
  }
  design.set_labels(registry.construction_of(offer.recipe).labels(offer.recipe, registry));
  design.recipe = offer.recipe;
  return surely_verified(std::move(design), "the best recipe for the " + name(p));
}

std::optional<VerifiedDesign> best_known_design(const Parameters& p) {
  const auto best = best_known(Registry::standard(), p);
  return best ? std::optional(built_design(*best)) : std::nullopt;
}

std::optional<Offer> best_offer(const Registry& registry, std::span<const Parameters> asked,
                                const Construction* only) {
  std::optional<Offer> best;
  for (const Parameters& p : asked) {
    std::optional<Offer> offer = only != nullptr    ? only->offer(p, registry)
                                 : impossibility(p) ? std::nullopt
                                                    : best_known(registry, p);
    if (offer && (!best || offer->b < best->b)) {
      best = std::move(offer);
    }
  }
  return best;
}

RecipeNode explained(const Registry& registry, const Recipe& recipe) {
  const Construction& construction = registry.construction_of(recipe);
  RecipeNode node{.construction = &construction,
                  .parameters = recipe.parameters,
                  .b = registry.build(recipe)->block_count(),
                  .explanation = construction.explain(recipe),
                  .citation = construction.citation().to_string(),
                  .inputs = {}};
  for (const Recipe& input : recipe.inputs) {
    node.inputs.push_back(explained(registry, input));
  }
  return node;
}

}  // namespace changeover
