// Searches where the catalog is weakest, and what of the user's is better than what comes with the program.
//
//     RunControl control({.time = std::chrono::seconds(2)});
//     const auto finds = improve_catalog(catalog, {.v_to = 9, .k_to = 4}, control);
//     const Submission submission = write_submission(catalog, sink);   // lines for those who keep the catalog
//
// Every find is verified and in the user's file before the next cell is looked at: whatever ends the search, no more is lost than what is
// under way.
//
// Bound by: the local search (search/local_search.hpp); a cell costs up to a second before its first move, in which the closure rules
// look for its best recipe.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "changeover/catalog/catalog.hpp"
#include "changeover/curator/add.hpp"
#include "changeover/io/output.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

struct CatalogSearch {
  /// For a cell in the first pass over all of them, twice as long in each pass after it; nothing: a fiftieth of the time that is left, but
  /// 1 to 60 s.
  std::optional<std::chrono::duration<double>> each = {};
  Introduction introduction = {};  ///< of what is found; program and command are filled in
};

/// A cell that became better.
struct CatalogFind {
  std::string label;
  Parameters parameters;
  std::uint64_t before = 0;
  std::uint64_t b = 0;
  std::string how;  ///< one line
};

/// Looks for better designs of the cells that the filter lets through and whose best is above its bound, again and again until the
/// control says stop: those whose gap is largest against their number of blocks first, of equal ones the smaller, whose designs are the
/// beginning of more others. Calls found() for each find once it is in the user's file. @throws as Catalog::add(); BadInput as newcomer_of().
[[nodiscard]] std::vector<CatalogFind> improve_catalog(
    Catalog& catalog, const CatalogFilter& filter, RunControl& control,
    const CatalogSearch& search = {}, const std::function<void(const CatalogFind&)>& found = {});

/// What the user has that is better than all that comes with the program, the best of each cell.
struct Submission {
  std::vector<std::string> labels;    ///< of the entries, in order
  std::vector<std::string> left_out;  ///< not as they say: label and why, a line each
};

/// Writes it as write_entries() does, each entry built and verified before. An entry is better if it has fewer blocks than
/// any of its cell that comes with the program and than a construction that needs no catalog. @throws as Sink::write().
[[nodiscard]] Submission write_submission(const Catalog& catalog, Sink& sink);

}  // namespace changeover
