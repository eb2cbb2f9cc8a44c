// changeover describe: every verb and option, for programs.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <ranges>

#include "answer/answer.hpp"
#include "changeover/core/version.hpp"
#include "changeover/loadorder/load_request.hpp"
#include "changeover/plan/job_request.hpp"
#include "io/request/request_schema.hpp"
#include "io/write/json_writer.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct DescribeRequest {
  const Program* program = nullptr;
  std::string schema;
  bool doors = false;
  OutputRequest output;
};

std::string as_text(const Program& program) {
  std::string text;
  for (const VerbDescription& verb : program.verbs()) {
    for (const OptionDescription& each : verb.options) {
      text +=
          fmt::format("{}\t{}\t{}\t{}\t{}\n", verb.name, each.positional ? "argument" : "option",
                      fmt::join(each.names, ","), each.kind, fmt::join(each.words, "|"));
    }
  }
  return text;
}

void write_options(JsonWriter& json, const VerbDescription& verb, bool positional) {
  const auto asked = [&](const OptionDescription& each) { return each.positional == positional; };
  json.objects(verb.options | std::views::filter(asked), [&](const OptionDescription& each) {
    if (positional) {
      json.key("name").value(each.names.front()).key("required").value(each.required);
    } else {
      json.key("names").value(each.names);
    }
    json.key("kind").value(each.kind);
    if (!each.words.empty()) {
      json.key("words").value(each.words);
    }
    json.key("help").value(each.help);
  });
}

void write_codes(JsonWriter& json, const std::vector<ExitCodeDescription>& codes) {
  json.objects(codes, [&](const ExitCodeDescription& each) {
    json.key("code").value(each.code).key("meaning").value(each.meaning);
  });
}

std::string as_json(const Program& program) {
  JsonWriter json;
  json.begin_object().key("version").value(version);
  json.objects("verbs", program.verbs(), [&](const VerbDescription& verb) {
    json.key("name").value(verb.name).key("typed").value(verb.typed());
    json.key("summary").value(verb.summary);
    write_options(json.key("arguments"), verb, true);
    write_options(json.key("options"), verb, false);
    json.key("rules").value(verb.rules).key("examples").value(verb.examples);
    write_codes(json.key("outcomes"), verb.outcomes);
  });
  json.objects("groups", program.groups(), [&](const GroupDescription& group) {
    json.key("name").value(group.name).key("summary").value(group.summary);
  });
  write_codes(json.key("exit_codes"), exit_codes());
  return json.end_object().take() + "\n";
}

// The options of each interface, for each kind of question.
std::string doors() {
  return "## Plans\n\n`plan`, `api/plan`, `changeover.plan()`: format `changeover-job/1`.\n\n" +
         doors_table(records_of(job_table())) +
         "\n## Load orders\n\n`loadorder`, `api/loadorder`, `changeover.load_order()`, "
         "`changeover_loadorder_open_with()`: format "
         "`changeover-load-request/1`.\n\n" +
         doors_table(records_of(load_table())) +
         "- C has members of `changeover_loadorder_options`, arguments and functions "
         "(`changeover/loadorder/changeover_loadorder.h`). Its steps evict and load items of one "
         "size, in one memory, so it takes no keys of sizes, levels, stores and overlap; `balance` "
         "is its default.\n";
}

Answer run(const DescribeRequest& request) {
  if (request.doors) {
    return text_answer(doors(), request.output);
  }
  if (!request.schema.empty()) {
    return text_answer(request.schema == "job" ? job_request_schema() : load_request_schema(),
                       request.output);
  }
  return text_answer(request.output.json() ? as_json(*request.program) : as_text(*request.program),
                     request.output);
}

}  // namespace

void add_describe(Program& program) {
  auto [verb, request] =
      program.add<DescribeRequest>("describe", "list every verb and option, for programs", run);
  request.program = &program;
  verb.choice("--schema", request.schema, {"job", "load-request"},
              "print the JSON Schema of these requests");
  verb.flag("--doors", request.doors,
            "print a table of the options of command line, server, Python and C, in Markdown");
  verb.exclude({"--schema", "--doors"});
  request.output.add_to(verb, {"json", "text"});
  verb.examples(
      {"changeover describe                  as JSON",
       "changeover describe --format text    as a table: verb, argument or option, names, type, "
       "allowed words",
       "changeover describe --schema job     what plan --request takes"});
}

}  // namespace changeover::cli
