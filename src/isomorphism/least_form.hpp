// The least standard form over the rotations and reversals of a design, and those that attain it.
//
//     const LeastForm least = least_form(design, {.reversal = true});
//     least.reading;                 // how to read the design
//     least.step;                    // rotating by that many blocks renames elements only
//     least.mirror;                  // a backwards reading with the same form, if there is one
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/isomorphism/isomorphism.hpp"

namespace changeover {

// Cheap invariants of the blocks of a circular design, to tell its rotations apart.
//
// The symbol of a block says how long the elements that are introduced in it stay, and how long
// they were and will be absent. Renaming elements does not change the word of the symbols, rotating
// the design rotates it. Two equal symbols may stand for different blocks: that costs time, never
// truth.

/// Ordered so that longer runs come first.
struct BlockSymbol {
  std::uint64_t shorter = 0;  ///< 2⁶⁴−1 less the longest run that begins here
  std::uint64_t mixed = 0;  ///< of the lengths of all runs that begin here and the gaps beside them

  auto operator<=>(const BlockSymbol&) const = default;
};

/// The word of the blocks 0, 1, …, b−1, and that of the same blocks read backwards around the
/// circle: symbol i of either is about block i.
struct CyclicWords {
  std::vector<BlockSymbol> forwards, backwards;
};

/// O(bk).
[[nodiscard]] CyclicWords cyclic_words(const Design& design);

/// Where the least rotation of a word begins, and the shortest rotation that leaves the word as it
/// is.
struct LeastRotation {
  std::size_t start = 0;
  std::size_t period = 0;
};

/// O(length).
[[nodiscard]] LeastRotation least_rotation(const std::vector<BlockSymbol>& word);

// Names for elements when the order of blocks is fixed: by columns, in O(bk).
//
//     StandardNames names(design);
//     names.read({.start = 3, .backwards = true});  // blocks 3, 2, 1, 0, b−1, …
//     names.name_of()[x];                           // 0 for an element of block 3
//     names.form();                                 // the b·k renamed elements, block after block
//
// The elements are kept in an ordered partition into classes with the same column so far. Each
// block splits the classes that it meets: its elements come first.

/// The order in which the blocks of a design are read; block `start` first, then on around the
/// circle.
struct Reading {
  std::size_t start = 0;
  bool backwards = false;

  /// The block that is read at `place`, 0 ≤ place < b.
  [[nodiscard]] std::size_t block(std::size_t place, std::size_t b) const {
    return backwards ? (start + b - place) % b : (start + place) % b;
  }
};

class StandardNames {
 public:
  /// Keeps a reference to the design.
  explicit StandardNames(const Design& design);

  /// Names the elements for this reading. O(bk log k).
  void read(const Reading& reading);

  /// By element.
  [[nodiscard]] const std::vector<Element>& name_of() const { return name_of_; }
  /// By name.
  [[nodiscard]] const std::vector<Element>& element_of() const { return element_of_; }
  /// The renamed blocks in the order in which they were read, each increasing.
  [[nodiscard]] const std::vector<Element>& form() const { return form_; }
  /// The elements of each class of two or more with the same column, by name.
  [[nodiscard]] std::vector<std::vector<Element>> twins() const;

  /// The map from the design as it is to form(), for the last reading.
  [[nodiscard]] Isomorphism map() const;

 private:
  struct Class {
    std::size_t begin = 0;
    std::size_t size = 0;
    std::size_t met = 0;  // elements of the present block among them, moved to the front
  };

  void split(std::span<const Element> block);

  const Design* design_;
  Reading reading_;
  std::vector<Element> name_of_, element_of_, form_;
  std::vector<std::size_t> class_of_, touched_;
  std::vector<Class> classes_;
};

struct LeastForm {
  Reading reading;
  std::vector<Element> form;  ///< the renamed blocks, read in this way
  Isomorphism map;            ///< from the design to `form`
  std::vector<std::vector<Element>> twins;
  std::size_t step = 0;           ///< the shortest rotation that is a symmetry, b (or 1 if
                                  ///< there is no block) if only the whole turn is
  std::optional<Reading> mirror;  ///< a reading in the other direction with the same form
};

/// O(n·bk) for n readings that the invariants above cannot tell apart.
[[nodiscard]] LeastForm least_form(const Design& design, const Sameness& same);

}  // namespace changeover
