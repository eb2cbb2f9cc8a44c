// Bits in arrays of words: counting and listing them.
//
//     std::vector<std::uint64_t> words{0b1010};
//     count_bits(words);                                                       // 2
//     for_each_bit(words, 0, 64, 10, [&](std::uint64_t place) { seen.push_back(place); });  // 1, 3
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace changeover {

/// The number of bits that are set.
[[nodiscard]] inline std::uint64_t count_bits(std::span<const std::uint64_t> words) {
  std::uint64_t count = 0;
  for (const std::uint64_t word : words) {
    count += static_cast<std::uint64_t>(std::popcount(word));
  }
  return count;
}

/// Sets the bits `place` + i of `words` for every i < `count` that is set in `from`. O(count / 64).
inline void or_bits(std::span<std::uint64_t> words, std::uint64_t place,
                    std::span<const std::uint64_t> from, std::uint64_t count) {
  const std::uint64_t shift = place % 64;
  std::uint64_t* const into = words.data() + place / 64;
  std::size_t w = 0;
  const auto put = [&](std::uint64_t bits) {
    into[w] |= bits << shift;
    // The rest is in the next word, which exists if there is a bit for it.
    if (const std::uint64_t rest = shift == 0 ? 0 : bits >> (64 - shift); rest != 0) {
      into[w + 1] |= rest;
    }
  };
  for (; w < count / 64; ++w) {
    put(from[w]);
  }
  if (count % 64 != 0) {
    put(from[w] & ((std::uint64_t{1} << count % 64) - 1));
  }
}

/// Calls visit(place) for up to `limit` of the places below `total` whose bit, after an exclusive or with
/// `flip`, is set; in increasing order. O(words + places visited).
template <typename Visit>
void for_each_bit(std::span<const std::uint64_t> words, std::uint64_t flip, std::uint64_t total,
                  std::uint64_t limit, Visit&& visit) {
  for (std::size_t w = 0; w < words.size() && limit > 0; ++w) {
    for (std::uint64_t bits = words[w] ^ flip; bits != 0 && limit > 0; bits &= bits - 1) {
      const std::uint64_t place = w * 64 + static_cast<std::uint64_t>(std::countr_zero(bits));
      if (place >= total) {
        return;
      }
      visit(place);
      --limit;
    }
  }
}

}  // namespace changeover
