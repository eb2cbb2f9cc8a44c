// Base blocks over Z_v developed into a stream: B₀, …, B_{c−1}, B₀+1, …, B_{c−1}+1, …, B_{c−1}+(v−1).
//
//     DevelopedSource source({{.v = 11, .k = 4, .kind = Kind::circular}, {{0, 1, 2, 5}}});
//
// Memory is that of the base blocks; the list has cv blocks.
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

/// A circular design given by base blocks over Z_v.
struct BaseBlocks {
  Parameters parameters;
  std::vector<Block> blocks;

  /// The number of blocks of the developed design, c·v. @throws ImpossibleParameters on overflow.
  [[nodiscard]] std::uint64_t block_count() const;

  bool operator==(const BaseBlocks&) const = default;
};

/// The development of base blocks over Z_v as a stream.
class DevelopedSource final : public BlockSource {
 public:
  /// @throws BadInput unless there is a base block and each has k elements below v.
  explicit DevelopedSource(BaseBlocks base);

  [[nodiscard]] const Parameters& parameters() const override { return base_.parameters; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return base_.block_count();
  }
  std::span<const Element> read(std::span<Element> room) override;
  bool rewind() override {
    which_ = 0;
    shift_ = 0;
    return true;
  }

  [[nodiscard]] const BaseBlocks& base() const { return base_; }

 private:
  BaseBlocks base_;
  std::size_t which_ = 0;
  std::uint64_t shift_ = 0;
};

}  // namespace changeover
