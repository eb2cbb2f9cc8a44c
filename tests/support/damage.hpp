// Damage to files: what readers must notice, or make something valid of.
//
//     RC_GTEST_PROP(Recipe, DamageIsRefusedOrRead, (const test::Damage& damage)) {
//       const std::string bad = damage.of(good);
//       if (test::accepted("f", [&] { recipe = read(bad, "f"); })) …
//     }
//
// It is data, so that a property that fails shrinks it and says what was done to the file.
#pragma once

#include <fmt/format.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/error.hpp"
#include "core/printable.hpp"

namespace changeover::test {

/// One thing that happens to a file.
struct Mishap {
  enum class Kind : std::uint8_t {
    byte,     // another byte
    bit,      // one bit of a byte
    digit,    // the next digit is another one
    letters,  // another byte is put in
    loss,     // some bytes are gone
    echo,     // some bytes come twice
    line_gone,
    line_twice,
    lines_exchanged,
    cut_off,
  };
  static constexpr int kinds = 10;
  Kind kind = Kind::byte;
  std::uint32_t at = 0;    ///< where, of 2³² places from the beginning to the end
  std::uint32_t with = 0;  ///< what, and how many

  void happen(std::string& text) const {
    if (text.empty()) {
      return;
    }
    const std::size_t place = (at * std::uint64_t{text.size()}) >> 32U;
    const std::size_t length = std::min<std::size_t>(1 + with % 12, text.size() - place);
    switch (kind) {
      case Kind::byte:
        text[place] = other_byte();
        break;
      case Kind::bit:
        text[place] = static_cast<char>(static_cast<unsigned char>(text[place]) ^ (1U << with % 8));
        break;
      case Kind::digit:
        if (const std::size_t digit = text.find_first_of("0123456789", place);
            digit != std::string::npos) {
          text[digit] = static_cast<char>('0' + with % 10);
        }
        break;
      case Kind::letters:
        text.insert(place, 1, other_byte());
        break;
      case Kind::loss:
        text.erase(place, length);
        break;
      case Kind::echo:
        text.insert(place, text.substr(place, length));
        break;
      case Kind::cut_off:
        text.resize(place);
        break;
      default:
        happen_to_lines(text);
    }
  }

 private:
  /// Half of the time one that means something in a text.
  [[nodiscard]] char other_byte() const {
    using namespace std::string_view_literals;
    constexpr std::string_view likely = " \n\r\t\0,;#\"'{}[]:-+.=x0123456789\x7f\xc3\xff"sv;
    const std::uint32_t which = with >> 1U;
    return with % 2 == 0 ? likely[which % likely.size()] : static_cast<char>(which % 256);
  }

  void happen_to_lines(std::string& text) const {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
      lines.push_back(text.substr(begin, end - begin));
      begin = end;
    }
    const auto line = static_cast<std::ptrdiff_t>((at * std::uint64_t{lines.size()}) >> 32U);
    const auto other = static_cast<std::ptrdiff_t>(with % lines.size());
    if (kind == Kind::line_gone) {
      lines.erase(lines.begin() + line);
    } else if (kind == Kind::line_twice) {
      lines.insert(lines.begin() + other, std::string(lines[static_cast<std::size_t>(line)]));
    } else {
      std::iter_swap(lines.begin() + line, lines.begin() + other);
    }
    text.clear();
    for (const std::string& each : lines) {
      text += each;
    }
  }
};

/// None to four mishaps, one after another.
struct Damage {
  std::vector<Mishap> mishaps;

  [[nodiscard]] std::string of(std::string text) const {
    for (const Mishap& mishap : mishaps) {
      mishap.happen(text);
    }
    return text;
  }
};

inline std::ostream& operator<<(std::ostream& out, const Damage& damage) {
  constexpr const char* names[Mishap::kinds] = {
      "another byte", "a bit",       "another digit", "a byte more",     "bytes lost",
      "bytes twice",  "a line lost", "a line twice",  "lines exchanged", "cut off"};
  for (const Mishap& mishap : damage.mishaps) {
    out << fmt::format("[{} at {:.4f}, {}]", names[static_cast<int>(mishap.kind)],
                       mishap.at / 4294967296.0, mishap.with);
  }
  return out;
}

/// Whether `work` ends without a fault. If not, it throws BadInput (or another fault that is
/// named), which says so in one line that begins with the name of the file; whatever else is thrown
/// fails the property.
template <typename Fault = BadInput, typename Work>
bool accepted(const std::string& file, Work&& work) {
  try {
    work();
    return true;
  } catch (const Fault& fault) {
    const std::string line = fault.what();
    RC_LOG() << line << '\n';
    RC_ASSERT(line.starts_with(file));
    RC_ASSERT(is_printable(line));
    return false;
  }
}

/// A text of up to `most` of these pieces.
inline std::string some_text(const std::vector<std::string>& pieces, int most) {
  std::string text;
  for (int rest = *rc::gen::inRange(0, most + 1); rest > 0; --rest) {
    text += *rc::gen::elementOf(pieces);
  }
  return text;
}

/// A number from 0 to `most`, each as likely as all others.
inline std::uint64_t some_number(std::uint64_t most) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::uint64_t>(0, most + 1));
}

}  // namespace changeover::test

namespace rc {

template <>
struct Arbitrary<changeover::test::Damage> {
  static Gen<changeover::test::Damage> arbitrary() {
    using changeover::test::Damage;
    using changeover::test::Mishap;
    const auto number = gen::inRange<std::uint32_t>(0, 0xffffffffU);
    const auto kind = gen::map(gen::inRange(0, Mishap::kinds),
                               [](int which) { return static_cast<Mishap::Kind>(which); });
    const auto mishap =
        gen::resize(kNominalSize,
                    gen::build<Mishap>(gen::set(&Mishap::kind, kind), gen::set(&Mishap::at, number),
                                       gen::set(&Mishap::with, number)));
    return gen::map(gen::resize(4, gen::container<std::vector<Mishap>>(mishap)),
                    [](std::vector<Mishap> mishaps) { return Damage{std::move(mishaps)}; });
  }
};

}  // namespace rc
