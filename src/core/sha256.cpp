#include "changeover/core/sha256.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace changeover {
namespace {

// The first 32 bits behind the point of the cube roots of the first 64 primes.
constexpr std::array<std::uint32_t, 64> roots = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

constexpr std::string_view digits = "0123456789abcdef";

}  // namespace

void Sha256::mix(const std::uint8_t* block) {
  std::array<std::uint32_t, 64> w;
  for (std::size_t i = 0; i < 16; ++i) {
    const std::uint8_t* byte = block + 4 * i;
    w[i] = std::uint32_t{byte[0]} << 24 | std::uint32_t{byte[1]} << 16 |
           std::uint32_t{byte[2]} << 8 | std::uint32_t{byte[3]};
  }
  for (std::size_t i = 16; i < 64; ++i) {
    const std::uint32_t x = w[i - 15];
    const std::uint32_t y = w[i - 2];
    w[i] = w[i - 16] + (std::rotr(x, 7) ^ std::rotr(x, 18) ^ x >> 3) + w[i - 7] +
           (std::rotr(y, 17) ^ std::rotr(y, 19) ^ y >> 10);
  }
  auto [a, b, c, d, e, f, g, h] = state_;
  for (std::size_t i = 0; i < 64; ++i) {
    const std::uint32_t one = h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) +
                              ((e & f) ^ (~e & g)) + roots[i] + w[i];
    const std::uint32_t two =
        (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
    h = g;
    g = f;
    f = e;
    e = d + one;
    d = c;
    c = b;
    b = a;
    a = one + two;
  }
  const std::array<std::uint32_t, 8> mixed = {a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < mixed.size(); ++i) {
    state_[i] += mixed[i];
  }
}

void Sha256::add(const void* bytes, std::size_t count) {
  const auto* from = static_cast<const std::uint8_t*>(bytes);
  std::size_t held = static_cast<std::size_t>(count_ % block_.size());
  count_ += count;
  while (count > 0) {
    if (held == 0 && count >= block_.size()) {
      mix(from);
      from += block_.size();
      count -= block_.size();
      continue;
    }
    const std::size_t taken = std::min(count, block_.size() - held);
    std::memcpy(block_.data() + held, from, taken);
    held += taken;
    from += taken;
    count -= taken;
    if (held == block_.size()) {
      mix(block_.data());
      held = 0;
    }
  }
}

Checksum Sha256::finish() {
  const std::uint64_t bits = count_ * 8;
  // A one, zeros up to 8 bytes before the end of a block, and the length.
  const std::array<std::uint8_t, 64> padding = {0x80};
  const std::size_t held = static_cast<std::size_t>(count_ % block_.size());
  add(padding.data(), held < 56 ? 56 - held : 120 - held);
  std::array<std::uint8_t, 8> length;
  for (std::size_t i = 0; i < length.size(); ++i) {
    length[i] = static_cast<std::uint8_t>(bits >> (56 - 8 * i));
  }
  add(length.data(), length.size());
  Checksum checksum;
  for (std::size_t i = 0; i < checksum.size(); ++i) {
    checksum[i] = static_cast<std::uint8_t>(state_[i / 4] >> (24 - 8 * (i % 4)));
  }
  return checksum;
}

Checksum sha256(std::string_view text) {
  Sha256 hash;
  hash.add(text);
  return hash.finish();
}

std::string to_hex(const Checksum& checksum) {
  std::string text;
  for (const std::uint8_t byte : checksum) {
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

std::optional<Checksum> checksum_from_hex(std::string_view text) {
  Checksum checksum;
  if (text.size() != 2 * checksum.size()) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t digit = digits.find(text[i]);
    if (digit == std::string_view::npos) {
      return std::nullopt;
    }
    const auto high = static_cast<std::uint8_t>(i % 2 == 0 ? digit << 4 : checksum[i / 2]);
    checksum[i / 2] = static_cast<std::uint8_t>(i % 2 == 0 ? high : high | digit);
  }
  return checksum;
}

}  // namespace changeover
