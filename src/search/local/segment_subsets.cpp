#include "search/local/segment_subsets.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t most_subsets = std::uint64_t{1} << 28;
constexpr std::uint32_t samples = 8;

}  // namespace

std::uint64_t SegmentSubsets::bytes(const Parameters& p, std::uint64_t b) {
  // Counters, places, and the list of uncovered subsets, which doubles when it grows.
  const std::uint64_t counters =
      checked_multiply(binomial(p.v, p.strength), 4 * sizeof(std::uint32_t));
  const std::uint64_t choices = checked_multiply(p.strength + 1, 8 * (p.v + 1));
  const std::uint64_t blocks = checked_multiply(b, checked_add(p.v, checked_multiply(2, p.k)));
  return checked_add(checked_add(counters, choices), blocks);
}

SegmentSubsets::SegmentSubsets(const Design& design, std::size_t frozen)
    : parameters_(design.parameters()),
      v_(static_cast<std::uint32_t>(design.v())),
      k_(static_cast<std::uint32_t>(design.k())),
      t_(design.parameters().strength),
      b_(static_cast<std::uint32_t>(design.block_count())),
      frozen_(static_cast<std::uint32_t>(frozen)),
      usual_(usual_segment(design.k(), design.parameters().change)),
      circular_(design.parameters().kind == Kind::circular),
      ranks_(v_, t_) {
  const std::uint64_t subsets = binomial(v_, t_);
  if (subsets > most_subsets) {
    throw MissingResource(fmt::format(
        "local search would need counters for {} subsets of {} elements; at most {} are supported",
        subsets, t_, most_subsets));
  }
  coverage_ = Coverage(std::vector<std::uint32_t>(static_cast<std::size_t>(subsets), 0));
  members_.assign(std::size_t{b_} * v_, 0);
  for (std::uint32_t i = 0; i < b_; ++i) {
    const auto block = design.block(i);
    for (const Element x : block) {
      members_[std::size_t{i} * v_ + x] = 1;
      elements_.push_back(static_cast<std::uint16_t>(x));
    }
    // Each subset is counted once: with its largest element.
    Block sorted(block.begin(), block.end());
    std::ranges::sort(sorted);
    for (std::size_t at = t_ - 1; at < sorted.size(); ++at) {
      stop_if_asked();
      others_.assign(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(at));
      count_with<true>(sorted[at], 0, 0, 0, 0);
    }
  }
}

// Counts every set of x and t − 1 elements of others_. `chosen` elements are selected already,
// `below` of them smaller than x, with rank `rank`; the others come from others_[from…].
template <bool Adding>
void SegmentSubsets::count_with(Element x, std::uint32_t from, std::uint32_t chosen,
                                std::uint32_t below, std::uint64_t rank) {
  if (chosen + 1 == t_) {
    const auto whole = static_cast<std::size_t>(rank + ranks_.choose(x, below + 1));
    Adding ? coverage_.add(whole) : coverage_.remove(whole);
    return;
  }
  for (auto at = from; at < others_.size(); ++at) {
    const Element z = others_[at];
    const std::uint32_t larger = z > x ? 1 : 0;
    count_with<Adding>(x, at + 1, chosen + 1, below + 1 - larger,
                       rank + ranks_.choose(z, chosen + larger + 1));
  }
}

Design SegmentSubsets::design() const {
  Design design(parameters_);
  for (std::uint32_t i = 0; i < b_; ++i) {
    const auto elements = block(i);
    design.append(Block(elements.begin(), elements.end()));
  }
  return design;
}

SegmentSwap SegmentSubsets::segment(std::uint32_t i, Element x, Element y,
                                    std::uint32_t longest) const {
  SegmentSwap move = find_segment(b_, circular_, longest, i, x, y, [&](std::uint32_t block) {
    return contains(block, x) != contains(block, y);
  });
  if (move.first < frozen_ || (frozen_ > 0 && move.first + move.length > b_)) {
    move.length = 0;
  }
  return move;
}

SegmentSwap SegmentSubsets::propose(Random& random) const {
  const std::uint32_t i = frozen_ + random.below(b_ - frozen_);
  const Element x = block(i)[random.below(k_)];
  Element y = random.below(v_);
  while (contains(i, y)) {
    y = random.below(v_);
  }
  return segment(i, x, y, (random.next() >> 60) == 0 ? b_ : usual_);
}

SegmentSwap SegmentSubsets::propose_aimed(Random& random) const {
  const auto which = random.below(coverage_.missing());
  const Block wanted = ranks_.subset(coverage_.uncovered(which));
  // Of a few random blocks, the one that contains most of the uncovered subset.
  std::uint32_t best = frozen_;
  std::uint32_t most = 0;
  for (std::uint32_t sample = 0; sample < samples; ++sample) {
    const std::uint32_t i = frozen_ + random.below(b_ - frozen_);
    const auto has = static_cast<std::uint32_t>(
        std::ranges::count_if(wanted, [&](Element z) { return contains(i, z); }));
    if (sample == 0 || has > most) {
      best = i;
      most = has;
    }
  }
  const std::uint32_t missing = random.below(t_ - most);
  Element y = 0;
  for (std::uint32_t at = 0, seen = 0; at < t_; ++at) {
    if (!contains(best, wanted[at]) && seen++ == missing) {
      y = wanted[at];
    }
  }
  const auto is_wanted = [&](Element z) { return std::ranges::find(wanted, z) != wanted.end(); };
  Element x = block(best)[random.below(k_)];
  while (most < k_ && is_wanted(x)) {
    x = block(best)[random.below(k_)];
  }
  return segment(best, x, y, (random.next() >> 60) == 0 ? b_ : usual_);
}

void SegmentSubsets::exchange(const SegmentSwap& move) {
  std::uint32_t i = move.first;
  for (std::uint32_t step = 0; step < move.length; ++step) {
    std::uint8_t* row = members_.data() + std::size_t{i} * v_;
    const Element out = row[move.x] != 0 ? move.x : move.y;
    const Element in = row[move.x] != 0 ? move.y : move.x;
    std::uint16_t* elements = elements_.data() + std::size_t{i} * k_;
    std::uint16_t* place = std::find(elements, elements + k_, static_cast<std::uint16_t>(out));
    others_.assign(elements, elements + k_);
    others_.erase(others_.begin() + (place - elements));
    std::ranges::sort(others_);
    count_with<false>(out, 0, 0, 0, 0);
    count_with<true>(in, 0, 0, 0, 0);
    row[out] = 0;
    row[in] = 1;
    *place = static_cast<std::uint16_t>(in);
    i = i + 1 == b_ ? 0 : i + 1;
  }
}

}  // namespace changeover
