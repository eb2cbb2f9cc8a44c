// The tight circular SCCD(2cK+1, k), K = k−1, in which r elements are left out and r others take
// their places in the window: a circular SCCD(2cK+1−r, k) with c(2cK+1) − 2(c−1)r blocks, and a
// linear one with one block fewer [docs/theorems.md, Theorem 10].
//
// With u = 2cK+1 and W_j = {j, …, j+K−1} over Z_u the tight design is W_j + (j+pK), p = c, …, 1,
// for j = 0, …, u−1. In place of d = 0, …, r−1 write d + cK in the windows. That element is then in
// a window twice, far apart, and meets all others there, those of the windows and those that visit
// them: it need visit no window itself. So each d saves c−1 visits, and its substitute as many. The
// block W_{(c−1)K} + cK is needed for {(c−1)K, cK} only, and (c−1)K visits W_0, in which cK takes
// the place of 0.
//
// Element x is number x − r.
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "construct/entries/families/cyclic/without_neighbours.hpp"

namespace changeover::substituted_cyclic_entry {
namespace {

// Leg j makes the blocks with W_j.
class SubstitutedCycle final : public LegsOfWindows {
 public:
  SubstitutedCycle(std::uint64_t k, const Deletion& deletion, Kind kind)
      : LegsOfWindows({k, deletion}, kind, (deletion.c - 1) * (k - 1)) {}

 protected:
  // W_j + (j+K).
  [[nodiscard]] Block last_of(std::uint64_t j) const override {
    Block block;
    for (std::uint64_t x = 0; x <= numbers().big; ++x) {
      block.push_back(static_cast<Element>(in_window((j + x) % numbers().u)));
    }
    return block;
  }

  [[nodiscard]] std::vector<Swap> swaps_of(std::uint64_t j) const override {
    std::vector<Swap> swaps;
    std::uint64_t out = in_window((j + numbers().u - 1) % numbers().u);
    const auto enter = [&](std::uint64_t number) {
      swaps.push_back({.leaves = out, .enters = number});
      out = number;
    };
    for (std::uint64_t p = numbers().c; p >= 2; --p) {
      const std::uint64_t visitor = (j + p * numbers().big) % numbers().u;
      if (visits(visitor)) {
        enter(visitor - numbers().r);
      }
    }
    enter(in_window((j + numbers().big) % numbers().u));
    return swaps;
  }

 private:
  [[nodiscard]] std::uint64_t in_window(std::uint64_t x) const {
    return (x < numbers().r ? x + numbers().c * numbers().big : x) - numbers().r;
  }
  [[nodiscard]] bool visits(std::uint64_t x) const {
    return x >= numbers().r &&
           (x < numbers().c * numbers().big || x >= numbers().c * numbers().big + numbers().r);
  }
};

constexpr Description description{
    .name = "substituted-cyclic",
    .summary =
        "a tight circular single-change design without some neighbours, others in their places",
    .preconditions = "m = 1, k >= 3, v = 2c(k-1)+1-r, c >= 3, 1 <= r < k",
    .guarantee = "b = c(2c(k-1)+1) - 2(c-1)r; linear 1 less",
    .place = "docs/theorems.md, Theorem 10",
};

class SubstitutedCyclic final : public WithoutNeighbours {
 public:
  SubstitutedCyclic() : WithoutNeighbours(description) {}

 protected:
  bool serves(std::uint64_t k, const Deletion& deletion, Kind /*kind*/) const override {
    return deletion.c >= 3 && deletion.r < k;
  }
  std::uint64_t saved(const Deletion& deletion) const override {
    return 2 * (deletion.c - 1) * deletion.r;
  }
  std::unique_ptr<SwapPlan> steps(std::uint64_t k, const Deletion& deletion,
                                  Kind kind) const override {
    return std::make_unique<SubstitutedCycle>(k, deletion, kind);
  }
  std::string explanation(const Parameters& p, const Deletion& deletion) const override {
    return fmt::format(
        "In the tight circular SCCD({0},{1}) of {2} windows let x+{3} take the place of x = "
        "0,…,{4} in the windows, and neither of them visit any.",
        p.v + deletion.r, p.k, deletion.c, deletion.c * (p.k - 1), deletion.r - 1);
  }
};

}  // namespace

const Construction& construction() { return only<SubstitutedCyclic>(); }

}  // namespace changeover::substituted_cyclic_entry
