#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/developed.hpp"
#include "changeover/core/error.hpp"
#include "core/checked.hpp"

namespace changeover {

std::uint64_t BaseBlocks::block_count() const {
  return checked_multiply(blocks.size(), parameters.v);
}

DevelopedSource::DevelopedSource(const BaseBlocks& base)
    : DevelopedSource(base, {.n = base.parameters.v, .cycles = 1}) {}

DevelopedSource::DevelopedSource(BaseBlocks base, const Automorphism& pi, std::uint64_t shift)
    : base_(std::move(base)),
      pi_(pi),
      shift_(shift),
      block_count_(checked_multiply(base_.blocks.size(), pi.n)) {
  const Parameters& p = base_.parameters;
  check(p);
  if (base_.blocks.empty()) {
    throw BadInput("no base blocks: give at least one");
  }
  for (std::size_t i = 0; i < base_.blocks.size(); ++i) {
    const Block& block = base_.blocks[i];
    if (block.size() != p.k || std::ranges::any_of(block, [&](Element x) { return x >= p.v; })) {
      throw BadInput(
          fmt::format("base block {} does not have k = {} elements below v = {}", i + 1, p.k, p.v));
    }
  }
}

std::span<const Element> DevelopedSource::read(std::span<Element> room) {
  const auto k = static_cast<std::size_t>(base_.parameters.k);
  std::size_t filled = 0;
  while (times_ < pi_.n && room.size() - filled >= k) {
    pi_.image(base_.blocks[which_], power_, room.subspan(filled, k));
    filled += k;
    if (++which_ == base_.blocks.size()) {
      which_ = 0;
      ++times_;
      power_ += shift_;
      power_ -= power_ >= pi_.n ? pi_.n : 0;
    }
  }
  return room.first(filled);
}

std::uint64_t Automorphism::pair_orbits() const {
  const std::uint64_t within = checked_multiply(cycles, n / 2);
  const std::uint64_t between = checked_multiply(binomial(cycles, 2), n);
  return checked_add(checked_add(within, between), cycles * fixed + binomial(fixed, 2));
}

}  // namespace changeover
