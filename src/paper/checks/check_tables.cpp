// Blocks and marks of the tables, cell by cell.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/expansion.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "core/each.hpp"
#include "paper/checks/checking.hpp"
#include "paper/checks/checks.hpp"

namespace changeover {
namespace {

using Names = std::set<std::string>;

Names names_of(std::span<const Element> block, const Design& design) {
  Names names;
  for (const Element x : block) {
    names.insert(design.label(x));
  }
  return names;
}

std::string in_braces(const Names& names) {
  return braces(std::vector<std::string>(names.begin(), names.end()));
}

std::string with_marks(const PrintedBlock& block) {
  return braces(each_of<std::string>(block.cells, [](const PrintedCell& cell) {
    return fmt::format("{}{}{}", cell.element, cell.introduced ? "^*" : "",
                       cell.leaving ? "_*" : "");
  }));
}

bool is_made_from(const Recipe& recipe, std::string_view construction) {
  return recipe.construction == construction ||
         std::ranges::any_of(
             recipe.inputs, [&](const Recipe& input) { return is_made_from(input, construction); });
}

// A table whose columns are not k-subsets of its elements.
PaperItem unreadable(const PrintedTable& table, const BadInput& fault) {
  Check check(table.place, table.caption, "tables");
  check.expect(false, {table.caption, "the columns are not a list of blocks", fault.what()});
  return std::move(check).finish();
}

// The kinds that a caption names, or both if it names none.
std::vector<Kind> kinds_of(const PrintedTable& table) {
  return table.kinds.empty() ? std::vector{Kind::linear, Kind::circular} : table.kinds;
}

// The print itself: is it the design that its caption names? If the caption names no kind, one must
// do.
void expect_caption(Check& check, const PrintedTable& table) {
  std::vector<std::string> wrong;
  const std::vector<Kind> kinds = kinds_of(table);
  for (const Kind kind : kinds) {
    const Design design = printed_design(table, kind);
    const Verdict verdict = verify(design);
    const Bound bound = lower_bound(design.parameters());
    if (!verdict.valid() || verdict.b != table.b || (table.tight && !verdict.tight()) ||
        (table.minimum && verdict.b != bound.blocks)) {
      wrong.push_back(fmt::format("read as {}: {}; the lower bound is {}", to_string(kind),
                                  in_words(verdict), bound.blocks));
      continue;
    }
    if (verdict.b == bound.blocks && !verdict.tight()) {
      check.note(fmt::format("as {}: minimum by the bound \"{}\", excess {}", to_string(kind),
                             bound.name, verdict.excess));
    } else if (table.kinds.empty()) {
      check.note(fmt::format("as {}: tight", to_string(kind)));
    }
  }
  check.expect(
      table.kinds.empty() ? wrong.size() < kinds.size() : wrong.empty(),
      {table.caption, fmt::format("{}", fmt::join(wrong, "; ")), "verified block by block"}, 0);
}

// The pairs {0,x} that a highlighted table claims to show: x is highlighted where it is covered.
void expect_highlights(Check& check, const PrintedTable& table, const ParsedTable& parsed,
                       const std::vector<Names>& introduced) {
  const std::string zero = element_name(table, 0);
  for (std::size_t i = 0; i < parsed.blocks.size(); ++i) {
    const auto& cells = parsed.blocks[i].cells;
    const bool has_zero =
        std::ranges::any_of(cells, [&](const auto& cell) { return cell.element == zero; });
    for (const PrintedCell& cell : cells) {
      const bool covered = has_zero && cell.element != zero &&
                           (introduced[i].contains(zero) || introduced[i].contains(cell.element));
      check.expect(cell.highlighted == covered,
                   {fmt::format("{}: {} is {}highlighted", block_name(parsed, i), cell.element,
                                cell.highlighted ? "" : "not "),
                    fmt::format("{{{},{}}} is {}covered in this block", zero, cell.element,
                                covered ? "" : "not "),
                    "x is highlighted where {0,x} is covered"});
    }
  }
}

void expect_carets(Check& check, const PrintedTable& table, const ParsedTable& parsed) {
  // A row of unchanged subsets stands also before the first block and after the last, where a
  // linear design has a choice.
  const Kind kind = parsed.unchanged.empty() ? Kind::circular : Kind::linear;
  const auto defect =
      expansion_set_defect(printed_design(table, kind), marked_expansion_set(table));
  check.expect(
      !defect.has_value(),
      [&] {
        return PaperFinding{"carets mark an expansion set", "they do not", *defect};
      },
      parsed.carets.size());
}

}  // namespace

PaperItem check_blocks(const PrintedTable& table, const Design& rebuilt,
                       const std::string& how) try {
  Check check(table.place, fmt::format("{}: {} blocks, {}", table.caption, table.b, how), "cells");
  expect_caption(check, table);
  const Design printed = printed_design(table, table.parameters.kind);
  const ParsedTable parsed = parse(table);
  const std::size_t count = std::max(printed.block_count(), rebuilt.block_count());
  for (std::size_t i = 0; i < count; ++i) {
    const Names in_print =
        i < printed.block_count() ? names_of(printed.block(i), printed) : Names{};
    Names built;
    if (i < rebuilt.block_count()) {
      for (const Element x : rebuilt.block(i)) {
        built.insert(rebuilt.labels().empty() ? element_name(table, x) : rebuilt.label(x));
      }
    }
    check.expect(in_print == built,
                 {fmt::format("{} = {}",
                              i < parsed.blocks.size() ? block_name(parsed, i) : "no further block",
                              in_braces(in_print)),
                  built.empty() ? "there is no such block" : in_braces(built), how},
                 table.parameters.k);
  }
  return std::move(check).finish();
} catch (const BadInput& fault) {
  return unreadable(table, fault);
}

PaperItem check_marks(const PrintedTable& table) try {
  const ParsedTable parsed = parse(table);
  const bool coloured = table.layout.find(':') != std::string::npos;
  const bool highlighted = table.layout.find('!') != std::string::npos;
  Check check(
      table.place,
      fmt::format("asterisks of introduced{} elements{}{}", table.leaving ? " and leaving" : "",
                  coloured ? ", a colour counting as one" : "",
                  highlighted ? ", and highlights" : ""),
      "marks");
  const Design design = printed_design(table, table.parameters.kind);
  DesignSource source(design);
  std::vector<Names> introduced;
  std::size_t wrong_blocks = 0;
  for (Transitions steps(source); steps.next();) {
    const std::size_t i = introduced.size();
    introduced.push_back(names_of(steps.introduced(), design));
    const Names leaving = names_of(steps.leaving(), design);
    bool right = true;
    for (const PrintedCell& cell : parsed.blocks[i].cells) {
      const bool in = introduced[i].contains(cell.element);
      const bool marked = cell.introduced || cell.colour != 0;
      right &= check.expect(marked == in, [&] {
        return PaperFinding{
            fmt::format("{}: {} has {} superscript asterisk, in {}", block_name(parsed, i),
                        cell.element, marked ? "a" : "no", with_marks(parsed.blocks[i])),
            in ? "it is introduced here" : "it is not introduced here",
            i == 0 && table.parameters.kind == Kind::linear
                ? "all elements are introduced in the first block of a linear design"
                : fmt::format(
                      "the block before, {}, {} it",
                      braces(design.block(i == 0 ? design.block_count() - 1 : i - 1), design),
                      in ? "does not have" : "has")};
      });
      if (table.leaving) {
        const bool out = leaving.contains(cell.element);
        right &= check.expect(cell.leaving == out, [&] {
          return PaperFinding{
              fmt::format("{}: {} has {} subscript asterisk, in {}", block_name(parsed, i),
                          cell.element, cell.leaving ? "a" : "no", with_marks(parsed.blocks[i])),
              out ? "it leaves here" : "it does not leave here",
              fmt::format("the block after is {}",
                          braces(design.block((i + 1) % design.block_count()), design))};
        });
      }
    }
    wrong_blocks += right ? 0 : 1;
  }
  if (wrong_blocks > 1) {
    check.note(fmt::format("{} blocks carry wrong or missing asterisks; the blocks are right",
                           wrong_blocks));
  }
  if (highlighted) {
    expect_highlights(check, table, parsed, introduced);
  }
  if (!parsed.carets.empty()) {
    expect_carets(check, table, parsed);
  }
  return std::move(check).finish();
} catch (const BadInput& fault) {
  return unreadable(table, fault);
}

PaperItem check_kind(const PrintedTable& table) try {
  Check check(table.place, "the kind that its caption names", "readings");
  std::vector<Kind> valid;
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    if (verify(printed_design(table, kind)).valid()) {
      valid.push_back(kind);
    }
  }
  const auto listed = [](const std::vector<Kind>& kinds) {
    return kinds.empty() ? std::string("none")
                         : joined(kinds, " and ", [](Kind kind) { return to_string(kind); });
  };
  check.expect(table.kinds.empty() ? !valid.empty() : table.kinds == valid,
               {fmt::format("called {}", listed(table.kinds)),
                fmt::format("as it stands it is {}", listed(valid)),
                "what the last block and the first have in common decides it"},
               2);
  check.note(
      table.kinds.empty()
          ? fmt::format("it names none, which by Section 1 leaves it open: the list is {}; the "
                        "asterisks of its first block are those of a linear one",
                        listed(valid))
          : fmt::format("the list is {}, and only that", listed(valid)));
  return std::move(check).finish();
} catch (const BadInput& fault) {
  return unreadable(table, fault);
}

PaperItem check_each_block(const PrintedTable& table) try {
  Check check(
      table.place,
      fmt::format("{}: {} blocks, each recomputed from all the others", table.caption, table.b),
      "cells");
  expect_caption(check, table);
  const ParsedTable parsed = parse(table);
  const Kind kind = kinds_of(table).front();
  const Design printed = printed_design(table, kind);
  const std::vector<Block> blocks = printed.blocks();
  std::size_t undetermined = 0;
  std::size_t without = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    std::vector<Names> fitting;
    std::vector<bool> chosen(printed.v(), false);
    std::fill_n(chosen.begin(), printed.k(), true);
    do {
      std::vector<Block> changed = blocks;
      changed[i].clear();
      for (Element x = 0; x < printed.v(); ++x) {
        if (chosen[x]) {
          changed[i].push_back(x);
        }
      }
      if (verify(Design(printed.parameters(), changed)).valid()) {
        fitting.push_back(names_of(changed[i], printed));
      }
    } while (std::prev_permutation(chosen.begin(), chosen.end()));
    if (fitting.size() != 1) {  // more than one: the others do not determine it
      (fitting.empty() ? without : undetermined) += 1;
      continue;
    }
    check.expect(
        fitting.front() == names_of(blocks[i], printed),
        [&] {
          return PaperFinding{fmt::format("{} = {}", block_name(parsed, i),
                                          in_braces(names_of(blocks[i], printed))),
                              in_braces(fitting.front()), "no other block makes the rest a design"};
        },
        printed.k());
  }
  if (undetermined > 0) {
    check.note(fmt::format("{} blocks are not determined by the others", undetermined));
  }
  if (without > 0) {
    check.note(fmt::format("at {} places no block makes the rest a design", without));
  }
  return std::move(check).finish();
} catch (const BadInput& fault) {
  return unreadable(table, fault);
}

PaperItem check_least(const PaperContext& context, const PrintedTable& table) {
  Check check(
      table.place,
      fmt::format("{} blocks: the least that there can be, and built without the print", table.b),
      "bounds and designs");
  if (check.finds(context.registry, "printed") == nullptr) {
    return std::move(check).finish();
  }
  for (const Kind kind : kinds_of(table)) {
    const Parameters p = table.parameters.as(kind);
    const Bound bound = lower_bound(p);
    check.expect(table.b == bound.blocks,
                 {fmt::format("{} blocks", table.b),
                  fmt::format("the lower bound for a {} one is {}", to_string(kind), bound.blocks),
                  bound.reason});
    const std::vector<Offer> offers = context.registry.offers(p);
    const auto ours = std::ranges::find_if(
        offers, [](const Offer& offer) { return !is_made_from(offer.recipe, "printed"); });
    if (ours == offers.end()) {
      check.note(fmt::format("no construction but the print gives a {} one", to_string(kind)));
      continue;
    }
    const Verdict verdict = verify(context.registry.build_design(ours->recipe));
    check.expect(verdict.valid() && verdict.b == table.b, [&] {
      return PaperFinding{
          fmt::format("{} blocks", table.b),
          fmt::format("{}: {}", verdict.b < table.b ? "better known now" : "not reached",
                      in_words(verdict)),
          ours->recipe.construction};
    });
    check.note(fmt::format("a {} one by {}, {}", to_string(kind), ours->recipe.construction,
                           in_words(verdict)));
  }
  return std::move(check).finish();
}

}  // namespace changeover
