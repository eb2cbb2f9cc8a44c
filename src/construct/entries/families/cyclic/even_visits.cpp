// The tight circular SCCD(2cK+1, k), K = k−1, with visits at even distances, without r ≤ K of its
// elements: a circular SCCD(2cK+1−r, k) with c(2cK+1) − (2c−1)r blocks, and a linear one with one
// block fewer [docs/theorems.md, Theorem 12]. Unions of m consecutive blocks are m-change
// designs.
//
// With u = 2cK+1 and W_j = {j, …, j+K−1} over Z_u the tight design is W_j + (j+oK), o = 2c−2,
// 2c−4, …, 2 and then o = 1, for j = 0, …, u−1. Let D = {0, …, r−1} be the elements that are left
// out. d+K, for d in D, enters at (j, o) = (d−K, 2) only. From there it stays, in the place of d
// and then in its own, until the window has passed it. So each of D saves its own c entries and
// c−1 of another element.
//
// Element x is number x − r. The first block of a circular design is {u−1, r, …, r+K−1}.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "changeover/construct/registry.hpp"
#include "construct/entries/families/cyclic/even_visits.hpp"
#include "core/words.hpp"

namespace changeover::even_visits_entry {
namespace {

constexpr Description description{
    .name = "even-visits",
    .summary = "a tight circular single-change design without some neighbours, others stay once",
    .preconditions = "v = 2cK+1-r, K = k-m >= 2, c >= 2, 1 <= r <= K; K >= 2m if m > 1",
    .guarantee = "b = c(2cK+1) - (2c-1)r, linear 1 less; the m-th part of it if m > 1",
    .place = "docs/theorems.md, Theorem 12",
};

class EvenVisitsFamily final : public WithoutNeighbours {
 public:
  EvenVisitsFamily() : WithoutNeighbours(description, true) {}

 protected:
  bool serves(std::uint64_t k, const Deletion& deletion, Kind /*kind*/) const override {
    return deletion.c >= 2 && deletion.r < k;
  }
  std::uint64_t saved(const Deletion& deletion) const override {
    return (2 * deletion.c - 1) * deletion.r;
  }
  std::unique_ptr<SwapPlan> steps(std::uint64_t k, const Deletion& deletion,
                                  Kind kind) const override {
    return std::make_unique<EvenVisits>(k, deletion, kind);
  }
  std::string explanation(const Parameters& p, const Deletion& deletion) const override {
    return fmt::format(
        "In the tight circular SCCD({},{}) of {} windows, visited at even distances, leave out {}; "
        "in place of each, another element stays once and visits no more.",
        p.v + deletion.r, p.k, deletion.c, count_of(deletion.r, "neighbour"));
  }
};

}  // namespace

const Construction& construction() { return only<EvenVisitsFamily>(); }

}  // namespace changeover::even_visits_entry
