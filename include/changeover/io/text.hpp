// Designs as text, the format that people type and every language reads.
//
//     # changeover design v=6 k=4 change=2 kind=circular
//     0 1 2 3
//     4 5 2 3
//     4 5 0 1
//
// One block a line, its elements separated by blanks or tabs; `#` starts a comment. Three comments mean
// something when they have a line before the first block to themselves:
//     # changeover design v=… k=… change=… kind=… strength=…     parameters, each optional
//     # labels: a b c …                                          the names of elements 0, 1, 2, …
//     # recipe: {…}                                              how the blocks were made, as JSON
// A writer names strength only if it is not 2, and writes the elements of a design with labels by their
// labels. What is missing is inferred by the rules in io/design_input.hpp. Lines may end in CR LF, and
// a byte order mark is skipped. Writing, reading and writing again gives the same bytes; the
// comments of others are dropped.
//
// Bound by: memory bandwidth and the system's read and write. Memory: one buffer of 256 KiB, the names
// of the elements, two blocks. A source that does not declare v is read twice; if it cannot be rewound
// (standard input) it is kept in memory as text, up to 4 GiB.
//
// Deliberately not done: several designs in one file; a block over several lines.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/io/design_input.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/sink.hpp"

namespace changeover {

/// Opens a stream of blocks. Reads the header and the first two blocks at once, and everything once if
/// v is not declared. If v is declared but no labels are, the first 256 KiB decide whether elements
/// are numbers or labels.
/// @throws BadInput as io/design_input.hpp says, from here or from next(); MissingResource if reading
/// fails.
[[nodiscard]] std::unique_ptr<DesignInput> open_text(std::unique_ptr<Input> input,
                                                     const ReadOptions& options = {});

/// The whole design in memory. @throws as open_text() and next().
[[nodiscard]] Design read_text(std::unique_ptr<Input> input, const ReadOptions& options = {});

/// Writes header, labels, recipe and blocks of a design. @throws as Sink::write().
void write_text(const Design& design, Sink& sink);

/// What a stream of blocks cannot tell about itself.
struct TextHeader {
  std::vector<std::string> labels = {};  ///< one per element, or empty
  std::optional<Recipe> recipe = {};
};

/// The same for a stream, which is read to its end. Returns the number of blocks. O(bytes written);
/// for v ≤ 65,535 each element costs one unaligned copy of 8 bytes unless labels are longer.
std::uint64_t write_text(BlockSource& source, Sink& sink, const TextHeader& header = {});

/// "changeover design v=61 k=4 change=2 kind=circular", with " strength=3" if it is not 2.
[[nodiscard]] std::string header_words(const Parameters& p);

}  // namespace changeover
