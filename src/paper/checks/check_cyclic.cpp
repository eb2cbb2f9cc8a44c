// Section 3.2, second part: designs developed from base blocks over Z_v.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "changeover/core/design.hpp"
#include "changeover/core/developed.hpp"
#include "changeover/core/error.hpp"
#include "changeover/verify/difference.hpp"
#include "core/each.hpp"
#include "paper/checks/checking.hpp"
#include "paper/checks/checks.hpp"

namespace changeover {
namespace {

using EdgeSet = std::set<std::pair<Element, Element>>;

std::string in_words(const EdgeSet& edges) {
  std::vector<std::string> words;
  for (const auto& [x, y] : edges) {
    words.push_back(fmt::format("{}-{}", x, y));
  }
  return fmt::format("{}", fmt::join(words, " "));
}

EdgeSet edges_in(const std::string& text) {
  EdgeSet edges;
  for (std::string word : words(text)) {
    std::ranges::replace(word, '-', ' ');
    const std::vector<Block> ends = blocks_in(word);  // one line, two numbers
    if (ends.size() != 1 || ends.front().size() != 2) {
      throw BadInput(fmt::format("\"{}\" is not a chord", word));
    }
    edges.insert(std::minmax(ends.front()[0], ends.front()[1]));
  }
  return edges;
}

Block elements_in(const std::string& text) {
  const std::vector<Block> blocks = blocks_in(text);
  return blocks.empty() ? Block{} : sorted(blocks.front());
}

// The picture against two consecutive blocks of a table.
PaperItem check_circle(const PrintedCircle& circle, const PrintedTable& table) {
  Check check(circle.place,
              fmt::format("blocks {{{}}} and {{{}}} of {}: vertices by colour, chords, differences",
                          fmt::join(words(circle.first), ","), fmt::join(words(circle.second), ","),
                          table.place),
              "vertices and chords");
  const Block first = elements_in(circle.first);
  const Block second = elements_in(circle.second);
  const auto compare = [&](const std::string& printed, const Block& truth,
                           const std::string& what) {
    check.expect(elements_in(printed) == sorted(truth),
                 {fmt::format("{}: {}", what, braces(elements_in(printed))), braces(truth),
                  "the two blocks"},
                 truth.size());
  };
  compare(circle.black, intersection(first, second), "black");
  compare(circle.first_only, changeover::difference(first, second), "in the first colour");
  compare(circle.second_only, changeover::difference(second, first), "in the second colour");

  const Design design = printed_design(table, Kind::circular);
  DesignSource source(design);
  std::size_t seen = 0;
  for (Transitions steps(source); steps.next();) {
    const Block block = sorted(Block(steps.block().begin(), steps.block().end()));
    if (block != first && block != second) {
      continue;
    }
    ++seen;
    EdgeSet covered;
    std::set<std::uint64_t> lengths;
    for (const Element x : steps.introduced()) {
      for (const Element y : steps.block()) {
        if (x != y) {
          covered.insert(std::minmax(x, y));
          const std::uint64_t d = x > y ? x - y : y - x;
          lengths.insert(std::min(d, circle.v - d));
        }
      }
    }
    const EdgeSet drawn = edges_in(block == first ? circle.first_edges : circle.second_edges);
    check.expect(drawn == covered,
                 {fmt::format("chords {}", in_words(drawn)), in_words(covered),
                  fmt::format("the pairs covered in {}", braces(block))},
                 covered.size());
    // With one base block each block shows every difference.
    if (circle.v == 4 * table.parameters.k - 5) {
      check.expect(lengths.size() == (circle.v - 1) / 2,
                   {"every difference appears as a length",
                    fmt::format("{} of {} do", lengths.size(), (circle.v - 1) / 2), braces(block)});
    }
  }
  check.expect(seen == 2, {fmt::format("two blocks of {}", table.place),
                           fmt::format("{} of them are", seen), "compared"});
  return std::move(check).finish();
}

std::string in_words(const std::vector<Block>& blocks) {
  return joined(blocks, [&](const Block& block) { return braces(sorted(block)); });
}

bool same_blocks(const std::vector<Block>& a, const std::vector<Block>& b) {
  return std::ranges::equal(a, b,
                            [](const Block& x, const Block& y) { return sorted(x) == sorted(y); });
}

Parameters cyclic_parameters(std::uint64_t c, std::uint64_t k) {
  return circular(c * (4 * k - 6) + 1, k);
}

PaperItem check_theorem(const PaperContext& context) {
  Check check("Theorem 10", fmt::format("{} (Table 9)", claim_at(context.paper, "Theorem 10")),
              "comparisons");
  const Construction* const construction = check.finds(context.registry, "cyclic-paper");
  if (construction == nullptr) {
    return std::move(check).finish();
  }
  std::uint64_t rows = 0;
  for (const PrintedBaseBlocks& row : context.paper.cyclic) {
    rows += row.c == rows + 1 ? 1U : 0U;
    for (std::uint64_t k = 3; k <= context.options.largest_k; ++k) {
      const Parameters p = cyclic_parameters(row.c, k);
      const BaseBlocks printed{p, base_blocks(row, k)};
      const std::string where = fmt::format("c = {}, k = {}", row.c, k);
      const auto offer = construction->offer(p, context.registry);
      const auto base = offer ? construction->base_blocks(offer->recipe) : std::nullopt;
      if (!check.expect(base && same_blocks(base->blocks, printed.blocks), [&] {
            return PaperFinding{
                fmt::format("base blocks for {}: {}", where, in_words(printed.blocks)),
                base ? in_words(base->blocks) : "not offered", "the construction"};
          })) {
        continue;
      }
      const DifferenceVerdict differences = verify_differences(printed);
      check.expect(differences.valid() && differences.tight,
                   {fmt::format("{}: every difference is covered exactly once", where),
                    fmt::format("{} differences uncovered, {} steps wrong", differences.uncovered,
                                differences.bad_steps),
                    in_words(printed.blocks)});
      DevelopedSource source(printed);
      const Design design = read_all(source);
      const Values values{{'c', row.c}, {'k', k}};
      const PrintedDesign& family = context.paper.cyclic_family;
      check.expect(
          count_of(family.v, values) == design.v(),
          {fmt::format("{}: v = {} = {}", where, family.v, value_of(family.v, values).to_string()),
           fmt::format("v = {}", design.v()), "developed"},
          0);
      expect_design(check, design, {.b = count_of(family.b, values), .tight = true});
      // "the elements introduced in B_{i,j} are B_{i,j} \ (A+j)": what is kept is A+j.
      const std::vector<UnchangedSubset> between = unchanged_subsets(design);
      check.expect(std::ranges::all_of(between,
                                       [&](const UnchangedSubset& subset) {
                                         Block shifted;
                                         for (std::uint64_t a = 0; a + 2 < k; ++a) {
                                           shifted.push_back(static_cast<Element>(
                                               (a + subset.position / row.c) % p.v));
                                         }
                                         return subset.elements == sorted(shifted);
                                       }),
                   {fmt::format("{}: A+j is kept", where), "another subset is", "verified"});
    }
  }
  check.expect(rows == context.paper.cyclic_up_to,
               {fmt::format("1 <= c <= {}", context.paper.cyclic_up_to),
                fmt::format("Table 9 has c = 1, ..., {}", rows), "counted"});
  check.note(
      fmt::format("k <= {}: base blocks as printed, differences, and every design in full; b is "
                  "the lower bound",
                  context.options.largest_k));
  return std::move(check).finish();
}

// "The elements introduced in block B_{i,j} are B_{i,j} \ (A+j)."
PaperItem check_introduced(const PaperContext& context) {
  Check check(
      "Theorem 10",
      "the proof: the elements introduced in B_{i,j} are those of B_{i,j} that are not in A+j",
      "blocks");
  for (const PrintedBaseBlocks& row : context.paper.cyclic) {
    for (std::uint64_t k = 3; k <= context.options.largest_k; ++k) {
      const Parameters p = cyclic_parameters(row.c, k);
      DevelopedSource source(BaseBlocks{p, base_blocks(row, k)});
      for (Transitions steps(source); steps.next();) {
        const std::uint64_t j = steps.index() / row.c;
        Block fresh;
        for (const Element x : steps.block()) {
          if ((x + p.v - j) % p.v >= k - 2) {
            fresh.push_back(x);
          }
        }
        const Block introduced = sorted(steps.introduced());
        check.expect(introduced == sorted(fresh),
                     {fmt::format("c = {}, k = {}: {} are introduced in B_{{{},{}}}", row.c, k,
                                  braces(sorted(fresh)), steps.index() % row.c, j),
                      braces(introduced), "against the block before"});
      }
    }
  }
  check.note(fmt::format("c = 1, ..., {} and k <= {}, every block", context.paper.cyclic.size(),
                         context.options.largest_k));
  return std::move(check).finish();
}

// The intervals of differences that the proof lists for c = 1 and c = 2.
PaperItem check_proof(const PaperContext& context) {
  Check check("Theorem 10", "the proof: the differences listed for c = 1 and c = 2", "differences");
  for (const PrintedBaseBlocks& row : context.paper.cyclic) {
    const auto listed = std::ranges::find(context.paper.differences, row.c, &PrintedDifferences::c);
    if (listed == context.paper.differences.end()) {
      continue;
    }
    for (std::uint64_t k = 3; k <= context.options.largest_k; ++k) {
      const std::uint64_t v = cyclic_parameters(row.c, k).v;
      check.expect(
          count_of(listed->v, {{'k', k}}) == v,
          [&] {
            return PaperFinding{
                fmt::format("c = {}: the differences in Z_v, v = {}", row.c, listed->v),
                fmt::format("v = {} for k = {}", v, k), "Theorem 10"};
          },
          0);
      const std::vector<Block> blocks = base_blocks(row, k);
      for (std::size_t i = 0; i < blocks.size() && i < listed->blocks.size(); ++i) {
        std::multiset<std::uint64_t> differences;
        const Block& block = blocks[i];
        for (std::size_t x = 0; x < block.size(); ++x) {
          for (std::size_t y = std::max<std::size_t>(x + 1, k - 2); y < block.size(); ++y) {
            const std::uint64_t d = (block[y] + v - block[x]) % v;
            differences.insert(std::min(d, v - d));
          }
        }
        std::multiset<std::uint64_t> printed;
        for (const auto& [from, to] : listed->blocks[i]) {
          const std::uint64_t last = count_of(to, {{'k', k}});
          for (std::uint64_t d = count_of(from, {{'k', k}}); d <= last; ++d) {
            printed.insert(d);
          }
        }
        check.expect(printed == differences,
                     {fmt::format("c = {}, k = {}: {}", row.c, k, fmt::join(printed, ",")),
                      fmt::format("{}", fmt::join(differences, ",")), braces(block)},
                     differences.size());
      }
    }
  }
  return std::move(check).finish();
}

// What two base blocks over Z_13 keep from the second to the successor of the first.
Block kept(const std::vector<Block>& base) {
  if (base.size() != 2) {
    return {};
  }
  Block next = base[0];
  for (Element& x : next) {
    x = (x + 1) % 13;
  }
  return intersection(base[1], next);
}

// Example 12 takes base blocks "from Theorem 10": in the order of Table 9?
PaperItem check_order_of_base_blocks(const Paper& paper) {
  Check check("Example 12", "base blocks B_{0,0} and B_{1,0} from Theorem 10 for c = 2 and k = 3",
              "blocks");
  const std::vector<Block> example = blocks_in(paper.base_blocks_in_example);
  for (const PrintedBaseBlocks& row : paper.cyclic) {
    if (row.c != 2) {
      continue;
    }
    const std::vector<Block> theorem = base_blocks(row, 3);
    check.expect(
        same_blocks(example, theorem),
        [&] {
          const bool swapped = example.size() == 2 && theorem.size() == 2 &&
                               same_blocks({example[1], example[0]}, theorem);
          const DifferenceVerdict verdict = verify_differences({cyclic_parameters(2, 3), example});
          return PaperFinding{
              fmt::format("B_{{0,0}}, B_{{1,0}} = {} from Theorem 10", in_words(example)),
              fmt::format("Table 9 with c = 2, k = 3 gives {}{}", in_words(theorem),
                          swapped ? ": the other order" : ""),
              fmt::format(
                  "developed in the order of the example they make {} too, but another one: "
                  "{} and not A+1 = {{1}} is kept from B_{{1,0}} to B_{{0,1}}",
                  verdict.valid() && verdict.tight ? "a tight circular DCCD(13,3,26)"
                                                   : "no tight design",
                  braces(kept(example)))};
        },
        2);
  }
  return std::move(check).finish();
}

// "We believe that this method will work to construct tight circular DCCDs for larger c."
PaperItem check_larger_c(const PaperContext& context) {
  Check check("Section 3.2", "\"we believe that this method will work ... for larger c\"",
              "designs");
  check.of_a_statement();
  const Construction* const construction = check.finds(context.registry, "cyclic");
  if (construction == nullptr) {
    return std::move(check).finish();
  }
  constexpr std::uint64_t largest_c = 60;
  constexpr std::uint64_t largest_k = 12;
  for (std::uint64_t c = context.paper.cyclic_up_to + 1; c <= largest_c; ++c) {
    for (std::uint64_t k = 3; k <= largest_k; ++k) {
      const Parameters p = cyclic_parameters(c, k);
      const auto offer = construction->offer(p, context.registry);
      const auto base = offer ? construction->base_blocks(offer->recipe) : std::nullopt;
      // The method: c base blocks A ∪ {x,y}, A = {0,…,k−3}, developed over Z_v.
      const bool of_the_method = base && base->blocks.size() == c &&
                                 std::ranges::all_of(base->blocks, [&](const Block& block) {
                                   const Block in_order = sorted(block);
                                   for (Element a = 0; a + 2 < k; ++a) {
                                     if (in_order[a] != a) {
                                       return false;
                                     }
                                   }
                                   return true;
                                 });
      check.expect(
          of_the_method && base->parameters.v == p.v,
          {"the method works", fmt::format("not for c = {}, k = {}", c, k), "no such base blocks"});
      if (of_the_method) {
        const DifferenceVerdict verdict = verify_differences(*base);
        check.expect(
            verdict.valid() && verdict.tight && verdict.b == c * p.v,
            [&] {
              return PaperFinding{"the method works", fmt::format("not for c = {}, k = {}", c, k),
                                  in_words(base->blocks)};
            },
            0);
      }
    }
  }
  check.note(
      fmt::format("proved for every c >= 1 and k >= 3: docs/theorems.md, Theorem 1; here its base "
                  "blocks for c = {}, ..., {} and k <= {}, by differences",
                  context.paper.cyclic_up_to + 1, largest_c, largest_k));
  return std::move(check).finish();
}

// "Every pair of distinct elements has difference ±d for some 1 ≤ d ≤ (v−1)/2."
PaperItem check_half_differences(const Paper& paper) {
  constexpr std::uint64_t largest_v = 60;
  Check check("Section 3.2", "in Z_v every pair has a difference ±d with 1 <= d <= (v-1)/2",
              "values of v");
  std::uint64_t even = 0;
  std::uint64_t wrong = 0;
  for (std::uint64_t v = 3; v <= largest_v; ++v) {
    const Fraction largest = value_of(paper.cited.largest_difference, {{'v', v}});
    std::uint64_t without = 0;  // the least difference of that kind
    for (std::uint64_t d = v - 1; d >= 1; --d) {
      const auto least = static_cast<std::int64_t>(std::min(d, v - d));
      without = least * largest.denominator <= largest.numerator ? without : d;
    }
    check.expect(without == 0 || wrong > 0,
                 {"every pair of distinct elements of Z_v",
                  fmt::format("{{0,{0}}} in Z_{1} has the difference {0} = -{0}", without, v),
                  "a proviso is missing: v is odd, as it is in all that follows"});
    even += without != 0 && v % 2 == 0 ? 1U : 0U;
    wrong += without != 0 ? 1U : 0U;
  }
  check.note(fmt::format("false for {} v <= {}, {} of them even", wrong, largest_v, even));
  return std::move(check).finish();
}

// "All differences from 1, 2, …, 12 (mod 13) are covered in these two blocks."
PaperItem check_differences_of_example(const Paper& paper) {
  Check check("Example 12",
              "all differences 1, ..., 12 (mod 13) are covered in its two base blocks",
              "differences");
  const std::vector<Block> base = blocks_in(paper.base_blocks_in_example);
  const DifferenceVerdict verdict = verify_differences({cyclic_parameters(2, 3), base});
  check.expect(verdict.valid() && verdict.uncovered == 0,
               {"all differences are covered",
                fmt::format("{} are not, {} steps are wrong", verdict.uncovered, verdict.bad_steps),
                in_words(base)},
               12);
  return std::move(check).finish();
}

void add_developed(std::vector<PaperItem>& items, const Paper& paper, std::string_view place,
                   const std::vector<Block>& base, const std::string& how) {
  const PrintedTable& table = table_at(paper, place);
  try {
    DevelopedSource source({table.parameters, base});
    items.push_back(check_blocks(table, read_all(source), how));
  } catch (const BadInput& fault) {
    Check check(table.place, table.caption, "blocks");
    check.expect(false, {"base blocks", "they cannot be developed", fault.what()});
    items.push_back(std::move(check).finish());
  }
  items.push_back(check_marks(table));
}

std::vector<Block> row_of(const Paper& paper, std::uint64_t c, std::uint64_t k) {
  for (const PrintedBaseBlocks& row : paper.cyclic) {
    if (row.c == c) {
      return base_blocks(row, k);
    }
  }
  return {};
}

}  // namespace

std::vector<PaperItem> check_cyclic(const PaperContext& context) {
  const Paper& paper = context.paper;
  std::vector<PaperItem> items;
  const auto add_circles = [&](std::string_view figure, std::string_view table) {
    for (const PrintedCircle& circle : paper.circles) {
      if (circle.place.starts_with(figure)) {
        items.push_back(check_circle(circle, table_at(paper, table)));
      }
    }
  };
  items.push_back(check_half_differences(paper));
  add_circles("Figure 3", "Table 8");
  add_developed(items, paper, "Table 8", row_of(paper, 1, 4),
                "developed from the row c = 1 of Table 9 (Example 9)");
  items.push_back(check_theorem(context));
  items.push_back(check_introduced(context));
  items.push_back(check_proof(context));
  add_developed(items, paper, "Table 10", row_of(paper, 2, 4),
                "developed from the row c = 2 of Table 9 (Example 11)");
  items.push_back(check_order_of_base_blocks(paper));
  items.push_back(check_differences_of_example(paper));
  add_circles("Figure 4", "Table 11");
  add_developed(items, paper, "Table 11", blocks_in(paper.base_blocks_in_example),
                "developed from the base blocks of Example 12 in its order");
  items.push_back(check_larger_c(context));
  return items;
}

}  // namespace changeover
