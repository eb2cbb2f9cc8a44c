// How a design is made, as the tree of its constructions with their theorems; each node is built and verified
// unless that takes long.
#pragma once

#include <string>

#include "changeover/core/recipe.hpp"

namespace changeover::cli {

[[nodiscard]] std::string tree_text(const Recipe& recipe);

/// The document of `explain --json`: {"recipe":…,"tree":…}.
[[nodiscard]] std::string explanation_json(const Recipe& recipe);

}  // namespace changeover::cli
