// Elements, blocks and where blocks come from.
//
// A block is written as its k elements in any order; 0 ≤ element < v. A BlockSource hands out the
// blocks of a design one at a time, so a design of 10⁹ blocks needs no memory for its blocks:
//
//     std::vector<Element> block(source.parameters().k);
//     while (source.next(block)) {
//       std::cout << block.front() << '\n';     // or whatever is to be done with a block
//     }
//
// What a source hands out is a claim, not a fact: verification reads blocks and trusts nothing else.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "changeover/core/parameters.hpp"

namespace changeover {

/// An element of the point set {0, …, v−1}.
using Element = std::uint32_t;

/// The elements of one block; the order in which they are written means nothing.
using Block = std::vector<Element>;

/// A design as a stream of blocks.
class BlockSource {
 public:
  virtual ~BlockSource() = default;

  /// What the stream claims to be; v, k and the kind do not change while it is read.
  [[nodiscard]] virtual const Parameters& parameters() const = 0;

  /// The number of blocks of the whole stream, if known beforehand.
  [[nodiscard]] virtual std::optional<std::uint64_t> block_count() const { return std::nullopt; }

  /// Writes the next block into `block` (which has k places) and returns true; false at the end.
  /// @throws BadInput if the stream comes from a file that is malformed.
  virtual bool next(std::span<Element> block) = 0;

  /// Starts over at the first block. Returns false, and changes nothing, if the stream cannot be
  /// read twice (standard input).
  virtual bool rewind() { return false; }

 protected:
  BlockSource() = default;
  BlockSource(const BlockSource&) = default;
  BlockSource& operator=(const BlockSource&) = default;
};

}  // namespace changeover
