// changeover catalog cite [LABEL]: BibTeX of a design, or of the catalog as it is today.
#include <fmt/format.h>

#include "answer/answer.hpp"
#include "answer/entry_words.hpp"
#include "changeover/construct/standard_catalog.hpp"
#include "changeover/core/version.hpp"
#include "request/catalog_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct CiteRequest {
  std::string label;
  CatalogRequest catalog;
  OutputRequest output;
};

std::string misc(const std::string& key, const std::string& author, const std::string& title,
                 const std::string& date, const std::string& note) {
  std::string text = fmt::format("@misc{{{},\n", key);
  if (!author.empty()) {
    text += fmt::format("  author = {{{{{}}}}},\n", author);  // one name, whatever is in it
  }
  text += fmt::format("  title  = {{{}}},\n", title);
  if (!date.empty()) {
    text += fmt::format("  year   = {{{}}},\n", date.substr(0, 4));
  }
  return text + fmt::format("  note   = {{{}}}\n}}\n", note);
}

Answer run(const CiteRequest& request) {
  const Catalog& catalog = request.catalog.open();
  const std::string program = fmt::format("Changeover {}", version);
  if (request.label.empty()) {
    Sha256 hash;
    std::uint64_t count = 0;
    std::string latest;
    catalog.each({.best_only = false}, [&](const CatalogEntry& entry) {
      if (catalog.is_shipped(entry.label())) {
        ++count;
        latest = std::max(latest, entry.credit.date);
        hash.add(entry.checksum);
      }
      return true;
    });
    return text_answer(misc("changeover-catalog-" + latest, "The Changeover developers",
                            "A catalog of change covering designs", latest,
                            fmt::format("{}; {} designs as of {}; SHA-256 of their checksums {}",
                                        program, count, latest, to_hex(hash.finish()))),
                       request.output);
  }
  const auto entry = catalog.find(request.label);
  if (!entry) {
    throw MissingResource(fmt::format("the catalog has no design {}", request.label));
  }
  std::string text = misc(
      "changeover-" + entry->label(), entry->credit.who,
      fmt::format("{} with {} blocks", name(entry->parameters), entry->b), entry->credit.date,
      fmt::format("{}, catalog label {}, SHA-256 of the blocks {}{}{}", program, entry->label(),
                  to_hex(entry->checksum), entry->note.empty() ? "" : "; ", entry->note));
  for (const std::string& key : references_of(*entry)) {
    const std::string reference = bibtex_of(key);
    text +=
        "\n" + (reference.empty() ? "% " + key + " is not in docs/references.bib\n" : reference);
  }
  return text_answer(text, request.output);
}

}  // namespace

void add_catalog_cite(Program& program) {
  auto [verb, request] = program.add(
      "catalog-cite", "BibTeX of a design and what it is from, or of the whole catalog", run);
  verb.positional("LABEL", request.label, "of a design; the whole catalog without it", false);
  request.catalog.add_to(verb);
  request.output.add_to(verb, {"bibtex"});
  verb.examples({"changeover catalog cite 26.4.2.circular.65", "changeover catalog cite"});
}

}  // namespace changeover::cli
