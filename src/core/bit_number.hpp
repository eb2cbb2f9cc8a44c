// How many bits of a word are set. std::popcount() is a call into the compiler's library where the
// processor is not known to count bits; such calls took a fifth of the walks of Theorem 28.
//
//     number_of_bits(0b1011U);  // 3
#pragma once

#include <bit>
#include <cstdint>

namespace changeover {

[[nodiscard]] constexpr std::uint32_t number_of_bits(std::uint64_t word) {
#ifdef __POPCNT__
  return static_cast<std::uint32_t>(std::popcount(word));
#else
  // Each two bits hold how many of them were set, then each four, then each byte; the product's
  // highest byte is the sum of all bytes.
  word -= word >> 1U & 0x5555555555555555U;
  word = (word & 0x3333333333333333U) + (word >> 2U & 0x3333333333333333U);
  word = (word + (word >> 4U)) & 0x0F0F0F0F0F0F0F0FU;
  return static_cast<std::uint32_t>(word * 0x0101010101010101U >> 56U);
#endif
}

}  // namespace changeover
