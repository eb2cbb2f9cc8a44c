#include "construct/tools/cyclic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "changeover/core/error.hpp"
#include "construct/entry.hpp"

namespace changeover {
namespace {

// i-th of 1, 2, 3, … without `skipped`, counted from 0.
std::uint64_t nth_from_one_without(std::uint64_t skipped, std::uint64_t i) {
  return i + 1 < skipped ? i + 1 : i + 2;
}

// c = 4m.
PositionPair ordinary_0(std::uint64_t m, std::uint64_t i) {
  if (i < 2 * m) {
    const std::uint64_t j = i + 1;
    return {j, 4 * m + 1 - j};
  }
  if (i < 4 * m - 2) {
    const std::uint64_t j = nth_from_one_without(m, i - 2 * m);
    return {4 * m + j, 8 * m - j};
  }
  return {6 * m, 8 * m};
}

// c = 4m+1.
PositionPair ordinary_1(std::uint64_t m, std::uint64_t i) {
  if (i < 2 * m - 1) {
    const std::uint64_t j = i + 1;
    return {j, 4 * m - j};
  }
  i -= 2 * m - 1;
  if (i == 0) {
    return {2 * m, 6 * m};
  }
  if (i == 1) {
    return {4 * m, 6 * m + 1};
  }
  i -= 2;
  if (i < m - 1) {
    const std::uint64_t j = i + 1;
    return {4 * m + 1 + j, 8 * m + 2 - j};
  }
  i -= m - 1;
  if (i < m - 1) {
    const std::uint64_t j = i + 1;
    return {5 * m + j, 7 * m + 1 - j};
  }
  return {7 * m + 1, 7 * m + 2};
}

// c = 4m+2.
PositionPair ordinary_2(std::uint64_t m, std::uint64_t i) {
  if (m == 0) {
    return {2, 3};
  }
  if (i < m - 1) {
    const std::uint64_t j = i + 1;
    return {j, 4 * m + 1 - j};
  }
  i -= m - 1;
  if (i == 0) {
    return {m, m + 1};
  }
  i -= 1;
  if (i < m - 1) {
    const std::uint64_t j = i + 1;
    return {m + 1 + j, 3 * m + 2 - j};
  }
  i -= m - 1;
  if (i == 0) {
    return {2 * m + 1, 4 * m + 2};
  }
  if (i == 1) {
    return {2 * m + 2, 6 * m + 3};
  }
  const std::uint64_t j = i - 1;
  return {4 * m + 2 + j, 8 * m + 4 - j};
}

// c = 4m+3.
PositionPair ordinary_3(std::uint64_t m, std::uint64_t i) {
  if (i < 2 * m + 1) {
    const std::uint64_t j = i + 1;
    return {j, 4 * m + 3 - j};
  }
  if (i < 4 * m + 1) {
    const std::uint64_t j = nth_from_one_without(m + 1, i - (2 * m + 1)) - 1;
    return {4 * m + 3 + j, 8 * m + 5 - j};
  }
  return {6 * m + 4, 8 * m + 6};
}

}  // namespace

PositionPair ordinary_pair(std::uint64_t c, std::uint64_t i) {
  switch (c % 4) {
    case 0:
      return ordinary_0(c / 4, i);
    case 1:
      return ordinary_1(c / 4, i);
    case 2:
      return ordinary_2(c / 4, i);
    default:
      return ordinary_3(c / 4, i);
  }
}

PositionPair special_pair(std::uint64_t c) {
  const std::uint64_t m = c / 4;
  switch (c % 4) {
    case 0:
      return {5 * m, 7 * m};
    case 1:
      return {4 * m + 1, 8 * m + 2};
    case 2:
      return {4 * m + 1, 8 * m + 4};
    default:
      return {5 * m + 3, 7 * m + 5};
  }
}

std::uint64_t link_pair(std::uint64_t c) {
  const std::uint64_t m = c / 4;
  switch (c % 4) {
    case 0:
      return 0;
    case 1:
      return c - 1;
    case 2:
      return m == 0 ? 0 : 2 * m - 1;
    default:
      return m == 0 ? c - 1 : 2 * m + 1;
  }
}

std::array<Element, 2> double_change_points(std::uint64_t c, std::uint64_t k, std::uint64_t i) {
  const std::uint64_t n = k - 2;
  const std::uint64_t step = 2 * k - 3;  // N
  const std::uint64_t v = 2 * c * step + 1;
  const auto straight = [&](std::uint64_t z) {
    return z >= c ? (z - c) * step + n : v - (c - z) * step + n;
  };
  const auto barred = [&](std::uint64_t z) {
    return z >= c ? v - (z - c) * step - 1 : (c - z) * step - 1;
  };
  // The pair with position c and the last pair change places.
  const std::uint64_t link = link_pair(c);
  const std::uint64_t number = i == c - 1 ? link : i == link ? c - 1 : i;
  const bool special = number == c - 1;
  const PositionPair pair = special ? special_pair(c) : ordinary_pair(c, number);
  const auto x = static_cast<Element>(straight(pair.first));
  const auto y = static_cast<Element>(special ? barred(pair.second) : straight(pair.second));
  return {std::min(x, y), std::max(x, y)};
}

Element single_change_point(std::uint64_t c, std::uint64_t k, std::uint64_t i) {
  return static_cast<Element>((i == c - 1 ? 1 : i + 2) * (k - 1));
}

bool has_interval_expansion_set(std::uint64_t v, std::uint64_t n) {
  return n >= 1 && v % n == 0 && v <= max_elements_of_interval_expansion;
}

std::vector<UnchangedSubset> interval_expansion_set(std::uint64_t c, std::uint64_t v,
                                                    std::uint64_t n) {
  std::vector<UnchangedSubset> set;
  set.reserve(static_cast<std::size_t>(v / n));
  for (std::uint64_t i = 1; i <= v / n; ++i) {
    Block interval(static_cast<std::size_t>(n));
    std::iota(interval.begin(), interval.end(), static_cast<Element>(i * n % v));
    set.push_back({static_cast<std::size_t>(i * n * c), std::move(interval)});
  }
  return set;
}

std::string explain_development(const Parameters& parameters, std::uint64_t length,
                                std::uint64_t base_blocks,
                                const IntervalDevelopedSource::Points& points) {
  constexpr std::uint64_t most_shown = 6;
  constexpr std::uint64_t first_shown = 3;
  const bool all = base_blocks <= most_shown;
  Block extra(static_cast<std::size_t>(parameters.k - length));
  std::string text;
  const auto append = [&](std::uint64_t i) {
    points(i, extra);
    text += fmt::format("{}{{{},{}}}", text.empty() ? "" : ", ", first_elements(length),
                        fmt::join(extra, ","));
  };
  for (std::uint64_t i = 0; i < (all ? base_blocks : first_shown); ++i) {
    append(i);
  }
  if (!all) {
    text += ", …";
    append(base_blocks - 1);
  }
  return fmt::format("Develop the {}base block{} {} over Z_{}.",
                     all ? "" : fmt::format("{} ", base_blocks), base_blocks == 1 ? "" : "s", text,
                     parameters.v);
}

}  // namespace changeover
