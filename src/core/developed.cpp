#include "changeover/core/developed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/checked.hpp"
#include "changeover/core/error.hpp"

namespace changeover {

std::uint64_t BaseBlocks::block_count() const {
  return checked_multiply(blocks.size(), parameters.v);
}

DevelopedSource::DevelopedSource(BaseBlocks base) : base_(std::move(base)) {
  const Parameters& p = base_.parameters;
  check(p);
  if (base_.blocks.empty()) {
    throw BadInput("no base blocks: give at least one");
  }
  for (std::size_t i = 0; i < base_.blocks.size(); ++i) {
    const Block& block = base_.blocks[i];
    if (block.size() != p.k ||
        std::any_of(block.begin(), block.end(), [&](Element x) { return x >= p.v; })) {
      throw BadInput(
          fmt::format("base block {} does not have k = {} elements below v = {}", i + 1, p.k, p.v));
    }
  }
}

std::span<const Element> DevelopedSource::read(std::span<Element> room) {
  const std::uint64_t v = base_.parameters.v;
  std::size_t filled = 0;
  while (shift_ < v && room.size() - filled >= base_.parameters.k) {
    for (const Element x : base_.blocks[which_]) {
      const std::uint64_t sum = x + shift_;
      room[filled++] = static_cast<Element>(sum >= v ? sum - v : sum);
    }
    if (++which_ == base_.blocks.size()) {
      which_ = 0;
      ++shift_;
    }
  }
  return room.first(filled);
}

}  // namespace changeover
