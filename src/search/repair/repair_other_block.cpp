#include "search/repair/repair_other_block.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/contains.hpp"
#include "search/repair/repair_cover.hpp"
#include "search/subset_ranks.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t most_counted_subsets = 1U << 27U;

class OtherBlock {
  // The elements that both neighbors of a block have, only one or neither; first the `least` ones
  // that must be in the block, then those that are in it now.
  struct Alike {
    Block elements;
    std::size_t least = 0;
  };
  using Kinds = std::array<Alike, 4>;

 public:
  explicit OtherBlock(const Design& list)
      : p_(list.parameters()),
        ranks_(p_.v, p_.strength),
        times_(static_cast<std::size_t>(binomial(p_.v, p_.strength)), 0) {
    for (std::size_t i = 0; i < list.block_count(); ++i) {
      blocks_.push_back(block_of(list, i));
      ranks_.for_each_rank(blocks_[i], [&](std::uint64_t rank) {
        times(rank) = static_cast<std::uint8_t>(std::min(times(rank) + 1, 2));
      });
    }
    find_uncovered();
    for (std::size_t i = 0; i + 1 < blocks_.size() || (is_circular() && i < blocks_.size()); ++i) {
      if (!fit(blocks_[i], blocks_[next(i)])) {
        wrong_.push_back(i);
      }
    }
  }

  std::optional<Design> found() {
    std::optional<std::size_t> best;
    Block other;
    for (std::size_t i = 0; i < blocks_.size() && uncovered_.size() <= p_.k; ++i) {
      stop_if_asked();
      if (is_only_fault(i)) {
        if (auto block = instead_of(i)) {
          best = i;
          other = std::move(*block);
        }
      }
    }
    if (!best) {
      return std::nullopt;
    }
    blocks_[*best] = std::move(other);
    return Design(p_, blocks_);
  }

 private:
  [[nodiscard]] bool is_circular() const { return p_.kind == Kind::circular; }
  [[nodiscard]] std::size_t next(std::size_t i) const { return (i + 1) % blocks_.size(); }
  [[nodiscard]] bool fit(const Block& one, const Block& other) const {
    return difference(one, other).size() == p_.change;
  }

  // How often a t-subset is covered: 0, 1, or 2 for more.
  [[nodiscard]] std::uint8_t& times(std::uint64_t rank) {
    return times_[static_cast<std::size_t>(rank)];
  }

  // The elements of what is covered nowhere; if they are more than k, only some of them.
  void find_uncovered() {
    for (std::uint64_t rank = 0; rank < times_.size() && uncovered_.size() <= p_.k; ++rank) {
      if (times(rank) == 0) {
        for (const Element x : ranks_.subset(rank)) {
          if (!contains(uncovered_, x)) {
            uncovered_.push_back(x);
          }
        }
      }
    }
  }

  // All wrong steps begin or end at block i.
  [[nodiscard]] bool is_only_fault(std::size_t i) const {
    return std::ranges::all_of(wrong_, [&](std::size_t w) { return w == i || next(w) == i; });
  }

  // A block that can take the place of block i and keeps more of it than any before, if there is
  // one.
  std::optional<Block> instead_of(std::size_t i) {
    const Block& given = blocks_[i];
    std::vector<bool> is_wanted(p_.v);
    for (const Element x : uncovered_) {
      is_wanted[x] = true;
    }
    ranks_.for_each_rank(given, [&](std::uint64_t rank) {
      if (times(rank) == 1) {
        for (const Element x : ranks_.subset(rank)) {
          is_wanted[x] = true;
        }
      }
    });
    const bool is_last = !is_circular() && i + 1 == blocks_.size();
    const bool is_first = !is_circular() && i == 0;
    const Block& before = blocks_[is_first ? 1 : (i + blocks_.size() - 1) % blocks_.size()];
    const Block& after = is_last ? before : blocks_[next(i)];
    std::vector<std::uint8_t> kind(p_.v, 0);
    for (const Element x : before) {
      kind[x] |= 1U;
    }
    for (const Element x : after) {
      kind[x] |= 2U;
    }
    std::vector<bool> is_given(p_.v);
    for (const Element x : given) {
      is_given[x] = true;
    }
    Kinds kinds;
    for (const auto& [wanted, here] : {std::pair(true, true), std::pair(true, false),
                                       std::pair(false, true), std::pair(false, false)}) {
      for (Element x = 0; x < p_.v; ++x) {
        if (is_wanted[x] == wanted && is_given[x] == here) {
          Alike& of = kinds.at(kind[x]);
          of.elements.push_back(x);
          of.least += wanted ? 1 : 0;
        }
      }
    }
    return best_of(kinds, given);
  }

  // A block with as many elements of each kind as it needs, those of greatest use first.
  std::optional<Block> best_of(const Kinds& kinds, const Block& given) {
    const std::size_t stays = p_.k - p_.change;
    std::optional<Block> best;
    for (std::size_t both = 0; both <= stays; ++both) {
      const std::size_t only = stays - both;
      if (both + 2 * only > p_.k) {
        continue;
      }
      Block block;
      const std::array<std::size_t, 4> counts{p_.k - both - 2 * only, only, only, both};
      bool is_possible = true;
      for (std::size_t of = 0; of < counts.size() && is_possible; ++of) {
        const auto& [elements, least] = kinds.at(of);
        const std::size_t count = counts.at(of);
        is_possible = least <= count && count <= elements.size();
        const auto begin = elements.begin();
        block.insert(block.end(), begin,
                     begin + static_cast<std::ptrdiff_t>(is_possible ? count : 0));
      }
      const std::size_t kept = p_.k - difference(given, block).size();
      if (is_possible && (!most_kept_ || kept > *most_kept_)) {
        most_kept_ = kept;
        best = std::move(block);
      }
    }
    return best;
  }

  Parameters p_;
  SubsetRanks ranks_;
  std::vector<std::uint8_t> times_;  // how many blocks cover each t-subset; 2 for more
  std::vector<Block> blocks_;
  Block uncovered_;
  std::vector<std::size_t> wrong_;  // steps, by the block where each begins
  std::optional<std::size_t> most_kept_;
};

}  // namespace

std::optional<Design> with_another_block(const Design& list) {
  const Parameters& p = list.parameters();
  if (list.block_count() < 2 || binomial(p.v, p.strength) > most_counted_subsets) {
    return std::nullopt;
  }
  return OtherBlock(list).found();
}

}  // namespace changeover
