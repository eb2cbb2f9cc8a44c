// A request for a plan or a diagnosis as plain data, made by every door; and its check and its
// answer.
//
//     JobRequest request{.items = 9, .at_once = 3, .test_cost = "1", .change_cost = "5"};
//     // {"format":"changeover-job/1","items":9,"at_once":3,"test_cost":"1","change_cost":"5"}
//     to_json(request);
//     const CheckedJobRequest asked = checked_job(request, Door::document);
//     RunControl control({.threads = 1});
//     const PlanAnswer answer = answer_to(asked, control);
//     answer.plan->sheet.steps.size();                        // 17
//
// The document, format "changeover-job/1": the keys of job_table(), with numbers, texts and truth
// values as in JSON. Amounts are numbers or texts, and exact. A list is an array of its rows
// (RowShape, io/request.hpp), {"file": its path} or {"text": the content of a file}. "parts" may be
// a number, like "items"; "model" is a text. Parts are given by name or by number, from 1; a name
// takes precedence.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "changeover/io/request.hpp"
#include "changeover/plan/benches.hpp"
#include "changeover/plan/diagnosis.hpp"
#include "changeover/plan/job.hpp"
#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// The keys of a request; job_table() says what each one means.
struct JobRequest {
  RequestList model = {};
  std::optional<std::uint64_t> items = {};
  RequestList parts = {};
  bool header = false;
  bool no_header = false;
  bool items_are_parts =
      false;  ///< the document gives the number of items as "parts"; messages then do, too
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
  RequestPlaces places = {};

  bool operator==(const JobRequest&) const = default;
};

/// All options of plans, in the order of the help text, and the rules between them.
[[nodiscard]] const RequestTable<JobRequest>& job_table();

/// Writes one line of JSON that job_request() reads back as the same request.
[[nodiscard]] std::string to_json(const JobRequest& request);

/// Reads a request document; `name` is the name of its file, or empty; `door` says how messages
/// spell its keys. Files that it names are not opened. @throws BadInput with one line, and a place
/// in the file if there is one, if the document is invalid.
[[nodiscard]] JobRequest job_request(std::string json, std::string name = "",
                                     Door door = Door::document);

/// The same for the server: messages do not name keys that it does not take.
[[nodiscard]] JobRequest job_request_sent(std::string json, std::string name);

/// Returns a JSON Schema (draft 2020-12) of the document.
[[nodiscard]] std::string job_request_schema();

/// Fills the keys that `request` does not have from `other`.
void complete(JobRequest& request, JobRequest other);

/// A request completed from the workbook of its parts list, and notes on what was taken from there,
/// one per line.
struct OpenedRequest {
  JobRequest request;
  std::vector<std::string> notes;
  /// Keys of the question in the workbook that have no meaning for this request, as a budget for a
  /// diagnosis: the question of the answer has them again.
  JobRequest kept = {};
};

/// If the parts are in a workbook and no sheet of it is named: a workbook that was made as a run
/// sheet, or as those of several benches, has the question that it was made for on a hidden sheet,
/// which is taken where the request says nothing, and the tests on it that have a result are those
/// that were done; a budget is less by what they cost, and the first day is that of the first test
/// that was not. Lists on its other sheets count if they were changed since. In other workbooks,
/// slots, forbidden pairs, priorities, costs by what is replaced and benches are found on sheets by
/// their names. Every other request comes back as it is. @throws
/// BadInput for a workbook that cannot be read, and for a question in it that is damaged, of
/// another kind, or that names files; MissingResource for a file that cannot be read.
[[nodiscard]] OpenedRequest open_workbook(JobRequest request);

/// Checks ranges and combinations of keys, before any list is read. @throws BadOption, naming
/// options as the door does.
void check_options(const JobRequest& request, Door door);

/// What the lists of a request say.
struct ReadJob {
  CheckedJob job;
  std::vector<std::string> notes;  ///< remarks on the job, one per line
  std::string done_from;           ///< where the tests that were done were read from
  std::vector<Bench> benches;      ///< the requested benches; the job is then that of all
  std::vector<Block>
      rest;  ///< remaining set-ups of the current plan; with benches, each has its own
  std::vector<DoneTest> done;              ///< tests that were done, in order
  DoneRecord record;                       ///< the same as written on the sheet
  std::vector<TestedSetup> results;        ///< tests that passed or failed
  std::uint64_t unread = 0;                ///< number of results that are not understood
  std::vector<UnreadResult> first_unread;  ///< the first of these
  /// The note on tests with a result that a diagnosis leaves out; empty if there is none.
  std::string left_out;
  /// The request with its lists as rows, without the tests that were done: it needs no file.
  JobRequest question;
};

/// A request that was read and checked completely, with what was read; only checked_job() makes
/// one. Copies share it. *asked is a ReadJob.
class CheckedJobRequest {
 public:
  [[nodiscard]] const JobRequest& request() const { return *request_; }
  [[nodiscard]] const ReadJob& operator*() const { return *read_; }
  [[nodiscard]] const ReadJob* operator->() const { return read_.get(); }

 private:
  friend CheckedJobRequest checked_job(const OpenedRequest& opened, Door door,
                                       std::optional<double> seconds);
  CheckedJobRequest(JobRequest request, ReadJob read)
      : request_(std::make_shared<const JobRequest>(std::move(request))),
        read_(std::make_shared<const ReadJob>(std::move(read))) {}

  std::shared_ptr<const JobRequest> request_;
  std::shared_ptr<const ReadJob> read_;
};

/// Reads the lists of a request and checks all of it: the only way from a request to a job, for
/// every door. The scope of this thread (run/control.hpp) limits its time. @throws BadOption,
/// naming options as the door does, for wrong keys; BadInput for wrong lists; MissingResource for
/// files that cannot be read. O(v³ + size of the lists).
[[nodiscard]] CheckedJobRequest checked_job(const JobRequest& request, Door door);
/// Reads and checks a request that was opened, perhaps from a workbook, whose notes come first.
/// With `seconds` of a search it takes these and three more: what a job needs is decided whole, but
/// the rules of a model can be harder than any machine is fast. @throws Stopped
[[nodiscard]] CheckedJobRequest checked_job(const OpenedRequest& opened, Door door,
                                            std::optional<double> seconds = {});

/// The answer: a plan, a plan for several benches, the ranges of ratios, or a diagnosis.
struct PlanAnswer {
  std::optional<RunPlan> plan = {};
  std::optional<BenchPlan> benches = {};
  std::optional<WhatIf> what_if = {};
  std::optional<Diagnosis> diagnosis = {};
  std::size_t bench = 0;     ///< of several: the number of the one that the next test is for
  PlanOptions options = {};  ///< with which it was searched for
  BenchObjective objective = BenchObjective::makespan;
  std::vector<std::string> notes = {};  ///< of the job, and of the planning

  /// RunPlan::shortage of the answer.
  [[nodiscard]] const std::optional<std::string>& shortage() const;
  /// RunPlan::why_stopped of the answer; `exhausted` for a diagnosis.
  [[nodiscard]] WhyStopped why_stopped() const;
};

/// The objective of plans for several benches.
[[nodiscard]] BenchObjective bench_objective(const JobRequest& request);

/// The search options of a request.
[[nodiscard]] PlanOptions plan_options(const CheckedJobRequest& asked);

/// Plans or diagnoses. Time and threads are those of the control. A requested time is used up;
/// otherwise the search ends by itself, so that answers are reproducible. @throws as
/// make_run_plan(), make_bench_plan(), what_if() and diagnose(); BadInput if there is no result to
/// diagnose. `on_better` as in PlanOptions.
[[nodiscard]] PlanAnswer answer_to(const CheckedJobRequest& asked, RunControl& control,
                                   std::function<void(const PlanNews&)> on_better = {});

/// Writes the answer in one of the formats table, csv, markdown, html, xlsx, json; `width` is that
/// of a terminal. "json" is "changeover-plan/1", "changeover-benches/1", "changeover-what-if/1" or
/// "changeover-diagnosis/1", with the same bytes at every door. @throws BadOption for a format that
/// the answer does not have; as written() of sheet_formats.hpp.
[[nodiscard]] std::string written(const CheckedJobRequest& asked, const PlanAnswer& answer,
                                  const std::string& format, std::size_t width = 80);

}  // namespace changeover
