// Run sheets for experimenters.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"
#include "changeover/plan/run_plan.hpp"
#include "changeover/plan/sheet_formats.hpp"
#include "changeover/run/scope.hpp"
#include "core/printable.hpp"
#include "io/write/json_writer.hpp"
#include "serve/api/json_body.hpp"
#include "serve/api/routes.hpp"

namespace changeover::serve {
namespace {

using Names = std::map<std::string, Element>;

struct Asked {
  Job job;
  std::vector<DoneTest> done;
  FailedTests failed = FailedTests::again;
  std::optional<double> seconds;
};

// A part by its name; a number stands for its digits.
Element part_of(const nlohmann::json& value, const Names& names, const std::string& where) {
  const std::string name = value.is_string() ? value.get<std::string>() : value.dump();
  const auto found = names.find(name);
  if (found == names.end()) {
    throw Refusal{422, fmt::format("{}: there is no part {}", where, printable(name))};
  }
  return found->second;
}

const nlohmann::json& array_of(const nlohmann::json& value, const std::string& where) {
  if (!value.is_array()) {
    throw Refusal{422, fmt::format("{}: write an array, […]", where)};
  }
  return value;
}

Amount amount_of(const std::string& text, const std::string& where) {
  try {
    return parse_amount(text);
  } catch (const std::exception& fault) {
    throw Refusal{422, fmt::format("{}: {}", where, fault.what())};
  }
}

void read_part(const nlohmann::json& part, Job& job) {
  const std::string where = fmt::format("parts[{}]", job.names.size());
  const bool named = part.is_object() && part.contains("name") && part["name"].is_string();
  if (!named && !part.is_string()) {
    throw Refusal{422, where + ": write {\"name\":…,\"cost\":…}, or the name alone"};
  }
  if (named) {
    for (const auto& [key, value] : part.items()) {
      if (key != "name" && key != "cost") {
        throw Refusal{422, fmt::format("{}: {} is not read here; a part has name and cost", where,
                                       printable(key))};
      }
    }
  }
  const std::string name = named ? part["name"].get<std::string>() : part.get<std::string>();
  if (const auto defect = text_defect(name)) {
    throw Refusal{422, fmt::format("{}: {}", where, *defect)};
  }
  const std::size_t number = job.names.size();
  job.names.push_back(name);
  if (named && part.contains("cost") && !part["cost"].is_null()) {
    const nlohmann::json& cost = part["cost"];
    job.change_costs[number] =
        amount_of(cost.is_string() ? cost.get<std::string>() : cost.dump(), where + ".cost");
  }
}

Job read_parts(JsonBody& body) {
  const nlohmann::json* const parts = body.find("parts");
  if (parts == nullptr) {
    throw Refusal{422, "parts is missing: write a number of parts, or an array of them"};
  }
  const std::uint64_t at_once = body.needed_number("at_once");
  const Amount test = amount_of(body.decimal("test_cost").value_or("1"), "test_cost");
  const Amount change = amount_of(body.decimal("change_cost").value_or("1"), "change_cost");
  if (parts->is_number_unsigned()) {
    return make_job(parts->get<std::uint64_t>(), at_once, test, change);
  }
  array_of(*parts, "parts");
  Job job = make_job(parts->size(), at_once, test, change);
  job.names.clear();
  for (const nlohmann::json& part : *parts) {
    read_part(part, job);
  }
  return job;
}

// The parts of a test that was done, or these with what came of it.
DoneTest read_done_test(const nlohmann::json& test, const Names& names, const std::string& where) {
  const auto wrong = [&] {
    return Refusal{
        422, where + ": write [\"a\",\"b\",…] or {\"parts\":[…],\"result\":\"pass\" or \"fail\"}"};
  };
  DoneTest done;
  const nlohmann::json* parts = &test;
  if (test.is_object()) {
    for (const auto& [key, value] : test.items()) {
      const bool is_result = key == "result" && (value.is_string() || value.is_null());
      if (key != "parts" && !is_result) {
        throw wrong();
      }
      if (is_result && value.is_string()) {
        done.result = result_of(value.get<std::string>());
      }
    }
    const auto found = test.find("parts");
    if (found == test.end()) {
      throw wrong();
    }
    parts = &*found;
  }
  for (const nlohmann::json& part : array_of(*parts, where)) {
    done.setup.push_back(part_of(part, names, where));
  }
  return done;
}

Asked asked_of(const Request& request) {
  JsonBody body(request.body);
  Asked asked{
      .job = read_parts(body), .done = {}, .failed = {}, .seconds = body.seconds("seconds")};
  Job& job = asked.job;
  constexpr std::uint64_t fewest = 2;
  if (job.parts() < fewest || job.at_once < fewest) {
    throw Refusal{422, "a pair needs two parts, and room for two"};
  }
  Names names;
  for (Element i = 0; i < job.parts(); ++i) {
    if (!names.emplace(job.names[i], i).second) {
      throw Refusal{422, fmt::format("two parts are called {}", printable(job.names[i]))};
    }
  }
  if (const nlohmann::json* const pairs = body.find("pairs")) {
    PairSet needed(job.parts());
    for (const nlohmann::json& pair : array_of(*pairs, "pairs")) {
      if (!pair.is_array() || pair.size() != 2) {
        throw Refusal{422, "pairs: write [[a,b],…], two parts each"};
      }
      const Element x = part_of(pair[0], names, "pairs");
      const Element y = part_of(pair[1], names, "pairs");
      if (x == y) {
        throw Refusal{422, fmt::format("pairs: {} with itself", printable(job.names[x]))};
      }
      needed.insert(x, y);
    }
    if (needed.size() == 0) {
      throw Refusal{422, "pairs: no pair is listed"};
    }
    job.needed = needed;
  }
  if (const nlohmann::json* const done = body.find("done")) {
    std::size_t left_out = 0;  // that were not run
    for (const nlohmann::json& test : array_of(*done, "done")) {
      DoneTest each =
          read_done_test(test, names, fmt::format("done[{}]", asked.done.size() + left_out));
      if (each.result == TestResult::not_run) {
        ++left_out;
      } else {
        asked.done.push_back(std::move(each));
      }
    }
  }
  if (body.boolean("trust_failed").value_or(false)) {
    asked.failed = FailedTests::trusted;
  }
  body.finish();
  return asked;
}

std::vector<std::string> names_of(const Job& job, const Block& parts) {
  std::vector<std::string> names;
  for (const Element part : parts) {
    names.push_back(job.names[part]);
  }
  return names;
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
  json.key("alternatives").begin_array();
  for (const Candidate& candidate : plan.candidates) {
    json.begin_object().key("name").value(candidate.name).key("how").value(candidate.how);
    json.key("change").value(run_sheet(job, candidate.setups).constant_change());
    json.key("tests").value(candidate.tests()).key("changes").value(candidate.changes);
    json.key("cost").raw(to_string(candidate.cost));
    json.key("bound").raw(to_string(plan.bound.cost)).end_object();
  }
  json.end_array();
}

Response plan(const Explorer& explorer, const Request& request) {
  Asked asked = asked_of(request);
  Job& job = asked.job;
  try {
    check(job);
    mark_tested(job, asked.done, asked.failed);
  } catch (const BadInput& fault) {
    throw Refusal{422, fault.what()};
  }
  constexpr double usual_seconds = 10;
  const double most_seconds = explorer.limits.seconds.count();
  const double seconds = asked.seconds.value_or(usual_seconds);
  if (seconds <= 0 || seconds > most_seconds) {
    throw Refusal{422, fmt::format("seconds: write more than 0 and at most {}", most_seconds)};
  }
  RunControl control(*RunScope::current(), std::chrono::duration<double>(seconds));
  PlanOptions options;
  options.until_stopped = asked.seconds.has_value();
  options.checked = true;
  const RunPlan found = make_run_plan(job, options, control);
  stop_if_asked();  // whoever asked may have gone
  const RunSheet& sheet = found.sheet;
  JsonWriter json;
  json.begin_object();
  write_tests(json, job, asked.done, sheet);
  json.key("cost").raw(to_string(sheet.cost)).key("changes").value(sheet.changes);
  json.key("bound").raw(to_string(found.bound.cost)).key("reason").value(found.bound.reason);
  json.key("cheapest").value(found.proved_cheapest());
  json.key("met_only_in_failed").value(job.met_only_in_failed);
  write_alternatives(json, job, found);
  // The sheet was counted by code that shares nothing with what made it.
  json.key("verified").value(sheet.does_the_job());
  SheetDocument document{.job = &job, .plan = &found};
  json.key("csv").value(sheet_as_csv(document)).end_object();
  return json_response(json.take() + "\n");
}

}  // namespace

void add_plans(Router& router, Explorer& explorer) {
  router.add(posted(explorer, "api/plan", {}, Body::json,
                    [&explorer](const Request& request) { return plan(explorer, request); }));
}

}  // namespace changeover::serve
