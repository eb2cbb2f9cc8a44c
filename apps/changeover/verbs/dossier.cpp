// changeover dossier V K | LABEL: what a paper or its referee needs of one design.
#include "answer/dossier/dossier.hpp"
#include "answer/known/known_table.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/registry.hpp"
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
  const auto named = cells_or_entry(catalog, request.asked, request.what, request.k);
  if (!named) {
    return no_design(request.output, exit_code::missing_resource, has_no_design(request.what));
  }
  if (named->entry) {
    return of_entry(*named->entry, request.output);
  }
  const std::vector<Parameters>& cells = named->cells;
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
      "dossier",
      "write up one design for a paper: bounds, construction, blocks, picture, check, citations",
      run);
  request.asked.add_beside_label_to(verb, request.what, request.k);
  request.catalog.add_to(verb);
  request.output.add_to(verb, {"markdown", "latex", "html", "json"});
  verb.examples({"changeover dossier 61 4 -o dossier.tex",
                 "changeover dossier 26.4.2.circular.65 --format html -o dossier.html"});
}

}  // namespace changeover::cli
