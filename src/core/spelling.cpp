#include "core/spelling.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace changeover {
namespace {

// Letters to insert, drop, replace or swap with their neighbour.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before;
  std::vector<std::size_t> above(b.size() + 1);
  std::iota(above.begin(), above.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::vector<std::size_t> row(b.size() + 1, i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] =
          std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before = std::move(above);
    above = std::move(row);
  }
  return above[b.size()];
}

}  // namespace

std::optional<std::string> nearest_word(const std::string& word,
                                        const std::vector<std::string>& known) {
  constexpr std::size_t longest = 40;
  if (word.size() > longest) {
    return std::nullopt;
  }
  const std::string* nearest = nullptr;
  // One other letter in place of the only one is another word.
  std::size_t least = word.size() < 2 ? 1 : std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& each : known) {
    const bool begins = word.size() > 2 && each.starts_with(word);
    const std::size_t away = begins ? 1 : distance(word, each);
    if (away < least) {
      least = away;
      nearest = &each;
    }
  }
  return nearest == nullptr ? std::nullopt : std::optional(*nearest);
}

}  // namespace changeover
