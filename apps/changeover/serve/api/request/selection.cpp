#include "serve/api/request/selection.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "answer/known/known_table.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/verify/verdict.hpp"
#include "core/printable.hpp"
#include "io/write/json_writer.hpp"
#include "serve/api/request/query.hpp"
#include "serve/jobs/search_jobs.hpp"

namespace changeover::serve {
namespace {

constexpr std::uint64_t most_blocks = 200'000;
constexpr std::size_t most_answer_bytes = 50'000'000;

void refuse_if_long(const Parameters& p, std::uint64_t b) {
  // A number is two bytes at least: what would be too long in the end is not built first.
  constexpr std::size_t bytes_of_a_number = 2;
  if (b > most_blocks || b > most_answer_bytes / bytes_of_a_number / p.k) {
    throw Refusal{
        413, fmt::format("{} has {} blocks, too many for a page; changeover design {} {} --change "
                         "{} --{}{} --format text -o FILE writes it",
                         name(p), b, p.v, p.k, p.change, to_string(p.kind),
                         p.strength == 2 ? "" : fmt::format(" --strength {}", p.strength))};
  }
}

// A design that is held in memory, as something that was chosen.
Selection held(const Explorer& explorer, const std::shared_ptr<const Design>& design) {
  struct Owned {
    std::shared_ptr<const Design> design;
    DesignSource source;
  };
  const Parameters& p = design->parameters();
  refuse_if_long(p, design->block_count());
  const auto owned = std::make_shared<Owned>(Owned{design, DesignSource(*design)});
  Selection selection;
  cli::ChosenDesign& chosen = selection.chosen;
  if (design->recipe) {
    chosen.offer.recipe = *design->recipe;
  }
  chosen.offer.recipe.parameters = p;
  chosen.offer.b = design->block_count();
  chosen.exhibit.header = {.labels = design->labels(), .recipe = design->recipe};
  chosen.exhibit.judgement = cli::judge(verify(*design));
  chosen.source = {owned, &owned->source};
  DesignSource blocks(*design);
  const std::string label = design_label(p, design->block_count(), design_digest(blocks).checksum);
  selection.label = explorer.catalog.find(label) ? label : "";
  return selection;
}

Offer offer_of(const std::vector<Parameters>& asked) {
  auto offer = cli::best_offer(asked, "");
  if (!offer) {
    std::string message;
    for (const Parameters& p : asked) {
      const auto reason = impossibility(p);
      message += (message.empty() ? "" : "; ") +
                 (reason ? fmt::format("no {} exists: {}", name(p), *reason)
                         : fmt::format("nothing is known that makes a {}", name(p)));
    }
    throw Refusal{404, message};
  }
  return *std::move(offer);
}

// By which of the ways it is selected. @throws Refusal 400 unless by one.
std::string way_of(const Request& request, const std::vector<std::string>& ways) {
  std::string found;
  for (const std::string& way : ways) {
    if (!request.parameter(way)) {
      continue;
    }
    if (!found.empty()) {
      throw Refusal{400,
                    fmt::format("{} and {} are two ways of naming a design; give one", found, way)};
    }
    found = way;
  }
  if (found.empty()) {
    throw Refusal{400, "name a design by v, k, change and kind, or by its label"};
  }
  for (const char* const name : {"k", "change", "kind", "strength"}) {
    if (found != "v" && request.parameter(name)) {
      throw Refusal{400, fmt::format("{} has no meaning with {}; leave it out", name, found)};
    }
  }
  return found;
}

}  // namespace

CatalogEntry entry_of(const Explorer& explorer, const std::string& label) {
  const auto entry = explorer.catalog.find(label);
  if (!entry) {
    throw Refusal{404, fmt::format("the catalog has no design {}; api/table gives the labels of "
                                   "the designs that it has",
                                   printable(label))};
  }
  return *entry;
}

std::vector<std::string> selectors() {
  return {"v", "k", "change", "kind", "strength", "label", "file", "job"};
}

Selection selected(Explorer& explorer, const Request& request) {
  const std::string way = way_of(request, {"v", "label", "file", "job"});
  if (way == "label") {
    const CatalogEntry entry = entry_of(explorer, *request.parameter("label"));
    refuse_if_long(entry.parameters, entry.b);
    return {cli::built(entry), entry.label()};
  }
  if (way == "file") {
    const std::uint64_t number = needed_number(request, "file");
    if (number < 1 || number > explorer.files.size()) {
      throw Refusal{404, fmt::format("there is no file {}; the server was given {}", number,
                                     explorer.files.size())};
    }
    const Design& design = explorer.files[number - 1].design;
    return held(explorer, {std::shared_ptr<void>(), &design});
  }
  if (way == "job") {
    return held(explorer, explorer.jobs->design_of(needed_number(request, "job")));
  }
  const Offer offer = offer_of(cells_of(request));
  refuse_if_long(offer.recipe.parameters, offer.b);
  return {cli::built(offer), label_of(offer)};
}

Recipe selected_recipe(Explorer& explorer, const Request& request) {
  return way_of(request, {"v", "label"}) == "label"
             ? entry_of(explorer, *request.parameter("label")).recipe
             : offer_of(cells_of(request)).recipe;
}

std::string design_json(const Selection& selection) {
  StringSink sink;
  cli::write_design(*selection.chosen.source, selection.chosen.exhibit, "json", sink);
  std::string text = sink.take();
  if (text.size() > most_answer_bytes) {
    throw Refusal{413, fmt::format("the design takes {} bytes, too many for a page; changeover "
                                   "design --format text -o FILE writes it",
                                   text.size())};
  }
  // One more key of the object.
  text.erase(text.find_last_of('}'));
  text += ",\"label\":";
  if (selection.label.empty()) {
    text += "null";
  } else {
    append_json_string(text, selection.label);
  }
  return text + "}\n";
}

bool is_quick(const Request& request) {
  constexpr std::uint64_t quick_v = 60;
  if (request.parameter("label")) {
    return true;
  }
  if (!request.parameter("v")) {
    return false;
  }
  try {
    return std::ranges::all_of(
        cells_of(request), [](const Parameters& p) { return is_stored_cell(p) || p.v <= quick_v; });
  } catch (const ImpossibleParameters&) {
    return true;  // It is soon said.
  }
}

}  // namespace changeover::serve
