#include "io/scan/base64.hpp"

#include <cstdint>

namespace changeover {
namespace {

constexpr std::string_view base64_letters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr unsigned bits_of_letter = 6;
constexpr unsigned bits_of_byte = 8;

}  // namespace

std::string base64_of(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  std::uint32_t held = 0;
  unsigned bits = 0;
  for (const char byte : bytes) {
    held = held << bits_of_byte | static_cast<unsigned char>(byte);
    bits += bits_of_byte;
    while (bits >= bits_of_letter) {
      bits -= bits_of_letter;
      text += base64_letters[held >> bits & 63U];
    }
    held &= (1U << bits) - 1;
  }
  if (bits > 0) {
    text += base64_letters[held << (bits_of_letter - bits) & 63U];
  }
  text.append((4 - text.size() % 4) % 4, '=');
  return text;
}

std::optional<std::string> from_base64(std::string_view text) {
  if (text.size() % 4 == 0) {
    text.remove_suffix(text.ends_with("==") ? 2 : text.ends_with('=') ? 1 : 0);
  }
  if (text.size() % 4 == 1) {
    return std::nullopt;
  }
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t held = 0;
  unsigned bits = 0;
  for (const char letter : text) {
    const std::size_t value = base64_letters.find(letter);
    if (value == std::string_view::npos) {
      return std::nullopt;
    }
    held = held << bits_of_letter | static_cast<std::uint32_t>(value);
    bits += bits_of_letter;
    if (bits >= bits_of_byte) {
      bits -= bits_of_byte;
      bytes += static_cast<char>(held >> bits & 255U);
      held &= (1U << bits) - 1;
    }
  }
  return held == 0 ? std::optional(bytes) : std::nullopt;
}

}  // namespace changeover
