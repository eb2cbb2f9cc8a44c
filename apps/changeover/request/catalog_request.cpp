#include "request/catalog_request.hpp"

#include <fmt/format.h>

#include "catalog/entry/day.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/registry.hpp"
#include "core/printable.hpp"
#include "request/parameters.hpp"

namespace changeover::cli {

void CatalogRequest::add_to(Verb& verb) {
  verb.option("--catalog", path, "FILE",
              "the user's designs (default $CHANGEOVER_CATALOG, or changeover/catalog.db in "
              "$XDG_DATA_HOME)");
}

Catalog& CatalogRequest::open() const {
  if (!path.empty()) {
    choose_catalog(path);
  }
  return standard_catalog();
}

Catalog& CatalogRequest::open_to_change(const OutputRequest& output) const {
  output.check_writable();
  return open();
}

std::string has_no_design(const std::string& label) {
  return fmt::format("the catalog has no design {}; changeover catalog list shows what it has",
                     printable(label));
}

std::optional<CellsOrEntry> cells_or_entry(const Catalog& catalog, const ParameterRequest& asked,
                                           const std::string& what, const std::string& k) {
  if (!k.empty()) {
    return CellsOrEntry{asked.of_each_kind(what, k), {}};
  }
  if (what.find_first_not_of(' ') == std::string::npos) {
    throw UsageError{"name a label of the catalog, or V and K"};
  }
  if (const auto cell = parse_cell_label(what)) {
    return CellsOrEntry{{*cell}, {}};
  }
  if (const auto entry = catalog.find(what)) {
    return CellsOrEntry{{}, *entry};
  }
  if (whole_number(what)) {
    return CellsOrEntry{asked.of_each_kind(what, ""), {}};
  }
  return std::nullopt;
}

std::string left_out() {
  const std::string problem = standard_catalog_problem();
  const std::string remark = standard_catalog_remark();
  return (problem.empty() ? "" : "; your own catalog was left out: " + problem) +
         (remark.empty() ? "" : "; " + remark);
}

void FilterRequest::add_to(Verb& verb, Unless unless) {
  verb.option("--k", k, "A..B", "block sizes");
  verb.option("--v", v, "C..D", "numbers of elements");
  verb.option("-m,--change", change, "M", "elements in which consecutive blocks differ");
  verb.option("-t,--strength", strength, "T", "every T elements meet");
  add_kind_to(verb, kind, "circular designs only", "linear designs only");
  verb.choice("--status", status, {"minimum", "best-known", "retracted"},
              "only designs of this status");
  verb.option("--gap", gap, "N", "only designs with N or more blocks over the lower bound");
  verb.option("--construction", construction, "NAME", "only designs that this construction made");
  verb.option("--since", since, "DATE", "only designs credited on DATE or later, e.g. 2026-11-22");
  if (unless == Unless::all_is_not_asked_for) {
    verb.flag("--all", all, "all designs of each cell, not only the best");
  } else {
    all = true;
    verb.flag(
        "--best", [this] { all = false; }, "only the best design of each cell");
  }
  verb.flag("--users", users, "the user's designs only");
}

CatalogFilter FilterRequest::filter() const {
  CatalogFilter filter;
  if (!k.empty()) {
    const Range range = range_of("--k", k, 1);
    filter.k_from = range.from;
    filter.k_to = range.to;
  }
  if (!v.empty()) {
    const Range range = range_of("--v", v, 1);
    filter.v_from = range.from;
    filter.v_to = range.to;
  }
  if (!since.empty() && !is_day(since)) {
    throw UsageError{"--since: '" + since + "' is not a day; write it as 2026-11-22"};
  }
  filter.change = change;
  if (strength) {
    filter.strength = strength_of(strength);
  }
  filter.kind = kind;
  filter.status = status;
  filter.gap = gap;
  filter.construction = construction;
  filter.since = since;
  filter.best_only = !all;
  filter.users_only = users;
  return filter;
}

}  // namespace changeover::cli
