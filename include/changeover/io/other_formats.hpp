// Designs as GAP, Sage, designtheory.org and the La Jolla repository write them.
//
//     Design design = read_design("from_gap.g");  // known by its content, like all formats
//     StringSink sink;
//     write_gap(design, sink);  // D := BlockDesign(6, [ … ]);
//
// These formats say v and blocks. Writers put the points of a block in increasing order and keep the order of the
// blocks; GAP and Sage themselves sort blocks when they make an object of them. What else a design is stands in
// comments, in the words of text (io/formats.hpp), and a reader takes it from there: our files keep everything but the
// recipe. Files of others are completed by the rules in io/input.hpp. Writing, reading and writing again
// gives the same bytes.
//
// **GAP** [package DESIGN]: `D := BlockDesign(7, [[1,2,4],[2,3,5]]);`, with points from 1 on; also without name, and the
// record `rec( isBlockDesign := true, v := 7, blocks := [ [ 1, 2, 4 ] ] )` that GAP prints. Blocks that a group develops
// are refused.
// **Sage**: `D = IncidenceStructure(7, [[0,1,3],[1,2,4]])`, with points from 0 on, or BlockDesign. A bare BlockDesign is
// of GAP if point v occurs and of Sage if point 0 does.
// **designtheory.org**: XML, `list_of_designs` with one `block_design`, points from 0 on; a processing instruction
// `<?changeover …?>` in the place of comments. Entities are refused.
// **La Jolla**: one block a line, points from 1 on, and nothing else. It is text, so the points are labels 1, …, v when it is read.
// Its JSON, an object of v, k, t and blocks, is read by read_json(): t is the strength.
//
// A reader holds the whole text (up to 1 GiB) and the blocks; one design a file.
#pragma once

#include <string_view>

#include "changeover/core/design.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/output.hpp"

namespace changeover {

/// @throws BadInput as io/input.hpp says; MissingResource if reading fails. The same for the other reader.
[[nodiscard]] Design read_literal(Input& input, const ReadOptions& options = {});
[[nodiscard]] Design read_designtheory(Input& input, const ReadOptions& options = {});

/// Whether a text begins, after its comments, like a design of GAP or Sage.
[[nodiscard]] bool begins_like_a_literal(std::string_view beginning);

/// @throws as Sink::write(). The same for the other writers.
void write_gap(const Design& design, Sink& sink);
void write_sage(const Design& design, Sink& sink);
void write_designtheory(const Design& design, Sink& sink);
void write_ljcr(const Design& design, Sink& sink);

}  // namespace changeover
