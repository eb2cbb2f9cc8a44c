// Parameters that a file and its reader's caller declare, and what they come to together.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "changeover/core/parameters.hpp"
#include "changeover/io/input.hpp"
#include "io/scan/place.hpp"

namespace changeover {

/// Notes that a file says key = text, for the keys v, k, change, kind and strength; other keys mean
/// nothing. Returns what is wrong with it, if anything.
[[nodiscard]] std::optional<std::string> declare(ReadOptions& found, std::string_view key,
                                                 std::string_view text);

/// What is declared, and which part of it by the caller.
struct Declared : ReadOptions {
  ReadOptions by_caller = {};
};

/// What the caller says, and else what the file says. @throws BadOption if what the caller says can
/// be true of no file.
[[nodiscard]] Declared merged(const std::string& name, const ReadOptions& caller,
                              const ReadOptions& file);

/// What merged() declares, completed: v and k are known by now, `first_change` is the number of
/// elements in which the first two blocks differ, 0 if that says nothing.
/// @throws BadInput at `place` if no blocks with these parameters can be written down; BadOption if
/// that comes from what the caller declared.
[[nodiscard]] Parameters completed(const std::string& name, Place place, const Declared& declared,
                                   std::uint64_t v, std::uint64_t k, std::uint64_t first_change);

/// What is wrong with a list of labels for v elements, if v is declared.
[[nodiscard]] std::optional<std::string> label_count_defect(std::size_t labels,
                                                            const ReadOptions& declared);

/// A message if the input begins like one of our tables for people rather than like a design.
[[nodiscard]] std::optional<std::string> table_defect(std::string_view beginning);

/// Whether every word outside comments is a plain number; the last one may be cut off.
[[nodiscard]] bool only_numbers(std::string_view beginning);

/// What to say when there are no blocks.
inline constexpr std::string_view no_blocks =
    "no blocks; give one block a line, its elements separated by blanks";

/// Block `number` (from 1) has `size` elements instead of `k`.
[[nodiscard]] std::string size_defect(std::uint64_t number, std::uint64_t size, std::uint64_t k,
                                      bool declared);
[[nodiscard]] std::string surplus_defect(std::uint64_t number, std::uint64_t k, bool declared);
[[nodiscard]] std::string repeat_defect(std::uint64_t number, std::string_view word);
[[nodiscard]] std::string above_v_defect(std::string_view word, std::uint64_t v);
[[nodiscard]] std::string unknown_label_defect(std::string_view word);
[[nodiscard]] std::string too_many_defect(std::string_view word, std::optional<std::uint64_t> v);

}  // namespace changeover
