// The parameters of designs that verbs ask about or read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/core/parameters.hpp"
#include "changeover/io/input.hpp"
#include "cli/cli.hpp"

namespace changeover::cli {

/// [--circular | --linear], with what each means in the help.
void add_kind_to(Verb& verb, std::optional<Kind>& kind, const std::string& circular,
                 const std::string& linear);

/// The strength that was named, in range; 2 if none was. @throws UsageError.
[[nodiscard]] std::uint32_t strength_of(std::optional<std::uint64_t> named);

/// The kinds that may answer: the named one, or circular and linear.
[[nodiscard]] std::vector<Kind> kinds_of(std::optional<Kind> named);

/// The number that a text is; nothing for any other text, and for what is too large.
[[nodiscard]] std::optional<std::uint64_t> whole_number(const std::string& text);

/// What `without` of ParameterRequest::add_to() says where known designs of both kinds are looked
/// up and the better one is taken.
inline constexpr const char* better_kind =
    "default: the kind with fewer blocks known, circular if equal";
inline constexpr const char* linear_kind = "default";

/// [V K] [--change M] [--strength T] [--circular | --linear]: what a verb does not offer stays
/// empty.
struct ParameterRequest {
  std::optional<std::uint64_t> v;
  std::optional<std::uint64_t> k;
  std::optional<std::uint64_t> change;
  std::optional<std::uint64_t> strength;
  std::optional<Kind> kind;

  /// V K [--change M] [--circular | --linear], V and K required. `without` says what holds without
  /// a kind.
  void add_to(Verb& verb, bool required, const std::string& without);

  /// LABEL | V K, as they are typed, with what is said after V K.
  void add_beside_label_to(Verb& verb, std::string& what, std::string& k_typed);

  /// Refuses what stands beside a label that says it itself. @throws UsageError.
  void refuse_beside_label(const std::string& label) const;

  /// [--strength T].
  void add_strength_to(Verb& verb);

  /// What is asked of one kind. @throws UsageError, ImpossibleParameters.
  [[nodiscard]] Parameters of_kind(Kind one) const;
  /// The same, of the named kind or else `usual`.
  [[nodiscard]] Parameters of_one_kind(Kind usual) const { return of_kind(kind.value_or(usual)); }
  /// What is asked, once for each kind that may answer.
  [[nodiscard]] std::vector<Parameters> of_each_kind() const;
  /// The same with V and K as they were typed, where a label could stand for both.
  [[nodiscard]] std::vector<Parameters> of_each_kind(const std::string& v_typed,
                                                     const std::string& k_typed) const;

  /// As they are declared to the reader of a design. @throws UsageError.
  [[nodiscard]] ReadOptions reading() const;
};

// Ranges of whole numbers on the command line.

struct Range {
  std::uint64_t from = 0;
  std::uint64_t to = 0;
};

/// "A..B", "..B" (from `least`) or "A". @throws UsageError that names the option if it is none, or
/// empty.
[[nodiscard]] Range range_of(const std::string& option, const std::string& text,
                             std::uint64_t least);

}  // namespace changeover::cli
