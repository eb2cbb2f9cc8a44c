#include "changeover/catalog/catalog.hpp"

#include <array>

namespace changeover {
namespace {

constexpr Kind linear = Kind::linear;
constexpr Kind circular = Kind::circular;

constexpr std::array reports{
    Reported{"PreeceEtAl1995", {12, 4, 1, linear}, 21},
    Reported{"PreeceEtAl1995", {15, 4, 1, linear}, 34},
    Reported{"PreeceEtAl1995", {18, 4, 1, linear}, 50},
    Reported{"Phillips2001", {20, 5, 1, linear}, 46},
    Reported{"McSorley1999", {9, 4, 1, circular}, 12},
    Reported{"McSorley1999", {10, 4, 1, circular}, 15},
    Reported{"Bean2026", {26, 6, 1, linear}, 63},
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

}  // namespace changeover
