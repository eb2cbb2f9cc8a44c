// changeover describe: every verb and option, for programs.
#include <memory>

#include "changeover/core/version.hpp"
#include "io/write/json_writer.hpp"
#include "request/request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

std::string joined(const std::vector<std::string>& words, char between) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : std::string(1, between)) + word;
  }
  return text;
}

std::string as_text(const Program& program) {
  std::string text;
  for (const OptionDescription& each : program.describe()) {
    text += each.verb + (each.positional ? "\targument\t" : "\toption\t") +
            joined(each.names, ',') + "\t" + each.kind + "\t" + joined(each.words, '|') + "\n";
  }
  return text;
}

void write_options(JsonWriter& json, const std::vector<OptionDescription>& all,
                   const std::string& verb, bool positional) {
  json.begin_array();
  for (const OptionDescription& each : all) {
    if (each.verb != verb || each.positional != positional) {
      continue;
    }
    json.begin_object();
    if (positional) {
      json.key("name").value(each.names.front()).key("required").value(each.required);
    } else {
      json.key("names").value(each.names);
    }
    json.key("kind").value(each.kind);
    if (!each.words.empty()) {
      json.key("words").value(each.words);
    }
    json.key("help").value(each.help).end_object();
  }
  json.end_array();
}

std::string as_json(const Program& program) {
  const std::vector<OptionDescription> all = program.describe();
  JsonWriter json;
  json.begin_object().key("version").value(version).key("verbs").begin_array();
  for (const auto& [name, summary] : program.verbs()) {
    json.begin_object().key("name").value(name).key("summary").value(summary);
    write_options(json.key("arguments"), all, name, true);
    write_options(json.key("options"), all, name, false);
    json.end_object();
  }
  return json.end_array().end_object().take() + "\n";
}

}  // namespace

void add_describe(Program& program) {
  auto output = std::make_shared<OutputRequest>();
  Verb& verb = program.add("describe", "every verb and option of this program, for programs");
  output->add_to(verb, {"json", "text"});
  verb.examples(
      {"changeover describe                  as JSON",
       "changeover describe --format text    verb, argument or option, names, kind, words"});
  verb.run([output, &program] {
    deliver(output->chosen() == "json" ? as_json(program) : as_text(program), *output);
    return exit_code::done;
  });
}

}  // namespace changeover::cli
