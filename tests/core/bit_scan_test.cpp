#include "core/bit_scan.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace changeover::bit_scan_test {
namespace {

TEST(OrBits, SetsEachBitWhereItBelongsAndNoOther) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 500; ++round) {
    const std::uint64_t count = random() % 200;
    const std::uint64_t place = random() % 200;
    std::vector<std::uint64_t> from(count / 64 + 1);
    for (std::uint64_t& word : from) {
      word = random();
    }
    // No word more than is needed: a store behind the last bit would be seen by the sanitizer.
    std::vector<std::uint64_t> words((place + count + 63) / 64 + (place + count == 0 ? 1 : 0));
    std::vector<bool> expected(words.size() * 64);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      expected[i] = random() % 4 == 0;
      words[i / 64] |= static_cast<std::uint64_t>(expected[i]) << (i % 64);
    }
    for (std::uint64_t i = 0; i < count; ++i) {
      expected[place + i] = expected[place + i] || (from[i / 64] >> (i % 64) & 1) != 0;
    }
    or_bits(words, place, from, count);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_EQ((words[i / 64] >> (i % 64) & 1) != 0, expected[i]) << place << " " << count;
    }
  }
}

TEST(NextBit, FindsEveryBitInOrderAndThenNone) {
  std::mt19937_64 random(4);
  for (int round = 0; round < 200; ++round) {
    std::vector<std::uint64_t> words(random() % 4);
    std::vector<std::uint64_t> expected;
    const std::uint64_t flip = round % 2 == 0 ? 0 : ~std::uint64_t{0};
    for (std::size_t w = 0; w < words.size(); ++w) {
      words[w] = random() & random() & (random() % 3 == 0 ? 0 : ~std::uint64_t{0});
      for (std::uint64_t i = 0; i < 64; ++i) {
        if (((words[w] ^ flip) >> i & 1) != 0) {
          expected.push_back(w * 64 + i);
        }
      }
    }
    std::vector<std::uint64_t> found;
    for (std::uint64_t r = next_bit(words, 0, flip); r < words.size() * 64;
         r = next_bit(words, r + 1, flip)) {
      found.push_back(r);
    }
    ASSERT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace changeover::bit_scan_test
