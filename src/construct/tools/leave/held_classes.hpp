// A cyclic list, then classes of m-sets of its elements that pass beside held groups of new ones
// [docs/theorems.md, Theorems 33 and 34].
//
// v = w + nt, n = k−m. First the development of base blocks {0, …, n−1} ∪ {m points} over Z_w, then
// a short list on nt new elements; where the latter keeps a group of n, the m-sets of a class pass
// beside it. Shortest ways lead from the one list to the other, over the seams of the short one,
// and back if the design is circular. All this is a stream in memory of the short list.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "changeover/core/design.hpp"
#include "changeover/core/developed.hpp"

namespace changeover {

/// Base blocks over Z_w, and classes of disjoint m-sets that hold every element.
class HeldClasses {
 public:
  HeldClasses() = default;
  HeldClasses(const HeldClasses&) = delete;
  HeldClasses& operator=(const HeldClasses&) = delete;
  virtual ~HeldClasses() = default;

  /// w, below 2³².
  [[nodiscard]] virtual std::uint64_t elements() const = 0;
  [[nodiscard]] virtual std::uint64_t base_blocks() const = 0;
  [[nodiscard]] virtual IntervalDevelopedSource::Points points() const = 0;
  /// t, at least 1.
  [[nodiscard]] virtual std::uint64_t groups() const = 0;
  /// How many m-sets class i has, at least 1.
  [[nodiscard]] virtual std::uint64_t count(std::uint64_t i) const = 0;
  /// m-set number j of class i; those that follow each other are disjoint.
  virtual void write(std::uint64_t i, std::uint64_t j, std::span<Element> set) const = 0;
};

/// How many blocks the source below has. O(tk²).
[[nodiscard]] std::uint64_t held_classes_count(const Parameters& p,
                                               std::shared_ptr<const HeldClasses> classes);

/// The design as a stream; v = w + (k−m)t.
[[nodiscard]] std::unique_ptr<BlockSource> held_classes_source(
    const Parameters& p, std::shared_ptr<const HeldClasses> classes);

}  // namespace changeover
