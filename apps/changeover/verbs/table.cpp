// changeover table: the best known design for every v and k of a range.
#include <fmt/format.h>

#include <map>

#include "answer/answer.hpp"
#include "answer/catalog/today.hpp"
#include "answer/known/planned_table.hpp"
#include "changeover/catalog/label.hpp"
#include "changeover/construct/standard_catalog.hpp"
#include "changeover/core/version.hpp"
#include "changeover/verify/verdict.hpp"
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

std::string number(const PlannedCell& cell) {
  if (cell.impossible) {
    return "-";
  }
  return cell.best ? fmt::format("{}{}", cell.best->b, cell.status() == "minimum" ? "=" : "") : "?";
}

std::string construction(const PlannedCell& cell) {
  return cell.best ? cell.best->recipe.construction : "";
}

std::string as_csv(const Cells& cells) {
  std::string text = "v,k,change,kind,b,lower_bound,status,construction\n";
  for (const PlannedCell* cell : cells) {
    const Parameters& p = cell->parameters;
    text += fmt::format("{},{},{},{},{},{},{},{}\n", p.v, p.k, p.change, to_string(p.kind),
                        cell->best ? fmt::format("{}", cell->best->b) : "",
                        cell->impossible ? "" : fmt::format("{}", cell->bound.blocks),
                        cell->status(), construction(*cell));
  }
  return text;
}

// Lines of a catalog: the design of each cell, built to know its checksum.
std::string as_catalog(const Cells& cells, const TableRequest& request) {
  const Credit credit{.who = "The Changeover developers",
                      .date = today(),
                      .program = "changeover " + std::string(version),
                      .command = fmt::format("changeover table --k {} --v {} --change {}",
                                             request.k, request.v, request.change.value_or(2))};
  std::string text = header_line(credit) + "\n";
  for (const PlannedCell* cell : cells) {
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

/// How a grid of v by k is written.
struct GridStyle {
  std::string before;  // everything
  std::string row_start, between, row_end;
  std::string after_head;  // given the number of columns
  std::string after;
  bool padded = false;
};

std::string as_grid(const Cells& cells, const GridStyle& style) {
  std::map<std::uint64_t, std::map<std::uint64_t, const PlannedCell*>> rows;
  std::map<std::uint64_t, std::size_t> widths;
  for (const PlannedCell* cell : cells) {
    rows[cell->parameters.v][cell->parameters.k] = cell;
    std::size_t& width = widths[cell->parameters.k];
    width = std::max({width, number(*cell).size(), fmt::format("k={}", cell->parameters.k).size()});
  }
  const auto pad = [&](const std::string& text, std::size_t width) {
    return style.padded ? fmt::format("{:>{}}", text, width) : text;
  };
  std::string text = style.before + style.row_start + pad("v", 5);
  for (const auto& [k, width] : widths) {
    text += style.between + pad(fmt::format("k={}", k), width);
  }
  text += style.row_end + style.after_head;
  for (const auto& [v, row] : rows) {
    text += style.row_start + pad(fmt::format("{}", v), 5);
    for (const auto& [k, cell] : row) {
      text += style.between + pad(number(*cell), widths[k]);
    }
    text += style.row_end;
  }
  return text + style.after;
}

GridStyle style_of(const std::string& format, const std::string& title, std::size_t columns) {
  if (format == "markdown") {
    std::string rule = "|---:|";
    for (std::size_t i = 0; i < columns; ++i) {
      rule += "---:|";
    }
    return {fmt::format("### {}\n\n", title), "| ", " | ", " |\n", rule + "\n", "\n", false};
  }
  if (format == "latex") {
    return {fmt::format("% {}\n\\begin{{tabular}}{{r{}}}\n", title, std::string(columns, 'r')),
            "",
            " & ",
            " \\\\\n",
            "\\hline\n",
            "\\end{tabular}\n",
            false};
  }
  return {title + "\n", "", "  ", "\n", "", "\n", true};
}

std::string title(const Cells& cells) {
  const Parameters& p = cells.front()->parameters;
  const std::string what = p.change == 1   ? "single-change"
                           : p.change == 2 ? "double-change"
                                           : fmt::format("{}-change", p.change);
  return fmt::format("{} {} covering designs: blocks of the best known (= minimum, - none exists)",
                     to_string(p.kind), what);
}

std::string summary(const Cells& cells) {
  std::size_t possible = 0;
  std::size_t minimum = 0;
  double ratios = 0;
  for (const PlannedCell* cell : cells) {
    if (cell->best) {
      ++possible;
      minimum += cell->status() == "minimum" ? 1U : 0U;
      ratios += static_cast<double>(cell->best->b) / static_cast<double>(cell->bound.blocks);
    }
  }
  return possible == 0
             ? std::string()
             : fmt::format("{} cells, {} proved minimum; mean of b / lower bound {:.4f}\n",
                           possible, minimum, ratios / static_cast<double>(possible));
}

Answer run(const TableRequest& request) {
  const TableRange range = table_range(request.k, request.v, request.change);
  const PlannedTable table = plan_table(range, request.anew ? Planned::anew : Planned::as_shipped);
  const std::string format = request.output.format();
  Cells all;
  std::string text;
  for (const Kind kind : kinds_of(request.kind)) {
    const Cells cells = table.cells(kind);
    text += as_grid(cells, style_of(format, title(cells),
                                    static_cast<std::size_t>(range.k.to - range.k.from + 1)));
    text += format == "table" ? summary(cells) + "\n" : "";
    all.insert(all.end(), cells.begin(), cells.end());
  }
  if (format == "json" || format == "csv") {
    text = format == "json" ? table_json(all) + "\n" : as_csv(all);
  } else if (format == "catalog") {
    text = as_catalog(all, request);
  }
  return text_answer(text, request.output);
}

}  // namespace

void add_table(Program& program) {
  auto [verb, request] =
      program.add<TableRequest>("table", "the best known design for every v and k of a range", run);
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
