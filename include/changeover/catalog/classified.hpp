// The number of all designs with given parameters, up to names of elements, where exhaustive search
// has counted them.
//
//     const auto all = classified({.v = 9, .k = 4, .change = 1, .kind = Kind::circular}, 12);
//     all->classes;                    // 2 [McSorley1999]
//     all->groups;                     // "1:1 3:1"
//
// The counts are those of classify_designs() (search/enumeration.hpp), for designs with as few
// blocks as possible; that takes up to some seconds for each, here they are stored. Linear in the
// number of counts.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "changeover/core/parameters.hpp"

namespace changeover {

/// The counts for a number of blocks.
struct Classified {
  Parameters parameters;
  std::uint64_t b = 0;
  std::uint64_t standard_forms = 0;  ///< up to names of elements
  std::uint64_t classes = 0;         ///< up to rotation too, if circular
  std::uint64_t tight = 0;           ///< of the classes
  std::string_view groups = {};      ///< the number of classes for each order of a group
};

/// The count for exactly these parameters and blocks; nullopt if there is none.
[[nodiscard]] std::optional<Classified> classified(const Parameters& p, std::uint64_t b);

/// All counts.
[[nodiscard]] std::span<const Classified> classified_cells();

}  // namespace changeover
