// Internal: the order that exists for every P and C and is generated step by step.
//
// Let n = C − 1. In a hold round n items stay while all other remaining items pass through the last
// place; then the n items are finished. After `rounds` hold rounds, the remaining R items are
// ordered by more hold rounds, to the end. Or, if R = 2cn + 1 + w with c ≥ 1 and 0 ≤ w ≤ n, they
// are ordered by windows:
//
//   Number them 0, …, v−1 and X_1, …, X_w, where v = 2cn + 1. For j = 0, …, v−1 the window
//   {j, …, j+n−1} (modulo v) stays while j+cn, …, j+2n, j+n pass, after X_1, …, X_w if j is one of
//   0, n, …, (2c−1)n. The last to pass, j+n, belongs to the next window, so only j is evicted. At
//   the end X_1, …, X_w join v−1.
//
// The windows and the passing items are the tight circular SCCD on v items, so all pairs of these
// meet: x passes the window that is qn back for each of q = 1, …, c, and so meets the items at
// distances (q−1)n + 1, …, qn. The 2c windows with the X's contain 0, …, v−2, and v−1 meets the X's
// at the end. When the first window starts, all items in memory but one are finished; that one is
// numbered 0. Number x is the item 2cx modulo v, counted from the first remaining item: then the c
// items j+cn, …, j+n are consecutive, which helps read-ahead and rotating disks. Verification is
// slower with these numbers, since the pairs of a window no longer share cache lines;
// names_by_window() solves that.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

/// The shape of such an order.
struct StreamedShape {
  std::uint64_t items = 0;
  std::uint64_t room = 0;
  std::uint64_t rounds = 0;  ///< hold rounds before the windows; ignored if c = 0
  std::uint64_t c = 0;       ///< 0: hold rounds to the end
  std::uint64_t w = 0;
  std::uint64_t loads = 0;

  /// The number of steps: all but the first load one item.
  [[nodiscard]] std::uint64_t steps() const { return items <= room ? 1 : loads - room + 1; }

  /// A description in one line.
  [[nodiscard]] std::string explain() const;

  bool operator==(const StreamedShape&) const = default;
};

/// The shape of hold rounds only. O(items / room).
[[nodiscard]] StreamedShape hold_and_stream_shape(std::uint64_t items, std::uint64_t room);

/// The shape with the fewest loads. items ≥ 1, room ≥ 2.
[[nodiscard]] StreamedShape best_streamed_shape(std::uint64_t items, std::uint64_t room);

/// Reads the steps. O(1) per load; memory O(1) except for the first step.
[[nodiscard]] std::unique_ptr<StepSource> streamed_steps(const StreamedShape& shape);

/// Computes when two items first meet, without reading the steps before.
class StreamedPairs {
 public:
  explicit StreamedPairs(const StreamedShape& shape);

  /// Needs x and y together in memory after this step (from 1): whether they meet for the first
  /// time. O(1)
  [[nodiscard]] bool meet_first(std::uint64_t step, Element x, Element y) const;

  /// The first step that loads the item. O(1)
  [[nodiscard]] std::uint64_t first_load(Element item) const;

  /// The number of pairs that have met after `steps` steps. O(rounds)
  [[nodiscard]] std::uint64_t met_after(std::uint64_t steps) const;

 private:
  [[nodiscard]] std::uint64_t end_of_round(std::uint64_t round) const;
  [[nodiscard]] std::uint64_t number(Element item) const;

  StreamedShape shape_;
  std::uint64_t n_, v_, first_, zero_;
  std::uint64_t windows_after_ = 0;  // number of steps before the second pass of the first window
  std::uint64_t joins_after_ = 0;
};

/// For CheckOptions::kept_as: names by which the items of a window are consecutive. An item that
/// passes then needs one cache line of pairs, and the next windows need the same lines. At P =
/// 65,535 the check is 1.3 times as fast for C = 40 and for C = 500, and shares of 10,000 workers
/// 1.6 times. Empty for orders without windows.
[[nodiscard]] std::vector<Element> names_by_window(const StreamedShape& shape);

/// Checks the differences of the base blocks, and describes the check in one line. @throws
/// InternalError if they are not those of a tight design. O(c log c).
[[nodiscard]] std::string certify(const StreamedShape& shape);

}  // namespace changeover
