// A greedy walk through disjoint blocks, for k = m, where nothing can be held: the fallback that
// makes even these parameters served.
//
// From a block go to the disjoint block that newly covers most pairs, chosen element by element; if
// all pairs outside the block are covered, go through a block that leaves the elements of some
// uncovered pair free. Every second step covers a pair, so the walk ends. In a circular design the
// shortest way leads back (construct/tools/path.hpp). Nothing is promised but that it works; the
// walk is made to count its blocks.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <numeric>
#include <optional>
#include <utility>

#include "changeover/construct/registry.hpp"
#include "changeover/core/pair_set.hpp"
#include "construct/entry.hpp"
#include "construct/tools/path.hpp"
#include "core/checked.hpp"

namespace changeover::disjoint_walk_entry {
namespace {

class Walk {
 public:
  explicit Walk(const Parameters& p)
      : p_(p),
        v_(static_cast<std::size_t>(p.v)),
        k_(static_cast<std::size_t>(p.k)),
        covered_(p.v),
        open_(v_, v_ - 1) {}

  std::vector<Block> run() {
    Block first(k_);
    std::iota(first.begin(), first.end(), 0U);
    visit(first);
    while (left_ > 0) {
      Block block = best(outside(blocks_.back(), {}), blocks_.back());
      if (block.empty()) {
        // The uncovered pair stays free while one step is made; then it is outside.
        Block pair;
        covered_.for_each_missing(1, [&](Element x, Element y) { pair = {x, y}; });
        block = outside(blocks_.back(), pair);
        block.resize(k_);
      }
      visit(block);
    }
    return std::move(blocks_);
  }

 private:
  void visit(const Block& block) {
    for (std::size_t i = 0; i < block.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (is_open(block[i], block[j])) {
          covered_.insert(block[i], block[j]);
          --open_[block[i]];
          --open_[block[j]];
          --left_;
        }
      }
    }
    blocks_.push_back(block);
  }

  [[nodiscard]] bool is_open(Element x, Element y) const { return !covered_.contains(x, y); }

  [[nodiscard]] Block outside(const Block& block, const Block& also) const {
    std::vector<char> taken(v_, 0);
    for (const Block* const left_out : {&block, &also}) {
      for (const Element x : *left_out) {
        taken[x] = 1;
      }
    }
    Block rest;
    rest.reserve(v_);
    for (Element x = 0; x < v_; ++x) {
      if (taken[x] == 0) {
        rest.push_back(x);
      }
    }
    return rest;
  }

  // k elements of `from`, all but those of `without`, each the one with most uncovered pairs among
  // those before it, the first the one with most among all; empty if no pair is uncovered there.
  [[nodiscard]] Block best(const Block& from, const Block& without) const {
    std::vector<std::uint64_t> gain;
    gain.reserve(from.size());
    for (const Element x : from) {
      std::uint64_t open = open_[x];
      for (const Element y : without) {
        open -= is_open(x, y) ? 1U : 0U;
      }
      gain.push_back(open);
    }
    const auto next = std::ranges::max_element(gain);
    if (*next == 0) {
      return {};
    }
    auto chosen = static_cast<std::size_t>(next - gain.begin());
    gain.assign(from.size(), 0);
    Block block;
    std::vector<bool> used(from.size(), false);
    while (true) {
      used[chosen] = true;
      block.push_back(from[chosen]);
      if (block.size() == k_) {
        return block;
      }
      std::size_t most = from.size();
      for (std::size_t i = 0; i < from.size(); ++i) {
        if (used[i]) {
          continue;
        }
        gain[i] += is_open(from[i], block.back()) ? 1U : 0U;
        if (most == from.size() || gain[i] > gain[most]) {
          most = i;
        }
      }
      chosen = most;
    }
  }

  Parameters p_;
  std::size_t v_;
  std::size_t k_;
  PairSet covered_;
  std::vector<std::uint64_t> open_;  // by element: how many it has not met
  std::uint64_t left_ = binomial(p_.v, 2);
  std::vector<Block> blocks_;
};

// From the last block of the walk back to its first.
std::vector<Block> way_back(const Parameters& p, const Block& last) {
  Block first(static_cast<std::size_t>(p.k));
  std::iota(first.begin(), first.end(), 0U);
  return connecting_blocks(last, first, p.change, p.v);
}

std::vector<Block> walk(const Parameters& p) {
  std::vector<Block> blocks = Walk(p).run();
  if (p.kind == Kind::circular) {
    for (Block& between : way_back(p, blocks.back())) {
      blocks.push_back(std::move(between));
    }
  }
  return blocks;
}

constexpr Description description{
    .name = "disjoint-walk",
    .summary = "a greedy walk through disjoint blocks",
    .preconditions = "k = m, 2k + 1 <= v <= 128",
    .guarantee = "that it works; b is counted by walking",
};

class DisjointWalk final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    constexpr std::uint64_t largest_v = 128;
    if (!asks_for_pairs(p, p.change) || p.change != p.k || p.v < 2 * p.k + 1 || p.v > largest_v) {
      return std::nullopt;
    }
    // Asked for again and again by those that build on it; both kinds go the same way.
    struct Counted {
      std::uint64_t b;
      Block last;
    };
    static std::mutex mutex;
    static std::map<std::pair<std::uint64_t, std::uint64_t>, Counted> walked;
    const auto look = [&]() -> std::optional<Counted> {
      const std::lock_guard lock(mutex);
      const auto place = walked.find({p.v, p.k});
      return place == walked.end() ? std::nullopt : std::optional(place->second);
    };
    std::optional<Counted> counted = look();
    if (!counted) {
      const std::vector<Block> blocks = Walk(p).run();
      counted = {blocks.size(), blocks.back()};
      const std::lock_guard lock(mutex);
      walked.emplace(std::pair(p.v, p.k), *counted);
    }
    return Promise{counted->b + (p.kind == Kind::circular ? way_back(p, counted->last).size() : 0)};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    return std::make_unique<BlockListSource>(p, walk(p));
  }

  std::string explanation(const Parameters& p) const override {
    return fmt::format(
        "From {{0,…,{}}} go from block to disjoint block, each time to one that covers many new "
        "pairs.",
        p.k - 1);
  }
};

}  // namespace

const Construction& construction() { return only<DisjointWalk>(); }

}  // namespace changeover::disjoint_walk_entry
