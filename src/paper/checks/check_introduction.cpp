// Abstract and Section 1.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/one_factorization.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/pair_set.hpp"
#include "core/checked.hpp"
#include "core/each.hpp"
#include "paper/checks/checking.hpp"
#include "paper/checks/checks.hpp"
#include "paper/checks/enumeration.hpp"

namespace changeover {
namespace {

PaperItem check_count_in_abstract(const Paper& paper) {
  Check check("Abstract", "the number of designs that the recursion gives from the cyclic families",
              "counts");
  check.expect(
      paper.count_in_abstract == paper.eleven.size(),
      {fmt::format("{} additional minimum DCCDs from members of these infinite families",
                   paper.count_in_abstract),
       fmt::format("{}: that many are listed in Corollary 15, which says {}, and Section 4 says {}",
                   paper.eleven.size(), paper.count_in_corollary, paper.count_in_conclusion),
       "Theorem 2 applies to a design of Theorem 10 exactly when k-2 divides 2c+1. (The "
       "DCCD(10,4,9) of Table 7 would make twelve, but it comes from Theorem 3.)"});
  return std::move(check).finish();
}

// The three places write the recursion with different fractions; each is evaluated as printed, and
// compared with what the 1-factors of a complete graph add: its vertices, and a block for each
// edge.
PaperItem check_recursion_formulas(const Paper& paper) {
  Check check("Abstract",
              "v* and b* of the recursion, as the abstract, Theorem 2 and Section 4 write them",
              "values");
  constexpr std::uint64_t blocks_before = 17;  // any number
  for (std::uint32_t subsets = 3; subsets <= 25; subsets += 2) {
    const OneFactorization factors = one_factorization(subsets + 1);
    const std::uint64_t edges = sum_of(factors.factors, &OneFactor::size);
    for (std::uint64_t k = 3; k <= 20; ++k) {
      const std::uint64_t v = subsets * (k - 2);
      const Values values{{'v', v}, {'k', k}, {'b', blocks_before}};
      for (const PrintedDesign& printed : paper.recursion) {
        const Fraction elements = value_of(printed.v, values);
        const Fraction blocks = value_of(printed.b, values);
        check.expect(
            elements.count() == v + factors.order && blocks.count() == blocks_before + edges,
            {fmt::format("{}: v* = {} = {}, b* = {} = {}", printed.place, printed.v,
                         elements.to_string(), printed.b, blocks.to_string()),
             fmt::format("v* = {}, b* = {}", v + factors.order, blocks_before + edges),
             fmt::format("v = {}, k = {}, b = {}: K_{} has {} edges", v, k, blocks_before,
                         factors.order, edges)});
      }
    }
  }
  return std::move(check).finish();
}

PaperItem check_covered_example(const Paper& paper) {
  const PrintedCovered& printed = paper.covered;
  Check check("Section 1",
              fmt::format("where {{{},{}}} is covered in {}", printed.x, printed.y, printed.table),
              "blocks");
  const PrintedTable& table = table_at(paper, printed.table);
  const ParsedTable parsed = parse(table);
  const Design design = printed_design(table, table.parameters.kind);
  DesignSource source(design);
  std::size_t found = 0;
  for (Transitions steps(source); steps.next();) {
    const std::string& block = parsed.blocks[static_cast<std::size_t>(steps.index())].name;
    const auto holds = [&](std::span<const Element> elements, const std::string& name) {
      return std::ranges::any_of(elements, [&](Element e) { return design.label(e) == name; });
    };
    const bool covered =
        holds(steps.block(), printed.x) && holds(steps.block(), printed.y) &&
        (holds(steps.introduced(), printed.x) || holds(steps.introduced(), printed.y));
    const auto compare = [&](const std::vector<std::string>& names, bool said) {
      if (std::ranges::find(names, block) == names.end()) {
        return;
      }
      ++found;
      check.expect(
          said == covered,
          {fmt::format("{}covered in {}", said ? "" : "not ",
                       block_name(parsed, static_cast<std::size_t>(steps.index()))),
           fmt::format("{}covered there", covered ? "" : "not "), braces(steps.block(), design)});
    };
    compare(printed.covered, true);
    compare(printed.not_covered, false);
  }
  const std::size_t named = printed.covered.size() + printed.not_covered.size();
  check.expect(found == named,
               {fmt::format("{} blocks are named", named),
                fmt::format("{} of them are in the table", found), printed.table},
               0);
  return std::move(check).finish();
}

constexpr Element nine = 9;  // components of the example, called 1, …, 9

std::uint64_t pairs_met(const std::vector<Block>& blocks) {
  PairSet pairs(nine + 1);
  for (const Block& block : blocks) {
    for (std::size_t i = 0; i < block.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        pairs.insert(block[i], block[j]);
      }
    }
  }
  return pairs.size();
}

// "An optimal covering design with 12 blocks": what its blocks are, each from the others, and that
// fewer do not do.
PaperItem check_covering(const Paper& paper) {
  Check check("Section 1",
              "the covering design of nine components, threes: its blocks, each recomputed from "
              "all the others, and that fewer do not do",
              "statements");
  constexpr Element v = nine;
  const std::vector<Block> covering = blocks_in(paper.covering);
  for (std::size_t i = 0; i < covering.size(); ++i) {
    std::vector<Block> others = covering;
    std::vector<Block> completions;
    for (Element x = 1; x <= v; ++x) {
      for (Element y = x + 1; y <= v; ++y) {
        for (Element z = y + 1; z <= v; ++z) {
          others[i] = {x, y, z};
          if (pairs_met(others) == binomial(v, 2)) {
            completions.push_back(others[i]);
          }
        }
      }
    }
    check.expect(completions == std::vector<Block>{sorted(covering[i])}, [&] {
      return PaperFinding{braces(covering[i]),
                          completions.empty()
                              ? "no block completes the others to a covering of all pairs"
                              : braces(completions.front()),
                          "every set of three tried"};
    });
  }
  // Each component meets 8 others, two a block, so it is in 4 blocks at least.
  const std::uint64_t fewest = ceil_div(v * ceil_div(v - 1, 2), 3);
  check.expect(covering.size() == fewest,
               {fmt::format("an optimal covering design with {} blocks", covering.size()),
                fmt::format("{} blocks are the least", fewest), "[Schonheim1964]"});
  check.note(fmt::format("{} blocks are the least: each component is in four, to meet eight others",
                         fewest));
  return std::move(check).finish();
}

// Changes of a list run in order; the first block counts as k changes.
std::uint64_t changes(const std::vector<Block>& blocks) {
  std::uint64_t total = blocks.empty() ? 0 : blocks.front().size();
  for (std::size_t i = 1; i < blocks.size(); ++i) {
    total += difference(blocks[i], blocks[i - 1]).size();
  }
  return total;
}

// The most changes in any order: steps between disjoint blocks form paths in the graph of
// disjointness, which cannot leave a component, so at least (components − 1) steps share an
// element.
std::uint64_t most_changes(const std::vector<Block>& blocks) {
  std::vector<std::size_t> component(blocks.size());
  std::iota(component.begin(), component.end(), std::size_t{0});
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (intersection(blocks[i], blocks[j]).empty()) {
        std::ranges::replace(component, component[i], component[j]);
      }
    }
  }
  std::ranges::sort(component);
  const auto components = static_cast<std::uint64_t>(
      std::unique(component.begin(), component.end()) - component.begin());
  const std::uint64_t k = blocks.front().size();
  return k * blocks.size() - (components - 1);
}

PaperItem check_costs(const Paper& paper) {
  Check check("Section 1", "costs of testing nine components three at a time, six figures",
              "figures");
  const std::vector<Block> covering = blocks_in(paper.covering);
  const Enumeration single = enumerate({.v = 9, .k = 3, .change = 1, .kind = Kind::linear}, 18);
  check.expect(single.found > 0 &&
                   lower_bound({.v = 9, .k = 3, .change = 1, .kind = Kind::linear}).blocks == 18,
               {"a minimum SCCD(9,3,18)", "none was found", "by exhaustion"}, 0);
  const PrintedTable& table = table_at(paper, "Table 1");
  const std::vector<Block> twice = printed_design(table, Kind::linear).blocks();
  if (single.designs.empty()) {
    return std::move(check).finish();
  }
  const std::vector<Block> once = single.designs.front().blocks();
  for (const PrintedCosts& printed : paper.costs) {
    const auto compare = [&](std::uint64_t dollars, const std::vector<Block>& blocks,
                             const std::string& what) {
      const std::uint64_t cost = blocks.size() * printed.test + changes(blocks) * printed.change;
      check.expect(cost == dollars,
                   {fmt::format("${} for {} at ${} a test and ${} a change", dollars, what,
                                printed.test, printed.change),
                    fmt::format("${}", cost),
                    fmt::format("{} tests and {} changes, the first block counting as three",
                                blocks.size(), changes(blocks))});
    };
    compare(printed.covering, covering, "the covering design as listed");
    compare(printed.single, once, "a minimum SCCD(9,3,18)");
    compare(printed.twice, twice, "a minimum DCCD(9,3,12)");
  }
  // "The DCCD outperformed the SCCD and the covering" where a test costs more than a change, by the
  // printed figures.
  for (const PrintedCosts& printed : paper.costs) {
    const bool twice_is_best = printed.twice < printed.single && printed.twice < printed.covering;
    check.expect(twice_is_best == (printed.test > printed.change),
                 {"the DCCD costs least at $10 a test and $1 a change, the SCCD at $1 and $5",
                  fmt::format("${} and ${} for the others, ${} for it", printed.covering,
                              printed.single, printed.twice),
                  fmt::format("${} a test, ${} a change", printed.test, printed.change)},
                 0);
  }
  check.expect(changes(covering) == most_changes(covering),
               {"the order shown is the worst case",
                fmt::format("{} changes; another order may have {}", changes(covering),
                            most_changes(covering)),
                "consecutive blocks are disjoint only within a parallel class"},
               0);
  check.note(fmt::format("{}, {} and {} changes; no order of the covering design has more",
                         changes(covering), changes(once), changes(twice)));
  return std::move(check).finish();
}

}  // namespace

std::vector<PaperItem> check_introduction(const PaperContext& context) {
  return {
      check_recursion_formulas(context.paper),
      check_again(context, "Abstract"),
      check_count_in_abstract(context.paper),
      check_covered_example(context.paper),
      check_covering(context.paper),
      check_costs(context.paper),
      not_checkable(
          "Section 1",
          "history and motive: tape drives, caches, tests of components; who found what and when",
          "no mathematical statement; what is cited of the results themselves stands below")};
}

}  // namespace changeover
