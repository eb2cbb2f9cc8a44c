// changeover table: the best known design for every v and k of a range.
#include <fmt/format.h>

#include <limits>
#include <map>

#include "answer/answer.hpp"
#include "answer/catalog/entry_words.hpp"
#include "answer/known/known_table.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/version.hpp"
#include "changeover/verify/verdict.hpp"
#include "core/words.hpp"
#include "io/table/table.hpp"
#include "io/write/latex_prose.hpp"
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

std::string number(const KnownCell& cell) {
  if (cell.impossible) {
    return "-";
  }
  return cell.best ? fmt::format("{}{}", cell.best->b, cell.status() == "minimum" ? "=" : "") : "?";
}

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

// The construction whose citation a cell has: the outermost of its recipe that cites a publication,
// or else the outermost.
const Recipe* cited_within(const Recipe& recipe) {
  const Construction* const made = Registry::standard().find(recipe.construction);
  if (made != nullptr && !made->citation().key.empty()) {
    return &recipe;
  }
  for (const Recipe& input : recipe.inputs) {
    if (const Recipe* const found = cited_within(input)) {
      return found;
    }
  }
  return nullptr;
}

std::string credited(const KnownCell& cell) {
  const Recipe* const cited = cited_within(cell.best->recipe);
  return cited == nullptr ? construction(cell) : cited->construction;
}

// One letter for each construction of the cells, in the order in which they come.
std::map<std::string, std::string> letters_of(const Cells& cells) {
  constexpr std::size_t letters = 26;
  std::map<std::string, std::string> named;
  for (const KnownCell* cell : cells) {
    if (cell->best && !named.contains(credited(*cell))) {
      const std::size_t n = named.size();
      named[credited(*cell)] =
          (n < letters ? "" : std::string(1, static_cast<char>('a' + n / letters - 1))) +
          static_cast<char>('a' + n % letters);
    }
  }
  return named;
}

// "$\\mathbf{366}^{a}$", "$39^{b}_{\\geq 38}$".
std::string formula(const KnownCell& cell, const std::map<std::string, std::string>& letters) {
  if (cell.impossible) {
    return "--";
  }
  if (!cell.best) {
    return fmt::format("$\\geq {}$", cell.bound.blocks);
  }
  const std::string& letter = letters.at(credited(cell));
  return cell.status() == "minimum"
             ? fmt::format("$\\mathbf{{{}}}^{{{}}}$", cell.best->b, letter)
             : fmt::format("${}^{{{}}}_{{\\geq {}}}$", cell.best->b, letter, cell.bound.blocks);
}

// A row for each v, a column for each k of a range whose cells are by k, then v.
Table grid(const Cells& cells, const TableRange& range,
           const std::map<std::string, std::string>& letters) {
  const std::size_t rows = range.v.to - range.v.from + 1;
  Table grid{.rows = rows, .columns = {}};
  grid.columns.push_back({"v",
                          [&range](std::size_t row) { return std::to_string(range.v.from + row); },
                          {.kind = ColumnKind::number, .least_width = 5}});
  for (std::uint64_t k = range.k.from; k <= range.k.to; ++k) {
    const std::size_t first = (k - range.k.from) * rows;
    grid.columns.push_back(
        {fmt::format("k={}", k),
         [&cells, first](std::size_t row) { return number(*cells[first + row]); },
         {.kind = ColumnKind::number, .in = everywhere & ~in_latex}});
    grid.columns.push_back({fmt::format("$k={}$", k),
                            [&cells, &letters, first](std::size_t row) {
                              return formula(*cells[first + row], letters);
                            },
                            {.kind = ColumnKind::formula, .in = in_latex}});
  }
  return grid;
}

std::string title(const Cells& cells) {
  const Parameters& p = cells.front()->parameters;
  const std::string what = change_name(p.change);
  return fmt::format("{} {} covering designs: blocks of the best known (= minimum, - none exists)",
                     to_string(p.kind), what);
}

// The table with what its signs mean and who made the constructions.
std::string latex(const Cells& cells, const Table& shown,
                  const std::map<std::string, std::string>& letters) {
  const Parameters& p = cells.front()->parameters;
  std::map<std::string, std::string> by_letter;
  std::vector<std::string> keys;
  for (const auto& [name, letter] : letters) {
    const Citation citation = Registry::standard().find(name)->citation();
    by_letter[letter.size() == 1 ? " " + letter : letter] =
        fmt::format("{}: {} {}", letter, name, citation.to_string());
    add_keys(citation.to_string(), keys);
  }
  std::string made;
  for (const auto& [letter, words] : by_letter) {
    made += (made.empty() ? "" : "; ") + latex_prose(words, keys);
  }
  std::string bibtex;
  for (const std::string& key : keys) {
    bibtex += fmt::format("% changeover catalog cite {}\n", key);
  }
  return fmt::format(
      "% \\usepackage{{booktabs,longtable}}; BibTeX of what is cited:\n{}{}\n"
      "{{\\sloppy\\noindent The fewest blocks known of {} {} covering designs. Bold: the minimum. "
      "An index is the lower bound; --: no design exists. Made by: {}.\\par}}\n",
      bibtex, table_latex(shown), to_string(p.kind), change_name(p.change), made);
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
    const std::map<std::string, std::string> letters = letters_of(cells);
    const Table shown = grid(cells, range, letters);
    text += format == "markdown"
                ? fmt::format("### {}\n\n{}\n", title(cells), table_markdown(shown))
            : format == "latex" ? latex(cells, shown, letters)
            : format == "table" ? fmt::format("{}\n{}\n{}\n", title(cells),
                                              table_text(shown, most_wide), summary(cells))
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
