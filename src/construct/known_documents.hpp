// What is known as documents in JSON: of some parameters, of a range of them, of how a design is
// made, of what makes designs. Every door has them from here.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/best_known.hpp"

namespace changeover {

class JsonWriter;

/// Why no design exists, or every lower bound and the best design.
struct KnownBounds {
  Parameters parameters;
  std::optional<std::string> impossible;  ///< why no design exists
  std::vector<Bound> bounds;              ///< largest first; none if impossible
  std::optional<Offer> best;
  std::optional<Reported> reported;  ///< a publication has fewer blocks than the best
  std::optional<Classified> all;     ///< how many designs there are with as many blocks as the best

  /// "impossible", "open", "minimum" or "best-known".
  [[nodiscard]] std::string status() const;
};

/// @throws ImpossibleParameters as check().
[[nodiscard]] KnownBounds known_bounds(const Parameters& p);

/// That of the kind that a single answer is about: the one with the fewest blocks known, the first
/// among equals.
[[nodiscard]] const KnownBounds& best_of(const std::vector<KnownBounds>& kinds);

/// "63 reported [Bean2026], blocks not held here".
[[nodiscard]] std::string reported_words(const Reported& reported);

/// The key "reported" of an object, null if there is nothing.
void write_reported(JsonWriter& json, const KnownBounds& known);

/// "16 standard forms in 2 classes, 2 tight: counted by classify".
[[nodiscard]] std::string classified_words(const Classified& all);

/// The key "classified" of an object, null if the designs were not counted.
void write_classified(JsonWriter& json, const KnownBounds& known);

/// Opens an object with the parameters, the largest bound and its reason.
void begin_known(JsonWriter& json, const KnownBounds& known);

/// The document of `bounds --json`.
[[nodiscard]] std::string bounds_json(const KnownBounds& known);

using Cells = std::vector<const KnownCell*>;

/// What cells have besides their numbers: "label", of their design in the catalog, or "reason", of
/// the bound, or why nothing exists.
enum class CellKeys : std::uint8_t { numbers, with_label, with_reason };

/// The document of `table --json`.
[[nodiscard]] std::string table_json(const Cells& cells, CellKeys keys = CellKeys::numbers);

/// All cells of a kind that the catalog comes with.
[[nodiscard]] CellRange stored_cells(std::uint64_t change, Kind kind);

/// Opens an object with what all cells of a range have in common; `range.kind` is given.
void begin_atlas(JsonWriter& json, const CellRange& range, std::uint32_t strength = 2);

/// The cells of a range in columns, as a map of the catalog shows them: what all have in common,
/// then b, lower bound, construction and label of each, by k, then v. A label has only what its
/// cell and number of blocks do not say: its digits at the end.
[[nodiscard]] std::string atlas_json(const CellRange& range, const Cells& cells,
                                     std::uint32_t strength = 2);

/// The label in the catalog of the design that is offered; empty if it is not there.
[[nodiscard]] std::string label_of(const Offer& offer);

/// Writes the verdict on the design of a recipe, or null.
using WriteVerdict = std::function<void(const Recipe& recipe, JsonWriter& json)>;

/// The tree of a recipe as an object; without "verdict" if nothing writes it.
void write_tree(const Recipe& recipe, JsonWriter& json, const WriteVerdict& verdict = {});

/// The document of `constructions --json`.
[[nodiscard]] std::string constructions_json();

}  // namespace changeover
