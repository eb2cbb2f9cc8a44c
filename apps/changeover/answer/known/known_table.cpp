#include "answer/known/known_table.hpp"

#include <fmt/format.h>

#include "changeover/construct/best_known.hpp"
#include "changeover/construct/registry.hpp"
#include "cli/cli.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"

namespace changeover::cli {
namespace {

std::string text_of(const Range& range) { return fmt::format("{}..{}", range.from, range.to); }

// The range that was asked for in these words. @throws UsageError if it is too large.
CellRange cell_range_of(const TableRange& asked, const std::string& k, const std::string& v) {
  if (asked.k.from < 2) {
    throw UsageError{fmt::format("--k {}: blocks have at least 2 elements; give 2 or more", k)};
  }
  if (asked.v.from < 2 || asked.v.to > largest_v_of_a_range) {
    throw UsageError{fmt::format("--v {}: a table goes from v = 2 to v = {}; give a range within",
                                 v, largest_v_of_a_range)};
  }
  if (asked.change < 1) {
    throw UsageError{"--change 0: consecutive blocks differ in at least 1 element; give 1 or more"};
  }
  if (asked.k.to - asked.k.from >= most_cells_of_a_range / 2 / (asked.v.to - asked.v.from + 1)) {
    throw UsageError{
        fmt::format("--k {} --v {}: the range has more than {} cells; give a smaller one", k, v,
                    most_cells_of_a_range)};
  }
  return {.v_from = asked.v.from,
          .v_to = asked.v.to,
          .k_from = asked.k.from,
          .k_to = asked.k.to,
          .change = asked.change,
          .kind = asked.kind};
}

}  // namespace

Cells KnownTable::cells(Kind kind) const {
  Cells cells;
  for (std::uint64_t k = asked_.k.from; k <= asked_.k.to; ++k) {
    for (std::uint64_t v = asked_.v.from; v <= asked_.v.to; ++v) {
      cells.push_back(&table_.at({.v = v, .k = k, .change = asked_.change, .kind = kind}));
    }
  }
  return cells;
}

TableRange table_range(const std::string& k, const std::string& v,
                       std::optional<std::uint64_t> change) {
  TableRange range{.k = range_of("--k", k, 2), .v = {}, .change = change.value_or(2)};
  range.v = range_of("--v", v, range.k.from);
  static_cast<void>(cell_range_of(range, k, v));
  return range;
}

void check_table(const TableRange& asked) {
  static_cast<void>(cell_range_of(asked, text_of(asked.k), text_of(asked.v)));
}

KnownTable known_table(const TableRange& asked, Stored stored) {
  return {asked,
          best_known_table(Registry::standard(),
                           cell_range_of(asked, text_of(asked.k), text_of(asked.v)), stored)};
}

std::optional<Offer> best_known(const Parameters& p) {
  return changeover::best_known(Registry::standard(), p);
}

std::optional<Offer> best_offer(const std::vector<Parameters>& asked,
                                const std::string& construction) {
  const Construction* const named = Registry::standard().find(construction);
  if (named == nullptr && !construction.empty()) {
    throw UsageError{fmt::format(
        "no construction is called '{}'; changeover constructions lists them", construction)};
  }
  return changeover::best_offer(Registry::standard(), asked, named);
}

Answer decline(const std::vector<Parameters>& asked, const std::string& construction,
               const OutputRequest& output) {
  const Registry& registry = Registry::standard();
  std::string text;
  bool open = false;
  for (const Parameters& p : asked) {
    if (const auto reason = impossibility(p)) {
      text += fmt::format("No {} exists: {}.\n", name(p), *reason);
      continue;
    }
    open = true;
    const Bound bound = lower_bound(p);
    text += construction.empty()
                ? fmt::format("No construction serves {}.\n", name(p))
                : fmt::format("The construction {} does not serve {}.\n", construction, name(p));
    text += fmt::format("  at least {}: {}\n", count_of(bound.blocks, "block"), bound.reason);
    if (!construction.empty()) {
      const std::string others = joined(registry.offers(p), [&](const Offer& offer) {
        return fmt::format("{} ({})", offer.recipe.construction, count_of(offer.b, "block"));
      });
      if (!others.empty()) {
        text += "  served by: " + others + "\n";
        continue;
      }
    }
    constexpr std::size_t most_named = 6;
    constexpr std::uint64_t radius = 12;
    const std::string near =
        joined(registry.nearest(p, most_named, radius), [&](const Offer& offer) {
          return fmt::format("({},{}) with {}", offer.recipe.parameters.v,
                             offer.recipe.parameters.k, count_of(offer.b, "block"));
        });
    text += near.empty() ? fmt::format("  nothing served within {} of v and k\n", radius)
                         : "  nearest served (v,k): " + near + "\n";
  }
  if (open) {
    text +=
        "What would help: another kind or change number, nearby parameters, or a design of your "
        "own\n"
        "to enlarge (changeover expand FILE).\n";
  }
  JsonWriter json;
  json.begin_object().key("served").value(false).key("explanation").value(text);
  json.list("lower_bounds", asked, [&](const Parameters& p) {
    if (!impossibility(p)) {
      json.begin_object().key("kind").value(to_string(p.kind));
      json.key("lower_bound").value(lower_bound(p).blocks).end_object();
    }
  });
  json.end_object();
  text.pop_back();
  return no_design(output, exit_code::missing_resource, text, json.take());
}

}  // namespace changeover::cli
