// What the constructions of minimum SCCD(v,k) of one k have in common: some designs are written
// down, and all others are extensions of them; see construct/expansion/single_change_extension.hpp.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "construct/entry.hpp"

namespace changeover::detail {

/// A design that is written down.
struct ListedMinimum {
  std::uint64_t v = 0;
  std::string_view blocks;     ///< see short_blocks.hpp
  bool expansion_set = false;  ///< it has one that lasts when it is extended
};

/// A construction with one recipe for each v and kind: the listed design of the largest v′ ≤ v, v′
/// ≡ v (mod 2(k−1)), extended as often as needed. Promises are read off the list.
class ExtendedMinima : public Family {
 public:
  std::optional<std::vector<UnchangedSubset>> expansion_set(
      const Recipe& recipe, const Registry& registry) const override;

 protected:
  /// @param linear, circular by increasing v; views of static storage
  ExtendedMinima(const Description& description, std::uint64_t k,
                 std::span<const ListedMinimum> linear, std::span<const ListedMinimum> circular)
      : Family(description), k_(k), linear_(linear), circular_(circular) {}

 private:
  [[nodiscard]] const ListedMinimum* listed_for(const Parameters& p) const;
  [[nodiscard]] std::optional<Promise> promise(const Parameters& p) const override;
  [[nodiscard]] std::unique_ptr<BlockSource> blocks(const Parameters& p) const override;
  [[nodiscard]] std::string explanation(const Parameters& p) const override;

  std::uint64_t k_;
  std::span<const ListedMinimum> linear_;
  std::span<const ListedMinimum> circular_;
};

}  // namespace changeover::detail
