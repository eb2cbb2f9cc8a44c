// A list of blocks held in memory, with the names of its elements.
//
//     Design design(Parameters{.v = 6, .k = 4, .kind = Kind::circular},
//                   std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}});
//     design.block(1);                       // {4, 5, 2, 3}
//     DesignSource source(design);           // the same as a stream
//
// A Design is a list of blocks of the right shape (k distinct elements below v each), no more: whether
// it is a change covering design is for verify/verdict.hpp to say.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/core/recipe.hpp"

namespace changeover {

/// Why no element can have this name, with how to mend it; nullopt if it can. So that every format can
/// carry it and every terminal show it, a name is printable UTF-8 (core/printable.hpp), is not empty and
/// has no white space, comma, double quote or '#'.
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

  /// A copy of the list of blocks, to be worked on.
  [[nodiscard]] std::vector<Block> blocks() const;

  /// Adds a block at the end. @throws BadInput if it has not exactly k distinct elements below v;
  /// the design is then unchanged. O(k).
  void append(std::span<const Element> block);

  void reserve(std::size_t blocks) { elements_.reserve(blocks * parameters_.k); }

  /// The same blocks read as the other kind.
  void set_kind(Kind kind) { parameters_.kind = kind; }

  /// The name of an element: its label, or its number in decimal.
  [[nodiscard]] std::string label(Element element) const;

  /// One name per element, or empty if elements are named by their numbers.
  [[nodiscard]] const std::vector<std::string>& labels() const { return labels_; }

  /// Names the elements; an empty list, or one that only says "0", "1", …, removes all names.
  /// @throws BadInput unless there are exactly v distinct labels, each one that label_defect() lets pass.
  void set_labels(std::vector<std::string> labels);

  /// How the blocks were made, if known.
  std::optional<Recipe> recipe;

 private:
  Parameters parameters_;
  std::vector<Element> elements_;
  std::vector<std::string> labels_;
  std::vector<std::size_t> last_seen_;  // by element: number of the last block that holds it
};

/// A design in memory as a stream. Keeps a reference: the design must outlive it.
class DesignSource final : public BlockSource {
 public:
  explicit DesignSource(const Design& design) : design_(&design) {}

  [[nodiscard]] const Parameters& parameters() const override { return design_->parameters(); }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return design_->block_count();
  }
  bool next(std::span<Element> block) override;
  bool rewind() override {
    position_ = 0;
    return true;
  }

 private:
  const Design* design_;
  std::size_t position_ = 0;
};

/// Reads a whole stream into memory. @throws ImpossibleParameters if v exceeds
/// max_elements_in_memory; as BlockSource::next() and Design::append().
[[nodiscard]] Design read_all(BlockSource& source);

}  // namespace changeover
