#include "support/chain.hpp"

#include <cstdint>
#include <cstdio>
#include <sstream>

#include "changeover/core/sha256.hpp"

namespace changeover::fuzz {

std::string with_right_chain(const std::string& journal) {
  constexpr std::size_t digits = 32;
  std::istringstream lines(journal);
  std::string right;
  std::string line;
  if (!std::getline(lines, line)) {
    return journal;
  }
  right = line + "\n";
  Checksum chain = sha256(right);
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string step;
    std::string number;
    std::string results;
    words >> step >> number >> results;
    const std::string record = step + " " + number + " " + results;
    Sha256 hash;
    hash.add(chain);
    hash.add(record);
    chain = hash.finish();
    right += record + " " + to_hex(chain).substr(0, digits) + "\n";
  }
  return right;
}

std::string with_right_check(const std::string& checkpoint) {
  const std::size_t last = checkpoint.rfind("check ");
  std::string text = checkpoint.substr(0, last);
  if (!text.ends_with('\n')) {
    text += '\n';
  }
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char byte : text) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
  }
  char line[32];
  static_cast<void>(
      std::snprintf(line, sizeof line, "check %016llx\n", static_cast<unsigned long long>(hash)));
  return text + line;
}

}  // namespace changeover::fuzz
