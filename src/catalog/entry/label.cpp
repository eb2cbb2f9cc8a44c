#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "changeover/catalog/catalog.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/io/output.hpp"
#include "core/parsed.hpp"
#include "core/words.hpp"
#include "io/write/element_text.hpp"

namespace changeover {
namespace {

std::vector<std::string_view> parts(std::string_view text) {
  std::vector<std::string_view> result;
  for (;;) {
    const std::size_t dot = text.find('.');
    result.push_back(text.substr(0, dot));
    if (dot == std::string_view::npos) {
      return result;
    }
    text.remove_prefix(dot + 1);
  }
}

// As it is written: without signs, and zeros in front.
std::optional<std::uint64_t> number(std::string_view text) {
  const auto value = parsed<std::uint64_t>(text);
  return value && fmt::to_string(*value) == text ? value : std::nullopt;
}

// Takes the parts of a cell from the front.
std::optional<Parameters> take_cell(std::vector<std::string_view>& parts) {
  if (parts.size() < 4) {
    return std::nullopt;
  }
  const auto v = number(parts[0]);
  const auto k = number(parts[1]);
  const auto change = number(parts[2]);
  const auto kind = kind_from_string(parts[3]);
  if (!v || !k || !change || !kind) {
    return std::nullopt;
  }
  Parameters p{.v = *v, .k = *k, .change = *change, .kind = *kind};
  std::size_t taken = 4;
  if (parts.size() > taken && parts[taken].starts_with('t')) {
    const auto strength = number(parts[taken].substr(1));
    if (!strength || *strength == 2 || *strength > max_strength) {
      return std::nullopt;
    }
    p.strength = static_cast<std::uint32_t>(*strength);
    ++taken;
  }
  try {
    check(p);
  } catch (const ImpossibleParameters&) {
    return std::nullopt;
  }
  parts.erase(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(taken));
  return p;
}

// What is written, as a checksum.
class HashSink final : public Sink {
 public:
  void write(std::string_view text) override { hash.add(text); }

  Sha256 hash;
};

}  // namespace

std::string cell_label(const Parameters& p) {
  std::string label = fmt::format("{}.{}.{}.{}", p.v, p.k, p.change, to_string(p.kind));
  if (p.strength != 2) {
    label += fmt::format(".t{}", p.strength);
  }
  return label;
}

std::optional<Parameters> parse_cell_label(std::string_view text) {
  std::vector<std::string_view> rest = parts(text);
  const std::optional<Parameters> p = take_cell(rest);
  return rest.empty() ? p : std::nullopt;
}

std::string design_label(const Parameters& p, std::uint64_t b, const Checksum& checksum) {
  return fmt::format("{}.{}.{}", cell_label(p), b, to_hex(checksum).substr(0, label_digits));
}

std::optional<DesignLabel> parse_design_label(std::string_view text) {
  std::vector<std::string_view> rest = parts(text);
  const std::optional<Parameters> p = take_cell(rest);
  if (!p || rest.size() != 2) {
    return std::nullopt;
  }
  const auto b = number(rest[0]);
  if (!b || *b == 0 || rest[1].size() != label_digits ||
      rest[1].find_first_not_of("0123456789abcdef") != std::string_view::npos) {
    return std::nullopt;
  }
  return DesignLabel{*p, *b, std::string(rest[1])};
}

bool reads_as_label(std::string_view text) {
  std::string plain = lower_case(text);
  std::erase(plain, ' ');
  const std::vector<std::string_view> words = parts(plain);
  const auto is_number = [](std::string_view word) {
    return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos;
  };
  constexpr std::size_t numbers = 3;  // v, k and the change number; then the kind
  for (std::size_t i = 0; i < std::min(numbers, words.size()); ++i) {
    const bool ends_here = i > 0 && i + 1 == words.size() && words[i].empty();
    if (!is_number(words[i]) && !ends_here) {
      return false;
    }
  }
  if (words.size() <= numbers) {
    return true;
  }
  const auto is_kind = [&](std::string_view kind) {
    return words.size() == numbers + 1 ? kind.starts_with(words[numbers]) : kind == words[numbers];
  };
  return is_kind(to_string(Kind::linear)) || is_kind(to_string(Kind::circular));
}

DesignDigest design_digest(BlockSource& source) {
  HashSink sink;
  const Parameters& p = source.parameters();
  const std::vector<std::string> numbers;
  ElementText text(sink, p.v, numbers, ' ');
  const std::uint64_t blocks = write_block_lines(source, text);
  return {sink.hash.finish(), blocks};
}

std::string CatalogEntry::label() const { return design_label(parameters, b, checksum); }

std::string_view CatalogEntry::status() const {
  if (!retracted.empty()) {
    return "retracted";
  }
  return b == lower_bound ? "minimum" : "best-known";
}

bool CatalogEntry::carries_blocks() const {
  return recipe.construction == "literal" || recipe.construction == "developed";
}

namespace {

constexpr Kind linear = Kind::linear;
constexpr Kind circular = Kind::circular;

constexpr std::array reports{
    Reported{"PreeceEtAl1995", {12, 4, 1, linear}, 21},
    Reported{"PreeceEtAl1995", {15, 4, 1, linear}, 34},
    Reported{"PreeceEtAl1995", {18, 4, 1, linear}, 50},
    Reported{"Phillips1999", {12, 4, 1, linear}, 21},
    Reported{"Phillips2001", {20, 5, 1, linear}, 46},
    Reported{"McSorley1999", {9, 4, 1, circular}, 12},
    Reported{"McSorley1999", {10, 4, 1, circular}, 15},
    Reported{"Bean2026", {26, 6, 1, linear}, 63},
    Reported{"ChafeeStevens2025", {61, 4, 2, circular}, 366},
    // Corollary 15 of the paper, its two misprints as its formula has them.
    Reported{"ChafeeStevens2025", {15, 3, 2, circular}, 35},
    Reported{"ChafeeStevens2025", {21, 5, 2, circular}, 30},
    Reported{"ChafeeStevens2025", {27, 3, 2, circular}, 117},
    Reported{"ChafeeStevens2025", {55, 7, 2, circular}, 135},
    Reported{"ChafeeStevens2025", {39, 3, 2, circular}, 247},
    Reported{"ChafeeStevens2025", {51, 3, 2, circular}, 425},
    Reported{"ChafeeStevens2025", {77, 5, 2, circular}, 418},
    Reported{"ChafeeStevens2025", {63, 3, 2, circular}, 651},
};

}  // namespace

std::span<const Reported> reported_designs() { return reports; }

std::optional<Reported> reported_below(const Parameters& p, std::optional<std::uint64_t> held) {
  std::optional<Reported> fewest;
  for (const Reported& each : reports) {
    if (each.parameters == p && (!held || each.blocks < *held) &&
        (!fewest || each.blocks < fewest->blocks)) {
      fewest = each;
    }
  }
  return fewest;
}

std::vector<std::string> reporters_of(const Parameters& p, std::uint64_t blocks) {
  std::vector<std::string> keys;
  for (const Reported& each : reports) {
    if (each.parameters == p && each.blocks == blocks) {
      keys.emplace_back(each.cites);
    }
  }
  return keys;
}

}  // namespace changeover
