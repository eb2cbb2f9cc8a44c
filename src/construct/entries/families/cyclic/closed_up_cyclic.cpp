// The tight circular SCCD(2cK+1, k), K = k−1, without r of its elements, closed up: a circular
// SCCD(2cK+1−r, k) with c(2cK+1) − (c+1)r blocks, and a linear one with one block fewer
// [docs/theorems.md, Theorem 10].
//
// With u = 2cK+1 and W_j = {j, …, j+K−1} over Z_u the tight design is W_j + (j+pK), p = c, …, 1,
// for j = 0, …, u−1. Let D = {0, …, r−1} be the elements that are left out. Where the place of d in
// D would begin, at j = d−K, the last visitor d+K stays, so that it need not come again at j = d
// (if d+K is in D too, then d+2K does so). So each of D saves its own c stays and one of another
// element. For d = r−1 the stay of d+K ends with W_{d+K} + (d+2K), a block that is needed for {d+K,
// d+2K} only; these two meet at j = d, too.
//
// Element x is number x − r. The first block of a circular design is {u−1, r, …, r+K−1}.
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "construct/entries/families/cyclic/without_neighbours.hpp"
#include "core/words.hpp"

namespace changeover::closed_up_cyclic_entry {
namespace {

// Leg j makes the blocks with W_j.
class ClosedUpCycle final : public LegsWithHeldPlaces {
 public:
  using LegsWithHeldPlaces::LegsWithHeldPlaces;

 protected:
  [[nodiscard]] std::vector<std::uint64_t> visitors_of(std::uint64_t j) const override {
    std::vector<std::uint64_t> visitors;
    const bool held = deleted(j);  // what stays in its place is there already
    for (std::uint64_t p = numbers().c; p >= 2; --p) {
      const std::uint64_t visitor = (j + p * numbers().big) % numbers().u;
      if (!deleted(visitor) && !(held && p == 2 && deleted(j + numbers().big))) {
        visitors.push_back(visitor);
      }
    }
    const std::uint64_t next = (j + numbers().big) % numbers().u;
    if (!deleted(next) && !held) {
      visitors.push_back(next);
    }
    return visitors;
  }
};

constexpr Description description{
    .name = "closed-up-cyclic",
    .summary = "a tight circular single-change design without some neighbours, closed up",
    .preconditions = "m = 1, k >= 3, v = 2c(k-1)+1-r, c >= 2, 1 <= r < 2(k-1); r < k if c = 2",
    .guarantee = "b = c(2c(k-1)+1) - (c+1)r; linear 1 less",
    .place = "docs/theorems.md, Theorem 10",
};

class ClosedUpCyclic final : public WithoutNeighbours {
 public:
  ClosedUpCyclic() : WithoutNeighbours(description) {}

 protected:
  bool serves(std::uint64_t k, const Deletion& deletion, Kind /*kind*/) const override {
    return deletion.c > 2 || (deletion.c == 2 && deletion.r < k);
  }
  std::uint64_t saved(const Deletion& deletion) const override {
    return (deletion.c + 1) * deletion.r;
  }
  std::unique_ptr<SwapPlan> steps(std::uint64_t k, const Deletion& deletion,
                                  Kind kind) const override {
    return std::make_unique<ClosedUpCycle>(k, deletion, kind);
  }
  std::string explanation(const Parameters& p, const Deletion& deletion) const override {
    return fmt::format(
        "Delete {} of the tight circular SCCD({},{}) of {} windows; in place of each, "
        "another element stays from its last visit on.",
        count_of(deletion.r, "neighbour"), p.v + deletion.r, p.k, deletion.c);
  }
};

}  // namespace

const Construction& construction() { return only<ClosedUpCyclic>(); }

}  // namespace changeover::closed_up_cyclic_entry
