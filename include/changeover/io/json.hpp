// Designs, recipes and verdicts as JSON.
//
//     {"format":"changeover-design/1","v":6,"k":4,"change":2,"kind":"circular","blocks":[
//     [0,1,2,3],
//     [4,5,2,3],
//     [4,5,0,1]
//     ]}
//
// Keys come in this order; after `kind` comes "strength" if it is not 2, after `blocks` come "labels"
// (the names of elements 0, 1, …), "recipe" and "verdict", each if there is one. A block is an array of
// element *numbers*, on a line of its own. A reader takes keys in any order and ignores those that
// it does not know; it takes strings for elements as labels, and a bare array of blocks. What is
// missing is inferred by the rules in io/design_input.hpp. Writing, reading and writing again gives
// the same bytes, except that a verdict is never read: it is for the verifier to say.
//
// A reader holds the whole text (up to 4 GiB) and the blocks; a writer holds neither. Nesting deeper
// than 256 levels is refused.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/recipe.hpp"
#include "changeover/io/design_input.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/sink.hpp"
#include "changeover/io/text.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover {

/// What a design's file says about its quality: the verdict in short, and what bounds and proofs say.
struct DesignVerdict {
  bool valid = false;
  bool tight = false;
  bool economical = false;
  std::uint64_t b = 0;
  std::uint64_t lower_bound = 0;
  bool minimum_proved = false;  ///< "minimum":"proved" or "unknown"

  bool operator==(const DesignVerdict&) const = default;
};

/// @throws BadInput as io/design_input.hpp says, for text that is not JSON and for JSON that is not a
/// design; MissingResource if reading fails.
[[nodiscard]] Design read_json(Input& input, const ReadOptions& options = {});

/// Writes a design with its labels and recipe, and the verdict if there is one.
void write_json(const Design& design, Sink& sink,
                const std::optional<DesignVerdict>& verdict = std::nullopt);

/// The same for a stream, which is read to its end. The verdict is asked for after the last block, as
/// that is when it is known; it may be empty. Returns the number of blocks.
std::uint64_t write_json(BlockSource& source, Sink& sink, const TextHeader& header = {},
                         const std::function<std::optional<DesignVerdict>()>& verdict = {});

/// {"valid":true,"tight":true,"economical":true,"b":366,"lower_bound":366,"minimum":"proved"}
[[nodiscard]] std::string verdict_to_json(const DesignVerdict& verdict);

/// Everything that the verifier found, with elements in examples named by `labels` if there are any.
/// Keys: v, k, change, kind, strength; valid, tight, economical, b, counting_bound; bad_steps,
/// bad_step_examples [{from,to,changes}]; subsets, uncovered, uncovered_examples [[…]]; covered,
/// never_newly_covered, excess; fixed […]; degree_identity (true, or null for strength ≠ 2);
/// unchanged_subsets, never_unchanged […]; elements [{element, introductions, blocks, covered, excess}].
[[nodiscard]] std::string verdict_to_json(const Verdict& verdict,
                                          const std::vector<std::string>& labels = {});

/// {"construction":"cyclic","v":7,"k":3,"change":2,"kind":"circular","arguments":{"c":1},"inputs":[]},
/// with "strength" after kind if it is not 2 and "blocks" last if there are any. One line.
[[nodiscard]] std::string recipe_to_json(const Recipe& recipe);

/// Reads what recipe_to_json() writes; missing arguments and inputs are empty.
/// @throws BadInput with line and column.
[[nodiscard]] Recipe recipe_from_json(std::string_view json, const std::string& name = "<recipe>");

}  // namespace changeover
