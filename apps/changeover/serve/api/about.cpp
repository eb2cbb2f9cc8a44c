// What the server is and what it knows in general.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>

#include "answer/catalog/entry_words.hpp"
#include "answer/known/theorems.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/version.hpp"
#include "changeover/run/control.hpp"
#include "io/write/json_writer.hpp"
#include "serve/api/about.hpp"
#include "serve/api/routes.hpp"

namespace changeover::serve {
namespace {

Response about(const Explorer& explorer) {
  const Catalog::Size size = explorer.catalog.size();
  JsonWriter json;
  json.begin_object().key("version").value(version);
  json.key("catalog")
      .begin_object()
      .key("designs")
      .value(size.designs)
      .key("cells")
      .value(size.cells);
  json.key("version").value(size.latest).end_object();
  const Limits& limits = explorer.limits;
  json.key("limits").begin_object().key("body_bytes").value(limits.body_bytes);
  json.key("seconds").value(limits.seconds.count()).key("memory").value(limits.memory_bytes);
  json.key("searches").value(limits.searches).end_object();
  json.key("write").value(explorer.may_write);
  std::uint64_t index = 0;
  json.objects("files", explorer.files, [&](const GivenFile& file) {
    json.key("index").value(++index).key("name").value(file.name);
  });
  json.key("static").value(false).end_object();
  return json_response(json.take() + "\n");
}

// The smallest parameters, by v, then k, that show a construction.
struct Examples {
  std::optional<Parameters> made;  // its design is the one that is shown
  std::optional<Parameters> best;  // as few blocks as any
  std::optional<Parameters> any;

  [[nodiscard]] const std::optional<Parameters>& shown() const {
    return made ? made : best ? best : any;
  }
};

// Examples of each construction, by the change number; 0 is any.
using ExamplesOf = std::map<std::pair<std::string_view, std::uint64_t>, Examples>;

void add_examples(const Registry& registry, const Parameters& p, ExamplesOf& examples) {
  const std::vector<Offer> offers = registry.offers(p);
  for (const Offer& offer : offers) {
    const Construction* const made = registry.find(offer.recipe.construction);
    for (const std::uint64_t change : {std::uint64_t{0}, p.change}) {
      Examples& of = examples[{made->name(), change}];
      const auto take = [&](std::optional<Parameters>& place, bool fits) {
        place = place || !fits ? place : std::optional(p);
      };
      take(of.any, true);
      take(of.best, offer.b == offers.front().b);
      take(of.made, &offer == &offers.front());
    }
  }
}

ExamplesOf examples_of_constructions() {
  constexpr std::uint64_t largest_v = 40;
  constexpr std::uint64_t largest_k = 8;
  constexpr std::uint64_t largest_change = 3;
  ExamplesOf examples;
  Parameters p;
  for (p.v = 3; p.v <= largest_v; ++p.v) {
    for (p.k = 2; p.k <= std::min(largest_k, p.v); ++p.k) {
      for (const std::uint64_t change : {std::uint64_t{2}, std::uint64_t{1}, std::uint64_t{3}}) {
        for (const Kind kind : {Kind::circular, Kind::linear}) {
          stop_if_asked();
          p.change = change;
          p.kind = kind;
          if (change <= std::min(p.k, largest_change) && !impossibility(p)) {
            add_examples(Registry::standard(), p, examples);
          }
        }
      }
    }
  }
  return examples;
}

// That of any change number where there is none of this one.
std::optional<Parameters> example_of(const ExamplesOf& examples, std::string_view construction,
                                     std::uint64_t change = 0) {
  auto found = examples.find({construction, change});
  found = found == examples.end() ? examples.find({construction, 0}) : found;
  return found == examples.end() ? std::nullopt : found->second.shown();
}

// The change number of the designs that a theorem is about, as the paragraph with its name says; 0
// if there are several.
std::uint64_t change_of(std::string_view statement) {
  statement.remove_prefix(std::min(statement.find("**Theorem"), statement.size()));
  statement = statement.substr(0, statement.find("\n\n"));
  const bool single = statement.find("SCCD") != std::string_view::npos;
  const bool twice = statement.find("DCCD") != std::string_view::npos;
  return single == twice ? 0 : single ? 1 : 2;
}

void write_example(JsonWriter& json, const std::optional<Parameters>& p) {
  json.key("example");
  p ? json.begin_object().cell(*p).end_object() : json.null();
}

}  // namespace

std::string constructions_json() {
  const auto examples = examples_of_constructions();
  JsonWriter json;
  json.objects(Registry::standard().constructions(), [&](const Construction* each) {
    json.key("name").value(each->name()).key("summary").value(each->summary());
    json.key("citation").value(each->citation().to_string());
    json.key("serves").value(each->preconditions()).key("gives").value(each->guarantee());
    write_example(json, example_of(examples, each->name()));
  });
  return json.take() + "\n";
}

std::string theorems_json() {
  const auto examples = examples_of_constructions();
  JsonWriter json;
  json.objects(cli::theorems_of(cli::theorems_text()), [&](const cli::Theorem& theorem) {
    json.key("number").value(theorem.number).key("title").value(theorem.title);
    json.key("statement").value(theorem.statement).key("proof").value(theorem.proof);
    // The parameters of an example of a construction that cites this theorem.
    std::optional<Parameters> example;
    for (const Construction* each : Registry::standard().constructions()) {
      const std::string cited = each->citation().to_string();
      if (!example && cited.ends_with("docs/theorems.md, Theorem " + theorem.number + "]")) {
        example = example_of(examples, each->name(), change_of(theorem.statement));
      }
    }
    write_example(json, example);
  });
  return json.take() + "\n";
}

void add_about(Router& router, Explorer& explorer) {
  const auto add = [&](const std::string& path, std::function<Response()> answer,
                       Lane lane = Lane::slow) {
    Route route = question(explorer, path, {}, Again::while_unchanged,
                           [answer = std::move(answer)](const Request&) { return answer(); });
    route.lane = always(lane);
    router.add(std::move(route));
  };
  add(
      "api/about", [&explorer] { return about(explorer); }, Lane::quick);
  add("api/completeness", [&explorer] {
    return json_response(
        cli::completeness_json(cli::completeness(explorer.catalog, {.best_only = true})) + "\n");
  });
  add("api/constructions", [] { return json_response(constructions_json()); });
  add("api/theorems", [] { return json_response(theorems_json()); });
}

}  // namespace changeover::serve
