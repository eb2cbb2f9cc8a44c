#include "construct/expansion/single_change_expansion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "construct/expansion/inserter.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

Parameters parameters_after(Parameters p) {
  if (p.change != 1 || p.strength != 2) {
    throw ImpossibleParameters(fmt::format(
        "the v + 1 expansion needs a single-change design of strength 2, not a {}", name(p)));
  }
  ++p.v;
  check(p);
  return p;
}

// Why these are no subsets of k − 1 elements at increasing positions that cover V.
std::optional<std::string> set_defect(const Parameters& p, const ExpansionSet& set) {
  std::vector<bool> covered(static_cast<std::size_t>(p.v), false);
  for (std::size_t i = 0; i < set.size(); ++i) {
    const auto& [position, elements] = set[i];
    if (i > 0 && position <= set[i - 1].position) {
      return fmt::format("position {} follows position {}: positions must increase", position,
                         set[i - 1].position);
    }
    if (elements.size() != p.k - 1) {
      return fmt::format("the subset at position {} has {}, not k - 1 = {}", position,
                         count_of(elements.size(), "element"), p.k - 1);
    }
    for (std::size_t j = 0; j < elements.size(); ++j) {
      if (elements[j] >= p.v) {
        return fmt::format("the subset at position {} holds {}, which is not below v = {}",
                           position, elements[j], p.v);
      }
      if (j > 0 && elements[j - 1] >= elements[j]) {
        return fmt::format("the elements of the subset at position {} do not increase", position);
      }
      covered[elements[j]] = true;
    }
  }
  const auto missed = std::ranges::find(covered, false);
  if (missed != covered.end()) {
    return fmt::format("element {} is in no chosen subset", missed - covered.begin());
  }
  return std::nullopt;
}

// U ∪ {x} for each subset U, x being the new element.
class SingleChangeExpandedSource final : public InsertingSource {
 public:
  SingleChangeExpandedSource(std::unique_ptr<BlockSource> source, ExpansionSet set)
      : InsertingSource(std::move(source), parameters_after(source->parameters()),
                        {set.size(), set.size()}),
        set_(std::move(set)) {}

 private:
  [[nodiscard]] std::uint64_t position(std::uint64_t i) const override { return set_[i].position; }

  [[nodiscard]] Insertion insertion(std::uint64_t i, const Place&) override {
    return {set_[i].elements, {static_cast<Element>(parameters().v - 1)}};
  }

  ExpansionSet set_;
};

// The end block without the first element that the other subsets hold.
Block at_end(std::span<const Element> block, const ExpansionSet& others) {
  Block kept(block.begin(), block.end());
  std::ranges::sort(kept);
  const auto held = std::ranges::find_if(kept, [&others](Element x) {
    return std::ranges::any_of(others, [x](const UnchangedSubset& other) {
      return std::ranges::binary_search(other.elements, x);
    });
  });
  kept.erase(held == kept.end() ? kept.begin() : held);
  return kept;
}

}  // namespace

std::optional<std::string> single_change_expansion_defect(const Design& design,
                                                          const ExpansionSet& set) {
  const Parameters& p = design.parameters();
  if (p.change != 1 || p.strength != 2) {
    return fmt::format("a {} is not a single-change design of strength 2", name(p));
  }
  if (std::optional<std::string> defect = set_defect(p, set)) {
    return defect;
  }
  const std::size_t b = design.block_count();
  const bool circular = p.kind == Kind::circular;
  for (const auto& [position, elements] : set) {
    if (position > b || b == 0 || (circular && (position == 0 || b == 1))) {
      return fmt::format("there is no position {} in a {} design of {}", position,
                         to_string(p.kind), count_of(b, "block"));
    }
    if (!circular && (position == 0 || position == b)) {
      if (!holds_all(design.block(position == 0 ? 0 : b - 1), elements)) {
        return fmt::format("the subset at position {} is not in the {} block", position,
                           position == 0 ? "first" : "last");
      }
    } else if (!holds_all(design.block(position - 1), elements) ||
               !holds_all(design.block(position % b), elements)) {
      return fmt::format("the subset at position {} is not what blocks {} and {} have in common",
                         position, position, position % b + 1);
    }
  }
  return std::nullopt;
}

Design expand_single_change(const Design& design, const ExpansionSet& set) {
  (void)parameters_after(design.parameters());
  if (const auto defect = single_change_expansion_defect(design, set)) {
    throw BadInput(fmt::format("one element cannot be added: {}", *defect));
  }
  SingleChangeExpandedSource source(std::make_unique<DesignSource>(design), set);
  Design result = read_all(source);
  result.set_labels(expanded_labels(design.labels(), 1));
  return result;
}

Design expand_single_change(const Design& design, std::vector<std::size_t> positions) {
  const std::size_t b = design.block_count();
  const bool circular = design.parameters().kind == Kind::circular;
  std::ranges::sort(positions);
  ExpansionSet set;
  for (UnchangedSubset& subset : unchanged_subsets(design)) {
    if (std::ranges::binary_search(positions, subset.position)) {
      set.push_back(std::move(subset));
    }
  }
  for (const std::size_t end : {std::size_t{0}, b}) {
    if (!circular && b > 0 && std::ranges::binary_search(positions, end)) {
      Block kept = at_end(design.block(end == 0 ? 0 : b - 1), set);
      set.insert(end == 0 ? set.begin() : set.end(), UnchangedSubset{end, std::move(kept)});
    }
  }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (i == set.size() || set[i].position != positions[i]) {
      throw BadInput(fmt::format("one element cannot be added: there is no position {}{}",
                                 positions[i],
                                 i > 0 && positions[i] == positions[i - 1] ? " twice" : ""));
    }
  }
  return expand_single_change(design, set);
}

std::unique_ptr<BlockSource> expand_single_change(std::unique_ptr<BlockSource> source,
                                                  ExpansionSet set) {
  (void)parameters_after(source->parameters());
  if (const auto defect = set_defect(source->parameters(), set)) {
    throw BadInput(fmt::format("one element cannot be added: {}", *defect));
  }
  return std::make_unique<SingleChangeExpandedSource>(std::move(source), std::move(set));
}

}  // namespace changeover
