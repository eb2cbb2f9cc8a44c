#include "plan/search/benches/bench_clock.hpp"

#include <algorithm>
#include <bit>
#include <functional>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/least_number.hpp"

namespace changeover {
namespace {

[[noreturn]] void fail_for_time() {
  throw ImpossibleParameters("the plan takes longer than can be counted; give smaller costs");
}

Ticks later(Ticks time, Ticks by) {
  Ticks sum = 0;
  if (__builtin_add_overflow(time, by, &sum)) {
    fail_for_time();
  }
  return sum;
}

bool holds(const std::uint64_t* parts, Element x) { return (parts[x / 64] >> (x % 64) & 1U) != 0; }

}  // namespace

BenchClock::BenchClock(std::vector<ClockBench> benches, const std::vector<std::uint64_t>& quantity,
                       Ticks day)
    : benches_(std::move(benches)),
      steps_(benches_.size()),
      changed_(benches_.size(), 0),
      words_((quantity.size() + 63) / 64),
      day_(day),
      first_piece_{0},
      courses_(benches_.size()),
      wanted_(benches_.size() * words_, 0),
      touched_(words_, 0) {
  for (Element x = 0; x < quantity.size(); ++x) {
    const bool scarce = std::any_of(benches_.begin(), benches_.end(),
                                    [&](const ClockBench& one) { return holds(one.shared, x); });
    first_piece_.push_back(first_piece_.back() + (scarce ? quantity[x] : 0));
  }
  pieces_.resize(first_piece_.back());
  moment_ = 2 + pieces_.size() + 2 * benches_.size();
  constexpr std::size_t cheap = 16;  // as much as a step or two
  stride_ = 1 + moment_ / cheap;
}

template <typename Visit>
void BenchClock::each_bit(std::uint64_t bits, std::size_t word, Visit&& visit) const {
  for (; bits != 0; bits &= bits - 1) {
    visit(static_cast<Element>(64 * word + static_cast<std::size_t>(std::countr_zero(bits))));
  }
}

// When a piece of a part is free; never: all are held without a known end.
Ticks BenchClock::available(Element x) const {
  return first_piece_[x] < first_piece_[x + 1] ? pieces_[first_piece_[x]] : never;
}

// A bench has the first free piece, and gives it back at this time.
void BenchClock::take(Element x, Ticks until) {
  std::size_t i = first_piece_[x];
  for (; i + 1 < first_piece_[x + 1] && pieces_[i + 1] < until; ++i) {
    pieces_[i] = pieces_[i + 1];
  }
  pieces_[i] = until;
}

// A piece that was held without a known end is free at this time.
void BenchClock::release(Element x, Ticks at) {
  std::size_t i = first_piece_[x + 1] - 1;
  for (; i > first_piece_[x] && pieces_[i - 1] > at; --i) {
    pieces_[i] = pieces_[i - 1];
  }
  pieces_[i] = at;
}

// The first time from `from` on at which a step of this cost may begin with these hours, and its
// end.
void BenchClock::fit(Course& course, Ticks from, Ticks cost, Ticks hours) const {
  course.begin = from;
  if (hours == 0) {
    course.end = later(from, cost);
    return;
  }
  // A piece may turn out to be free earlier than it was when this bench was looked at last.
  if (from < course.morning || from - course.morning >= day_) {
    course.morning = from / day_ * day_;
  }
  Ticks morning = course.morning;
  const Ticks now = from - morning;
  if (now + cost <= hours && (now < hours || cost == 0)) {
    course.end = later(from, cost);
    return;
  }
  if (now > 0) {
    morning = later(morning, day_);
  }
  course.begin = morning;
  if (cost <= hours) {
    course.end = later(morning, cost);
    return;
  }
  const Ticks days = (cost - 1) / hours;  // before the last day
  Ticks rest = 0;
  if (__builtin_mul_overflow(days, day_, &rest)) {
    fail_for_time();
  }
  course.end = later(later(morning, rest), cost - days * hours);
}

const std::uint64_t* BenchClock::before(std::size_t bench) const {
  const std::size_t next = courses_[bench].next;
  return next == 0 ? benches_[bench].start : steps_[bench][next - 1].parts;
}

Ticks BenchClock::cost_of_next(std::size_t bench) const {
  const Course& course = courses_[bench];
  Ticks cost = steps_[bench][course.next].cost;
  for (const Element x : course.lost) {
    cost += benches_[bench].change[x];
  }
  return cost;
}

// Computes when the next step of a bench can begin.
void BenchClock::look_at(std::size_t bench) {
  Course& course = courses_[bench];
  const std::uint64_t* const now = steps_[bench][course.next].parts;
  const std::uint64_t* const old = before(bench);
  const std::uint64_t* const shared = benches_[bench].shared;
  std::uint64_t* const wanted = &wanted_[bench * words_];
  for (std::size_t w = 0; w < words_; ++w) {
    wanted[w] = now[w] & ~old[w] & shared[w];
  }
  for (const Element x : course.lost) {
    wanted[x / 64] |= std::uint64_t{1} << (x % 64);
  }
  Ticks from = course.free;
  for (std::size_t w = 0; w < words_; ++w) {
    each_bit(wanted[w], w, [&](Element x) { from = std::max(from, std::max(now_, available(x))); });
  }
  if (from == never) {
    course.begin = never;
  } else {
    fit(course, from, cost_of_next(bench), benches_[bench].hours);
  }
}

void BenchClock::advance(std::size_t bench, ClockRecord* record) {
  Course& course = courses_[bench];
  const std::vector<ClockStep>& steps = steps_[bench];
  const std::uint64_t* const now = steps[course.next].parts;
  const bool is_last = course.next + 1 == steps.size();
  const std::uint64_t* const after = is_last ? nullptr : steps[course.next + 1].parts;
  const std::uint64_t* const shared = benches_[bench].shared;
  const std::uint64_t* const comes = &wanted_[bench * words_];
  for (std::size_t w = 0; w < words_; ++w) {
    const std::uint64_t stays = after != nullptr ? after[w] : 0;
    const std::uint64_t goes = now[w] & shared[w] & ~comes[w] & ~stays;
    each_bit(comes[w], w,
             [&](Element x) { take(x, (stays >> (x % 64) & 1U) != 0 ? never : course.end); });
    each_bit(goes, w, [&](Element x) { release(x, course.end); });
    touched_[w] = comes[w] | goes;
  }
  for (const Element x : course.lost) {
    result_.again += benches_[bench].change[x];
  }
  if (record != nullptr) {
    std::sort(course.lost.begin(), course.lost.end());
    record->times[bench].push_back({course.begin, course.end, course.lost});
  }
  losing_ -= course.lost.empty() ? 0U : 1U;
  course.lost.clear();
  course.free = course.end;
  now_ = course.begin;
  ++course.next;
}

// Every bench waits for parts that waiting benches hold: the one that has waited longest gets them.
void BenchClock::break_up() {
  std::size_t first = benches_.size();
  for (std::size_t b = 0; b < benches_.size(); ++b) {
    if (has_more(b) && (first == benches_.size() || courses_[b].free < courses_[first].free)) {
      first = b;
    }
  }
  const auto free_it = [&](Element x) {
    for (std::size_t b = 0; b < benches_.size() && available(x) == never; ++b) {
      Course& course = courses_[b];
      const bool keeps = b != first && has_more(b) && holds(benches_[b].shared, x) &&
                         holds(before(b), x) && holds(steps_[b][course.next].parts, x) &&
                         !holds(&wanted_[b * words_], x);
      if (keeps) {
        release(x, course.free);
        losing_ += course.lost.empty() ? 1U : 0U;
        course.lost.push_back(x);
      }
    }
    if (available(x) == never) {
      throw InternalError("a part is waited for that no bench holds");
    }
  };
  for (std::size_t w = 0; w < words_; ++w) {
    each_bit(wanted_[first * words_ + w], w, free_it);
  }
}

void BenchClock::begin_anew() {
  std::fill(pieces_.begin(), pieces_.end(), 0);
  now_ = 0;
  result_.again = 0;
  for (std::size_t b = 0; b < benches_.size(); ++b) {
    courses_[b].next = 0;
    courses_[b].free = 0;
    if (steps_[b].empty()) {
      continue;
    }
    // Parts that are mounted and stay in the first set-up are held from the beginning.
    for (std::size_t w = 0; w < words_; ++w) {
      each_bit(benches_[b].start[w] & steps_[b][0].parts[w] & benches_[b].shared[w], w,
               [&](Element x) {
                 if (available(x) != never) {
                   take(x, never);
                 }
               });
    }
  }
}

// Keeps what is known now, unless some bench has lost parts: now_, the cost of putting in again,
// the pieces, and where each bench is.
void BenchClock::snapshot() {
  if (losing_ > 0) {
    return;
  }
  const std::size_t from = new_.count++ * moment_;
  if (new_.data.size() < from + moment_) {
    new_.data.resize(2 * (from + moment_));
  }
  Ticks* at = &new_.data[from];
  *at++ = now_;
  *at++ = result_.again;
  at = std::copy(pieces_.begin(), pieces_.end(), at);
  for (const Course& course : courses_) {
    *at++ = course.free;
    *at++ = static_cast<Ticks>(course.next);
  }
}

// Goes back to the last moment of the kept run that does not depend on a changed step. Whether a
// part stays depends on the step after, so the step before a changed one must be ahead.
bool BenchClock::go_on_from_kept() {
  const std::size_t places = 2 + pieces_.size();
  const auto serves = [&](std::size_t moment) {
    const Ticks* const at = &kept_.data[moment * moment_ + places];
    for (std::size_t b = 0; b < benches_.size(); ++b) {
      if (changed_[b] <= static_cast<std::size_t>(at[2 * b + 1])) {
        return false;
      }
    }
    return true;
  };
  shared_ = least_number(0, has_kept_ ? kept_.count : 0, std::not_fn(serves));
  if (shared_ == 0) {
    return false;
  }
  const Ticks* at = &kept_.data[(shared_ - 1) * moment_];
  now_ = *at++;
  result_.again = *at++;
  std::copy(at, at + pieces_.size(), pieces_.begin());
  at += pieces_.size();
  for (Course& course : courses_) {
    course.free = *at++;
    course.next = static_cast<std::size_t>(*at++);
  }
  return true;
}

const BenchClock::Result& BenchClock::run(ClockRecord* record) {
  if (record != nullptr) {
    record->times.assign(benches_.size(), {});
    has_kept_ = false;
  }
  new_.count = 0;
  losing_ = 0;
  for (Course& course : courses_) {
    course.morning = 0;
    course.lost.clear();
  }
  if (!go_on_from_kept()) {
    begin_anew();
  }
  std::size_t left = 0;
  for (std::size_t b = 0; b < benches_.size(); ++b) {
    left += steps_[b].size() - courses_[b].next;
    if (has_more(b)) {
      look_at(b);
    }
  }
  std::size_t until_moment = shared_ == 0 ? 0 : stride_;
  while (left > 0) {
    if (until_moment-- == 0) {
      snapshot();
      until_moment = stride_ - 1;
    }
    std::size_t best = benches_.size();
    Ticks begin = never;
    for (std::size_t b = 0; b < benches_.size(); ++b) {
      if (courses_[b].begin < begin && has_more(b)) {
        best = b;
        begin = courses_[b].begin;
      }
    }
    const bool stuck = best == benches_.size();
    if (stuck) {
      break_up();
    } else {
      advance(best, record);
      --left;
    }
    for (std::size_t b = 0; b < benches_.size(); ++b) {
      bool affected = stuck || b == best;
      for (std::size_t w = 0; w < words_ && !affected; ++w) {
        affected = (wanted_[b * words_ + w] & touched_[w]) != 0;
      }
      if (affected && has_more(b)) {
        look_at(b);
      }
    }
  }
  result_.finish = 0;
  result_.ends.clear();
  for (const Course& course : courses_) {
    result_.ends.push_back(course.free);
    result_.finish = std::max(result_.finish, course.free);
  }
  has_run_ = true;
  return result_;
}

void BenchClock::keep() {
  if (!has_run_) {
    return;
  }
  kept_.count = shared_ + new_.count;
  kept_.data.resize(std::max(kept_.data.size(), kept_.count * moment_));
  std::copy_n(new_.data.begin(), new_.count * moment_,
              kept_.data.begin() + static_cast<std::ptrdiff_t>(shared_ * moment_));
  kept_result_ = result_;
  std::fill(changed_.begin(), changed_.end(), unchanged);
  has_kept_ = true;
  has_run_ = false;
}

void BenchClock::undo() {
  result_ = kept_result_;
  std::fill(changed_.begin(), changed_.end(), unchanged);
  has_run_ = false;
}

}  // namespace changeover
