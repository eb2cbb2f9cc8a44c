// A design that was verified: whoever is handed one need not do it again.
//
//     if (const auto found = verified(std::move(design))) {
//       found->block_count();                 // as of the design
//       found->verdict().tight();
//       const Design& blocks = *found;        // to read; a copy can be changed, and is no longer verified
//     }
//
// Only the functions below make one, and they read the blocks.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "changeover/verify/verdict.hpp"

namespace changeover {

class VerifiedDesign {
 public:
  [[nodiscard]] const Design& design() const { return design_; }
  // NOLINTNEXTLINE(google-explicit-constructor): a verified design is a design
  operator const Design&() const { return design_; }
  /// To be changed, and no longer verified.
  [[nodiscard]] Design take() && { return std::move(design_); }

  [[nodiscard]] const Verdict& verdict() const { return verdict_; }

  [[nodiscard]] const Parameters& parameters() const { return design_.parameters(); }
  [[nodiscard]] std::size_t block_count() const { return design_.block_count(); }
  [[nodiscard]] std::span<const Element> block(std::size_t index) const {
    return design_.block(index);
  }
  [[nodiscard]] std::vector<Block> blocks() const { return design_.blocks(); }
  [[nodiscard]] const std::vector<std::string>& labels() const { return design_.labels(); }
  [[nodiscard]] const std::optional<Recipe>& recipe() const { return design_.recipe; }
  /// Says how the blocks were made, which changes none.
  void set_recipe(Recipe recipe) { design_.recipe = std::move(recipe); }

 private:
  friend std::optional<VerifiedDesign> verified(Design design);
  VerifiedDesign(Design design, Verdict verdict)
      : design_(std::move(design)), verdict_(std::move(verdict)) {}

  Design design_;
  Verdict verdict_;
};

/// The design, if its blocks say that it is one. Listens as verify(). @throws as verify().
[[nodiscard]] std::optional<VerifiedDesign> verified(Design design);

/// The same where there is no doubt. `what` names it, as in "a repaired DCCD(60,5)".
/// @throws InternalError if it is none.
[[nodiscard]] VerifiedDesign surely_verified(Design design, std::string_view what);

}  // namespace changeover
