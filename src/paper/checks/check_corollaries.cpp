// Section 3.2, the rest: expansions of the cyclic designs, the DCCD(61,4,366).
#include <fmt/format.h>

#include <algorithm>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/expansion.hpp"
#include "changeover/core/developed.hpp"
#include "changeover/verify/difference.hpp"
#include "paper/checks/checking.hpp"
#include "paper/checks/checks.hpp"

namespace changeover {
namespace {

std::vector<CyclicWithSet> designs_with_sets(const PaperContext& context) {
  return cyclic_with_sets(context.registry, context.paper.cyclic_up_to, context.options.largest_k);
}

PaperItem check_expansion_sets(const PaperContext& context,
                               const std::vector<CyclicWithSet>& designs) {
  Check check("Proposition 13", claim_at(context.paper, "Proposition 13"), "expansion sets");
  if (check.finds(context.registry, "cyclic-paper") == nullptr) {
    return std::move(check).finish();
  }
  std::uint64_t searched = 0;
  for (const auto& [c, design, set] : designs) {
    const auto defect = expansion_set_defect(design, set);
    check.expect(!defect.has_value(), [&, parameter = c, &made = design] {
      return PaperFinding{fmt::format("an expansion set for c = {}, k = {}", parameter, made.k()),
                          "the subsets of the proof are none", *defect};
    });
    if (design.v() <= 64) {
      ++searched;
      const ExpansionSearch search = find_expansion_sets(design, {.how_many = 1, .limits = {}});
      check.expect(!search.sets.empty(),
                   {"an expansion set", fmt::format("the {} has none", name(design.parameters())),
                    "exact cover"});
    }
  }
  check.note(
      fmt::format("the {} pairs (c,k) with c <= {} and k-2 dividing 2c+1, k <= {}; {} of them by "
                  "exact cover too",
                  designs.size(), context.paper.cyclic_up_to, context.options.largest_k, searched));
  return std::move(check).finish();
}

// "Taking 0 ≤ j < v/(k−2) − 1, the unchanged subsets U_{ic(k−2)} partition Z_v."
PaperItem check_range(const PaperContext& context, const std::vector<CyclicWithSet>& designs) {
  Check check("Proposition 13", "the proof: the range of the subsets U_{ic(k-2)}", "designs");
  bool told = false;
  for (const auto& [c, design, whole] : designs) {
    const std::uint64_t subsets = design.v() / (design.k() - 2);
    ExpansionSet set;
    for (const UnchangedSubset& subset : whole) {
      // i runs from 0; i = 0 is the one at the closing position.
      const std::uint64_t i = subset.position / (c * (design.k() - 2)) % subsets;
      if (i + context.paper.range_short_by < subsets) {
        set.push_back(subset);
      }
    }
    const auto defect = expansion_set_defect(design, set);
    check.expect(!defect || told, [&, &made = design] {
      return PaperFinding{
          fmt::format("0 <= j < v/(k-2) - {}", context.paper.range_short_by), "0 <= i < v/(k-2)",
          fmt::format(
              "v/(k-2) subsets of k-2 elements are needed, and the index is called i; the {} "
              "subsets in the printed range of the {} leave k-2 elements out: {}",
              set.size(), name(made.parameters()), *defect)};
    });
    told = told || defect;
  }
  return std::move(check).finish();
}

// "The order of the expansion set is (4ck−6c+1)/(k−2) = 4c + (2c+1)/(k−2). This is odd if and only
// if (2c+1)/(k−2) is."
PaperItem check_order(const PaperContext& context, const std::vector<CyclicWithSet>& designs) {
  Check check("Corollary 14", "the proofs: the order of the expansion set, and when it is odd",
              "values");
  if (check.finds(context.registry, "cyclic-paper") == nullptr) {
    return std::move(check).finish();
  }
  for (const auto& [c, design, set] : designs) {
    const Values values{{'c', c}, {'k', design.k()}, {'v', design.v()}};
    for (const std::string& formula : context.paper.expansion_order) {
      const Fraction printed = value_of(formula, values);
      check.expect(printed.count() == set.size(),
                   {fmt::format("{} = {}", formula, printed.to_string()),
                    fmt::format("{} subsets", set.size()), "counted"});
    }
    check.expect(
        (set.size() % 2 == 1) == ((2 * c + 1) / (design.k() - 2) % 2 == 1),
        {"odd if and only if (2c+1)/(k-2) is", fmt::format("not for {}", set.size()), "counted"});
  }
  check.note(
      "2c+1 is odd, and so is each of its divisors: whenever k-2 divides it the order is odd");
  return std::move(check).finish();
}

struct Expanded {
  std::uint64_t c = 0, l = 0;
  PrintedTriple triple;
};

// Corollary 14's formulas as printed.
Expanded by_formula(const PrintedDesign& printed, std::uint64_t c, std::uint64_t k) {
  const std::uint64_t l = (2 * c + 1) / (k - 2);
  const Values values{{'c', c}, {'k', k}, {'l', l}};
  return {c, l, {count_of(printed.v, values), k, count_of(printed.b, values)}};
}

std::string in_words(const PrintedTriple& triple) { return dccd(triple.v, triple.k, triple.b); }

Design expanded(const CyclicWithSet& cyclic) {
  return expand(cyclic.design, cyclic.set,
                one_factorization(static_cast<std::uint32_t>(cyclic.set.size()) + 1));
}

PaperItem check_formula(const PaperContext& context, const std::vector<CyclicWithSet>& designs) {
  Check check("Corollary 14", claim_at(context.paper, "Corollary 14"), "designs");
  if (check.finds(context.registry, "cyclic-paper") == nullptr) {
    return std::move(check).finish();
  }
  for (const CyclicWithSet& cyclic : designs) {
    const Expanded printed = by_formula(context.paper.expanded, cyclic.c, cyclic.design.k());
    const Design design = expanded(cyclic);
    check.expect(
        design.v() == printed.triple.v,
        {fmt::format("v = {} for c = {}, k = {}", printed.triple.v, cyclic.c, cyclic.design.k()),
         fmt::format("v = {}", design.v()), "expanded by Theorem 2"},
        0);
    expect_design(check, design, {.b = printed.triple.b, .tight = true});
  }
  check.note("expanded by Theorem 2 and verified");
  return std::move(check).finish();
}

// How two numbers that no (c,k) gives may have come about: another k in the formulas of Corollary
// 14, or an expansion with some of the subsets only.
std::string likely_slip(const PaperContext& context, const PrintedTriple& triple,
                        const std::vector<CyclicWithSet>& designs) {
  const PrintedDesign& formulas = context.paper.expanded;
  for (const CyclicWithSet& cyclic : designs) {
    if (cyclic.design.k() != triple.k) {
      continue;
    }
    const std::uint64_t l = (2 * cyclic.c + 1) / (triple.k - 2);
    for (std::uint64_t k = 3; k <= context.options.largest_k; ++k) {
      const Values values{{'c', cyclic.c}, {'k', k}, {'l', l}};
      if (k != triple.k && value_of(formulas.v, values).count() == triple.v &&
          value_of(formulas.b, values).count() == triple.b) {
        return fmt::format("Corollary 14 with c = {} and l = {} gives {} and {} if k is {} there",
                           cyclic.c, l, triple.v, triple.b, k);
      }
    }
    for (std::uint64_t subsets = 1; subsets < cyclic.set.size(); subsets += 2) {
      if (cyclic.design.v() + subsets + 1 == triple.v &&
          cyclic.design.block_count() + subsets * (subsets + 1) / 2 == triple.b) {
        return fmt::format(
            "{} and {} come out if the {} is expanded with {} of the {} members of its expansion "
            "set",
            triple.v, triple.b, dccd(cyclic.design.v(), triple.k, cyclic.design.block_count()),
            subsets, cyclic.set.size());
      }
    }
  }
  return "";
}

// One of the eleven: which (c,k) gives it, and does it exist.
PaperItem check_triple(const PaperContext& context, const PrintedTriple& triple,
                       const std::vector<CyclicWithSet>& designs) {
  Check check("Corollary 15", fmt::format("a tight circular {}", in_words(triple)), "designs");
  check.of_a_statement();
  if (check.finds(context.registry, "cyclic-paper") == nullptr) {
    return std::move(check).finish();
  }
  const auto is_printed = [&](const PrintedTriple& other) {
    const auto& list = context.paper.eleven;
    return std::ranges::find(list, other) != list.end();
  };
  std::vector<std::string> instead;
  for (const CyclicWithSet& cyclic : designs) {
    const Expanded given = by_formula(context.paper.expanded, cyclic.c, cyclic.design.k());
    if (given.triple == triple) {
      expect_design(check, expanded(cyclic), {.b = triple.b, .tight = true});
      check.note(
          fmt::format("c = {}, l = {}: expanded from the {}", given.c, given.l,
                      dccd(cyclic.design.v(), cyclic.design.k(), cyclic.design.block_count())));
      return std::move(check).finish();
    }
    if (given.triple.k == triple.k && !is_printed(given.triple)) {
      const Design design = expanded(cyclic);
      const Verdict verdict = verify(design);
      instead.push_back(fmt::format(
          "Corollary 14 with c = {}, k = {}, l = {} gives {}, built and {}", given.c, triple.k,
          given.l, in_words(given.triple), verdict.tight() ? "verified tight" : "refuted"));
    }
  }
  const Parameters p = circular(triple.v, triple.k);
  const Bound bound = lower_bound(p);
  check.expect(false, [&] {
    std::string truth = triple.b < bound.blocks
                            ? fmt::format("impossible, at least {} blocks are needed", bound.blocks)
                            : std::string("no (c,k) of Theorem 10 gives it");
    for (const std::string& other : instead) {
      truth += "; " + other;
    }
    return PaperFinding{fmt::format("a tight circular {} exists", in_words(triple)), truth,
                        triple.b < bound.blocks ? bound.reason : "compared with Corollary 14"};
  });
  if (const std::string slip = likely_slip(context, triple, designs); !slip.empty()) {
    check.note("a slip of arithmetic, it seems: " + slip);
  }
  return std::move(check).finish();
}

PaperItem check_count(const PaperContext& context, const std::vector<CyclicWithSet>& designs) {
  Check check("Corollary 15", "eleven: how many are listed, and how many (c,k) there are",
              "counts");
  const Paper& paper = context.paper;
  check.expect(paper.count_in_corollary == paper.eleven.size(),
               {fmt::format("the following {}", paper.count_in_corollary),
                fmt::format("{} are listed", paper.eleven.size()), "counted"});
  // k−2 divides 2c+1 ≤ 11, so k ≤ 13 whatever the limit.
  std::uint64_t pairs = 0;
  for (std::uint64_t c = 1; c <= paper.cyclic_up_to; ++c) {
    for (std::uint64_t d = 1; d <= 2 * c + 1; ++d) {
      pairs += (2 * c + 1) % d == 0 ? 1U : 0U;
    }
  }
  check.expect(pairs == paper.count_in_corollary,
               {fmt::format("{} designs", paper.count_in_corollary),
                fmt::format("{} pairs (c,k)", pairs), "k-2 divides 2c+1"});
  check.expect(
      designs.size() == pairs || context.options.largest_k < 2 * paper.cyclic_up_to + 3,
      {fmt::format("{} designs", pairs), fmt::format("{} built", designs.size()), "cyclic-paper"});
  return std::move(check).finish();
}

PaperItem check_61_4(const PaperContext& context) {
  Check check("Proposition 16",
              fmt::format("{} (Table 12)", claim_at(context.paper, "Proposition 16")),
              "comparisons");
  const Parameters p = circular(61, 4);
  const Construction* const construction = check.finds(context.registry, "cyclic-61-4");
  if (construction == nullptr) {
    return std::move(check).finish();
  }
  const BaseBlocks printed{p, base_blocks(context.paper.six_base_blocks, 4)};
  const auto offer = construction->offer(p, context.registry);
  const auto ours = offer ? construction->base_blocks(offer->recipe) : std::nullopt;
  for (std::size_t i = 0; i < printed.blocks.size(); ++i) {
    const bool same = ours && i < ours->blocks.size() &&
                      std::is_permutation(printed.blocks[i].begin(), printed.blocks[i].end(),
                                          ours->blocks[i].begin(), ours->blocks[i].end());
    check.expect(same, [&] {
      return PaperFinding{fmt::format("B_{{{},0}} = {}", i, braces(printed.blocks[i])),
                          ours && i < ours->blocks.size() ? braces(ours->blocks[i]) : "none",
                          "the construction"};
    });
  }
  const DifferenceVerdict differences = verify_differences(printed);
  check.expect(
      differences.valid() && differences.tight,
      {"every difference is covered exactly once",
       fmt::format("{} uncovered, {} wrong steps", differences.uncovered, differences.bad_steps),
       "differences of the printed base blocks"});
  DevelopedSource source(printed);
  const Design design = read_all(source);
  if (expect_design(check, design, {.b = 366, .tight = true})) {
    check.note("developed, and verified in full: 366 blocks");
  }
  return std::move(check).finish();
}

}  // namespace

std::vector<PaperItem> check_corollaries(const PaperContext& context) {
  const std::vector<CyclicWithSet> designs = designs_with_sets(context);
  std::vector<PaperItem> items{check_expansion_sets(context, designs),
                               check_range(context, designs), check_order(context, designs),
                               check_formula(context, designs), check_count(context, designs)};
  for (const PrintedTriple& triple : context.paper.eleven) {
    items.push_back(check_triple(context, triple, designs));
  }
  items.push_back(check_61_4(context));
  return items;
}

}  // namespace changeover
