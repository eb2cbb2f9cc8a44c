// Consecutive blocks of a design that cover all pairs, or most of them.
#include <algorithm>
#include <vector>

#include "changeover/construct/closure.hpp"
#include "changeover/core/pair_set.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

// How often each pair is in the consecutive blocks from `begin` on; blocks come and go at the ends.
class Window {
 public:
  explicit Window(const Design& design) : design_(design) {
    const std::uint64_t pairs = binomial(design.v(), 2);
    require_memory(pairs * sizeof(std::uint32_t), "counting the pairs of a part of a design");
    times_.assign(static_cast<std::size_t>(pairs), 0);
  }

  [[nodiscard]] std::uint64_t covered() const { return covered_; }

  void add(std::size_t i) {
    for_each_pair(i, [&](std::uint32_t& times) { covered_ += times++ == 0 ? 1U : 0U; });
  }
  void remove(std::size_t i) {
    for_each_pair(i, [&](std::uint32_t& times) { covered_ -= --times == 0 ? 1U : 0U; });
  }

 private:
  template <typename Visit>
  void for_each_pair(std::size_t i, Visit&& visit) {
    stop_if_asked();
    const auto block = design_.block(i % design_.block_count());
    for (std::size_t a = 0; a < block.size(); ++a) {
      for (std::size_t c = 0; c < a; ++c) {
        visit(times_[static_cast<std::size_t>(PairSet::rank(block[a], block[c]))]);
      }
    }
  }

  const Design& design_;
  std::vector<std::uint32_t> times_;
  std::uint64_t covered_ = 0;
};

Design part(const Design& design, std::size_t begin, std::size_t length) {
  Design linear(design.parameters().as(Kind::linear));
  for (std::size_t i = begin; i < begin + length; ++i) {
    linear.append(design.block(i % design.block_count()));
  }
  linear.set_labels(design.labels());
  return linear;
}

// Where windows may begin: anywhere in a circular design.
std::size_t last_block_of_windows(const Design& design) {
  const std::size_t b = design.block_count();
  return design.parameters().kind == Kind::circular ? 2 * b - 1 : b;
}

}  // namespace

Design shortest_cut(const Design& design) {
  const std::size_t b = design.block_count();
  if (design.parameters().strength != 2) {
    return part(design, 0, b);
  }
  Window window(design);
  std::size_t best = 0;
  std::size_t shortest = b;
  std::size_t end = 0;
  const std::uint64_t all = binomial(design.v(), 2);
  const std::size_t last = last_block_of_windows(design);
  for (std::size_t begin = 0; begin < b; ++begin) {
    while (window.covered() < all && end < last) {
      window.add(end++);
    }
    if (window.covered() < all) {
      break;
    }
    if (end - begin < shortest) {
      shortest = end - begin;
      best = begin;
    }
    window.remove(begin);
  }
  return without_needless_blocks(part(design, best, shortest));
}

Design best_part(const Design& design, std::size_t blocks) {
  const std::size_t b = design.block_count();
  const std::size_t length = std::clamp<std::size_t>(blocks, 1, b);
  if (design.parameters().strength != 2) {
    return part(design, 0, length);
  }
  Window window(design);
  for (std::size_t i = 0; i < length; ++i) {
    window.add(i);
  }
  std::size_t best = 0;
  std::uint64_t most = window.covered();
  for (std::size_t begin = 1; begin < b && begin + length <= last_block_of_windows(design);
       ++begin) {
    window.remove(begin - 1);
    window.add(begin + length - 1);
    if (window.covered() > most) {
      most = window.covered();
      best = begin;
    }
  }
  return part(design, best, length);
}

}  // namespace changeover
