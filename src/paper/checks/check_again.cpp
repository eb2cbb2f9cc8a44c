// Parameters that the abstract and Section 4 write once more, against designs of the statements
// that they belong to.
#include <fmt/format.h>

#include "paper/checks/checking.hpp"
#include "paper/checks/checks.hpp"

namespace changeover {
namespace {

struct Member {
  Values values;  // of k, and of c where there is one
  Design design;
};

void add_member(std::vector<Member>& members, const Registry& registry,
                std::string_view construction, std::uint64_t v, const Values& values) {
  const Parameters p = circular(v, values.at('k'));
  if (std::optional<Design> design = construct(registry, construction, p)) {
    members.push_back({values, *std::move(design)});
  }
}

// Designs of a statement, built by its construction.
std::vector<Member> members_of(const PaperContext& context, const std::string& statement) {
  constexpr std::uint64_t largest_cyclic_k = 10;
  std::vector<Member> members;
  const auto& [paper, registry, options] = context;
  if (statement == "Theorem 10") {
    for (std::uint64_t c = 1; c <= paper.cyclic_up_to; ++c) {
      for (std::uint64_t k = 3; k <= std::min(largest_cyclic_k, options.largest_k); ++k) {
        add_member(members, registry, "cyclic-paper", c * (4 * k - 6) + 1, {{'c', c}, {'k', k}});
      }
    }
    return members;
  }
  const PrintedFamily& family = family_at(paper, statement);
  for (std::uint64_t k = family.smallest_k; k <= options.largest_k; ++k) {
    if ((k % 2 == 0) != family.even) {
      continue;
    }
    if (statement == "Theorem 8") {
      add_member(members, registry, "fixed-element", 2 * k - 3, {{'k', k}});
    } else {
      add_member(members, registry, statement == "Theorem 3" ? "doubling" : "short-long-runs",
                 2 * k - 2, {{'k', k}});
    }
  }
  return members;
}

}  // namespace

PaperItem check_again(const PaperContext& context, std::string_view place) {
  Check check(std::string(place), "v and b of the families, as they are written there once more",
              "designs");
  for (const PrintedAgain& again : context.paper.again) {
    if (again.design.place != place) {
      continue;
    }
    const std::vector<Member> members = members_of(context, again.statement);
    if (members.empty()) {
      check.lacks(again.statement);
      return std::move(check).finish();
    }
    for (const auto& [values, design] : members) {
      const Fraction v = value_of(again.design.v, values);
      const Fraction b = value_of(again.design.b, values);
      const Verdict verdict = verify(design);
      check.expect(
          verdict.valid() && v.count() == design.v() && b.count() == verdict.b,
          {fmt::format("({},k,{}), so ({},{},{})", again.design.v, again.design.b, v.to_string(),
                       design.k(), b.to_string()),
           dccd(design.v(), design.k(), verdict.b), fmt::format("built by {}", again.statement)});
    }
  }
  return std::move(check).finish();
}

}  // namespace changeover
