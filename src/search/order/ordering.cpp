#include "changeover/search/local_search.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "search/order/ordering_bound.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t most_memory = std::uint64_t{4} << 30;

}  // namespace

Overlaps::Overlaps(std::span<const Block> blocks, std::uint64_t v)
    : words_(static_cast<std::size_t>(std::max<std::uint64_t>(1, ceil_div(v, 64)))) {
  if (checked_multiply(words_ * 8, blocks.size()) > most_memory) {
    throw MissingResource(
        fmt::format("{} blocks on {} elements need more than 4 GiB as bit sets", blocks.size(), v));
  }
  require_memory(words_ * 8 * blocks.size(),
                 fmt::format("the bit sets of {} blocks", blocks.size()));
  bits_.assign(words_ * blocks.size(), 0);
  sizes_.reserve(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    for (const Element x : blocks[i]) {
      if (x >= v) {
        throw BadInput(
            fmt::format("block {} has the element {}, which is not below v = {}", i + 1, x, v));
      }
      std::uint64_t& word = bits_[i * words_ + x / 64];
      if ((word >> (x % 64) & 1) != 0) {
        throw BadInput(fmt::format("block {} has the element {} twice", i + 1, x));
      }
      word |= std::uint64_t{1} << (x % 64);
    }
    sizes_.push_back(static_cast<std::uint32_t>(blocks[i].size()));
  }
}

std::vector<Block> arranged(std::span<const Block> blocks, std::span<const std::size_t> order) {
  std::vector<Block> list;
  list.reserve(order.size());
  for (const std::size_t i : order) {
    if (i >= blocks.size()) {
      throw BadInput(fmt::format("there is no block {} among {}", i + 1, blocks.size()));
    }
    list.push_back(blocks[i]);
  }
  return list;
}

std::uint64_t change_cost(std::span<const Block> blocks, std::span<const std::size_t> order,
                          const LeastChangeWanted& wanted) {
  std::vector<std::size_t> sorted(order.begin(), order.end());
  std::ranges::sort(sorted);
  bool all = sorted.size() == blocks.size();
  for (std::size_t i = 0; i < sorted.size() && all; ++i) {
    all = sorted[i] == i;
  }
  if (!all || order.empty()) {
    throw BadInput("an order must name each block exactly once");
  }
  std::uint64_t cost = 0;
  for (std::size_t at = 0; at < order.size(); ++at) {
    if (at > 0) {
      cost += difference(blocks[order[at]], blocks[order[at - 1]]).size();
    } else if (wanted.kind == Kind::circular) {
      cost += difference(blocks[order[0]], blocks[order.back()]).size();
    } else if (wanted.first_counts) {
      cost += blocks[order[0]].size();
    }
  }
  return cost;
}

}  // namespace changeover
