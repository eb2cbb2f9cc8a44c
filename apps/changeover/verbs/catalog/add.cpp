// changeover catalog add FILE…: designs into the user's catalog, verified.
#include <fmt/format.h>

#include "answer/answer.hpp"
#include "answer/catalog/entry_words.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/curator/curator.hpp"
#include "changeover/io/input.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"
#include "request/catalog_request.hpp"
#include "request/output.hpp"
#include "request/parameters.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct AddRequest {
  std::vector<std::string> paths;
  ParameterRequest declared;
  std::string who, note, cites;
  bool even_isomorphic = false;
  CatalogRequest catalog;
  OutputRequest output;
};

// What becomes of one file.
struct Arrival {
  std::string path;
  CatalogEntry entry;
  std::optional<Catalog::Known> before;  // the best of its cell
  std::optional<std::uint64_t> built;    // blocks that the registry offers
  std::optional<std::string> same_as;
  std::vector<Gain> gains;
  bool closes_up = false;  // linear, and its last and first block are consecutive, too
  std::string outcome;     // "improved", "added", "already there", "isomorphic", "invalid"
};

std::vector<std::string> words_of(const std::string& list) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t comma = std::min(list.find(',', at), list.size());
    words.push_back(list.substr(at, comma - at));
    at = comma + 1;
  }
  return words;
}

bool closes_up(const Design& design) {
  const Parameters& p = design.parameters();
  return p.kind == Kind::linear && design.block_count() > 2 &&
         difference(design.blocks().front(), design.blocks().back()).size() == p.change;
}

// What is known of the cell of a design that is not a minimum.
std::string_view status_of(const Arrival& arrival) {
  const std::uint64_t b = arrival.entry.b;
  const bool is_beaten =
      (arrival.before && arrival.before->b < b) || (arrival.built && *arrival.built < b);
  return is_beaten ? "not the best that is known" : arrival.entry.status();
}

std::string text_of(const Arrival& arrival) {
  const CatalogEntry& entry = arrival.entry;
  const std::string label = entry.label();
  const std::string path = printable(arrival.path);
  if (arrival.outcome == "already there") {
    return fmt::format("there already: {} ({})\n", label, path);
  }
  if (arrival.outcome == "isomorphic") {
    return fmt::format(
        "not added: {} is {} up to names, rotation and reversal ({}); --even-isomorphic adds it\n",
        label, *arrival.same_as, path);
  }
  std::string text = fmt::format("added: {}, {} with {}, {} ({})\n", label, name(entry.parameters),
                                 count_of(entry.b, "block"), status_of(arrival), path);
  if (arrival.outcome == "improved") {
    text += arrival.before
                ? fmt::format("  the best that was known of its cell had {}: {}\n",
                              count_of(arrival.before->b, "block"), arrival.before->label)
                : fmt::format("  the first of its cell in the catalog; constructions give {}\n",
                              arrival.built ? count_of(*arrival.built, "block") : "none");
  } else {
    text += fmt::format("  the best that is known of its cell has {}: {}\n",
                        count_of(arrival.before->b, "block"), arrival.before->label);
  }
  if (arrival.closes_up) {
    text += "  its last and first block are consecutive, too: --circular adds it as circular\n";
  }
  if (arrival.same_as) {
    text += fmt::format("  it is {} up to names, rotation and reversal\n", *arrival.same_as);
  }
  for (const Gain& gain : arrival.gains) {
    text += fmt::format(
        "  {} makes {} with {} of it; {}\n", gain.rule, name(gain.parameters),
        count_of(gain.b, "block"),
        gain.before ? fmt::format("before: {}", *gain.before) : "nothing was known before");
  }
  return text;
}

void write_json(JsonWriter& json, const Arrival& arrival) {
  json.begin_object().key("file").value(printable(arrival.path));
  json.key("label").value(arrival.entry.label()).key("outcome").value(arrival.outcome);
  json.key("closes_up").value(arrival.closes_up);
  if (arrival.before) {
    json.key("before").begin_object().key("label").value(arrival.before->label);
    json.key("b").value(arrival.before->b).end_object();
  }
  if (arrival.same_as) {
    json.key("isomorphic_to").value(*arrival.same_as);
  }
  json.objects("gains", arrival.gains, [&](const Gain& gain) {
    json.key("rule").value(gain.rule).cell(gain.parameters).key("b").value(gain.b);
    if (gain.before) {
      json.key("before").value(*gain.before);
    }
  });
  json.end_object();
}

Answer run(const AddRequest& request) {
  std::vector<InputFile> inputs;
  inputs.reserve(request.paths.size());
  for (const std::string& path : request.paths) {
    inputs.emplace_back("the design", path);
  }
  check_inputs(request.output, inputs);
  Catalog& catalog = request.catalog.open_to_change(request.output);
  const Introduction introduction{
      .credit = {.who = request.who, .date = today(), .program = "", .command = ""},
      .cites = words_of(request.cites),
      .note = request.note};
  std::vector<Arrival> arrivals;
  std::string refusals;
  SameDesigns same(catalog);
  for (const std::string& path : request.paths) {
    const auto input = open_design(path, request.declared.reading());
    const Design design = read_all(*input);
    const Newcomer newcomer = newcomer_of(design, introduction);
    if (!newcomer.entry) {
      refusals += fmt::format("INVALID: {}: {}\n", printable(path), newcomer.refused);
      continue;
    }
    Arrival arrival{path, *newcomer.entry, {}, {}, {}, {}, closes_up(design), ""};
    const CatalogEntry& entry = arrival.entry;
    if (const auto there = catalog.find(entry.label());
        !there || there->checksum != entry.checksum) {
      arrival.before = catalog.fewest(entry.parameters);
      const auto offer = Registry::standard().best(entry.parameters);
      arrival.built = offer ? std::optional(offer->b) : std::nullopt;
      arrival.same_as = same.find(entry);
      if (arrival.same_as && !request.even_isomorphic) {
        arrival.outcome = "isomorphic";
      } else if (!offer || entry.b < offer->b) {
        arrival.gains = gains_of(entry);
      }
      if (arrival.outcome.empty()) {
        same.remember(entry);  // The files after it may have the same design.
      }
    }
    arrivals.push_back(std::move(arrival));
  }
  if (!refusals.empty()) {
    return text_answer(refusals + "nothing was added\n", request.output, exit_code::refuted);
  }
  std::vector<CatalogEntry> entries;
  for (const Arrival& arrival : arrivals) {
    if (arrival.outcome.empty()) {
      entries.push_back(arrival.entry);
    }
  }
  const std::vector<Added> added = entries.empty() ? std::vector<Added>() : catalog.add(entries);
  std::string text;
  JsonWriter json;
  std::size_t next = 0;
  json.list(arrivals, [&](Arrival& arrival) {
    if (arrival.outcome.empty()) {
      const Added what = added[next++];
      arrival.outcome = what == Added::already_there ? "already there"
                        : what == Added::improved    ? "improved"
                                                     : "added";
    }
    if (arrival.outcome == "added" && !arrival.before) {
      // Another of these files was better.
      arrival.before = catalog.fewest(arrival.entry.parameters);
    }
    text += text_of(arrival);
    write_json(json, arrival);
  });
  Answer answer = text_answer(request.output.json() ? json.take() + "\n" : text, request.output);
  if (!entries.empty()) {
    answer.done_before = catalog_was_changed;
  }
  return answer;
}

}  // namespace

void add_catalog_add(Program& program) {
  auto [verb, request] =
      program.add<AddRequest>("catalog-add", "add designs to your own catalog", run);
  verb.positional("FILE", request.paths,
                  "text, JSON, CSV, GAP, Sage, XML or sets {A,B}; - is standard input");
  verb.option("-m,--change", request.declared.change, "M",
              "elements in which consecutive blocks differ, if the files do not say");
  verb.option("-t,--strength", request.declared.strength, "T", "every T elements must meet");
  add_kind_to(verb, request.declared.kind, "take them as circular, whatever the files say",
              "take them as linear");
  verb.option("--who", request.who, "NAME", "whom they are from");
  verb.option("--note", request.note, "TEXT", "a line that is kept with them");
  verb.option("--cites", request.cites, "KEYS",
              "keys of docs/references.bib, separated by commas, if they are from the literature");
  verb.flag("--even-isomorphic", request.even_isomorphic,
            "also those that are there already by other names of elements");
  request.catalog.add_to(verb);
  request.output.add_to(verb, {"text", "json"});
  verb.examples({"changeover catalog add mine.txt --who 'A. Researcher'",
                 "changeover search 9 4 --change 2 --circular --format text | changeover catalog "
                 "add -"});
  verb.outcomes({{exit_code::done, "added, or there already"},
                 {exit_code::refuted, "one of them is not a valid design; nothing was added"}});
}

}  // namespace changeover::cli
