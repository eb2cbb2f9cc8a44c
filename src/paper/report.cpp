#include "paper/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "changeover/draw/draw.hpp"
#include "core/each.hpp"
#include "io/write/json_writer.hpp"
#include "paper/checks/checks.hpp"

namespace changeover {
namespace {

// "105 marks", "1 count".
std::string counted(const PaperItem& item) {
  std::string_view unit = item.unit;
  if (item.checked == 1 && unit.ends_with('s')) {
    unit.remove_suffix(1);
  }
  return fmt::format("{} {}", item.checked, unit);
}

std::string summary(const PaperReport& report) {
  const std::size_t consequences = report.consequences();
  return fmt::format(
      "{} items: {} reproduced, {} differ, {} refuted, {} vacuous, {} not checkable{}",
      report.items.size() - consequences, report.count(PaperStatus::reproduced),
      report.count(PaperStatus::differs), report.count(PaperStatus::refuted),
      report.count(PaperStatus::vacuous), report.count(PaperStatus::not_checkable),
      consequences == 0 ? "" : fmt::format("; {} consequences", consequences));
}

// Characters on a terminal, all of width one here.
std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

// Breaks a line at blanks so that it fits into 100 columns after an indent.
void append_wrapped(std::string& out, std::string_view first, std::string_view indent,
                    std::string_view text) {
  constexpr std::size_t columns = 100;
  std::string line(first);
  bool empty = true;
  while (!text.empty()) {
    const std::size_t blank = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, blank);
    text.remove_prefix(std::min(blank + 1, text.size()));
    if (!empty && width(line) + 1 + width(word) > columns) {
      out += line + '\n';
      line = indent;
      empty = true;
    }
    line += fmt::format("{}{}", empty ? "" : " ", word);
    empty = false;
  }
  out += line + '\n';
}

// A table cell of Markdown.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '*' || c == '_' || c == '\\' || c == '<' || c == '[' || c == '`') {
      out += '\\';
    }
    out += c;
  }
  return out;
}

// Appends the items for which `shown` holds, each with its findings, under a heading; nothing if
// there is no such item.
template <typename Shown>
void append_findings(std::string& out, const PaperReport& report, std::string_view heading,
                     const Shown& shown) {
  bool headed = false;
  for (const PaperItem& item : report.items) {
    if (!shown(item)) {
      continue;
    }
    if (!headed) {
      out += fmt::format("\n## {}\n", heading);
      headed = true;
    }
    out += fmt::format("\n### {}: {}\n\n", item.place, escaped(item.what));
    for (const PaperFinding& finding : item.findings) {
      out += fmt::format("- printed: {}  \n  true: {}  \n  why: {}\n", escaped(finding.printed),
                         escaped(finding.truth), escaped(finding.why));
    }
    for (const std::string& note : item.notes) {
      out += fmt::format("- {}\n", escaped(note));
    }
  }
}

// Whether others follow from what was found there.
bool has_consequences(const PaperReport& report, const PaperItem& item) {
  return item.status == PaperStatus::refuted && item.follows.empty() &&
         std::ranges::any_of(report.items,
                             [&](const PaperItem& other) { return other.follows == item.place; });
}

}  // namespace

std::string_view to_string(PaperStatus status) {
  switch (status) {
    case PaperStatus::reproduced:
      return "reproduced";
    case PaperStatus::differs:
      return "differs";
    case PaperStatus::refuted:
      return "refuted";
    case PaperStatus::vacuous:
      return "vacuous";
    case PaperStatus::not_checkable:
      break;
  }
  return "not checkable";
}

std::size_t PaperReport::count(PaperStatus status) const {
  return static_cast<std::size_t>(std::ranges::count_if(items, [status](const PaperItem& item) {
    return item.status == status && item.follows.empty();
  }));
}

std::size_t PaperReport::consequences() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(items, [](const PaperItem& item) { return !item.follows.empty(); }));
}

PaperReport run_paper_report(const Registry& registry, const PaperReportOptions& options,
                             const Paper& paper) {
  const PaperContext context{paper, registry, options};
  PaperReport report;
  for (const auto& section :
       {check_introduction, check_history, check_cited, check_preliminaries, check_tightness,
        check_recursion, check_doubling, check_cyclic, check_corollaries, check_conclusion}) {
    std::vector<PaperItem> items = section(context);
    std::move(items.begin(), items.end(), std::back_inserter(report.items));
  }
  return report;
}

std::string render_text(const PaperReport& report) {
  std::string out;
  for (const PaperItem& item : report.items) {
    const std::string checked = item.checked > 0 ? fmt::format(" [{}]", counted(item)) : "";
    append_wrapped(out, fmt::format("{:<13} {:<16} ", to_string(item.status), item.place),
                   std::string(31, ' '), item.what + checked);
    if (!item.follows.empty()) {
      append_wrapped(out, "    ", "    ", fmt::format("follows from {}", item.follows));
    }
    for (const PaperFinding& finding : item.findings) {
      append_wrapped(out, "    printed: ", "             ", finding.printed);
      append_wrapped(out, "    true:    ", "             ", finding.truth);
      append_wrapped(out, "    why:     ", "             ", finding.why);
    }
    for (const std::string& note : item.notes) {
      append_wrapped(out, "    ", "    ", note);
    }
  }
  out += '\n' + summary(report) + '\n';
  return out;
}

std::string render_markdown(const PaperReport& report) {
  std::string out =
      "# The source paper, rebuilt\n\n"
      "This library began with [ChafeeStevens2025]. Here is each statement of the paper, its\n"
      "own and those that it cites, and what the library finds of it. *Reproduced*: rebuilt or\n"
      "recomputed, equal in every comparison. *Differs*: a misprint, or a proof that leaves\n"
      "something out. *Refuted*: false as printed, with a counterexample that was built and\n"
      "verified; most need one more condition. *Vacuous*: true, but there is no such design.\n"
      "*Not checkable*: no statement that a program could decide, or one for which the paper\n"
      "names too little. \"For all k\" is checked up to a limit that is named; where there is a\n"
      "proof, it is said. `changeover paper` writes this page.\n\n";
  out += summary(report) + ".\n";
  append_findings(out, report, "What to know first",
                  [](const PaperItem& item) { return item.comes_first; });
  append_findings(out, report, "One cause",
                  [&](const PaperItem& item) { return has_consequences(report, item); });
  append_findings(out, report, "What follows from it",
                  [](const PaperItem& item) { return !item.follows.empty(); });
  append_findings(out, report, "Other statements that are not true as printed",
                  [&](const PaperItem& item) {
                    return item.status == PaperStatus::refuted && item.follows.empty() &&
                           !has_consequences(report, item);
                  });
  append_findings(out, report, "Where the print differs", [](const PaperItem& item) {
    return item.status == PaperStatus::differs && item.follows.empty();
  });
  append_findings(out, report, "True of no design",
                  [](const PaperItem& item) { return item.status == PaperStatus::vacuous; });
  out +=
      "\n## Every item\n\n| place | claim | status | compared | remarks |\n|---|---|---|---|---|\n";
  for (const PaperItem& item : report.items) {
    std::string notes;
    if (item.findings.empty() && !item.comes_first && item.status != PaperStatus::vacuous) {
      notes = joined(item.notes, "; ", escaped);
    }
    out += fmt::format("| {} | {} | {} | {} | {} |\n", escaped(item.place), escaped(item.what),
                       item.follows.empty() ? std::string(to_string(item.status))
                                            : fmt::format("{}: follows from {}",
                                                          to_string(item.status), item.follows),
                       item.checked > 0 ? counted(item) : "", notes);
  }
  return out;
}

std::string render_json(const PaperReport& report) {
  JsonWriter json;
  json.begin_object().key("format").value("changeover-paper/3");
  json.key("reproduced").value(report.count(PaperStatus::reproduced));
  json.key("differs").value(report.count(PaperStatus::differs));
  json.key("refuted").value(report.count(PaperStatus::refuted));
  json.key("vacuous").value(report.count(PaperStatus::vacuous));
  json.key("not_checkable").value(report.count(PaperStatus::not_checkable));
  json.key("consequences").value(report.consequences());
  json.objects("items", report.items, [&](const PaperItem& item) {
    json.key("place").value(item.place).key("what").value(item.what);
    json.key("status").value(to_string(item.status));
    json.key("checked").value(item.checked).key("unit").value(item.unit);
    json.key("follows");
    json.value_or_null(item.follows);
    json.objects("findings", item.findings, [&](const PaperFinding& finding) {
      json.key("printed").value(finding.printed).key("truth").value(finding.truth);
      json.key("why").value(finding.why);
    });
    json.key("notes").value(item.notes);
  });
  json.end_object();
  return json.take();
}

namespace {

// "Figure 4a" becomes "figure-4a".
std::string file_name(const std::string& place, std::string_view extension) {
  const std::size_t blank = std::min(place.find(' '), place.size() - 1);
  return fmt::format("figure-{}.{}", place.substr(blank + 1), extension);
}

void add(std::vector<PaperFigure>& figures, const std::string& place, const Picture& picture) {
  figures.push_back({file_name(place, "svg"), svg(picture)});
  figures.push_back({file_name(place, "tex"), tikz(picture)});
}

FactorFigure printed_figure(const PrintedFactorization& printed) {
  const OneFactorization factorization = parse(printed);
  FactorFigure figure = factor_figure(factorization);
  figure.names = printed.vertices;
  figure.title = fmt::format("{}: 1-factorization of K_{}", printed.place, factorization.order);
  if (factorization.order == 8) {
    figure.centre = 7;  // the paper draws 15 in the middle
  }
  return figure;
}

// The place of a block in a table.
std::uint64_t index_of(const Design& design, Block block, const std::string& place) {
  std::ranges::sort(block);
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    if (std::is_permutation(block.begin(), block.end(), design.block(i).begin(),
                            design.block(i).end())) {
      return i;
    }
  }
  throw BadInput(fmt::format("{}: its first block is not in the table", place));
}

CircleFigure drawn_circle(const Paper& paper, const PrintedCircle& printed) {
  for (const PrintedTable& table : paper.tables) {
    const std::vector<Block> first = blocks_in(printed.first);
    if (table.parameters.v != printed.v || first.empty()) {
      continue;
    }
    const Design design = printed_design(table, Kind::circular);
    CircleFigure figure = circle_figure(design, index_of(design, first.front(), printed.place), 2);
    figure.title =
        fmt::format("{}: two consecutive blocks of the {}", printed.place, name(table.parameters));
    return figure;
  }
  throw BadInput(fmt::format("{}: no table over Z_{}", printed.place, printed.v));
}

}  // namespace

std::vector<PaperFigure> paper_figures(const Paper& paper) {
  std::vector<PaperFigure> figures;
  for (const PrintedFactorization& printed : paper.factorizations) {
    if (printed.place.starts_with("Figure")) {
      add(figures, printed.place, draw_factors(printed_figure(printed)));
    }
  }
  for (const PrintedCircle& printed : paper.circles) {
    add(figures, printed.place, draw_circle(drawn_circle(paper, printed)));
  }
  return figures;
}

}  // namespace changeover
