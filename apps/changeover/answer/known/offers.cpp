#include "answer/known/offers.hpp"

#include <fmt/format.h>

#include "changeover/construct/best_known.hpp"
#include "changeover/core/error.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"

namespace changeover::cli {

std::optional<Offer> best_known(const Parameters& p) {
  return changeover::best_known(Registry::standard(), p);
}

std::optional<Offer> best_offer(const std::vector<Parameters>& asked,
                                const std::string& construction) {
  const Construction* const named = Registry::standard().find(construction);
  if (named == nullptr && !construction.empty()) {
    std::string names;
    for (const Construction* each : Registry::standard().constructions()) {
      names += (names.empty() ? "" : ", ") + std::string(each->name());
    }
    throw UsageError{
        fmt::format("no construction is called '{}'; there are {}", construction, names)};
  }
  return changeover::best_offer(Registry::standard(), asked, named);
}

Answer decline(const std::vector<Parameters>& asked, const std::string& construction,
               const OutputRequest& output) {
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
    text += construction.empty()
                ? fmt::format("No construction serves {}.\n", name(p))
                : fmt::format("The construction {} does not serve {}.\n", construction, name(p));
    text += fmt::format("  at least {}: {}\n", count_of(bound.blocks, "block"), bound.reason);
    if (!construction.empty()) {
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
  text.pop_back();
  return no_design(output, exit_code::missing_resource, text, json.take());
}

}  // namespace changeover::cli
