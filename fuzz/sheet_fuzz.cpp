// A parts list and a run sheet with results, as they come back from a bench: what was done is taken
// off, a sheet is made of what is left and read again, and the results are diagnosed.
#include <algorithm>

#include "changeover/plan/diagnosis.hpp"
#include "changeover/plan/run_plan.hpp"
#include "changeover/run/control.hpp"
#include "plan/sheet/places.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::sheet_fuzz {
namespace {

constexpr std::size_t most_parts_here = 12;

std::vector<Block> sorted(std::vector<Block> setups) {
  for (Block& setup : setups) {
    std::sort(setup.begin(), setup.end());
  }
  return setups;
}

void plan_again(const Job& job, RunControl& control) {
  const RunPlan plan =
      make_run_plan(job, {.steps = 200, .attempts = 1, .design_moves = 0, .states = 0}, control);
  must(plan.sheet.does_the_job(), "a plan does the job");
  must(plan.sheet.cost >= plan.bound.cost, "no plan is below its bound");
  const SheetDocument document{.job = &job, .plan = &plan};
  must(is_plain_json(changeover::written(document, "json")), "a run sheet is JSON");
  const std::string csv = changeover::written(document, "csv");
  for (const std::string& text :
       {csv, changeover::written(document, "table", 80), changeover::written(document, "html"),
        changeover::written(document, "markdown")}) {
    must(is_plain(text), "a run sheet is plain text");
  }
  const std::vector<ShownSheet> shown{{&job, &plan.sheet}};
  must(place_faults(shown, placed(shown)).empty(), "a part that stays keeps its place");
  if (plan.sheet.steps.empty()) {
    return;
  }
  std::vector<Block> setups;
  for (const RunStep& step : plan.sheet.steps) {
    setups.push_back(step.setup);
  }
  must(sorted(read_setups(*input_from_text(csv), job.names)) == sorted(setups),
       "the set-ups of a run sheet are read as written");
}

void diagnosed(const Job& job, const DoneList& done) {
  std::vector<TestedSetup> tests;
  for (const DoneRow& row : done.rows) {
    const TestResult result = result_of(row.result);
    if ((result == TestResult::pass || result == TestResult::fail) && !row.lacks &&
        !row.setup.empty()) {
      tests.push_back({row.setup, result == TestResult::fail});
    }
  }
  const Diagnosis found = diagnose(job, tests);
  must(found.passed + found.failed == tests.size(), "every result counts");
  if (found.next) {
    must(run_sheet(job, {found.next->setup}).faults.empty(), "the next test can be mounted");
  }
  for (const Suspect& suspect : found.suspects) {
    for (const TestedSetup& test : tests) {
      const auto has = [&](Element x) {
        return std::find(test.setup.begin(), test.setup.end(), x) != test.setup.end();
      };
      must((has(suspect.one) && has(suspect.other.value_or(suspect.one))) == test.failed,
           "a suspect is in all tests that failed and in none that passed");
    }
  }
  must(is_plain_json(changeover::written(job, found, "json")), "a diagnosis is JSON");
  must(is_plain(changeover::written(job, found, "table", 80)), "a diagnosis is plain text");
}

const Target target("sheet", [](const std::string& bytes) {
  const std::vector<std::string> parts = parts_of(bytes, 2);
  accepts([&] {
    const PartList list = read_parts(*input_from_text(parts[0]));
    const std::size_t count = list.names.size();
    if (count < 2 || count > most_parts_here) {
      return;
    }
    Job job =
        make_job(count, std::min<std::size_t>(count, 4), parse_amount("1"), parse_amount("5"));
    job.names = list.names;
    for (std::size_t x = 0; x < count; ++x) {
      job.change_costs[x] = list.change_costs[x].value_or(job.change_costs[x]);
    }
    const DoneList done = read_done(*input_from_text(parts[1]), job.names, job.at_once);
    RunControl control({.time = std::chrono::seconds(2)});
    const RunScope scope(control);
    try {
      diagnosed(job, done);
      std::vector<Block> whole = done.setups();
      std::erase_if(whole, [](const Block& setup) { return setup.empty(); });
      mark_done(job, whole);
      plan_again(job, control);
    } catch (const Stopped&) {
      must(control.why_stopped() == WhyStopped::time_limit, "only the time stops it");
    }
  });
});

}  // namespace
}  // namespace changeover::fuzz::sheet_fuzz
