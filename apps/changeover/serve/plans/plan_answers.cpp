#include "serve/plans/plan_answers.hpp"

#include <fmt/format.h>

#include <array>
#include <set>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/plan/run_plan.hpp"
#include "core/each.hpp"
#include "io/request/request_document.hpp"
#include "io/write/json_writer.hpp"
#include "plan/sheet/sheet_words.hpp"
#include "serve/api/request/query.hpp"

namespace changeover::serve {
namespace {

JobRequest job_in(const std::string& body) {
  JobRequest request = job_request_sent(body, std::string(name_of_body));
  require_of_server(request, job_table());
  return request;
}

// What the question of a workbook says for the machine on which it was made.
void forget_the_machine(JobRequest& request) {
  request.threads.reset();
  request.compact = false;
}

// A job is read before its costs are known.
void take_usual_costs(JobRequest& request) {
  const std::string usual = "1";
  request.test_cost = request.test_cost.empty() ? usual : request.test_cost;
  request.change_cost = request.change_cost.empty() ? usual : request.change_cost;
}

void write_tests(JsonWriter& json, const Job& job, const std::vector<DoneTest>& done,
                 const RunSheet& sheet) {
  std::uint64_t number = 0;
  json.key("tests").begin_array();
  for (const DoneTest& test : done) {
    json.begin_object().key("number").value(++number);
    json.key("parts").value(names_of(job, test.setup));
    json.key("out").begin_array().end_array().key("in").begin_array().end_array();
    json.key("cost").value(0U).key("changes").value(0U).key("done").value(true).end_object();
  }
  for (const RunStep& step : sheet.steps) {
    json.begin_object().key("number").value(++number);
    json.key("parts").value(names_of(job, step.setup));
    json.key("out").value(names_of(job, step.take_out));
    json.key("in").value(names_of(job, step.put_in));
    json.key("cost").raw(to_string(step.cost)).key("changes").value(step.put_in.size());
    json.key("done").value(false).end_object();
  }
  json.end_array();
}

void write_alternatives(JsonWriter& json, const Job& job, const RunPlan& plan) {
  json.objects("alternatives", plan.candidates, [&](const Candidate& candidate) {
    json.key("name").value(candidate.name).key("how").value(candidate.how);
    json.key("change").value(run_sheet(job, candidate.setups).constant_change());
    json.key("tests").value(candidate.tests()).key("changes").value(candidate.changes);
    json.key("cost").raw(to_string(candidate.cost));
    json.key("bound").raw(to_string(plan.bound.cost));
  });
}

// The keys that the explorer's pages read, from before there was a document of a plan.
void write_plan(JsonWriter& json, const CheckedJobRequest& asked, const PlanAnswer& answer) {
  const Job& job = *asked->job;
  const RunPlan& found = *answer.plan;
  const RunSheet& sheet = found.sheet;
  write_tests(json, job, asked->done, sheet);
  json.key("cost").raw(to_string(sheet.cost)).key("changes").value(sheet.changes);
  json.key("bound").raw(to_string(found.bound.cost)).key("reason").value(found.bound.reason);
  json.key("cheapest").value(found.proved_cheapest());
  json.key("met_only_in_failed").value(job.met_only_in_failed);
  write_alternatives(json, job, found);
  // The sheet was counted by code that shares nothing with what made it.
  json.key("verified").value(sheet.does_the_job());
  SheetDocument document{.job = &job, .plan = &found};
  json.key("csv").value(written(document, "csv"));
}

// All sheets of an answer.
std::vector<const RunSheet*> sheets_of(const PlanAnswer& answer) {
  std::vector<const RunSheet*> sheets;
  if (answer.plan) {
    sheets.push_back(&answer.plan->sheet);
  }
  if (answer.benches) {
    for (const RunSheet& sheet : answer.benches->sheets) {
      sheets.push_back(&sheet);
    }
  }
  return sheets;
}

void require_small(std::size_t bytes, std::size_t most) {
  if (bytes > most) {
    throw Refusal{413, fmt::format("the answer has more than {} bytes; take a file of csv with "
                                   "api/plan/start and api/plan/file, or use changeover plan",
                                   most)};
  }
}

// Every writer names the parts of each test: what has too many names is not written first.
void require_few_names(const CheckedJobRequest& asked, const PlanAnswer& answer, std::size_t most) {
  std::size_t bytes = 0;
  for (const RunSheet* const sheet : sheets_of(answer)) {
    for (const RunStep& step : sheet->steps) {
      for (const Element part : step.setup) {
        bytes += asked->job->names[part].size();
      }
      require_small(bytes, most);
    }
  }
}

std::size_t bytes_of(const std::vector<Block>& setups) {
  return sum_of<std::size_t>(
      setups, [&](const Block& setup) { return sizeof(Block) + setup.size() * sizeof(Element); });
}

// The parts as they are listed: a part without a cost has none.
RequestList listed(const PartList& parts) {
  std::vector<ListRow> rows;
  for (std::size_t i = 0; i < parts.names.size(); ++i) {
    ListRow& row = rows.emplace_back();
    row.fields = {parts.names[i], parts.change_costs[i] ? to_string(*parts.change_costs[i]) : "",
                  parts.slots.empty() ? "" : parts.slots[i],
                  parts.quantities.empty() ? "" : std::to_string(parts.quantities[i])};
  }
  return {.rows = std::move(rows)};
}

// The slots that a parts list names, without limits.
RequestList slots_named(const PartList& parts) {
  std::set<std::string> seen;
  std::vector<ListRow> rows;
  for (const std::string& slot : parts.slots) {
    if (!slot.empty() && seen.insert(slot).second) {
      rows.push_back({{slot, "", ""}});
    }
  }
  return {.rows = std::move(rows)};
}

// The same with some number of parts at once.
CheckedJobRequest checked_without_room(OpenedRequest& opened) {
  constexpr std::uint64_t some = 2;
  const bool of_triples = opened.request.strength.value_or(some) > some;
  opened.request.at_once = of_triples ? some + 1 : some;
  return checked_job(opened, Door::document);
}

// If a job does not say how many parts fit, everything else is read.
CheckedJobRequest checked_for_reading(OpenedRequest& opened, bool has_limits) {
  const JobRequest& request = opened.request;
  const bool needs_room = !request.at_once && !request.model.is_given();
  if (needs_room && !has_limits) {
    return checked_without_room(opened);
  }
  try {
    return checked_job(opened, Door::document);
  } catch (const BadInput&) {
    if (!needs_room) {
      throw;
    }
    return checked_without_room(opened);
  }
}

// In the words of the pages.
std::string_view word_of(TestResult result) {
  constexpr std::array<std::string_view, 6> words{"", "pass", "fail", "done", "not run", "other"};
  return words.at(static_cast<std::size_t>(result));
}

void write_done(JsonWriter& json, const DoneRecord& record) {
  json.key("done").begin_object();
  json.objects("places", record.places, [&](const DonePlace& place) {
    json.key("number").value(place.number).key("slot").value_or_null(place.slot);
  });
  json.objects("tests", record.tests, [&](const DoneRecord::Test& test) {
    json.key("bench").value_or_null(test.bench);
    json.key("places").value(test.parts).key("result").value(test.result);
    json.key("verdict").value(word_of(result_of(test.result)));
    json.key("notes").value(test.notes);
  });
  json.end_object();
}

}  // namespace

OpenedRequest sent_job(const std::string& body) {
  JobRequest sent = job_in(body);  // What is malformed has its place.
  OpenedRequest opened = from_body([&] { return open_workbook(std::move(sent)); });
  forget_the_machine(opened.request);
  return opened;
}

std::string plan_json(const CheckedJobRequest& asked, const PlanAnswer& answer,
                      std::size_t most_bytes) {
  require_few_names(asked, answer, most_bytes);
  JsonWriter json;
  json.begin_object();
  if (answer.plan && !answer.what_if) {
    write_plan(json, asked, answer);
  }
  json.key(answer.diagnosis ? "diagnosis"
           : answer.what_if ? "what_if"
           : answer.benches ? "benches"
                            : "plan");
  std::string document = written(asked, answer, "json");
  document.pop_back();  // its end of line
  std::string text = json.raw(document).end_object().take() + "\n";
  require_small(text.size(), most_bytes);
  return text;
}

std::string plan_file(const CheckedJobRequest& asked, const PlanAnswer& answer,
                      const std::string& format, std::size_t most_bytes) {
  require_few_names(asked, answer, most_bytes);
  std::string text = written(asked, answer, format);
  require_small(text.size(), most_bytes);
  return text;
}

std::size_t bytes_of(const PlanAnswer& answer) {
  std::size_t bytes = sizeof(PlanAnswer);
  for (const RunSheet* const sheet : sheets_of(answer)) {
    for (const RunStep& step : sheet->steps) {
      bytes += sizeof(RunStep) +
               sizeof(Element) * (step.setup.size() + step.put_in.size() + step.take_out.size() +
                                  2 * (step.new_pairs.size() + step.replaced.size()) +
                                  3 * step.new_triples.size());
    }
  }
  if (answer.plan) {
    for (const Candidate& each : answer.plan->candidates) {
      bytes += bytes_of(each.setups);
    }
  }
  if (answer.benches) {
    for (const BenchCandidate& each : answer.benches->candidates) {
      for (const auto& list : each.lists) {
        bytes += bytes_of(list);
      }
    }
  }
  return bytes;
}

std::string read_job_json(const std::string& body) {
  JobRequest sent = job_in(body);  // What is malformed has its place.
  OpenedRequest opened = from_body([&] { return open_workbook(std::move(sent)); });
  JobRequest& request = opened.request;
  forget_the_machine(request);
  const std::string test_cost = request.test_cost;
  const std::string change_cost = request.change_cost;
  take_usual_costs(request);
  return from_body([&] {
    std::optional<PartList> parts;
    const bool has_limits = request.slots.is_given() || !request.slot.empty();
    if (request.parts.is_given()) {
      PartListOptions options{.header = request.header      ? Header::given
                                        : request.no_header ? Header::none
                                                            : Header::guessed,
                              .cost_column = request.cost_column};
      const auto list =
          open(request.parts, option_of(job_table(), "parts").record, std::string("parts"));
      parts = read_parts(*list, options);
      if (!parts->slots.empty() && !has_limits) {
        request.slots = slots_named(*parts);
      }
    }
    const bool says_room = request.at_once.has_value();
    const CheckedJobRequest asked = checked_for_reading(opened, has_limits);
    JobRequest found = asked->question;
    if (!says_room && request.at_once) {
      found.at_once.reset();
    }
    found.test_cost = test_cost;
    found.change_cost = change_cost;
    if (parts) {
      found.parts = listed(*parts);
    }
    JsonWriter json;
    std::string document = to_json(found);
    document.pop_back();  // its end of line
    json.begin_object().key("request").raw(document);
    write_done(json, asked->record);
    json.key("notes").value(asked->notes);
    return json.end_object().take() + "\n";
  });
}

}  // namespace changeover::serve
