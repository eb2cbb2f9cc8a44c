// Lists of windows over Z_u, u = 6K+1 and K = k−1, with new elements x_1, …, x_w, that differ from
// the tight design near the multiples of K: chained_windows.cpp, chained_three_windows.cpp.
//
//     class OfThree final : public ThreeWindows { … };  // says how it begins, and has a table
//
// With a window j that is not in the table the steps are j+2K, j+3K, j+K.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "construct/entries/families/chains.hpp"
#include "construct/tools/swaps.hpp"

namespace changeover::three_windows {

using chains::Leg;
using chains::Place;
using chains::Step;

constexpr Place e(std::uint64_t i) { return {i, 0}; }
constexpr Place f(std::uint64_t i) { return {i, -1}; }
constexpr Place g(std::uint64_t i) { return {i, 1}; }
constexpr Place h(std::uint64_t i) { return {i, 2}; }
constexpr Place d(std::uint64_t i) { return {i, 3}; }

// New elements are this many windows away, or all from one on are.
constexpr std::uint64_t new_element = 1000;
constexpr std::uint64_t new_elements = 1001;
constexpr Place x(int i) { return {new_element, i}; }
/// x_i, …, x_w, one after another.
constexpr Place from_x(int i) { return {new_elements, i}; }
/// x_w.
constexpr Place last_x = x(0);

class ThreeWindows : public SwapPlan {
 public:
  ThreeWindows(std::uint64_t k, std::uint64_t w, std::uint64_t first)
      : big_(k - 1), u_(6 * big_ + 1), w_(w), first_(first) {}

  /// The steps before the first window, then a leg for each window from it on.
  bool leg(std::uint64_t index, std::vector<Swap>& swaps) const final {
    if (index == 0) {
      begin(swaps);
      return true;
    }
    const std::uint64_t j = first_ + index - 1;
    if (j == u_) {
      return false;
    }
    const Leg* const before = leg_at(j - 1);
    const std::uint64_t leaves =
        before != nullptr && before->leaves_next ? at(*before->leaves_next) : j - 1;
    const Leg* const own = leg_at(j);
    chains::add(
        own != nullptr ? with_all(own->steps) : usual(j), leaves,
        [this](const Place& place) { return at(place); }, swaps);
    if (j + 1 == u_) {
      end(swaps);
    }
    return true;
  }

 protected:
  [[nodiscard]] virtual const std::vector<Leg>& table() const = 0;
  virtual void begin(std::vector<Swap>& /*swaps*/) const {}
  virtual void end(std::vector<Swap>& /*swaps*/) const {}

  [[nodiscard]] std::uint64_t big() const { return big_; }
  [[nodiscard]] std::uint64_t added() const { return w_; }
  /// The number of x_i.
  [[nodiscard]] std::uint64_t number_of_x(std::uint64_t i) const { return u_ + i - 1; }

 private:
  [[nodiscard]] std::uint64_t at(const Place& place) const {
    if (place.windows == new_element) {
      return number_of_x(place == last_x ? w_ : static_cast<std::uint64_t>(place.by));
    }
    return (place.windows * big_ + u_ + static_cast<std::uint64_t>(std::int64_t{place.by})) % u_;
  }

  [[nodiscard]] const Leg* leg_at(std::uint64_t j) const {
    const auto found =
        std::ranges::find(table(), j, [this](const Leg& leg) { return at(leg.window); });
    return found == table().end() ? nullptr : &*found;
  }

  [[nodiscard]] std::vector<Step> with_all(const std::vector<Step>& steps) const {
    std::vector<Step> all;
    for (const Step& step : steps) {
      if (step.enters.windows == new_elements) {
        for (int i = step.enters.by; i <= static_cast<int>(w_); ++i) {
          all.push_back(x(i));
        }
      } else {
        all.push_back(step);
      }
    }
    return all;
  }

  [[nodiscard]] std::vector<Step> usual(std::uint64_t j) const {
    const std::uint64_t windows = j / big_;
    const int by = static_cast<int>(j % big_);
    return {Place{windows + 2, by}, Place{windows + 3, by}, Place{windows + 1, by}};
  }

  std::uint64_t big_;  // K
  std::uint64_t u_;
  std::uint64_t w_;
  std::uint64_t first_;
};

}  // namespace changeover::three_windows
