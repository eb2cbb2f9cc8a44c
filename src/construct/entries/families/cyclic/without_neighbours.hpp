// Families that leave out neighbours of the tight circular SCCD(2cK+1, k), K = k−1: v = 2cK+1−r,
// 0 < r < 2K.
//
//     // says which it serves, what it saves, and the legs
//     class ClosedUp final : public WithoutNeighbours { … };
//
// In each of these designs some block is needed for one pair only if the list begins with the
// next block, and this pair meets elsewhere too. A linear design leaves it out.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "construct/entry.hpp"
#include "construct/tools/swaps.hpp"
#include "core/checked.hpp"

namespace changeover {

/// r elements fewer than the tight design with c base blocks has.
struct Deletion {
  std::uint64_t c = 0;
  std::uint64_t r = 0;
};

/// The numbers that steps are made of: u = 2cK+1, K = k−1.
struct CycleNumbers {
  CycleNumbers(std::uint64_t k, const Deletion& deletion)
      : c(deletion.c), big(k - 1), u(2 * deletion.c * (k - 1) + 1), r(deletion.r) {}

  std::uint64_t c;
  std::uint64_t big;  // K
  std::uint64_t u;
  std::uint64_t r;
};

/// The steps of such a design, a leg for each of the u = 2cK+1 windows. The circular list begins
/// with the last block of window −1. The linear list begins after the last step of window
/// `before`, with the block that its next step makes; that last step's own block is left out.
class LegsOfWindows : public SwapPlan {
 public:
  LegsOfWindows(const CycleNumbers& numbers, Kind kind, std::uint64_t before)
      : is_(numbers), first_(kind == Kind::linear ? before + 1 : 0), kind_(kind) {}

  [[nodiscard]] Block start() const override {
    Block block;
    if (kind_ == Kind::circular) {
      block = last_of(is_.u - 1);
    } else {
      block = last_of(first_ - 1);
      const Swap step = swaps_of(first_).front();
      std::ranges::replace(block, static_cast<Element>(step.leaves),
                           static_cast<Element>(step.enters));
    }
    return block;
  }

  bool leg(std::uint64_t index, std::vector<Swap>& swaps) const override {
    if (index == is_.u) {
      return false;
    }
    std::vector<Swap> all = swaps_of((first_ + index) % is_.u);
    if (index == is_.u - 1) {
      all.pop_back();  // it leads back to the first block, or makes the block that is left out
    }
    if (kind_ == Kind::linear && index == 0) {
      all.erase(all.begin());  // it makes the first block
    }
    swaps.insert(swaps.end(), all.begin(), all.end());
    return true;
  }

 protected:
  /// The steps of window j, the one that moves it there first.
  [[nodiscard]] virtual std::vector<Swap> swaps_of(std::uint64_t j) const = 0;
  /// The block after them.
  [[nodiscard]] virtual Block last_of(std::uint64_t j) const = 0;
  [[nodiscard]] const CycleNumbers& numbers() const { return is_; }

 private:
  CycleNumbers is_;
  std::uint64_t first_;
  Kind kind_;
};

/// Legs in which 0, …, r−1 are left out and others hold their places in the windows: none does
/// at the window that the linear list begins after, that of K+r−1, and r, …, K+r−1 are there at
/// the end of window −1. Element x is number x−r.
class LegsWithHeldPlaces : public LegsOfWindows {
 public:
  LegsWithHeldPlaces(std::uint64_t k, const Deletion& deletion, Kind kind)
      : LegsOfWindows({k, deletion}, kind, k - 1 + deletion.r - 1) {}

 protected:
  /// Who enters while the window is W_j, one after another.
  [[nodiscard]] virtual std::vector<std::uint64_t> visitors_of(std::uint64_t j) const = 0;

  [[nodiscard]] std::vector<Swap> swaps_of(std::uint64_t j) const final {
    std::vector<Swap> swaps;
    std::uint64_t out = leaving_before(j);
    for (const std::uint64_t x : visitors_of(j)) {
      swaps.push_back({.leaves = number(out), .enters = number(x)});
      out = x;
    }
    return swaps;
  }

  [[nodiscard]] Block last_of(std::uint64_t j) const final {
    const std::uint64_t next = j == numbers().u - 1 ? numbers().r : j + 1;
    Block block(static_cast<std::size_t>(numbers().big));
    std::iota(block.begin(), block.end(), static_cast<Element>(number(next)));
    block.push_back(static_cast<Element>(number(j)));
    return block;
  }

  [[nodiscard]] bool deleted(std::uint64_t x) const { return x < numbers().r; }
  [[nodiscard]] std::uint64_t number(std::uint64_t x) const { return x - numbers().r; }

 private:
  // Who makes room when the window moves to W_j: j−1, or if there is no such element the last
  // visitor of W_{j−1}.
  [[nodiscard]] std::uint64_t leaving_before(std::uint64_t j) const {
    const std::uint64_t before = (j + numbers().u - 1) % numbers().u;
    if (!deleted(before)) {
      return before;
    }
    return before + (deleted(before + numbers().big) ? 3 : 2) * numbers().big;
  }
};

/// A family of change number 1 or, if its lists permit it (tools/unions.hpp), of every change
/// number.
class WithoutNeighbours : public Family {
 protected:
  explicit WithoutNeighbours(const Description& description, bool unions = false)
      : Family(description), unions_(unions) {}

  /// r > 0; k ≥ 3.
  [[nodiscard]] virtual bool serves(std::uint64_t k, const Deletion& deletion, Kind kind) const = 0;
  /// How many blocks fewer than the tight design.
  [[nodiscard]] virtual std::uint64_t saved(const Deletion& deletion) const = 0;
  [[nodiscard]] virtual std::unique_ptr<SwapPlan> steps(std::uint64_t k, const Deletion& deletion,
                                                        Kind kind) const = 0;
  [[nodiscard]] virtual std::string explanation(const Parameters& p,
                                                const Deletion& deletion) const = 0;

 private:
  // The single-change design that p's blocks are unions of.
  [[nodiscard]] static Parameters single(Parameters p) {
    p.k -= p.change - 1;
    p.change = 1;
    return p;
  }

  [[nodiscard]] std::optional<Deletion> deletion_of(const Parameters& p) const {
    const bool unites = p.change > 1;
    if (!asks_for_pairs(p, p.change) || p.change == 0 || (unites && !unions_)) {
      return std::nullopt;
    }
    const Parameters q = single(p);
    if (q.k < 3 || q.v <= 2 * q.k || (unites && !unions_fit(q.k - 1, p.change))) {
      return std::nullopt;
    }
    const std::uint64_t around = 2 * (q.k - 1);
    const Deletion deletion{(q.v - 2) / around + 1, around - 1 - (q.v - 2) % around};
    return deletion.r > 0 && serves(q.k, deletion, q.kind) ? std::optional(deletion) : std::nullopt;
  }

  [[nodiscard]] std::uint64_t single_count(const Parameters& p, const Deletion& deletion) const {
    return checked_multiply(deletion.c, p.v + deletion.r) - saved(deletion) -
           (p.kind == Kind::linear ? 1 : 0);
  }

  [[nodiscard]] std::optional<Promise> promise(const Parameters& p) const final {
    const auto deletion = deletion_of(p);
    return deletion ? std::optional(Promise{.b = ceil_div(single_count(p, *deletion), p.change)})
                    : std::nullopt;
  }

  [[nodiscard]] std::unique_ptr<BlockSource> blocks(const Parameters& p) const final {
    const Deletion deletion = deletion_of(p).value();
    const Parameters q = single(p);
    auto source =
        std::make_unique<SwapSource>(q, single_count(p, deletion), steps(q.k, deletion, p.kind));
    return p.change == 1 ? std::move(source) : unions_of_blocks(std::move(source), p.change);
  }

  [[nodiscard]] std::string explanation(const Parameters& p) const final {
    const std::string text = explanation(single(p), deletion_of(p).value());
    return p.change == 1 ? text : fmt::format("{} Unite {} consecutive blocks.", text, p.change);
  }

  bool unions_;
};

}  // namespace changeover
