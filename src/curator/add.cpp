#include "changeover/curator/curator.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/isomorphism/isomorphism.hpp"
#include "changeover/verify/verdict.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

std::string defect_of(const Verdict& verdict) {
  const Parameters& p = verdict.parameters;
  if (verdict.b == 0) {
    return "there is no block; give at least one";
  }
  if (verdict.bad_steps > 0) {
    const BadStep& first = verdict.bad_step_examples.front();
    return fmt::format(
        "{} of the steps {} not change exactly {}, the first from block {} to block {}; correct "
        "them",
        verdict.bad_steps, verdict.bad_steps == 1 ? "does" : "do", count_of(p.change, "element"),
        first.from, first.to);
  }
  return fmt::format(
      "{} of {} {} {} in no block, e.g. {{{}}}; add blocks that cover them", verdict.uncovered,
      verdict.subsets, p.strength == 2 ? "pairs" : fmt::format("{}-subsets", p.strength),
      verdict.uncovered == 1 ? "is" : "are", fmt::join(verdict.uncovered_examples.front(), ","));
}

// Whether every copy of the program can build it.
bool names_only_shipped(const Recipe& recipe) {
  if (recipe.construction == "found" && recipe.inputs.empty() &&
      !standard_catalog().is_shipped(recipe.provenance)) {
    return false;
  }
  return std::ranges::all_of(recipe.inputs, names_only_shipped);
}

// Whether a recipe makes these blocks; reads no more blocks than these from it.
bool makes(const Recipe& recipe, const Design& design) {
  if (recipe.parameters != design.parameters()) {
    return false;
  }
  try {
    const auto source = Registry::standard().build(recipe);
    Block block(design.k());
    for (std::size_t i = 0; i < design.block_count(); ++i) {
      if (!source->next(block) || !std::ranges::equal(block, design.block(i))) {
        return false;
      }
    }
    return !source->next(block);
  } catch (const InternalError&) {
    throw;
  } catch (const Error&) {
    return false;  // A recipe of a newer program, or of none.
  }
}

// "changeover 0.1.0: search 9 4 …" is a program and a command.
void credit_provenance(const std::string& provenance, Credit& credit) {
  constexpr std::string_view program = "changeover ";
  const std::size_t colon = provenance.find(": ");
  if (provenance.starts_with(program) && colon != std::string::npos) {
    credit.program = provenance.substr(0, colon);
    credit.command = std::string(program) + provenance.substr(colon + 2);
  } else if (credit.command.empty()) {
    credit.command = provenance;
  }
}

// Equal for all designs that are the same.
Checksum form_of(const CatalogEntry& entry) {
  const Design design = Registry::standard().build_design(entry.recipe);
  const CanonicalForm form = canonical_form(design, {.rotation = true, .reversal = true});
  DesignSource blocks(form.design);
  return design_digest(blocks).checksum;
}

bool is_small(const CatalogEntry& entry) {
  return entry.parameters.v <= largest_compared && entry.b <= largest_compared;
}

}  // namespace

Newcomer newcomer_of(const Design& design, const Introduction& introduction) {
  const Verdict verdict = verify(design);
  if (!verdict.valid()) {
    return {{}, defect_of(verdict)};
  }
  const Bound bound = lower_bound(design.parameters());
  if (bound.blocks > verdict.b) {
    throw InternalError(fmt::format("a valid {} has {} blocks, fewer than the bound {}: {}",
                                    name(design.parameters()), verdict.b, bound.blocks,
                                    bound.reason));
  }
  CatalogEntry entry;
  entry.parameters = design.parameters();
  entry.b = verdict.b;
  entry.lower_bound = bound.blocks;
  entry.reason = bound.reason;
  entry.credit = introduction.credit;
  entry.cites = introduction.cites;
  entry.note = introduction.note;
  DesignSource blocks(design);
  entry.checksum = design_digest(blocks).checksum;
  if (design.recipe) {
    credit_provenance(design.recipe->provenance, entry.credit);
  }
  if (design.recipe && design.recipe->construction != "found" &&
      names_only_shipped(*design.recipe) && makes(*design.recipe, design)) {
    entry.recipe = *design.recipe;
    if (entry.carries_blocks()) {
      entry.recipe.provenance.clear();  // The credit has it.
    }
  } else {
    entry.recipe = literal_recipe(design);
  }
  // Refuses entries that could not be read again.
  const std::string line = line_of(entry, {});
  if (entry_from_line(line, "the design", 1, {}) != entry) {
    throw BadInput(
        "the credit or note of the design has unprintable characters; write one plain line");
  }
  return {std::move(entry), ""};
}

SameDesigns::Class& SameDesigns::class_of(const CatalogEntry& entry) {
  const auto [place, is_new] = classes_.try_emplace({entry.parameters, entry.b});
  if (is_new) {
    std::vector<CatalogEntry>& waiting = place->second.waiting;
    waiting = catalog_->cell(entry.parameters);
    std::erase_if(waiting, [&](const CatalogEntry& other) { return other.b != entry.b; });
    std::ranges::reverse(waiting);
  }
  return place->second;
}

std::optional<std::string> SameDesigns::find(const CatalogEntry& entry) {
  if (!is_small(entry)) {
    return std::nullopt;
  }
  Class& known = class_of(entry);
  if (known.waiting.empty() && known.by_form.empty()) {
    return std::nullopt;
  }
  const Checksum wanted = form_of(entry);
  const std::string label = entry.label();
  for (;;) {
    for (const std::string& other : known.by_form[wanted]) {
      if (other != label) {
        return other;
      }
    }
    if (known.waiting.empty()) {
      return std::nullopt;
    }
    const CatalogEntry other = std::move(known.waiting.back());
    known.waiting.pop_back();
    try {
      put(known, other);
    } catch (const InternalError&) {
      throw;
    } catch (const Error&) {
      continue;  // A damaged entry is the same as no design.
    }
  }
}

void SameDesigns::remember(const CatalogEntry& entry) {
  if (is_small(entry)) {
    put(class_of(entry), entry);
  }
}

void SameDesigns::put(Class& known, const CatalogEntry& entry) {
  // If there are two labels, at least one is not that of the given design.
  if (auto& labels = known.by_form[form_of(entry)]; labels.size() < 2) {
    labels.push_back(entry.label());
  }
}

std::optional<std::string> same_in_catalog(const Catalog& catalog, const CatalogEntry& entry) {
  return SameDesigns(catalog).find(entry);
}

std::vector<Gain> gains_of(const CatalogEntry& entry) {
  std::vector<Gain> gains;
  if (!is_small(entry) || entry.parameters.strength != 2) {
    return gains;
  }
  const Registry& registry = Registry::standard();
  const Design design = registry.build_design(entry.recipe);
  const auto weigh = [&](const char* rule, const Recipe& recipe) {
    const auto offer = best_known(registry, recipe.parameters);
    const auto blocks = registry.build(recipe);
    const Verdict verdict = verify(*blocks);
    if (!verdict.valid()) {
      throw InternalError(fmt::format("{} of {} is not a design", rule, entry.label()));
    }
    if (!offer || verdict.b < offer->b) {
      gains.push_back(
          {rule, verdict.parameters, verdict.b, offer ? std::optional(offer->b) : std::nullopt});
    }
  };
  if (entry.parameters.kind == Kind::circular) {
    const Design cut = shortest_cut(design);
    weigh("cut", literal_recipe(cut));
  }
  weigh("fix", fix_recipe(entry.recipe, 1));
  for (std::uint64_t gone = 1;; ++gone) {
    const auto fewer = truncated(design, gone);
    if (!fewer || gone > 20) {
      break;
    }
    const std::size_t before = gains.size();
    weigh("truncate", literal_recipe(*fewer));
    if (gains.size() == before) {
      break;  // Later cells have better designs already.
    }
  }
  for (const std::uint64_t s : {2U, 3U}) {
    weigh("blow-up", blow_up_recipe(entry.recipe, s));
  }
  return gains;
}

}  // namespace changeover
