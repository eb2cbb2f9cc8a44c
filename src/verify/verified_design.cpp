#include "changeover/verify/verdict.hpp"

#include <fmt/format.h>

#include "changeover/core/error.hpp"

namespace changeover {

std::optional<VerifiedDesign> verified(Design design) {
  Verdict verdict = verify(design);
  if (!verdict.valid()) {
    return std::nullopt;
  }
  return VerifiedDesign(std::move(design), std::move(verdict));
}

VerifiedDesign surely_verified(Design design, std::string_view what) {
  if (auto checked = verified(std::move(design))) {
    return *std::move(checked);
  }
  throw InternalError(fmt::format("{} fails verification", what));
}

}  // namespace changeover
