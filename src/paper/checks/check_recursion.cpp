// Section 3.1: the recursion by expansion sets and 1-factorizations.
#include <fmt/format.h>

#include <algorithm>

#include "changeover/construct/expansion.hpp"
#include "changeover/core/design.hpp"
#include "core/words.hpp"
#include "paper/checks/checking.hpp"
#include "paper/checks/checks.hpp"

namespace changeover {
namespace {

struct DesignWithSet {
  Design design;
  ExpansionSet set;
};

// Designs with expansion sets: those of Tables 2 and 4, those of Theorem 10, and the circular ones
// read as linear too.
std::vector<DesignWithSet> recursion_designs(const PaperContext& context) {
  std::vector<DesignWithSet> designs;
  const PrintedTable& table_2 = table_at(context.paper, "Table 2");
  designs.push_back({printed_design(table_2, Kind::linear), marked_expansion_set(table_2)});
  const PrintedTable& table_4 = table_at(context.paper, "Table 4 (right)");
  designs.push_back({printed_design(table_4, Kind::circular), marked_expansion_set(table_4)});
  for (CyclicWithSet& cyclic :
       cyclic_with_sets(context.registry, context.paper.cyclic_up_to, context.options.largest_k)) {
    designs.push_back({std::move(cyclic.design), std::move(cyclic.set)});
  }
  const std::size_t count = designs.size();
  for (std::size_t i = 1; i < count; ++i) {
    DesignWithSet linear = designs[i];
    linear.design.set_kind(Kind::linear);
    designs.push_back(std::move(linear));
  }
  return designs;
}

// "Preece et al. use expansion sets to construct a SCCD(v+1,k,b) from a SCCD(v,k,b)."
PaperItem check_expanded_single_change(const PaperContext& context) {
  constexpr std::uint64_t largest_v = 30;
  Check check("Section 3.1", "cited: expansion sets make a SCCD(v+1,k,b) of a SCCD(v,k,b)",
              "designs");
  const Construction* const construction = check.finds(context.registry, "single-change-expansion");
  if (construction == nullptr) {
    return std::move(check).finish();
  }
  const PrintedDesign& printed = context.paper.single_recursion;
  bool told = false;
  std::size_t made = 0;
  for (std::uint64_t k = 3; k <= 6; ++k) {
    for (std::uint64_t v = k + 2; v <= largest_v; ++v) {
      for (const Kind kind : {Kind::linear, Kind::circular}) {
        const Parameters p{.v = v, .k = k, .change = 1, .kind = kind};
        const auto offer = construction->offer(p, context.registry);
        if (!offer || offer->recipe.inputs.size() != 1) {
          continue;
        }
        ++made;
        const Verdict small = verify(context.registry.build_design(offer->recipe.inputs.front()));
        const Verdict larger = verify(context.registry.build_design(offer->recipe));
        const Values values{{'v', small.parameters.v}, {'k', k}, {'b', small.b}};
        const bool right = small.valid() && larger.valid() &&
                           value_of(printed.v, values).count() == v &&
                           value_of(printed.b, values).count() == larger.b;
        check.expect(
            right || told,
            {fmt::format("a SCCD({},{},{}) from a SCCD({},{},{})", v, k,
                         count_of(printed.b, values), small.parameters.v, k, small.b),
             fmt::format("{} blocks: {} more", larger.b, larger.b - small.b),
             "one block more for each of the v/(k-1) members of the expansion set; the paper "
             "writes b for two numbers"});
        told |= !right;
      }
    }
  }
  check.expect(made > 0, {"such designs", "none was made", "single-change-expansion"}, 0);
  check.note(fmt::format("k <= 6, v <= {}, linear and circular; all are valid", largest_v));
  return std::move(check).finish();
}

PaperItem check_theorem(const PaperContext& context, const std::vector<DesignWithSet>& designs) {
  Check check("Theorem 2", claim_at(context.paper, "Theorem 2"), "designs");
  const PrintedDesign& printed = formulas_at(context.paper.recursion, "Theorem 2");
  std::size_t tight = 0;
  std::size_t economical = 0;
  for (const DesignWithSet& with_set : designs) {
    const Design& design = with_set.design;
    const ExpansionSet& set = with_set.set;
    const auto subsets = static_cast<std::uint32_t>(set.size());
    const auto defect = expansion_set_defect(design, set);
    if (!check.expect(
            !defect.has_value(),
            [&] {
              return PaperFinding{
                  fmt::format("an expansion set of the {}", name(design.parameters())),
                  "it is none", *defect};
            },
            0)) {
      continue;
    }
    const Verdict before = verify(design);
    for (const FactorizationKind kind : {FactorizationKind::circle, FactorizationKind::doubled}) {
      OneFactorization factors = one_factorization(subsets + 1, kind);
      if (kind == FactorizationKind::doubled) {  // "in any order"
        for (OneFactor& factor : factors.factors) {
          std::ranges::reverse(factor);
        }
      }
      const Design larger = expand(design, set, factors);
      const Verdict after = verify(larger);
      const Values values{{'v', design.v()}, {'k', design.k()}, {'b', before.b}};
      const std::uint64_t v = count_of(printed.v, values);
      const std::uint64_t b = count_of(printed.b, values);
      check.expect(larger.v() == v && after.b == b && after.valid() &&
                       after.parameters.kind == before.parameters.kind &&
                       before.tight() == after.tight() &&
                       before.economical() == after.economical() && before.excess == after.excess,
                   {fmt::format("{} gives a {} {}", name(design.parameters()),
                                to_string(design.parameters().kind), dccd(v, design.k(), b)),
                    fmt::format("v = {}, {}", larger.v(), in_words(after)), "built and verified"});
      tight += after.tight() ? 1U : 0U;
      economical += after.economical() && !after.tight() ? 1U : 0U;
    }
  }
  check.note(fmt::format("{} of them tight, {} economical and not tight; two 1-factorizations each",
                         tight, economical));
  return std::move(check).finish();
}

PaperItem check_table_3(const Paper& paper, const PrintedTable& table) {
  if (const auto rebuilt = expanded_as_printed(paper, "Table 2", Kind::linear, "Figure 2")) {
    return check_blocks(table, *rebuilt,
                        "expanded from Table 2 with the colours of Figure 2 in their order");
  }
  Check check(table.place, table.caption, "blocks");
  check.expect(
      false, {"Table 2 expanded with the 1-factors of Figure 2", "that cannot be done",
              "the carets do not mark an expansion set, or the colours are not a 1-factorization"});
  return std::move(check).finish();
}

// Each coloured pair of Table 3 is an edge of the 1-factor of that colour.
PaperItem check_colours(const Paper& paper, const PrintedTable& table) {
  Check check(table.place, "colours of the inserted elements against the 1-factors of Figure 2",
              "cells");
  const ParsedTable parsed = parse(table);
  for (const PrintedFactorization& printed : paper.factorizations) {
    if (printed.place != "Figure 2") {
      continue;
    }
    const OneFactorization factors = parse(printed);
    for (const PrintedBlock& block : parsed.blocks) {
      for (const PrintedCell& cell : block.cells) {
        const auto vertex = std::ranges::find(printed.vertices, cell.element);
        bool holds = (vertex == printed.vertices.end()) == (cell.colour == 0);
        if (holds && cell.colour != 0) {
          const auto x = static_cast<std::uint32_t>(vertex - printed.vertices.begin());
          const auto& factor =
              factors.factors.at(std::min<std::size_t>(cell.colour, factors.factors.size()) - 1);
          holds = cell.colour <= factors.factors.size() &&
                  std::ranges::any_of(factor, [&](const Edge& edge) {
                    if (edge.a != x && edge.b != x) {
                      return false;
                    }
                    const std::string& other = printed.vertices[edge.a == x ? edge.b : edge.a];
                    return std::ranges::any_of(block.cells, [&](const PrintedCell& c) {
                      return c.element == other && c.colour == cell.colour;
                    });
                  });
        }
        check.expect(holds,
                     {fmt::format("{}: {} in colour {}", block.name, cell.element, cell.colour),
                      "no edge of that colour in this block", "Figure 2"});
      }
    }
  }
  return std::move(check).finish();
}

// Hands on those whose set is one, and what Theorem 2 makes of them.
template <typename Use>
void for_each_expanded(const std::vector<DesignWithSet>& designs, const Use& use) {
  for (const auto& [design, set] : designs) {
    if (!expansion_set_defect(design, set)) {
      use(design,
          expand(design, set, one_factorization(static_cast<std::uint32_t>(set.size()) + 1)));
    }
  }
}

// What the blocks without a new element introduce, in their order; with their numbers among all
// blocks, from 1.
struct OldBlocks {
  std::vector<Block> blocks, introduced;
  std::vector<std::uint64_t> number;
};

OldBlocks old_blocks(const Design& design, std::uint64_t old_elements) {
  OldBlocks old;
  DesignSource source(design);
  for (Transitions steps(source); steps.next();) {
    const std::span<const Element> block = steps.block();
    if (std::ranges::all_of(block, [&](Element x) { return x < old_elements; })) {
      old.blocks.push_back(sorted(block));
      old.introduced.push_back(sorted(steps.introduced()));
      old.number.push_back(steps.index() + 1);
    }
  }
  return old;
}

// "Each B_{j,e} only covers new pairs and does not effect introductions in preexisting blocks."
PaperItem check_introductions(const Paper& paper, const std::vector<DesignWithSet>& designs) {
  Check check(
      "Theorem 2",
      "the proof: the inserted blocks leave the introductions in the blocks that were there",
      "blocks");
  const PrintedTable& table = table_at(paper, "Table 3");
  const Design printed = printed_design(table, Kind::linear);
  std::size_t different = 0;
  std::size_t at_the_front = 0;
  for (const auto& [design, set] : designs) {
    if (expansion_set_defect(design, set)) {
      continue;
    }
    const Design larger =
        expand(design, set, one_factorization(static_cast<std::uint32_t>(set.size()) + 1));
    const OldBlocks before = old_blocks(design, design.v());
    const OldBlocks after = old_blocks(larger, design.v());
    const std::size_t count = std::min(before.blocks.size(), after.blocks.size());
    for (std::size_t i = 0; i < count; ++i) {
      const bool same = before.introduced[i] == after.introduced[i];
      check.expect(same || different > 0, [&, &made = design] {
        const std::uint64_t number = after.number[i];
        const bool in_print = number <= printed.block_count() && larger.v() == printed.v() &&
                              sorted(printed.block(number - 1)) == after.blocks[i];
        return PaperFinding{
            fmt::format("B_{} introduces {} in the linear {}, and so it does when it is expanded",
                        before.number[i], braces(before.introduced[i]),
                        dccd(made.v(), made.k(), made.block_count())),
            fmt::format("in the {} that comes of it block {} = {} introduces {}{}",
                        dccd(larger.v(), larger.k(), larger.block_count()), number,
                        braces(after.blocks[i]), braces(after.introduced[i]),
                        in_print ? fmt::format(", as {} has it", table.place) : ""),
            "blocks inserted at U_0 come before B_1, and bring U_0 in. So the first of them covers "
            "the pairs within U_0, and B_1 no longer does; all else is as the proof says"};
      });
      different += same ? 0U : 1U;
    }
    at_the_front +=
        std::ranges::any_of(set,
                            [&, &made = design](const UnchangedSubset& subset) {
                              return made.parameters().kind == Kind::linear && subset.position == 0;
                            })
            ? 1U
            : 0U;
    check.expect(before.blocks == after.blocks,
                 {"the blocks that were there are there", "not all", "compared"}, 0);
  }
  check.note(fmt::format(
      "so in {}; {} of the designs {} linear with a subset at U_0. As many pairs are covered in "
      "all, and Theorem 2 stands as it is",
      count_of(different, "block"), at_the_front, at_the_front == 1 ? "is" : "are"));
  return std::move(check).finish();
}

PaperItem check_never_again(const std::vector<DesignWithSet>& designs) {
  Check check("Section 3.1", "the expanded design never has an expansion set", "designs");
  for_each_expanded(designs, [&](const Design&, const Design& larger) {
    if (larger.v() > 64) {
      return;
    }
    const ExpansionSearch search = find_expansion_sets(larger, {.how_many = 1, .limits = {}});
    check.expect(search.sets.empty() && search.complete,
                 {"no expansion set", fmt::format("the {} has one", name(larger.parameters())),
                  "exact cover"});
  });
  check.note("by exact cover, v <= 64");
  return std::move(check).finish();
}

// "Every new element is always removed one block after it is introduced."
PaperItem check_removed_at_once(const std::vector<DesignWithSet>& designs) {
  Check check("Section 3.1", "a new element is removed one block after it is introduced",
              "designs");
  for_each_expanded(designs, [&](const Design& design, const Design& larger) {
    const Verdict verdict = verify(larger);
    check.expect(
        std::all_of(verdict.elements.begin() + static_cast<std::ptrdiff_t>(design.v()),
                    verdict.elements.end(),
                    [](const ElementCount& x) { return x.introductions == x.blocks; }),
        {"removed one block later", "one stays for two blocks", name(larger.parameters())});
  });
  return std::move(check).finish();
}

PaperItem check_new_elements(const Paper& paper, const std::vector<DesignWithSet>& designs) {
  Check check("Section 3.1", "a new element of Theorem 2 is never in an unchanged subset",
              "designs");
  for_each_expanded(designs, [&](const Design& design, const Design& larger) {
    const std::vector<UnchangedSubset> between = unchanged_subsets(larger);
    check.expect(std::ranges::none_of(between,
                                      [&](const UnchangedSubset& subset) {
                                        return subset.elements.back() >= design.v();
                                      }),
                 {"a new element is never in an unchanged subset",
                  "one is kept from a block to the next", name(larger.parameters())});
  });
  // By Section 2.2 the ends of a linear design have unchanged subsets too: U_0 and U_b.
  const PrintedTable& table = table_at(paper, "Table 3");
  const Design linear = printed_design(table, Kind::linear);
  const std::uint64_t old_elements = table_at(paper, "Table 2").parameters.v;
  for (const std::size_t end : {std::size_t{0}, linear.block_count() - 1}) {
    const auto block = linear.block(end);
    const auto fresh = std::ranges::find_if(block, [&](Element x) { return x >= old_elements; });
    check.expect(fresh == block.end(), [&] {
      return PaperFinding{"a new element is never in an unchanged subset",
                          fmt::format("in Table 3 the {} block is {}, so U_{} = {{{}}} is one",
                                      end == 0 ? "first" : "last", braces(block, linear),
                                      end == 0 ? 0 : linear.block_count(), linear.label(*fresh)),
                          "by Section 2.2 every (k-2)-subset of the first and of the last block of "
                          "a linear design is an unchanged subset. True of all others; and what is "
                          "concluded, that there is no expansion set, holds all the same"};
    });
  }
  return std::move(check).finish();
}

}  // namespace

std::vector<PaperItem> check_recursion(const PaperContext& context) {
  const PrintedTable& table = table_at(context.paper, "Table 3");
  const std::vector<DesignWithSet> designs = recursion_designs(context);
  return {check_expanded_single_change(context),
          check_theorem(context, designs),
          check_introductions(context.paper, designs),
          check_table_3(context.paper, table),
          check_marks(table),
          check_colours(context.paper, table),
          check_kind(table),
          check_removed_at_once(designs),
          check_never_again(designs),
          check_new_elements(context.paper, designs)};
}

}  // namespace changeover
