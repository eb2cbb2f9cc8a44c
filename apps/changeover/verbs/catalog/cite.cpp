// changeover catalog cite [LABEL|KEY]: BibTeX of a design, of a reference, or of the catalog as it
// is today.
#include "answer/answer.hpp"
#include "answer/catalog/entry_words.hpp"
#include "changeover/core/error.hpp"
#include "request/catalog_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct CiteRequest {
  std::string label;
  CatalogRequest catalog;
  OutputRequest output;
};

Answer run(const CiteRequest& request) {
  const Catalog& catalog = request.catalog.open();
  if (request.label.empty()) {
    return text_answer(bibtex_of(catalog), request.output);
  }
  if (const std::string reference = bibtex_of(request.label); !reference.empty()) {
    return text_answer(reference, request.output);
  }
  const auto cell = parse_cell_label(request.label);
  const auto entry = cell ? catalog.best(*cell) : catalog.find(request.label);
  if (!entry) {
    throw MissingResource(has_no_design(request.label) + left_out());
  }
  return text_answer(bibtex_of(*entry), request.output);
}

}  // namespace

void add_catalog_cite(Program& program) {
  auto [verb, request] = program.add<CiteRequest>(
      "catalog-cite", "write BibTeX of a design and its sources, or of the whole catalog", run);
  verb.positional("LABEL", request.label,
                  "label of a design or of a cell, whose best design is cited, or a key of "
                  "docs/references.bib (default: the whole catalog)",
                  false);
  request.catalog.add_to(verb);
  request.output.add_to(verb, {"bibtex"});
  verb.examples({"changeover catalog cite 26.4.2.circular.65",
                 "changeover catalog cite ChafeeStevens2025", "changeover catalog cite"});
}

}  // namespace changeover::cli
