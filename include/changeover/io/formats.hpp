// Designs as text, the format that people type and every language reads.
//
//     # changeover design v=6 k=4 change=2 kind=circular
//     0 1 2 3
//     4 5 2 3
//     4 5 0 1
//
// One block per line, its elements separated by blanks or tabs; `#` starts a comment. Three
// comments have a meaning if each is alone on a line before the first block:
//   # changeover design v=… k=… change=… kind=… strength=…     parameters, each optional
//   # labels: a b c …                                          the names of elements 0, 1, 2, …
//   # recipe: {…}                                              how the blocks were made, as JSON
// A writer names strength only if it is not 2, and writes elements by their labels if the design
// has them. A reader infers missing parameters by the rules in io/input.hpp. Lines may end in CR
// LF, and a byte order mark is skipped. Writing, reading and writing again gives the same bytes;
// other comments are dropped.
//
// Speed: that of memory and of the system's read and write. Memory: one buffer of 256 KiB, the
// names of the elements, two blocks. A source that does not declare v is read twice; if it cannot
// be rewound (standard input) it is kept in memory as text, up to 4 GiB.
//
// Deliberately not done: several designs in one file; a block over several lines.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/output.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover {

/// Opens a stream of blocks. Reads the header and the first two blocks at once, and everything once
/// if v is not declared. If v is declared but no labels are, the first 256 KiB decide whether
/// elements are numbers or labels.
/// @throws BadInput as io/input.hpp says, from here or from next(); MissingResource if reading
/// fails.
[[nodiscard]] std::unique_ptr<DesignInput> open_text(std::unique_ptr<Input> input,
                                                     const ReadOptions& options = {});

/// The whole design in memory. @throws as open_text() and next().
[[nodiscard]] Design read_text(std::unique_ptr<Input> input, const ReadOptions& options = {});

/// Writes header, labels, recipe and blocks of a design. @throws as Sink::write().
void write_text(const Design& design, Sink& sink);

/// What a stream of blocks does not carry: labels and recipe.
struct TextHeader {
  std::vector<std::string> labels = {};  ///< one per element, or empty
  std::optional<Recipe> recipe = {};
};

/// Writes the blocks of a stream as text; the stream is read to its end. Returns the number of
/// blocks. O(bytes written); for v ≤ 65,535 each element costs one unaligned copy of 8 bytes unless
/// labels are longer.
std::uint64_t write_text(BlockSource& source, Sink& sink, const TextHeader& header = {});

/// "changeover design v=61 k=4 change=2 kind=circular", with " strength=3" if it is not 2.
[[nodiscard]] std::string header_words(const Parameters& p);

// Designs as CSV, for spreadsheets and data frames.
//
//     block,element_1,element_2,element_3,element_4,v,change,kind
//     1,0,1,2,3,6,2,circular
//     2,4,5,2,3,6,2,circular
//     3,4,5,0,1,6,2,circular
//
// One block per row, numbered from 1; the columns after the elements have the same values in every
// row, so that rows can be sorted and filtered without losing the parameters. A column `strength`
// follows if it is not 2, and a column `elements`, which then always says `labels`, if the elements
// are named by other words than 0 … v−1: its cells are names even where they look like numbers. A
// name that a spreadsheet would compute, such as =1+1, has an apostrophe in front, which a reader
// removes. Rows end in LF.
//
// A reader finds the columns by their names, in any order, and ignores others; every column but the
// elements may be missing, and so may the first row, if all rows hold nothing but elements. The
// separator is a comma or a semicolon, whichever comes first in the first row; fields may be
// quoted. The reader infers the rest by the rules in io/input.hpp. Rows are blocks in the order of
// the file. Writing, reading and writing again gives the same bytes; a recipe is not kept, and
// labels are in the order in which they occur.

/// @throws BadInput as io/input.hpp says; MissingResource if reading fails.
[[nodiscard]] Design read_csv(Input& input, const ReadOptions& options = {});

/// Writes the blocks of a design, elements by label.
void write_csv(const Design& design, Sink& sink);

/// Writes the blocks of a stream as CSV; the stream is read to its end. Returns the number of
/// blocks.
std::uint64_t write_csv(BlockSource& source, Sink& sink,
                        const std::vector<std::string>& labels = {});

// Designs, recipes and verdicts as JSON.
//
//     {"format":"changeover-design/1","v":6,"k":4,"change":2,"kind":"circular","blocks":[
//     [0,1,2,3],
//     [4,5,2,3],
//     [4,5,0,1]
//     ]}
//
// Keys come in this order; after `kind` comes "strength" if it is not 2, after `blocks` come
// "labels" (the names of elements 0, 1, …), "recipe" and "verdict", each if there is one. A block
// is an array of element *numbers*, on a separate line. A reader takes keys in any order and
// ignores those that it does not know; it takes strings as labels of elements, accepts a bare array
// of blocks, and infers the rest by the rules in io/input.hpp. Writing, reading and writing again
// gives the same bytes, except that a reader ignores verdicts: only the verifier gives one.
//
// A reader holds the whole text (up to 4 GiB) and the blocks; a writer holds neither. Nesting
// deeper than 256 levels is refused.

/// The quality of a design in its file: the verdict in short, and the lower bound.
struct DesignVerdict {
  bool valid = false;
  bool tight = false;
  bool economical = false;
  std::uint64_t b = 0;
  std::uint64_t lower_bound = 0;
  bool minimum_proved = false;  ///< "minimum":"proved" or "unknown"

  bool operator==(const DesignVerdict&) const = default;
};

/// @throws BadInput as io/input.hpp says, for text that is not JSON and for JSON that is not a
/// design; MissingResource if reading fails.
[[nodiscard]] Design read_json(Input& input, const ReadOptions& options = {});

/// Writes a design with its labels and recipe, and the verdict if there is one.
void write_json(const Design& design, Sink& sink,
                const std::optional<DesignVerdict>& verdict = std::nullopt);

/// Writes the blocks of a stream as JSON; the stream is read to its end. Calls for the verdict
/// after the last block, when it is known; it may be empty. Returns the number of blocks.
std::uint64_t write_json(BlockSource& source, Sink& sink, const TextHeader& header = {},
                         const std::function<std::optional<DesignVerdict>()>& verdict = {});

/// {"valid":true,"tight":true,"economical":true,"b":366,"lower_bound":366,"minimum":"proved"}
[[nodiscard]] std::string verdict_to_json(const DesignVerdict& verdict);

/// The whole verdict, with elements in examples named by `labels` if there are any. Keys: v, k,
/// change, kind, strength; valid, tight, economical, b, counting_bound; bad_steps,
/// bad_step_examples [{from,to,changes}]; subsets, uncovered, uncovered_examples [[…]]; covered,
/// never_newly_covered, excess; fixed […]; degree_identity (true, or null for strength ≠ 2);
/// unchanged_subsets, never_unchanged […]; elements [{element, introductions, blocks, covered,
/// excess}].
[[nodiscard]] std::string verdict_to_json(const Verdict& verdict,
                                          const std::vector<std::string>& labels = {});

/// {"construction":"cyclic","v":7,"k":3,"change":2,"kind":"circular","arguments":{"c":1},
/// "inputs":[]}, with "strength" after kind if it is not 2 and "blocks" last if there are any. One
/// line.
[[nodiscard]] std::string recipe_to_json(const Recipe& recipe);

/// Reads what recipe_to_json() writes; missing arguments and inputs are empty.
/// @throws BadInput with line and column.
[[nodiscard]] Recipe recipe_from_json(std::string_view json, const std::string& name = "<recipe>");

// Designs as GAP, Sage, designtheory.org and the La Jolla repository write them.
//
//     Design design = read_design("from_gap.g");  // known by its content, like all formats
//     StringSink sink;
//     write_gap(design, sink);  // D := BlockDesign(6, [ … ]);
//
// These formats have v and blocks. Writers put the points of a block in increasing order and keep
// the order of the blocks; GAP and Sage themselves sort blocks when they make an object of them.
// The other parameters and the labels are in comments, with the same words as in text (above), and
// readers take them from there: our files keep everything but the recipe. For other files readers
// use the rules in io/input.hpp. Writing, reading and writing again gives the same bytes.
//
// **GAP** [package DESIGN]: `D := BlockDesign(7, [[1,2,4],[2,3,5]]);`, with points from 1 on; also
// without name, and the record `rec( isBlockDesign := true, v := 7, blocks := [ [ 1, 2, 4 ] ] )`
// that GAP prints. Blocks to be developed under a group are refused. **Sage**:
// `D = IncidenceStructure(7, [[0,1,3],[1,2,4]])`, with points from 0 on, or BlockDesign. A bare
// BlockDesign is of GAP if point v occurs and of Sage if point 0 does. **designtheory.org**: XML,
// `list_of_designs` with one `block_design`, points from 0 on; a processing instruction
// `<?changeover …?>` instead of comments. Entities are refused. **La Jolla**: one block per line,
// points from 1 on, and nothing else. A reader takes it for text, so the points are labels 1, …, v.
// read_json() reads its JSON, an object of v, k, t and blocks: t is the strength.
//
// A reader holds the whole text (up to 1 GiB) and the blocks; one design per file.

/// @throws BadInput as io/input.hpp says; MissingResource if reading fails. The same for the other
/// reader.
[[nodiscard]] Design read_literal(Input& input, const ReadOptions& options = {});
[[nodiscard]] Design read_designtheory(Input& input, const ReadOptions& options = {});

/// Blocks in brackets of any kind, "{A,B,D} {B,C,E}" or "blocks = [(0,1,3),(1,2,4)]", their
/// elements numbers or names, separated by commas or blanks; a pair of brackets may hold all
/// blocks. Elements get their numbers as in a JSON array of blocks. @throws as read_literal().
[[nodiscard]] Design read_brackets(Input& input, const ReadOptions& options = {});

/// Whether a text begins, after its comments, like a design of GAP or Sage.
[[nodiscard]] bool begins_like_a_literal(std::string_view beginning);

/// Whether a text begins, after its comments, like blocks in brackets and not like JSON.
[[nodiscard]] bool begins_like_brackets(std::string_view beginning);

/// @throws as Sink::write(). The same for the other writers.
void write_gap(const Design& design, Sink& sink);
void write_sage(const Design& design, Sink& sink);
void write_designtheory(const Design& design, Sink& sink);
void write_ljcr(const Design& design, Sink& sink);

}  // namespace changeover
