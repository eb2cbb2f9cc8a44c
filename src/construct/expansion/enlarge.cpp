#include "changeover/construct/expansion.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t nodes_for_covers = 200'000;

// Finds an expansion set with an odd number of members; nullopt if there is none.
std::optional<ExpansionSet> odd_expansion_set(const Design& design, const EnlargeOptions& options) {
  if (design.parameters().change != 2) {
    return std::nullopt;
  }
  const std::uint64_t which = options.set.value_or(1);
  ExpansionSearch search =
      find_expansion_sets(design, {.how_many = which, .limits = options.limits});
  if (search.sets.size() < which) {
    if (!options.set) {
      return std::nullopt;
    }
    const std::size_t there = search.sets.size();
    throw MissingResource(
        fmt::format("{} expansion {}: {}", there == 0 ? "no" : fmt::format("only {}", there),
                    there < 2 ? "set" : "sets",
                    !search.complete        ? "the search stopped at its limit; allow more"
                    : search.reason.empty() ? "every exact cover was tried; give a smaller number"
                                            : search.reason));
  }
  ExpansionSet& set = search.sets[static_cast<std::size_t>(which - 1)];
  return set.size() % 2 == 0 ? std::nullopt : std::optional(std::move(set));
}

// The largest number below `end` that can be inserted.
std::optional<std::uint64_t> most_new_elements(const Design& design, std::uint64_t end,
                                               const CoverOptions& cover) {
  for (std::uint64_t w = end; w-- > 1;) {
    if (best_new_elements(design, w, w, cover)) {
      return w;
    }
  }
  return std::nullopt;
}

Enlarged by_cover(const Design& design, const EnlargeOptions& options) {
  if (design.k() == design.parameters().change) {
    throw MissingResource(
        "no new elements can be inserted: k = m, so unchanged subsets are "
        "empty; use a design with m < k");
  }
  const std::uint64_t w = options.new_elements.value_or(0);
  CoverOptions cover;
  cover.limits = options.limits;
  cover.limits.nodes = options.limits.nodes.value_or(nodes_for_covers);
  const std::uint64_t most = 2 * design.k() + 2;
  const auto best =
      w == 0 ? best_new_elements(design, 1, most, cover) : best_new_elements(design, w, w, cover);
  if (!best) {
    const auto fewer = most_new_elements(design, std::min(w, most + 1), cover);
    throw MissingResource(fmt::format(
        "{} cannot be inserted: too few unchanged subsets, or they leave an element out; {}",
        w == 0 ? "new elements" : count_of(w, "new element"),
        fewer ? fmt::format("at most {} can be", *fewer) : "use another design"));
  }
  return {.design = expand_by(design, best->cover, best->w, options.factorization),
          .at = best->cover.subsets,
          .new_elements = best->w};
}

}  // namespace

Enlarged enlarge(const Design& design, const EnlargeOptions& options) {
  if (options.set == 0) {
    throw BadInput("expansion sets are counted from 1; give 1 or more");
  }
  if (options.set && options.new_elements) {
    throw BadInput("name an expansion set or a number of new elements, not both");
  }
  if (!options.new_elements) {
    if (auto set = odd_expansion_set(design, options)) {
      const auto order = static_cast<std::uint32_t>(set->size() + 1);
      Design larger = expand(design, *set, one_factorization(order, options.factorization));
      return {.design = std::move(larger),
              .at = std::move(*set),
              .new_elements = order,
              .by_expansion_set = true};
    }
    if (options.set) {
      throw MissingResource(
          fmt::format("no expansion set serves: {}; ask for a number of new elements",
                      design.parameters().change == 2 ? "each has an even number of members"
                                                      : "the recursion is for change number 2"));
    }
  }
  return by_cover(design, options);
}

}  // namespace changeover
