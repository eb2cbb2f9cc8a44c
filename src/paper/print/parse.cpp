// Reads the notation of printed.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "changeover/core/error.hpp"
#include "core/lines.hpp"
#include "core/parsed.hpp"
#include "core/words.hpp"
#include "paper/print/printed.hpp"

namespace changeover {
namespace {

PrintedCell cell_in(std::string_view token) {
  PrintedCell cell;
  if (const std::size_t colon = token.find(':'); colon != std::string_view::npos) {
    const auto colour = parsed<std::uint64_t>(token.substr(colon + 1));
    if (!colour || *colour == 0 || *colour > 99) {
      throw BadInput(fmt::format("\"{}\": a colour is a number from 1", token));
    }
    cell.colour = static_cast<unsigned>(*colour);
    token = token.substr(0, colon);
  }
  for (; token.size() > 1; token.remove_suffix(1)) {
    const char mark = token.back();
    if (mark == '*') {
      cell.introduced = true;
    } else if (mark == '_') {
      cell.leaving = true;
    } else if (mark == '^') {
      cell.caret = true;
    } else if (mark == '!') {
      cell.highlighted = true;
    } else {
      break;
    }
  }
  cell.element = std::string(token);
  return cell;
}

// "^{2}", "{2,3}" or "." where nothing is printed.
PrintedUnchanged unchanged_in(std::string_view token) {
  PrintedUnchanged unchanged;
  if (token == ".") {
    return unchanged;
  }
  if (token.starts_with('^')) {
    unchanged.caret = true;
    token.remove_prefix(1);
  }
  if (token.size() < 3 || token.front() != '{' || token.back() != '}') {
    throw BadInput(fmt::format("\"{}\" is not an unchanged subset; write {{2,3}}", token));
  }
  std::string inside(token.substr(1, token.size() - 2));
  std::ranges::replace(inside, ',', ' ');
  unchanged.elements = words(inside);
  return unchanged;
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  for (Lines each(text); each.next();) {
    if (!words(each.line()).empty()) {
      lines.emplace_back(each.line());
    }
  }
  return lines;
}

std::size_t index_of(const std::vector<std::string>& names, std::string_view name,
                     std::string_view place) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) {
    throw BadInput(fmt::format("{}: \"{}\" is none of its elements", place, name));
  }
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace

std::vector<std::string> words(std::string_view line) {
  std::vector<std::string> found;
  std::istringstream stream{std::string(line)};
  for (std::string word; stream >> word;) {
    found.push_back(word);
  }
  return found;
}

std::vector<Block> blocks_in(std::string_view text) {
  std::vector<Block> blocks;
  for (const std::string& line : lines_of(text)) {
    Block& block = blocks.emplace_back();
    for (const std::string& word : words(line)) {
      const auto number = parsed<std::uint64_t>(word);
      if (!number || *number >= max_elements_in_memory) {
        throw BadInput(fmt::format("\"{}\" in \"{}\" is not an element", word, line));
      }
      block.push_back(static_cast<Element>(*number));
    }
  }
  return blocks;
}

ParsedTable parse(const PrintedTable& table) {
  ParsedTable parsed;
  std::size_t first_column = 0;  // of the band that is being read
  for (const std::string& line : lines_of(table.layout)) {
    const std::vector<std::string> tokens = words(line);
    if (tokens.front() == "--") {
      first_column = parsed.blocks.size();
      continue;
    }
    if (tokens.front() == "U") {
      for (std::size_t i = 1; i < tokens.size(); ++i) {
        parsed.unchanged.push_back(unchanged_in(tokens[i]));
      }
      continue;
    }
    const bool header = tokens.front().starts_with('B');
    if (parsed.blocks.size() == first_column) {
      parsed.blocks.resize(first_column + tokens.size());
    }
    if (parsed.blocks.size() - first_column != tokens.size()) {
      throw BadInput(fmt::format("{}: \"{}\" has {}, the line before {}", table.place, line,
                                 count_of(tokens.size(), "column"),
                                 parsed.blocks.size() - first_column));
    }
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      PrintedBlock& block = parsed.blocks[first_column + i];
      if (header) {
        block.name = tokens[i];
      } else {
        block.cells.push_back(cell_in(tokens[i]));
      }
    }
  }
  for (std::size_t i = 0; i < parsed.unchanged.size(); ++i) {
    if (parsed.unchanged[i].caret) {
      parsed.carets.push_back(i);
    }
  }
  for (std::size_t i = 0; i < parsed.blocks.size(); ++i) {
    const auto& cells = parsed.blocks[i].cells;
    if (std::ranges::any_of(cells, [](const auto& cell) { return cell.caret; })) {
      parsed.carets.push_back(i + 1);
    }
  }
  return parsed;
}

std::string element_name(const PrintedTable& table, Element element) {
  return element < table.elements.size() ? table.elements[element] : fmt::format("{}", element);
}

Design printed_design(const PrintedTable& table, Kind kind) {
  const Parameters parameters = table.parameters.as(kind);
  std::vector<std::string> names;
  for (Element x = 0; x < parameters.v; ++x) {
    names.push_back(element_name(table, x));
  }
  Design design(parameters);
  for (const PrintedBlock& printed : parse(table).blocks) {
    Block block;
    for (const PrintedCell& cell : printed.cells) {
      block.push_back(static_cast<Element>(index_of(names, cell.element, table.place)));
    }
    design.append(block);
  }
  design.set_labels(std::move(names));
  return design;
}

OneFactorization parse(const PrintedFactorization& printed) {
  OneFactorization factorization;
  factorization.order = static_cast<std::uint32_t>(printed.vertices.size());
  for (const std::string& line : lines_of(printed.factors)) {
    OneFactor& factor = factorization.factors.emplace_back();
    for (const std::string& edge : words(line)) {
      const std::size_t dash = edge.find('-');
      if (dash == std::string::npos) {
        throw BadInput(fmt::format("{}: \"{}\" is not an edge", printed.place, edge));
      }
      const auto a = index_of(printed.vertices, edge.substr(0, dash), printed.place);
      const auto b = index_of(printed.vertices, edge.substr(dash + 1), printed.place);
      factor.push_back(
          {static_cast<std::uint32_t>(std::min(a, b)), static_cast<std::uint32_t>(std::max(a, b))});
    }
  }
  return factorization;
}

std::vector<Block> base_blocks(const PrintedBaseBlocks& row, std::uint64_t k) {
  std::vector<Block> blocks;
  for (const std::string& terms : row.further) {
    Block& block = blocks.emplace_back();
    for (Element x = 0; x + 2 < k; ++x) {
      block.push_back(x);
    }
    std::string spaced = terms;
    std::ranges::replace(spaced, ',', ' ');
    for (const std::string& term : words(spaced)) {
      const auto value = value_of(term, {{'k', k}}).count();
      if (!value || *value >= max_elements_in_memory) {
        throw BadInput(fmt::format("{}: cannot read \"{}\"", row.place, term));
      }
      block.push_back(static_cast<Element>(*value));
    }
  }
  return blocks;
}

namespace {

template <typename Item, typename Place>
const Item& item_at(const std::vector<Item>& items, std::string_view place, std::string_view what,
                    const Place& place_of) {
  const auto found =
      std::ranges::find_if(items, [&](const Item& item) { return place_of(item) == place; });
  if (found == items.end()) {
    throw BadInput(fmt::format("the paper has no {} \"{}\"", what, place));
  }
  return *found;
}

}  // namespace

const PrintedTable& table_at(const Paper& paper, std::string_view place) {
  return item_at(paper.tables, place, "table of blocks",
                 [](const PrintedTable& table) { return table.place; });
}

const PrintedFamily& family_at(const Paper& paper, std::string_view place) {
  return item_at(paper.families, place, "family",
                 [](const PrintedFamily& family) { return family.design.place; });
}

const PrintedDesign& formulas_at(const std::vector<PrintedDesign>& designs,
                                 std::string_view place) {
  return item_at(designs, place, "formulas at",
                 [](const PrintedDesign& design) { return design.place; });
}

const std::string& claim_at(const Paper& paper, std::string_view place) {
  return item_at(paper.statements, place, "statement",
                 [](const PrintedStatement& statement) { return statement.place; })
      .claim;
}

}  // namespace changeover
