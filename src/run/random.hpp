// Random numbers that are the same everywhere, forever: xoshiro256** seeded by splitmix64.
//
//     Random random(7);
//     random.below(30);                     // 0 … 29
//     random.one_in_two();
//     Random other(7, 3);                   // a fourth stream of the same seed, for another thread
//
// Integer arithmetic only, no standard distribution: those differ between libraries. Not for
// secrets. Source of the generator: [BlackmanVigna2021].
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace changeover {

/// One step of splitmix64: advances `state` and returns a well mixed number.
[[nodiscard]] constexpr std::uint64_t splitmix64(std::uint64_t& state) {
  state += 0x9e3779b97f4a7c15ULL;
  std::uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// xoshiro256**, period 2²⁵⁶ − 1.
class Random {
 public:
  using State = std::array<std::uint64_t, 4>;

  /// Streams of one seed with different numbers are independent.
  explicit constexpr Random(std::uint64_t seed, std::uint64_t stream = 0) {
    std::uint64_t mixed = seed;
    mixed = splitmix64(mixed) ^ (stream * 0xd1342543de82ef95ULL);
    for (std::uint64_t& word : state_) {
      word = splitmix64(mixed);
    }
  }

  /// Continues from a state() taken before. At least one word must not be 0.
  explicit constexpr Random(const State& state) : state_(state) {}

  /// The state, which determines all later numbers.
  [[nodiscard]] constexpr const State& state() const { return state_; }

  /// 64 random bits.
  constexpr std::uint64_t next() {
    const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
    const std::uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = std::rotl(state_[3], 45);
    return result;
  }

  /// 32 random bits.
  constexpr std::uint32_t next32() { return static_cast<std::uint32_t>(next() >> 32); }

  /// A number below `limit`, 0 if limit is 0. The bias is below limit / 2³².
  constexpr std::uint32_t below(std::uint32_t limit) {
    return static_cast<std::uint32_t>((std::uint64_t{next32()} * limit) >> 32);
  }

  /// True or false, each as likely.
  constexpr bool one_in_two() { return (next() >> 63) != 0; }

 private:
  State state_{};
};

/// Puts the members of a vector in a random order.
template <typename List>
constexpr void shuffle(List& list, Random& random) {
  for (std::size_t i = list.size(); i > 1; --i) {
    std::swap(list[i - 1], list[random.below(static_cast<std::uint32_t>(i))]);
  }
}

}  // namespace changeover
