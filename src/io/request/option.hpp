// How the records of options are written.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "changeover/io/request.hpp"

namespace changeover {

/// The kind of value that a member of this type has if its record says nothing else.
template <typename Value>
constexpr ValueKind kind_of_member =
    std::is_same_v<Value, std::optional<std::uint64_t>> ? ValueKind::number
    : std::is_same_v<Value, std::optional<double>>      ? ValueKind::seconds
    : std::is_same_v<Value, bool>                       ? ValueKind::flag
    : std::is_same_v<Value, std::string>                ? ValueKind::text
    : std::is_same_v<Value, RequestList>                ? ValueKind::list
                                                        : ValueKind::names;

/// One option. Its flag is "--" and its key with hyphens, if `more` says nothing else.
///
/// @param value  the name of its value in the help; empty: it has none, or is one of some words
template <typename Request, typename Value>
[[nodiscard]] RequestOption<Request> option(std::string_view key, std::string_view value,
                                            std::string_view help, Value Request::*member,
                                            OptionRecord more = {}) {
  more.key = key;
  more.value = value;
  more.help = help;
  if (more.flags.empty()) {
    more.flags = "--" + std::string(key);
    std::ranges::replace(more.flags, '_', '-');
  }
  if (more.kind == ValueKind::flag) {
    more.kind = more.words.empty() ? kind_of_member<Value> : ValueKind::word;
  }
  return {std::move(more), member};
}

}  // namespace changeover
