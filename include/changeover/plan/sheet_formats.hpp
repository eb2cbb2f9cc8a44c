// A run sheet for people and for programs.
//
//     SheetDocument document{.job = &job, .plan = &plan, .title = "Pump bench"};
//     written(document, "table", 100);    // for a terminal of 100 columns
//     written(document, "html");          // one page to print, with boxes to tick; needs nothing else
//
// All say for each step what to take out and put in, the set-up, how many needed pairs it tests first,
// and the cost so far; all but CSV add what the plan was compared with and the lower bound with its reason.
// Costs of one document have the same number of decimals. Names are escaped as each format asks.
//
// CSV, one row a step, in LF lines; read_setups() (plan/job.hpp) reads it back:
//
//     step,take_out,put_in,slot_1,slot_2,new_pairs,cost,cost_so_far,result
//     2,Valve 2,"""Motor, small""",Pump A,"Motor, small",1,6,13,
//
// The parts of a set-up have a column each, as many as the largest set-up has parts; with slots the parts of a slot stand
// in columns of their own, called `slot_1 CPU`. What is taken out and put
// in is a list for people; the result is to be filled in. No cell is a formula to a spreadsheet: a text that would be one begins with an
// apostrophe (io/write/csv_cell.hpp), which read_setups() takes back; numbers stay numbers.
// Workbook (.xlsx), three sheets: `Run sheet` with the columns of the CSV and one for notes, as people print and fill it in;
// `Plan` with costs, bound and what was compared; `Parts`, which read_parts() reads. Names are text, whatever they look
// like, and so are costs of more than 15 digits; other numbers are numbers. read_setups() and read_done() read it back.
// JSON, one object: format "changeover-plan/1", title, parts [{name, change_cost, slot (or null; with slots only)}], at_once,
// slots [{name, least, most}], test_cost, mounted,
// start, first [[part]], tests_done, met_only_in_failed, trust_failed, tests, changes, cost, pairs_needed, pairs_tested, proved_cheapest, lower_bound {cost,
// tests, changes, reason}, budget (or null), triples_needed, triples_tested, weight {needed, tested, most (or null)} (or null), steps [{step, take_out, put_in, set_up, new_pairs [[a,b]], cost,
// cost_so_far, weight_so_far (where pairs are weighed)}], candidates [{name, how, tests, changes, cost, pairs_tested,
// triples_tested, weight}], notes [text]. If costs depend on what is replaced, also replace_costs [[number, or null where a part meets
// itself]] by part out and part in, and in each step replaced [[out, in]]. Costs are exact decimals.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// What is written; job and plan must outlive it.
struct SheetDocument {
  const Job* job = nullptr;
  const RunPlan* plan = nullptr;
  std::optional<Amount> budget = {};
  std::string title = "Run sheet";
  bool compact = false;  ///< pages and tables: what is put in and taken out, not the whole set-up
  std::vector<std::string> notes = {};  ///< what else is to be said of the job, a line each
};

/// The document as "table" for a terminal (lists are broken between parts where a line would be
/// longer than `width`), "csv", "json"
/// (one line), "markdown" (tables in the style of GitHub), "html" (a page without scripts, pictures
/// or anything from outside) or "xlsx"
/// (the bytes of a workbook), as described above; the same for the same document. @throws BadOption
/// for another format;
/// MissingResource if there is no room for the temporary files of a workbook.
[[nodiscard]] std::string written(const SheetDocument& document, std::string_view format,
                                  std::size_t width = 80);

/// The ranges of ratios with the plan that is cheapest in each and where the job stands: "table",
/// "csv", "json" or
/// "markdown". The job is the one that was asked about. @throws BadOption for another format.
[[nodiscard]] std::string written(const Job& job, const WhatIf& answer, std::string_view format);

}  // namespace changeover
