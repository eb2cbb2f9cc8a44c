// Internal: sets of items with close numbers, stored in words.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

/// A set in words of 64 bits, so that many close elements share a word. Only non-empty words are
/// kept, sorted. O(words) to add a word, O(log words) if it exists.
class WordSet {
 public:
  using Word = std::pair<std::uint32_t, std::uint64_t>;  // the elements 64 · first + bit

  void insert(Element x) { insert(Word(x / 64, std::uint64_t{1} << x % 64)); }
  void insert(const Word& word);
  void erase(Element x);
  void clear() { words_.clear(); }

  [[nodiscard]] const std::vector<Word>& words() const { return words_; }
  /// In order.
  template <typename Visit>
  void for_each(Visit&& visit) const {
    for (const auto& [word, bits] : words_) {
      for (std::uint64_t rest = bits; rest != 0; rest &= rest - 1) {
        visit(64 * word + static_cast<Element>(std::countr_zero(rest)));
      }
    }
  }

 private:
  std::vector<Word> words_;
};

inline void WordSet::insert(const Word& word) {
  const auto at = std::ranges::lower_bound(words_, Word(word.first, 0));
  if (at != words_.end() && at->first == word.first) {
    at->second |= word.second;
  } else {
    words_.insert(at, word);
  }
}

inline void WordSet::erase(Element x) {
  const auto at = std::ranges::lower_bound(words_, Word(x / 64, 0));
  if (at == words_.end() || at->first != x / 64) {
    return;
  }
  at->second &= ~(std::uint64_t{1} << x % 64);
  if (at->second == 0) {
    words_.erase(at);
  }
}

}  // namespace changeover
