// changeover constructions: the registry as a list.
#include <fmt/format.h>

#include "answer/answer.hpp"
#include "changeover/construct/registry.hpp"
#include "io/write/json_writer.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

std::string as_text() {
  std::string text;
  for (const Construction* each : Registry::standard().constructions()) {
    text += fmt::format("{}\n  {}\n  for:     {}\n  gives:   {}\n  source:  {}\n", each->name(),
                        each->summary(), each->preconditions(), each->guarantee(),
                        each->citation().to_string());
  }
  return text;
}

std::string as_markdown() {
  std::string text =
      "# Constructions\n\nAs the registry states them; written by `changeover constructions "
      "--format "
      "markdown`.\n\n";
  for (const Construction* each : Registry::standard().constructions()) {
    text += fmt::format("## {}\n\n{}\n\n- **For** {}\n- **Gives** {}\n- **Source** {}\n\n",
                        each->name(), each->summary(), each->preconditions(), each->guarantee(),
                        each->citation().to_string());
  }
  text.pop_back();
  return text;
}

std::string as_json() {
  JsonWriter json;
  json.begin_array();
  for (const Construction* each : Registry::standard().constructions()) {
    json.begin_object().key("name").value(each->name()).key("summary").value(each->summary());
    json.key("preconditions")
        .value(each->preconditions())
        .key("guarantee")
        .value(each->guarantee());
    json.key("citation").value(each->citation().to_string()).end_object();
  }
  json.end_array();
  return json.take() + "\n";
}

Answer run(const OutputRequest& output) {
  return text_answer(output.json()                   ? as_json()
                     : output.format() == "markdown" ? as_markdown()
                                                     : as_text(),
                     output);
}

}  // namespace

void add_constructions(Program& program) {
  auto [verb, output] = program.add<OutputRequest>(
      "constructions", "what can be constructed, and by whom it was found", run);
  output.add_to(verb, {"text", "markdown", "json"});
  verb.examples({"changeover constructions", "changeover constructions --json"});
}

}  // namespace changeover::cli
