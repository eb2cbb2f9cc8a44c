// changeover catalog completeness: how much is known, by change number, kind and block size.
#include <fmt/format.h>

#include "answer/answer.hpp"
#include "answer/catalog/entry_words.hpp"
#include "request/catalog_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct CompletenessRequest {
  FilterRequest filter;
  CatalogRequest catalog;
  OutputRequest output;
};

std::string text_of(const Completeness& found) {
  std::string text;
  for (const auto& [key, tally] : found) {
    const auto& [strength, change, kind, k] = key;
    text += fmt::format(
        "t = {}, m = {}, {:<8}  k = {:<3} v = {:>3}..{:<4} {:>5} {:<6} {:>5} proved minimum "
        "({:>3.0f} %), mean of b / bound {:.4f}\n",
        strength, change, to_string(kind), k, tally.v_from, tally.v_to, tally.cells,
        tally.cells == 1 ? "cell," : "cells,", tally.minimum,
        100.0 * static_cast<double>(tally.minimum) / static_cast<double>(tally.cells),
        tally.mean_ratio());
  }
  return text;
}

Answer run(const CompletenessRequest& request) {
  const Completeness found = completeness(request.catalog.open(), request.filter.filter());
  return text_answer(request.output.json() ? completeness_json(found) + "\n" : text_of(found),
                     request.output);
}

}  // namespace

void add_catalog_completeness(Program& program) {
  auto [verb, request] = program.add<CompletenessRequest>(
      "catalog-completeness", "count cells that are filled and proved minimum, by block size", run);
  request.filter.add_to(verb);
  request.catalog.add_to(verb);
  request.output.add_to(verb, {"text", "json"});
  verb.examples({"changeover catalog completeness --change 1 --linear --v ..60"});
}

}  // namespace changeover::cli
