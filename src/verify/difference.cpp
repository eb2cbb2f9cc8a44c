#include "changeover/verify/difference.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "core/checked.hpp"

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

}  // namespace

DifferenceVerdict verify_differences(const BaseBlocks& base) {
  const Parameters& p = base.parameters;
  check(p);
  if (p.strength != 2) {
    throw ImpossibleParameters("differences certify pairs only: use strength 2");
  }
  if (base.blocks.empty()) {
    throw BadInput("no base blocks: give at least one");
  }
  const std::size_t c = base.blocks.size();
  DifferenceVerdict verdict;
  verdict.b = base.block_count();

  // Before B_0 comes the last base block of the round before: B_{c−1} − 1.
  Block previous = sorted_and_checked(base.blocks.back(), c, p);
  for (Element& x : previous) {
    x = x == 0 ? static_cast<Element>(p.v - 1) : x - 1;
  }
  std::sort(previous.begin(), previous.end());

  std::vector<bool> seen(static_cast<std::size_t>(p.v / 2 + 1), false);
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
        const Element x = introduced[a];
        const std::uint64_t d = x < y ? y - x : x - y;
        seen[static_cast<std::size_t>(std::min(d, p.v - d))] = true;
        ++newly_covered;
      };
      std::for_each(kept.begin(), kept.end(), mark);
      std::for_each(introduced.begin(), introduced.begin() + static_cast<std::ptrdiff_t>(a), mark);
    }
    previous = std::move(block);
  }

  if (p.k == p.v) {  // every block is Z_v: nothing ever changes, everything occurs
    return verdict;
  }
  // No element is in every translate of a base block, so a pair that occurs is newly covered
  // somewhere.
  std::uint64_t distinct = 0;
  for (std::uint64_t d = 1; d <= p.v / 2; ++d) {
    if (seen[static_cast<std::size_t>(d)]) {
      distinct += 2 * d == p.v ? p.v / 2 : p.v;
    } else {
      ++verdict.uncovered;
      if (verdict.uncovered_examples.size() < DifferenceVerdict::most_examples) {
        verdict.uncovered_examples.push_back(d);
      }
    }
  }
  verdict.excess = checked_multiply(newly_covered, p.v) - distinct;
  verdict.tight = verdict.valid() && verdict.excess == 0;
  return verdict;
}

}  // namespace changeover
