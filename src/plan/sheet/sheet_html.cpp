// Run sheets to print: one page that needs nothing else.
#include <fmt/format.h>

#include <algorithm>

#include "changeover/io/tables.hpp"
#include "plan/sheet/sheet_html.hpp"
#include "plan/sheet/sheet_words.hpp"

namespace changeover {

std::string html_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

namespace {

constexpr std::string_view style = R"(
  @page { size: A4; margin: 14mm 12mm; }
  * { box-sizing: border-box; }
  body { margin: 2rem auto; max-width: 60rem; padding: 0 1rem; color: #000; background: #fff;
         font: 14px/1.4 "Helvetica Neue", Helvetica, Arial, "Liberation Sans", sans-serif; }
  h1 { font-size: 1.6rem; margin: 0 0 .25rem; }
  h2 { font-size: 1.1rem; margin: 2rem 0 .5rem; }
  p { margin: .25rem 0; }
  dl { display: flex; flex-wrap: wrap; gap: .5rem 2.25rem; margin: .75rem 0; padding: .6rem 0;
       border-top: 2px solid #000; border-bottom: 1px solid #000; }
  dt { font-size: .75rem; }
  dd { margin: 0; font-size: 1.15rem; font-weight: 600; font-variant-numeric: tabular-nums; }
  .small { font-size: .85em; }
  table { width: 100%; border-collapse: collapse; }
  thead { display: table-header-group; }
  tr { break-inside: avoid; }
  th { text-align: left; font-size: .75rem; border-bottom: 2px solid #000; vertical-align: bottom; }
  th, td { padding: .3rem .5rem; }
  th:first-child, td:first-child { padding-left: 0; }
  td { border-bottom: 1px solid #999; vertical-align: top; }
  .n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
  .in { font-weight: 600; }
  .part { white-space: nowrap; }
  .part:not(:last-child)::after { content: " \00b7"; }
  .wide { white-space: normal; }
  .lines .part { display: block; }
  .lines .part::after { content: none !important; }
  .lines .wide { padding-left: 1em; text-indent: -1em; }
  .lines .flow .part { display: inline; padding: 0; }
  .lines .flow .part:not(:last-child)::after { content: " \00b7" !important; }
  .box { display: inline-block; width: 1em; height: 1em; border: 1.5px solid #000;
         vertical-align: -.12em; }
  .verdict { white-space: nowrap; width: 1%; }
  .notes { width: 30%; min-width: 45mm; }
  .bench { break-before: page; }
  .many .setup { width: 40%; }
  .many .notes { width: 10%; min-width: 22mm; }
  .compact { font-size: .85em; }
  .two { columns: 2; column-gap: 8mm; }
  .compact td { border-bottom: 1px solid #999; padding: .15rem .3rem; }
  .compact .notes { width: 18%; min-width: 20mm; }
  @media print { body { margin: 0; max-width: none; padding: 0; font-size: 9pt; line-height: 1.25; }
                 dl { gap: .5rem 1.4rem; } dd { font-size: 11pt; }
                 h2 { break-after: avoid; } }
  @media screen and (max-width: 40rem) {
    body { margin: 1rem auto; }
    .two { columns: 1; }
    .compact { font-size: 1em; }
    .steps, .steps tbody { display: block; }
    .steps thead { display: none; }
    .steps tr { display: flex; flex-wrap: wrap; gap: .15rem 1rem; padding: .5rem 0;
                border-bottom: 1px solid #999; }
    .steps td { display: block; padding: 0; border: 0; text-align: left; width: auto; }
    .steps td:nth-child(2) { font-weight: 600; }
    .steps td:nth-child(n+3) { flex-basis: 100%; }
    .steps td:empty { display: none; }
    .steps .part { display: inline !important; padding: 0; }
    .steps .part:not(:last-child)::after { content: " \00b7" !important; }
    .steps td:nth-child(2)::before { content: "Step "; }
    .steps td:nth-child(3)::before { content: "Take out: "; }
    .steps td:nth-child(4)::before { content: "Put in: "; }
    .whole td:nth-child(5)::before { content: "Set-up: "; }
    .whole td:nth-child(6)::before { content: "New pairs: "; }
    .whole td:nth-child(7)::before { content: "Cost so far: "; }
    .whole td:nth-child(n+6) { flex-basis: auto; }
    th, td { padding: .3rem .25rem; }
    .n { white-space: normal; } }
)";

// Long names stand one a line, short ones side by side.
bool has_long_names(const Job& job) {
  constexpr std::size_t long_name = 8;
  return std::any_of(job.names.begin(), job.names.end(),
                     [](const std::string& name) { return display_width(name) > long_name; });
}

// A list of parts; the marked ones are bold. The style puts dots between them where they stand side by side.
std::string list(const Job& job, const Block& parts, const Block& marked) {
  constexpr std::size_t wide_name = 26;
  std::string text;
  for (const Element x : parts) {
    const bool bold = std::find(marked.begin(), marked.end(), x) != marked.end();
    text += fmt::format("{}<span class=\"part{}{}\">{}</span>", text.empty() ? "" : " ",
                        bold ? " in" : "", display_width(job.names[x]) > wide_name ? " wide" : "",
                        html_text(job.names[x]));
  }
  return text;
}

// What is put in for what, one a line.
std::string words_in_bold(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& each : words) {
    text +=
        fmt::format("{}<span class=\"in\">{}</span>", text.empty() ? "" : "<br>", html_text(each));
  }
  return text;
}

// The same in a line of text.
std::string in_words(const Job& job, const Block& parts) {
  return html_text(joined(names_of(job, parts), " · "));
}

std::string figure(const std::string& what, const std::string& value) {
  return fmt::format("  <div><dt>{}</dt><dd>{}</dd></div>\n", what, html_text(value));
}

std::string figures(const SheetDocument& document) {
  const Job& job = *document.job;
  const RunSheet& sheet = document.plan->sheet;
  const Money money(job, document.budget);
  std::string text = "<dl>\n";
  text += figure("Parts, at a time", fmt::format("{}, {}", job.parts(), job.at_once));
  text += figure("Tests", fmt::format("{}", sheet.steps.size()));
  text += figure("Changes", fmt::format("{}", sheet.changes));
  if (job.triples.empty()) {
    text += figure("Pairs tested", fmt::format("{} of {}", sheet.pairs_tested, sheet.pairs_needed));
  } else {
    text += figure("Triples tested",
                   fmt::format("{} of {}", sheet.triples_tested, sheet.triples_needed));
  }
  text += figure("Cost of tests", money(sheet.cost - sheet.change_cost));
  text += figure("Cost of changes", money(sheet.change_cost));
  text += figure("Total cost", money(sheet.cost));
  if (document.budget) {
    text += figure("Budget", money(*document.budget));
  }
  return text + "</dl>\n";
}

std::string constraints(const SheetDocument& document) {
  const Job& job = *document.job;
  std::string text;
  if (!job.mounted.empty()) {
    text += "<p>Stay mounted: " + in_words(job, job.mounted) + "</p>\n";
  }
  if (!job.start.empty()) {
    text += "<p>Mounted before the first step: " + in_words(job, job.start) + "</p>\n";
  }
  if (job.tests_done > 0) {
    text += fmt::format("<p>{} done before.</p>\n", count_of(job.tests_done, "test"));
  }
  return text;
}

}  // namespace

std::string html_steps(const SheetDocument& document) {
  const Job& job = *document.job;
  const Money money(job, document.budget);
  const bool whole = !document.compact;
  const bool long_names = has_long_names(job);
  // One name a line would make a step as high as a third of a page.
  constexpr std::uint64_t most_lines = 6;
  const bool flows = whole && long_names && job.room() > most_lines;
  std::string text =
      whole ? "" : fmt::format("<div class=\"compact{}\">\n", long_names ? "" : " two");
  text += fmt::format("<table class=\"steps{}{}\">\n",
                      !whole       ? ""
                      : long_names ? " whole lines"
                                   : " whole",
                      flows ? " many" : "");
  text += fmt::format(
      "<thead><tr><th>Pass Fail</th><th class=\"n\">Step</th><th>Take out</th><th>Put in</th>"
      "{}<th class=\"notes\">Notes</th></tr></thead>\n<tbody>\n",
      whole
          ? fmt::format(
                "<th class=\"setup\">Set-up</th><th class=\"n\">New<br>{}</th>{}<th class=\"n\">Cost<br>so far</th>",
                what_meets(job), job.replaces() ? "<th class=\"n\">Cost</th>" : "")
          : "");
  std::uint64_t number = job.tests_done;
  for (const RunStep& step : document.plan->sheet.steps) {
    text += fmt::format(
        "<tr><td class=\"verdict\"><span class=\"box\"></span> <span class=\"box\"></span></td>"
        "<td class=\"n\">{}</td><td>{}</td><td>{}</td>",
        ++number, list(job, step.take_out, {}),
        job.replaces() ? words_in_bold(put_in_words(job, step))
                       : list(job, step.put_in, step.put_in));
    if (whole) {
      text += fmt::format(
          "<td{}>{}</td><td class=\"n\">{}</td>{}<td class=\"n\">{}</td>",
          flows ? " class=\"flow\"" : "", list(job, without_mounted(job, step.setup), step.put_in),
          new_here(job, step),
          job.replaces() ? fmt::format("<td class=\"n\">{}</td>", money(step.cost)) : "",
          money(step.cost_so_far));
    }
    text += "<td></td></tr>\n";
  }
  return text + "</tbody>\n</table>\n" + (whole ? "" : "</div>\n");
}

namespace {

std::string comparison(const SheetDocument& document) {
  const Job& job = *document.job;
  const Money money(job, document.budget);
  std::string text =
      "<h2>Compared</h2>\n<table>\n<thead><tr><th>Plan</th><th class=\"n\">Tests</th>"
      "<th class=\"n\">Changes</th><th class=\"n\">Cost</th><th class=\"n\">" +
      std::string(job.triples.empty() ? "Pairs" : "Triples") +
      "</th><th class=\"n\">Dearer by</th></tr></thead>\n<tbody>\n";
  for (const Candidate& candidate : document.plan->candidates) {
    text += fmt::format(
        "<tr><td>{}<br><span class=\"small\">{}</span></td><td class=\"n\">{}</td>"
        "<td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td>"
        "<td class=\"n\">{}</td></tr>\n",
        html_text(candidate.name), html_text(candidate.how), candidate.tests(), candidate.changes,
        money(candidate.cost), tested_by(job, candidate),
        html_text(difference(document, candidate)));
  }
  return text + "</tbody>\n</table>\n";
}

}  // namespace

std::string html_page(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n{2}"
      "</body>\n</html>\n",
      html_text(title), style, body);
}

std::string sheet_as_html(const SheetDocument& document) {
  std::string notes;
  const std::vector<std::string> lines = summary(document);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    notes += fmt::format("<p class=\"small\">{}</p>\n", html_text(lines[i]));
  }
  return html_page(document.title, figures(document) + constraints(document) +
                                       html_steps(document) + comparison(document) + notes);
}

}  // namespace changeover
