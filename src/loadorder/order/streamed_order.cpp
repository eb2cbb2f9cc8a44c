#include "loadorder/order/streamed_order.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/developed.hpp"
#include "changeover/core/error.hpp"
#include "changeover/verify/difference.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

class StreamedSteps final : public StepSource {
 public:
  explicit StreamedSteps(const StreamedShape& shape)
      : shape_(shape), n_(shape.room - 1), v_(2 * shape.c * n_ + 1) {}

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

  bool pass(Step& step) {
    next_ += next_ == skipped_ ? 1 : 0;
    if (next_ >= shape_.items) {
      return false;
    }
    exchange(step, next_, slot_);
    slot_ = next_++;
    return true;
  }

  // The items below first_ are dropped; n of them are still in memory, with the one that passed last.
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
    if (into_windows_) {  // 1, …, n−1 and the first that passes; 0 is there
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

  // Items by number: number x is item 2cx modulo v, so that x−n is the item after x, since −n·2c = 1: what
  // passes one after another is together on the disk. The item in memory is 0 and changes places with
  // the first.
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
  std::uint64_t n_;  // items that stay
  std::uint64_t v_;  // of the windows
  Stage stage_ = Stage::end;
  Stage after_swap_ = Stage::end;
  std::uint64_t number_ = 0;
  std::uint64_t first_ = 0;  // items from here on are not dropped
  std::uint64_t rounds_ = 0;
  std::uint64_t slot_ = 0;     // the item that passed last
  std::uint64_t next_ = 0;     // the next to pass
  std::uint64_t skipped_ = 0;  // which is in memory already
  std::uint64_t swapped_ = 0;
  std::uint64_t to_swap_ = 0;
  bool into_windows_ = false;
  std::uint64_t zero_ = 0;
  std::uint64_t window_ = 0;
  std::uint64_t passed_ = 0;
  std::uint64_t joined_ = 0;
};

// Loads of a hold round on `rest` items, the first one or a later one: a later one finds one item in memory.
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
  constexpr std::uint64_t most_held = 1'000'000;  // beyond so many rounds windows are better
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
  std::uint64_t held = 0;  // loads of the rounds so far
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

std::unique_ptr<StepSource> streamed_steps(const StreamedShape& shape) {
  return std::make_unique<StreamedSteps>(shape);
}

std::vector<Element> names_by_window(const StreamedShape& shape) {
  std::vector<Element> names;
  if (shape.items <= shape.room || shape.c == 0) {
    return names;
  }
  // As StreamedSteps::numbered(), but for the item that is in memory before: it makes no difference in time.
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
