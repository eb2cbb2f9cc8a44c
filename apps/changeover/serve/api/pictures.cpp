// Designs and tables as pictures.

#include "answer/known/known_table.hpp"
#include "changeover/core/error.hpp"
#include "changeover/draw/draw.hpp"
#include "changeover/io/input.hpp"
#include "request/picture_options.hpp"
#include "serve/api/cells.hpp"
#include "serve/api/request/query.hpp"
#include "serve/api/request/selection.hpp"
#include "serve/api/routes.hpp"
#include "serve/api/verify.hpp"

namespace changeover::serve {
namespace {

Theme theme_of(const Request& request) {
  return theme_from_string(word_of(request, "theme", {"light", "dark"})).value();
}

Response picture_response(const Picture& picture, Theme theme) {
  return text_response(svg(picture, theme), "image/svg+xml");
}

DrawOptions options_of(const Request& request) {
  const std::string picture =
      word_of(request, "picture", {"array", "stays", "coverage", "circle", "recipe"});
  for (const char* const option : {"order", "colour", "leaving", "from", "to"}) {
    const auto defect = cli::picture_option_defect(option, picture, "");
    if (request.parameter(option) && defect) {
      throw Refusal{400, *defect};
    }
  }
  DrawOptions options;
  options.picture = picture_kind_from_string(picture).value();
  options.order =
      element_order_from_string(word_of(request, "order", {"first", "stays", "given"})).value();
  options.colour =
      stay_colour_from_string(word_of(request, "colour", {"length", "ordinal"})).value();
  options.leaving = word_of(request, "leaving", {"no", "yes"}) == "yes";
  options.from = number_of(request, "from").value_or(1);
  options.to = number_of(request, "to");
  return options;
}

// A message about options of the program, with the names that they have here.
std::string of_parameters(std::string message) {
  for (std::size_t at = 0; (at = message.find("--", at)) != std::string::npos;) {
    message.erase(at, 2);
  }
  return message;
}

Response drawn(const Request& request, const Design& design, const DrawOptions& options) {
  if (const auto defect = range_defect(options)) {
    throw Refusal{400, of_parameters(*defect)};
  }
  if (const auto defect = draw_defect(design.parameters(), design.block_count(), options)) {
    throw Refusal{413, of_parameters(*defect)};
  }
  try {
    return picture_response(draw(design, options), theme_of(request));
  } catch (const BadInput& fault) {
    throw Refusal{400, of_parameters(fault.what())};
  }
}

Response drawn_selection(Explorer& explorer, const Request& request) {
  const DrawOptions asked = options_of(request);
  if (asked.picture == PictureKind::recipe && !request.parameter("file") &&
      !request.parameter("job")) {
    return picture_response(draw_recipe(selected_recipe(explorer, request)), theme_of(request));
  }
  const Selection selection = selected(explorer, request);
  const cli::ChosenDesign& chosen = selection.chosen;
  DrawOptions options = asked;
  options.name = selection.label;
  options.note = cli::quality(chosen.exhibit.judgement);
  Design design = read_all(*chosen.source);
  design.set_labels(chosen.exhibit.header.labels);
  design.recipe = chosen.exhibit.header.recipe;
  const Registry& registry = Registry::standard();
  if (const Construction* const made = registry.find(chosen.offer.recipe.construction)) {
    if (const auto set = made->expansion_set(chosen.offer.recipe, registry)) {
      options.expansion_set = *set;
    }
  }
  return drawn(request, design, options);
}

Response heatmap(Explorer& explorer, const Request& request) {
  const Kind kind = needed_kind(request);
  const HeatMeasure measure =
      heat_measure_from_string(word_of(request, "measure", {"ratio", "status", "gap"})).value();
  cli::TableRange range = table_range_of(request);
  range.kind = kind;
  const auto table = explorer.tables.of(range, explorer.generation());
  std::vector<KnownCell> cells;
  for (const KnownCell* const cell : table->cells(kind)) {
    cells.push_back(*cell);
  }
  return picture_response(draw_heatmap(cells, measure), theme_of(request));
}

}  // namespace

void add_pictures(Router& router, Explorer& explorer) {
  Route heat = question(explorer, "api/heatmap", {"v", "k", "change", "kind", "theme", "measure"},
                        Again::while_unchanged,
                        [&explorer](const Request& asked) { return heatmap(explorer, asked); });
  heat.lane = [](const Request& request) {
    return is_quick_table(request) ? Lane::quick : Lane::slow;
  };
  router.add(std::move(heat));

  const std::vector<std::string> ways{"picture", "order", "colour", "leaving",
                                      "theme",   "from",  "to"};
  Route route;
  route.path = "api/draw";
  route.parameters = selectors();
  route.parameters.insert(route.parameters.end(), ways.begin(), ways.end());
  route.lane = [](const Request& request) { return is_quick(request) ? Lane::quick : Lane::slow; };
  route.answer = [&explorer](const Request& request) {
    const Again again = request.parameter("job") ? Again::made_anew : Again::while_unchanged;
    return answered(explorer, request, again, [&] { return drawn_selection(explorer, request); });
  };
  router.add(std::move(route));

  // A design that is sent is drawn as it is, valid or not.
  std::vector<std::string> declared{"v", "k", "change", "kind", "strength"};
  declared.insert(declared.end(), ways.begin(), ways.end());
  router.add(posted(explorer, "api/draw", declared, Body::any, [](const Request& request) {
    return drawn(request, read_design(input_from_text(request.body), reading_of(request)),
                 options_of(request));
  }));
}

}  // namespace changeover::serve
