#include "changeover/construct/expansion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "changeover/core/error.hpp"
#include "construct/expansion/partial_expansion_parts.hpp"
#include "core/parsed.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

constexpr std::size_t no_part = std::numeric_limits<std::size_t>::max();

std::string element_name(const Design* design, Element x) {
  return design != nullptr ? design->label(x) : std::to_string(x);
}

// Why the set does not partition V into parts of k − m elements at increasing positions. The design
// only lends its labels and may be missing.
std::optional<std::string> shape_defect(const Parameters& p, const ExpansionSet& set,
                                        const Design* design) {
  for (std::size_t i = 1; i < set.size(); ++i) {
    if (set[i].position <= set[i - 1].position) {
      return fmt::format("position {} follows position {}: positions must increase",
                         set[i].position, set[i - 1].position);
    }
  }
  const std::uint64_t size = p.k - p.change;
  std::vector<std::size_t> part(static_cast<std::size_t>(p.v), no_part);
  for (std::size_t i = 0; i < set.size(); ++i) {
    const auto& [position, elements] = set[i];
    if (elements.size() != size) {
      return fmt::format("the subset at position {} has {}, not k - m = {}", position,
                         count_of(elements.size(), "element"), size);
    }
    for (std::size_t j = 0; j < elements.size(); ++j) {
      const Element x = elements[j];
      if (x >= p.v) {
        return fmt::format("the subset at position {} holds {}, which is not below v = {}",
                           position, x, p.v);
      }
      if (j > 0 && elements[j - 1] >= x) {
        return fmt::format("the elements of the subset at position {} do not increase", position);
      }
      if (part[x] != no_part) {
        return fmt::format("element {} is in the subsets at positions {} and {}",
                           element_name(design, x), set[part[x]].position, position);
      }
      part[x] = i;
    }
  }
  const auto missed = std::ranges::find(part, no_part);
  if (missed != part.end()) {
    return fmt::format("element {} is in no subset of the set",
                       element_name(design, static_cast<Element>(missed - part.begin())));
  }
  return std::nullopt;
}

// Whether Theorem 2 can be applied to parameters p with an expansion set of ℓ subsets.
void check_expanded(const Parameters& p, std::size_t subsets) {
  if (p.change != 2 || p.strength != 2) {
    throw ImpossibleParameters(
        fmt::format("expansion needs a double-change design of strength 2, not a {}", name(p)));
  }
  if (subsets % 2 == 0) {
    throw ImpossibleParameters(
        fmt::format("expansion needs an odd number of subsets, not {}: K_{} has no 1-factorization",
                    subsets, subsets + 1));
  }
  check(p.on(p.v + subsets + 1));  // at most 2p.v + 1
}

}  // namespace

std::optional<std::string> expansion_set_defect(const Design& design, const ExpansionSet& set) {
  const Parameters& p = design.parameters();
  if (p.k == p.change) {
    return "k = m: unchanged subsets are empty";
  }
  if (std::optional<std::string> defect = shape_defect(p, set, &design)) {
    return defect;
  }
  const std::size_t b = design.block_count();
  if (b == 0) {
    return "the design has no blocks";
  }
  const bool circular = p.kind == Kind::circular;
  for (const auto& [position, elements] : set) {
    if (circular && position == 0) {
      return fmt::format("a circular design has no position 0: before its first block is {}", b);
    }
    if (position > b) {
      return fmt::format("position {} is past the last block, {}", position, b);
    }
    if (!circular && (position == 0 || position == b)) {
      if (!holds_all(design.block(position == 0 ? 0 : b - 1), elements)) {
        return fmt::format("the subset at position {} is not in the {} block", position,
                           position == 0 ? "first" : "last");
      }
      continue;
    }
    const auto before = design.block(position - 1);
    const auto after = design.block(position % b);
    if (!holds_all(before, elements) || !holds_all(after, elements) ||
        intersection(before, after).size() != elements.size()) {
      return fmt::format("the subset at position {} is not what blocks {} and {} have in common",
                         position, position, position % b + 1);
    }
  }
  return std::nullopt;
}

std::vector<std::string> expanded_labels(std::vector<std::string> labels, std::uint64_t count) {
  if (labels.empty()) {
    return labels;
  }
  std::set<std::uint64_t> taken;  // numbers from v on that are labels
  for (const std::string& label : labels) {
    const auto number = parsed<std::uint64_t>(label);
    if (number && *number >= labels.size() && label.front() != '0') {
      taken.insert(*number);
    }
  }
  std::uint64_t start = labels.size();
  for (const std::uint64_t number : taken) {
    if (number - start < count) {
      start = number + 1;
    }
  }
  for (std::uint64_t i = 0; i < count; ++i) {
    labels.push_back(std::to_string(start + i));
  }
  return labels;
}

Design expand(const Design& design, const ExpansionSet& set,
              const OneFactorization& factorization) {
  check_expanded(design.parameters(), set.size());
  if (const auto defect = expansion_set_defect(design, set)) {
    throw BadInput(fmt::format("not an expansion set: {}", *defect));
  }
  if (factorization.order != set.size() + 1) {
    throw BadInput(fmt::format("{} unchanged subsets need a 1-factorization of K_{}, not of K_{}",
                               set.size(), set.size() + 1, factorization.order));
  }
  if (const auto defect = factorization_defect(factorization)) {
    throw BadInput(fmt::format("not a 1-factorization: {}", *defect));
  }
  const auto source =
      expand_with(std::make_unique<DesignSource>(design), {.subsets = set}, set.size() + 1,
                  [&](std::uint32_t i) { return factorization.factors[i]; });
  Design result = read_all(*source);
  result.set_labels(expanded_labels(design.labels(), set.size() + 1));
  return result;
}

std::unique_ptr<BlockSource> expand(std::unique_ptr<BlockSource> source, ExpansionSet set,
                                    FactorizationKind kind) {
  const Parameters& p = source->parameters();
  check_expanded(p, set.size());
  if (const auto defect = shape_defect(p, set, nullptr)) {
    throw BadInput(fmt::format("not an expansion set: {}", *defect));
  }
  const std::size_t order = set.size() + 1;
  return expand_by(std::move(source), {.subsets = std::move(set)}, order, kind);
}

}  // namespace changeover
