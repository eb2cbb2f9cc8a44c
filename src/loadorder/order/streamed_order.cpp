#include "loadorder/order/streamed_order.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/developed.hpp"
#include "changeover/core/error.hpp"
#include "changeover/verify/difference.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

class StreamedSteps final : public StepSource {
 public:
  explicit StreamedSteps(const StreamedShape& shape)
      : shape_(shape), n_(shape.room - 1), v_(2 * shape.c * n_ + 1) {
    if (n_ == 0) {
      throw InternalError("a streamed order needs room for two items");
    }
  }

  bool jump(std::uint64_t step, std::vector<Element>& held) override {
    if (step == 0 || step > shape_.steps()) {
      return false;
    }
    restart();
    if (step > 1) {
      Step first;
      next(first);
      skip(step - 2);
    }
    hold(held);
    return true;
  }

  /// Skips `steps` steps at once, after at least one was made, if there are as many.
  void skip(std::uint64_t steps) {
    number_ += steps;
    while (steps > 0) {
      const std::uint64_t skipped = stage_ == Stage::pass   ? skip_passes(steps)
                                    : stage_ == Stage::swap ? skip_swaps(steps)
                                    : stage_ == Stage::join ? skip_joins(steps)
                                                            : skip_windows(steps);
      steps -= skipped;
    }
  }

  /// The items in memory after the steps so far.
  void hold(std::vector<Element>& held) const {
    held.clear();
    if (number_ == 0) {
      return;
    }
    const auto put = [&](std::uint64_t item) { held.push_back(static_cast<Element>(item)); };
    if (stage_ == Stage::windows) {
      for (std::uint64_t i = 0; i < n_; ++i) {
        put(numbered((window_ + i) % v_));
      }
      put(slot_);
    } else if (stage_ == Stage::join || stage_ == Stage::end) {
      if (shape_.c == 0 || shape_.items <= shape_.room) {
        hold_round(held);
        return;
      }
      put(numbered(v_ - 1));
      for (std::uint64_t number = joined_; number < n_; ++number) {
        put(numbered(number));
      }
      for (std::uint64_t i = 0; i < joined_; ++i) {
        put(extra(i));
      }
    } else {
      hold_round(held);
    }
  }

  bool next(Step& step) override {
    step.number = ++number_;
    step.load.clear();
    step.evict.clear();
    if (number_ == 1) {
      begin(step);
      return true;
    }
    while (true) {
      switch (stage_) {
        case Stage::pass:
          if (pass(step)) {
            return true;
          }
          end_round();
          break;
        case Stage::swap:
          if (swapped_ < to_swap_) {
            swap(step);
            return true;
          }
          stage_ = after_swap_;
          break;
        case Stage::windows:
          if (window_step(step)) {
            return true;
          }
          break;
        case Stage::join:
          if (joined_ < shape_.w) {
            exchange(step, extra(joined_), numbered(joined_));
            ++joined_;
            return true;
          }
          stage_ = Stage::end;
          break;
        case Stage::end:
          return false;
      }
    }
  }

 private:
  enum class Stage : std::uint8_t { pass, swap, windows, join, end };

  static void exchange(Step& step, std::uint64_t in, std::uint64_t out) {
    step.evict.push_back(static_cast<Element>(out));
    step.load.push_back(static_cast<Element>(in));
  }

  void begin(Step& step) {
    const std::uint64_t p = shape_.items;
    if (p <= shape_.room) {
      fill(step, p);
      stage_ = Stage::end;
    } else if (shape_.c > 0 && shape_.rounds == 0) {
      zero_ = 0;
      for (std::uint64_t number = 0; number < n_; ++number) {
        step.load.push_back(static_cast<Element>(numbered(number)));
      }
      slot_ = passing(0, 0);
      step.load.push_back(static_cast<Element>(slot_));
      passed_ = 1;
      stage_ = Stage::windows;
    } else {
      fill(step, shape_.room);
      slot_ = n_;
      next_ = shape_.room;
      skipped_ = p;  // none
      stage_ = Stage::pass;
    }
  }

  static void fill(Step& step, std::uint64_t count) {
    for (std::uint64_t x = 0; x < count; ++x) {
      step.load.push_back(static_cast<Element>(x));
    }
  }

  void restart() {
    stage_ = after_swap_ = Stage::end;
    number_ = first_ = rounds_ = slot_ = next_ = skipped_ = 0;
    swapped_ = to_swap_ = zero_ = window_ = passed_ = joined_ = 0;
    into_windows_ = false;
  }

  // In hold rounds: the items that stay or replace them, and the one that passed last.
  void hold_round(std::vector<Element>& held) const {
    const auto put = [&](std::uint64_t item) { held.push_back(static_cast<Element>(item)); };
    if (shape_.items <= shape_.room) {
      for (std::uint64_t x = 0; x < shape_.items; ++x) {
        put(x);
      }
      return;
    }
    if (stage_ == Stage::pass) {
      for (std::uint64_t i = 0; i < n_; ++i) {
        put(in_round(i));
      }
      put(slot_);
      return;
    }
    // Windows begin with 0, which is in memory as zero_, and with 1, …, n−1 and the first item that
    // passes, which replace the items that stayed.
    for (std::uint64_t i = 0; i < swapped_; ++i) {
      put(into_windows_ ? (i + 1 < n_ ? numbered(i + 1) : passing(0, 0)) : in_round(i));
    }
    for (std::uint64_t i = swapped_; i < n_; ++i) {
      put(first_ - n_ + i);
    }
    put(into_windows_ ? zero_ : skipped_);
  }
  // The i-th item that stays in this round.
  [[nodiscard]] std::uint64_t in_round(std::uint64_t i) const {
    const std::uint64_t item = first_ + i;
    return item + (item >= skipped_ ? 1 : 0);
  }

  std::uint64_t skip_passes(std::uint64_t steps) {
    const bool jumps = skipped_ >= next_ && skipped_ < shape_.items;
    const std::uint64_t left = shape_.items - std::min(next_, shape_.items) - (jumps ? 1 : 0);
    const std::uint64_t count = std::min(left, steps);
    if (count == 0) {
      end_round();
      return 0;
    }
    const std::uint64_t last = next_ + count - 1;
    slot_ = last + (jumps && last >= skipped_ ? 1 : 0);
    next_ = slot_ + 1;
    return count;
  }

  std::uint64_t skip_swaps(std::uint64_t steps) {
    const std::uint64_t count = std::min(to_swap_ - swapped_, steps);
    swapped_ += count;
    if (swapped_ == to_swap_ && into_windows_) {
      slot_ = passing(0, 0);
    }
    if (count == 0) {
      stage_ = after_swap_;
    }
    return count;
  }

  std::uint64_t skip_windows(std::uint64_t steps) {
    // Number of passes in windows so far; the window after them is found by bisection.
    const std::uint64_t to = passes_before(window_) + passed_ + steps;
    const std::uint64_t end = passes_before(v_);
    if (to >= end) {
      const std::uint64_t count = end - passes_before(window_) - passed_;
      window_ = v_;
      stage_ = Stage::join;
      return count;
    }
    std::uint64_t low = window_;
    std::uint64_t high = v_ - 1;
    while (low < high) {
      const std::uint64_t middle = high - (high - low) / 2;
      passes_before(middle) < to ? low = middle : high = middle - 1;
    }
    window_ = low;
    passed_ = to - passes_before(low);
    slot_ = passing(window_, passed_ - 1);
    return steps;
  }

  std::uint64_t skip_joins(std::uint64_t steps) {
    joined_ += steps;
    return steps;
  }

  // Passes in all windows before.
  [[nodiscard]] std::uint64_t passes_before(std::uint64_t window) const {
    return window * shape_.c + shape_.w * std::min(ceil_div(window, n_), 2 * shape_.c);
  }

  bool pass(Step& step) {
    next_ += next_ == skipped_ ? 1 : 0;
    if (next_ >= shape_.items) {
      return false;
    }
    exchange(step, next_, slot_);
    slot_ = next_++;
    return true;
  }

  // Ends a round: the items below first_ are finished, and n of them are still in memory, with the
  // item that passed last.
  void end_round() {
    first_ += n_;
    ++rounds_;
    swapped_ = 0;
    stage_ = Stage::swap;
    const std::uint64_t rest = shape_.items - first_;
    if (shape_.c > 0 && rounds_ == shape_.rounds) {
      zero_ = slot_;
      to_swap_ = n_;
      after_swap_ = Stage::windows;
      into_windows_ = true;
      passed_ = 1;
    } else if (rest <= shape_.room) {
      skipped_ = slot_;
      to_swap_ = rest - 1;
      after_swap_ = Stage::end;
    } else {
      skipped_ = slot_;
      to_swap_ = n_;
      next_ = first_ + n_;
      after_swap_ = Stage::pass;
    }
  }

  void swap(Step& step) {
    const std::uint64_t out = first_ - n_ + swapped_;
    std::uint64_t in = first_ + swapped_;
    if (into_windows_) {  // 1, …, n−1 and the first item that passes; 0 is in memory
      in = swapped_ + 1 < n_ ? numbered(swapped_ + 1) : passing(0, 0);
      slot_ = in;
    } else if (in >= skipped_) {
      ++in;
    }
    exchange(step, in, out);
    ++swapped_;
  }

  bool window_step(Step& step) {
    if (passed_ == passing_count(window_)) {
      if (++window_ == v_) {
        stage_ = Stage::join;
        return false;
      }
      passed_ = 0;
    }
    const std::uint64_t in = passing(window_, passed_);
    exchange(step, in, passed_ == 0 ? numbered(window_ - 1) : slot_);
    slot_ = in;
    ++passed_;
    return true;
  }

  [[nodiscard]] bool has_extra(std::uint64_t window) const {
    return window % n_ == 0 && window < v_ - 1;
  }

  [[nodiscard]] std::uint64_t passing_count(std::uint64_t window) const {
    return shape_.c + (has_extra(window) ? shape_.w : 0);
  }

  [[nodiscard]] std::uint64_t passing(std::uint64_t window, std::uint64_t which) const {
    if (has_extra(window)) {
      if (which < shape_.w) {
        return extra(which);
      }
      which -= shape_.w;
    }
    const std::uint64_t number = window + (shape_.c - which) * n_;
    return numbered(number < v_ ? number : number - v_);
  }

  // Items by number: number x is item 2cx modulo v, so x−n is the item after x, since −n·2c = 1.
  // Items that pass one after another are then consecutive on the disk. The item in memory is 0 and
  // is exchanged with the first.
  [[nodiscard]] std::uint64_t renamed(std::uint64_t item) const {
    return item == first_ ? zero_ : item == zero_ ? first_ : item;
  }
  [[nodiscard]] std::uint64_t numbered(std::uint64_t number) const {
    return renamed(first_ + number * 2 * shape_.c % v_);
  }
  [[nodiscard]] std::uint64_t extra(std::uint64_t which) const {
    return renamed(first_ + v_ + which);
  }

  StreamedShape shape_;
  std::uint64_t n_;  // number of items that stay
  std::uint64_t v_;  // number of items in the windows
  Stage stage_ = Stage::end;
  Stage after_swap_ = Stage::end;
  std::uint64_t number_ = 0;
  std::uint64_t first_ = 0;  // items below it are finished
  std::uint64_t rounds_ = 0;
  std::uint64_t slot_ = 0;     // the item that passed last
  std::uint64_t next_ = 0;     // the next to pass
  std::uint64_t skipped_ = 0;  // in memory already
  std::uint64_t swapped_ = 0;
  std::uint64_t to_swap_ = 0;
  bool into_windows_ = false;
  std::uint64_t zero_ = 0;
  std::uint64_t window_ = 0;
  std::uint64_t passed_ = 0;
  std::uint64_t joined_ = 0;
};

// Loads of a hold round on `rest` items. Later rounds find one item in memory.
std::uint64_t round_loads(std::uint64_t rest, bool is_first) { return is_first ? rest : rest - 1; }

}  // namespace

std::string StreamedShape::explain() const {
  if (items <= room) {
    return "Everything fits: load all items at once.";
  }
  const std::uint64_t n = room - 1;
  if (c == 0) {
    return n == 1 ? std::string("Hold 1 item while all others pass, drop it, repeat on the rest.")
                  : fmt::format(
                        "Hold {} items while all others pass, drop them, repeat on the rest.", n);
  }
  std::string text;
  if (rounds > 0) {
    text = fmt::format("{} of {} held items that all others pass; then the ",
                       rounds == 1 ? "One round" : fmt::format("{} rounds", rounds), n);
  } else {
    text = "The ";
  }
  text += fmt::format("circular SCCD({},{}) of windows of {} items", 2 * c * n + 1, room, n);
  return w == 0 ? text + "."
                : text + fmt::format("; {} further {} every {}th window.", w,
                                     w == 1 ? "item passes" : "items pass", n);
}

StreamedShape hold_and_stream_shape(std::uint64_t items, std::uint64_t room) {
  StreamedShape shape{.items = items, .room = room};
  const std::uint64_t n = room - 1;
  std::uint64_t rest = items;
  shape.loads = items;
  while (rest > room) {
    rest -= n;
    shape.loads += rest - 1;
  }
  return shape;
}

StreamedShape best_streamed_shape(std::uint64_t items, std::uint64_t room) {
  constexpr std::uint64_t most_rounds = 64;
  constexpr std::uint64_t most_held = 1'000'000;  // with more rounds, windows are better
  const std::uint64_t n = room - 1;
  StreamedShape best{.items = items, .room = room, .loads = items};
  if (items <= room) {
    return best;
  }
  bool found = items / n <= most_held;
  if (found) {
    best = hold_and_stream_shape(items, room);
  }
  std::uint64_t rest = items;
  std::uint64_t held = 0;  // in the rounds so far
  for (std::uint64_t rounds = 0; rounds <= most_rounds && rest >= 2 * n + 1; ++rounds) {
    const std::uint64_t c = (rest - 1) / (2 * n);
    const std::uint64_t w = (rest - 1) % (2 * n);
    if (w <= n) {
      const std::uint64_t first = rounds == 0 ? room : n;
      const std::uint64_t loads = held + first + c * (2 * c * n + 1) - 1 + 2 * c * w + w;
      if (!found || loads < best.loads) {
        best = {.items = items, .room = room, .rounds = rounds, .c = c, .w = w, .loads = loads};
        found = true;
      }
    }
    held += round_loads(rest, rounds == 0);
    rest -= n;
  }
  return best;
}

StreamedPairs::StreamedPairs(const StreamedShape& shape)
    : shape_(shape),
      n_(shape.room - 1),
      v_(2 * shape.c * n_ + 1),
      first_(shape.c > 0 ? shape.rounds * n_ : 0),
      // Two items take turns to pass last: each is skipped in the next round.
      zero_(shape.rounds == 0 ? 0 : shape.items - (shape.rounds % 2 == 1 ? 1 : 2)) {
  if (shape.c > 0 && shape.items > shape.room) {
    joins_after_ = shape.steps() - shape.w;
    windows_after_ = shape.rounds == 0 ? 1 : end_of_round(shape.rounds - 1) + n_;
  }
}

// Step 1 and P − C passes; then each round has n exchanges, and all remaining items pass, except
// those that stay and one that is in memory.
std::uint64_t StreamedPairs::end_of_round(std::uint64_t round) const {
  return 1 + shape_.items - shape_.room + round * (shape_.items - 1) -
         n_ * (round * (round + 1) / 2);
}

std::uint64_t StreamedPairs::number(Element item) const {
  std::uint64_t place = item == first_ ? zero_ : item == zero_ ? first_ : item;
  place -= first_;
  return place < v_ ? (v_ - place * n_ % v_) % v_ : place;
}

bool StreamedPairs::meet_first(std::uint64_t step, Element x, Element y) const {
  if (shape_.items <= shape_.room) {
    return true;
  }
  const std::uint64_t low = std::min(x, y);
  if (shape_.c == 0 || low < first_) {
    return step <= end_of_round(low / n_);
  }
  const std::uint64_t a = number(x);
  const std::uint64_t b = number(y);
  if (step > joins_after_) {
    return std::min(a, b) >= v_ - 1;
  }
  return step <= windows_after_ || a >= n_ || b >= n_;
}

std::uint64_t StreamedPairs::first_load(Element item) const {
  if (shape_.items <= shape_.room) {
    return 1;
  }
  if (shape_.c == 0 || shape_.rounds > 0) {
    return item < shape_.room ? 1 : item - shape_.room + 2;
  }
  const std::uint64_t a = number(item);
  if (a >= v_) {
    return a - v_ + 1;  // passes the first window
  }
  if (a < n_) {
    return 1;
  }
  const std::uint64_t q = std::min(shape_.c, a / n_);
  const std::uint64_t window = a - q * n_;
  const std::uint64_t with_extras = std::min(ceil_div(window, n_), 2 * shape_.c);
  const bool has_extra = window % n_ == 0 && window < v_ - 1;
  return window * shape_.c + shape_.w * (with_extras + (has_extra ? 1 : 0)) + shape_.c - q + 1;
}

std::uint64_t StreamedPairs::met_after(std::uint64_t steps) const {
  if (steps == 0 || shape_.items <= shape_.room) {
    return steps == 0 ? 0 : binomial(shape_.items, 2);
  }
  std::uint64_t met = binomial(shape_.room, 2);
  std::uint64_t left = steps - 1;
  const auto take = [&](std::uint64_t most) {
    const std::uint64_t taken = std::min(left, most);
    left -= taken;
    return taken;
  };
  // The i-th exchange of a round meets those before it and the item that passed last.
  const auto exchanges = [](std::uint64_t count) { return count * (count + 1) / 2; };
  std::uint64_t rest = shape_.items;
  for (std::uint64_t round = 0; left > 0 && rest > shape_.room; ++round) {
    if (shape_.c > 0 && round == shape_.rounds) {
      break;
    }
    met += n_ * take(round == 0 ? rest - shape_.room : rest - n_ - 1);
    rest -= n_;
    const bool last = shape_.c == 0 && rest <= shape_.room;
    met += exchanges(take(last ? rest - 1 : n_));
  }
  if (shape_.c == 0) {
    return met;
  }
  const std::uint64_t passes = take(joins_after_ - windows_after_);
  met += n_ * passes;
  // The last item to pass window v−n+a is a, for a = 1, …, n−1; it has met a items of that window
  // in the first window.
  const std::uint64_t all = passes + 1;
  const std::uint64_t extras = 2 * shape_.c * shape_.w;
  const std::uint64_t windows = all > extras ? (all - extras) / shape_.c : 0;
  const std::uint64_t a = std::min(windows > v_ - n_ ? windows - (v_ - n_) - 1 : 0, n_ - 1);
  return met - exchanges(a) + exchanges(left);
}

std::unique_ptr<StepSource> streamed_steps(const StreamedShape& shape) {
  return std::make_unique<StreamedSteps>(shape);
}

std::vector<Element> names_by_window(const StreamedShape& shape) {
  std::vector<Element> names;
  if (shape.items <= shape.room || shape.c == 0) {
    return names;
  }
  // Like StreamedSteps::numbered(), except for the item that is in memory before, which does not
  // matter here.
  const std::uint64_t v = 2 * shape.c * (shape.room - 1) + 1;
  const std::uint64_t first = shape.rounds * (shape.room - 1);
  names.resize(static_cast<std::size_t>(shape.items));
  for (std::uint64_t number = 0; number < v; ++number) {
    names[static_cast<std::size_t>(first + number * 2 * shape.c % v)] =
        static_cast<Element>(number);
  }
  for (std::uint64_t i = first + v; i < shape.items; ++i) {
    names[static_cast<std::size_t>(i)] = static_cast<Element>(i - first);
  }
  for (std::uint64_t i = 0; i < first; ++i) {
    names[static_cast<std::size_t>(i)] = static_cast<Element>(shape.items - first + i);
  }
  return names;
}

std::string certify(const StreamedShape& shape) {
  if (shape.items <= shape.room) {
    return "structure: one step loads everything";
  }
  if (shape.c == 0) {
    return "structure: each round holds items that all remaining ones pass";
  }
  const std::uint64_t n = shape.room - 1;
  IntervalBaseBlocks base{
      {.v = 2 * shape.c * n + 1, .k = shape.room, .change = 1, .kind = Kind::circular}, 0, n, {}};
  for (std::uint64_t q = shape.c; q >= 1; --q) {
    base.points.push_back(static_cast<Element>(q * n));
  }
  const DifferenceVerdict verdict = verify_differences(base);
  if (!verdict.valid() || !verdict.tight) {
    throw InternalError("the windows of a streamed load order are not a tight design");
  }
  return fmt::format("structure: differences of {} over Z_{}{}", count_of(shape.c, "base block"),
                     base.parameters.v,
                     shape.rounds > 0 || shape.w > 0 ? ", other items pass what holds all" : "");
}

}  // namespace changeover
