// The circular DCCD(2k−2, k, k), k odd: every element but two stays for one run of consecutive
// blocks, and two such runs among k blocks cannot miss each other.
//
// With h = (k+1)/2 and blocks numbered from 0 modulo k, the elements i_s, 0 ≤ i ≤ k−3, have short
// runs, h blocks from block i(h−1) − 1 on; i_l have long runs, h+1 blocks from block ih on. A run
// ends in the block in which that of i+1 begins. ∞_s is in blocks (k−1)/2 and k−1, ∞_l in blocks 0
// and (k−1)/2. The three blocks with ∞_s or ∞_l cover all their pairs. A tight one, with k−1
// blocks, would need runs of k/2 blocks, so k blocks are the minimum.
#include <fmt/format.h>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"

namespace changeover::short_long_runs_entry {
namespace {

// Elements in the order ∞_s, 0_s, …, (k−3)_s, ∞_l, 0_l, …, (k−3)_l.
void write_block(std::uint64_t k, std::uint64_t index, std::span<Element> block) {
  const std::uint64_t h = (k + 1) / 2;
  const bool middle = index == (k - 1) / 2;
  std::size_t filled = 0;
  const auto add_if = [&](bool wanted, std::uint64_t element) {
    if (wanted) {
      block[filled++] = static_cast<Element>(element);
    }
  };
  // Whether the block lies in the run of that many blocks from block `start` on, modulo k.
  const auto runs = [&](std::uint64_t start, std::uint64_t length) {
    return (index + k - start % k) % k < length;
  };
  add_if(middle || index == k - 1, 0);
  add_if(middle || index == 0, k - 1);
  for (std::uint64_t i = 0; i + 2 < k; ++i) {
    add_if(runs(i * (h - 1) + k - 1, h), 1 + i);
    add_if(runs(i * h, h + 1), k + i);
  }
}

constexpr Description description{
    .name = "short-long-runs",
    .summary = "elements that stay for one short or one long run, and two that come twice",
    .preconditions = "circular, m = 2, v = 2k-2, k odd, k >= 5",
    .guarantee = "a minimum circular DCCD(2k-2,k,k), one block above the counting bound",
    .cited = "ChafeeStevens2025",
    .place = "Theorem 4",
};

class ShortLongRuns final : public Described<Family, description> {
 public:
  std::vector<std::string> labels(const Recipe& recipe, const Registry&) const override {
    const std::uint64_t k = required(recipe).k;
    std::vector<std::string> labels;
    for (const char* run : {"s", "l"}) {
      labels.push_back(fmt::format("∞_{}", run));
      for (std::uint64_t i = 0; i + 2 < k; ++i) {
        labels.push_back(fmt::format("{}_{}", i, run));
      }
    }
    return labels;
  }

 protected:
  std::optional<Promise> promise(const Parameters& p) const override {
    if (!asks_for_pairs(p, 2) || p.kind != Kind::circular || p.k % 2 == 0 || p.k < 5 ||
        p.v != 2 * p.k - 2) {
      return std::nullopt;
    }
    return Promise{p.k};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    return numbered(p, p.k, [k = p.k](std::uint64_t index, std::span<Element> block) {
      write_block(k, index, block);
    });
  }

  std::string explanation(const Parameters& p) const override {
    const std::uint64_t k = p.k;
    const std::uint64_t h = (k + 1) / 2;
    return fmt::format(
        "Number the blocks from 0 modulo {0}. For i = 0,…,{1}, put i_s into {2} blocks from block "
        "{3}i - 1 on and i_l into {4} blocks from block {2}i on; put ∞_s into blocks {3} and {5}, "
        "and ∞_l into blocks 0 and {3}.",
        k, k - 3, h, h - 1, h + 1, k - 1);
  }
};

}  // namespace

const Construction& construction() { return only<ShortLongRuns>(); }

}  // namespace changeover::short_long_runs_entry
