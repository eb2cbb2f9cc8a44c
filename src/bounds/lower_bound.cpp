#include "changeover/bounds/lower_bound.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "bounds/degree_program.hpp"
#include "bounds/known_minima.hpp"
#include "bounds/special_bounds.hpp"
#include "bounds/stays.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

/// The least e ≥ 0 with pairs + e ≡ 0 modulo n.
std::uint64_t least_excess(std::uint64_t pairs, std::uint64_t n) { return (n - pairs % n) % n; }

/// What the degree identity forces: each e_x ≥ each, so total excess ≥ total.
struct ForcedExcess {
  std::uint64_t modulus = 1;
  std::uint64_t each = 0;
  std::uint64_t total = 0;
};

// i_x(k−1−m) + m·r_x = v − 1 + e_x, so e_x ≡ −(v−1) modulo gcd(k−1−m, m) = gcd(k−1, m).
ForcedExcess forced_excess(const Parameters& p) {
  ForcedExcess forced;
  forced.modulus = std::gcd(p.k - 1, p.change);
  forced.each = least_excess(p.v - 1, forced.modulus);
  forced.total = ceil_div(checked_multiply(p.v, forced.each), 2);
  return forced;
}

Bound linear_counting(const Parameters& p) {
  const std::uint64_t most = newly_covered_at_most(p);
  const std::uint64_t all = binomial(p.v, p.strength);
  const std::uint64_t first = binomial(p.k, p.strength);
  const std::uint64_t b = ceil_div(all - first, most) + 1;
  return {
      b, "counting",
      fmt::format("the first block covers C({0},{1}) = {2} of C({3},{1}) = {4} {5}, each later one "
                  "newly covers at most {6}: b >= ceil(({4} - {2}) / {6}) + 1 = {7}",
                  p.k, p.strength, first, p.v, all,
                  p.strength == 2 ? "pairs" : fmt::format("{}-subsets", p.strength), most, b)};
}

Bound linear_degree(const Parameters& p, const ForcedExcess& forced) {
  const std::uint64_t most = newly_covered_at_most(p);
  const std::uint64_t all = checked_add(binomial(p.v, 2), forced.total);
  const std::uint64_t first = binomial(p.k, 2);
  const std::uint64_t b = ceil_div(all - first, most) + 1;
  return {b, "degree",
          fmt::format(
              "i_x(k-1) + m(r_x-i_x) = v-1 + e_x makes every e_x >= {} (modulo gcd(k-1,m) = {}), "
              "so {} pairs are covered with repetition: b >= ceil(({} - {}) / {}) + 1 = {}",
              forced.each, forced.modulus, all, all, first, most, b)};
}

struct CircularMinimum {
  std::uint64_t b = 0;
  std::uint64_t fixed = 0;
};

// The least number of blocks that counting allows, over the number f of elements in every block.
// `forced` adds the excess that degrees force at the v − f other elements; each of the f fixed
// elements meets m elements newly in each block, m·b = v − f + e_x in all.
CircularMinimum circular_minimum(const Parameters& p, const ForcedExcess* forced) {
  // C(v−f,2) / p(k−f,m) grows with f from here on: cross-multiply two neighbours.
  const std::uint64_t growing = 2 * p.k > p.v + p.change + 1 ? 2 * p.k - p.v - p.change - 1 : 0;
  constexpr std::uint64_t most_tries = std::uint64_t{1} << 20;
  if (growing > most_tries) {
    return {3, 0};  // weak, but "end to end" is what counts for v < 2k
  }
  const auto pairs_a_block = [&](std::uint64_t k) {
    return binomial(k, 2) - binomial(k - p.change, 2);
  };
  CircularMinimum best;
  for (std::uint64_t f = 0; f + p.change <= p.k && f + p.change < p.v; ++f) {
    if (pairs_a_block(p.k - f) == 0) {
      break;  // blocks of one element beside the fixed ones: no two others ever meet
    }
    const std::uint64_t rest = p.v - f;
    std::uint64_t all = binomial(p.v, 2) - binomial(f, 2);
    if (forced != nullptr) {
      const std::uint64_t at_fixed = f == 0 ? 0 : least_excess(rest, p.change);
      all += ceil_div(checked_add(checked_multiply(rest, forced->each), f * at_fixed), 2);
    }
    const std::uint64_t of_rest = ceil_div(binomial(rest, 2), pairs_a_block(p.k - f));
    const std::uint64_t b = std::max(
        {ceil_div(all, pairs_a_block(p.k)), of_rest, ceil_div(rest, p.change), std::uint64_t{3}});
    if (best.b == 0 || b < best.b) {
      best = {b, f};
    }
    if (best.b == 3 || (f >= growing && of_rest >= best.b)) {
      break;
    }
  }
  return best;
}

void circular_bounds(const Parameters& p, std::vector<Bound>& bounds) {
  const std::uint64_t most = newly_covered_at_most(p);
  const std::uint64_t all = binomial(p.v, p.strength);
  if (p.strength != 2) {
    // A t-subset that is in every block is never newly covered. This case is worked out for pairs
    // only, so for t > 2 the first block is granted all its subsets, as in a linear design.
    Bound bound = linear_counting(p);
    bound.reason += " (a circular design is also a linear one)";
    bounds.push_back(std::move(bound));
    return;
  }
  const CircularMinimum plain = circular_minimum(p, nullptr);
  const std::uint64_t g2 = ceil_div(all, most);
  if (plain.b == g2) {
    bounds.push_back(
        {g2, "counting",
         fmt::format(
             "each block newly covers at most {0} of C({1},2) = {2} pairs: "
             "b >= ceil({2} / {0}) = {3} (a design with elements in every block needs no fewer)",
             most, p.v, all, g2)});
  } else {
    bounds.push_back(
        {plain.b, "counting",
         fmt::format(
             "ceil(C({0},2) / {1}) = {2} counts pairs of elements that are in every block; over "
             "the number f of those, max(ceil((C({0},2) - C(f,2)) / {1}), "
             "ceil(C({0}-f,2) / p({3}-f)), ceil(({0}-f) / {4}), 3) is least at f = {5}: b >= {6}",
             p.v, most, g2, p.k, p.change, plain.fixed, plain.b)});
  }
  const ForcedExcess forced = forced_excess(p);
  if (forced.each > 0) {
    const CircularMinimum minimum = circular_minimum(p, &forced);
    bounds.push_back(
        {minimum.b, "degree",
         fmt::format(
             "i_x(k-1) + m(r_x-i_x) = v-1 + e_x makes every e_x >= {} (modulo gcd(k-1,m) = {}); "
             "counting pairs with this excess{} gives b >= {}",
             forced.each, forced.modulus,
             minimum.fixed == 0 ? ""
                                : fmt::format(", least with {} in every block,",
                                              count_of(minimum.fixed, "element")),
             minimum.b)});
  }
}

// "3*n1 + 2*n2 + n3", and its end where s is large.
std::string weighted_stays(std::uint64_t s) {
  constexpr std::uint64_t most_terms = 4;
  std::string text;
  for (std::uint64_t j = 1; j <= s; ++j) {
    if (s > most_terms && j == most_terms - 1) {
      text += fmt::format(" + ... + n{}", s);
      break;
    }
    text += fmt::format("{}{}n{}", j == 1 ? "" : " + ",
                        j == s ? std::string() : fmt::format("{}*", s + 1 - j), j);
  }
  return text;
}

Bound stays(const Parameters& p) {
  const Introductions least = least_introductions(p.v, p.k, p.strength);
  const std::uint64_t n = most_meetings(least.s, p.strength);
  const std::uint64_t b =
      least.count > p.k ? ceil_div(least.count - p.k, p.change) + 1 : std::uint64_t{1};
  const std::string times = n == 1 ? std::string() : std::to_string(n);
  return {b, "stays",
          fmt::format("{0} <= {1}k = {2} where n_j elements have j stays (docs/theorems.md, "
                      "Theorem 5), so k + m(b-1) >= {3}v - {1}k = {4}: b >= {5}",
                      weighted_stays(least.s), times, n * p.k, least.s + 1, least.count, b)};
}

// In p = ceil((v-k)/m) blocks in a row at most k + m(p-1) < v elements occur. If there were at most
// t*p blocks, cut them into t such runs: one element missing from each run gives t elements that
// never meet.
Bound end_to_end(const Parameters& p) {
  const std::uint64_t reach = ceil_div(p.v - p.k, p.change);
  const std::uint64_t b = checked_add(checked_multiply(p.strength, reach), 1);
  const std::string entering = p.change == 1 ? "at most 1 element enters"
                                             : fmt::format("at most {} elements enter", p.change);
  if (p.strength == 2) {
    return {b, "end to end",
            fmt::format("{5} a step, so some x is in none of the first ceil(({1}-{2})/{0}) = {6} "
                        "and some y in none of the last {3}: b >= 2*{3} + 1 = {4}",
                        p.change, p.v, p.k, reach, b, entering, count_of(reach, "block"))};
  }
  return {
      b, "end to end",
      fmt::format("{6} a step, so ceil(({1}-{2})/{0}) = {7} in a row lack some element, "
                  "and {4} runs of {3} lack {4} that never meet: b >= {4}*{3} + 1 = {5}",
                  p.change, p.v, p.k, reach, p.strength, b, entering, count_of(reach, "block"))};
}

bool is_circular_14_5(const Parameters& p) {
  return p.strength == 2 && p.change == 1 && p.kind == Kind::circular && p.k == 5 && p.v == 14;
}

Bound of_degree_program(const Parameters& p, std::uint64_t b) {
  constexpr std::uint64_t largest_m_of_stays = 3;
  return {
      b, "degree program",
      fmt::format(
          "with {0} let x be introduced i_x >= 1 times, and e_x >= 0 be its new meetings beyond "
          "v-1; then e_x >= i_x(k-1)-(v-1), the difference is a multiple of m = {1}, e_x is at "
          "most half of the sum of all, and x fits into the blocks{2}. No whole numbers with the "
          "right sums{3} do (docs/theorems.md, Theorem 35): b >= {4}",
          count_of(b - 1, "block"), p.change,
          p.kind == Kind::circular ? ", whatever is in every block" : "",
          p.change > largest_m_of_stays ? "" : " and the stays of Theorem 5", b)};
}

std::uint64_t largest(const std::vector<Bound>& bounds) {
  return std::ranges::max_element(bounds, {}, &Bound::blocks)->blocks;
}

void add_if_larger(std::vector<Bound>& bounds, std::optional<Bound> bound) {
  if (bound && bound->blocks > largest(bounds)) {
    bounds.push_back(*std::move(bound));
  }
}

}  // namespace

std::vector<Bound> lower_bounds(const Parameters& p) {
  check(p);
  if (p.v == p.k) {
    return {{1, "trivial", "one block holds all elements"}};
  }
  std::vector<Bound> bounds;
  if (p.kind == Kind::circular) {
    circular_bounds(p, bounds);
  } else {
    bounds.push_back(linear_counting(p));
    if (p.strength == 2) {
      const ForcedExcess forced = forced_excess(p);
      if (forced.each > 0) {
        bounds.push_back(linear_degree(p, forced));
      }
    }
  }
  bounds.push_back(end_to_end(p));
  bounds.push_back(stays(p));
  add_if_larger(bounds, returning(p));
  add_if_larger(bounds, steiner_system(p));
  add_if_larger(bounds, complements(p));
  add_if_larger(bounds, one_left_out(p));
  const std::uint64_t known = largest(bounds);
  const std::optional<std::uint64_t> program = degree_program(p, known);
  if (program && *program > known) {
    bounds.push_back(of_degree_program(p, *program));
  }
  if (is_circular_14_5(p)) {
    bounds.push_back({24, "all lists",
                      "with 23 blocks each element has one or two stays; a search through all such "
                      "lists finds none (docs/theorems.md, Theorem 29): b >= 24"});
  }
  if (const auto searched = excluded_below(p)) {
    bounds.push_back(
        {*searched, "checked proofs",
         fmt::format(
             "fewer than {} are excluded by SAT with checked DRAT proofs, which this "
             "command writes: changeover search {} {} --change {} --{}{} --exact --proof DIR",
             count_of(*searched, "block"), p.v, p.k, p.change, to_string(p.kind),
             p.strength == 2 ? "" : fmt::format(" --strength {}", p.strength))});
  }
  std::ranges::stable_sort(bounds, std::ranges::greater(), &Bound::blocks);
  return bounds;
}

Bound lower_bound(const Parameters& p) { return lower_bounds(p).front(); }

}  // namespace changeover
