#include "construct/tools/extended_minima.hpp"

#include <fmt/format.h>

#include "construct/entry.hpp"
#include "construct/expansion/single_change_extension.hpp"
#include "construct/tools/short_blocks.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

// The largest v whose expansion set is written down.
constexpr std::uint64_t largest_expansion_set = std::uint64_t{1} << 20;

std::uint64_t listed_count(const ListedMinimum& listed, std::uint64_t k) {
  return (listed.blocks.size() + 1) / (k + 1);
}

std::uint64_t rounds_to(const Parameters& p, const ListedMinimum& listed) {
  return (p.v - listed.v) / (2 * (p.k - 1));
}

Design design_of(Parameters p, const ListedMinimum& listed) {
  p.v = listed.v;
  return Design(p, short_blocks(listed.blocks));
}

}  // namespace

const ListedMinimum* ExtendedMinima::listed_for(const Parameters& p) const {
  if (!asks_for_pairs(p, 1) || p.k != k_) {
    return nullptr;
  }
  const ListedMinimum* best = nullptr;
  for (const ListedMinimum& listed : p.kind == Kind::linear ? linear_ : circular_) {
    if (listed.v <= p.v && (p.v - listed.v) % (2 * (k_ - 1)) == 0) {
      best = &listed;
    }
  }
  return best;
}

std::optional<Promise> ExtendedMinima::promise(const Parameters& p) const {
  const ListedMinimum* listed = listed_for(p);
  if (listed == nullptr) {
    return std::nullopt;
  }
  // Round r = 0, 1, … adds 2(v′ + 2(k−1)r) + 2k − 3 blocks. At most v²/2(k−1) in all, below 2⁶⁴.
  const std::uint64_t rounds = rounds_to(p, *listed);
  std::uint64_t b = listed_count(*listed, k_);
  if (rounds > 0) {
    b += rounds * (2 * (listed->v + k_) - 3) + 2 * (k_ - 1) * rounds * (rounds - 1);
  }
  const std::uint64_t first = p.kind == Kind::linear ? 1 : 0;  // covers all its pairs
  const std::uint64_t pairs = binomial(p.v, 2) - first * binomial(k_, 2);
  const bool tight = (b - first) * (k_ - 1) == pairs;
  const bool economical = b == ceil_div(pairs, k_ - 1) + first;
  const bool expansion_set = listed->expansion_set && p.v <= largest_expansion_set;
  return Promise{b, tight, economical, expansion_set};
}

std::unique_ptr<BlockSource> ExtendedMinima::blocks(const Parameters& p) const {
  const ListedMinimum& listed = *listed_for(p);
  const std::uint64_t rounds = rounds_to(p, listed);
  if (rounds == 0) {
    return std::make_unique<BlockListSource>(p, short_blocks(listed.blocks));
  }
  return extend_single_change(design_of(p, listed), rounds);
}

std::optional<std::vector<UnchangedSubset>> ExtendedMinima::expansion_set(const Recipe& recipe,
                                                                          const Registry&) const {
  const Parameters& p = required(recipe);
  const ListedMinimum& listed = *listed_for(p);
  if (!listed.expansion_set || p.v > largest_expansion_set) {
    return std::nullopt;
  }
  return extended_expansion_set(design_of(p, listed), rounds_to(p, listed));
}

std::string ExtendedMinima::explanation(const Parameters& p) const {
  const ListedMinimum& listed = *listed_for(p);
  const std::uint64_t rounds = rounds_to(p, listed);
  const std::uint64_t count = listed_count(listed, k_);
  if (rounds == 0) {
    return fmt::format("A list of {}.", count_of(count, "block"));
  }
  return fmt::format(
      "Extend a listed {} of {} blocks {} by {} elements: two sets of {} are held "
      "beside almost every old one.",
      changeover::name(p.on(listed.v)), count,
      rounds == 1 ? "once" : fmt::format("{} times", rounds), 2 * (k_ - 1),
      count_of(k_ - 1, "new element"));
}

}  // namespace changeover
