// Bits in arrays of words: counting and finding them.
//
//     std::vector<std::uint64_t> words{0b1010};
//     count_bits(words);                                                       // 2
//     next_bit(words, 2, 0);                                                   // 3
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

/// The first place from `place` on whose bit is set after an exclusive or with `flip`; a place
/// beyond all words if there is none.
[[nodiscard]] inline std::uint64_t next_bit(std::span<const std::uint64_t> words,
                                            std::uint64_t place, std::uint64_t flip) {
  for (auto w = static_cast<std::size_t>(place / 64); w < words.size(); ++w, place = w * 64) {
    if (const std::uint64_t bits = (words[w] ^ flip) >> place % 64; bits != 0) {
      return place + static_cast<std::uint64_t>(std::countr_zero(bits));
    }
  }
  return std::uint64_t{words.size()} * 64;
}

}  // namespace changeover
