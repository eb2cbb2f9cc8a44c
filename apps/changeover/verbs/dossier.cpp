// changeover dossier V K | LABEL: what a paper or its referee needs of one design.
#include "answer/dossier/dossier.hpp"
#include "answer/known/known_table.hpp"
#include "answer/known/offers.hpp"
#include "changeover/construct/standard_catalog.hpp"
#include "changeover/core/error.hpp"
#include "request/catalog_request.hpp"
#include "request/parameters.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct DossierRequest {
  std::string what;
  std::string k;
  ParameterRequest asked;  // without V and K: `what` may be a label
  CatalogRequest catalog;
  OutputRequest output;
};

Answer written(const Dossier& dossier, const OutputRequest& output) {
  const std::string format = output.format();
  return text_answer(format == "latex"  ? dossier_latex(dossier)
                     : format == "html" ? dossier_html(dossier)
                     : format == "json" ? dossier_json(dossier) + "\n"
                                        : dossier_markdown(dossier),
                     output);
}

Answer of_entry(const CatalogEntry& entry, const OutputRequest& output) {
  return written(dossier_of(built(entry), entry), output);
}

Answer run(const DossierRequest& request) {
  const Catalog& catalog = request.catalog.open();
  std::vector<Parameters> cells;
  if (!request.k.empty()) {
    cells = request.asked.of_each_kind(request.what, request.k);
  } else if (const auto cell = parse_cell_label(request.what)) {
    cells = {*cell};
  } else if (const auto entry = catalog.find(request.what)) {
    return of_entry(*entry, request.output);
  } else if (whole_number(request.what)) {
    cells = request.asked.of_each_kind(request.what, "");
  } else {
    return no_design(request.output, exit_code::missing_resource, has_no_design(request.what));
  }
  const auto offer = best_offer(cells, "");
  if (!offer) {
    return decline(cells, "", request.output);
  }
  const std::string label = label_of(*offer);
  if (const auto entry = label.empty() ? std::nullopt : catalog.find(label)) {
    return of_entry(*entry, request.output);
  }
  return written(dossier_of(built(*offer), std::nullopt), request.output);
}

}  // namespace

void add_dossier(Program& program) {
  auto [verb, request] = program.add<DossierRequest>(
      "dossier", "one design for a paper: bounds, construction, blocks, picture, check, citations",
      run);
  request.asked.add_beside_label_to(verb, request.what, request.k);
  request.catalog.add_to(verb);
  request.output.add_to(verb, {"markdown", "latex", "html", "json"});
  verb.examples({"changeover dossier 61 4 -o dossier.tex",
                 "changeover dossier 26.4.2.circular.65 --format html -o dossier.html"});
}

}  // namespace changeover::cli
