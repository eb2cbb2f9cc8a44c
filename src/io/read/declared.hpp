// Parameters that a file and the caller declare, and their merger.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/io/input.hpp"
#include "io/scan/place.hpp"
#include "io/scan/text_scanner.hpp"

namespace changeover {

/// Takes the next word of a text; empty at the end.
std::string_view next_word(std::string_view& words);

/// Records key = text of a file, for the keys v, k, change, kind and strength; ignores other keys.
/// Returns what is wrong with it, if anything.
[[nodiscard]] std::optional<std::string> declare(ReadOptions& found, std::string_view key,
                                                 std::string_view text);

/// Adds a label to those that a file has listed so far. Returns what is wrong with it, if anything.
[[nodiscard]] std::optional<std::string> add_label(TokenTable& labels, std::string_view label);

/// The declared parameters, and which of them the caller declared.
struct Declared : ReadOptions {
  ReadOptions by_caller = {};
};

/// The parameters of the caller, completed by those of the file. @throws BadOption if those of the
/// caller are impossible for any file.
[[nodiscard]] Declared merged(const std::string& name, const ReadOptions& caller,
                              const ReadOptions& file);

/// Completes the parameters of merged(): v and k are known by now, `first_change` is the number of
/// elements in which the first two blocks differ, 0 if that is not known.
/// @throws BadInput at `place` if no blocks with these parameters can be written down; BadOption if
/// that comes from what the caller declared.
[[nodiscard]] Parameters completed(const std::string& name, Place place, const Declared& declared,
                                   std::uint64_t v, std::uint64_t k, std::uint64_t first_change);

/// What is wrong with a list of labels for v elements, if v is declared.
[[nodiscard]] std::optional<std::string> label_count_defect(std::size_t labels,
                                                            const ReadOptions& declared);

/// A message if the input begins like one of our tables for people rather than like a design.
[[nodiscard]] std::optional<std::string> table_defect(std::string_view beginning);

/// Why a new word of blocks without a list of names is hardly an element: a bracket, the name of a
/// block in front of it, or a comment of another language.
[[nodiscard]] std::optional<std::string> loose_word_defect(std::string_view word, bool is_first);

/// Whether every word outside comments is a plain number; the last one may be cut off.
[[nodiscard]] bool only_numbers(std::string_view beginning);

/// The message if there are no blocks.
inline constexpr std::string_view no_blocks =
    "no blocks; give one block per line, its elements separated by blanks";

/// The message if block `number` (from 1) has `size` elements instead of `k`.
[[nodiscard]] std::string size_defect(std::uint64_t number, std::uint64_t size, std::uint64_t k,
                                      bool declared);
[[nodiscard]] std::string surplus_defect(std::uint64_t number, std::uint64_t k, bool declared);
[[nodiscard]] std::string repeat_defect(std::uint64_t number, std::string_view word);
[[nodiscard]] std::string above_v_defect(std::string_view word, std::uint64_t v);
[[nodiscard]] std::string unknown_label_defect(std::string_view word);
[[nodiscard]] std::string too_many_defect(std::string_view word, std::optional<std::uint64_t> v);

// Makes a design of blocks in memory, for formats that are not streamed.

/// Collects the words of blocks; their meaning is decided at the end, when all of them are known.
class Collector {
 public:
  /// Adds a word to the block; returns what is wrong with it, if anything. A quoted label has a '"'
  /// in front in formats where quotes make a difference.
  [[nodiscard]] std::optional<std::string> add(std::string_view word);

  /// Ends the block; returns what is wrong with its size, if anything.
  [[nodiscard]] std::optional<std::string> end_block();

  /// The number of words of the block that is being collected.
  [[nodiscard]] std::size_t block_size() const { return elements_.size() - block_start_; }

  /// What the rest of the file declares.
  struct Context {
    std::string name;
    Declared declared;
    std::optional<std::vector<std::string>> labels;  ///< valid and distinct
    Place labels_place;
    Place place;         ///< where the parameters are, or the beginning
    bool named = false;  ///< words are labels even if they are numbers
    std::function<Place(std::uint64_t word)> place_of_word;  ///< the i-th word of all, from 0
  };

  /// The design. @throws BadInput as io/input.hpp says.
  [[nodiscard]] Design finish(const Context& context);

 private:
  void settle(const Context& context);
  void refuse_repeats(const Context& context) const;

  TokenTable table_;
  std::vector<Element> elements_;  // first by word, after settle() by element
  std::size_t block_start_ = 0;
  std::uint64_t blocks_ = 0;
  std::size_t k_ = 0;
  std::uint64_t v_ = 0;
  std::vector<std::string> labels_;
};

}  // namespace changeover
