// The words of blocks and the elements that they stand for.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/parameters.hpp"

namespace changeover {

inline constexpr std::size_t max_token_bytes = 255;

/// The value of a plain decimal: digits without a needless leading zero, at most 19 of them; longer
/// ones give the largest value. nullopt for any other word.
[[nodiscard]] std::optional<std::uint64_t> plain_number(std::string_view word);

/// Why an element of a file cannot have this name: label_defect(), or it is too long.
[[nodiscard]] std::optional<std::string> word_defect(std::string_view label);

/// Numbers each new word as it comes: 0, 1, 2, … Small plain numbers are found by one array access.
class TokenTable {
 public:
  static constexpr Element none = 0xFFFFFFFF;
  /// not a small number: number() does not take it
  static constexpr std::uint32_t not_small = 65'535;

  /// The element that the plain number n ≤ not_small stands for.
  [[nodiscard]] Element number(std::uint32_t n) const {
    return n < by_number_.size() ? by_number_[n] : none;
  }

  /// The element that `word` stands for, or none.
  [[nodiscard]] Element find(std::string_view word) const;

  /// Gives a new word the next element.
  Element add(std::string_view word);

  /// Lets 0, …, v−1 stand for themselves.
  void add_numbers(std::uint64_t v);

  /// The words given to add(), in that order.
  [[nodiscard]] const std::vector<std::string>& words() const { return words_; }
  [[nodiscard]] std::size_t size() const { return words_.size(); }

  /// Lets what stood for i stand for elements[i] from now on. words() keeps its order.
  void renumber(std::span<const Element> elements);

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const {
      return std::hash<std::string_view>()(text);
    }
  };
  std::vector<Element> by_number_;  // as long as the largest number needs
  std::unordered_map<std::string, Element, Hash, std::equal_to<>> by_word_;
  std::vector<std::string> words_;
};

/// The element set that words make if it is not declared.
struct ElementSet {
  std::vector<Element> element_of;  ///< by position among the words
  std::vector<std::string> labels;  ///< empty if the words are exactly 0, …, n−1
};

/// Makes it from distinct words: in increasing order if all are numbers, otherwise in their order.
[[nodiscard]] ElementSet element_set(std::span<const std::string> words);

/// Completes labels to v of them, with numbers from v upwards.
void fill_labels(std::vector<std::string>& labels, std::uint64_t v);

}  // namespace changeover
