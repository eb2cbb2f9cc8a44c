// Section 2.1, the rest: what the paper cites from other works.
#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "changeover/bounds/lower_bound.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "paper/checks/checking.hpp"
#include "paper/checks/checks.hpp"
#include "paper/checks/enumeration.hpp"

namespace changeover {
namespace {

// What is known of the minimum for some parameters: our best design, verified, and the lower bound.
struct Known {
  std::optional<std::uint64_t> b;
  Bound bound;

  [[nodiscard]] bool is_minimum() const { return b == bound.blocks; }
};

Known known_minimum(const Registry& registry, const Parameters& p) {
  const std::optional<Design> design = best_design(registry, p);
  return {design ? std::optional<std::uint64_t>(design->block_count()) : std::nullopt,
          lower_bound(p)};
}

std::string in_words(const Known& known) {
  return known.b ? fmt::format("{} blocks are built, the lower bound is {}", *known.b,
                               known.bound.blocks)
                 : fmt::format("none is built, the lower bound is {}", known.bound.blocks);
}

// A minimum is built for these parameters.
void expect_minimum(Check& check, const Registry& registry, const Parameters& p) {
  const Known known = known_minimum(registry, p);
  check.expect(known.is_minimum(),
               {fmt::format("a minimum {}", name(p)), in_words(known), known.bound.reason});
}

// "Minimum SCCDs of block sizes two, three and four."
PaperItem check_cited_single_change(const PaperContext& context) {
  constexpr std::uint64_t largest_v = 40;
  Check check("Section 2.1",
              fmt::format("cited: all minimum SCCDs are constructed for k = {}",
                          fmt::join(context.paper.cited.single_k, ", ")),
              "designs");
  if (check.finds(context.registry, "pairs-single-change") == nullptr) {
    return std::move(check).finish();
  }
  for (const std::uint64_t k : context.paper.cited.single_k) {
    for (std::uint64_t v = k + 1; v <= largest_v; ++v) {
      for (const Kind kind : {Kind::linear, Kind::circular}) {
        expect_minimum(check, context.registry, {.v = v, .k = k, .change = 1, .kind = kind});
      }
    }
  }
  check.note(fmt::format(
      "linear and circular, v <= {}: built by us, as many blocks as the lower bound", largest_v));
  return std::move(check).finish();
}

// "v ≥ k+m if b > 1, because we need at least m additional elements to change between blocks."
PaperItem check_room(const Paper& paper) {
  Check check("Section 2.1", "an m-change design with b > 1 needs v >= k+m", "parameters");
  for (std::uint64_t v = 2; v <= 9; ++v) {
    for (std::uint64_t k = 1; k <= v; ++k) {
      for (std::uint64_t m = 1; m <= k; ++m) {
        const std::uint32_t first = (std::uint32_t{1} << k) - 1;
        bool possible = false;
        for (std::uint32_t second = 0; second < std::uint32_t{1} << v; ++second) {
          possible |= std::popcount(second) == std::popcount(first) &&
                      static_cast<std::uint64_t>(std::popcount(second & ~first)) == m;
        }
        check.expect(
            possible == (v >= count_of(paper.cited.room_v, {{'k', k}, {'m', m}})),
            {fmt::format("a next block exactly if v >= {}", paper.cited.room_v),
             fmt::format("not so for v = {}, k = {}, m = {}", v, k, m), "all k-subsets tried"});
      }
    }
  }
  check.note("every second block tried, v <= 9");
  return std::move(check).finish();
}

PaperItem check_pairs_of_elements(const PaperContext& context) {
  constexpr std::uint64_t largest_v = 12;
  Check check("Section 2.1",
              "cited: linear DCCD(5,2,10), and linear and circular DCCD(v,2,v(v-1)/2) for v >= 6",
              "designs");
  if (check.finds(context.registry, "pairs-double-change") == nullptr) {
    return std::move(check).finish();
  }
  for (std::uint64_t v = 5; v <= largest_v; ++v) {
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      const Parameters p{.v = v, .k = 2, .change = 2, .kind = kind};
      const std::uint64_t b = count_of(context.paper.cited.pairs_b, {{'v', v}});
      if (v == 5 && kind == Kind::circular) {
        const Enumeration all = enumerate(p, 10);
        check.expect(all.complete && all.found == 0,
                     {"only a linear DCCD(5,2,10) is named", "a circular one exists",
                      "found by exhaustion"});
        continue;
      }
      const std::optional<Design> design = construct(context.registry, "pairs-double-change", p);
      const Verdict verdict = design ? verify(*design) : Verdict{};
      check.expect(verdict.valid() && verdict.b == b,
                   {fmt::format("a {} {}", to_string(kind), dccd(v, 2, b)),
                    design ? in_words(verdict) : "none was built",
                    "orders of the pairs, consecutive ones disjoint"});
    }
  }
  check.note(
      fmt::format("built for v <= {}; no circular DCCD(5,2,10) exists (the Petersen graph has no "
                  "Hamilton cycle)",
                  largest_v));
  return std::move(check).finish();
}

// "A Hamilton cycle exists in K_v for all v ≥ 6 as a consequence of Dirac's theorem": n/2
// neighbours are enough.
PaperItem check_dirac() {
  constexpr std::uint64_t largest_v = 100;
  Check check("Section 2.1", "cited: by Dirac's theorem a Hamilton cycle exists in K_v for v >= 6",
              "graphs");
  std::uint64_t in_pairs_from = 0;
  for (std::uint64_t v = 6; v <= largest_v; ++v) {
    const std::uint64_t degree = v - 1;
    check.expect(2 * degree >= v, {fmt::format("Dirac's condition for K_{}", v),
                                   fmt::format("degree {}", degree), "counted"});
    // What a DCCD(v,2) is: a Hamilton path or cycle in the graph of pairs, disjoint ones adjacent.
    if (2 * binomial(v - 2, 2) < binomial(v, 2)) {
      in_pairs_from = v + 1;
    }
  }
  check.note(fmt::format(
      "v <= {}; a DCCD(v,2) needs one in the graph of pairs, disjoint ones adjacent, and there "
      "the condition holds from v = {} on; below, the cycles are built",
      largest_v, in_pairs_from));
  return std::move(check).finish();
}

// "Minimum or near minimum circular DCCD(v,3,b) for all v"; minimum for v ≡ 0, 1, 3, 5 (mod 6).
PaperItem check_triples(const PaperContext& context) {
  constexpr std::uint64_t largest_v = 100;
  Check check("Section 2.1",
              "cited: circular DCCD(v,3,b) for all v, minimum for v = 0, 1, 3, 5 (mod 6)",
              "designs");
  if (check.finds(context.registry, "triples-double-change") == nullptr) {
    return std::move(check).finish();
  }
  std::size_t others = 0;
  std::size_t minimum = 0;
  for (std::uint64_t v = 5; v <= largest_v; ++v) {
    if (v % 6 != 2 && v % 6 != 4) {
      expect_minimum(check, context.registry, circular(v, 3));
      continue;
    }
    const Known known = known_minimum(context.registry, circular(v, 3));
    ++others;
    minimum += known.is_minimum() ? 1U : 0U;
    check.expect(known.b.has_value(),
                 {fmt::format("a circular DCCD({},3,b)", v), "none is built", ""});
  }
  check.note(fmt::format(
      "by our own construction, v <= {}; minimum for {} of the {} with v = 2, 4 (mod 6) too, "
      "which the cited work leaves open",
      largest_v, minimum, others));
  return std::move(check).finish();
}

// "Linear DCCD(3k−5,k,2k−4) are minimum": no fewer blocks can do. That one exists is not said.
PaperItem check_3k_5(const PaperContext& context) {
  const PrintedCited& cited = context.paper.cited;
  Check check("Section 2.1", "cited: linear DCCD(3k-5,k,2k-4) are minimum", "parameters");
  std::size_t none = 0;
  for (std::uint64_t k = 4; k <= context.options.largest_k; ++k) {
    const std::uint64_t v = count_of(cited.minimum_v, {{'k', k}});
    const std::uint64_t b = count_of(cited.minimum_b, {{'k', k}});
    const Fraction bound = counted_bound(v, k, Kind::linear);
    check.expect(bound.count() == b,
                 {fmt::format("no linear DCCD({},{}) has fewer than {} blocks", v, k, b),
                  fmt::format("g1 = {}", bound.to_string()), "counting"});
    if (k <= 5) {
      const Enumeration all = enumerate(linear(v, k), b);
      none += all.complete && all.found == 0 ? 1U : 0U;
    } else {
      none += lower_bound(linear(v, k)).blocks > b ? 1U : 0U;
    }
  }
  const std::uint64_t tried = context.options.largest_k - 3;
  if (none == tried) {
    check.is_vacuous();
  }
  check.note(fmt::format(
      "2k-4 is g1, so such a design would be tight, and no other could have fewer blocks. But for "
      "{} of {} k there is none: for k = 4, 5 by exhaustion, and from k = 6 on by the bound of "
      "stays (docs/theorems.md, Theorem 5), 2b >= 3v-4k+2 = 5k-13, which is more than 2(2k-4) = "
      "4k-8",
      none, tried));
  return std::move(check).finish();
}

bool is_odd_prime_power(std::uint64_t n) {
  for (std::uint64_t p = 3; p <= n; p += 2) {
    if (n % p == 0) {
      while (n % p == 0) {
        n /= p;
      }
      return n == 1;
    }
  }
  return false;
}

// "If 2k−3 is an odd prime power, then minimum linear DCCD(v,k,(2v−2)/3) can only exist if v ≥
// 3k−5."
PaperItem check_prime_power(const PaperContext& context) {
  constexpr std::uint64_t largest_k = 12;
  const PrintedCited& cited = context.paper.cited;
  Check check(
      "Section 2.1",
      "cited: if 2k-3 is an odd prime power, a minimum linear DCCD(v,k,(2v-2)/3) needs v >= 3k-5",
      "parameters");
  check.of_a_statement();
  if (check.finds(context.registry, "small-v") == nullptr) {
    return std::move(check).finish();
  }
  std::vector<std::string> open;
  for (std::uint64_t k = 3; k <= largest_k; ++k) {
    const std::uint64_t least_v = count_of(cited.prime_power_v, {{'k', k}});
    if (!is_odd_prime_power(2 * k - 3)) {
      continue;
    }
    for (std::uint64_t v = k + 2; v < least_v; ++v) {
      const auto b = value_of(cited.prime_power_b, {{'v', v}}).count();
      if (!b) {
        continue;
      }
      const Parameters p = linear(v, k);
      const std::optional<Design> design = best_design(context.registry, p);
      const Bound bound = lower_bound(p);
      const bool excluded = bound.blocks > *b || (design && design->block_count() < *b);
      const bool built = design && design->block_count() == *b && bound.blocks == *b;
      if (!excluded && !built) {
        open.push_back(dccd(v, k, *b));
        continue;
      }
      check.expect(!built, [&] {
        return PaperFinding{
            fmt::format("no minimum linear {}, for {} < {} and 2k-3 = {}", dccd(v, k, *b), v,
                        least_v, 2 * k - 3),
            fmt::format("{} is one", all_blocks(*design)),
            fmt::format("verified; no fewer than {} blocks can do: {}", *b, bound.reason)};
      });
    }
  }
  std::size_t tight = 0;
  for (std::uint64_t k = 3; k <= context.options.largest_k; ++k) {
    for (std::uint64_t v = k + 2; v < count_of(cited.prime_power_v, {{'k', k}}); ++v) {
      tight += counted_bound(v, k, Kind::linear) == value_of(cited.prime_power_b, {{'v', v}});
    }
  }
  check.note(fmt::format(
      "every v below 3k-5 for k <= {}{}; with \"tight\" in the place of \"minimum\" it is right: "
      "g1 - (2v-2)/3 is a quadratic in v with the roots 3k-5 and 2 - k/3, and is 0 at {} places "
      "with k+2 <= v < 3k-5, k <= {}",
      largest_k, open.empty() ? "" : fmt::format(", {} left open", fmt::join(open, ", ")), tight,
      context.options.largest_k));
  return std::move(check).finish();
}

// "Fixed elements do not exist in minimum linear DCCD(v,k,⌈g₁⌉) for v ≥ 3k−6."
PaperItem check_no_fixed_elements(const PaperContext& context) {
  constexpr std::uint64_t beyond = 60;
  const PrintedCited& cited = context.paper.cited;
  Check check(
      "Section 2.1",
      "cited: minimum linear DCCDs with ceil(g1) blocks and v >= 3k-6 have no fixed elements",
      "parameters");
  for (std::uint64_t k = 3; k <= context.options.largest_k; ++k) {
    const std::uint64_t from =
        std::max(k + 2, value_of(cited.no_fixed_from, {{'k', k}}).count().value_or(0));
    for (std::uint64_t v = from; v <= from + beyond; ++v) {
      const Fraction b = value_of(cited.linear_b, {{'v', v}, {'k', k}});
      check.expect(
          b == Fraction{counted_bound(v, k, Kind::linear).ceiling(), 1},
          {fmt::format("b = {} for v = {}, k = {}", b.to_string(), v, k),
           fmt::format("ceil(g1) = {}", counted_bound(v, k, Kind::linear).ceiling()), "counting"});
      const std::int64_t without = counted_bound(v - 1, k - 1, Kind::linear).ceiling();
      check.expect(without > b.ceiling(),
                   {fmt::format("no fixed element for v = {}, k = {}", v, k),
                    fmt::format("{} blocks may do for v-1, k-1", without), "counting"});
    }
  }
  check.note(fmt::format(
      "by counting: delete a fixed element, and a linear DCCD(v-1,k-1) with as many blocks is "
      "left, which has too few; 3 <= k <= {}, the first {} values of v of each",
      context.options.largest_k, beyond + 1));
  return std::move(check).finish();
}

// "… nor minimum DCCD(v,4,⌈(v²−v−12)/10⌉), v ≥ 6."
PaperItem check_k4_formula(const PaperContext& context) {
  Check check("Section 2.1", "cited: the number of blocks of the minimum DCCD(v,4,b), v >= 6",
              "values");
  std::size_t wrong = 0;
  std::size_t impossible = 0;
  for (std::uint64_t v = 6; v <= 100; ++v) {
    const Fraction printed = value_of(context.paper.cited.k4_b, {{'v', v}});
    const std::int64_t g1 = counted_bound(v, 4, Kind::linear).ceiling();
    const bool right = printed == Fraction{g1, 1};
    const PaperFinding finding{
        fmt::format("DCCD(v,4,b) with b = {}", context.paper.cited.k4_b),
        fmt::format("b = g1(v,4) = {} and not {} for v = {}", g1, printed.to_string(), v),
        "the formula for general k in the same sentence, which ends in + 1, gives this for "
        "k = 4"};
    check.expect(right || wrong > 0, finding);  // one finding says it for all
    if (!right) {
      ++wrong;
      impossible += printed.ceiling() < g1 && static_cast<std::uint64_t>(printed.ceiling()) <
                                                  lower_bound(circular(v, 4)).blocks
                        ? 1U
                        : 0U;
    }
  }
  if (wrong > 0) {
    check.note(fmt::format(
        "wrong for {} of 95 values of v, and below the bounds for linear and for circular designs "
        "for {}; that there are no fixed elements is right for linear ones, by the item above",
        wrong, impossible));
  }
  return std::move(check).finish();
}

// "Minimum circular DCCD(v,k,⌈g₂⌉) have a fixed element if and only if v = 2k−3."
PaperItem check_fixed_elements(const PaperContext& context) {
  Check check(
      "Section 2.1",
      "cited: a minimum circular DCCD(v,k,ceil(v(v-1)/(4(k-2)+2))) has a fixed element if and "
      "only if v = 2k-3",
      "designs");
  check.of_a_statement();
  const Enumeration all = enumerate(circular(7, 5), 3, {.keep = 10'000});
  for (const Design& design : all.designs) {
    check.expect(
        !verify(design).fixed.empty(),
        {"every circular DCCD(7,5,3) has a fixed element",
         fmt::format("one without: it begins {}", braces(design.block(0))), "by exhaustion"});
  }
  bool told = false;
  std::uint64_t once = 0;
  const auto compare = [&](const Design& design) {
    const Verdict verdict = verify(design);
    const std::vector<std::uint64_t> times = times_covered(design);
    if (std::ranges::all_of(times, [](std::uint64_t n) { return n == 1; })) {
      ++once;
      const bool at = design.v() == count_of(context.paper.cited.fixed_at, {{'k', design.k()}});
      check.expect(at == !verdict.fixed.empty(),
                   {"where every pair is covered once, a fixed element exactly if v = 2k-3",
                    fmt::format("the {} has {}", name(design.parameters()), braces(verdict.fixed)),
                    "verified"});
    }
    const std::uint64_t g2 = static_cast<std::uint64_t>(
        value_of(context.paper.cited.circular_b, {{'v', design.v()}, {'k', design.k()}}).ceiling());
    const Bound bound = lower_bound(design.parameters());
    if (verdict.fixed.empty() || verdict.b != g2 || verdict.b != bound.blocks) {
      return;
    }
    const bool holds = design.v() == count_of(context.paper.cited.fixed_at, {{'k', design.k()}});
    check.expect(holds || told, [&] {
      const std::size_t fixed = verdict.fixed.size();
      return PaperFinding{
          "no fixed element unless v = 2k-3",
          fmt::format("a circular {} with ceil(g2) = {} blocks has {}, and 2k-3 = {}",
                      dccd(design.v(), design.k(), verdict.b), g2, count_of(fixed, "fixed element"),
                      2 * design.k() - 3),
          fmt::format("add {} to every block of the circular {}; it is minimum, for {}",
                      count_of(fixed, "element"),
                      dccd(design.v() - fixed, design.k() - fixed, verdict.b), bound.reason)};
    });
    told = told || !holds;
  };
  for (const Design& design : designs_to_try(context.registry, Kind::circular)) {
    compare(design);
  }
  // Beyond 2k-3 the least example has one fixed element.
  told = false;
  for (std::uint64_t k = 5; k <= 8 && !told; ++k) {
    for (std::uint64_t v = 2 * k - 2; v <= 2 * k && !told; ++v) {
      if (const auto smaller = best_design(context.registry, circular(v - 1, k - 1))) {
        compare(with_fixed_elements(*smaller, 1));
      }
    }
  }
  check.note(fmt::format(
      "right where every pair is covered exactly once ({} designs compared): if x is in every "
      "block, every other element is introduced once, so 2b = v-1, and b = g2 gives v = 2k-3; and "
      "at v = 2k-3 the k-2 blocks introduce 2k-4 of the 2k-3 elements. All {} circular "
      "DCCD(7,5,3) that begin with {{0,1,2,3,4}} have one",
      once, all.found));
  return std::move(check).finish();
}

// "Constructions for minimum DCCD(v,4,b) when v = 6, …, 14."
PaperItem check_fours(const PaperContext& context) {
  const PrintedCited& cited = context.paper.cited;
  Check check("Section 2.1",
              fmt::format("cited: minimum DCCD(v,4,b) are constructed for v = {}, ..., {}",
                          cited.k4_from, cited.k4_to),
              "designs");
  if (check.finds(context.registry, "found") == nullptr) {
    return std::move(check).finish();
  }
  std::vector<std::uint64_t> minima;
  std::vector<std::string> open;
  for (std::uint64_t v = cited.k4_from; v <= cited.k4_to; ++v) {
    const Known as_circular = known_minimum(context.registry, circular(v, 4));
    const Known as_linear = known_minimum(context.registry, linear(v, 4));
    check.expect(
        as_circular.is_minimum() || as_linear.is_minimum(),
        {fmt::format("a minimum DCCD({},4,b)", v),
         fmt::format("circular: {}; linear: {}", in_words(as_circular), in_words(as_linear)),
         as_circular.bound.reason});
    minima.push_back(as_circular.bound.blocks);
    if (!as_linear.is_minimum()) {
      open.push_back(fmt::format("v = {}: {}", v, in_words(as_linear)));
    }
  }
  check.note(fmt::format("circular minima {}{}", fmt::join(minima, ", "),
                         open.empty() ? "; linear ones too"
                                      : fmt::format("; linear ones are settled except for {}",
                                                    fmt::join(open, "; "))));
  return std::move(check).finish();
}

// "General constructions for circular DCCD(v,4,b) that are not necessarily minimum."
PaperItem check_any_fours(const PaperContext& context) {
  constexpr std::uint64_t largest_v = 60;
  Check check("Section 2.1", "cited: circular DCCD(v,4,b), not necessarily minimum", "designs");
  if (check.finds(context.registry, "partial-expansion") == nullptr) {
    return std::move(check).finish();
  }
  std::size_t minimum = 0;
  for (std::uint64_t v = 6; v <= largest_v; ++v) {
    const auto offer = context.registry.best(circular(v, 4));
    const Verdict verdict =
        offer ? verify(context.registry.build_design(offer->recipe)) : Verdict{};
    check.expect(verdict.valid(),
                 {fmt::format("a circular DCCD({},4,b)", v), in_words(verdict), "built"});
    minimum += verdict.valid() && verdict.b == lower_bound(circular(v, 4)).blocks ? 1U : 0U;
  }
  check.note(fmt::format("by our own constructions, 6 <= v <= {}, {} of them minimum", largest_v,
                         minimum));
  return std::move(check).finish();
}

}  // namespace

std::vector<PaperItem> check_cited(const PaperContext& context) {
  return {
      check_cited_single_change(context),
      not_checkable(
          "Section 2.1",
          "cited: minimum SCCDs are constructed for four classes of v modulo 16 with k = 5",
          "the paper does not say which classes"),
      check_room(context.paper),
      check_pairs_of_elements(context),
      check_dirac(),
      check_triples(context),
      check_3k_5(context),
      check_prime_power(context),
      check_no_fixed_elements(context),
      check_k4_formula(context),
      check_fixed_elements(context),
      check_fours(context),
      check_any_fours(context),
      not_checkable("Section 2.1", "cited: recursions for DCCD(v,4,b) that preserve minimality",
                    "the paper does not say which recursions"),
  };
}

}  // namespace changeover
