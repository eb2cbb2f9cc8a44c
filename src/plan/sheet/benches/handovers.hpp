// Parts of which there are few, as they go from one bench to another.
#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "changeover/plan/benches.hpp"
#include "plan/sheet/sheet_words.hpp"

namespace changeover {

class BenchCalendar;

/// A piece of a part that a step puts in, and the bench that had it before. Benches and steps are
/// indices.
struct Handover {
  Element part = 0;
  std::size_t from = 0;
  std::size_t to = 0;
  std::size_t step = 0;  ///< of `to`, which puts it in
  /// It must be taken out for it: no step of `from` has done so by then. It is done with the part
  /// after the step `after`, or before its first one.
  bool is_early = false;
  std::optional<std::size_t> after = {};

  auto operator<=>(const Handover&) const = default;
};

/// All of a plan, in the order of time. A step takes a piece that lies beside the benches before
/// one that is still on a bench, and one that no bench has had before one that comes from another.
/// Of parts without a limit, of a bench's own pieces, and of models there is nothing to say.
/// O(parts · steps · benches).
[[nodiscard]] std::vector<Handover> handovers(const Job& job, const BenchCount& plan);

/// The same as lines for people, by bench and step: "after it take out Battery: Bench 2 needs it
/// for step 2, day 2, hour 3" where it is to be taken out, "Battery from Bench 1" where it is put
/// in. Without a calendar times are sums of costs.
using HandoverLines = std::vector<std::vector<std::vector<std::string>>>;
[[nodiscard]] HandoverLines handover_lines(const Job& job, const BenchCount& plan,
                                           const Money& money, const BenchCalendar& calendar);

}  // namespace changeover
