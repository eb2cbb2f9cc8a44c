#include "search/local/known_as_wanted.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "changeover/construct/best_known.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "changeover/verify/verdict.hpp"
#include "construct/entry.hpp"
#include "construct/tools/concatenation/pieces.hpp"
#include "construct/tools/exact_cover.hpp"
#include "core/sorted.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t most_nodes = 200'000;
constexpr std::uint64_t most_entries = std::uint64_t{1} << 22;  // of the blocks

/// The elements wanted in the first block, in the last and in both, as columns of an exact cover.
struct Ends {
  Block both, first, last;

  explicit Ends(const Wanted& wanted)
      : both(intersection(wanted.first, wanted.last)),
        first(difference(wanted.first, wanted.last)),
        last(difference(wanted.last, wanted.first)) {}

  [[nodiscard]] std::size_t size() const { return both.size() + first.size() + last.size(); }
};

/// What the row of an exact cover says.
struct Row {
  std::optional<std::size_t> position = {};  // an unchanged subset
  std::optional<Element> renumbered = {};    // the row's one element becomes this one
};

/// An exact cover of the elements of a design and of the elements wanted at its ends.
class Fitting {
 public:
  Fitting(const Design& design, const Wanted& wanted)
      : design_(design),
        v_(static_cast<std::uint32_t>(design.v())),
        cover_(v_ + static_cast<std::uint32_t>(Ends(wanted).size())) {
    const Ends ends(wanted);
    const std::size_t b = design.block_count();
    const Block in_both = intersection(design.block(0), design.block(b - 1));
    std::uint32_t column = v_;
    for (const auto& [names, from] :
         {std::pair(&ends.both, in_both),
          std::pair(&ends.first, Block(design.block(0).begin(), design.block(0).end())),
          std::pair(&ends.last, Block(design.block(b - 1).begin(), design.block(b - 1).end()))}) {
      for (const Element name : *names) {
        for (const Element x : from) {
          add({.renumbered = name}, {x, column});
        }
        ++column;
      }
    }
    if (!wanted.expansion_set) {
      for (Element x = 0; x < v_; ++x) {
        add({}, {x});
      }
      return;
    }
    const Parameters& p = design.parameters();
    for (const UnchangedSubset& subset : unchanged_subsets(design)) {
      if (subset.elements.size() == p.k - p.change && p.k > p.change) {
        add({.position = subset.position}, subset.elements);
      }
    }
  }

  [[nodiscard]] std::optional<AsWanted> fitted() const {
    const auto solution = cover_.first_solution({.nodes = most_nodes, .stop = [] {
                                                   stop_if_asked();
                                                   return false;
                                                 }});
    if (!solution.rows) {
      return std::nullopt;
    }
    constexpr Element none = ~Element{0};
    std::vector<Element> names(v_, none);
    std::vector<bool> used(v_, false);
    AsWanted result{Design(design_.parameters()), {}};
    for (const std::size_t i : *solution.rows) {
      if (rows_[i].position) {
        result.positions.push_back(*rows_[i].position);
      } else if (rows_[i].renumbered) {
        names[cover_.row(i).front()] = *rows_[i].renumbered;
        used[*rows_[i].renumbered] = true;
      }
    }
    Element next = 0;
    for (Element& name : names) {
      if (name == none) {
        while (used[next]) {
          ++next;
        }
        name = next++;
      }
    }
    result.design.reserve(design_.block_count());
    for (std::size_t i = 0; i < design_.block_count(); ++i) {
      Block block;
      for (const Element x : design_.block(i)) {
        block.push_back(names[x]);
      }
      result.design.append(block);
    }
    std::ranges::sort(result.positions);
    return result;
  }

 private:
  void add(const Row& row, const Block& columns) {
    cover_.add_row(columns);
    rows_.push_back(row);
  }

  const Design& design_;
  std::uint32_t v_;
  ExactCover cover_;
  std::vector<Row> rows_;
};

Design reversed(const Design& design) {
  Design result(design.parameters());
  result.reserve(design.block_count());
  for (std::size_t i = design.block_count(); i-- > 0;) {
    result.append(design.block(i));
  }
  return result;
}

// The recipes of designs that may have what is wanted, those with the fewest blocks first.
std::vector<Offer> known_recipes(const Parameters& p, bool expansion_set) {
  const Registry& registry = Registry::standard();
  std::vector<Offer> known;
  const auto add = [&known](std::optional<Offer> offer) {
    if (offer) {
      known.push_back(*std::move(offer));
    }
  };
  add(best_known(registry, p));
  if (expansion_set) {
    add(best_that_asks_none(p, Need::expansion_set, registry));
    for (const auto* pieces : {&open_pieces(), &copied_pieces()}) {
      for (const WrittenPiece& piece : *pieces) {
        if (Parameters{.v = piece.w, .k = piece.k, .change = 1} == p) {
          known.push_back({.recipe = written_recipe(piece), .b = piece.b});
        }
      }
    }
  }
  std::ranges::stable_sort(known, {}, &Offer::b);
  return known;
}

}  // namespace

std::optional<AsWanted> as_wanted(const Design& design, const Wanted& wanted) {
  if (design.block_count() == 0 || !wanted.contained.empty() ||
      design.elements().size() > most_entries) {
    return std::nullopt;
  }
  std::optional<AsWanted> found = Fitting(design, wanted).fitted();
  const bool ends_differ = wanted.first.size() + wanted.last.size() > 0;
  if (!found && ends_differ && design.parameters().kind == Kind::linear) {
    found = Fitting(reversed(design), wanted).fitted();
  }
  return found;
}

std::optional<AsWanted> known_as_wanted(const Parameters& p, const Wanted& wanted) {
  if (!wanted.contained.empty()) {
    return std::nullopt;
  }
  for (const Offer& offer : known_recipes(p, wanted.expansion_set)) {
    try {
      const Design design = built_design(offer).take();
      if (auto found = as_wanted(design, wanted)) {
        return found;
      }
    } catch (const MissingResource&) {
      continue;  // too large to be built
    }
  }
  return std::nullopt;
}

}  // namespace changeover
