// Section 2.1: Table 1 and claims of the literature that the paper cites.
#include <fmt/format.h>

#include "changeover/bounds/lower_bound.hpp"
#include "core/checked.hpp"
#include "paper/checking.hpp"
#include "paper/checks.hpp"
#include "paper/enumeration.hpp"

namespace changeover {
namespace {

PaperItem check_pairs_of_elements() {
  Check check("Section 2.1",
              "cited: linear DCCD(5,2,10), and linear and circular DCCD(v,2,v(v-1)/2) for v >= 6",
              "designs");
  for (std::uint64_t v = 5; v <= 12; ++v) {
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      bool complete = false;
      const std::optional<Design> design = order_of_pairs(v, kind, 1'000'000, &complete);
      if (v == 5 && kind == Kind::circular) {
        check.expect(!design && complete, [] {
          return PaperFinding{"only a linear DCCD(5,2,10) is named", "a circular one exists",
                              "found by exhaustion"};
        });
        continue;
      }
      check.expect(design && verify(*design).valid(), [&] {
        return PaperFinding{fmt::format("a {} {}", to_string(kind), dccd(v, 2, binomial(v, 2))),
                            "none was found", "orders of the pairs, consecutive ones disjoint"};
      });
    }
  }
  check.note(
      "found for v <= 12; no circular DCCD(5,2,10) exists (the Petersen graph has no "
      "Hamilton cycle)");
  return std::move(check).finish();
}

// "Linear DCCD(3k−5,k,2k−4) are minimum."
PaperItem check_3k_5(const PaperContext& context) {
  Check check("Section 2.1", "cited: linear DCCD(3k-5,k,2k-4) are minimum", "parameters");
  for (std::uint64_t k = 4; k <= context.options.largest_k; ++k) {
    const Parameters p{.v = 3 * k - 5, .k = k, .change = 2, .kind = Kind::linear};
    check.expect(printed_bound(p.v, k, p.kind) == 2 * k - 4, [&] {
      return PaperFinding{fmt::format("2k-4 = {} for k = {}", 2 * k - 4, k),
                          fmt::format("g1 = {}", printed_bound(p.v, k, p.kind)), "Theorem 1"};
    });
  }
  for (std::uint64_t k = 4; k <= 5; ++k) {
    const Parameters p{.v = 3 * k - 5, .k = k, .change = 2, .kind = Kind::linear};
    std::uint64_t b = 2 * k - 4;
    Enumeration tried = enumerate(p, b);
    const bool exists = tried.found > 0;
    while (tried.found == 0 && tried.complete) {
      tried = enumerate(p, ++b);
    }
    check.expect(exists, [&] {
      return PaperFinding{
          fmt::format("a minimum linear {}", dccd(p.v, k, 2 * k - 4)),
          fmt::format("no linear {} exists; the minimum is {} blocks", dccd(p.v, k, 2 * k - 4), b),
          "by exhaustion"};
    });
  }
  check.note(
      "2k-4 = g1(3k-5,k) for every k tried, so such a design would be tight and therefore "
      "minimum; in that sense the claim is right. It does not say that one exists");
  return std::move(check).finish();
}

// "No fixed elements in minimum DCCD(v,4,⌈(v²−v−12)/10⌉), v ≥ 6."
PaperItem check_k4_formula(const PaperContext& context) {
  Check check("Section 2.1", "cited: the number of blocks of the minimum DCCD(v,4,b), v >= 6",
              "values");
  std::size_t wrong = 0;
  std::size_t impossible = 0;
  for (std::uint64_t v = 6; v <= 100; ++v) {
    const std::uint64_t printed = ceil_div(v * v - v - 12, 10) + context.paper.added_for_k4;
    const std::uint64_t g1 = printed_bound(v, 4, Kind::linear);
    const auto finding = [&] {
      return PaperFinding{"DCCD(v,4,ceil((v^2-v-12)/10))",
                          fmt::format("ceil((v^2-v-12)/10) + 1 = g1(v,4): {} and not {} for v = {}",
                                      g1, printed, v),
                          "the formula for general k in the same sentence, which ends in + 1, "
                          "gives this for k = 4"};
    };
    check.expect(printed == g1 || wrong > 0, finding);  // one finding says it for all
    if (printed != g1) {
      ++wrong;
      const Parameters p{.v = v, .k = 4, .change = 2, .kind = Kind::circular};
      impossible += printed < g1 && printed < lower_bound(p).blocks ? 1U : 0U;
    }
  }
  if (wrong > 0) {
    check.note(
        fmt::format("wrong for {} of 95 values of v, and below the bounds for linear and for "
                    "circular designs for {}",
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
  const Enumeration all =
      enumerate({.v = 7, .k = 5, .change = 2, .kind = Kind::circular}, 3, {.keep = 10'000});
  for (const Design& design : all.designs) {
    check.expect(!verify(design).fixed.empty(), [&] {
      return PaperFinding{"every circular DCCD(7,5,3) has a fixed element",
                          fmt::format("one without: it begins {}", braces(design.block(0))),
                          "by exhaustion"};
    });
  }
  bool told = false;
  for (const Design& design : designs_to_try(context.registry, Kind::circular)) {
    const Verdict verdict = verify(design);
    const std::uint64_t g2 = printed_bound(design.v(), design.k(), Kind::circular);
    const Bound bound = lower_bound(design.parameters());
    if (verdict.fixed.empty() || verdict.b != g2 || verdict.b != bound.blocks) {
      continue;
    }
    const bool holds = design.v() == 2 * design.k() - 3;
    check.expect(holds || told, [&] {
      const std::size_t fixed = verdict.fixed.size();
      return PaperFinding{
          "no fixed element unless v = 2k-3",
          fmt::format(
              "a circular {} with ceil(g2) = {} blocks has {} fixed elements, and 2k-3 = {}",
              dccd(design.v(), design.k(), verdict.b), g2, fixed, 2 * design.k() - 3),
          fmt::format("add {} elements to every block of the circular {}; it is minimum, for {}",
                      fixed, dccd(design.v() - fixed, design.k() - fixed, verdict.b),
                      bound.reason)};
    });
    told = told || !holds;
  }
  check.note(
      fmt::format("all {} circular DCCD(7,5,3) that begin with {{0,1,2,3,4}} have one", all.found));
  return std::move(check).finish();
}

}  // namespace

std::vector<PaperItem> check_history(const PaperContext& context) {
  std::vector<PaperItem> items;
  const PrintedTable& table = table_at(context.paper, "Table 1");
  if (const auto rebuilt = construct(context.registry, "printed", table.parameters)) {
    items.push_back(check_blocks(table, *rebuilt, "compared with a second copy of it"));
  } else {
    Check check(table.place, table.caption, "blocks");
    check.lacks("printed");
    items.push_back(std::move(check).finish());
  }
  items.push_back(check_marks(table));
  items.push_back(check_kind(table));
  items.push_back(
      out_of_scope("Section 2.1",
                   "cited: minimum SCCDs are constructed for k = 2, 3, 4 and for four classes of v "
                   "modulo 16 with k = 5",
                   "results of other papers"));
  items.push_back(check_pairs_of_elements());
  items.push_back(out_of_scope("Section 2.1",
                               "cited: minimum or near minimum circular DCCD(v,3,b) for all v",
                               "a construction of another work, from quasigroups"));
  items.push_back(check_3k_5(context));
  items.push_back(out_of_scope(
      "Section 2.1",
      "cited: if 2k-3 is an odd prime power, a minimum linear DCCD(v,k,(2v-2)/3) needs v >= 3k-5",
      "a theorem of another work"));
  items.push_back(out_of_scope(
      "Section 2.1",
      "cited: minimum linear DCCDs with ceil(g1) blocks and v >= 3k-6 have no fixed elements",
      "a statement on all designs, which would need a search for each (v,k)"));
  items.push_back(check_k4_formula(context));
  items.push_back(check_fixed_elements(context));
  items.push_back(out_of_scope("Section 2.1",
                               "cited: minimum DCCD(v,4,b) for v = 6,...,14 and recursions that "
                               "preserve minimality",
                               "constructions of another work"));
  return items;
}

}  // namespace changeover
