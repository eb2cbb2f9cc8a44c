#include "search/repair/repair_cover.hpp"

#include <algorithm>
#include <cstdint>

#include "changeover/core/design.hpp"
#include "changeover/run/control.hpp"
#include "construct/tools/path.hpp"
#include "search/local/random_list.hpp"

namespace changeover {
namespace {

constexpr int samples_per_step = 48;

// A block that contains `wanted`, and otherwise as much of `here` as possible.
Block block_around(const Block& wanted, const Block& here) {
  Block block = wanted;
  for (const Element x : here) {
    if (block.size() < here.size() && std::ranges::find(wanted, x) == wanted.end()) {
      block.push_back(x);
    }
  }
  return block;
}

// Appends blocks up to `to`: at least one, except if `to` is one step away and `with_end` is false.
void walk_to(Design& list, CoveredSubsets& covered, const Block& to, bool with_end) {
  const auto last = list.block(list.block_count() - 1);
  const Parameters& p = list.parameters();
  std::vector<Block> way = connecting_blocks(Block(last.begin(), last.end()), to, p.change, p.v);
  if (with_end) {
    way.push_back(to);
  }
  for (const Block& block : way) {
    list.append(block);
    covered.insert(block);
  }
}

}  // namespace

Design cover_the_rest(const Design& list, Random& random) {
  Design result = list;
  result.recipe.reset();
  const Parameters& p = list.parameters();
  CoveredSubsets covered(p);
  for (std::size_t i = 0; i < list.block_count(); ++i) {
    covered.insert(list.block(i));
  }
  while (const auto wanted = covered.first_missing()) {
    stop_if_asked();
    if (progress_due()) {
      report_progress({.phase = "adding blocks",
                       .steps = result.block_count(),
                       .unit = "blocks",
                       .missing = covered.missing()});
    }
    const auto last = result.block(result.block_count() - 1);
    const Block here(last.begin(), last.end());
    Block best;
    std::uint64_t most = 0;
    for (int sample = 0; sample < samples_per_step; ++sample) {
      Block next = random_step(here, p, random);
      if (const std::uint64_t gain = covered.gain(next); gain > most) {
        most = gain;
        best = std::move(next);
      }
    }
    if (most > 0) {
      result.append(best);
      covered.insert(best);
    } else {
      walk_to(result, covered, block_around(*wanted, here), true);
    }
  }
  if (p.kind == Kind::circular && result.block_count() > 1) {
    const auto first = result.block(0);
    const auto last = result.block(result.block_count() - 1);
    const Block goal(first.begin(), first.end());
    if (difference(goal, last).size() != p.change) {
      walk_to(result, covered, goal, false);
    }
  }
  return result;
}

}  // namespace changeover
