#include "paper/checks/checking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/pair_set.hpp"
#include "core/checked.hpp"
#include "core/each.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_findings = 40;

constexpr std::uint64_t largest_v_to_try = 24;
constexpr std::uint64_t largest_k_to_try = 8;
constexpr std::uint64_t most_fixed_to_try = 8;
constexpr std::string_view constructions_to_try[] = {"cyclic-paper", "doubling", "fixed-element",
                                                     "printed", "short-long-runs"};

}  // namespace

Check::Check(std::string place, std::string what, std::string unit) {
  item_.place = std::move(place);
  item_.what = std::move(what);
  item_.unit = std::move(unit);
}

void Check::add(PaperFinding finding) {
  if (item_.findings.size() < most_findings) {
    item_.findings.push_back(std::move(finding));
  } else {
    ++untold_;
  }
}

Check& Check::of_a_statement() {
  failed_ = PaperStatus::refuted;
  return *this;
}

Check& Check::follows(std::string place) {
  follows_ = std::move(place);
  return *this;
}

Check& Check::comes_first() {
  item_.comes_first = true;
  return *this;
}

void Check::lacks(std::string_view construction) {
  item_.status = PaperStatus::not_checkable;
  note(fmt::format("the construction \"{}\" that it takes is not in this registry", construction));
}

const Construction* Check::finds(const Registry& registry, std::string_view construction) {
  const Construction* const found = registry.find(construction);
  if (found == nullptr) {
    lacks(construction);
  }
  return found;
}

PaperItem Check::finish() && {
  if (untold_ > 0) {
    note(fmt::format("and {} more of the kind", untold_));
  }
  if (!item_.findings.empty()) {
    item_.status = failed_;
    item_.follows = std::move(follows_);
  }
  return std::move(item_);
}

PaperItem not_checkable(std::string place, std::string what, std::string reason) {
  PaperItem item;
  item.place = std::move(place);
  item.what = std::move(what);
  item.status = PaperStatus::not_checkable;
  item.notes.push_back(std::move(reason));
  return item;
}

std::string braces(std::span<const Element> block) {
  return fmt::format("{{{}}}", fmt::join(block, ","));
}

std::string braces(std::span<const Element> block, const Design& design) {
  const std::vector<std::string> names =
      each_of<std::string>(block, [&](Element x) { return design.label(x); });
  return braces(names);
}

std::string braces(const std::vector<std::string>& names) {
  return fmt::format("{{{}}}", fmt::join(names, ","));
}

std::string block_name(const ParsedTable& table, std::size_t index) {
  const std::string& printed = table.blocks[index].name;
  if (printed.empty()) {
    return fmt::format("block {}", index + 1);
  }
  const std::size_t digits = printed.find_first_of("0123456789");
  const std::string subscript = printed.substr(std::min(digits, printed.size()));
  const std::string letter = printed.substr(0, digits);
  return subscript.size() > 1 ? fmt::format("{}_{{{}}}", letter, subscript)
                              : fmt::format("{}_{}", letter, subscript);
}

std::string dccd(std::uint64_t v, std::uint64_t k, std::uint64_t b) {
  return fmt::format("DCCD({},{},{})", v, k, b);
}

std::string in_words(const Verdict& verdict) {
  if (verdict.b == 0) {
    return "no blocks";
  }
  std::string words = fmt::format("{} blocks", verdict.b);
  if (verdict.bad_steps > 0) {
    const BadStep& step = verdict.bad_step_examples.front();
    words +=
        fmt::format(", {} steps do not change {} elements (block {} to {} changes {})",
                    verdict.bad_steps, verdict.parameters.change, step.from, step.to, step.changes);
  }
  if (verdict.uncovered > 0) {
    words += fmt::format(", {} pairs in no block ({} is one)", verdict.uncovered,
                         braces(verdict.uncovered_examples.front()));
  }
  if (verdict.valid()) {
    words += verdict.tight() ? ", tight" : fmt::format(", valid with excess {}", verdict.excess);
  }
  return words;
}

std::uint64_t count_of(std::string_view formula, const Values& values) {
  return value_of(formula, values).count().value_or(0);
}

Fraction printed_bound(const Paper& paper, std::uint64_t v, std::uint64_t k, Kind kind) {
  return value_of(kind == Kind::circular ? paper.circular_bound : paper.linear_bound,
                  {{'v', v}, {'k', k}});
}

Fraction counted_bound(std::uint64_t v, std::uint64_t k, Kind kind) {
  std::int64_t all = 0;
  std::int64_t first = 0;  // in {0,…,k−1}
  std::int64_t step = 0;   // in {2,…,k+1} and not in {0,…,k−1}
  for (std::uint64_t y = 0; y < std::max(v, k + 2); ++y) {
    for (std::uint64_t x = 0; x < y; ++x) {
      all += y < v ? 1 : 0;
      first += y < k ? 1 : 0;
      step += x >= 2 && y >= k && y < k + 2 ? 1 : 0;
    }
  }
  const std::int64_t numerator = kind == Kind::circular ? all : all - first + step;
  const std::int64_t divisor = std::gcd(numerator, step);
  return {numerator / divisor, step / divisor};
}

std::vector<std::uint64_t> times_covered(const Design& design) {
  std::vector<std::uint64_t> times(static_cast<std::size_t>(binomial(design.v(), 2)));
  DesignSource source(design);
  for (Transitions steps(source); steps.next();) {
    const Block entering(steps.introduced().begin(), steps.introduced().end());
    const Block kept = difference(steps.block(), entering);
    for (std::size_t i = 0; i < entering.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        ++times[PairSet::rank(entering[j], entering[i])];
      }
      for (const Element x : kept) {
        ++times[PairSet::rank(x, entering[i])];
      }
    }
  }
  return times;
}

std::string all_blocks(const Design& design) {
  return joined(std::views::iota(std::size_t{0}, design.block_count()),
                [&](std::size_t i) { return braces(design.block(i)); });
}

std::optional<Design> construct(const Registry& registry, std::string_view construction,
                                const Parameters& parameters) {
  const Construction* found = registry.find(construction);
  if (found == nullptr) {
    return std::nullopt;
  }
  const std::optional<Offer> offer = found->offer(parameters, registry);
  if (!offer) {
    return std::nullopt;
  }
  return registry.build_design(offer->recipe);
}

std::optional<Design> best_design(const Registry& registry, const Parameters& parameters) {
  std::optional<Offer> best = registry.best(parameters);
  if (!best || best->b > lower_bound(parameters).blocks) {
    best = best_known(registry, parameters);
  }
  if (!best) {
    return std::nullopt;
  }
  Design design = registry.build_design(best->recipe);
  return verify(design).valid() ? std::optional(std::move(design)) : std::nullopt;
}

Design with_fixed_elements(const Design& design, std::uint64_t count) {
  Parameters p = design.parameters();
  p.v += count;
  p.k += count;
  Design larger(p);
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    Block block(design.block(i).begin(), design.block(i).end());
    for (std::uint64_t x = design.v(); x < p.v; ++x) {
      block.push_back(static_cast<Element>(x));
    }
    larger.append(block);
  }
  return larger;
}

std::vector<Design> designs_to_try(const Registry& registry, Kind kind) {
  std::vector<Design> designs;
  const auto add = [&designs](Design design) {
    if (verify(design).valid()) {
      designs.push_back(std::move(design));
    }
  };
  for (std::uint64_t k = 3; k <= largest_k_to_try; ++k) {
    for (std::uint64_t v = k + 2; v <= largest_v_to_try; ++v) {
      for (const std::string_view construction : constructions_to_try) {
        const Parameters p = circular(v, k);
        std::optional<Design> design = construct(registry, construction, p);
        if (!design) {
          continue;
        }
        if (kind == Kind::linear) {
          design->set_kind(Kind::linear);
          add(*std::move(design));
          continue;
        }
        for (std::uint64_t fixed = 1; fixed <= most_fixed_to_try; ++fixed) {
          add(with_fixed_elements(*design, fixed));
        }
        add(*std::move(design));
      }
    }
  }
  std::ranges::stable_sort(designs, {}, &Design::parameters);
  return designs;
}

std::vector<CyclicWithSet> cyclic_with_sets(const Registry& registry, std::uint64_t largest_c,
                                            std::uint64_t largest_k) {
  std::vector<CyclicWithSet> designs;
  for (std::uint64_t c = 1; c <= largest_c; ++c) {
    for (std::uint64_t k = 3; k <= largest_k && k - 2 <= 2 * c + 1; ++k) {
      if ((2 * c + 1) % (k - 2) != 0) {
        continue;
      }
      const Parameters p = circular(c * (4 * k - 6) + 1, k);
      std::optional<Design> design = construct(registry, "cyclic-paper", p);
      if (!design) {
        continue;
      }
      // U_{ic(k−2)} = A + i(k−2); U_0 stands at position b of a circular design.
      ExpansionSet set;
      for (std::uint64_t i = 1; i <= p.v / (k - 2); ++i) {
        Block subset;
        for (std::uint64_t a = 0; a < k - 2; ++a) {
          subset.push_back(static_cast<Element>((a + i * (k - 2)) % p.v));
        }
        set.push_back({static_cast<std::size_t>(i * c * (k - 2)), std::move(subset)});
      }
      designs.push_back({c, *std::move(design), std::move(set)});
    }
  }
  return designs;
}

ExpansionSet marked_expansion_set(const PrintedTable& table) {
  const ParsedTable parsed = parse(table);
  const std::vector<UnchangedSubset> between =
      unchanged_subsets(printed_design(table, Kind::circular));
  ExpansionSet set;
  for (const std::size_t position : parsed.carets) {
    UnchangedSubset subset{.position = position, .elements = {}};
    if (position < parsed.unchanged.size()) {
      const auto& printed = parsed.unchanged[position].elements;
      for (Element x = 0; x < table.parameters.v; ++x) {
        if (std::ranges::find(printed, element_name(table, x)) != printed.end()) {
          subset.elements.push_back(x);
        }
      }
    } else if (position >= 1 && position <= between.size()) {
      subset.elements = between[position - 1].elements;
    }
    set.push_back(std::move(subset));
  }
  return set;
}

std::optional<Design> expanded_as_printed(const Paper& paper, std::string_view table, Kind kind,
                                          std::string_view factorization) {
  const PrintedTable& small = table_at(paper, table);
  for (const PrintedFactorization& printed : paper.factorizations) {
    if (printed.place == factorization) {
      try {
        Design design =
            expand(printed_design(small, kind), marked_expansion_set(small), parse(printed));
        design.set_labels({});
        return design;
      } catch (const Error&) {
        return std::nullopt;
      }
    }
  }
  return std::nullopt;
}

bool expect_design(Check& check, const Design& design, const Claim& claim) {
  const Verdict verdict = verify(design);
  const Bound bound = lower_bound(design.parameters());
  const bool holds = verdict.valid() && verdict.b == claim.b && (!claim.tight || verdict.tight()) &&
                     verdict.b == bound.blocks;
  return check.expect(holds, [&] {
    return PaperFinding{fmt::format("a {} {} with {} blocks", claim.tight ? "tight" : "minimum",
                                    name(design.parameters()), claim.b),
                        fmt::format("the construction gives {}; the lower bound is {}",
                                    in_words(verdict), bound.blocks),
                        bound.reason};
  });
}

}  // namespace changeover
