// changeover constructions: the registry as a list.
#include <fmt/format.h>

#include "answer/answer.hpp"
#include "changeover/construct/registry.hpp"
#include "construct/known_documents.hpp"
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

Answer run(const OutputRequest& output) {
  return text_answer(output.json()                   ? constructions_json() + "\n"
                     : output.format() == "markdown" ? as_markdown()
                                                     : as_text(),
                     output);
}

}  // namespace

void add_constructions(Program& program) {
  auto [verb, output] =
      program.add<OutputRequest>("constructions", "list the constructions and their sources", run);
  output.add_to(verb, {"text", "markdown", "json"});
  verb.examples({"changeover constructions", "changeover constructions --json"});
}

}  // namespace changeover::cli
