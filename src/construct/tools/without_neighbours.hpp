// Families that leave out neighbours of the tight circular SCCD(2cK+1, k), K = k−1: v = 2cK+1−r, 0 < r < 2K.
//
//     class ClosedUp final : public WithoutNeighbours { … };  // says which it serves, what it saves, and the steps
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "construct/entry.hpp"
#include "construct/tools/swaps.hpp"
#include "core/checked.hpp"

namespace changeover {

/// r elements fewer than the tight design with c base blocks has.
struct Deletion {
  std::uint64_t c = 0;
  std::uint64_t r = 0;
};

class WithoutNeighbours : public Family {
 protected:
  using Family::Family;

  /// r > 0; k ≥ 3.
  [[nodiscard]] virtual bool serves(std::uint64_t k, const Deletion& deletion) const = 0;
  /// How many blocks fewer than the tight design.
  [[nodiscard]] virtual std::uint64_t saved(const Deletion& deletion) const = 0;
  [[nodiscard]] virtual std::unique_ptr<SwapPlan> steps(std::uint64_t k,
                                                        const Deletion& deletion) const = 0;
  [[nodiscard]] virtual std::string explanation(const Parameters& p,
                                                const Deletion& deletion) const = 0;

 private:
  [[nodiscard]] std::optional<Deletion> deletion_of(const Parameters& p) const {
    if (!asks_for_pairs(p, 1) || p.k < 3 || p.v <= 2 * p.k) {
      return std::nullopt;
    }
    const std::uint64_t around = 2 * (p.k - 1);
    const Deletion deletion{(p.v - 2) / around + 1, around - 1 - (p.v - 2) % around};
    return deletion.r > 0 && serves(p.k, deletion) ? std::optional(deletion) : std::nullopt;
  }

  [[nodiscard]] std::uint64_t block_count(const Parameters& p, const Deletion& deletion) const {
    return checked_multiply(deletion.c, p.v + deletion.r) - saved(deletion);
  }

  [[nodiscard]] std::optional<Promise> promise(const Parameters& p) const final {
    const auto deletion = deletion_of(p);
    return deletion ? std::optional(Promise{.b = block_count(p, *deletion)}) : std::nullopt;
  }

  [[nodiscard]] std::unique_ptr<BlockSource> blocks(const Parameters& p) const final {
    const Deletion deletion = deletion_of(p).value();
    return std::make_unique<SwapSource>(p, block_count(p, deletion), steps(p.k, deletion));
  }

  [[nodiscard]] std::string explanation(const Parameters& p) const final {
    return explanation(p, deletion_of(p).value());
  }
};

}  // namespace changeover
