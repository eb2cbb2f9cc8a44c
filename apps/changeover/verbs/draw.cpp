// changeover draw WHAT: pictures of designs, recipes and tables.
#include "changeover/draw/draw.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "answer/answer.hpp"
#include "answer/converter.hpp"
#include "answer/design/chosen_design.hpp"
#include "answer/design/judgement.hpp"
#include "answer/known/known_table.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/construct/expansion.hpp"
#include "changeover/construct/one_factorization.hpp"
#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "core/words.hpp"
#include "request/catalog_request.hpp"
#include "request/output.hpp"
#include "request/parameters.hpp"
#include "request/picture_options.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct DrawRequest {
  std::string what;
  std::string second;
  std::string picture = "array";
  ParameterRequest asked;  // without V and K: `what` may be a file or a label
  CatalogRequest catalog;
  std::string order = "first";
  std::string colour = "length";
  std::string theme = "light";
  std::string measure = "ratio";
  std::string k;
  std::string v;
  bool leaving = false;
  bool expansion_sets = false;
  std::optional<std::uint64_t> from;
  std::optional<std::uint64_t> to;
  OutputRequest output;
};

// PNG is enlarged, so that it is sharp on paper too, as far as that stays in reason.
unsigned zoom_of(const Picture& picture, const std::string& format) {
  constexpr double most_pixels = 8000;
  return format == "png" && 2 * std::max(picture.width, picture.height) <= most_pixels ? 2 : 1;
}

Answer answer_of(const Picture& picture, const DrawRequest& request) {
  const std::string format = request.output.format();
  const Theme theme = theme_from_string(request.theme).value();
  if (format == "tikz") {
    if (const std::size_t marks = mark_count(picture); marks > most_marks_of_tikz) {
      throw UsageError{fmt::format(
          "--format tikz: {} marks are too many for TeX, which takes {}; draw a part with --from "
          "and --to, or write svg",
          marks, most_marks_of_tikz)};
    }
    return text_answer(tikz(picture, theme), request.output);
  }
  std::string page = svg(picture, theme);
  if (format != "svg") {
    page = converted(page, format, zoom_of(picture, format));
  }
  return text_answer(std::move(page), request.output);
}

DrawOptions options_of(const DrawRequest& request) {
  DrawOptions options;
  options.picture = picture_kind_from_string(request.picture).value();
  options.order = element_order_from_string(request.order).value();
  options.colour = stay_colour_from_string(request.colour).value();
  options.leaving = request.leaving;
  options.from = request.from.value_or(1);
  options.to = request.to;
  return options;
}

void require_fits(const Parameters& p, std::uint64_t b, const DrawOptions& options) {
  if (const auto defect = draw_defect(p, b, options)) {
    throw UsageError{*defect};
  }
}

// An expansion set of the design, which is read and rewound; the note says so if there is none.
void add_expansion_set(DrawOptions& options, BlockSource& source) {
  constexpr std::uint64_t most_nodes = 2'000'000;
  const Design design = read_all(source);
  static_cast<void>(source.rewind());
  ExpansionSearchOptions search;
  search.limits.nodes = most_nodes;
  const ExpansionSearch found = find_expansion_sets(design, search);
  if (!found.sets.empty()) {
    options.expansion_set = found.sets.front();
  } else {
    options.note += found.complete ? "; it has no expansion set" : "; no expansion set was found";
  }
}

// A design that was verified, or one of a stranger with its verdict.
struct Subject {
  std::shared_ptr<BlockSource> source;
  std::vector<std::string> labels;
  std::optional<Recipe> recipe;
};

Answer drawn(const Subject& subject, DrawOptions options, const DrawRequest& request) {
  if (options.picture == PictureKind::recipe) {
    if (!subject.recipe) {
      throw BadInput(fmt::format(
          "{}: it does not say how it was made, so there is no recipe to draw; draw another "
          "picture",
          request.what));
    }
    return answer_of(draw_recipe(*subject.recipe, Registry::standard(), options.note), request);
  }
  if (request.expansion_sets && options.expansion_set.empty()) {
    add_expansion_set(options, *subject.source);
  }
  return answer_of(draw(*subject.source, options, subject.labels), request);
}

// What the registry makes of a promise, judged.
Answer draw_promised(const Offer& promise, DrawOptions options, const DrawRequest& request,
                     bool named) {
  const Registry& registry = Registry::standard();
  require_fits(promise.recipe.parameters, promise.b, options);
  const Construction& construction = registry.construction_of(promise.recipe);
  Subject subject{.source = registry.build(promise.recipe), .labels = {}, .recipe = promise.recipe};
  if (const auto at_once = judge_at_once(*subject.source, promise)) {
    options.note = quality(*at_once);
  } else if (takes_long_to_judge(*subject.source, promise)) {
    options.note = not_verified_here(promise.recipe.parameters);
  } else {
    options.note = quality(judge(*subject.source, promise));
  }
  if (!named) {
    subject.labels = construction.labels(promise.recipe, registry);
  }
  if (request.expansion_sets) {
    if (const auto set = construction.expansion_set(promise.recipe, registry)) {
      options.expansion_set = *set;
    }
  }
  return drawn(subject, std::move(options), request);
}

Answer draw_cell(const std::vector<Parameters>& asked, const DrawRequest& request) {
  const auto offer = best_offer(asked, "");
  if (!offer) {
    return decline(asked, "", request.output);
  }
  return draw_promised(*offer, options_of(request), request, false);
}

Answer draw_entry(const CatalogEntry& entry, const DrawRequest& request) {
  check_published_blocks(entry);
  DrawOptions options = options_of(request);
  options.name = entry.label();
  Offer promise;
  promise.recipe = entry.recipe;
  promise.b = entry.b;
  // Elements by their numbers, as the checksum has them.
  return draw_promised(promise, std::move(options), request, true);
}

std::string verdict_of(const Verdict& verdict) {
  if (verdict.valid()) {
    return "valid, " + quality(judge(verdict));
  }
  std::string defects;
  const auto add = [&](std::uint64_t number, const std::string& what) {
    if (number > 0) {
      defects += (defects.empty() ? "" : ", ") + count_of(number, what);
    }
  };
  add(verdict.bad_steps, "wrong step");
  add(verdict.uncovered, verdict.parameters.strength == 2 ? "uncovered pair" : "uncovered subset");
  return "INVALID: " + (defects.empty() ? "no blocks" : defects);
}

Answer draw_file(const DrawRequest& request) {
  check_inputs(request.output, {{"the design", request.what}});
  const auto design = std::make_shared<Design>(read_design(request.what, request.asked.reading()));
  DrawOptions options = options_of(request);
  require_fits(design->parameters(), design->block_count(), options);
  struct Owned {
    std::shared_ptr<Design> design;
    DesignSource source;
  };
  const auto owned = std::make_shared<Owned>(Owned{design, DesignSource(*design)});
  options.name =
      fmt::format("{}: {}, {}",
                  request.what == "-" ? "standard input"
                                      : std::filesystem::path(request.what).filename().string(),
                  name(design->parameters()), count_of(design->block_count(), "block"));
  options.note = verdict_of(verify(*design));
  return drawn({{owned, &owned->source}, design->labels(), design->recipe}, std::move(options),
               request);
}

Answer draw_factorization(const DrawRequest& request) {
  constexpr std::uint64_t most_drawn = 40;
  const auto order = whole_number(request.what);
  if (!order) {
    throw UsageError{fmt::format("N: '{}' is not a whole number", request.what)};
  }
  if (!request.second.empty()) {
    throw UsageError{
        "a 1-factorization has one number, N; write changeover draw 8 --picture factorization"};
  }
  if (*order > most_drawn) {
    throw UsageError{fmt::format(
        "only 1-factorizations of K_2 to K_{} are drawn; give a smaller number", most_drawn)};
  }
  const OneFactorization factorization = one_factorization(static_cast<std::uint32_t>(*order));
  if (const auto defect = factorization_defect(factorization)) {
    throw InternalError("the 1-factorization is not one: " + *defect);
  }
  const std::uint32_t last = factorization.order - 1;
  return answer_of(
      draw_factors(factor_figure(factorization, last > 1 ? std::optional(last) : std::nullopt)),
      request);
}

Answer draw_table(const DrawRequest& request) {
  if (!request.what.empty()) {
    throw UsageError{
        "a heat map is of a range; write --picture heatmap --k A..B --v C..D, without FILE or V K"};
  }
  TableRange range = table_range(request.k.empty() ? "3..8" : request.k,
                                 request.v.empty() ? "..40" : request.v, request.asked.change);
  const std::uint64_t rows = range.k.to - range.k.from + 1;
  const std::uint64_t columns = range.v.to - range.v.from + 1;
  if (rows * columns > most_cells_of_a_heatmap) {
    throw UsageError{fmt::format(
        "a heat map of {} cells has too many, {} is the most; give fewer with --k and --v",
        rows * columns, most_cells_of_a_heatmap)};
  }
  const Kind kind = request.asked.kind.value_or(Kind::linear);
  range.kind = kind;
  const KnownTable table = known_table(range);
  std::vector<KnownCell> cells;
  for (const KnownCell* cell : table.cells(kind)) {
    cells.push_back(*cell);
  }
  return answer_of(draw_heatmap(cells, heat_measure_from_string(request.measure).value()), request);
}

Answer run(const DrawRequest& request) {
  if (request.picture == "heatmap") {
    return draw_table(request);
  }
  if (request.what.empty()) {
    throw UsageError{"name a file, a label of the catalog, or V and K"};
  }
  if (request.picture == "factorization") {
    return draw_factorization(request);
  }
  if (!request.second.empty()) {
    return draw_cell(request.asked.of_each_kind(request.what, request.second), request);
  }
  std::error_code ignored;
  if (request.what == "-" || std::filesystem::exists(request.what, ignored)) {
    return draw_file(request);
  }
  request.asked.refuse_beside_label(request.what);
  if (const auto cell = parse_cell_label(request.what)) {
    return draw_cell({*cell}, request);
  }
  if (const auto entry = request.catalog.open().find(request.what)) {
    return draw_entry(*entry, request);
  }
  if (whole_number(request.what)) {
    throw UsageError{fmt::format("{}: there is no such file; V needs K: changeover draw {} K",
                                 request.what, request.what)};
  }
  throw MissingResource(fmt::format(
      "{}: there is no such file, and the catalog has no such label; check how it is spelt{}",
      request.what, left_out()));
}

// Options that some pictures alone have.
void require_meaning(const DrawRequest& request) {
  const auto only = [&](bool given, std::string_view option) {
    if (const auto defect = picture_option_defect(option, request.picture, "--"); given && defect) {
      throw UsageError{*defect};
    }
  };
  only(request.from.has_value(), "from");
  only(request.to.has_value(), "to");
  only(request.order != "first", "order");
  only(request.colour != "length", "colour");
  only(request.leaving, "leaving");
  only(request.expansion_sets, "expansion-sets");
  only(request.measure != "ratio", "measure");
  only(!request.k.empty(), "k");
  only(!request.v.empty(), "v");
}

}  // namespace

void add_draw(Program& program) {
  auto [verb, request] =
      program.add<DrawRequest>("draw", "draw a design, a recipe or a table", run);
  verb.positional(
      "FILE", request.what,
      "a design in any format that verify reads, - is standard input; or a label of the catalog; "
      "or V",
      false);
  verb.positional("K", request.second, "elements in a block, after V", false);
  verb.choice("-p,--picture", request.picture,
              {"array", "stays", "circle", "coverage", "recipe", "factorization", "heatmap"},
              "what is drawn (default array)");
  verb.option("-m,--change", request.asked.change, "M",
              "elements in which consecutive blocks differ (default 2, or as the file says)");
  request.asked.add_strength_to(verb);
  add_kind_to(verb, request.asked.kind, "the last and the first block are consecutive too",
              std::string("they need not be (") + better_kind + ")");
  verb.option("--from", request.from, "N", "the first block that is drawn, from 1");
  verb.option("--to", request.to, "N", "the last one");
  verb.choice("--order", request.order, {"first", "stays", "given"},
              "sort elements by first block, by number of stays, or as numbered (default first)");
  verb.choice("--colour", request.colour, {"length", "ordinal"},
              "colour stays by length, or by their number within the element (default length)");
  verb.flag("--leaving", request.leaving, "array: mark leaving elements too");
  verb.flag("--expansion-sets", request.expansion_sets, "array: mark an expansion set");
  verb.option("--k", request.k, "A..B", "heatmap: block sizes (default 3..8)");
  verb.option("--v", request.v, "C..D", "heatmap: numbers of elements (default ..40)");
  verb.choice(
      "--measure", request.measure, {"ratio", "status", "gap"},
      "heatmap: blocks over the lower bound, status, or blocks more than it (default ratio)");
  verb.choice("--theme", request.theme, {"light", "dark"}, "background (default light)");
  request.catalog.add_to(verb);
  request.output.add_to(verb, {"svg", "tikz", "pdf", "png"});
  verb.require([&asked = request] { require_meaning(asked); });
  verb.examples({"changeover draw mine.json -o mine.svg             blocks as columns",
                 "changeover draw 20 5 --picture stays -o stays.pdf",
                 "changeover draw 61.4.2.circular --picture circle -o circle.tex",
                 "changeover draw --picture heatmap --k 3..12 --v 5..60 --linear -o map.png"});
}

}  // namespace changeover::cli
