#include "construct/known_tables.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <string_view>

#include "changeover/construct/registry.hpp"
#include "construct/references.hpp"
#include "core/words.hpp"
#include "io/write/latex_prose.hpp"

namespace changeover {
namespace {

std::string number(const KnownCell& cell) {
  if (cell.impossible) {
    return "-";
  }
  return cell.best ? fmt::format("{}{}", cell.best->b, cell.status() == "minimum" ? "=" : "") : "?";
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
  return cited == nullptr ? cell.best->recipe.construction : cited->construction;
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

void add_cited(const std::string& words, Citations citations, std::vector<std::string>& keys) {
  if (citations == Citations::cited) {
    add_keys(words, keys);
  }
}

}  // namespace

std::string known_grid_title(const Cells& cells) {
  const Parameters& p = cells.front()->parameters;
  const std::string what = change_name(p.change);
  return fmt::format("{} {} covering designs: blocks of the best known (= minimum, - none exists)",
                     to_string(p.kind), what);
}

Table known_grid(const Cells& cells) {
  struct Kept {
    Cells cells;
    std::map<std::string, std::string> letters;
  };
  const auto kept = std::make_shared<const Kept>(Kept{cells, letters_of(cells)});
  const Parameters& least = cells.front()->parameters;
  const Parameters& most = cells.back()->parameters;
  const std::size_t rows = most.v - least.v + 1;
  Table grid{.rows = rows, .columns = {}};
  grid.columns.push_back({"v",
                          [from = least.v](std::size_t row) { return std::to_string(from + row); },
                          {.kind = ColumnKind::number, .least_width = 5}});
  for (std::uint64_t k = least.k; k <= most.k; ++k) {
    const std::size_t first = (k - least.k) * rows;
    grid.columns.push_back(
        {fmt::format("k={}", k),
         [kept, first](std::size_t row) { return number(*kept->cells[first + row]); },
         {.kind = ColumnKind::number, .in = everywhere & ~in_latex}});
    grid.columns.push_back({fmt::format("$k={}$", k),
                            [kept, first](std::size_t row) {
                              return formula(*kept->cells[first + row], kept->letters);
                            },
                            {.kind = ColumnKind::formula, .in = in_latex}});
  }
  return grid;
}

std::string known_grid_latex(const Cells& cells, Citations citations) {
  const Parameters& p = cells.front()->parameters;
  std::map<std::string, std::string> by_letter;
  std::vector<std::string> keys;
  for (const auto& [name, letter] : letters_of(cells)) {
    const Citation citation = Registry::standard().find(name)->citation();
    by_letter[letter.size() == 1 ? " " + letter : letter] =
        fmt::format("{}: {} {}", letter, name, citation.to_string());
    add_cited(citation.to_string(), citations, keys);
  }
  std::string made;
  for (const auto& [letter, words] : by_letter) {
    made += (made.empty() ? "" : "; ") + latex_prose(words, keys);
  }
  std::string bibtex;
  for (const std::string& key : keys) {
    bibtex += fmt::format("% changeover catalog cite {}\n", key);
  }
  const std::string_view of_cited =
      citations == Citations::cited ? "; BibTeX of what is cited:" : "";
  return fmt::format(
      "% \\usepackage{{booktabs,longtable}}{}\n{}{}\n"
      "{{\\sloppy\\noindent The fewest blocks known of {} {} covering designs. Bold: the minimum. "
      "An index is the lower bound; --: no design exists. Made by: {}.\\par}}\n",
      of_cited, bibtex, table_latex(known_grid(cells)), to_string(p.kind), change_name(p.change),
      made);
}

std::string bounds_latex(const KnownBounds& answer, Citations citations) {
  std::vector<std::string> keys;
  std::string text =
      fmt::format("\\paragraph{{{}}}\n\\begin{{itemize}}\n", latex_prose(name(answer.parameters)));
  const auto item = [&](const std::string& words) {
    add_cited(words, citations, keys);
    text += fmt::format("\\item {}\n", latex_prose(words, keys));
  };
  if (answer.impossible) {
    item("impossible: " + *answer.impossible);
  }
  for (const Bound& bound : answer.bounds) {
    item(fmt::format("b >= {} ({}): {}", bound.blocks, bound.name, bound.reason));
  }
  if (answer.best) {
    const Construction& by = *Registry::standard().find(answer.best->recipe.construction);
    item(fmt::format("b <= {} ({}): {} {}", answer.best->b, by.name(),
                     by.explain(answer.best->recipe), by.citation().to_string()));
  }
  if (answer.all) {
    item("all of them: " + classified_words(*answer.all));
  }
  if (answer.reported) {
    item(fmt::format("{} [{}]: reported, blocks not held here", answer.reported->blocks,
                     answer.reported->cites));
  }
  return text + "\\end{itemize}\n";
}

}  // namespace changeover
