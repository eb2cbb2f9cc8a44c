// What a query asks for.
//
//     const Parameters p = cell_of(request);          // ?v=20&k=5&change=2&kind=linear
//     const Range k = range_of(request, "k", {3, 8});
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/parameters.hpp"
#include "request/range.hpp"
#include "serve/http/message.hpp"

namespace changeover::serve {

/// @throws Refusal 400 if it is no whole number.
[[nodiscard]] std::optional<std::uint64_t> number_of(const Request& request, std::string_view name);
/// @throws Refusal 400 also if it is missing.
[[nodiscard]] std::uint64_t needed_number(const Request& request, std::string_view name);

/// The value, which is one of `words`; the first of them if it is missing. @throws Refusal 400
[[nodiscard]] std::string word_of(const Request& request, std::string_view name,
                                  const std::vector<std::string>& words);

/// "circular" or "linear", if one is named. @throws Refusal 400
[[nodiscard]] std::optional<Kind> kind_of(const Request& request);

/// v, k, change (2 if it is missing), strength (2) and kind, which must be there. @throws Refusal
/// 400, ImpossibleParameters
[[nodiscard]] Parameters cell_of(const Request& request);
/// The same for each kind that may answer: the named one, or circular and linear.
[[nodiscard]] std::vector<Parameters> cells_of(const Request& request);

/// "A..B" or "A". @throws Refusal 400
[[nodiscard]] cli::Range range_of(const Request& request, std::string_view name,
                                  const cli::Range& usual);

}  // namespace changeover::serve
