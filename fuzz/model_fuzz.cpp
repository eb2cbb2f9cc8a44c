// A model of parameters, what its values cost, and tests that were done: rules that were read are
// true of the same rows for those who make tests and for the referee, a plan does the job, and its
// sheet is read as written.
#include <algorithm>

#include "changeover/plan/model.hpp"
#include "changeover/plan/run_plan.hpp"
#include "changeover/run/control.hpp"
#include "plan/search/choices/choice_lists.hpp"
#include "run/random.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::model_fuzz {
namespace {

constexpr std::size_t most_values_here = 40;
constexpr std::size_t rows_looked_at = 200;

void rules_agree(const Job& job) {
  const ChoiceJob choices(job);
  Random random(1);
  for (std::size_t i = 0; i < rows_looked_at; ++i) {
    Block row;
    for (const ModelParameter& parameter : job.model->parameters) {
      row.push_back(parameter.first + static_cast<Element>(random.below(
                                          static_cast<std::uint32_t>(parameter.values.size()))));
    }
    must(choices.allows(row) == follows(*job.model, row),
         "rules say the same, compiled or as they stand");
  }
}

void planned(const Job& job) {
  RunControl control({.time = std::chrono::seconds(2)});
  const RunScope scope(control);
  try {
    const RunPlan plan = make_run_plan(job, {.steps = 300, .attempts = 1, .states = 0}, control);
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
    std::vector<Block> setups = read_setups(*input_from_text(csv), job);
    must(setups.size() == plan.sheet.steps.size(), "a run sheet has a row a test");
    for (std::size_t i = 0; i < setups.size(); ++i) {
      std::ranges::sort(setups[i]);
      must(setups[i] == plan.sheet.steps[i].setup, "the tests of a run sheet are read as written");
    }
  } catch (const Stopped&) {
    must(control.why_stopped() == WhyStopped::time_limit, "only the time stops it");
  }
}

const Target target("model", [](const std::string& bytes) {
  const std::vector<std::string> parts = parts_of(bytes, 3);
  accepts([&] {
    Model model = read_model(*input_from_text(parts[0], "m"));
    for (const std::string& note : model.notes) {
      must(is_one_plain_line(note), "a note is one line");
    }
    for (const ModelConstraint& constraint : model.constraints) {
      must(is_one_plain_line(constraint.text), "a rule is said in one line");
    }
    if (model.values() > most_values_here) {
      return;
    }
    Job job = job_of(std::move(model), parse_amount("3"), parse_amount("1"));
    accepts([&] { (void)read_value_costs(*input_from_text(parts[1]), job); });
    rules_agree(job);
    drop_needed(job, cannot_meet(job));
    check(job);
    accepts([&] {
      const DoneList done = read_done(*input_from_text(parts[2]), job);
      Job left = job;
      std::vector<Block> whole = done.setups();
      std::erase_if(whole, [](const Block& setup) { return setup.empty(); });
      mark_done(left, whole);
      must(left.needed.size() <= job.needed.size(), "tests that were made add no pairs");
    });
    accepts([&] {
      Job first = job;
      first.first = read_first(*input_from_text(parts[2]), job);
      must(defects(first).empty(), "what is read as coming first can come first");
    });
    planned(job);
  });
});

}  // namespace
}  // namespace changeover::fuzz::model_fuzz
