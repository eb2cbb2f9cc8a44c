// Tables of what is different near the multiples of K in a list of windows over Z_u, K = k−1, where
// visitors stay while the window moves ("chains"): chained_three_windows.cpp,
// cyclic/chained_visits.cpp.
//
//     const Leg leg{{1, -1}, {{3, 0}, {{1, -1}, {3, -1}}}, Place{3, -1}};
//
// says: at window K−1 the element 3K enters in place of the one that entered before, then 3K−1 in
// place of K−1; and 3K−1 leaves for the first that enters at window K.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "construct/tools/swaps.hpp"

namespace changeover::chains {

/// The element or the window windows·K + by, counted from where the table says.
struct Place {
  std::uint64_t windows = 0;
  int by = 0;

  bool operator==(const Place&) const = default;
};

struct Step {
  Step(Place out, Place in) : leaves(out), enters(in) {}
  /// In place of the one that entered at the step before.
  Step(Place in) : enters(in) {}  // NOLINT(google-explicit-constructor)

  std::optional<Place> leaves;
  Place enters;
};

/// The steps with this window, instead of the usual ones.
struct Leg {
  Place window;
  std::vector<Step> steps;
  std::optional<Place> leaves_next = {};  ///< at the first step of the next window; usually j does
  std::optional<std::vector<Place>> absent = {};  ///< the usual visitors but these come first
};

/// Appends the steps; number_of(place) is the number of the element, and `out` entered last.
template <typename NumberOf>
void add(const std::vector<Step>& steps, std::uint64_t out, const NumberOf& number_of,
         std::vector<Swap>& swaps) {
  for (const Step& step : steps) {
    swaps.push_back(
        {.leaves = step.leaves ? number_of(*step.leaves) : out, .enters = number_of(step.enters)});
    out = swaps.back().enters;
  }
}

}  // namespace changeover::chains
