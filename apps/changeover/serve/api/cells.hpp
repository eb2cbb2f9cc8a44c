// What is known of cells, as JSON.
#pragma once

#include <string>

#include "answer/known/known_table.hpp"
#include "changeover/catalog/catalog.hpp"
#include "serve/http/message.hpp"

namespace changeover::serve {

/// ?k=A..B&v=C..D&change=M. @throws Refusal 400, 413
[[nodiscard]] cli::TableRange table_range_of(const Request& request);

/// Whether such a table takes milliseconds. @throws Refusal
[[nodiscard]] bool is_quick_table(const Request& request);

/// Bounds, the best design, what the catalog has, what constructions offer, how the cell became better.
[[nodiscard]] std::string cell_json(const Catalog& catalog, const Parameters& p);

}  // namespace changeover::serve
