// Section 4: what is said to have been done, and what is asked.
#include <fmt/format.h>

#include "changeover/bounds/lower_bound.hpp"
#include "paper/checks/checking.hpp"
#include "paper/checks/checks.hpp"

namespace changeover {
namespace {

PaperItem check_count(const Paper& paper) {
  Check check("Section 4",
              "\"we apply the recursion to construct eleven additional tight circular DCCDs\"",
              "counts");
  check.expect(paper.count_in_conclusion == paper.eleven.size(),
               {fmt::format("{} additional designs", paper.count_in_conclusion),
                fmt::format("{} are listed in Corollary 15", paper.eleven.size()), "counted"});
  return std::move(check).finish();
}

// A circular design for every v from k + change up to `largest_v(k)`, with as many blocks as the
// lower bound.
template <typename LargestV>
PaperItem check_all_minima(const PaperContext& context, std::string what, std::uint64_t change,
                           const LargestV& largest_v, const std::string& note) {
  Check check("Section 4", std::move(what), "designs");
  if (check.finds(context.registry, "small-v") == nullptr) {
    return std::move(check).finish();
  }
  for (std::uint64_t k = 2 + change - 1; k <= context.options.largest_k; ++k) {
    for (std::uint64_t v = k + change; v <= largest_v(k); ++v) {
      const Parameters p{.v = v, .k = k, .change = change, .kind = Kind::circular};
      const Bound bound = lower_bound(p);
      const std::optional<Design> design = best_design(context.registry, p);
      check.expect(design && verify(*design).b == bound.blocks, [&] {
        return PaperFinding{fmt::format("a minimum {}", name(p)),
                            design ? fmt::format("{}; the lower bound is {}",
                                                 in_words(verify(*design)), bound.blocks)
                                   : std::string("none is built"),
                            bound.reason};
      });
    }
  }
  check.note(fmt::format("k <= {}: {}", context.options.largest_k, note));
  return std::move(check).finish();
}

}  // namespace

std::vector<PaperItem> check_conclusion(const PaperContext& context) {
  const PrintedCited& cited = context.paper.cited;
  return {
      check_again(context, "Section 4"),
      check_count(context.paper),
      check_all_minima(
          context, "cited: minimum circular SCCDs are known and constructed for v <= 2k-1", 1,
          [&](std::uint64_t k) {
            return count_of(cited.circular_single_to, {{'k', k}});
          },
          "built by us, with as many blocks as the lower bound"),
      check_all_minima(
          context, "asked: the minimum circular DCCDs for v <= 2k-2", 2,
          [](std::uint64_t k) { return 2 * k - 2; },
          "answered, for every k, by Theorem 2 of docs/theorems.md; built, with as many blocks "
          "as the lower bound"),
      not_checkable(
          "Section 4",
          "asked: a recursion for expansion sets of even size; economical designs from tight "
          "ones; products of two designs; more designs with k > 4; triples",
          "questions, not statements. Of what we know, in docs/theorems.md: Theorem 3 is a "
          "recursion for either parity, Theorem 31 has tight designs for every even k, Theorem 33"
          " designs within a constant of the bound for every v; strength 3 and 4 are in "
          "docs/minima.md"),
  };
}

}  // namespace changeover
