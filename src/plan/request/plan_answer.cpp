// Answers a checked job.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <utility>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/plan/job_request.hpp"
#include "changeover/plan/run_plan.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "plan/job/bench_jobs.hpp"
#include "plan/request/workbook/workbook_question.hpp"
#include "plan/search/first_pieces.hpp"

namespace changeover {
namespace {

// The job of the bench that the next test is for.
Job diagnosed_job(const CheckedJobRequest& asked, std::size_t bench) {
  return asked->benches.empty() ? *asked->job : job_by_itself(*asked->job, asked->benches[bench]);
}

// What comes next on each bench: the next test where it is for, and what was planned.
BenchPlan next_on_benches(const CheckedJobRequest& asked, std::size_t on, const Job& own,
                          const Diagnosis& found) {
  BenchPlan next;
  next.benches = asked->benches;
  for (std::size_t b = 0; b < next.benches.size(); ++b) {
    Bench& bench = next.benches[b];
    std::vector<Block> setups;
    if (found.next && b == on) {
      setups.push_back(found.next->setup);
    }
    std::ranges::copy_if(bench.rest, std::back_inserter(setups),
                         [](const Block& setup) { return !setup.empty(); });
    Job job = bench.down ? own : job_of_bench(*asked->job, bench);
    job.first.clear();
    next.sheets.push_back(run_sheet(job, bench.down ? std::vector<Block>() : setups));
  }
  return next;
}

// How many explanations are left at worst after the next test, and what it costs.
std::tuple<bool, std::size_t, Amount> worth_of(const Diagnosis& found) {
  if (!found.next) {
    return {true, 0, Amount{}};
  }
  const std::size_t left =
      std::max(found.next->if_it_fails.size(), found.next->if_it_passes.size());
  return {false, left, found.next->cost};
}

// Which faults the results leave, and what to test next: of benches, where that tells most for the
// least.
void diagnose_results(const CheckedJobRequest& asked, PlanAnswer& answer) {
  if (asked->results.empty()) {
    if (!asked->left_out.empty()) {
      throw BadInput(asked->left_out +
                     "; no other result says pass or fail: run more tests, and fill in theirs");
    }
    throw BadInput(
        asked->unread == 0
            ? asked->done_from + ": no result says pass or fail; fill in the column result"
            : fmt::format("{}: {} is neither pass nor fail, and no other row has a result; write "
                          "pass or fail",
                          asked->first_unread.front().place,
                          shown(asked->first_unread.front().text)));
  }
  constexpr std::size_t most_looked_at = 8;
  const std::vector<std::size_t> benches =
      asked->benches.empty() ? std::vector<std::size_t>{0}
                             : benches_with_most_parts(*asked->job, asked->benches, most_looked_at);
  for (const std::size_t bench : benches) {
    Diagnosis on_it = diagnose(diagnosed_job(asked, bench), asked->results);
    if (!answer.diagnosis || worth_of(on_it) < worth_of(*answer.diagnosis)) {
      answer.diagnosis = std::move(on_it);
      answer.bench = bench;
    }
  }
  Diagnosis& found = *answer.diagnosis;
  found.unread = asked->unread;
  found.first_unread = asked->first_unread;
  found.notes = asked->notes;
  if (asked->benches.size() > 1 && found.next) {
    found.notes.push_back("the next test is for " + name_of(asked->benches, answer.bench));
  }
}

// The request for a workbook, below its head.
std::vector<std::string> question_in_pieces(const CheckedJobRequest& asked) {
  std::string document = to_json(asked->question);
  document.pop_back();  // its line end
  std::vector<std::string> pieces = question_pieces(document);
  pieces.insert(pieces.begin(), std::string(job_table().format));
  return pieces;
}

}  // namespace

const std::optional<std::string>& PlanAnswer::shortage() const {
  static const std::optional<std::string> none;
  return what_if ? what_if->shortage : plan ? plan->shortage : benches ? benches->shortage : none;
}

WhyStopped PlanAnswer::why_stopped() const {
  return what_if   ? what_if->why_stopped
         : plan    ? plan->why_stopped
         : benches ? benches->why_stopped
                   : WhyStopped::exhausted;
}

PlanOptions plan_options(const CheckedJobRequest& asked) {
  const JobRequest& request = asked.request();
  PlanOptions options;
  if (request.model.is_given() && request.objective == "tests") {
    options.objective = PlanObjective::tests;
  }
  if (!request.budget.empty()) {
    options.budget = parse_amount(request.budget);
  }
  options.until_stopped = request.seconds.has_value() && !request.steps && !request.what_if;
  options.steps = request.steps.value_or(0);
  options.rest = asked->rest;
  return options;
}

BenchObjective bench_objective(const JobRequest& request) {
  for (const BenchObjective each : {BenchObjective::cost, BenchObjective::tests}) {
    if (request.objective == to_string(each)) {
      return each;
    }
  }
  return BenchObjective::makespan;
}

namespace {

// A time that was asked for is used up; another limit changes the answer, which then says so.
void note_limit(PlanAnswer& answer) {
  if (answer.why_stopped() == WhyStopped::time_limit && !answer.options.until_stopped) {
    answer.notes.emplace_back(
        "the time limit stopped the search; with more time the plan may be better");
  }
}

void search(const CheckedJobRequest& asked, RunControl& control,
            std::function<void(const PlanNews&)> on_better, PlanAnswer& answer) {
  const JobRequest& request = asked.request();
  answer.options = plan_options(asked);
  PlanOptions options = answer.options;
  options.on_better = std::move(on_better);
  answer.objective = bench_objective(request);
  if (!asked->benches.empty()) {
    answer.benches = make_bench_plan(
        asked->job,
        {.objective = answer.objective, .plan = std::move(options), .each = asked->benches},
        control);
    return;
  }
  answer.plan = with_first_pieces(*asked->job, make_run_plan(asked->job, options, control));
  if (request.shuffle) {
    std::uint64_t exchanged = 0;
    answer.plan = shuffled(*asked->job, std::move(*answer.plan), *request.shuffle, exchanged);
    answer.notes.push_back(
        fmt::format("shuffled with seed {}: {} stand where others stood that nothing tells apart",
                    *request.shuffle, count_of(exchanged, "part")));
  }
  if (request.what_if) {
    answer.what_if = what_if(*asked->job, *answer.plan, answer.options, control);
  }
}

}  // namespace

PlanAnswer answer_to(const CheckedJobRequest& asked, RunControl& control,
                     std::function<void(const PlanNews&)> on_better) {
  PlanAnswer answer;
  answer.notes = asked->notes;
  if (asked.request().diagnose) {
    diagnose_results(asked, answer);
    return answer;
  }
  search(asked, control, std::move(on_better), answer);
  note_limit(answer);
  if (answer.what_if) {
    answer.what_if->notes = answer.notes;
  }
  return answer;
}

std::string written(const CheckedJobRequest& asked, const PlanAnswer& answer,
                    const std::string& format, std::size_t width) {
  const JobRequest& request = asked.request();
  const Job& job = *asked->job;
  if (answer.diagnosis) {
    const Job own = diagnosed_job(asked, answer.bench);
    DiagnosisDocument document{.job = &own,
                               .found = &*answer.diagnosis,
                               .rest = asked->rest,
                               .done = &asked->record,
                               .question = question_in_pieces(asked),
                               .list = asked->question.benches};
    BenchPlan next;
    if (!asked->benches.empty()) {
      next = next_on_benches(asked, answer.bench, own, *answer.diagnosis);
      document.benches = &next;
      document.of_benches = &job;
    }
    return written(document, format, width);
  }
  if (answer.what_if) {
    return written(job, *answer.what_if, format);
  }
  if (answer.benches) {
    BenchDocument document{.job = &job,
                           .plan = &*answer.benches,
                           .objective = answer.objective,
                           .notes = answer.notes,
                           .budget = answer.options.budget,
                           .first_day = request.first_day,
                           .weekends = request.weekends,
                           .done = &asked->record,
                           .question = question_in_pieces(asked),
                           .list = asked->question.benches};
    document.title = request.title.empty() ? document.title : request.title;
    return written(document, format, width);
  }
  SheetDocument document{.job = &job, .plan = &*answer.plan, .budget = answer.options.budget};
  document.notes = answer.notes;
  document.compact = request.compact;
  document.title = request.title.empty() ? document.title : request.title;
  document.done = &asked->record;
  document.question = question_in_pieces(asked);
  return written(document, format, width);
}

}  // namespace changeover
