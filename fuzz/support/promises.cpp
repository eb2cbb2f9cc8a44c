#include "support/promises.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace changeover::fuzz {
namespace {

// The length of the UTF-8 character at the front; 0 if there is none, or one that a terminal obeys.
// Shares nothing with src/core/printable.hpp, which made what is judged here.
std::size_t plain_character(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xc0U) == 0x80U; };
  const unsigned first = byte(0);
  if (first < 0x80) {
    return first >= 0x20 && first != 0x7f ? 1 : 0;
  }
  if (first >= 0xc2 && first < 0xe0 && follows(1)) {
    return first == 0xc2 && byte(1) < 0xa0 ? 0 : 2;
  }
  if ((first & 0xf0U) == 0xe0 && follows(1) && follows(2)) {
    const unsigned point = (first & 0xfU) << 12U | (byte(1) & 0x3fU) << 6U | (byte(2) & 0x3fU);
    const bool turns = (point >= 0x2028 && point <= 0x202e) || (point >= 0x2066 && point <= 0x2069);
    return point < 0x800 || (point >= 0xd800 && point < 0xe000) || turns ? 0 : 3;
  }
  if (first >= 0xf0 && first < 0xf5 && follows(1) && follows(2) && follows(3)) {
    const unsigned point = (first & 7U) << 18U | (byte(1) & 0x3fU) << 12U;
    return point < 0x10000 || point >= 0x110000 ? 0 : 4;
  }
  return 0;
}

bool is_plain_but_for(std::string_view text, std::string_view blanks) {
  while (!text.empty()) {
    const std::size_t bytes =
        blanks.find(text.front()) == std::string_view::npos ? plain_character(text) : 1;
    if (bytes == 0) {
      return false;
    }
    text.remove_prefix(bytes);
  }
  return true;
}

}  // namespace

bool is_one_plain_line(std::string_view text) {
  return !text.empty() && is_plain_but_for(text, "");
}

bool is_plain(std::string_view text) { return is_plain_but_for(text, "\n\t"); }

bool is_plain_json(const std::string& text) {
  return is_plain(text) && nlohmann::json::accept(text);
}

std::vector<std::string> parts_of(const std::string& bytes, std::size_t count) {
  constexpr std::string_view line = "----\n";
  std::vector<std::string> parts;
  std::size_t from = 0;
  while (parts.size() + 1 < count) {
    std::size_t at = bytes.find(line, from);
    while (at != std::string::npos && at != from && bytes[at - 1] != '\n') {
      at = bytes.find(line, at + 1);
    }
    if (at == std::string::npos) {
      break;
    }
    parts.push_back(bytes.substr(from, at - from));
    from = at + line.size();
  }
  parts.push_back(bytes.substr(from));
  parts.resize(count);
  return parts;
}

Scratch::Scratch() {
  path_ = (std::filesystem::temp_directory_path() / "changeover-fuzz-XXXXXX").string();
  if (::mkdtemp(path_.data()) == nullptr) {
    throw std::runtime_error("no temporary folder");
  }
}

Scratch::~Scratch() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void Scratch::empty() const {
  for (const auto& entry : std::filesystem::directory_iterator(path_)) {
    std::filesystem::remove_all(entry.path());
  }
}

void Scratch::put(const std::string& name, const std::string& bytes) const {
  std::ofstream(file(name), std::ios::binary) << bytes;
}

std::optional<std::string> Scratch::bytes(const std::string& name) const {
  std::ifstream in(file(name), std::ios::binary);
  if (!in) {
    return std::nullopt;
  }
  return std::string(std::istreambuf_iterator<char>(in), {});
}

}  // namespace changeover::fuzz
