// What the literature reports: numbers of blocks of designs that are said to exist.
//
//     const Parameters p{.v = 26, .k = 6, .change = 1, .kind = Kind::linear};
//     reported_below(p, 64)->blocks;                // 63 [Bean2026]
//     reported_below(p, 63).has_value();            // false: it is no better than what is held
//
// Reported is not verified. A catalog holds blocks, which are verified; here is a number and who
// says it, for the caller who asks what is known of some parameters. It is no bound, and no other
// answer depends on it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "changeover/core/parameters.hpp"

namespace changeover {

/// A design that a publication counts.
struct Reported {
  std::string_view cites;  ///< a key of docs/references.bib
  Parameters parameters;
  std::uint64_t blocks = 0;
};

/// All of them.
[[nodiscard]] std::span<const Reported> reported_designs();

/// The one with the fewest blocks for exactly these parameters, if that is fewer than `held`, the
/// number of blocks of the best design at hand; nullopt otherwise. Linear in the number of reports.
[[nodiscard]] std::optional<Reported> reported_below(const Parameters& p,
                                                     std::optional<std::uint64_t> held);

}  // namespace changeover
