// What is known of some parameters: why none exists, or every lower bound and the best design.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "answer/known/offers.hpp"
#include "changeover/bounds/lower_bound.hpp"

namespace changeover {
class JsonWriter;
}  // namespace changeover

namespace changeover::cli {

struct KnownBounds {
  Parameters parameters;
  std::optional<std::string> impossible;  ///< why no design exists
  std::vector<Bound> bounds;              ///< largest first; none if impossible
  std::optional<Offer> best;

  /// "impossible", "open", "minimum" or "best-known".
  [[nodiscard]] std::string status() const;
};

/// @throws ImpossibleParameters as check().
[[nodiscard]] KnownBounds known_bounds(const Parameters& p);

/// Opens an object with the parameters, the largest bound and its reason.
void begin_known(JsonWriter& json, const KnownBounds& known);

/// The document of `bounds --json`.
[[nodiscard]] std::string bounds_json(const KnownBounds& known);

}  // namespace changeover::cli
