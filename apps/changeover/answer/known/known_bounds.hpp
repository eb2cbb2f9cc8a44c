// What is known of some parameters: why none exists, or every lower bound and the best design.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "answer/known/offers.hpp"
#include "changeover/bounds/lower_bound.hpp"
#include "changeover/catalog/catalog.hpp"

namespace changeover {
class JsonWriter;
}  // namespace changeover

namespace changeover::cli {

struct KnownBounds {
  Parameters parameters;
  std::optional<std::string> impossible;  ///< why no design exists
  std::vector<Bound> bounds;              ///< largest first; none if impossible
  std::optional<Offer> best;
  std::optional<Reported> reported;  ///< a publication has fewer blocks than the best

  /// "impossible", "open", "minimum" or "best-known".
  [[nodiscard]] std::string status() const;
};

/// @throws ImpossibleParameters as check().
[[nodiscard]] KnownBounds known_bounds(const Parameters& p);

/// "63 reported [Bean2026], blocks not held here".
[[nodiscard]] std::string in_words(const Reported& reported);

/// The key "reported" of an object, null if there is nothing.
void write_reported(JsonWriter& json, const KnownBounds& known);

/// Opens an object with the parameters, the largest bound and its reason.
void begin_known(JsonWriter& json, const KnownBounds& known);

/// The document of `bounds --json`.
[[nodiscard]] std::string bounds_json(const KnownBounds& known);

}  // namespace changeover::cli
