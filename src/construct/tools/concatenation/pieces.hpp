// Pieces that are put after linear single-change designs: concatenation and rings
// [docs/theorems.md, Theorem 13].
//
//     const Piece piece = open_piece(blocks, {8, 16, 33, 41});
//     auto longer = with_pieces(std::move(source), piece, 1000, larger);
//
// A *piece* is a list of blocks in which one element changes at each step, with *parts*:
// unchanged subsets, k−1 elements each, that are disjoint. The elements in no part are the
// piece's *anchors*: k−1 in its first block or, for a ring, 2(k−1), k−1 of them in its first
// block and the others in its last. After a design V the anchors are elements of V, those of the
// first block from the last block of V, those of the last from the first of V; all other elements
// of the piece are new. At the position of each part U_i the blocks U_i ∪ {x} are inserted for
// all x of V that are no anchors.
//
// *Open ends*: V lacks the pairs of its ends, those of 0, …, k−2, in its first block, with its
// last k−1 elements, in its last block. Then a ring's piece brings them, and one that is made open
// by `opened` leaves V with open ends again.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "changeover/core/block.hpp"
#include "changeover/core/fans.hpp"

namespace changeover {

struct Piece {
  std::vector<Block> blocks;
  std::vector<UnchangedSubset> parts;  ///< in order of position
  Block first;                         ///< anchors in the first block, increasing
  Block last;                          ///< anchors of the last block; none unless it closes a ring
  Block fresh;                         ///< the elements of the parts, as they are numbered

  [[nodiscard]] std::uint64_t anchors() const { return first.size() + last.size(); }
};

/// A piece of blocks on 0, …, w−1, w ≤ 2^20, with the unchanged subsets at these positions as
/// parts (1 is between the first two blocks). If the anchors are in the last block only, the list
/// is reversed. @throws BadInput, in one line, if it is none.
[[nodiscard]] Piece open_piece(std::vector<Block> blocks, const std::vector<Element>& positions);

/// The same for a ring.
[[nodiscard]] Piece closing_piece(std::vector<Block> blocks, const std::vector<Element>& positions);

/// A ring's piece for the rounds before it closes: the anchors of its last block become a part
/// there.
[[nodiscard]] Piece opened(Piece closing);

/// Whether a design has open ends, and so has what is made of it by an opened piece.
enum class Ends : std::uint8_t { paired, open };

/// How many blocks a design of v elements and b blocks has after `times` such pieces. @throws
/// ImpossibleParameters if they exceed 64 bits.
[[nodiscard]] std::uint64_t count_with_pieces(std::uint64_t v, std::uint64_t b, const Piece& piece,
                                              std::uint64_t times, Ends ends = Ends::paired);

/// The design with so many pieces after it, as a stream. `larger` has v + |fresh|·times elements.
/// Memory of a piece and a block. Reading
/// @throws BadInput if a ring's design has no disjoint anchors at its ends.
[[nodiscard]] std::unique_ptr<FanSource> with_pieces(std::unique_ptr<FanSource> design, Piece piece,
                                                     std::uint64_t times, const Parameters& larger,
                                                     Ends ends = Ends::paired);

/// A piece that is written down: blocks as in short_blocks.hpp, positions of its parts.
struct WrittenPiece {
  std::uint64_t k = 0;
  std::uint64_t w = 0;      ///< elements
  std::uint64_t fresh = 0;  ///< how many of them are in parts
  std::uint64_t b = 0;
  std::string_view blocks{};
  std::vector<Element> positions{};
};

/// Those for concatenation, and those that close rings, of least waste first.
[[nodiscard]] const std::vector<WrittenPiece>& open_pieces();
[[nodiscard]] const std::vector<WrittenPiece>& closing_pieces();

/// Pieces that are designs, for rings of copies; `fresh` when they close.
[[nodiscard]] const std::vector<WrittenPiece>& copied_pieces();

/// A piece as a design.
[[nodiscard]] Recipe written_recipe(const WrittenPiece& piece);

/// Lists with open ends that are written down; `fresh` and `positions` are not used.
[[nodiscard]] const std::vector<WrittenPiece>& open_lists();

/// The fewest blocks that concatenation makes for p, linear, of the registry's designs that are
/// no concatenations, with one piece or more. For a ring also a written piece itself, or such a
/// design itself if its ends have at most two elements in common. nullopt if there is none.
[[nodiscard]] std::optional<Offer> best_concatenation(const Parameters& p, const Registry& registry,
                                                      bool for_a_ring);

}  // namespace changeover
