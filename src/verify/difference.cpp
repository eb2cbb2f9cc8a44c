#include "changeover/verify/difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "changeover/core/error.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

Block sorted_and_checked(const Block& block, std::size_t number, const Parameters& p) {
  Block sorted = block;
  std::sort(sorted.begin(), sorted.end());
  if (sorted.size() != p.k) {
    throw BadInput(
        fmt::format("base block {} has {} elements, not k = {}", number, sorted.size(), p.k));
  }
  if (sorted.back() >= p.v) {
    throw BadInput(
        fmt::format("base block {}: element {} is not below v = {}", number, sorted.back(), p.v));
  }
  const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
  if (twin != sorted.end()) {
    throw BadInput(fmt::format("base block {} repeats the element {}", number, *twin));
  }
  return sorted;
}

// The orbits of pairs under a permutation without fixed points, numbered: first the differences 1,
// …, ⌊n/2⌋ of each cycle, then those of each two cycles, 0, …, n−1.
class PairOrbits {
 public:
  explicit PairOrbits(const Automorphism& pi)
      : pi_(pi), seen_(static_cast<std::size_t>(pi.pair_orbits()), false) {}

  void mark(Element x, Element y) { seen_[static_cast<std::size_t>(number(x, y))] = true; }

  [[nodiscard]] std::uint64_t count() const { return seen_.size(); }
  [[nodiscard]] bool seen(std::uint64_t number) const {
    return seen_[static_cast<std::size_t>(number)];
  }
  [[nodiscard]] std::uint64_t pairs(std::uint64_t number) const {
    const bool halved =
        number < pi_.cycles * (pi_.n / 2) && pi_.n % 2 == 0 && (number + 1) % (pi_.n / 2) == 0;
    return halved ? pi_.n / 2 : pi_.n;
  }

 private:
  [[nodiscard]] std::uint64_t number(Element x, Element y) const {
    const auto [low, high] = std::minmax(x, y);
    const std::uint64_t one = pi_.cycle(low);
    const std::uint64_t other = pi_.cycle(high);
    const std::uint64_t apart = (pi_.residue(high) + pi_.n - pi_.residue(low)) % pi_.n;
    const std::uint64_t half = pi_.n / 2;
    return one == other ? one * half + std::min(apart, pi_.n - apart) - 1
                        : pi_.cycles * half + (other * (other - 1) / 2 + one) * pi_.n + apart;
  }

  Automorphism pi_;
  std::vector<bool> seen_;
};

void mark_all(const Block& block, PairOrbits& orbits) {
  for (std::size_t j = 1; j < block.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      orbits.mark(block[i], block[j]);
    }
  }
}

}  // namespace

DifferenceVerdict verify_differences(const BaseBlocks& base) {
  check(base.parameters);
  return verify_differences(base, {base.parameters.v, 1, 0});
}

DifferenceVerdict verify_differences(const BaseBlocks& base, const Automorphism& pi) {
  const Parameters& p = base.parameters;
  check(p);
  if (p.strength != 2) {
    throw ImpossibleParameters("differences certify pairs only: use strength 2");
  }
  if (base.blocks.empty()) {
    throw BadInput("no base blocks: give at least one");
  }
  if (pi.fixed != 0 || pi.n == 0 || pi.v() != p.v) {
    throw BadInput(fmt::format(
        "the permutation has {} of length {} and {}: use one whose cycles have all {} elements",
        count_of(pi.cycles, "cycle"), pi.n, count_of(pi.fixed, "fixed element"), p.v));
  }
  const std::size_t c = base.blocks.size();
  DifferenceVerdict verdict;
  verdict.b = checked_multiply(c, pi.n);

  // Before B_0 comes the last base block of the round before: π^{−1}(B_{c−1}).
  Block previous = pi.image(sorted_and_checked(base.blocks.back(), c, p), pi.n - 1);
  std::sort(previous.begin(), previous.end());

  PairOrbits orbits(pi);
  std::uint64_t newly_covered = 0;
  Block kept;
  Block introduced;
  for (std::size_t i = 0; i < c; ++i) {
    Block block = sorted_and_checked(base.blocks[i], i + 1, p);
    kept.clear();
    introduced.clear();
    std::set_intersection(block.begin(), block.end(), previous.begin(), previous.end(),
                          std::back_inserter(kept));
    std::set_difference(block.begin(), block.end(), previous.begin(), previous.end(),
                        std::back_inserter(introduced));
    if (introduced.size() != p.change) {
      ++verdict.bad_steps;
      // The step into B_0 is the link, the last step of a round.
      const std::uint64_t step = i == 0 ? c : i;
      verdict.first_bad_step = std::min(verdict.first_bad_step.value_or(step), step);
    }
    for (std::size_t a = 0; a < introduced.size(); ++a) {
      const auto mark = [&](Element y) {
        orbits.mark(introduced[a], y);
        ++newly_covered;
      };
      std::for_each(kept.begin(), kept.end(), mark);
      std::for_each(introduced.begin(), introduced.begin() + static_cast<std::ptrdiff_t>(a), mark);
    }
    previous = std::move(block);
  }

  if (p.k == p.v) {  // every block has all elements: nothing ever changes, everything occurs
    return verdict;
  }
  // No element is in all blocks unless its whole cycle is, so a pair that occurs is newly covered
  // somewhere, or its elements are of such cycles.
  std::optional<PairOrbits> always;
  if (p.k >= pi.n) {  // a cycle fits into a block
    mark_all(base.blocks.front(), always.emplace(pi));
  }
  std::uint64_t never_newly = 0;
  std::uint64_t distinct = 0;
  for (std::uint64_t number = 0; number < orbits.count(); ++number) {
    if (orbits.seen(number)) {
      distinct += orbits.pairs(number);
    } else if (always && always->seen(number)) {
      ++never_newly;
    } else {
      ++verdict.uncovered;
      if (pi.cycles == 1 && verdict.uncovered_examples.size() < DifferenceVerdict::most_examples) {
        verdict.uncovered_examples.push_back(number + 1);
      }
    }
  }
  verdict.excess = checked_multiply(newly_covered, pi.n) - distinct;
  verdict.tight = verdict.valid() && verdict.excess == 0 && never_newly == 0;
  return verdict;
}

}  // namespace changeover
