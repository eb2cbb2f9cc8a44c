// changeover design V K: the best design that a construction gives, verified.
#include <fmt/format.h>

#include "changeover/core/error.hpp"
#include "changeover/io/json_writer.hpp"
#include "show_design.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct DesignRequest {
  ParameterRequest asked;
  OutputRequest output;
  std::string construction;
  bool leaving = false;
};

std::string names_of_constructions() {
  std::string names;
  for (const Construction* construction : Registry::standard().constructions()) {
    names += (names.empty() ? "" : ", ") + std::string(construction->name());
  }
  return names;
}

// What is known of parameters that nothing serves: the bound, what is near, what would help.
int decline(const DesignRequest& request, const std::vector<Parameters>& asked) {
  const Registry& registry = Registry::standard();
  std::string text;
  bool open = false;
  for (const Parameters& p : asked) {
    if (const auto reason = impossibility(p)) {
      text += fmt::format("No {} exists: {}.\n", name(p), *reason);
      continue;
    }
    open = true;
    const Bound bound = lower_bound(p);
    text += request.construction.empty() ? fmt::format("No construction serves {}.\n", name(p))
                                         : fmt::format("The construction {} does not serve {}.\n",
                                                       request.construction, name(p));
    text += fmt::format("  at least {}: {}\n", count_of(bound.blocks, "block"), bound.reason);
    if (!request.construction.empty()) {
      std::string others;
      for (const Offer& offer : registry.offers(p)) {
        others += fmt::format("{}{} ({})", others.empty() ? "" : ", ", offer.recipe.construction,
                              count_of(offer.b, "block"));
      }
      if (!others.empty()) {
        text += "  served by: " + others + "\n";
        continue;
      }
    }
    constexpr std::size_t most_named = 6;
    constexpr std::uint64_t radius = 12;
    std::string near;
    for (const Offer& offer : registry.nearest(p, most_named, radius)) {
      near += fmt::format("{}({},{}) with {}", near.empty() ? "" : ", ", offer.recipe.parameters.v,
                          offer.recipe.parameters.k, count_of(offer.b, "block"));
    }
    text += near.empty() ? fmt::format("  nothing served within {} of v and k\n", radius)
                         : "  nearest served (v,k): " + near + "\n";
  }
  if (open) {
    text +=
        "What would help: another kind or change number, nearby parameters, or a design of your "
        "own\n"
        "to enlarge (changeover expand FILE).\n";
  }
  if (request.output.chosen() == "json") {
    JsonWriter json;
    json.begin_object().key("served").value(false).key("explanation").value(text);
    json.key("lower_bounds").begin_array();
    for (const Parameters& p : asked) {
      if (!impossibility(p)) {
        json.begin_object().key("kind").value(to_string(p.kind));
        json.key("lower_bound").value(lower_bound(p).blocks).end_object();
      }
    }
    json.end_array().end_object();
    text = json.take() + "\n";
  }
  deliver(text, "-");
  return exit_code::missing_resource;
}

int run(const DesignRequest& request) {
  const Registry& registry = Registry::standard();
  const std::vector<Parameters> asked = request.asked.parameters();
  if (!request.construction.empty() && registry.find(request.construction) == nullptr) {
    throw UsageError{fmt::format("no construction is called '{}'; there are {}",
                                 request.construction, names_of_constructions())};
  }
  const auto offer = best_offer(asked, request.construction);
  if (!offer) {
    return decline(request, asked);
  }
  const Construction& construction = *registry.find(offer->recipe.construction);
  const std::unique_ptr<BlockSource> source = registry.build(offer->recipe);
  const auto base = construction.base_blocks(offer->recipe);

  Exhibit exhibit;
  exhibit.judgement = judge(*source, *offer);
  exhibit.header.labels = construction.labels(offer->recipe, registry);
  exhibit.header.recipe = offer->recipe;
  exhibit.leaving = request.leaving;
  if (base && base->blocks.size() > 1) {
    exhibit.base_blocks = base->blocks.size();
  }
  if (const auto set = construction.expansion_set(offer->recipe, registry)) {
    for (const UnchangedSubset& subset : *set) {
      exhibit.positions.push_back(subset.position);
    }
  }
  exhibit.title = fmt::format("{}, {}: {}\n{} {}\nverified: {}", name(offer->recipe.parameters),
                              count_of(offer->b, "block"), quality(exhibit.judgement),
                              construction.explain(offer->recipe),
                              construction.citation().to_string(), exhibit.judgement.certificate);
  if (!exhibit.positions.empty()) {
    exhibit.title += fmt::format("\n^ marks the {} unchanged subsets of an expansion set",
                                 exhibit.positions.size());
  }
  show_design(*source, exhibit, request.output);
  return exit_code::done;
}

}  // namespace

void add_design(Program& program) {
  auto request = std::make_shared<DesignRequest>();
  Verb& verb = program.add("design", "the best design that a construction gives, verified");
  request->asked.add_to(verb);
  verb.option("--construction", request->construction, "NAME", "use this construction only");
  verb.flag("--leaving", request->leaving, "mark leaving elements too, in tables and LaTeX");
  request->output.add_to(verb, design_formats());
  verb.examples(
      {"changeover design 61 4                     as a table, introduced elements marked *",
       "changeover design 8 5 --leaving            leaving elements marked . too",
       "changeover design 9 5 --change 1 --json    a single-change design as JSON",
       "changeover design 21 4 --format latex -o d.tex"});
  verb.run([request] { return run(*request); });
}

}  // namespace changeover::cli
