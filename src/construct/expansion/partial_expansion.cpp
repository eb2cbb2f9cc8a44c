// Counts, defects and the expansion itself.
//
// Why consecutive blocks differ in exactly m elements. All inserted blocks of a position contain
// its unchanged subset U, and so do the blocks before and after, B and B′, which have nothing else
// in common. So it is enough that the m other elements of consecutive blocks are disjoint.
//   w ≤ m   the one block's others are new, or old elements in neither B nor B′.
//   m = 2   the edges of a factor are disjoint from one another and, being new, from B and B′. With
//           w odd there is one more pair {x,y}, x new and in no edge, y old and not in U. It is
//           disjoint from the edges, of which there is at least one. If y is not in B the pair
//           comes first: its neighbours are B and an edge. If y is in B it is not in B′, and comes
//           last.
//   m = 1   elsewhere than at the sweep the others are distinct new elements.
// For the sweep see partial_expansion_sweep.cpp.
#include "changeover/construct/expansion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "changeover/core/error.hpp"
#include "construct/expansion/inserter.hpp"
#include "construct/expansion/partial_expansion_parts.hpp"
#include "core/checked.hpp"
#include "core/contains.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

void check_fit(const Parameters& p, std::uint64_t w) {
  check(p);
  const auto refuse = [](const std::string& why) { throw ImpossibleParameters(why); };
  if (p.strength != 2) {
    refuse(fmt::format("partial expansion is for strength 2, not for {}", name(p)));
  }
  if (w == 0) {
    refuse("partial expansion needs w >= 1 new elements");
  }
  if (p.change == p.k) {
    refuse("k = m: unchanged subsets are empty");
  }
  if (p.change >= 3 && w > p.change) {
    refuse(fmt::format("m = {} takes at most {} new elements, not {}", p.change, p.change, w));
  }
  if (w > std::numeric_limits<std::uint32_t>::max() - p.v) {
    refuse(fmt::format("v + w = {} + {} is too large; give fewer new elements", p.v, w));
  }
  if (w < p.change && p.v < p.k + 2 * p.change - w) {
    refuse(fmt::format("w = {} < m needs v >= k + 2m - w = {}: no other element fits", w,
                       p.k + 2 * p.change - w));
  }
}

// Near-1-factors: m = 2 and w odd, w > 1.
bool has_unmatched(const Parameters& p, std::uint64_t w) {
  return p.change == 2 && w > 2 && w % 2 != 0;
}

bool increase(const Block& elements) {
  return std::ranges::adjacent_find(elements, std::greater_equal<>()) == elements.end();
}

// Why some list of elements cannot come beside new ones.
std::optional<std::string> beside_defect(const Parameters& p, const UnchangedCover& cover,
                                         std::uint64_t w) {
  if (cover.beside.empty()) {
    return std::nullopt;
  }
  if (cover.beside.size() != cover.subsets.size()) {
    return fmt::format("{} but {} of what comes beside", count_of(cover.subsets.size(), "subset"),
                       count_of(cover.beside.size(), "list"));
  }
  const std::uint64_t most = beside_at_most(p, w);
  for (std::size_t i = 0; i < cover.beside.size(); ++i) {
    const Block& beside = cover.beside[i];
    const std::size_t position = cover.subsets[i].position;
    if (beside.size() > most) {
      return fmt::format("{} old elements beside new ones at position {}: at most {} can be",
                         beside.size(), position, most);
    }
    if (!increase(beside) || (!beside.empty() && beside.back() >= p.v)) {
      return fmt::format("the elements beside new ones at position {} do not increase below v = {}",
                         position, p.v);
    }
    if (!intersection(beside, cover.subsets[i].elements).empty()) {
      return fmt::format("an element is in the subset at position {} and beside it", position);
    }
  }
  return std::nullopt;
}

// Why the elements in no subset are not served.
std::optional<std::string> left_out_defect(const Parameters& p, const UnchangedCover& cover,
                                           std::uint64_t w) {
  const Block rest = left_out_elements(p.v, cover.subsets);
  if (rest.empty()) {
    return std::nullopt;
  }
  if (p.change == 1) {
    return rest.size() == 1 && w > 1
               ? std::nullopt
               : std::optional(fmt::format("element {} is in no subset of the cover", rest.back()));
  }
  // The unmatched element at the i-th position depends on i mod w; for w < m all of X is there.
  const std::uint64_t classes = has_unmatched(p, w) ? w : 1;
  for (const Element x : rest) {
    std::vector<bool> met(static_cast<std::size_t>(classes), false);
    for (std::size_t i = 0; i < cover.beside.size(); ++i) {
      if (contains(cover.beside[i], x)) {
        met[i % classes] = true;
      }
    }
    if (!std::ranges::all_of(met, [](bool once) { return once; })) {
      return fmt::format("element {} is in no subset of the cover, nor beside every new element",
                         x);
    }
  }
  return std::nullopt;
}

// What is wrong with the cover, whatever the blocks.
std::optional<std::string> cover_defect(const Parameters& p, const UnchangedCover& cover,
                                        std::uint64_t w) {
  const auto& subsets = cover.subsets;
  if (subsets.size() < least_positions(p, w)) {
    return fmt::format("{}: {} {} at least {}", count_of(subsets.size(), "subset"),
                       count_of(w, "new element"), w == 1 ? "takes" : "take",
                       count_of(least_positions(p, w), "position"));
  }
  for (std::size_t i = 0; i < subsets.size(); ++i) {
    const auto& [position, elements] = subsets[i];
    if (i > 0 && position <= subsets[i - 1].position) {
      return fmt::format("position {} follows position {}: positions must increase", position,
                         subsets[i - 1].position);
    }
    if (elements.size() != p.k - p.change) {
      return fmt::format("the subset at position {} has {}, not k - m = {}", position,
                         count_of(elements.size(), "element"), p.k - p.change);
    }
    if (!increase(elements) || elements.back() >= p.v) {
      return fmt::format("the elements of the subset at position {} do not increase below v = {}",
                         position, p.v);
    }
  }
  if (cover.sweep >= subsets.size()) {
    return fmt::format("the sweep is at subset {} of {}", cover.sweep + 1, subsets.size());
  }
  if (std::optional<std::string> defect = beside_defect(p, cover, w)) {
    return defect;
  }
  return left_out_defect(p, cover, w);
}

// Why the subset, with what comes beside, is not unchanged between two blocks; at the ends of a
// linear design one of them is missing.
std::optional<std::string> place_defect(const Parameters& p, const UnchangedSubset& subset,
                                        const Block* beside, std::span<const Element> before,
                                        std::span<const Element> after, std::uint64_t w) {
  if (!before.empty() && !holds_all(before, subset.elements)) {
    return fmt::format("the subset at position {0} is not in block {0}", subset.position);
  }
  if (!after.empty() && !holds_all(after, subset.elements)) {
    return fmt::format("the subset at position {} is not in the block after it", subset.position);
  }
  if (!before.empty() && !after.empty() &&
      intersection(before, after).size() != subset.elements.size()) {
    return fmt::format("the blocks at position {} do not differ in {}", subset.position,
                       count_of(p.change, "element"));
  }
  if (beside != nullptr && w < p.change &&
      !(intersection(*beside, before).empty() && intersection(*beside, after).empty())) {
    return fmt::format("an element beside new ones at position {} is in a block there",
                       subset.position);
  }
  return std::nullopt;
}

// The element that leaves at the sweep has to be the one that is left out (m = 1).
std::optional<std::string> sweep_defect(const UnchangedSubset& subset, Element left_out,
                                        std::span<const Element> before) {
  if (!before.empty() && difference(before, subset.elements) == Block{left_out}) {
    return std::nullopt;
  }
  return fmt::format("element {} is in no subset of the cover, nor does it leave at the sweep",
                     left_out);
}

class PartiallyExpandedSource final : public InsertingSource {
 public:
  PartiallyExpandedSource(std::unique_ptr<BlockSource> source, UnchangedCover cover,
                          std::uint64_t w, Factors factors)
      : PartiallyExpandedSource(source->parameters(), left_out_by(source->parameters(), cover), w,
                                std::move(source), std::move(cover), std::move(factors)) {}

 private:
  PartiallyExpandedSource(const Parameters& small, std::optional<Element> left_out, std::uint64_t w,
                          std::unique_ptr<BlockSource>&& source, UnchangedCover&& cover,
                          Factors&& factors)
      : InsertingSource(std::move(source), small.on(small.v + w),
                        {cover.subsets.size(),
                         blocks_added(small, cover.subsets.size(), w, left_out.has_value())}),
        small_(small),
        left_out_(left_out),
        w_(w),
        cover_(std::move(cover)),
        factors_(std::move(factors)),
        sweeps_(takes_sweep(small, cover_.subsets.size(), w)) {}

  // The element that is left out, m = 1.
  static std::optional<Element> left_out_by(const Parameters& p, const UnchangedCover& cover) {
    const Block rest = p.change == 1 ? left_out_elements(p.v, cover.subsets) : Block{};
    return rest.empty() ? std::nullopt : std::optional(rest.front());
  }

  [[nodiscard]] std::uint64_t position(std::uint64_t i) const override {
    return cover_.subsets[i].position;
  }

  [[nodiscard]] Insertion insertion(std::uint64_t index, const Place& place) override {
    const UnchangedSubset& subset = cover_.subsets[index];
    const Block* beside = cover_.beside.empty() ? nullptr : &cover_.beside[index];
    auto defect = subset.position == 0 && small_.kind == Kind::circular
                      ? std::optional(std::string("a circular design has no position 0"))
                      : place_defect(small_, subset, beside, place.before, place.after, w_);
    const bool is_sweep = index == cover_.sweep;
    if (!defect && left_out_ && is_sweep) {
      defect = sweep_defect(subset, *left_out_, place.before);
    }
    if (defect) {
      throw BadInput(fmt::format("not a cover by unchanged subsets: {}", *defect));
    }
    if (w_ <= small_.change) {
      return {subset.elements, all_new(subset.elements, beside, place)};
    }
    if (small_.change == 2) {
      return sweeps_ && is_sweep ? Insertion{{}, double_sweep(subset.elements, place)}
                                 : Insertion{subset.elements, factor(index, beside, place.before)};
    }
    return is_sweep ? Insertion{{}, sweep(subset.elements, left_out_, new_elements())}
                    : Insertion{subset.elements, new_elements()};
  }

  [[nodiscard]] Element new_element(std::uint64_t i) const {
    return static_cast<Element>(small_.v + i);
  }

  [[nodiscard]] Block new_elements() const {
    Block added(static_cast<std::size_t>(w_));
    std::iota(added.begin(), added.end(), new_element(0));
    return added;
  }

  // X and what comes beside.
  [[nodiscard]] Block all_new(const Block& kept, const Block* beside, const Place& place) const {
    Block others = new_elements();
    if (beside != nullptr) {
      others.insert(others.end(), beside->begin(), beside->end());
    }
    for (Element y = 0; others.size() < small_.change; ++y) {
      if (!contains(place.before, y) && !contains(place.after, y) && !contains(kept, y) &&
          !contains(others, y)) {
        others.push_back(y);
      }
    }
    return others;
  }

  // The edges of a 1-factor or near-1-factor.
  [[nodiscard]] Block factor(std::uint64_t index, const Block* beside,
                             std::span<const Element> before) const {
    const Block& kept = cover_.subsets[index].elements;
    Block edges;
    std::optional<Element> unmatched;
    for (const auto [a, b] : factors_(static_cast<std::uint32_t>(index % (w_ + w_ % 2 - 1)))) {
      if (b == w_) {
        unmatched = new_element(a);
      } else {
        edges.insert(edges.end(), {new_element(a), new_element(b)});
      }
    }
    if (unmatched) {
      Element y = 0;
      if (beside != nullptr && !beside->empty()) {
        y = beside->front();
      } else {
        while (contains(before, y) || contains(kept, y)) {
          ++y;
        }
      }
      edges.insert(contains(before, y) ? edges.end() : edges.begin(), {*unmatched, y});
    }
    return edges;
  }

  // With w odd an old element of neither block makes the number even.
  [[nodiscard]] Block double_sweep(const Block& kept, const Place& place) const {
    Block added = new_elements();
    for (Element y = 0; added.size() % 2 != 0; ++y) {
      if (!contains(place.before, y) && !contains(place.after, y)) {
        added.push_back(y);
      }
    }
    return changeover::double_sweep(kept, added);
  }

  Parameters small_;
  std::optional<Element> left_out_;
  std::uint64_t w_;
  UnchangedCover cover_;
  Factors factors_;
  bool sweeps_;
};

void throw_if(const std::optional<std::string>& defect) {
  if (defect) {
    throw BadInput(fmt::format("not a cover by unchanged subsets: {}", *defect));
  }
}

}  // namespace

std::uint64_t beside_at_most(const Parameters& p, std::uint64_t w) {
  return w < p.change ? p.change - w : has_unmatched(p, w) ? 1 : 0;
}

Block left_out_elements(std::uint64_t v, const std::vector<UnchangedSubset>& subsets) {
  std::vector<bool> met(static_cast<std::size_t>(v), false);
  for (const UnchangedSubset& subset : subsets) {
    for (const Element x : subset.elements) {
      met[x] = true;
    }
  }
  Block rest;
  for (std::size_t x = 0; x < met.size(); ++x) {
    if (!met[x]) {
      rest.push_back(static_cast<Element>(x));
    }
  }
  return rest;
}

std::uint64_t positions_for_factors(const Parameters& p, std::uint64_t w) {
  return p.change != 2 || w <= 2 ? 1 : w % 2 == 0 ? w - 1 : w;
}

bool takes_sweep(const Parameters& p, std::uint64_t subsets, std::uint64_t w) {
  return w > p.change && (p.change == 1 || subsets < positions_for_factors(p, w));
}

std::optional<std::uint64_t> best_positions(const Parameters& p, std::uint64_t subsets,
                                            std::uint64_t available, std::uint64_t w) {
  const std::uint64_t more = std::max(subsets, positions_for_factors(p, w));
  const bool few = least_positions(p, w) <= subsets;
  if (few && (more > available || blocks_added(p, subsets, w) <= blocks_added(p, more, w))) {
    return subsets;
  }
  return more <= available ? std::optional(more) : std::nullopt;
}

std::uint64_t least_positions(const Parameters& p, std::uint64_t w) {
  check_fit(p, w);
  const bool can_sweep = p.k >= 4 && (w % 2 == 0 || p.v >= p.k + 3);
  return can_sweep ? 1 : positions_for_factors(p, w);
}

std::uint64_t may_be_left_out(const Parameters& p, std::uint64_t subsets, std::uint64_t w) {
  check_fit(p, w);
  if (w < p.change) {
    return checked_multiply(p.change - w, subsets);
  }
  return has_unmatched(p, w) ? subsets / w : p.change == 1 && w > 1 ? 1 : 0;
}

std::uint64_t blocks_added(const Parameters& p, std::uint64_t subsets, std::uint64_t w,
                           bool left_out) {
  const std::uint64_t positions = std::max(subsets, least_positions(p, w));
  if (w <= p.change) {
    return positions;
  }
  const std::uint64_t at_each = p.change == 2 ? w / 2 + w % 2 : w;
  if (!takes_sweep(p, positions, w)) {
    return checked_multiply(positions, at_each);
  }
  const std::uint64_t kept = p.change == 2 ? p.k / 2 - 1 : p.k - 1;
  return checked_add(checked_multiply(positions - 1, at_each),
                     sweep_length(kept, at_each, left_out && p.change == 1));
}

std::optional<std::string> cover_defect(const Design& design, const UnchangedCover& cover,
                                        std::uint64_t w) {
  const Parameters& p = design.parameters();
  if (std::optional<std::string> defect = cover_defect(p, cover, w)) {
    return defect;
  }
  const std::size_t b = design.block_count();
  const bool circular = p.kind == Kind::circular;
  const Block rest = p.change == 1 ? left_out_elements(p.v, cover.subsets) : Block{};
  for (std::size_t i = 0; i < cover.subsets.size(); ++i) {
    const UnchangedSubset& subset = cover.subsets[i];
    const std::size_t position = subset.position;
    if (position > b || (circular && (position == 0 || b == 1))) {
      return fmt::format("the design has no position {}", position);
    }
    const auto before = position > 0 ? design.block(position - 1) : std::span<const Element>{};
    const auto after =
        position < b || circular ? design.block(position % b) : std::span<const Element>{};
    const Block* beside = cover.beside.empty() ? nullptr : &cover.beside[i];
    if (auto defect = place_defect(p, subset, beside, before, after, w)) {
      return defect;
    }
    if (!rest.empty() && i == cover.sweep) {
      if (auto defect = sweep_defect(subset, rest.front(), before)) {
        return defect;
      }
    }
  }
  return std::nullopt;
}

std::unique_ptr<BlockSource> expand_by(std::unique_ptr<BlockSource> source, UnchangedCover cover,
                                       std::uint64_t w, FactorizationKind kind) {
  throw_if(cover_defect(source->parameters(), cover, w));
  const auto order = static_cast<std::uint32_t>(w + w % 2);
  return expand_with(std::move(source), std::move(cover), w, [kind, order](std::uint32_t which) {
    return kind == FactorizationKind::circle ? circle_factor(order, which)
                                             : doubled_factor(order, which);
  });
}

std::unique_ptr<BlockSource> expand_with(std::unique_ptr<BlockSource> source, UnchangedCover cover,
                                         std::uint64_t w, Factors factors) {
  return std::make_unique<PartiallyExpandedSource>(std::move(source), std::move(cover), w,
                                                   std::move(factors));
}

Design expand_by(const Design& design, const UnchangedCover& cover, std::uint64_t w,
                 FactorizationKind kind) {
  UnchangedCover enough = cover;
  const std::uint64_t least = least_positions(design.parameters(), w);
  if (cover.subsets.size() < least) {
    enough.beside.clear();
    if (!add_positions(enough, one_subset_a_position(design), least)) {
      throw BadInput(fmt::format("{} {} at least {}: there are only {}", count_of(w, "new element"),
                                 w == 1 ? "takes" : "take", count_of(least, "position"),
                                 enough.subsets.size()));
    }
  }
  throw_if(cover_defect(design, enough, w));
  const auto source = expand_by(std::make_unique<DesignSource>(design), std::move(enough), w, kind);
  Design result = read_all(*source);
  result.set_labels(expanded_labels(design.labels(), w));
  return result;
}

}  // namespace changeover
