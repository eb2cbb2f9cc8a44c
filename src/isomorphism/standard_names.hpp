// Names for elements when the order of blocks is fixed: by columns, in O(bk).
//
//     StandardNames names(design);
//     names.read({.start = 3, .backwards = true});  // blocks 3, 2, 1, 0, b−1, …
//     names.name_of()[x];                           // 0 for an element of block 3
//     names.form();                                 // the b·k renamed elements, block after block
//
// The elements are kept in an ordered partition into classes with the same column so far. Each
// block splits the classes that it meets: its elements come first.
#pragma once

#include <cstddef>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/isomorphism/isomorphism.hpp"

namespace changeover {

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

}  // namespace changeover
