// The question of an experimenter as plain data: what every door makes of what it is given, and
// what is planned for.
//
//     JobRequest request{.items = 9, .at_once = 3, .test_cost = "1", .change_cost = "5"};
//     // {"format":"changeover-job/1","items":9,"at_once":3,"test_cost":"1","change_cost":"5"}
//     to_json(request);
//     const ParsedJob asked = checked_job(request, Door::document);
//     RunControl control({.threads = 1});
//     const PlanAnswer answer = answer_to(request, asked, control);
//     answer.plan->sheet.steps.size();                        // 17
//
// The document, format "changeover-job/1": the keys of job_table(), with numbers, texts and truth
// values as JSON has them. Amounts are numbers or texts, and exact. A list is an array of its rows
// (RowShape, io/request.hpp), {"file": its path} or {"text": what a file would hold}. "parts" may
// be a number, as "items" is; "model" is a text. Parts are named, or numbered from 1; a name wins.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/io/request.hpp"
#include "changeover/plan/benches.hpp"
#include "changeover/plan/diagnosis.hpp"
#include "changeover/plan/job.hpp"
#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// What can be asked of plans; what each key means is said by job_table().
struct JobRequest {
  RequestList model = {};
  std::optional<std::uint64_t> items = {};
  bool items_are_parts = false;  ///< the document calls that number "parts"; so do messages
  RequestList parts = {};
  bool header = false;
  bool no_header = false;
  std::string cost_column = {};
  std::optional<std::uint64_t> at_once = {};
  std::string test_cost = {};
  std::string change_cost = {};
  RequestList change_costs = {};
  std::string cost_unit = {};
  std::optional<std::uint64_t> strength = {};
  RequestList pairs = {};
  RequestList never = {};
  RequestList slots = {};
  std::string slot = {};
  std::vector<std::string> mounted = {};
  std::vector<std::string> start = {};
  RequestList first = {};
  RequestList weights = {};
  std::string budget = {};
  RequestList done = {};
  std::optional<std::uint64_t> done_first = {};
  bool trust_failed = false;
  std::vector<std::string> without = {};
  RequestList benches = {};
  std::string objective = {};
  std::string hours = {};
  std::string first_day = {};
  bool weekends = false;
  bool what_if = false;
  bool diagnose = false;
  std::optional<std::uint64_t> shuffle = {};
  bool compact = false;
  std::string title = {};
  std::optional<std::uint64_t> steps = {};
  std::optional<double> seconds = {};
  std::optional<std::uint64_t> threads = {};
  std::optional<std::uint64_t> seed = {};

  bool operator==(const JobRequest&) const = default;
};

/// All options of plans, in the order of the help, and the rules between them.
[[nodiscard]] const RequestTable<JobRequest>& job_table();

/// One line of JSON that job_request() reads back as the same request.
[[nodiscard]] std::string to_json(const JobRequest& request);

/// A request from its document; `name` is that of the file it is from, or empty. No file that it
/// names is opened.
/// @throws BadInput with one line, with a place if there is a file, for what is no such document.
[[nodiscard]] JobRequest job_request(std::string json, std::string name = "");

/// A JSON Schema (draft 2020-12) of the document.
[[nodiscard]] std::string job_request_schema();

/// Takes from `other` what `request` does not say.
void complete(JobRequest& request, JobRequest other);

/// A request with what the workbook of its parts list says besides, and what was taken from there,
/// a line each.
struct OpenedRequest {
  JobRequest request;
  std::vector<std::string> notes;
};

/// If the parts are in a workbook and no sheet of it is named: a workbook that was made as a run
/// sheet has the question that it was made for on a hidden sheet, which is taken where the request
/// says nothing, and the tests on it that have a result are those that were done; a budget is less
/// by what they cost. Lists on its other sheets count if they were changed since. In other
/// workbooks, slots, forbidden pairs, priorities and costs by what is
/// replaced are found on sheets by their names. Every other request comes back as it is. @throws
/// BadInput for a workbook that cannot be read, and for a question in it that is damaged, of
/// another kind, or that names files; MissingResource for a file that cannot be read.
[[nodiscard]] OpenedRequest open_workbook(JobRequest request);

/// What two keys cannot mean together, and what is out of range, before any list is read. @throws
/// BadOption in the words of the door.
void check_options(const JobRequest& request, Door door);

/// A request of which everything was read and checked.
struct ParsedJob {
  CheckedJob job;
  std::vector<std::string> notes;    ///< what else is to be said of it, a line each
  std::string done_from;             ///< what the tests that were done were read from
  std::vector<Bench> benches;        ///< those that were asked for; the job is then that of all
  std::vector<Block> rest;           ///< of the plan that is under way; of benches each has its own
  std::vector<DoneTest> done;        ///< tests that were done, in their order
  DoneRecord record;                 ///< the same as they are written
  std::vector<TestedSetup> results;  ///< those that passed or failed
  std::uint64_t unread = 0;          ///< results that are not understood
  std::vector<UnreadResult> first_unread;  ///< the first of them
  /// What was asked, its lists as rows, but for tests that were done: it needs no file.
  JobRequest question;
};

/// Reads the lists of a request and checks all of it: the one way from a question to a job, for
/// every door. What waits is bounded by the scope of this thread (run/control.hpp). @throws
/// BadOption, in the words of the door, for keys that are wrong; BadInput for lists that are;
/// MissingResource for files that cannot be read. O(v³) and the size of the lists.
[[nodiscard]] ParsedJob checked_job(const JobRequest& request, Door door);
/// The same of one that was opened: its notes come first.
[[nodiscard]] ParsedJob checked_job(const OpenedRequest& opened, Door door);

/// What comes of it: the plan, that for several benches, the ranges of ratios, or the diagnosis.
struct PlanAnswer {
  std::optional<RunPlan> plan = {};
  std::optional<BenchPlan> benches = {};
  std::optional<WhatIf> what_if = {};
  std::optional<Diagnosis> diagnosis = {};
  PlanOptions options = {};  ///< with which it was searched for
  BenchObjective objective = BenchObjective::makespan;
  std::vector<std::string> notes = {};  ///< those of the job, and of how it was planned

  /// As RunPlan::shortage.
  [[nodiscard]] const std::optional<std::string>& shortage() const;
};

/// The options of the search that a request asks for.
[[nodiscard]] PlanOptions plan_options(const JobRequest& request, const ParsedJob& asked);

/// Plans, or diagnoses. The time and the threads are those of the control; a time that was asked
/// for is used, otherwise the search ends by itself, so that answers repeat. @throws as
/// make_run_plan(), make_bench_plan(), what_if() and diagnose(); BadInput if there is no result to
/// be diagnosed. `on_better` as in PlanOptions.
[[nodiscard]] PlanAnswer answer_to(const JobRequest& request, const ParsedJob& asked,
                                   RunControl& control,
                                   std::function<void(const PlanNews&)> on_better = {});

/// The answer in one of the formats table, csv, markdown, html, xlsx, json; `width` is that of a
/// terminal. "json" is "changeover-plan/1", "changeover-benches/1", "changeover-what-if/1" or
/// "changeover-diagnosis/1": the same bytes at every door.
/// @throws BadOption for a format that such an answer does not have; as written() of
/// sheet_formats.hpp.
[[nodiscard]] std::string written(const JobRequest& request, const ParsedJob& asked,
                                  const PlanAnswer& answer, const std::string& format,
                                  std::size_t width = 80);

}  // namespace changeover
