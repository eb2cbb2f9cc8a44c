// A list of blocks held in memory, with the names of its elements.
//
//     Design design(Parameters{.v = 6, .k = 4, .kind = Kind::circular},
//                   std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}});
//     design.block(1);                       // {4, 5, 2, 3}
//     DesignSource source(design);           // the same as a stream
//
// A Design is only a list of blocks of the right shape (k distinct elements below v each):
// verify/verdict.hpp decides whether it is a change covering design.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/parameters.hpp"

namespace changeover {

// How a design is made: a small tree of named constructions, data and not code.
//
// A recipe is deterministic: everyone who builds it gets the same blocks and can verify them again.
//
//     // The expansion of a cyclic design on 7 elements by 8 more:
//     Recipe cyclic{"cyclic-paper", {.v = 7, .k = 3, .kind = Kind::circular}, {{"c", 1}}, {}, {}};
//     const Parameters expanded{.v = 15, .k = 3, .kind = Kind::circular};
//     Recipe recipe{"expansion", expanded, {{"w", 8}}, {cyclic}, {}};
//
// The registry (construct/registry.hpp) turns it into blocks.

/// One construction with its arguments and the designs that it starts from.
struct Recipe {
  std::string construction;                       ///< name in the registry
  Parameters parameters;                          ///< of the design that it makes
  std::map<std::string, std::int64_t> arguments;  ///< whole numbers, by name
  std::vector<Recipe> inputs;                     ///< recipes of the designs that it works on
  std::vector<Block> blocks;  ///< of a literal recipe, or as its construction defines them
  std::string provenance =
      {};  ///< where a literal recipe's blocks come from, one line; may be empty

  bool operator==(const Recipe&) const = default;
};

/// Returns why no element can have this name, and how to correct it; nullopt if one can. A name is
/// printable UTF-8 (no control characters, none that change the writing direction), not empty, and
/// has no white space, comma, double quote or '#', so that every format can carry it and every
/// terminal can show it.
[[nodiscard]] std::optional<std::string> label_defect(std::string_view label);

/// Blocks in memory: b·k elements in one array.
class Design {
 public:
  /// A design without blocks. @throws as check(Parameters), and ImpossibleParameters if v exceeds
  /// max_elements_in_memory.
  explicit Design(const Parameters& parameters);

  /// @throws as above, and as append().
  Design(const Parameters& parameters, std::span<const Block> blocks);

  [[nodiscard]] const Parameters& parameters() const { return parameters_; }
  [[nodiscard]] std::uint64_t v() const { return parameters_.v; }
  [[nodiscard]] std::uint64_t k() const { return parameters_.k; }
  [[nodiscard]] std::size_t block_count() const { return elements_.size() / parameters_.k; }

  /// The elements of block `index`, 0 ≤ index < block_count().
  [[nodiscard]] std::span<const Element> block(std::size_t index) const {
    return {elements_.data() + index * parameters_.k, static_cast<std::size_t>(parameters_.k)};
  }

  /// All blocks, one after another.
  [[nodiscard]] std::span<const Element> elements() const { return elements_; }

  /// A copy of the list of blocks.
  [[nodiscard]] std::vector<Block> blocks() const;

  /// Adds a block at the end. @throws BadInput unless it has exactly k distinct elements below v;
  /// the design is then unchanged. O(k).
  void append(std::span<const Element> block);

  void reserve(std::size_t blocks) { elements_.reserve(blocks * parameters_.k); }

  /// Reads the blocks as those of a design of this kind.
  void set_kind(Kind kind) { parameters_.kind = kind; }

  /// The name of an element: its label, or its number in decimal.
  [[nodiscard]] std::string label(Element element) const;

  /// One name per element, or empty if elements are named by their numbers.
  [[nodiscard]] const std::vector<std::string>& labels() const { return labels_; }

  /// Names the elements; an empty list, or one that only says "0", "1", …, removes all names.
  /// @throws BadInput unless there are exactly v distinct labels, each one that label_defect() lets
  /// pass.
  void set_labels(std::vector<std::string> labels);

  /// How the blocks were made, if known.
  std::optional<Recipe> recipe;

 private:
  Parameters parameters_;
  std::vector<Element> elements_;
  std::vector<std::string> labels_;
  std::vector<std::size_t> last_seen_;  // by element: number of the last block that holds it
};

/// A design in memory as a stream. Its blocks are views of the design's memory: the design must
/// outlive the source.
class DesignSource final : public BlockSource {
 public:
  explicit DesignSource(const Design& design) : design_(&design) {}

  [[nodiscard]] const Parameters& parameters() const override { return design_->parameters(); }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return design_->block_count();
  }
  std::span<const Element> read(std::span<Element> room) override;
  bool rewind() override {
    position_ = 0;
    return true;
  }

 private:
  const Design* design_;
  std::size_t position_ = 0;  // elements handed out
};

/// Reads a whole stream into memory. @throws ImpossibleParameters if v exceeds
/// max_elements_in_memory; as BlockSource::read() and Design::append().
[[nodiscard]] Design read_all(BlockSource& source);

// What happens between blocks: introduced and leaving elements, unchanged subsets.
//
// An element x of block Bᵢ is *introduced* in it if x is not in the block before, and *leaves* in
// it if x is not in the block after; all elements are introduced in the first block of a linear
// design and leave in its last [ChafeeStevens2025, Section 1]. Bᵢ ∩ Bᵢ₊₁ is the i-th *unchanged
// subset* Uᵢ.
//
//     DesignSource source(design);
//     for (Transitions steps(source); steps.next();) {
//       draw(steps.block(), steps.introduced(), steps.leaving());
//     }
//
// Nothing here assumes that the change property holds.

/// The elements of `block` that are not in `other`, in the order of `block`. O(k log k).
[[nodiscard]] Block difference(std::span<const Element> block, std::span<const Element> other);

/// The elements of `block` that are also in `other`, in the order of `block`. O(k log k).
[[nodiscard]] Block intersection(std::span<const Element> block, std::span<const Element> other);

/// Whether the block holds all these elements, none of them twice. O(k log k).
[[nodiscard]] bool holds_all(std::span<const Element> block, std::span<const Element> elements);

/// A stream of blocks with the marks of each, one block of look-ahead.
class Transitions {
 public:
  /// Starts on `source`, which must outlive this. Reads a circular source once to its end first,
  /// because its last block precedes its first. @throws BadInput if it is circular and cannot be
  /// rewound.
  explicit Transitions(BlockSource& source);

  /// Moves to the next block, the first at the first call; false at the end.
  bool next();

  [[nodiscard]] std::span<const Element> block() const { return block_; }
  [[nodiscard]] std::span<const Element> introduced() const { return introduced_; }
  [[nodiscard]] std::span<const Element> leaving() const { return leaving_; }

  /// The number of this block, from 0.
  [[nodiscard]] std::uint64_t index() const { return index_; }

 private:
  BlockSource* source_;
  std::optional<Block> first_;  // circular only: what follows the last block
  Block previous_, block_, ahead_;
  bool has_ahead_ = false, has_previous_ = false, started_ = false;
  Block introduced_, leaving_;
  std::uint64_t index_ = 0;
};

/// An unchanged subset and its position: position i is between blocks i and i+1, counted from 1; in
/// a circular design of b blocks position b is between the last and the first.
struct UnchangedSubset {
  std::size_t position = 0;
  Block elements;  ///< increasing

  bool operator==(const UnchangedSubset&) const = default;
};

/// The unchanged subsets Bᵢ ∩ Bᵢ₊₁ of a design in order of position: b of them if it is circular
/// and has more than one block, else b − 1. In a linear design any (k−m)-subset of the first and of
/// the last block may serve as U₀ and U_b too; these are not listed. O(bk log k).
[[nodiscard]] std::vector<UnchangedSubset> unchanged_subsets(const Design& design);

}  // namespace changeover
