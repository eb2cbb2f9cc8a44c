// changeover expand FILE: the recursion with expansion sets, applied to a design of the user's own.
#include "changeover/construct/expansion.hpp"

#include <fmt/format.h>

#include "answer/design/show_design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"
#include "request/output.hpp"
#include "request/parameters.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct ExpandRequest {
  std::string path;
  std::optional<Kind> kind;
  std::string factorization = "circle";
  std::optional<std::uint64_t> which;
  std::optional<std::uint64_t> list;
  bool count = false;
  bool partial = false;
  std::optional<std::uint64_t> nodes;
  std::optional<std::uint64_t> new_elements;
  OutputRequest output;
};

std::string members(const Design& design, const ExpansionSet& set) {
  const std::string text = joined(set, [&](const UnchangedSubset& subset) {
    return fmt::format("U_{} = {{{}}}", subset.position,
                       joined(subset.elements, ",", [&](Element x) { return design.label(x); }));
  });
  return text.empty() ? "none" : text;
}

std::size_t elements_in(const ExpansionSet& set) {
  return sum_of<std::size_t>(set,
                             [&](const UnchangedSubset& subset) { return subset.elements.size(); });
}

void add_set(const Design& design, const ExpansionSet& set, JsonWriter& json) {
  json.objects(set, [&](const UnchangedSubset& subset) {
    json.key("position").value(subset.position);
    json.list("elements", subset.elements, [&](const Element x) {
      design.labels().empty() ? json.value(x) : json.value(design.label(x));
    });
  });
}

std::string no_more(const ExpansionSearch& search) {
  if (!search.complete) {
    return "the search stopped at its limit";
  }
  return search.reason.empty() ? "every exact cover was tried" : search.reason;
}

// --list, --count, --partial: what there is, without expanding.
Answer report(const ExpandRequest& request, const Design& design) {
  request.output.require("a list of expansion sets", {"table", "text", "json"});
  ExpansionSearchOptions options;
  options.how_many = request.list.value_or(request.count ? 0 : 1);
  options.count = request.count;
  options.partial = request.partial;
  options.limits.nodes = request.nodes;
  const ExpansionSearch search = find_expansion_sets(design, options);
  std::optional<PartialExpansion> largest;
  if (request.partial) {
    largest = largest_partial_expansion_set(design, options.limits);
  }
  if (request.output.json()) {
    JsonWriter json;
    json.begin_object().key("complete").value(search.complete).key("reason").value(search.reason);
    json.key("count").value(search.count).key("partial").value(request.partial);
    json.list("sets", search.sets, [&](const ExpansionSet& set) { add_set(design, set, json); });
    if (largest) {
      json.key("largest");
      add_set(design, largest->set, json);
      json.key("largest_is_optimal").value(largest->optimal);
    }
    return text_answer(json.end_object().take() + "\n", request.output);
  }
  std::string text;
  if (largest) {
    text += fmt::format("largest partial expansion set: {} of {} elements{}\n  {}\n",
                        elements_in(largest->set), design.v(),
                        largest->optimal ? ", proved" : ", the best so far",
                        members(design, largest->set));
  }
  for (const ExpansionSet& set : search.sets) {
    text += members(design, set) + "\n";
  }
  if (request.count) {
    text += (search.count ? count_of(*search.count, "expansion set")
                          : "not counted: " + no_more(search)) +
            "\n";
  } else if (search.sets.empty() && !request.partial) {
    text += fmt::format("no expansion set found: {}\n", no_more(search));
  }
  return text_answer(text, request.output);
}

// The larger design; what is missing is said of the file.
Enlarged larger_than(const Design& design, const ExpandRequest& request) {
  EnlargeOptions options{.new_elements = request.new_elements, .set = request.which};
  options.factorization = factorization_kind_from_string(request.factorization).value();
  options.limits.nodes = request.nodes;
  if (request.which == 0) {
    throw UsageError{"--set 0: expansion sets are counted from 1; give 1 or more"};
  }
  try {
    return enlarge(design, options);
  } catch (const MissingResource& missing) {
    const std::string which = request.which ? fmt::format("--set {}: ", *request.which) : "";
    throw MissingResource(fmt::format("{}: {}{}", request.path, which, missing.what()));
  } catch (const ImpossibleParameters& impossible) {
    const std::string which =
        request.new_elements ? fmt::format("--new-elements {}: ", *request.new_elements) : "";
    throw ImpossibleParameters(which + impossible.what());
  }
}

Answer run(const ExpandRequest& request) {
  ReadOptions reading;
  reading.kind = request.kind;
  check_inputs(request.output, {{"the design", request.path}});
  const Design design = read_design(request.path, reading);
  const Verdict given = verify(design);
  if (!given.valid()) {
    throw BadInput(fmt::format("{}: not a valid {}; changeover verify {} says where", request.path,
                               name(design.parameters()), request.path));
  }
  if (request.list || request.count || request.partial) {
    return report(request, design);
  }
  const Enlarged made = larger_than(design, request);
  const Design& larger = made.design;
  const std::string how =
      (made.by_expansion_set
           ? std::string("at the expansion set ")
           : fmt::format("by {} at ", count_of(made.new_elements, "new element"))) +
      members(design, made.at);

  Exhibit exhibit;
  exhibit.judgement = judge(verify(larger));
  if (!exhibit.judgement.verdict.valid) {
    throw InternalError("the expanded design is not valid");
  }
  exhibit.header = {larger.labels(), larger.recipe};
  exhibit.title =
      fmt::format("{}, {}: {}\nexpanded from {} with {} {}\nverified: {}",
                  name(larger.parameters()), count_of(larger.block_count(), "block"),
                  quality(exhibit.judgement), name(design.parameters()),
                  count_of(design.block_count(), "block"), how, exhibit.judgement.certificate);
  return show_design(larger, std::move(exhibit), request.output);
}

}  // namespace

void add_expand(Program& program) {
  auto [verb, request] = program.add<ExpandRequest>(
      "expand", "expand your own design by the recursion with expansion sets", run);
  verb.positional("FILE", request.path,
                  "text, JSON, CSV, GAP, Sage, XML or sets {A,B}; - is standard input");
  add_kind_to(verb, request.kind, "treat the design as circular, whatever the file says",
              "treat the design as linear");
  verb.choice("--factorization", request.factorization, {"circle", "doubled"},
              "the 1-factorization of the new elements (default circle)");
  verb.option("--set", request.which, "N", "use the N-th expansion set found (default 1)");
  verb.option("--list", request.list, "N", "list up to N expansion sets instead");
  verb.flag("--count", request.count, "count all expansion sets instead");
  verb.flag("--partial", request.partial,
            "list maximal partial expansion sets, and the largest, instead");
  verb.option(
      "-w,--new-elements", request.new_elements, "W",
      "insert W new elements at unchanged subsets that may overlap; 0: the program chooses\n"
      "the best number, as it does if no expansion set has an odd number of members");
  verb.option("--nodes", request.nodes, "N", "give up after N nodes of the search");
  verb.never_with({"--set", "--new-elements", "--factorization"},
                  {"--list", "--count", "--partial"});
  verb.exclude({"--set", "--new-elements"});
  request.output.add_to(verb, design_formats());
  verb.examples({"changeover design 7 3 --linear --json | changeover expand -",
                 "changeover design 21 5 --json -o d.json && changeover expand d.json --count",
                 "changeover design 15 5 --json | changeover expand - --new-elements 4"});
}

}  // namespace changeover::cli
