// How a design is made, as the tree of its constructions with their theorems; each node is built
// and verified unless that takes long.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "changeover/core/design.hpp"

namespace changeover::cli {

/// One construction of the tree.
struct RecipeStep {
  std::size_t depth = 0;  ///< how many constructions it stands within
  std::string design;     ///< "circular DCCD(231,13): 1155 blocks"
  std::string how;        ///< a sentence
  std::string citation;   ///< "[ChafeeStevens2025, Theorem 2]"
};

/// The outermost first. Nothing is verified.
[[nodiscard]] std::vector<RecipeStep> recipe_steps(const Recipe& recipe);

[[nodiscard]] std::string tree_text(const Recipe& recipe);

/// The tree with verdicts, as that document has it.
[[nodiscard]] std::string tree_json(const Recipe& recipe);

/// The document of `explain --json`: {"recipe":…,"tree":…}.
[[nodiscard]] std::string explanation_json(const Recipe& recipe);

}  // namespace changeover::cli
