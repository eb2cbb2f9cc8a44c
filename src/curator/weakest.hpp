// The order in which cells of a catalog are searched: where a better design is worth most.
//
//     WeakestFirst cells(catalog, {.k_to = 6});
//     cells.begin_pass();
//     while (const auto p = cells.next()) {
//       ...                                      // a search for fewer than cells.known(*p) blocks
//       cells.improved(*p, b);                   // it found b: its neighbours are better, too
//     }
//
// A design with b blocks of one cell is the beginning of others with no more: read as linear, with elements that are in every block, with
// elements truncated, blown up. A cell is worth the share of its blocks that is over its bound, times the blocks that all cells gain
// if it comes down by one. Which of them truncation reaches is estimated, for that depends on the blocks.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "changeover/catalog/catalog.hpp"
#include "changeover/core/parameters.hpp"

namespace changeover {

class WeakestFirst {
 public:
  /// The cells that the filter lets through and whose best design has more blocks than its bound. Reads them and what they lead to.
  /// Fewer cells, and less of what they lead to, if the scope of this thread (run/control.hpp) wants to stop.
  WeakestFirst(const Catalog& catalog, CatalogFilter filter);

  /// All cells that still have something to gain are to be searched again.
  void begin_pass();

  /// The one that is worth most of those that next() did not name in this pass; nullopt if there is none.
  [[nodiscard]] std::optional<Parameters> next();

  /// Blocks of the best design that is known of a cell, or estimated after improved().
  [[nodiscard]] std::uint64_t known(const Parameters& p) const { return stands_.at(p).b; }

  /// A design with so many blocks is known from now on.
  void improved(const Parameters& p, std::uint64_t b);

 private:
  struct Stand {
    std::uint64_t b = 0;
    std::uint64_t lower_bound = 0;
  };
  using Stands = std::map<Parameters, Stand>;

  // The cells that have more than b blocks, and could have b, and come to b with p.
  [[nodiscard]] std::vector<Stands::iterator> reached_from(const Parameters& p, std::uint64_t b);
  [[nodiscard]] double worth(const Parameters& p);

  Stands stands_;
  std::vector<Parameters> cells_;
  std::priority_queue<std::pair<double, Parameters>> open_;
};

}  // namespace changeover
