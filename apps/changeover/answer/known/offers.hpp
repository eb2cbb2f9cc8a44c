// What constructions offer for parameters, and the answer where nothing serves them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "answer/answer.hpp"
#include "changeover/construct/registry.hpp"

namespace changeover::cli {

/// The best that is known of some parameters, by construct/best_known.hpp with the standard
/// registry.
[[nodiscard]] std::optional<Offer> best_known(const Parameters& p);

/// The best offer over some kinds, circular before linear among equals; `construction` is the only
/// one that is asked, or empty. @throws UsageError if no construction has that name.
[[nodiscard]] std::optional<Offer> best_offer(const std::vector<Parameters>& asked,
                                              const std::string& construction);

/// What is known of parameters that nothing serves: why no design exists, or the lower bound, what
/// is near, what would help.
[[nodiscard]] Answer decline(const std::vector<Parameters>& asked, const std::string& construction,
                             const OutputRequest& output);

}  // namespace changeover::cli
