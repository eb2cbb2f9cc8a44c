// Which design a request is about: ?v=&k=&change=&kind=, ?label=, ?file=N or ?job=N.
#pragma once

#include <string>
#include <vector>

#include "answer/design/chosen_design.hpp"
#include "serve/api/explorer.hpp"

namespace changeover::serve {

struct Selection {
  cli::ChosenDesign chosen;
  std::string label;  ///< in the catalog; empty if it has none
};

/// The names of parameters that select a design.
[[nodiscard]] std::vector<std::string> selectors();

/// @throws Refusal 400 unless exactly one way of selecting is used, 404 if there is no such design,
/// 413 if it has more than 200,000 blocks.
[[nodiscard]] Selection selected(Explorer& explorer, const Request& request);

/// The recipe of what is selected: by parameters or by label. @throws Refusal
[[nodiscard]] Recipe selected_recipe(Explorer& explorer, const Request& request);

/// The entry of the catalog with this label. @throws Refusal 404
[[nodiscard]] CatalogEntry entry_of(const Explorer& explorer, const std::string& label);

/// The design with its verdict in the format of files, and its label.
[[nodiscard]] std::string design_json(const Selection& selection);

/// Whether all of that takes milliseconds.
[[nodiscard]] bool is_quick(const Request& request);

}  // namespace changeover::serve
