// What all readers of designs share: the rules by which blocks from outside become a design.
//
// A foreign file seldom says all of its parameters. They come, in this order, from the caller
// (ReadOptions), from the file, and from these rules:
//   - k is the number of elements of the first block; every other block must agree.
//   - change is the number of elements in which the first two blocks differ (2 if there is one block
//     or they are equal), kind is linear, strength is 2.
//   - Elements are *numbers* (plain decimals: digits, no needless leading zero) or *labels*. If the
//     file lists its labels, each element is looked up there. If it declares v, either all elements are
//     numbers below v, or all are labels, numbered as they first occur, at most v of them. If it does
//     not, the elements that occur are the whole set: numbers 0 … n−1 stay as they are, other
//     numbers become labels in increasing order, anything else labels in the order of occurrence.
//   - At most 65,535 elements, in a block and altogether; a name has at most 255 bytes and is one that
//     label_defect() lets pass, in every format: UTF-8 without control characters.
//
// A violation is BadInput with one line: `NAME:LINE:COLUMN: what is wrong; how to mend it`. Lines and
// columns count from 1, columns in bytes. If it is the caller's it is BadReadOption, without a place.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/core/recipe.hpp"

namespace changeover {

/// What the caller knows of a design that is about to be read; it wins over what the file says.
struct ReadOptions {
  std::optional<std::uint64_t> v = {};
  std::optional<std::uint64_t> k = {};
  std::optional<std::uint64_t> change = {};
  std::optional<Kind> kind = {};
  std::optional<std::uint32_t> strength = {};
};

/// The caller declared what cannot be: v or k that no file can have, a change of 0 or of more than k
/// elements, a strength above k. No fault of the file, and no correction of it would help.
class BadReadOption : public BadInput {
 public:
  using BadInput::BadInput;
};

/// A design from outside as a stream.
class DesignInput : public BlockSource {
 public:
  /// One name per element, or empty if elements are numbers; complete once next() has said false.
  [[nodiscard]] virtual const std::vector<std::string>& labels() const = 0;

  /// The recipe that came with the blocks, if any. A claim: the blocks need not be its blocks.
  [[nodiscard]] virtual const std::optional<Recipe>& recipe() const = 0;
};

/// The whole stream with its labels and recipe. @throws as next().
[[nodiscard]] Design read_all(DesignInput& input);

}  // namespace changeover
