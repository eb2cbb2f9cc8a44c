// Writes damaged copies of a file, for the attacks on readers.
//
//     mutate SEED COUNT FILE FOLDER             FOLDER/0, FOLDER/1, …
//     mutate SEED COUNT FILE FOLDER checkpoint  every other copy gets the right checksum again
//
// The same seed gives the same copies everywhere. Exit code 2 if the command line is not
// understood, 4 if a file cannot be read or written.
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

/// SplitMix64.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t x = state_;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
  }

  /// 0 to bound − 1; 0 if bound is 0.
  std::size_t below(std::size_t bound) {
    return bound == 0 ? 0 : static_cast<std::size_t>(next() % bound);
  }

 private:
  std::uint64_t state_;
};

const std::vector<std::string>& intruders() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> some{
        "0",          "-1",   "1",       "65534",    "65535",       "65536",     "2147483648",
        "4294967296", "1e9",  "1e999",   "0x7f",     "007",         "1.5",       "nan",
        " ",          "\t",   "\n",      "\r",       "\r\n",        "#",         "\"",
        "\"\"",       "'",    ",",       ",,,,,,,,", ":",           "{",         "}",
        "[",          "]",    "\\",      "\\u0000",  "\\ud800",     "null",      "true",
        "\x1b[2J",    "\x07", "\x7f",    "\xc2\x9b", "\xff\xfe",    "\xc0\x80",  "=1+1",
        "@SUM(A1)",   "v=0",  "k=65535", "change=0", "kind=square", "strength=4"};
    some.insert(some.end(),
                {"9223372036854775807", "18446744073709551615", "18446744073709551616",
                 "99999999999999999999999999999999", "\xef\xbb\xbf", "\xe2\x80\xae",
                 "# changeover design v=5 k=2", "# labels: a a", "# recipe: {}", "change=65536",
                 std::string(1, '\0'), std::string(5000, '['), std::string(5000, '9'),
                 std::string(70000, 'x'), std::string(3000, ' '), std::string(300, '\n')});
    return some;
  }();
  return all;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The line that holds `at`, with its end.
struct Span {
  std::size_t begin = 0;
  std::size_t size = 0;
};

Span line_at(const std::string& text, std::size_t at) {
  const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  const std::size_t end = text.find('\n', at);
  return {begin, (end == std::string::npos ? text.size() : end + 1) - begin};
}

/// The number at or after `at`, or an empty span.
Span number_at(const std::string& text, std::size_t at) {
  while (at < text.size() && !is_digit(text[at])) {
    ++at;
  }
  std::size_t end = at;
  while (end < text.size() && is_digit(text[end])) {
    ++end;
  }
  return {at, end - at};
}

/// Somewhere in the first `reach` bytes.
void damage(std::string& text, std::size_t reach, Random& random) {
  const std::size_t at = random.below(std::min(reach, text.size()) + 1);
  const std::size_t other = random.below(text.size() + 1);
  const std::string& intruder = intruders()[random.below(intruders().size())];
  const Span line = line_at(text, at < text.size() ? at : 0);
  const std::string its_text = text.substr(line.begin, line.size);
  switch (random.below(11)) {
    case 0:  // a bit
      if (at < text.size()) {
        text[at] = static_cast<char>(text[at] ^ (1 << random.below(8)));
      }
      break;
    case 1:  // a byte
      if (at < text.size()) {
        text[at] = static_cast<char>(random.below(256));
      }
      break;
    case 2:
      text.insert(at, intruder);
      break;
    case 3:  // a number
    case 4: {
      const Span number = number_at(text, at);
      const std::string value =
          random.below(2) == 0 ? intruder : std::to_string(random.below(random.below(100) + 1));
      text.replace(number.begin, number.size, value);
      break;
    }
    case 5:
      text.erase(at, 1 + random.below(8));
      break;
    case 6:
      text.erase(line.begin, line.size);
      break;
    case 7:
      text.insert(line.begin, its_text);
      break;
    case 8:  // a line elsewhere
      text.erase(line.begin, line.size);
      text.insert(line_at(text, other < text.size() ? other : 0).begin, its_text);
      break;
    case 9:  // cut
      text.resize(at);
      break;
    default:  // a piece elsewhere
      text.insert(other, text.substr(at, 1 + random.below(40)));
      break;
  }
}

/// The last line of a checkpoint is the FNV-1a hash of all before it.
void seal(std::string& text) {
  const std::size_t check = text.rfind("check ");
  if (check != std::string::npos) {
    text.resize(check);
  }
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  }
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
  text += "check " + std::string(digits.data()) + "\n";
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  std::uint64_t seed = 0;
  std::size_t count = 0;
  const auto read = [](const std::string& word, auto& number) {
    const auto [rest, failure] = std::from_chars(word.data(), word.data() + word.size(), number);
    return failure == std::errc() && rest == word.data() + word.size();
  };
  const bool sealed = words.size() == 5 && words[4] == "checkpoint";
  if ((words.size() != 4 && !sealed) || !read(words[0], seed) || !read(words[1], count)) {
    std::fputs("usage: mutate SEED COUNT FILE FOLDER [checkpoint]\n", stderr);
    return 2;
  }
  std::ifstream input(words[2], std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(input), std::istreambuf_iterator<char>()};
  if (!input) {
    std::fprintf(stderr, "mutate: cannot read %s\n", words[2].c_str());
    return 4;
  }
  Random random(seed);
  for (std::size_t i = 0; i < count; ++i) {
    std::string text = whole;
    // What a checkpoint says of the search is small beside its blocks, and more is done with it.
    const std::size_t reach =
        sealed && random.below(4) > 0 ? text.find("\nblock") : std::string::npos;
    for (std::size_t times = 1 + random.below(3); times > 0; --times) {
      damage(text, reach, random);
    }
    if (sealed && i % 2 == 0) {
      seal(text);
    }
    std::ofstream output(words[3] + "/" + std::to_string(i), std::ios::binary);
    output << text;
    if (!output.flush()) {
      std::fprintf(stderr, "mutate: cannot write to %s\n", words[3].c_str());
      return 4;
    }
  }
  return 0;
}
