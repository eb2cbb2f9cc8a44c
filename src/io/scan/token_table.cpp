#include "io/scan/token_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <unordered_set>

#include "changeover/core/design.hpp"

namespace changeover {

std::optional<std::uint64_t> plain_number(std::string_view word) {
  if (word.empty() || (word[0] == '0' && word.size() > 1)) {
    return std::nullopt;
  }
  std::uint64_t value = 0;
  for (const char c : word) {
    if (c < '0' || c > '9') {
      return std::nullopt;
    }
    value = 10 * value + static_cast<std::uint64_t>(c - '0');
  }
  return word.size() > 19 ? std::numeric_limits<std::uint64_t>::max() : value;
}

std::optional<std::string> word_defect(std::string_view label) {
  if (label.size() > max_token_bytes) {
    return fmt::format("a name of more than {} bytes; use shorter names", max_token_bytes);
  }
  return label_defect(label);
}

Element TokenTable::find(std::string_view word) const {
  if (const auto n = plain_number(word); n && *n < not_small) {
    return number(static_cast<std::uint32_t>(*n));
  }
  const auto found = by_word_.find(word);
  return found == by_word_.end() ? none : found->second;
}

Element TokenTable::add(std::string_view word) {
  const auto element = static_cast<Element>(words_.size());
  words_.emplace_back(word);
  if (const auto n = plain_number(word); n && *n < not_small) {
    const auto at = static_cast<std::size_t>(*n);
    if (at >= by_number_.size()) {
      by_number_.resize(std::max(at + 1, 2 * by_number_.size()), none);
    }
    by_number_[at] = element;
  } else {
    by_word_.emplace(std::string(word), element);
  }
  return element;
}

void TokenTable::add_numbers(std::uint64_t v) {
  by_number_.resize(static_cast<std::size_t>(v));
  std::iota(by_number_.begin(), by_number_.end(), Element{0});
}

void TokenTable::renumber(std::span<const Element> elements) {
  for (Element& element : by_number_) {
    element = element == none ? none : elements[element];
  }
  for (auto& [word, element] : by_word_) {
    element = elements[element];
  }
}

ElementSet element_set(std::span<const std::string> words) {
  ElementSet set;
  set.element_of.resize(words.size());
  std::iota(set.element_of.begin(), set.element_of.end(), Element{0});
  std::vector<std::pair<std::uint64_t, Element>> numbers;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto n = plain_number(words[i]);
    if (!n) {
      set.labels.assign(words.begin(), words.end());
      return set;
    }
    numbers.emplace_back(*n, static_cast<Element>(i));
  }
  // By value: there are no leading zeros, so a longer number is larger, also where a value does not
  // fit.
  std::sort(numbers.begin(), numbers.end(), [&](const auto& a, const auto& b) {
    const std::string& x = words[a.second];
    const std::string& y = words[b.second];
    return x.size() != y.size() ? x.size() < y.size() : x < y;
  });
  for (std::size_t rank = 0; rank < numbers.size(); ++rank) {
    set.element_of[numbers[rank].second] = static_cast<Element>(rank);
    set.labels.push_back(words[numbers[rank].second]);
  }
  if (numbers.empty() || numbers.back().first + 1 == numbers.size()) {
    set.labels.clear();
  }
  return set;
}

void fill_labels(std::vector<std::string>& labels, std::uint64_t v) {
  const std::unordered_set<std::string> taken(labels.begin(), labels.end());
  for (std::uint64_t n = v; labels.size() < v; ++n) {
    std::string name = std::to_string(n);
    if (!taken.contains(name)) {
      labels.push_back(std::move(name));
    }
  }
}

}  // namespace changeover
