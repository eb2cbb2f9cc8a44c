// Elements, blocks and where blocks come from.
//
// A block is written as its k elements in any order; 0 ≤ element < v. A BlockSource hands out the
// blocks of a design a few at a time, so a design of 10⁹ blocks needs no memory for its blocks:
//
//     std::vector<Element> block(source.parameters().k);
//     while (source.next(block)) {
//       std::cout << block.front() << '\n';     // use the block
//     }
//     source.rewind();
//     for_each_block(source, [](std::span<const Element> each) {   // faster: in batches
//       std::cout << each.front() << '\n';
//     });
//
// The blocks of a source are a claim until they are verified: verification trusts nothing else. To
// write a source, derive from BlockByBlock, which asks for one block at a time; a source that must
// be fast fills batches itself. Cost: one virtual call per batch, and making the blocks.
#pragma once

#include <algorithm>
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

  /// The parameters that the stream claims; v, k and the kind do not change while it is read.
  [[nodiscard]] virtual const Parameters& parameters() const = 0;

  /// The number of blocks of the whole stream, if known beforehand.
  [[nodiscard]] virtual std::optional<std::uint64_t> block_count() const { return std::nullopt; }

  /// Returns the next blocks, one after another: as many as are ready and fit in `room`, which has
  /// places for at least one; none at the end and after it. They are at the front of `room`, or in
  /// the source's own memory, where they stay valid until the next call.
  /// @throws BadInput if the stream comes from a file that is malformed. Blocks that stand before
  /// the fault may be lost if they were asked for in the same call.
  virtual std::span<const Element> read(std::span<Element> room) = 0;

  /// Writes the next block into `block` (which has k places) and returns true; false at the end.
  /// @throws as read().
  bool next(std::span<Element> block) {
    const std::span<const Element> read_here = read(block);
    if (!read_here.empty() && read_here.data() != block.data()) {
      std::copy(read_here.begin(), read_here.end(), block.begin());
    }
    return !read_here.empty();
  }

  /// Starts over at the first block. Returns false, and changes nothing, if the stream cannot be
  /// read twice (standard input).
  virtual bool rewind() { return false; }

 protected:
  BlockSource() = default;
  BlockSource(const BlockSource&) = default;
  BlockSource& operator=(const BlockSource&) = default;
};

/// Base of a source that makes one block at a time. `class Mine final : public BlockByBlock<Mine>`
/// has this public function, which writes the next block, or returns false if there is none:
///
///     bool make(std::span<Element> block);
///
/// To implement a subclass of BlockSource, such as DesignInput, give it as Base.
template <typename Source, typename Base = BlockSource>
class BlockByBlock : public Base {
 public:
  std::span<const Element> read(std::span<Element> room) final {
    const auto k = static_cast<std::size_t>(this->parameters().k);
    std::size_t filled = 0;
    while (room.size() - filled >= k && static_cast<Source*>(this)->make(room.subspan(filled, k))) {
      filled += k;
    }
    return room.first(filled);
  }
};

/// Calls take(blocks) with the blocks of a source, some 4096 elements at a time, one block after
/// another.
template <typename Take>
void for_each_batch(BlockSource& source, Take&& take) {
  const auto k = static_cast<std::size_t>(source.parameters().k);
  std::vector<Element> room(k * std::max<std::size_t>(1, 4096 / k));
  for (;;) {
    const std::span<const Element> blocks = source.read(room);
    if (blocks.empty()) {
      return;
    }
    take(blocks);
  }
}

/// Calls take(block) with each block of a source.
template <typename Take>
void for_each_block(BlockSource& source, Take&& take) {
  const auto k = static_cast<std::size_t>(source.parameters().k);
  for_each_batch(source, [&](std::span<const Element> blocks) {
    for (std::size_t at = 0; at < blocks.size(); at += k) {
      take(blocks.subspan(at, k));
    }
  });
}

}  // namespace changeover
