// Moves of local search a second, against the same annealer with a state that looks at a move by
// changing its counters block by block and changing them back.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "changeover/core/pair_set.hpp"
#include "core/checked.hpp"
#include "paired.hpp"
#include "search/local/anneal.hpp"
#include "search/local/random_list.hpp"
#include "search/local/segment_orbits.hpp"
#include "search/local/segment_pairs.hpp"

namespace changeover::bench {
namespace {

// The same moves from the same random numbers as SegmentPairs; a plain list of blocks and one
// counter a pair.
class PlainPairs {
 public:
  explicit PlainPairs(const Design& design)
      : v_(static_cast<std::uint32_t>(design.v())),
        k_(static_cast<std::uint32_t>(design.k())),
        b_(static_cast<std::uint32_t>(design.block_count())),
        usual_(usual_segment(design.k(), design.parameters().change)),
        counts_(static_cast<std::size_t>(binomial(v_, 2)), 0),
        members_(std::size_t{b_} * v_, 0),
        elements_(design.elements().begin(), design.elements().end()) {
    for (std::uint32_t i = 0; i < b_; ++i) {
      for (std::uint32_t a = 0; a < k_; ++a) {
        members_[std::size_t{i} * v_ + at(i, a)] = 1;
        for (std::uint32_t c = 0; c < a; ++c) {
          ++count(at(i, a), at(i, c));
        }
      }
    }
    for (Element y = 1; y < v_; ++y) {
      for (Element x = 0; x < y; ++x) {
        if (count(x, y) == 0) {
          uncovered_.emplace_back(x, y);
        }
      }
    }
  }

  [[nodiscard]] std::uint64_t missing() const { return uncovered_.size(); }

  [[nodiscard]] SegmentSwap propose(Random& random) const {
    const std::uint32_t i = random.below(b_);
    const Element x = at(i, random.below(k_));
    Element y = random.below(v_);
    while (contains(i, y)) {
      y = random.below(v_);
    }
    return segment(i, x, y, random);
  }

  [[nodiscard]] SegmentSwap propose_aimed(Random& random) const {
    const auto which = random.below(static_cast<std::uint32_t>(uncovered_.size()));
    auto [p, q] = uncovered_[which];
    if (random.one_in_two()) {
      std::swap(p, q);
    }
    for (int tries = 0; tries < 1000; ++tries) {
      const std::uint32_t i = random.below(b_);
      if (contains(i, p)) {
        Element x = at(i, random.below(k_));
        while (x == p) {
          x = at(i, random.below(k_));
        }
        return segment(i, x, q, random);
      }
    }
    return propose(random);
  }

  template <typename Accept>
  bool attempt(const SegmentSwap& move, Accept&& accept) {
    const std::int32_t change = exchange(move);
    if (accept(change)) {
      list_uncovered(move);
      return true;
    }
    exchange(move);
    return false;
  }

 private:
  [[nodiscard]] Element at(std::uint32_t i, std::uint32_t place) const {
    return elements_[std::size_t{i} * k_ + place];
  }
  [[nodiscard]] bool contains(std::uint32_t i, Element x) const {
    return members_[std::size_t{i} * v_ + x] != 0;
  }
  std::uint32_t& count(Element x, Element y) {
    return counts_[static_cast<std::size_t>(PairSet::rank(x, y))];
  }

  [[nodiscard]] SegmentSwap segment(std::uint32_t i, Element x, Element y, Random& random) const {
    return find_segment(b_, false, (random.next() >> 60) == 0 ? b_ : usual_, i, x, y,
                        [&](std::uint32_t j) { return contains(j, x) != contains(j, y); });
  }

  std::int32_t exchange(const SegmentSwap& move) {
    std::int32_t change = 0;
    for (std::uint32_t i = move.first; i < move.first + move.length; ++i) {
      const Element out = contains(i, move.x) ? move.x : move.y;
      const Element in = out == move.x ? move.y : move.x;
      for (std::uint32_t place = 0; place < k_; ++place) {
        Element& z = elements_[std::size_t{i} * k_ + place];
        if (z == out) {
          z = in;
        } else {
          change += --count(out, z) == 0 ? 1 : 0;
          change -= count(in, z)++ == 0 ? 1 : 0;
        }
      }
      members_[std::size_t{i} * v_ + out] = 0;
      members_[std::size_t{i} * v_ + in] = 1;
    }
    return change;
  }

  // After a move that is kept; they are few.
  void list_uncovered(const SegmentSwap& move) {
    std::erase_if(uncovered_, [&](const auto& pair) {
      return pair.first == move.x || pair.second == move.x || pair.first == move.y ||
             pair.second == move.y;
    });
    for (Element z = 0; z < v_; ++z) {
      if (z != move.x && count(move.x, z) == 0) {
        uncovered_.emplace_back(move.x, z);
      }
      if (z != move.y && z != move.x && count(move.y, z) == 0) {
        uncovered_.emplace_back(move.y, z);
      }
    }
  }

  std::uint32_t v_, k_, b_, usual_;
  std::vector<std::uint32_t> counts_;
  std::vector<std::uint8_t> members_;
  std::vector<Element> elements_;
  std::vector<std::pair<Element, Element>> uncovered_;
};

constexpr std::uint64_t moves = 2'000'000;

template <typename State>
std::uint64_t run(const Design& start) {
  State state(start);
  Random random(2);
  RunControl control({});
  return anneal(state, {.moves = moves}, random, control).moves;
}

// A list one block shorter than any design, so that no run ends early.
void local_search_moves(benchmark::State& state) {
  const Parameters p{.v = static_cast<std::uint64_t>(state.range(0)),
                     .k = static_cast<std::uint64_t>(state.range(1)),
                     .change = static_cast<std::uint64_t>(state.range(2))};
  Random random(1);
  const Design start = random_list(p, static_cast<std::size_t>(state.range(3)), random).value();
  run_paired(
      state, [&] { benchmark::DoNotOptimize(run<PlainPairs>(start)); },
      [&] { benchmark::DoNotOptimize(run<SegmentPairs<std::uint8_t>>(start)); });
  state.counters["ours_moves/s"] =
      static_cast<double>(moves) / (state.counters["ours_ms"].value / 1000.0);
  state.counters["peer_moves/s"] =
      static_cast<double>(moves) / (state.counters["peer_ms"].value / 1000.0);
}

BENCHMARK(local_search_moves)
    ->ArgNames({"v", "k", "m", "b"})
    ->Args({30, 6, 1, 84})
    ->Args({30, 6, 2, 47})
    ->Args({50, 6, 2, 135})
    ->Args({100, 10, 2, 289})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace changeover::bench
