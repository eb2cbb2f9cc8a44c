#include "changeover/search/base_block_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "bounds/counting_bound.hpp"
#include "changeover/bounds/lower_bound.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "search/symmetric/base_block_anneal.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_shapes = 10'000;
constexpr std::uint64_t most_counted = std::uint64_t{1} << 62;

std::optional<std::string> tight_obstruction(const Parameters& p, const BaseBlockShape& shape) {
  const std::uint64_t pairs = binomial(p.v, 2);
  const std::uint64_t newly = newly_covered_at_most(p);
  if (checked_multiply(shape.b(), newly) != pairs) {
    return fmt::format("{} blocks newly cover {} each, and there are {}", shape.b(),
                       count_of(newly, "pair"), pairs);
  }
  if (shape.n % 2 == 0) {
    return fmt::format("n = {} is even: opposite elements of a cycle would be newly covered twice",
                       shape.n);
  }
  if (shape.fixed > 1) {
    return fmt::format("two of {} fixed elements would be newly covered {} times", shape.fixed,
                       shape.n);
  }
  const std::uint64_t m = p.change;
  const std::vector<Degree> of_fixed =
      shape.fixed == 0 ? std::vector<Degree>{} : fixed_degrees(p, shape);
  if (shape.fixed == 1 && of_fixed.empty()) {
    return fmt::format(
        "a fixed element would be introduced j times in r ≥ j ≥ 1 base blocks, {}j + {}(r−j) = {}",
        p.k - 1, m, shape.cycles);
  }
  const std::vector<Degree> of_cycles = cycle_degrees(p, shape);
  if (of_cycles.empty()) {
    return fmt::format(
        "an element would be introduced i ≥ 1 times in r ≥ i blocks, {}i + {}(r−i) = {}", p.k - 1,
        m, p.v - 1);
  }
  // The possible sums of introductions of s cycles.
  const std::size_t wanted = static_cast<std::size_t>(m * shape.base_blocks);
  std::vector<bool> sums(wanted + 1, false);
  sums[0] = true;
  for (std::uint64_t cycle = 0; cycle < shape.cycles; ++cycle) {
    stop_if_asked();
    std::vector<bool> next(wanted + 1, false);
    for (std::size_t sum = 0; sum <= wanted; ++sum) {
      for (const Degree& degree : of_cycles) {
        if (sums[sum] && sum + degree.introductions <= wanted) {
          next[static_cast<std::size_t>(sum + degree.introductions)] = true;
        }
      }
    }
    sums = std::move(next);
  }
  const bool adds_up =
      shape.fixed == 0 ? sums[wanted] : std::ranges::any_of(of_fixed, [&](const Degree& degree) {
        return degree.introductions <= wanted &&
               sums[wanted - static_cast<std::size_t>(degree.introductions)];
      });
  if (!adds_up) {
    return fmt::format("the introductions that an element can have do not add up to {} in {}",
                       wanted, count_of(shape.base_blocks, "base block"));
  }
  return std::nullopt;
}

}  // namespace

std::vector<Degree> cycle_degrees(const Parameters& p, const BaseBlockShape& shape) {
  std::vector<Degree> degrees;
  const std::uint64_t m = p.change;
  for (std::uint64_t i = 1; i * (p.k - 1) <= p.v - 1; ++i) {
    const std::uint64_t rest = p.v - 1 - i * (p.k - 1);
    const std::uint64_t r = i + rest / m;
    // Between two runs of blocks with the element there is a block without it.
    if (rest % m == 0 && r + i <= shape.b()) {
      degrees.push_back({i, r});
    }
  }
  return degrees;
}

std::vector<Degree> fixed_degrees(const Parameters& p, const BaseBlockShape& shape) {
  std::vector<Degree> degrees;
  if ((p.v - 1) % shape.n != 0) {
    return degrees;
  }
  const std::uint64_t each = (p.v - 1) / shape.n;
  if (p.change * shape.base_blocks == each) {
    degrees.push_back({0, shape.base_blocks});  // in every block: it meets the introduced elements
  }
  for (std::uint64_t j = 1; j * (p.k - 1) <= each; ++j) {
    const std::uint64_t rest = each - j * (p.k - 1);
    const std::uint64_t r = j + rest / p.change;
    if (rest % p.change == 0 && r + j <= shape.base_blocks) {
      degrees.push_back({j, r});
    }
  }
  return degrees;
}

std::string to_string(const BaseBlockShape& shape) {
  std::string text = fmt::format("{}, {} of length {}", count_of(shape.base_blocks, "base block"),
                                 count_of(shape.cycles, "cycle"), shape.n);
  if (shape.fixed > 0) {
    text += fmt::format(", {}", count_of(shape.fixed, "fixed point"));
  }
  return text;
}

std::optional<std::string> shape_obstruction(const Parameters& p, const BaseBlockShape& shape,
                                             bool tight) {
  check(p);
  const Parameters circular = p.as(Kind::circular);
  if (auto reason = impossibility(circular)) {
    return reason;
  }
  if (shape.n < 2 || shape.cycles == 0 || shape.base_blocks == 0 ||
      checked_add(checked_multiply(shape.n, shape.cycles), shape.fixed) != p.v) {
    return fmt::format("v = {} is not {} of length {} and {}", p.v, count_of(shape.cycles, "cycle"),
                       shape.n, count_of(shape.fixed, "fixed point"));
  }
  const Bound bound = lower_bound(circular);
  if (checked_multiply(shape.n, shape.base_blocks) < bound.blocks) {
    return fmt::format("at least {} blocks are needed: {}", bound.blocks, bound.reason);
  }
  return tight ? tight_obstruction(circular, shape) : std::nullopt;
}

std::vector<BaseBlockShape> base_block_shapes(const Parameters& p, const ShapeOptions& options) {
  check(p);
  const Parameters circular = p.as(Kind::circular);
  std::vector<BaseBlockShape> shapes;
  if (impossibility(circular) || p.strength != 2) {
    return shapes;
  }
  const std::uint64_t least = lower_bound(circular).blocks;
  if (options.tight && least > counting_bound(circular)) {
    return shapes;
  }
  const std::uint64_t first_fixed = options.fixed.value_or(0);
  const std::uint64_t last_fixed = std::min(options.fixed.value_or(options.tight ? 1 : 2),
                                            p.v - std::min<std::uint64_t>(p.v, 2));
  for (std::uint64_t fixed = first_fixed; fixed <= last_fixed; ++fixed) {
    const std::uint64_t moved = p.v - fixed;
    for (std::uint64_t cycles = 1; cycles <= moved / 2; ++cycles) {
      const std::uint64_t n = moved / cycles;
      if (moved % cycles != 0 || (options.n && *options.n != n)) {
        continue;
      }
      std::uint64_t from = ceil_div(least, n);
      std::uint64_t to = options.most_blocks ? *options.most_blocks / n : from;
      if (options.tight) {
        from = to = counting_bound(circular) / n;
      }
      if (options.base_blocks) {
        from = std::max(from, *options.base_blocks);
        to = *options.base_blocks;
      }
      to = std::min(to, most_counted / n);  // so that the number of blocks can be counted
      for (std::uint64_t c = from; c <= to && shapes.size() < most_shapes; ++c) {
        stop_if_asked();
        const BaseBlockShape shape{{n, cycles, fixed}, c};
        if ((!options.most_blocks || shape.b() <= *options.most_blocks) &&
            (!options.tight || !tight_obstruction(circular, shape))) {
          shapes.push_back(shape);
        }
      }
    }
  }
  std::ranges::sort(shapes, [](const BaseBlockShape& a, const BaseBlockShape& b) {
    return std::tuple(a.b(), b.n, a.fixed) < std::tuple(b.b(), a.n, b.fixed);
  });
  return shapes;
}

}  // namespace changeover
