// Base blocks developed into a stream: B₀, …, B_{c−1}, π(B₀), …, π(B_{c−1}), …, π^{n−1}(B_{c−1}).
//
//     DevelopedSource source({{.v = 11, .k = 4, .kind = Kind::circular}, {{0, 1, 2, 5}}});   // over Z_v
//
// Memory is that of the base blocks; the list has cn blocks, over Z_v cv.
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/core/automorphism.hpp"
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

/// The development of base blocks as a stream.
class DevelopedSource final : public BlockSource {
 public:
  /// @throws BadInput unless there is a base block and each has k elements below v.
  explicit DevelopedSource(BaseBlocks base);

  /// The same under π^shift, shift < n, instead of x ↦ x + 1. pi.v() must be the v of the base blocks.
  DevelopedSource(BaseBlocks base, const Automorphism& pi, std::uint64_t shift = 1);

  [[nodiscard]] const Parameters& parameters() const override { return base_.parameters; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override { return block_count_; }
  std::span<const Element> read(std::span<Element> room) override;
  bool rewind() override {
    which_ = 0;
    times_ = power_ = 0;
    return true;
  }

  [[nodiscard]] const BaseBlocks& base() const { return base_; }

 private:
  BaseBlocks base_;
  Automorphism pi_;
  std::uint64_t shift_;
  std::uint64_t block_count_;
  std::size_t which_ = 0;
  std::uint64_t times_ = 0;  // that the base blocks were handed out
  std::uint64_t power_ = 0;  // times · shift, modulo n
};

}  // namespace changeover
