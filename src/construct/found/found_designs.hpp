// The collection of designs that searches found, as files in src/construct/found:
//
//     # changeover design v=20 k=5 change=2 kind=linear
//     # provenance: changeover 0.2.0: search 20 5 --linear --seed 3 --time 60s
//     0 1 2 3 4
//     …
//
// The strength follows the kind if it is not 2, and in the file's name, as 20_5_2_linear.txt or 6_4_1_linear_3.txt.
// With a line "# developed: n=7 f=0 shift=1" the blocks are base blocks (entries/developed.cpp).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "changeover/core/recipe.hpp"

namespace changeover {

struct FoundDesign {
  Recipe recipe;        ///< literal, or developed
  std::uint64_t b = 0;  ///< number of blocks
};

/// A file of the collection.
struct FoundFile {
  std::string_view name;
  std::string_view text;
};

/// The files that were there when the library was built; generated.
[[nodiscard]] std::span<const FoundFile> found_design_files();

/// @throws InternalError that names file and line if one is malformed: they are part of the library.
[[nodiscard]] std::vector<FoundDesign> read_found_designs(std::span<const FoundFile> files);

}  // namespace changeover
