#include "search/local/segment_orbits.hpp"

#include <algorithm>
#include <utility>

#include "changeover/run/control.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

constexpr std::uint32_t most_tries = 200;

}  // namespace

std::uint64_t SegmentOrbits::bytes(const Parameters& p, const Automorphism& pi, std::uint64_t c) {
  const std::uint64_t pairs = checked_multiply(p.v, p.v);
  const std::uint64_t images = checked_multiply(2 * p.v, pi.n);
  // In the worst case every pair is an orbit; lists double when they grow.
  const std::uint64_t orbits = pairs / 2 / pi.n + 2 * p.v;
  const std::uint64_t blocks = checked_multiply(c, checked_add(p.v, checked_multiply(2, p.k)));
  return checked_add(checked_add(checked_multiply(4, pairs), images),
                     checked_add(checked_multiply(24, orbits), blocks));
}

SegmentOrbits::SegmentOrbits(const Parameters& p, const Automorphism& pi,
                             std::span<const Block> base_blocks)
    : parameters_(p.as(Kind::circular)),
      pi_(pi),
      n_(static_cast<std::uint32_t>(pi.n)),
      v_(static_cast<std::uint32_t>(p.v)),
      k_(static_cast<std::uint32_t>(p.k)),
      c_(static_cast<std::uint32_t>(base_blocks.size())),
      usual_(usual_segment(p.k, p.change)),
      images_(std::size_t{n_} * v_),
      orbits_(pi),
      members_(std::size_t{c_} * v_, 0) {
  for (std::uint32_t s = 0; s < n_; ++s) {
    stop_if_asked();
    for (Element x = 0; x < v_; ++x) {
      images_[std::size_t{s} * v_ + x] = static_cast<std::uint16_t>(pi.image(x, s));
    }
  }
  std::vector<std::uint32_t> counts(orbits_.count(), 0);
  for (std::uint32_t i = 0; i < c_; ++i) {
    stop_if_asked();
    const Block& block = base_blocks[i];
    for (std::size_t a = 0; a < block.size(); ++a) {
      members_[std::size_t{i} * v_ + block[a]] = 1;
      elements_.push_back(static_cast<std::uint16_t>(block[a]));
      for (std::size_t d = 0; d < a; ++d) {
        ++counts[orbits_.of(block[a], block[d])];
      }
    }
  }
  coverage_ = Coverage(std::move(counts));
}

Design SegmentOrbits::design() const {
  Design design(parameters_);
  Block block(k_);
  for (std::uint32_t s = 0; s < n_; ++s) {
    for (std::uint32_t i = 0; i < c_; ++i) {
      for (std::uint32_t at = 0; at < k_; ++at) {
        block[at] = image(elements_[std::size_t{i} * k_ + at], s);
      }
      design.append(block);
    }
  }
  return design;
}

SegmentSwap SegmentOrbits::segment(std::uint32_t i, Element x, Element y) const {
  const std::uint64_t longest = std::min<std::uint64_t>(pi_.meets_itself(x, y) * c_ - 1, usual_);
  SegmentSwap move{n_ * c_ + i, 1, x, y};
  // Block q·c + i holds x if base block i holds π⁻ᵠ(x); `turn` is −q modulo n.
  const auto differ = [&](std::uint32_t block, std::uint32_t turn) {
    return contains(block, image(x, turn)) != contains(block, image(y, turn));
  };
  for (std::uint32_t at = i, turn = 0; move.length <= longest;) {
    if (at == 0) {
      at = c_;
      turn = turn + 1 == n_ ? 0 : turn + 1;
    }
    --at;
    if (!differ(at, turn)) {
      break;
    }
    --move.first;
    ++move.length;
  }
  for (std::uint32_t at = i, turn = 0; move.length <= longest;) {
    if (++at == c_) {
      at = 0;
      turn = turn == 0 ? n_ - 1 : turn - 1;
    }
    if (!differ(at, turn)) {
      break;
    }
    ++move.length;
  }
  if (move.length > longest) {
    move.length = 0;
  }
  return move;
}

SegmentSwap SegmentOrbits::propose(Random& random) const {
  const std::uint32_t i = random.below(c_);
  const Element x = block(i)[random.below(k_)];
  Element y = random.below(v_);
  while (contains(i, y)) {
    y = random.below(v_);
  }
  return segment(i, x, y);
}

SegmentSwap SegmentOrbits::propose_aimed(Random& random) const {
  const auto which = random.below(coverage_.missing());
  auto [p, q] = orbits_.representative(coverage_.uncovered(which));
  if (random.one_in_two()) {
    std::swap(p, q);
  }
  for (std::uint32_t tries = 0; tries < most_tries; ++tries) {
    const std::uint32_t turn = random.below(n_);
    const std::uint32_t i = random.below(c_);
    const Element there = image(p, turn);
    if (!contains(i, there)) {
      continue;
    }
    const Element y = image(q, pi_.moves(p) ? turn : random.below(n_));
    if (contains(i, y)) {
      continue;
    }
    Element x = block(i)[random.below(k_)];
    while (x == there && k_ > 1) {
      x = block(i)[random.below(k_)];
    }
    return segment(i, x, y);
  }
  return propose(random);
}

// Changes the counters, block by block, and changes them back. A base block that a segment reaches
// twice would have to change in between; such moves are made and undone.
std::int32_t SegmentOrbits::look(const SegmentSwap& move) {
  if (move.length > c_) {
    const auto before = static_cast<std::int32_t>(coverage_.missing());
    exchange(move);
    const auto after = static_cast<std::int32_t>(coverage_.missing());
    exchange(move);
    return after - before;
  }
  std::int32_t change = 0;
  visit_counters(move, [&](std::uint32_t& loses, std::uint32_t& gains) {
    change += --loses == 0 ? 1 : 0;
    change -= gains++ == 0 ? 1 : 0;
  });
  visit_counters(move, [](std::uint32_t& loses, std::uint32_t& gains) {
    ++loses;
    --gains;
  });
  return change;
}

// Calls visit(loses, gains) with the counters of the orbits of {out,z} and {in,z}.
template <typename Visit>
void SegmentOrbits::visit_counters(const SegmentSwap& move, Visit&& visit) {
  std::uint32_t i = move.first % c_;
  std::uint32_t turn = (2 * n_ - move.first / c_) % n_;
  for (std::uint32_t step = 0; step < move.length; ++step) {
    Element out = image(move.x, turn);
    Element in = image(move.y, turn);
    if (!contains(i, out)) {
      std::swap(out, in);
    }
    const std::uint32_t* from = orbits_.row(out);
    const std::uint32_t* to = orbits_.row(in);
    const std::uint16_t* elements = elements_.data() + std::size_t{i} * k_;
    for (std::uint32_t at = 0; at < k_; ++at) {
      const std::uint16_t z = elements[at];
      if (z != out) {
        visit(coverage_.times(from[z]), coverage_.times(to[z]));
      }
    }
    if (++i == c_) {
      i = 0;
      turn = turn == 0 ? n_ - 1 : turn - 1;
    }
  }
}

void SegmentOrbits::exchange(const SegmentSwap& move) {
  for (std::uint32_t step = 0; step < move.length; ++step) {
    const std::uint32_t at = move.first + step;
    const std::uint32_t i = at % c_;
    const std::uint32_t turn = (2 * n_ - at / c_) % n_;
    Element out = image(move.x, turn);
    Element in = image(move.y, turn);
    if (!contains(i, out)) {
      std::swap(out, in);
    }
    std::uint8_t* row = members_.data() + std::size_t{i} * v_;
    row[out] = 0;
    row[in] = 1;
    const std::uint32_t* from = orbits_.row(out);
    const std::uint32_t* to = orbits_.row(in);
    std::uint16_t* elements = elements_.data() + std::size_t{i} * k_;
    std::uint32_t place = 0;
    for (std::uint32_t z = 0; z < k_; ++z) {
      if (elements[z] == out) {
        place = z;
      } else {
        coverage_.remove(from[elements[z]]);
        coverage_.add(to[elements[z]]);
      }
    }
    elements[place] = static_cast<std::uint16_t>(in);
  }
}

}  // namespace changeover
