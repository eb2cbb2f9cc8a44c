// Fans: lists of blocks in which one element goes through an interval beside k−1 that stay.
//
//     const Block kept{1, 4, 7};
//     const Fan fan{kept, 10, 12};       // {1,4,7,10}, {1,4,7,11}, {1,4,7,12}
//     fan.block_count();                 // 3
//
// A block alone is a fan with first = last. Where every old element is inserted beside an unchanged
// subset, as in concatenation, a list of b blocks over v elements has O(kv) fans, so a design of
// 10¹¹ blocks can be verified by its fans (verify/fans.hpp). A source of blocks that is made of
// fans hands out what they say, and nothing else.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "changeover/core/block.hpp"

namespace changeover {

/// The blocks kept ∪ {x} for x = first, …, last, in this order.
struct Fan {
  std::span<const Element> kept;  ///< k−1 elements; they stay where they are until the next fan
  Element first = 0;
  Element last = 0;  ///< at least `first`

  [[nodiscard]] std::uint64_t block_count() const { return std::uint64_t{last} - first + 1; }
};

/// A design as a stream of fans.
class FanSource {
 public:
  virtual ~FanSource() = default;

  /// As BlockSource::parameters().
  [[nodiscard]] virtual const Parameters& parameters() const = 0;

  /// As BlockSource::block_count().
  [[nodiscard]] virtual std::optional<std::uint64_t> block_count() const = 0;

  /// The next fan; nullopt at the end and after it. @throws as BlockSource::read().
  virtual std::optional<Fan> next() = 0;

  /// As BlockSource::rewind().
  virtual bool rewind() = 0;

 protected:
  FanSource() = default;
  FanSource(const FanSource&) = default;
  FanSource& operator=(const FanSource&) = default;
};

/// The blocks of these fans; each has the element that changes last.
[[nodiscard]] std::unique_ptr<BlockSource> blocks_of(std::unique_ptr<FanSource> fans);

/// Each block as a separate fan. Memory of a block.
[[nodiscard]] std::unique_ptr<FanSource> fans_of(std::unique_ptr<BlockSource> blocks);

}  // namespace changeover
