// Finding expansion sets: the elements are the primary columns and the unchanged subsets the rows.
// In a linear design each end is a secondary column too, for only one of its subsets can be used.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "changeover/construct/expansion.hpp"
#include "changeover/core/error.hpp"
#include "construct/tools/exact_cover.hpp"
#include "core/checked.hpp"
#include "core/each.hpp"
#include "core/sorted.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t max_end_elements = std::uint64_t{1} << 22;

// Calls visit for every subset of `size` elements, in lexicographic order.
template <typename Visit>
void for_each_subset(const Block& from, std::size_t size, Visit&& visit) {
  std::vector<std::size_t> chosen(size);
  for (std::size_t i = 0; i < size; ++i) {
    chosen[i] = i;
  }
  Block subset(size);
  for (;;) {
    for (std::size_t i = 0; i < size; ++i) {
      subset[i] = from[chosen[i]];
    }
    visit(subset);
    std::size_t i = size;
    while (i > 0 && chosen[i - 1] == from.size() - size + i - 1) {
      --i;
    }
    if (i == 0) {
      return;
    }
    ++chosen[i - 1];
    for (std::size_t j = i; j < size; ++j) {
      chosen[j] = chosen[j - 1] + 1;
    }
  }
}

// Whether the choices at an end can be written down.
bool ends_fit(const Parameters& p) {
  try {
    return checked_multiply(binomial(p.k, p.change), p.k - p.change) <= max_end_elements;
  } catch (const ImpossibleParameters&) {
    return false;
  }
}

// The unchanged subsets that may serve, in order of position.
struct Candidates {
  std::vector<UnchangedSubset> subsets;
  bool all = true;  // false: the ends are left out
};

Candidates candidates(const Design& design) {
  const Parameters& p = design.parameters();
  const std::size_t b = design.block_count();
  const auto size = static_cast<std::size_t>(p.k - p.change);
  Candidates result;
  if (size == 0 || b == 0) {
    return result;
  }
  const bool ends = p.kind == Kind::linear;
  result.all = !ends || ends_fit(p);
  const auto add_end = [&](std::size_t position, std::size_t block) {
    if (ends && result.all) {
      for_each_subset(sorted(design.block(block)), size, [&](const Block& subset) {
        result.subsets.push_back({position, subset});
      });
    }
  };
  add_end(0, 0);
  for (UnchangedSubset& subset : unchanged_subsets(design)) {
    if (subset.elements.size() == size) {
      result.subsets.push_back(std::move(subset));
    }
  }
  add_end(b, b - 1);
  return result;
}

// The different candidates as rows, each with the places where it occurs. Two equal subsets exclude
// each other, so every cover or packing by rows stands for the product of their numbers of places.
class Rows {
 public:
  Rows(const Design& design, const Candidates& from)
      : candidates_(&from), cover_(static_cast<std::uint32_t>(design.v()), 2) {
    const auto v = static_cast<std::uint32_t>(design.v());
    const bool linear = design.parameters().kind == Kind::linear;
    std::map<Block, std::size_t> known;
    for (std::size_t i = 0; i < from.subsets.size(); ++i) {
      const auto& [position, elements] = from.subsets[i];
      Block columns = elements;
      if (linear && (position == 0 || position == design.block_count())) {
        columns.push_back(position == 0 ? v : v + 1);
      }
      const auto [row, is_new] = known.try_emplace(std::move(columns), places_.size());
      if (is_new) {
        cover_.add_row(row->first);
        places_.emplace_back();
      }
      places_[row->second].push_back(i);
    }
  }

  [[nodiscard]] const ExactCover& cover() const { return cover_; }

  [[nodiscard]] std::vector<std::uint64_t> multiplicities() const {
    return each_of<std::uint64_t>(places_, [&](const auto& places) { return places.size(); });
  }

  // What the rows stand for is handed to `visit`, one by one, until it returns false; whether it
  // never did.
  template <typename Visit>
  bool for_each_set(std::span<const std::size_t> rows, Visit&& visit) const {
    std::vector<std::size_t> turn(rows.size(), 0);
    for (;;) {
      ExpansionSet set;
      for (std::size_t i = 0; i < rows.size(); ++i) {
        set.push_back(candidates_->subsets[places_[rows[i]][turn[i]]]);
      }
      std::ranges::sort(set, [](const auto& x, const auto& y) { return x.position < y.position; });
      if (!visit(std::move(set))) {
        return false;
      }
      std::size_t i = 0;
      while (i < rows.size() && ++turn[i] == places_[rows[i]].size()) {
        turn[i++] = 0;
      }
      if (i == rows.size()) {
        return true;
      }
    }
  }

  // How many sets the rows stand for. @throws ImpossibleParameters if that does not fit in 64 bits.
  [[nodiscard]] std::uint64_t sets(std::span<const std::size_t> rows) const {
    std::uint64_t product = 1;
    for (const std::size_t row : rows) {
      product = checked_multiply(product, places_[row].size());
    }
    return product;
  }

 private:
  const Candidates* candidates_;
  ExactCover cover_;  // the last two columns are the ends of a linear design
  std::vector<std::vector<std::size_t>> places_;
};

// Why no expansion set exists, if that needs no search.
std::string simple_reason(const Design& design, const Candidates& from) {
  const Parameters& p = design.parameters();
  if (p.k == p.change) {
    return "k = m: unchanged subsets are empty";
  }
  if (p.v % (p.k - p.change) != 0) {
    return fmt::format("k - m = {} does not divide v = {}", p.k - p.change, p.v);
  }
  std::vector<bool> met(static_cast<std::size_t>(p.v), false);
  for (const UnchangedSubset& subset : from.subsets) {
    for (const Element x : subset.elements) {
      met[x] = true;
    }
  }
  const auto missed = std::ranges::find(met, false);
  if (from.all && missed != met.end()) {
    return fmt::format("element {} is in no unchanged subset",
                       design.label(static_cast<Element>(missed - met.begin())));
  }
  return {};
}

// Lists and counts, as if the rows were all that there is.
void list(const Rows& rows, const ExpansionSearchOptions& options, ExpansionSearch& result) {
  const auto visit_set = [&](ExpansionSet set) {
    result.sets.push_back(std::move(set));
    return result.sets.size() < options.how_many;
  };
  std::uint64_t seen = 0;
  bool countable = true;
  bool enough = options.how_many == 0;
  const ExactCover::Visit visit = [&](std::span<const std::size_t> solution) {
    if (options.count) {
      try {
        seen = checked_add(seen, rows.sets(solution));
      } catch (const ImpossibleParameters&) {
        countable = false;
      }
    }
    enough = enough || !rows.for_each_set(solution, visit_set);
    return !enough || (options.count && options.partial);
  };
  if (options.partial) {
    if (!enough || options.count) {
      result.complete = rows.cover().for_each_maximal_packing(visit, options.limits).outcome ==
                        SearchOutcome::complete;
    }
  } else {
    if (!enough) {
      result.complete =
          rows.cover().for_each_solution(visit, options.limits).outcome == SearchOutcome::complete;
    }
    if (enough && options.count) {  // again, and faster: nothing is written down
      const SolutionCount counted =
          rows.cover().count_solutions(rows.multiplicities(), options.limits);
      result.complete = counted.outcome == SearchOutcome::complete;
      seen = counted.value;
    }
  }
  if (options.count && result.complete && countable) {
    result.count = seen;
  }
}

}  // namespace

ExpansionSearch find_expansion_sets(const Design& design, const ExpansionSearchOptions& options) {
  ExpansionSearch result;
  const Candidates from = candidates(design);
  const std::string none = simple_reason(design, from);
  if (!none.empty() && !options.partial) {
    result.reason = none;
    result.complete = true;
    if (options.count) {
      result.count = 0;
    }
    return result;
  }
  if (!from.all) {
    result.reason =
        fmt::format("the C({},{}) choices at each end are too many: the ends were left out",
                    design.k(), design.parameters().change);
  }
  const Rows rows(design, from);
  list(rows, options, result);
  if (!from.all) {
    result.complete = false;
    result.count.reset();
  }
  return result;
}

PartialExpansion largest_partial_expansion_set(const Design& design, const SearchLimits& limits) {
  const Candidates from = candidates(design);
  const Rows rows(design, from);
  const LargestPacking packing = rows.cover().largest_packing(limits);
  PartialExpansion result;
  rows.for_each_set(packing.rows, [&](ExpansionSet set) {
    result.set = std::move(set);
    return false;
  });
  result.optimal = from.all && packing.optimal;
  return result;
}

}  // namespace changeover
