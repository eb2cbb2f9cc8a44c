// The parameters of a change covering design.
//
// An m-change covering design with parameters (v, k) is an ordered list of b blocks, each a
// k-subset of a v-set, such that every pair of elements lies in some block and consecutive blocks
// differ in exactly m elements; circular if the last and the first block do so too, linear
// otherwise. m = 1 is a single-change covering design (SCCD), m = 2 a double-change covering design
// (DCCD) [ChafeeStevens2025, Section 1]. With strength t, every t-subset lies in some block.
//
//     Parameters p{.v = 61, .k = 4, .change = 2, .kind = Kind::circular};
//     check(p);  // throws if no such list of blocks can be written down
//     auto g2 = newly_covered_at_most(p);    // 2k − 3 = 5 pairs a block
#pragma once

#if __cplusplus < 202002L
#error "the headers of changeover need C++20: compile with -std=c++20"
#endif

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace changeover {

/// Whether the first block follows the last one.
enum class Kind : std::uint8_t { linear, circular };

/// "linear" or "circular".
[[nodiscard]] std::string_view to_string(Kind kind);

/// The kind of that name; nullopt for any other word.
[[nodiscard]] std::optional<Kind> kind_from_string(std::string_view name);

/// The largest v of a design whose blocks are held in memory or read from a file.
inline constexpr std::uint64_t max_elements_in_memory = 65'535;

/// The largest strength t that verification supports.
inline constexpr std::uint32_t max_strength = 4;

/// Parameters of a change covering design. Plain numbers: nothing is checked until check().
struct Parameters {
  std::uint64_t v = 0;         ///< number of elements
  std::uint64_t k = 0;         ///< elements in a block
  std::uint64_t change = 2;    ///< elements in which consecutive blocks differ (m)
  Kind kind = Kind::linear;    ///< linear or circular
  std::uint32_t strength = 2;  ///< every subset of this size must lie in some block (t)

  auto operator<=>(const Parameters&) const = default;

  /// These parameters with another kind.
  [[nodiscard]] constexpr Parameters as(Kind other) const {
    return {v, k, change, other, strength};
  }
  /// These parameters with another number of elements.
  [[nodiscard]] constexpr Parameters on(std::uint64_t elements) const {
    return {elements, k, change, kind, strength};
  }
};

/// Checks that blocks with these parameters can be written down at all: 1 ≤ m ≤ k ≤ v < 2³²,
/// 2 ≤ t ≤ min(k, 4). @throws ImpossibleParameters with one line that names the number at fault.
void check(const Parameters& p);

/// Why no design with these parameters exists, in one line, when a short argument shows it; nullopt
/// otherwise, which claims nothing. v = k needs one block; otherwise a change needs m elements
/// outside a block, so v ≥ k + m; and with v = 2k and m = k only a block and its complement occur,
/// so no DCCD(4,2) exists. @throws as check().
[[nodiscard]] std::optional<std::string> impossibility(const Parameters& p);

/// "DCCD(61,4)", "circular SCCD(9,4)", "linear 3-change covering design (20,6)", with ", t = 3" if
/// the strength is not 2. The kind is named only if `with_kind`.
[[nodiscard]] std::string name(const Parameters& p, bool with_kind = true);

/// The most t-subsets that a block can newly cover after its predecessor: C(k,t) − C(k−m,t); for
/// pairs C(m,2) + m(k−m), that is k − 1 for m = 1 and 2k − 3 for m = 2 [ChafeeStevens2025, Thm 1].
[[nodiscard]] std::uint64_t newly_covered_at_most(const Parameters& p);

}  // namespace changeover
