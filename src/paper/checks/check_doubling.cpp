// Section 3.2, first part: designs from single-change designs, and the minimum for v = 2k−2.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/expansion.hpp"
#include "changeover/core/developed.hpp"
#include "changeover/verify/difference.hpp"
#include "paper/checks/checking.hpp"
#include "paper/checks/checks.hpp"
#include "paper/checks/enumeration.hpp"

namespace changeover {
namespace {

// Every member of a family up to the limit: built by the construction, verified, minimum.
PaperItem check_family(const PaperContext& context, std::string_view place,
                       std::string_view construction, bool tight) {
  const PrintedFamily& family = family_at(context.paper, place);
  Check check(std::string(place), claim_at(context.paper, place), "designs");
  if (check.finds(context.registry, construction) == nullptr) {
    return std::move(check).finish();
  }
  std::uint64_t largest = 0;
  for (std::uint64_t k = family.smallest_k; k <= context.options.largest_k; ++k) {
    if ((k % 2 == 0) != family.even) {
      continue;
    }
    largest = k;
    const Parameters p = circular(count_of(family.design.v, {{'k', k}}), k);
    const Claim claim{.b = count_of(family.design.b, {{'k', k}}), .tight = tight};
    const std::optional<Design> design = construct(context.registry, construction, p);
    if (!design) {
      check.expect(
          false, {fmt::format("a circular {}", dccd(p.v, k, claim.b)),
                  "the construction gives none", impossibility(p).value_or(lower_bound(p).reason)});
      continue;
    }
    expect_design(check, *design, claim);
  }
  check.note(fmt::format("{} k up to {}: verified, and b is the lower bound{}",
                         family.even ? "even" : "odd", largest,
                         count_of(family.design.v, {{'k', family.smallest_k}}) == family.smallest_k
                             ? fmt::format(" (k = {}: a single block)", family.smallest_k)
                             : ""));
  return std::move(check).finish();
}

PaperItem check_nonexistence(const PaperContext& context) {
  const PrintedFamily& family = family_at(context.paper, "Theorem 3");
  Check check("Theorem 3", "no tight circular DCCD(2k-2,k,k-1) exists for odd k", "parameters");
  std::set<std::string> reasons;  // bounds that are enough for every k
  for (std::uint64_t k = family.smallest_k; k <= context.options.largest_k; ++k) {
    if ((k % 2 == 0) == family.even) {
      continue;
    }
    const Parameters p = circular(count_of(family.design.v, {{'k', k}}), k);
    const std::uint64_t b = count_of(family.design.b, {{'k', k}});
    const auto impossible = impossibility(p);
    const std::vector<Bound> bounds = lower_bounds(p);
    const Bound& bound = bounds.front();
    if (!impossible) {
      std::set<std::string> enough;
      for (const Bound& each : bounds) {
        if (each.blocks > b && (k == 5 || reasons.contains(each.name))) {
          enough.insert(each.name);
        }
      }
      reasons = std::move(enough);
    }
    check.expect(impossible || bound.blocks > b,
                 {fmt::format("no circular {}", dccd(p.v, k, b)),
                  fmt::format("the lower bound is only {}", bound.blocks), bound.reason});
  }
  check.note(fmt::format(
      "for k = 3 there is no room to change two elements; from k = 5 on every bound of these "
      "asks for more than k-1 blocks: {}",
      fmt::join(reasons, ", ")));
  return std::move(check).finish();
}

// "Determine minimum DCCD when v = 2k−2": k−1 blocks for even k, k for odd k, in both kinds.
PaperItem check_minimum(const PaperContext& context) {
  Check check("Theorem 4",
              "so the minimum DCCD(2k-2,k) has k-1 blocks for even k and k for odd k (abstract)",
              "designs");
  for (std::uint64_t k = 4; k <= context.options.largest_k; ++k) {
    const std::string_view construction = k % 2 == 0 ? "doubling" : "short-long-runs";
    std::optional<Design> design =
        construct(context.registry, construction, circular(2 * k - 2, k));
    if (!design) {
      check.lacks(construction);
      return std::move(check).finish();
    }
    const PrintedFamily& family = family_at(context.paper, k % 2 == 0 ? "Theorem 3" : "Theorem 4");
    for (const Kind kind : {Kind::circular, Kind::linear}) {
      design->set_kind(kind);
      expect_design(check, *design, {.b = count_of(family.design.b, {{'k', k}}), .tight = false});
    }
  }
  check.note(fmt::format(
      "k <= {}, circular and, read so, linear: some x is in none of the first and some y "
      "in none of the last (k-1)/2 blocks, so fewer cannot do",
      context.options.largest_k));
  return std::move(check).finish();
}

PaperItem check_doubled_single_change(const PaperContext& context) {
  const PrintedDesign& printed = context.paper.cited.single;
  Check check("Section 3.2",
              "cited: {0,...,k-1} is the base block of a tight circular SCCD(2k-1,k,2k-1)",
              "designs");
  for (std::uint64_t k = 2; k <= context.options.largest_k; ++k) {
    Block base(static_cast<std::size_t>(k));
    std::iota(base.begin(), base.end(), Element{0});
    DevelopedSource source(
        {{.v = count_of(printed.v, {{'k', k}}), .k = k, .change = 1, .kind = Kind::circular},
         {base}});
    expect_design(check, read_all(source), {.b = count_of(printed.b, {{'k', k}}), .tight = true});
  }
  return std::move(check).finish();
}

PaperItem check_cyclic_single_change(const Paper& paper) {
  const PrintedDesign& printed = paper.cited.single_cyclic;
  Check check("Section 3.2",
              "cited: tight circular SCCD(2c(k-1)+1,k,2c^2(k-1)+c) for all k >= 2, c >= 1",
              "designs");
  for (std::uint64_t k = 2; k <= 20; ++k) {
    for (std::uint64_t c = 1; c <= 10; ++c) {
      const Values values{{'c', c}, {'k', k}};
      BaseBlocks base{
          {.v = count_of(printed.v, values), .k = k, .change = 1, .kind = Kind::circular}, {}};
      for (std::uint64_t i = 1; i <= c; ++i) {
        Block block;
        for (Element x = 0; x + 1 < k; ++x) {
          block.push_back(x);
        }
        // Multiples of k−1; k−1 itself last, so that {1,…,k−1} is kept.
        block.push_back(static_cast<Element>((i == c ? 1 : i + 1) * (k - 1)));
        base.blocks.push_back(std::move(block));
      }
      const DifferenceVerdict verdict = verify_differences(base);
      check.expect(
          verdict.valid() && verdict.tight && verdict.b == count_of(printed.b, values),
          {"a tight circular SCCD", fmt::format("{} blocks, tight: {}", verdict.b, verdict.tight),
           fmt::format("k = {}, c = {}", k, c)});
    }
  }
  check.note(
      "by differences, from base blocks {0,...,k-2} with i(k-1), i = 2,...,c,1; k <= 20, c <= 10");
  return std::move(check).finish();
}

using Names = std::set<std::string>;

// The blocks of Theorem 4 from its runs: i_s is introduced in block i((k+1)/2 − 1) + (k−1) and
// leaves in block (i+1)((k+1)/2 − 1) + (k−1); i_l in blocks i(k+1)/2 and (i+1)(k+1)/2, all modulo
// k.
std::vector<Names> blocks_of_runs(std::uint64_t k) {
  const std::uint64_t h = (k + 1) / 2;
  std::vector<Names> blocks(k);
  for (std::uint64_t i = 0; i + 3 <= k; ++i) {
    const auto put = [&](std::uint64_t from, std::uint64_t to, const std::string& element) {
      for (std::uint64_t j = from % k;; j = (j + 1) % k) {
        blocks[j].insert(element);
        if (j == to % k) {
          break;
        }
      }
    };
    put(i * (h - 1) + k - 1, (i + 1) * (h - 1) + k - 1, fmt::format("{}_s", i));
    put(i * h, (i + 1) * h, fmt::format("{}_l", i));
  }
  for (const std::uint64_t j : {(k - 1) / 2, k - 1}) {
    blocks[j].insert("∞_s");
  }
  for (const std::uint64_t j : {std::uint64_t{0}, (k - 1) / 2}) {
    blocks[j].insert("∞_l");
  }
  return blocks;
}

// The three blocks that the proof displays.
std::map<std::uint64_t, Names> displayed_blocks(std::uint64_t k) {
  Names first{"∞_l", "0_l"};
  Names middle{"∞_l", "∞_s"};
  Names last{"∞_s", fmt::format("{}_l", k - 3)};
  for (std::uint64_t i = 0; i + 3 <= k; ++i) {
    first.insert(fmt::format("{}_{}", i, i % 2 == 0 ? "s" : "l"));
    middle.insert(fmt::format("{}_{}", i, i % 2 == 0 ? "l" : "s"));
    last.insert(fmt::format("{}_{}", i, i % 2 == 0 ? "s" : "l"));
  }
  return {{0, first}, {(k - 1) / 2, middle}, {k - 1, last}};
}

PaperItem check_runs(const PaperContext& context) {
  Check check("Theorem 4",
              "the proof: runs of (k+1)/2 and (k+3)/2 blocks, and the three displayed blocks",
              "blocks");
  for (std::uint64_t k = 5; k <= context.options.largest_k; k += 2) {
    const std::optional<Design> design =
        construct(context.registry, "short-long-runs", circular(2 * k - 2, k));
    if (!design) {
      check.lacks("short-long-runs");
      return std::move(check).finish();
    }
    const std::vector<Names> runs = blocks_of_runs(k);
    const std::map<std::uint64_t, Names> displayed = displayed_blocks(k);
    for (std::size_t i = 0; i < design->block_count(); ++i) {
      Names built;
      for (const Element x : design->block(i)) {
        built.insert(design->label(x));
      }
      const auto shown = displayed.find(i);
      check.expect(i < runs.size() && built == runs[i] &&
                       (shown == displayed.end() || built == shown->second),
                   [&] {
                     return PaperFinding{fmt::format("B_{} for k = {}", i, k),
                                         braces(design->block(i), *design),
                                         "rebuilt from the runs"};
                   });
    }
    const Verdict verdict = verify(*design);
    std::uint64_t twice = 0;
    std::uint64_t shorter = 0;
    std::uint64_t longer = 0;
    for (const ElementCount& element : verdict.elements) {
      twice += element.introductions == 2 && element.blocks == 2 ? 1U : 0U;
      shorter += element.introductions == 1 && element.blocks == (k + 1) / 2 ? 1U : 0U;
      longer += element.introductions == 1 && element.blocks == (k + 3) / 2 ? 1U : 0U;
    }
    check.expect(twice == 2 && shorter == k - 2 && longer == k - 2,
                 {"2 elements twice, k-2 short runs, k-2 long runs",
                  fmt::format("{}, {}, {} for k = {}", twice, shorter, longer, k), "counted"});
  }
  return std::move(check).finish();
}

// "As every element in a tight circular DCCD(2k−2,k,k−1) is introduced exactly once", the step to
// Theorem 8.
PaperItem check_introduced_once(const PaperContext& context) {
  Check check("Section 3.2",
              "every element of a tight circular DCCD(2k-2,k,k-1) is introduced exactly once",
              "designs");
  std::vector<Design> designs = enumerate(circular(6, 4), 3, {.keep = 100'000}).designs;
  const std::size_t all_of_four = designs.size();
  for (std::uint64_t k = 6; k <= context.options.largest_k; k += 2) {
    if (auto design = construct(context.registry, "doubling", circular(2 * k - 2, k))) {
      designs.push_back(*std::move(design));
    }
  }
  for (const Design& design : designs) {
    const Verdict verdict = verify(design);
    check.expect(verdict.tight() && std::ranges::all_of(
                                        verdict.elements,
                                        [](const ElementCount& x) { return x.introductions == 1; }),
                 {"every element is introduced once",
                  fmt::format("not so in the {}", name(design.parameters())), in_words(verdict)});
  }
  check.note(fmt::format(
      "all {} with k = 4 that begin with {{0,1,2,3}}, and one for each even k <= {}; for "
      "all of them by the count of introductions in the proof of Theorem 3",
      all_of_four, context.options.largest_k));
  return std::move(check).finish();
}

PaperItem check_expansion_iff_4(const PaperContext& context) {
  Check check("Proposition 7", claim_at(context.paper, "Proposition 7"), "designs");
  for (std::uint64_t k = 3; k <= context.options.largest_k; ++k) {
    const bool divides = (2 * k - 2) % (k - 2) == 0;
    check.expect(divides == (k == 3 || k == 4),
                 {"k-2 divides v if and only if k = 3 or 4", fmt::format("k = {}", k), "computed"},
                 0);
  }
  for (std::uint64_t k = 4; k <= context.options.largest_k; k += 2) {
    const std::optional<Design> design =
        construct(context.registry, "doubling", circular(2 * k - 2, k));
    if (!design) {
      check.lacks("doubling");
      return std::move(check).finish();
    }
    const ExpansionSearch search = find_expansion_sets(*design, {.how_many = 1, .limits = {}});
    check.expect(search.complete || !search.sets.empty(),
                 {"decided", fmt::format("k = {} is not", k), search.reason}, 0);
    check.expect(search.sets.empty() == (k != 4),
                 {"an expansion set if and only if k = 4",
                  fmt::format("k = {}: {}", k, search.sets.empty() ? "none" : "there is one"),
                  search.reason});
  }
  return std::move(check).finish();
}

PaperItem check_unique() {
  Check check("Proposition 7", "the proof: all circular DCCD(6,4,3) are isomorphic", "designs");
  const Enumeration all = enumerate(circular(6, 4), 3, {.keep = 100'000});
  check.expect(all.complete && all.found > 0,
               {"designs to compare", "the enumeration did not end", "by exhaustion"}, 0);
  for (const Design& design : all.designs) {
    check.expect(same_up_to_relabelling(all.designs.front(), design),
                 {"isomorphic",
                  fmt::format("another one: {}, {}, {}", braces(design.block(0)),
                              braces(design.block(1)), braces(design.block(2))),
                  "by exhaustion"});
  }
  check.note(
      fmt::format("{} designs that begin with {{0,1,2,3}}, one up to relabelling", all.found));
  return std::move(check).finish();
}

void add_table(std::vector<PaperItem>& items, const PaperContext& context, std::string_view place,
               std::string_view construction, const std::string& how) {
  const PrintedTable& table = table_at(context.paper, place);
  if (const auto rebuilt = construct(context.registry, construction, table.parameters)) {
    items.push_back(check_blocks(table, *rebuilt, how));
  } else {
    Check check(table.place, table.caption, "blocks");
    check.lacks(construction);
    items.push_back(std::move(check).finish());
  }
  items.push_back(check_marks(table));
}

}  // namespace

std::vector<PaperItem> check_doubling(const PaperContext& context) {
  std::vector<PaperItem> items{
      check_doubled_single_change(context), check_cyclic_single_change(context.paper),
      check_family(context, "Theorem 3", "doubling", true), check_nonexistence(context)};
  for (PaperItem& item : check_proof_for_odd_k(context)) {
    items.push_back(std::move(item));
  }
  add_table(items, context, "Table 4 (left)", "mcsorley-circular", "developed from {0,1} over Z_3");
  add_table(items, context, "Table 4 (right)", "doubling", "by Theorem 3 from the left one");
  items.push_back(check_family(context, "Theorem 4", "short-long-runs", false));
  items.push_back(check_runs(context));
  items.push_back(check_minimum(context));
  add_table(items, context, "Table 5", "short-long-runs", "by Theorem 4 (Example 5)");
  add_table(items, context, "Table 6", "short-long-runs", "by Theorem 4 (Example 6)");
  items.push_back(check_expansion_iff_4(context));
  items.push_back(check_unique());
  const PrintedTable& table_7 = table_at(context.paper, "Table 7");
  if (const auto rebuilt =
          expanded_as_printed(context.paper, "Table 4 (right)", Kind::circular, "K_4 of Table 7")) {
    items.push_back(check_blocks(table_7, *rebuilt, "expanded from Table 4 with 1-factors of K_4"));
  } else {
    Check check(table_7.place, table_7.caption, "blocks");
    check.expect(false, {"Table 4 expanded with the 1-factors of K_4", "that cannot be done",
                         "the carets mark no expansion set"});
    items.push_back(std::move(check).finish());
  }
  items.push_back(check_marks(table_7));
  items.push_back(check_introduced_once(context));
  items.push_back(check_family(context, "Theorem 8", "fixed-element", true));
  return items;
}

}  // namespace changeover
