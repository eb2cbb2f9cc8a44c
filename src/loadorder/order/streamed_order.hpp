// Internal: the order that serves every P and C and is made as it goes.
//
// n = C − 1. Some hold rounds: n items stay while all others of the rest pass through the last
// place, then they are dropped for good. After `rounds` of them the remaining R items are ordered
// either by more hold rounds, to the end, or, if R = 2cn + 1 + w with c ≥ 1 and 0 ≤ w ≤ n, like
// this:
//
//   Number them 0, …, v−1 and X_1, …, X_w, v = 2cn + 1. For j = 0, …, v−1 the window {j, …, j+n−1}
//   (modulo v) stays while j+cn, …, j+2n, j+n pass, after X_1, …, X_w if j is one of 0, n, …,
//   (2c−1)n. The last to pass, j+n, belongs to the next window, and only j has to go. At the end
//   X_1, …, X_w join v−1.
//
// The windows and what passes are the tight circular SCCD on v items, so each pair of these meets:
// x passes the window that is qn back for each of q = 1, …, c, and so meets the items at distance
// (q−1)n + 1, …, qn. The 2c windows with the X's hold 0, …, v−2, and v−1 meets them at the end. The
// items in memory when the first window comes are all but one dropped; that one is numbered 0.
// Otherwise number x is the item 2cx modulo v, counted from the first that is left: then j+cn, …,
// j+n, of which there are c, are c items in a row. Whatever reads ahead, and disks that turn, can
// make use of that. Verification is slower by it, since
// the pairs of a window no longer share cache lines; names_by_window() mends that.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

/// Which of these orders.
struct StreamedShape {
  std::uint64_t items = 0;
  std::uint64_t room = 0;
  std::uint64_t rounds = 0;  ///< hold rounds before the windows; of no meaning if c = 0
  std::uint64_t c = 0;       ///< 0: hold rounds to the end
  std::uint64_t w = 0;
  std::uint64_t loads = 0;

  /// All steps but the first load one item.
  [[nodiscard]] std::uint64_t steps() const { return items <= room ? 1 : loads - room + 1; }

  /// One line.
  [[nodiscard]] std::string explain() const;

  bool operator==(const StreamedShape&) const = default;
};

/// Hold rounds to the end. O(items / room).
[[nodiscard]] StreamedShape hold_and_stream_shape(std::uint64_t items, std::uint64_t room);

/// The shape with the fewest loads. items ≥ 1, room ≥ 2.
[[nodiscard]] StreamedShape best_streamed_shape(std::uint64_t items, std::uint64_t room);

/// A reader. O(1) a load; memory O(1) but for the first step.
[[nodiscard]] std::unique_ptr<StepSource> streamed_steps(const StreamedShape& shape);

/// When two items come together for the first time, said without the steps before.
class StreamedPairs {
 public:
  explicit StreamedPairs(const StreamedShape& shape);

  /// x and y come together by this step of the order, from 1: whether they never did before. O(1)
  [[nodiscard]] bool meet_first(std::uint64_t step, Element x, Element y) const;

  /// The step that loads the item first. O(1)
  [[nodiscard]] std::uint64_t first_load(Element item) const;

  /// How many pairs have met after so many steps. O(rounds)
  [[nodiscard]] std::uint64_t met_after(std::uint64_t steps) const;

 private:
  [[nodiscard]] std::uint64_t end_of_round(std::uint64_t round) const;
  [[nodiscard]] std::uint64_t number(Element item) const;

  StreamedShape shape_;
  std::uint64_t n_, v_, first_, zero_;
  std::uint64_t windows_after_ = 0;  // steps before the second pass of the first window
  std::uint64_t joins_after_ = 0;
};

/// For CheckOptions::kept_as: names by which a window is consecutive numbers, so that an item which
/// passes needs one cache line of pairs, and the next windows need the same lines. At P = 65,535
/// that makes the check 1.3 times as fast for C = 40 and for C = 500, and shares of 10,000 workers
/// 1.6 times. None without windows.
[[nodiscard]] std::vector<Element> names_by_window(const StreamedShape& shape);

/// Checks the differences of the base blocks; says how in one line. @throws InternalError if they
/// are not those of a tight design. O(c log c).
[[nodiscard]] std::string certify(const StreamedShape& shape);

}  // namespace changeover
