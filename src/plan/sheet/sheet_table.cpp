// Run sheets for terminals.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "changeover/plan/job.hpp"
#include "core/utf8.hpp"
#include "plan/sheet/sheet_words.hpp"

namespace changeover {
namespace {

std::size_t columns_of(std::string_view text) {
  std::size_t count = 0;
  while (!text.empty()) {
    text.remove_prefix(first_code_point(text).bytes);
    ++count;
  }
  return count;
}

/// A cell is a list of words that are never broken; lines break between them.
using Cell = std::vector<std::string>;

struct Column {
  std::string head;
  bool right = false;
  std::size_t width = 0;
};

// The lines of a cell that are no longer than `width`, unless a word is.
std::vector<std::string> lines_of(const Cell& cell, std::size_t width) {
  std::vector<std::string> lines;
  std::size_t columns = 0;  // of the last line
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const std::string word = cell[i] + (i + 1 < cell.size() ? "," : "");
    const std::size_t more = columns_of(word);
    if (!lines.empty() && columns + 1 + more <= width) {
      lines.back() += " " + word;
      columns += 1 + more;
    } else {
      lines.push_back(word);
      columns = more;
    }
  }
  return lines;
}

std::string laid_out(std::vector<Column> columns, const std::vector<std::vector<Cell>>& rows,
                     std::size_t width) {
  constexpr std::size_t gap = 2;
  std::vector<std::size_t> least;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    least.push_back(columns_of(columns[c].head));
    columns[c].width = least.back();
    for (const std::vector<Cell>& row : rows) {
      for (const std::string& line : lines_of(row[c], std::string::npos / 2)) {
        columns[c].width = std::max(columns[c].width, columns_of(line));
      }
      for (const std::string& word : row[c]) {
        least[c] = std::max(least[c], columns_of(word) + (row[c].size() > 1 ? 1 : 0));
      }
    }
  }
  // The widest column that can be narrowed gives way.
  const auto total = [&] {
    return std::accumulate(columns.begin(), columns.end(), gap * (columns.size() - 1),
                           [](std::size_t sum, const Column& c) { return sum + c.width; });
  };
  while (total() > width) {
    std::size_t widest = columns.size();
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (columns[c].width > least[c] &&
          (widest == columns.size() || columns[c].width > columns[widest].width)) {
        widest = c;
      }
    }
    if (widest == columns.size()) {
      break;
    }
    --columns[widest].width;
  }
  std::string text;
  const auto write = [&](const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const std::string pad(columns[c].width - std::min(columns[c].width, columns_of(cells[c])),
                            ' ');
      line += (c == 0 ? "" : std::string(gap, ' ')) +
              (columns[c].right ? pad + cells[c] : cells[c] + pad);
    }
    line.resize(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  };
  std::vector<std::string> cells;
  cells.reserve(columns.size());
  for (const Column& column : columns) {
    cells.push_back(column.head);
  }
  write(cells);
  for (const std::vector<Cell>& row : rows) {
    std::vector<std::vector<std::string>> lines;
    std::size_t height = 1;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      lines.push_back(lines_of(row[c], columns[c].width));
      height = std::max(height, lines.back().size());
    }
    for (std::size_t i = 0; i < height; ++i) {
      for (std::size_t c = 0; c < columns.size(); ++c) {
        cells[c] = i < lines[c].size() ? lines[c][i] : "";
      }
      write(cells);
    }
  }
  return text;
}

Cell one(const std::string& word) { return {word}; }

}  // namespace

std::string sheet_as_table(const SheetDocument& document, std::size_t width) {
  const Job& job = *document.job;
  const RunPlan& plan = *document.plan;
  const Money money(job, document.budget);
  std::string text = document.title + "\n";
  for (const std::string& line : summary(document)) {
    text += line + "\n";
  }
  std::vector<std::vector<Cell>> rows;
  rows.reserve(plan.sheet.steps.size());
  std::uint64_t number = job.tests_done;
  for (const RunStep& step : plan.sheet.steps) {
    rows.push_back({one(fmt::format("{}", ++number)), names_of(job, step.take_out),
                    names_of(job, step.put_in), names_of(job, step.setup),
                    one(fmt::format("{}", step.new_pairs.size())), one(money(step.cost_so_far))});
  }
  if (!rows.empty()) {
    text += "\n" + laid_out({{"step", true},
                             {"take out"},
                             {"put in"},
                             {"set-up"},
                             {"new pairs", true},
                             {"cost so far", true}},
                            rows, width);
  }
  rows.clear();
  for (const Candidate& candidate : plan.candidates) {
    rows.push_back({one(candidate.name), one(fmt::format("{}", candidate.tests())),
                    one(fmt::format("{}", candidate.changes)), one(money(candidate.cost)),
                    one(fmt::format("{}", candidate.pairs_tested)),
                    one(difference(document, candidate)), one(candidate.how)});
  }
  text += "\nCompared\n" + laid_out({{"plan"},
                                     {"tests", true},
                                     {"changes", true},
                                     {"cost", true},
                                     {"pairs", true},
                                     {"dearer by", true},
                                     {"how"}},
                                    rows, width);
  return text;
}

std::string what_if_as_table(const Job& job, const WhatIf& answer) {
  std::string text =
      answer.by_factor
          ? "If all change costs are multiplied by a factor, the cheapest plan that is known has\n"
          : "At a ratio of change cost to test cost, the cheapest plan that is known has\n";
  std::vector<std::vector<Cell>> rows;
  rows.reserve(answer.ranges.size());
  for (const WhatIf::Range& range : answer.ranges) {
    rows.push_back({one(range.from ? range.from->to_string() : "0"),
                    one(range.to ? range.to->to_string() : "any"),
                    one(fmt::format("{}", range.plan.tests())),
                    one(fmt::format("{}", range.plan.changes)), one(range.plan.name)});
  }
  text += laid_out({{"from", true}, {"to", true}, {"tests", true}, {"changes", true}, {"plan"}},
                   rows, 200);
  if (answer.asked) {
    text += fmt::format(
        "{} {}.\n",
        answer.by_factor ? "Your costs are at the factor" : "Your costs are at the ratio",
        answer.asked->to_string());
  }
  text += job.needed.size() == 0 ? "Nothing is left to test.\n" : "";
  return text;
}

}  // namespace changeover
