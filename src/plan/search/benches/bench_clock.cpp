#include "plan/search/benches/bench_clock.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "changeover/core/error.hpp"

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

}  // namespace

BenchClock::BenchClock(std::vector<std::uint64_t> quantity, Ticks day)
    : quantity_(std::move(quantity)),
      words_((quantity_.size() + 63) / 64),
      day_(day),
      held_(quantity_.size()) {}

BenchClock::Fit BenchClock::fit(Ticks from, Ticks cost, Ticks hours) const {
  if (hours == 0) {
    return {from, later(from, cost)};
  }
  Ticks morning = from / day_ * day_;
  const Ticks now = from - morning;
  if (now + cost <= hours && (now < hours || cost == 0)) {
    return {from, later(from, cost)};
  }
  if (now > 0) {
    morning = later(morning, day_);
  }
  const Ticks days = cost == 0 ? 0 : (cost - 1) / hours;  // before the last day
  Ticks rest = 0;
  if (__builtin_mul_overflow(days, day_, &rest)) {
    fail_for_time();
  }
  return {morning, later(later(morning, rest), cost - days * hours)};
}

const std::uint64_t* BenchClock::before(std::size_t bench) const {
  const std::size_t next = courses_[bench].next;
  return next == 0 ? benches_[bench].start : benches_[bench].steps[next - 1].parts;
}

// The scarce parts that the next step puts in.
template <typename Visit>
void BenchClock::each_wanted(std::size_t bench, Visit&& visit) const {
  const ClockBench& one = benches_[bench];
  const std::uint64_t* const now = one.steps[courses_[bench].next].parts;
  const std::uint64_t* const old = before(bench);
  for (std::size_t w = 0; w < words_; ++w) {
    for (std::uint64_t bits = now[w] & ~old[w] & one.shared[w]; bits != 0; bits &= bits - 1) {
      visit(static_cast<Element>(64 * w + static_cast<std::size_t>(std::countr_zero(bits))));
    }
  }
  for (const Element x : courses_[bench].lost) {
    visit(x);
  }
}

Ticks BenchClock::cost_of_next(std::size_t bench) const {
  const Course& course = courses_[bench];
  Ticks cost = benches_[bench].steps[course.next].cost;
  for (const Element x : course.lost) {
    cost += benches_[bench].change[x];
  }
  return cost;
}

// Computes when the next step of a bench can begin.
void BenchClock::look_at(std::size_t bench) {
  Course& course = courses_[bench];
  course.blocked = false;
  course.waits = false;
  Ticks from = course.free;
  each_wanted(bench, [&](Element x) {
    course.waits = true;
    from = std::max(from, now_);
    Holders& holders = held_[x];
    if (holders.staying >= quantity_[x]) {
      course.blocked = true;
      return;
    }
    const std::uint64_t room = quantity_[x] - holders.staying;  // for holders with an end
    if (holders.until.size() >= room) {
      // All but one of the pieces may still be held: the others must be released first.
      auto nth = holders.until.end() - static_cast<std::ptrdiff_t>(room);
      std::nth_element(holders.until.begin(), nth, holders.until.end());
      from = std::max(from, *nth);
    }
  });
  if (!course.blocked) {
    const Fit fitted = fit(from, cost_of_next(bench), benches_[bench].hours);
    course.begin = fitted.begin;
    course.end = fitted.end;
  }
}

void BenchClock::advance(std::size_t bench, ClockRecord* record) {
  const ClockBench& one = benches_[bench];
  Course& course = courses_[bench];
  const std::uint64_t* const old = before(bench);
  const std::uint64_t* const now = one.steps[course.next].parts;
  const bool is_last = course.next + 1 == one.steps.size();
  const std::uint64_t* const after = is_last ? nullptr : one.steps[course.next + 1].parts;
  for (const Element x : course.lost) {
    result_.again += one.change[x];
  }
  if (record != nullptr) {
    std::sort(course.lost.begin(), course.lost.end());
    record->times[bench].push_back({course.begin, course.end, course.lost});
  }
  const auto is_lost = [&](Element x) {
    return std::find(course.lost.begin(), course.lost.end(), x) != course.lost.end();
  };
  for (std::size_t w = 0; w < words_; ++w) {
    for (std::uint64_t bits = now[w] & one.shared[w]; bits != 0; bits &= bits - 1) {
      const auto bit = static_cast<std::size_t>(std::countr_zero(bits));
      const auto x = static_cast<Element>(64 * w + bit);
      Holders& holders = held_[x];
      const bool comes = (old[w] >> bit & 1U) == 0 || is_lost(x);
      const bool stays = after != nullptr && (after[w] >> bit & 1U) != 0;
      if (comes && holders.staying == 0 && holders.until.empty()) {
        used_.push_back(x);
      }
      if (comes && stays) {
        ++holders.staying;
      } else if (!comes && !stays) {
        --holders.staying;
      }
      if (!stays) {
        std::erase_if(holders.until, [&](Ticks until) { return until <= course.begin; });
        holders.until.push_back(course.end);
      }
    }
  }
  course.lost.clear();
  course.free = course.end;
  now_ = course.begin;
  result_.finish = std::max(result_.finish, course.end);
  result_.ends[bench] = course.end;
  ++course.next;
}

bool BenchClock::is_new(std::size_t bench, Element x) const {
  bool found = false;
  each_wanted(bench, [&](Element y) { found = found || x == y; });
  return found;
}

// Every bench waits for parts that waiting benches hold: the one that has waited longest gets them.
void BenchClock::break_up() {
  std::size_t first = benches_.size();
  for (std::size_t b = 0; b < benches_.size(); ++b) {
    const bool has_more = courses_[b].next < benches_[b].steps.size();
    if (has_more && (first == benches_.size() || courses_[b].free < courses_[first].free)) {
      first = b;
    }
  }
  std::vector<Element> wanted;
  each_wanted(first, [&](Element x) { wanted.push_back(x); });
  for (const Element x : wanted) {
    for (std::size_t b = 0; b < benches_.size() && held_[x].staying >= quantity_[x]; ++b) {
      const ClockBench& one = benches_[b];
      Course& course = courses_[b];
      if (b == first || course.next >= one.steps.size()) {
        continue;
      }
      const auto holds = [&](const std::uint64_t* parts) {
        return (parts[x / 64] >> (x % 64) & 1U) != 0;
      };
      const bool keeps = holds(one.shared) && holds(before(b)) &&
                         holds(one.steps[course.next].parts) && !is_new(b, x);
      if (keeps) {
        --held_[x].staying;
        held_[x].until.push_back(course.free);
        course.lost.push_back(x);
      }
    }
    if (held_[x].staying >= quantity_[x]) {
      throw InternalError("a part is waited for that no bench holds");
    }
  }
}

const BenchClock::Result& BenchClock::run(std::span<const ClockBench> benches,
                                          ClockRecord* record) {
  benches_ = benches;
  courses_.resize(benches.size());
  for (const Element x : used_) {
    held_[x].staying = 0;
    held_[x].until.clear();
  }
  used_.clear();
  now_ = 0;
  if (record != nullptr) {
    record->times.assign(benches.size(), {});
  }
  std::size_t left = 0;
  for (std::size_t b = 0; b < benches.size(); ++b) {
    Course& course = courses_[b];
    course.next = 0;
    course.free = 0;
    course.lost.clear();
    left += benches[b].steps.size();
    if (benches[b].steps.empty()) {
      continue;
    }
    // Parts that are mounted and stay in the first set-up are held from the beginning.
    for (std::size_t w = 0; w < words_; ++w) {
      const std::uint64_t kept =
          benches[b].start[w] & benches[b].steps[0].parts[w] & benches[b].shared[w];
      for (std::uint64_t bits = kept; bits != 0; bits &= bits - 1) {
        const auto x =
            static_cast<Element>(64 * w + static_cast<std::size_t>(std::countr_zero(bits)));
        if (held_[x].staying++ == 0) {
          used_.push_back(x);
        }
      }
    }
  }
  for (std::size_t b = 0; b < benches.size(); ++b) {
    if (!benches[b].steps.empty()) {
      look_at(b);
    }
  }
  result_.finish = 0;
  result_.again = 0;
  result_.ends.assign(benches.size(), 0);
  while (left > 0) {
    std::size_t best = benches.size();
    for (std::size_t b = 0; b < benches.size(); ++b) {
      const Course& course = courses_[b];
      const bool can = course.next < benches[b].steps.size() && !course.blocked;
      if (can && (best == benches.size() || course.begin < courses_[best].begin)) {
        best = b;
      }
    }
    if (best == benches.size()) {
      break_up();
    } else {
      advance(best, record);
      --left;
    }
    for (std::size_t b = 0; b < benches.size(); ++b) {
      const bool has_more = courses_[b].next < benches[b].steps.size();
      if (has_more && (b == best || courses_[b].waits || best == benches.size())) {
        look_at(b);
      }
    }
  }
  return result_;
}

}  // namespace changeover
