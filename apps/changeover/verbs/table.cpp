// changeover table: the best known design for every v and k of a range.
#include <fmt/format.h>

#include <limits>

#include "answer/answer.hpp"
#include "answer/catalog/entry_words.hpp"
#include "answer/known/known_table.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/version.hpp"
#include "changeover/verify/verdict.hpp"
#include "construct/known_tables.hpp"
#include "core/words.hpp"
#include "io/table/table.hpp"
#include "request/parameters.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct TableRequest {
  std::string k = "3..8";
  std::string v = "..40";
  std::optional<std::uint64_t> change;
  std::optional<Kind> kind;
  bool anew = false;
  OutputRequest output;
};

std::string construction(const KnownCell& cell) {
  return cell.best ? cell.best->recipe.construction : "";
}

Table cell_table(const Cells& cells) {
  std::vector<std::vector<std::string>> rows;
  for (const KnownCell* cell : cells) {
    const Parameters& p = cell->parameters;
    rows.push_back({std::to_string(p.v), std::to_string(p.k), std::to_string(p.change),
                    std::string(to_string(p.kind)), cell->best ? std::to_string(cell->best->b) : "",
                    cell->impossible ? "" : std::to_string(cell->bound.blocks),
                    std::string(cell->status()), construction(*cell)});
  }
  return table_of({{"v", number_column},
                   {"k", number_column},
                   {"change", number_column},
                   {"kind", {}},
                   {"b", number_column},
                   {"lower_bound", number_column},
                   {"status", {}},
                   {"construction", {}}},
                  std::move(rows));
}

// Lines of a catalog: the design of each cell, built to know its checksum.
std::string as_catalog(const Cells& cells, const TableRequest& request) {
  const Credit credit{.who = "The Changeover developers",
                      .date = today(),
                      .program = "changeover " + std::string(version),
                      .command = fmt::format("changeover table --k {} --v {} --change {}",
                                             request.k, request.v, request.change.value_or(2))};
  std::string text = header_line(credit) + "\n";
  for (const KnownCell* cell : cells) {
    if (!cell->best) {
      continue;
    }
    const Recipe& recipe = cell->best->recipe;
    std::optional<CatalogEntry> entry;
    if (recipe.construction == "found" && recipe.inputs.empty()) {
      entry = standard_catalog().find(recipe.provenance);
    }
    if (!entry) {
      entry.emplace();
      entry->parameters = cell->parameters;
      entry->lower_bound = cell->bound.blocks;
      entry->reason = cell->bound.reason;
      entry->recipe = recipe;
      entry->credit = credit;
      const DesignDigest digest = design_digest(*Registry::standard().build(recipe));
      entry->b = digest.b;
      entry->checksum = digest.checksum;
    }
    text += line_of(*entry, credit) + "\n";
  }
  return text;
}

std::string summary(const Cells& cells) {
  std::size_t possible = 0;
  std::size_t minimum = 0;
  double ratios = 0;
  for (const KnownCell* cell : cells) {
    if (cell->best) {
      ++possible;
      minimum += cell->status() == "minimum" ? 1U : 0U;
      ratios += static_cast<double>(cell->best->b) / static_cast<double>(cell->bound.blocks);
    }
  }
  return possible == 0 ? std::string()
                       : fmt::format("{}, {} proved minimum; mean of b / lower bound {:.4f}\n",
                                     count_of(possible, "cell"), minimum,
                                     ratios / static_cast<double>(possible));
}

Answer run(const TableRequest& request) {
  constexpr std::size_t most_wide = std::numeric_limits<std::size_t>::max();  // a grid is one
  TableRange range = table_range(request.k, request.v, request.change);
  range.kind = request.kind;
  const KnownTable table = known_table(range, request.anew ? Stored::anew : Stored::as_shipped);
  const std::string format = request.output.format();
  Cells all;
  std::string text;
  for (const Kind kind : kinds_of(request.kind)) {
    const Cells cells = table.cells(kind);
    text += format == "markdown" ? fmt::format("### {}\n\n{}\n", known_grid_title(cells),
                                               table_markdown(known_grid(cells)))
            : format == "latex"  ? known_grid_latex(cells)
            : format == "table"
                ? fmt::format("{}\n{}\n{}\n", known_grid_title(cells),
                              table_text(known_grid(cells), most_wide), summary(cells))
                : "";
    all.insert(all.end(), cells.begin(), cells.end());
  }
  if (format == "json" || format == "csv") {
    text = format == "json" ? table_json(all) + "\n" : table_csv(cell_table(all));
  } else if (format == "catalog") {
    text = as_catalog(all, request);
  }
  return text_answer(text, request.output);
}

}  // namespace

void add_table(Program& program) {
  auto [verb, request] = program.add<TableRequest>(
      "table", "list the best known design for every v and k of a range", run);
  verb.option("--k", request.k, "A..B", "block sizes (default 3..8)");
  verb.option("--v", request.v, "C..D", "numbers of elements (default ..40)");
  verb.option("-m,--change", request.change, "M",
              "elements in which consecutive blocks differ (default 2)");
  add_kind_to(verb, request.kind, "circular designs only", "linear designs only");
  verb.flag("--anew", request.anew,
            "apply the closure rules to cells of the built-in catalog too, as if they were new");
  request.output.add_to(verb, {"table", "csv", "json", "markdown", "latex", "catalog"});
  verb.examples({"changeover table --k 3..6 --v ..30",
                 "changeover table --k 4 --v 5..100 --change 1 --json"});
}

}  // namespace changeover::cli
