// changeover constructions: the registry as a list.
#include <fmt/format.h>

#include "changeover/construct/registry.hpp"
#include "io/write/json_writer.hpp"
#include "request/request.hpp"
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

}  // namespace

void add_constructions(Program& program) {
  auto output = std::make_shared<OutputRequest>();
  Verb& verb = program.add("constructions", "what can be constructed, and by whom it was found");
  output->add_to(verb, {"text", "markdown", "json"});
  verb.examples({"changeover constructions", "changeover constructions --json"});
  verb.run([output] {
    const std::string format = output->chosen();
    deliver(format == "json"       ? as_json()
            : format == "markdown" ? as_markdown()
                                   : as_text(),
            *output);
    return exit_code::done;
  });
}

}  // namespace changeover::cli
