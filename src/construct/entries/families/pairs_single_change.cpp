// The tight SCCD(v,2): the edges of K_v in an order in which consecutive edges share one vertex.
//
// Run x, 0 ≤ x ≤ v−2, lists the edges {x,y}, x < y. It begins with y = v−1 if x is even and with
// y = v−2 if x is odd, and ends with the other of the two, so that the next run begins with the
// same y; the last run is {v−2,v−1}, which meets the ends of all others. Run 0 begins with {0,v−1}:
// the list is circular.
//
// Expansion set: x ≤ v−3 after the first edge of its run, v−2 between runs 0 and 1, v−1 between
// runs 1 and 2 (for v = 3, between the last edge and the first).
#include <fmt/format.h>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"

namespace changeover::pairs_single_change_entry {
namespace {

// The largest v whose expansion set, v subsets, is written down.
constexpr std::uint64_t largest_expansion_set = std::uint64_t{1} << 20;

class RunsOfEdgesSource final : public BlockByBlock<RunsOfEdgesSource> {
 public:
  explicit RunsOfEdgesSource(const Parameters& parameters) : parameters_(parameters) {}

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return parameters_.v * (parameters_.v - 1) / 2;
  }

  bool make(std::span<Element> block) {
    const std::uint64_t v = parameters_.v;
    if (x_ + 1 == v) {
      return false;
    }
    const std::uint64_t length = v - 1 - x_;
    std::uint64_t y = x_ + edge_;
    if (length == 1) {
      y = v - 1;
    } else if (edge_ == 0) {
      y = x_ % 2 == 0 ? v - 1 : v - 2;
    } else if (edge_ + 1 == length) {
      y = x_ % 2 == 0 ? v - 2 : v - 1;
    }
    block[0] = static_cast<Element>(x_);
    block[1] = static_cast<Element>(y);
    if (++edge_ == length) {
      edge_ = 0;
      ++x_;
    }
    return true;
  }

  bool rewind() override {
    x_ = edge_ = 0;
    return true;
  }

 private:
  Parameters parameters_;
  std::uint64_t x_ = 0;
  std::uint64_t edge_ = 0;
};

constexpr Description description{
    .name = "pairs-single-change",
    .summary =
        "the edges of a complete graph, vertex after vertex, consecutive edges share a vertex",
    .preconditions = "m = 1, k = 2, v >= 3",
    .guarantee = "a tight SCCD(v,2,v(v-1)/2), with an expansion set if v <= 2^20",
    .cited = "WallisYucasZhang1993",
};

class PairsSingleChange final : public Described<Family, description> {
 public:
  std::optional<std::vector<UnchangedSubset>> expansion_set(const Recipe& recipe,
                                                            const Registry&) const override {
    const std::uint64_t v = required(recipe).v;
    if (v > largest_expansion_set) {
      return std::nullopt;
    }
    std::vector<UnchangedSubset> set;
    set.reserve(static_cast<std::size_t>(v));
    const auto add = [&set](std::uint64_t position, std::uint64_t x) {
      set.push_back({static_cast<std::size_t>(position), {static_cast<Element>(x)}});
    };
    std::uint64_t before = 0;  // edges in the runs before run x
    for (std::uint64_t x = 0; x < v - 2 || x <= 2; ++x) {
      if (x == 1 || x == 2) {
        add(before, v - 3 + x);
      }
      if (x + 3 <= v) {
        add(before + 1, x);
      }
      before += v - 1 - x;
    }
    return set;
  }

 protected:
  std::optional<Promise> promise(const Parameters& p) const override {
    if (!asks_for_pairs(p, 1) || p.k != 2 || p.v < 3) {
      return std::nullopt;
    }
    return Promise{p.v * (p.v - 1) / 2, true, true, p.v <= largest_expansion_set};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    return std::make_unique<RunsOfEdgesSource>(p);
  }

  std::string explanation(const Parameters& p) const override {
    const std::uint64_t v = p.v;
    return fmt::format(
        "For x = 0,…,{}, the edges {{x,y}} with y > x; y = {} comes first and y = {} last if x is "
        "even, the other way round if x is odd.",
        v - 2, v - 1, v - 2);
  }
};

}  // namespace

const Construction& construction() { return only<PairsSingleChange>(); }

}  // namespace changeover::pairs_single_change_entry
