#include "search/symmetric/base_block_anneal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "search/local/anneal.hpp"
#include "search/local/segment_orbits.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t first_anneal = 100'000;  // moves
constexpr int most_starts = 20;
constexpr std::uint64_t steps_between_questions = 64;

/// Blocks of any kind, and the total deviation of their steps from m changes.
class Descent {
 public:
  Descent(const Parameters& p, const BaseBlockShape& shape, Random& random)
      : v_(static_cast<std::uint32_t>(p.v)),
        k_(static_cast<std::uint32_t>(p.k)),
        c_(static_cast<std::uint32_t>(shape.base_blocks)),
        m_(p.change),
        pi_(static_cast<const Automorphism&>(shape)),
        random_(random),
        blocks_(c_),
        member_(std::size_t{c_} * v_, 0) {
    for (std::uint32_t i = 0; i < c_; ++i) {
      stop_if_asked();
      while (blocks_[i].size() < k_) {
        const Element x = random_.below(v_);
        if (member(i, x) == 0) {
          member(i, x) = 1;
          blocks_[i].push_back(x);
        }
      }
    }
  }

  // Returns whether the change property was reached.
  bool run() {
    std::uint64_t total = 0;
    for (std::uint32_t i = 0; i < c_; ++i) {
      stop_if_asked();
      total += defect(i);
    }
    const std::uint64_t steps = 2000ULL * c_ + 500ULL * v_;
    for (std::uint64_t step = 0; step < steps && total > 0; ++step) {
      if (step % steps_between_questions == 0) {
        stop_if_asked();
      }
      const std::uint32_t i = random_.below(c_);
      Element& place = blocks_[i][random_.below(k_)];
      const Element out = place;
      const Element in = random_.below(v_);
      if (member(i, in) != 0) {
        continue;
      }
      const auto exchange = [&](Element from, Element to) {
        member(i, from) = 0;
        member(i, to) = 1;
        place = to;
      };
      const std::uint64_t before = around(i);
      exchange(out, in);
      const std::uint64_t after = around(i);
      if (after <= before) {
        total -= before - after;
      } else {
        exchange(in, out);
      }
    }
    return total == 0;
  }

  std::vector<Block> take() { return std::move(blocks_); }

 private:
  std::uint8_t& member(std::uint32_t i, Element x) { return member_[std::size_t{i} * v_ + x]; }

  // The defect of the step from block i to the next one; after the last block, that is π(B₀).
  std::uint64_t defect(std::uint32_t i) {
    std::uint64_t leaving = 0;
    for (const Element x : blocks_[i]) {
      const bool stays =
          i + 1 < c_ ? member(i + 1, x) != 0 : member(0, pi_.image(x, pi_.n - 1)) != 0;
      leaving += stays ? 0 : 1;
    }
    return leaving > m_ ? leaving - m_ : m_ - leaving;
  }

  // The defects of the steps to and from block i.
  std::uint64_t around(std::uint32_t i) {
    const std::uint32_t previous = i == 0 ? c_ - 1 : i - 1;
    return defect(i) + (previous == i ? 0 : defect(previous));
  }

  std::uint32_t v_, k_, c_;
  std::uint64_t m_;
  Automorphism pi_;
  Random& random_;
  std::vector<Block> blocks_;
  std::vector<std::uint8_t> member_;  // by block and element
};

}  // namespace

std::vector<Block> random_base_blocks(const Parameters& p, const BaseBlockShape& shape,
                                      Random& random) {
  constexpr std::uint64_t most_base_blocks = std::numeric_limits<std::uint32_t>::max();
  if (shape.base_blocks > most_base_blocks) {
    throw MissingResource(fmt::format(
        "{} base blocks do not fit into memory; give smaller parameters", shape.base_blocks));
  }
  require_memory(checked_multiply(shape.base_blocks, checked_add(p.v, 4 * p.k)),
                 fmt::format("{} base blocks", shape.base_blocks));
  for (int start = 0; start < most_starts; ++start) {
    Descent descent(p, shape, random);
    if (descent.run()) {
      return descent.take();
    }
  }
  return {};
}

BaseBlockAnnealing base_blocks_by_annealing(const Parameters& p, const BaseBlockShape& shape,
                                            std::uint64_t moves, Random& random,
                                            RunControl& control) {
  BaseBlockAnnealing result;
  result.missing = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t length = first_anneal;
  for (int run = 0; result.moves < moves; ++run) {
    // Every second run is twice as long: base blocks are few, so several runs are better than one
    // long one.
    length *= run > 0 && run % 2 == 0 ? 2U : 1U;
    const std::vector<Block> begin = random_base_blocks(p, shape, random);
    if (begin.empty() || control.stop_wanted()) {
      break;
    }
    control.require_memory(SegmentOrbits::bytes(p, shape, begin.size()),
                           "annealing " + to_string(shape));
    SegmentOrbits state(p, shape, begin);
    const AnnealOutcome outcome = anneal(
        state, {.moves = std::min(length, moves - result.moves)}, random, control,
        telling(control,
                {.phase = fmt::format("annealing {}", to_string(shape)), .steps = result.moves}));
    result.moves += outcome.moves;
    result.missing = std::min(result.missing, outcome.least);
    if (outcome.missing == 0) {
      for (std::uint32_t i = 0; i < state.base_block_count(); ++i) {
        const auto block = state.block(i);
        result.blocks.emplace_back(block.begin(), block.end());
        std::ranges::sort(result.blocks.back());
      }
      break;
    }
    if (outcome.stopped) {
      break;
    }
  }
  return result;
}

}  // namespace changeover
