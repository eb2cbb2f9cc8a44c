#include "search/local/imposed.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "search/local/random_list.hpp"
#include "search/local/segment_orbits.hpp"

namespace changeover {
namespace {

constexpr int most_imposed_starts = 400;
constexpr std::uint64_t largest_imposed_v = 4096;

// A block of about `pieces` pieces of cycles, so that π moves at most that many elements out of it.
Block block_of_pieces(const Parameters& p, const Automorphism& pi, std::uint32_t pieces,
                      Random& random) {
  const auto v = static_cast<std::uint32_t>(p.v);
  std::vector<bool> taken(v, false);
  Block block;
  const auto take = [&](Element x) {
    if (!taken[x]) {
      taken[x] = true;
      block.push_back(x);
    }
    return block.size() == p.k;
  };
  for (std::uint32_t i = 0; i < pieces && block.size() < p.k; ++i) {
    take(random.below(v));
  }
  for (std::uint32_t tries = 0; block.size() < p.k; ++tries) {
    const Element x = block[random.below(static_cast<std::uint32_t>(block.size()))];
    take(tries < 50 * v ? pi.image(x, 1) : random.below(v));
  }
  return block;
}

}  // namespace

std::vector<Automorphism> imposed_automorphisms(std::uint64_t v) {
  std::vector<Automorphism> all;
  for (std::uint64_t n = v; n >= 2; --n) {
    for (std::uint64_t f = 0; f <= 2 && f < v; ++f) {
      if (const auto pi = Automorphism::on(v, n, f); pi && pi->cycles > 0) {
        all.push_back(*pi);
      }
    }
  }
  return all;
}

std::uint64_t fewest_base_blocks(const Parameters& p, const Automorphism& pi) {
  return std::max<std::uint64_t>(1, ceil_div(pi.pair_orbits(), newly_covered_at_most(p)));
}

std::optional<std::vector<Block>> random_base_blocks(const Parameters& p, const Automorphism& pi,
                                                     std::size_t base_blocks, Random& random) {
  for (int start = 0; start < most_imposed_starts; ++start) {
    stop_if_asked();
    const auto k = static_cast<std::uint32_t>(p.k);
    const Block first = start % 2 == 0 ? random_block(p, random)
                                       : block_of_pieces(p, pi, 1 + random.below(k), random);
    if (auto between = random_walk(first, pi.image(first, 1), base_blocks, p, random)) {
      between->insert(between->begin(), first);
      return between;
    }
  }
  return std::nullopt;
}

ImposedOutcome search_imposed(const Parameters& p, const Automorphism& pi, std::size_t base_blocks,
                              const AnnealSchedule& schedule, Random& random, RunControl& control,
                              const AnnealWatch& watch) {
  check(p);
  if (pi.v() != p.v || base_blocks == 0 || p.strength != 2 || p.v > largest_imposed_v) {
    throw BadInput(
        fmt::format("an automorphism of order {} with {} cannot be imposed on a {} with {}; "
                    "the order must divide v less the fixed elements, v ≤ {}, strength 2",
                    pi.n, count_of(pi.fixed, "fixed element"), name(p),
                    count_of(base_blocks, "base block"), largest_imposed_v));
  }
  ImposedOutcome outcome;
  const Parameters circular = p.as(Kind::circular);
  if (p.v < p.k + p.change) {
    return outcome;
  }
  const auto base = random_base_blocks(circular, pi, base_blocks, random);
  if (!base) {
    return outcome;
  }
  outcome.started = true;
  control.require_memory(SegmentOrbits::bytes(circular, pi, base_blocks),
                         "local search for the " + name(circular));
  SegmentOrbits state(circular, pi, *base);
  outcome.anneal = anneal(state, schedule, random, control, watch);
  if (outcome.anneal.missing == 0 && base_blocks * pi.n >= 3) {
    outcome.design = state.design();
  }
  return outcome;
}

}  // namespace changeover
