#include "changeover/core/parameters.hpp"

#include <fmt/format.h>

#include <limits>

#include "changeover/core/error.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"

namespace changeover {

std::string_view to_string(Kind kind) { return kind == Kind::circular ? "circular" : "linear"; }

std::optional<Kind> kind_from_string(std::string_view name) {
  return named(name, {Kind::linear, Kind::circular});
}

void check(const Parameters& p) {
  if (p.k < 1) {
    throw ImpossibleParameters("k = 0: a block needs at least one element");
  }
  if (p.k > p.v) {
    throw ImpossibleParameters(
        fmt::format("k = {} exceeds v = {}: a block is a subset of the v elements", p.k, p.v));
  }
  if (p.v > std::numeric_limits<std::uint32_t>::max()) {
    throw ImpossibleParameters(fmt::format("v = {} exceeds the limit of 2^32 - 1 elements", p.v));
  }
  if (p.change < 1 || p.change > p.k) {
    throw ImpossibleParameters(fmt::format(
        "change = {}: consecutive blocks must differ in 1 to k = {} elements", p.change, p.k));
  }
  if (p.strength < 2 || p.strength > max_strength) {
    throw ImpossibleParameters(
        fmt::format("strength = {}: it must be 2, 3 or {}", p.strength, max_strength));
  }
  if (p.strength > p.k) {
    throw ImpossibleParameters(fmt::format(
        "strength = {} exceeds k = {}: no block holds that many elements", p.strength, p.k));
  }
}

std::optional<std::string> impossibility(const Parameters& p) {
  check(p);
  if (p.v == p.k) {
    return std::nullopt;
  }
  if (p.v < p.k + p.change) {
    return fmt::format("a change of {} needs {} outside a block, so v >= k + m = {}",
                       count_of(p.change, "element"), count_of(p.change, "element"),
                       p.k + p.change);
  }
  if (p.v == 2 * p.k && p.change == p.k) {
    return "a block can be followed only by its complement, so just two blocks ever occur";
  }
  return std::nullopt;
}

std::string name(const Parameters& p, bool with_kind) {
  std::string text = with_kind ? fmt::format("{} ", to_string(p.kind)) : std::string();
  if (p.change == 1) {
    text += fmt::format("SCCD({},{})", p.v, p.k);
  } else if (p.change == 2) {
    text += fmt::format("DCCD({},{})", p.v, p.k);
  } else {
    text += fmt::format("{}-change covering design ({},{})", p.change, p.v, p.k);
  }
  if (p.strength != 2) {
    text += fmt::format(", t = {}", p.strength);
  }
  return text;
}

std::uint64_t newly_covered_at_most(const Parameters& p) {
  return binomial(p.k, p.strength) - binomial(p.k - p.change, p.strength);
}

}  // namespace changeover
