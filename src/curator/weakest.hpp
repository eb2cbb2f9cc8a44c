// The order in which cells of a catalog are searched: where a better design is worth most.
//
//     WeakestFirst cells(catalog, {.k_to = 6});
//     cells.begin_pass();
//     while (const auto p = cells.next()) {
//       ...                                      // a search for fewer than cells.known(*p) blocks
//       cells.improved(*p, b);                   // it found b: its neighbours improve, too
//     }
//
// A design with b blocks of one cell gives designs of others with no more blocks: read as linear,
// with elements added to every block, truncated, blown up. A cell is worth the share of its blocks
// above its bound, times the blocks that all cells gain if it loses one. The gain by truncation
// depends on the blocks and is estimated.
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
  /// Reads the cells that the filter lets through and whose best design has more blocks than its
  /// bound, and the cells that they lead to. Reads fewer of both if the scope of this thread
  /// (run/control.hpp) wants to stop.
  WeakestFirst(const Catalog& catalog, CatalogFilter filter);

  /// Starts a new pass over all cells that can still gain.
  void begin_pass();

  /// The cell that is worth most among those that next() did not return in this pass; nullopt if
  /// there is none.
  [[nodiscard]] std::optional<Parameters> next();

  /// Blocks of the best known design of a cell, or an estimate after improved().
  [[nodiscard]] std::uint64_t known(const Parameters& p) const { return stands_.at(p).b; }

  /// Records that a design with so many blocks is known from now on.
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
