// The one inserter of the recursions: a stream that copies another one and adds blocks at chosen
// positions, before the first block (0), after the i-th (i), or after the last (b).
//
//     class Beside final : public InsertingSource {  // U ∪ {x} at the position of each subset U
//      …
//       std::uint64_t position(std::uint64_t i) const override { return set_[i].position; }
//       Insertion insertion(std::uint64_t i, const Place&) override {
//         return {set_[i].elements, {x_}};
//       }
//     };
//
// Subclasses describe what is inserted, one insertion after another; the inserter reads, counts and
// rewinds. It holds the blocks beside a position and one description.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

class InsertingSource : public BlockSource {
 public:
  [[nodiscard]] const Parameters& parameters() const final { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const final;
  std::span<const Element> read(std::span<Element> room) final;
  bool rewind() final;

 protected:
  /// The blocks beside a position. Empty: there is none, at an end of a linear design.
  struct Place {
    std::span<const Element> before;
    std::span<const Element> after;  ///< of a circular design, behind its last block, the first one
  };

  /// Blocks that have `kept` in common: each of them is that and the next k − |kept| of `others`.
  struct Insertion {
    std::span<const Element> kept;  ///< has to stay until the next insertion is asked for
    std::vector<Element> others;
    bool unfinished = false;  ///< the rest of them follows: the same insertion is asked for again
  };

  /// How many insertions there are, and how many blocks they make in all.
  struct Amount {
    std::uint64_t insertions = 0;
    std::uint64_t blocks = 0;
  };

  /// @param larger the parameters with the new elements; k is that of the source.
  InsertingSource(std::unique_ptr<BlockSource>&& source, const Parameters& larger, Amount amount);

  /// Where the i-th insertion is, i = 0, 1, …; the positions do not decrease.
  [[nodiscard]] virtual std::uint64_t position(std::uint64_t i) const = 0;

  /// What is inserted there. Asked in turn, and from 0 again after rewind(). @throws BadInput if
  /// nothing can be inserted at this place.
  [[nodiscard]] virtual Insertion insertion(std::uint64_t i, const Place& place) = 0;

 private:
  bool make(std::span<Element> block);
  bool read_one(std::span<Element> block);
  [[nodiscard]] bool is_chosen(std::uint64_t position) const;

  std::unique_ptr<BlockSource> source_;
  Parameters parameters_;
  Amount amount_;
  bool circular_;

  std::uint64_t read_ = 0;           // blocks handed on from the source: the position
  std::uint64_t begun_ = 0;          // insertions
  Insertion insertion_;              // the last that was begun
  std::size_t given_ = 0;            // of its others
  Block first_;                      // of the source
  Block before_;                     // the last block handed on, if its position is chosen
  std::optional<Block> read_ahead_;  // what follows it, empty at the end
};

}  // namespace changeover
