#include "core/bit_number.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <random>

namespace changeover::bit_number_test {
namespace {

TEST(NumberOfBits, IsThatOfTheLibrary) {
  std::mt19937_64 random(6);
  for (int place = 0; place < 64; ++place) {
    const std::uint64_t bit = std::uint64_t{1} << place;
    EXPECT_EQ(number_of_bits(bit), 1U) << place;
    EXPECT_EQ(number_of_bits(bit - 1), static_cast<std::uint32_t>(place));
    EXPECT_EQ(number_of_bits(~bit), 63U) << place;
  }
  EXPECT_EQ(number_of_bits(~std::uint64_t{0}), 64U);
  for (int round = 0; round < 1000; ++round) {
    const std::uint64_t word = random() & random();
    EXPECT_EQ(number_of_bits(word), static_cast<std::uint32_t>(std::popcount(word))) << word;
  }
}

}  // namespace
}  // namespace changeover::bit_number_test
