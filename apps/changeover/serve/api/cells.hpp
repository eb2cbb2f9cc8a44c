// What is known of cells, as JSON.
#pragma once

#include <cstdint>
#include <string>

#include "answer/known/known_table.hpp"
#include "changeover/catalog/catalog.hpp"
#include "serve/http/message.hpp"

namespace changeover::serve {

/// ?k=A..B&v=C..D&change=M; what is not named is as in `usual`, v from k on if that has none.
/// @throws Refusal 400, 413
[[nodiscard]] cli::TableRange table_range_of(const Request& request,
                                             const cli::TableRange& usual = {.k = {3, 8},
                                                                             .v = {0, 40}});

/// Whether such a table takes milliseconds. @throws Refusal
[[nodiscard]] bool is_quick_table(const Request& request);

/// Bounds, the best design, what the catalog has, what constructions offer, how the cell became
/// better.
enum class CellWords : std::uint8_t {
  all,
  fewest  ///< no recipes of offers, and of designs not what the cell says already
};
[[nodiscard]] std::string cell_json(const Catalog& catalog, const Parameters& p,
                                    CellWords words = CellWords::all);

}  // namespace changeover::serve
