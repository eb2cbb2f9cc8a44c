// How a design is made: a small tree of named constructions, data and not code.
//
// A recipe is deterministic: everyone who builds it gets the same blocks and can verify them again.
//
//     // The expansion of a cyclic design on 7 elements by 8 more:
//     Recipe cyclic{"cyclic-paper", {.v = 7, .k = 3, .kind = Kind::circular}, {{"c", 1}}, {}, {}};
//     const Parameters expanded{.v = 15, .k = 3, .kind = Kind::circular};
//     Recipe recipe{"expansion", expanded, {{"w", 8}}, {cyclic}, {}};
//
// The registry (construct/registry.hpp) turns it into blocks.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/parameters.hpp"

namespace changeover {

/// One construction with its arguments and the designs that it starts from.
struct Recipe {
  std::string construction;                       ///< name in the registry
  Parameters parameters;                          ///< of the design that it makes
  std::map<std::string, std::int64_t> arguments;  ///< whole numbers, by name
  std::vector<Recipe> inputs;                     ///< recipes of the designs that it works on
  std::vector<Block> blocks;  ///< of a literal recipe, or as its construction defines them
  std::string provenance =
      {};  ///< where a literal recipe's blocks come from, one line; may be empty

  bool operator==(const Recipe&) const = default;
};

}  // namespace changeover
