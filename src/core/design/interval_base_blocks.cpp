#include "changeover/core/developed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

void check_interval(const Parameters& p, std::uint64_t start, std::uint64_t length) {
  check(p);
  if (start >= p.v) {
    throw BadInput(fmt::format("the interval starts at {}, not below v = {}", start, p.v));
  }
  if (length >= p.k) {
    throw BadInput(fmt::format("an interval of {} leaves no point in a block of k = {}",
                               count_of(length, "element"), p.k));
  }
}

// Writes {first, …, first+n−1} modulo v, n = interval.size().
void write_interval(std::uint64_t first, std::uint64_t v, std::span<Element> interval) {
  const auto up_to_v = interval.begin() + static_cast<std::ptrdiff_t>(
                                              std::min<std::uint64_t>(interval.size(), v - first));
  std::iota(interval.begin(), up_to_v, static_cast<Element>(first));
  std::iota(up_to_v, interval.end(), Element{0});
}

}  // namespace

std::uint64_t IntervalBaseBlocks::block_count() const {
  return checked_multiply(base_block_count(), parameters.v);
}

BaseBlocks IntervalBaseBlocks::written_out() const {
  check_shape(*this);
  const auto n = static_cast<std::size_t>(length);
  BaseBlocks base{parameters, {}};
  base.blocks.reserve(base_block_count());
  for (std::size_t i = 0; i < base_block_count(); ++i) {
    const std::span<const Element> extra = points_of(i);
    Block block(n + extra.size());
    write_interval(start, parameters.v, std::span(block).first(n));
    std::ranges::copy(extra, block.begin() + static_cast<std::ptrdiff_t>(n));
    base.blocks.push_back(std::move(block));
  }
  return base;
}

void check_shape(const IntervalBaseBlocks& base) {
  const Parameters& p = base.parameters;
  check_interval(p, base.start, base.length);
  const std::uint64_t each = base.points_per_block();
  if (base.points.empty() || base.points.size() % each != 0) {
    throw BadInput(fmt::format("{} cannot be shared out among base blocks: each takes {}",
                               count_of(base.points.size(), "point"), each));
  }
  for (std::size_t i = 0; i < base.points.size(); ++i) {
    if (base.points[i] >= p.v) {
      throw BadInput(fmt::format("base block {}: element {} is not below v = {}", i / each + 1,
                                 base.points[i], p.v));
    }
  }
}

IntervalDevelopedSource::IntervalDevelopedSource(const Parameters& parameters, std::uint64_t start,
                                                 std::uint64_t length, std::uint64_t base_blocks,
                                                 Points points)
    : parameters_(parameters),
      start_(start),
      length_(length),
      base_blocks_(base_blocks),
      points_(std::move(points)) {
  check_interval(parameters, start, length);
  if (base_blocks == 0) {
    throw BadInput("no base blocks: give at least one");
  }
  (void)checked_multiply(base_blocks, parameters.v);
}

IntervalDevelopedSource::IntervalDevelopedSource(IntervalBaseBlocks base)
    : parameters_(base.parameters), start_(base.start), length_(base.length), base_blocks_(0) {
  check_shape(base);
  base_blocks_ = base.base_block_count();
  (void)base.block_count();
  points_ = [kept = std::make_shared<const IntervalBaseBlocks>(std::move(base))](
                std::uint64_t which, std::span<Element> points) {
    std::ranges::copy(kept->points_of(static_cast<std::size_t>(which)), points.begin());
  };
}

// Writes the points of base block which_, not shifted.
void IntervalDevelopedSource::write_points(std::span<Element> points) {
  constexpr std::uint64_t most_kept = std::uint64_t{1} << 16;
  if (base_blocks_ > most_kept / points.size()) {
    points_(which_, points);
    return;
  }
  const std::size_t at = static_cast<std::size_t>(which_) * points.size();
  if (at == kept_points_.size()) {
    kept_points_.resize(at + points.size());
    points_(which_, std::span(kept_points_).last(points.size()));
  }
  std::copy_n(kept_points_.begin() + static_cast<std::ptrdiff_t>(at), points.size(),
              points.begin());
}

std::span<const Element> IntervalDevelopedSource::read(std::span<Element> room) {
  const std::uint64_t v = parameters_.v;
  const auto modulo_v = [v](std::uint64_t sum) { return sum >= v ? sum - v : sum; };
  const auto k = static_cast<std::size_t>(parameters_.k);
  const auto n = static_cast<std::size_t>(length_);
  std::size_t filled = 0;
  for (; shift_ < v && room.size() - filled >= k; filled += k) {
    write_interval(modulo_v(start_ + shift_), v, room.subspan(filled, n));
    const std::span<Element> points = room.subspan(filled + n, k - n);
    write_points(points);
    for (Element& x : points) {
      x = static_cast<Element>(modulo_v(x + shift_));
    }
    if (++which_ == base_blocks_) {
      which_ = 0;
      ++shift_;
    }
  }
  return room.first(filled);
}

}  // namespace changeover
