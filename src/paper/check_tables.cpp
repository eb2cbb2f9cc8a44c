// Blocks and marks of the tables, cell by cell.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "changeover/construct/expansion.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/transitions.hpp"
#include "paper/checking.hpp"
#include "paper/checks.hpp"

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
  std::vector<std::string> cells;
  for (const PrintedCell& cell : block.cells) {
    cells.push_back(
        fmt::format("{}{}{}", cell.element, cell.introduced ? "^*" : "", cell.leaving ? "_*" : ""));
  }
  return braces(cells);
}

// A table whose columns are not k-subsets of its elements.
PaperItem unreadable(const PrintedTable& table, const BadInput& fault) {
  Check check(table.place, table.caption, "tables");
  check.expect(false, [&] {
    return PaperFinding{table.caption, "the columns are no list of blocks", fault.what()};
  });
  return std::move(check).finish();
}

// The print itself: is it the design that its caption names?
void expect_caption(Check& check, const PrintedTable& table) {
  for (const Kind kind : table.kinds) {
    const Verdict verdict = verify(printed_design(table, kind));
    check.expect(
        verdict.valid() && verdict.b == table.b && (!table.tight || verdict.tight()),
        [&] {
          return PaperFinding{table.caption,
                              fmt::format("read as {}: {}", to_string(kind), in_words(verdict)),
                              "verified block by block"};
        },
        0);
    if (verdict.valid()) {
      const std::uint64_t bound = printed_bound(table.parameters.v, table.parameters.k, kind);
      if (table.parameters.change == 2 && verdict.b == bound && !verdict.tight()) {
        check.note(
            fmt::format("as {}: valid, economical, excess {}", to_string(kind), verdict.excess));
      }
    }
  }
}

// The pairs {0,x} that a highlighted table claims to show: x is highlighted where it is covered.
void expect_highlights(Check& check, const PrintedTable& table, const ParsedTable& parsed,
                       const std::vector<Names>& introduced) {
  const std::string zero = element_name(table, 0);
  for (std::size_t i = 0; i < parsed.blocks.size(); ++i) {
    const auto& cells = parsed.blocks[i].cells;
    const bool has_zero = std::any_of(cells.begin(), cells.end(),
                                      [&](const auto& cell) { return cell.element == zero; });
    for (const PrintedCell& cell : cells) {
      const bool covered = has_zero && cell.element != zero &&
                           (introduced[i].contains(zero) || introduced[i].contains(cell.element));
      check.expect(cell.highlighted == covered, [&] {
        return PaperFinding{fmt::format("{}: {} is {}highlighted", block_name(parsed, i),
                                        cell.element, cell.highlighted ? "" : "not "),
                            fmt::format("{{{},{}}} is {}covered in this block", zero, cell.element,
                                        covered ? "" : "not "),
                            "x is highlighted where {0,x} is covered"};
      });
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
    check.expect(
        in_print == built,
        [&] {
          return PaperFinding{
              fmt::format("{} = {}",
                          i < parsed.blocks.size() ? block_name(parsed, i) : "no further block",
                          in_braces(in_print)),
              built.empty() ? "there is no such block" : in_braces(built), how};
        },
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
  Check check(table.place, "the kind that it is shown as", "readings");
  const Verdict circular = verify(printed_design(table, Kind::circular));
  check.expect(!circular.valid(), [&] {
    return PaperFinding{
        "every element of the first block is marked as introduced, as in a linear design",
        fmt::format("it is circular as it stands: {}", in_words(circular)),
        "the last block and the first differ in exactly two elements. Not an error: it is more "
        "than "
        "the table shows"};
  });
  return std::move(check).finish();
} catch (const BadInput& fault) {
  return unreadable(table, fault);
}

}  // namespace changeover
