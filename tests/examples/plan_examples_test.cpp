// The examples of the headers of plan/, as they stand there.
#include <iostream>

#include "example_support.hpp"

namespace changeover::test::plan_examples_test {
namespace {

TEST(PlanExamples, Benches) {
  Job job = make_job(9, 3, parse_amount("1"), parse_amount("5"));
  RunControl control({.threads = 1});
  BenchPlan plan = make_bench_plan(job, {.benches = 2}, control);
  EXPECT_EQ(to_string(plan.makespan), "63");   // when the last test ends
  EXPECT_EQ(plan.sheets[0].steps.size(), 8U);  // tests on the first bench
}

TEST(PlanExamples, Diagnosis) {
  const Job job = make_job(5, 3, parse_amount("2"), parse_amount("1"));
  StandardOutput output;
  Diagnosis found =
      diagnose(job, {{{0, 1, 2}, true}, {{0, 3, 4}, false}});  // set-ups, and whether they failed
  for (const Suspect& suspect : found.suspects) {              // part 1, part 2, pairs of 0, 1, 2
    std::cout << in_words(suspect, job.names) << '\n';
  }
  const Block test = found.next->setup;  // run it, add its result, and ask again
  EXPECT_EQ(output.take(), "2\n3\n1 with 2\n1 with 3\n2 with 3\n");
  EXPECT_TRUE(run_sheet(job, {test}).faults.empty());
}

TEST(PlanExamples, Job) {
  Job job = make_job(9, 3, parse_amount("1"), parse_amount("5"));  // nine parts, three at a time
  job.never.insert(2, 7);                                          // these two must not meet …
  job.needed = all_pairs_but(job.never);                           // … and all others must
  check(job);
  EXPECT_EQ(job.needed.size(), 35U);
}

TEST(PlanExamples, Amount) {
  const Amount test = parse_amount("1.25");
  EXPECT_EQ(to_string(test * 12 + parse_amount("0.5")), "15.50");
  EXPECT_EQ(to_string(parse_amount("3")), "3");
}

TEST(PlanExamples, ReadJob) {
  const std::string bench = R"(
    # bench.csv
    component,change cost
    Pump A,12.50
    "Valve, large",8
    Motor,3
)";
  const std::string pairs = R"(
    # pairs.csv
    Pump A,Motor
    1,2
)";
  const std::string done = R"(
    # done.csv
    Pump A,Motor
    2,3
)";
  const PartList parts = read_parts(*input_from_text(without_margin(bench)));
  EXPECT_THAT(parts.names, ElementsAre("Pump A", "Valve, large", "Motor"));
  EXPECT_EQ(parts.change_costs[0], parse_amount("12.50"));
  const PairSet needed = read_pairs(*input_from_text(without_margin(pairs)), parts.names);
  EXPECT_TRUE(needed.contains(0, 2) && needed.contains(0, 1));
  EXPECT_THAT(read_setups(*input_from_text(without_margin(done)), parts.names),
              ElementsAre(Block{0, 2}, Block{1, 2}));
}

TEST(PlanExamples, JobRequest) {
  JobRequest request{.items = 9, .at_once = 3, .test_cost = "1", .change_cost = "5"};
  EXPECT_EQ(
      to_json(request),
      "{\"format\":\"changeover-job/1\",\"items\":9,\"at_once\":3,\"test_cost\":\"1\",\"change_cost\":\"5\"}\n");
  const CheckedJobRequest asked = checked_job(request, Door::document);
  RunControl control({.threads = 1});
  const PlanAnswer answer = answer_to(asked, control);
  EXPECT_EQ(answer.plan->sheet.steps.size(), 17U);
}

TEST(PlanExamples, Model) {
  auto input = input_from_text(
      "OS:      Debian, Fedora, Windows\n"
      "Browser: Firefox, Chrome, Edge\n"
      "Locale:  de, en, ja\n"
      "IF [Browser] = \"Edge\" THEN [OS] = \"Windows\";\n");
  const Model model = read_model(*input);
  EXPECT_TRUE(follows(model, {2, 5, 7}));
  EXPECT_FALSE(follows(model, {0, 5, 7}));
  const Job job = job_of(model, parse_amount("1"), parse_amount("5"));
  EXPECT_EQ(job.parts(), 9U);
}

TEST(PlanExamples, RunPlan) {
  StandardOutput output;
  RunControl control({.time = std::chrono::seconds(10)});
  RunPlan plan = make_run_plan(make_job(9, 3, parse_amount("1"), parse_amount("5")), {}, control);
  EXPECT_GE(plan.sheet.cost, plan.bound.cost);
  for (const Candidate& c : plan.candidates) {  // cheapest first: the first one is the sheet
    std::cout << c.name << ": " << to_string(c.cost) << '\n';
  }
  EXPECT_THAT(output.take(), HasSubstr(": " + to_string(plan.sheet.cost) + "\n"));
  EXPECT_EQ(plan.candidates.front().cost, plan.sheet.cost);
}

TEST(PlanExamples, RunSheet) {
  const Job job = make_job(4, 2, parse_amount("1"), parse_amount("5"));
  const std::vector<Block> setups{{0, 1}, {0, 2}, {0, 3}, {1, 3}, {1, 2}, {3, 2}};
  RunSheet sheet = run_sheet(job, setups);
  EXPECT_TRUE(sheet.does_the_job());
  EXPECT_THAT(sheet.steps[3].put_in, ElementsAre(1U));
  EXPECT_EQ(to_string(sheet.cost), "41");
}

TEST(PlanExamples, CostBound) {
  CostBound bound = cost_bound(make_job(9, 3, parse_amount("10"), parse_amount("1")));
  EXPECT_EQ(to_string(bound.cost), "145");
  EXPECT_EQ(bound.tests, 12U);
  EXPECT_THAT(bound.reason, HasSubstr("12 tests with 25 changes"));
}

TEST(PlanExamples, WhatIf) {
  const Job job = make_job(6, 3, parse_amount("1"), parse_amount("5"));
  RunControl control({.time = std::chrono::seconds(10)});
  const PlanOptions few{.steps = 1000, .attempts = 1, .design_moves = 1000};
  const RunPlan plan = make_run_plan(job, few, control);
  control.stop(WhyStopped::found);
  StandardOutput output;
  WhatIf answer = what_if(job, plan, {}, control);
  for (const WhatIf::Range& range : answer.ranges) {  // by ratio, without gaps
    std::cout << range.plan.name << (range.to ? " up to " + range.to->to_string() : "") << '\n';
  }
  const std::string lines = output.take();
  ASSERT_FALSE(answer.ranges.empty());
  EXPECT_FALSE(answer.ranges.front().from);
  EXPECT_FALSE(answer.ranges.back().to);
  EXPECT_EQ(std::ranges::count(lines, '\n'), std::ssize(answer.ranges));
}

TEST(PlanExamples, SheetFormats) {
  Job job = make_job(3, 2, parse_amount("5"), parse_amount("1"));
  job.names = {"Pump A", "Valve 2", "Motor, small"};
  RunPlan plan;
  plan.sheet = run_sheet(job, {{0, 1}, {0, 2}, {1, 2}});
  plan.bound = cost_bound(job);
  SheetDocument document{.job = &job, .plan = &plan, .title = "Pump bench"};
  EXPECT_THAT(written(document, "table", 100), HasSubstr("Pump bench"));
  EXPECT_THAT(written(document, "html"), HasSubstr("class=\"box\""));
  const std::string example = R"(
    step,take_out,put_in,slot_1,slot_2,new_pairs,cost,cost_so_far,result
    2,Valve 2,"""Motor, small""",Pump A,"Motor, small",1,6,13,
)";
  std::istringstream lines(without_margin(example));
  for (std::string line; std::getline(lines, line);) {
    EXPECT_THAT(written(document, "csv"), HasSubstr(line + "\n"));
  }
}

}  // namespace
}  // namespace changeover::test::plan_examples_test
