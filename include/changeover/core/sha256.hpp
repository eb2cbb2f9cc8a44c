// SHA-256, used to recognise texts and results.
//
//     Sha256 hash;
//     hash.add("ab");
//     hash.add("c");
//     to_hex(hash.finish());       // "ba7816bf8f01cfea414140de5dae2223…", 64 digits
//
// Results that are changed, by accident or on purpose, have another checksum. It is not a
// signature: a person who can write both results and checksum can make them agree.
//
// Reference: Secure Hash Standard [FIPS180-4, Sec. 6.2].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace changeover {

using Checksum = std::array<std::uint8_t, 32>;

/// Takes bytes in any pieces.
class Sha256 {
 public:
  void add(const void* bytes, std::size_t count);
  void add(std::string_view text) { add(text.data(), text.size()); }
  void add(const Checksum& checksum) { add(checksum.data(), checksum.size()); }

  /// The checksum of all that was added; nothing may be added afterwards.
  [[nodiscard]] Checksum finish();

 private:
  void mix(const std::uint8_t* block);

  std::array<std::uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<std::uint8_t, 64> block_ = {};
  std::uint64_t count_ = 0;  // bytes
};

[[nodiscard]] Checksum sha256(std::string_view text);

/// 64 digits.
[[nodiscard]] std::string to_hex(const Checksum& checksum);

/// The checksum of 64 digits as to_hex() writes them; nothing for any other text.
[[nodiscard]] std::optional<Checksum> checksum_from_hex(std::string_view text);

}  // namespace changeover
