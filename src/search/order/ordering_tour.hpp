// Local search for short tours: 2-opt and Or-opt moves with neighbour lists, and double bridges.
//
//     Tour tour(weight, begin, neighbours, random);       // weight(i, j), symmetric whole numbers
//     tour.descend();
//     while (…) { tour.kick(); }
//
// A tour is an array of cities and the place of each. Every change is a reversal of a stretch (of
// the shorter side where that is the same tour) or a rewritten window of some fifty places. Both
// are recorded, so that a kick without gain can be undone. Moves are tried only from cities whose
// neighbourhood changed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "run/random.hpp"

namespace changeover {

template <typename Weight>
class Tour {
 public:
  using City = std::uint32_t;
  using Neighbours = std::vector<std::vector<City>>;  // by city, nearest first

  Tour(const Weight& weight, std::vector<City> cities, const Neighbours& neighbours, Random& random)
      : weight_(weight),
        neighbours_(neighbours),
        random_(random),
        n_(cities.size()),
        tour_(std::move(cities)),
        place_(n_),
        queued_(n_, false) {
    for (std::size_t at = 0; at < n_; ++at) {
      place_[tour_[at]] = static_cast<City>(at);
    }
  }

  [[nodiscard]] const std::vector<City>& cities() const { return tour_; }

  /// Applies moves from every city until none is left. `stop` is called now and then.
  template <typename Stop>
  void descend(Stop&& stop) {
    for (std::size_t at = n_; at-- > 0;) {
      enqueue(tour_[at]);
    }
    work(stop);
    undo_.clear();
  }

  /// Makes a double bridge in a small window and descends from it; undone if the tour is then
  /// longer. Returns whether it is shorter than before. Needs 8 cities.
  bool kick() {
    undo_.clear();
    std::int64_t gain = bridge();
    gain += work([] { return false; });
    if (gain < 0) {
      take_back();
    }
    return gain > 0;
  }

 private:
  static constexpr std::size_t window = 50;
  static constexpr std::size_t longest_segment = 3;

  // A recorded change: a reversal of places, or a window with its former contents.
  struct Step {
    std::size_t from = 0;
    std::size_t to = 0;
    std::vector<City> before = {};
  };

  [[nodiscard]] std::int64_t d(City a, City b) const { return weight_(a, b); }
  [[nodiscard]] City next(City a) const {
    const std::size_t at = place_[a] + std::size_t{1};
    return tour_[at == n_ ? 0 : at];
  }
  [[nodiscard]] City previous(City a) const {
    return tour_[place_[a] == 0 ? n_ - 1 : place_[a] - std::size_t{1}];
  }

  void enqueue(City a) {
    if (!queued_[a]) {
      queued_[a] = true;
      queue_.push_back(a);
    }
  }

  // Reverses the cities from a to b along the tour. Returns false if all others were reversed
  // instead, which is the same tour read backwards.
  bool reverse(City a, City b) {
    const std::size_t from = place_[a];
    const std::size_t to = place_[b];
    undo_.push_back({from, to, {}});
    return reverse_places(from, to);
  }

  // Reversing the same places again undoes it, since the same side is reversed.
  bool reverse_places(std::size_t from, std::size_t to) {
    std::size_t length = (to + n_ - from) % n_ + 1;
    const bool inside = 2 * length <= n_;
    if (!inside) {
      std::swap(from, to);
      from = from + 1 == n_ ? 0 : from + 1;
      to = to == 0 ? n_ - 1 : to - 1;
      length = n_ - length;
    }
    for (std::size_t step = 0; step < length / 2; ++step) {
      std::swap(tour_[from], tour_[to]);
      place_[tour_[from]] = static_cast<City>(from);
      place_[tour_[to]] = static_cast<City>(to);
      from = from + 1 == n_ ? 0 : from + 1;
      to = to == 0 ? n_ - 1 : to - 1;
    }
    return inside;
  }

  void take_back() {
    while (!undo_.empty()) {
      const Step& step = undo_.back();
      if (step.before.empty()) {
        reverse_places(step.from, step.to);
      } else {
        write(step.from, step.before);
      }
      undo_.pop_back();
    }
  }

  void write(std::size_t from, const std::vector<City>& cities) {
    for (const City city : cities) {
      tour_[from] = city;
      place_[city] = static_cast<City>(from);
      from = from + 1 == n_ ? 0 : from + 1;
    }
  }

  // Exchanges two neighbouring stretches: a | b…c | d…e | f becomes a | d…e | b…c | f. Returns the
  // gain.
  std::int64_t bridge() {
    const std::size_t reach = std::min(window, n_ - 2);
    const std::size_t from = random_.below(static_cast<std::uint32_t>(n_));
    const std::size_t first = 1 + random_.below(static_cast<std::uint32_t>(reach / 2));
    const std::size_t second = 1 + random_.below(static_cast<std::uint32_t>(reach - reach / 2));
    std::vector<City> before;
    for (std::size_t at = 0; at < first + second; ++at) {
      before.push_back(tour_[(from + at) % n_]);
    }
    const City a = previous(before.front());
    const City f = next(before.back());
    const City c = before[first - 1];
    const City dd = before[first];
    const std::int64_t gain = d(a, before.front()) + d(c, dd) + d(before.back(), f) - d(a, dd) -
                              d(before.back(), before.front()) - d(c, f);
    std::vector<City> after(before.begin() + static_cast<std::ptrdiff_t>(first), before.end());
    after.insert(after.end(), before.begin(), before.begin() + static_cast<std::ptrdiff_t>(first));
    write(from, after);
    for (const City city : {a, before.front(), c, dd, before.back(), f}) {
      enqueue(city);
    }
    undo_.push_back({from, 0, std::move(before)});
    return gain;
  }

  // Applies moves from queued cities until none is left; returns the gain.
  template <typename Stop>
  std::int64_t work(Stop&& stop) {
    std::int64_t total = 0;
    std::uint32_t until_question = 256;
    while (!queue_.empty()) {
      const City a = queue_.back();
      queue_.pop_back();
      queued_[a] = false;
      if (--until_question == 0) {
        until_question = 256;
        if (stop()) {
          break;
        }
      }
      for (std::int64_t gain = improve(a); gain > 0; gain = improve(a)) {
        total += gain;
      }
    }
    for (const City a : queue_) {
      queued_[a] = false;
    }
    queue_.clear();
    return total;
  }

  std::int64_t improve(City a) {
    std::int64_t gain = two_opt(a);
    if (gain == 0) {
      gain = or_opt(a);
    }
    return gain;
  }

  // Replaces the steps from a and from its neighbour c, both forwards or both backwards.
  std::int64_t two_opt(City a) {
    for (const bool forwards : {true, false}) {
      const City b = forwards ? next(a) : previous(a);
      const std::int64_t old = d(a, b);
      for (const City c : neighbours_[a]) {
        const std::int64_t near = d(a, c);
        if (near >= old) {
          break;
        }
        const City e = forwards ? next(c) : previous(c);
        const std::int64_t gain = old + d(c, e) - near - d(b, e);
        if (c == b || e == a || gain <= 0) {
          continue;
        }
        if (forwards) {
          reverse(b, c);
        } else {
          reverse(c, b);
        }
        for (const City city : {a, b, c, e}) {
          enqueue(city);
        }
        return gain;
      }
    }
    return 0;
  }

  // Moves a stretch of up to three cities that ends in a between a's neighbour c and a city next to
  // c.
  std::int64_t or_opt(City a) {
    for (const bool forwards : {true, false}) {
      // The stretch is a = s₁, s₂, …, towards the tour's end if forwards; outside are p, next to a,
      // and q.
      City last = a;
      const City p = forwards ? previous(a) : next(a);
      for (std::size_t length = 1; length <= longest_segment && length + 3 <= n_; ++length) {
        if (length > 1) {
          last = forwards ? next(last) : previous(last);
        }
        const City q = forwards ? next(last) : previous(last);
        const std::int64_t freed = d(p, a) + d(last, q) - d(p, q);
        if (freed <= 0) {
          continue;
        }
        for (const City c : neighbours_[a]) {
          const std::int64_t near = d(a, c);
          if (near >= freed) {
            break;
          }
          if (within(c, a, last, forwards)) {
            continue;
          }
          for (const bool after : {true, false}) {
            // Between c and e, with a next to c.
            const City e = after ? next(c) : previous(c);
            if (within(e, a, last, forwards)) {
              continue;
            }
            const std::int64_t gain = freed + d(c, e) - near - d(last, e);
            if (gain > 0) {
              insert(a, last, forwards, c, after);
              for (const City city : {a, last, p, q, c, e}) {
                enqueue(city);
              }
              return gain;
            }
          }
        }
      }
    }
    return 0;
  }

  [[nodiscard]] bool within(City c, City a, City last, bool forwards) const {
    const std::size_t begin = forwards ? place_[a] : place_[last];
    const std::size_t end = forwards ? place_[last] : place_[a];
    return (place_[c] + n_ - begin) % n_ <= (end + n_ - begin) % n_;
  }

  // Moves the stretch from a to last next to c, with a adjacent to c, after c or before it, by
  // reversals of the stretch and of the cities that it passes.
  void insert(City a, City last, bool forwards, City c, bool after) {
    const City begin = forwards ? a : last;  // the stretch along the tour
    const City end = forwards ? last : a;
    const bool turned = forwards != after;  // a comes first after c, last before it
    // The gap is between g and next(g).
    const City g = after ? c : previous(c);
    const City h = next(g);
    const std::size_t ahead = (place_[g] + n_ - place_[end]) % n_;     // cities from end to g
    const std::size_t behind = (place_[begin] + n_ - place_[h]) % n_;  // and from h to begin
    // To move past a stretch X, reverse both together, then each of them.
    if (ahead <= behind) {
      const City x = next(end);
      if (reverse(begin, g)) {  // S X → X⁻ S⁻
        reverse(g, x);
      } else {
        reverse(x, g);
      }
    } else {
      const City x = previous(begin);
      if (reverse(h, end)) {  // X S → S⁻ X⁻
        reverse(x, h);
      } else {
        reverse(h, x);
      }
    }
    // The stretch is short, so it is the shorter way between its ends.
    if (!turned) {
      if ((place_[end] + n_ - place_[begin]) % n_ < longest_segment) {
        reverse(begin, end);
      } else {
        reverse(end, begin);
      }
    }
  }

  const Weight& weight_;
  const Neighbours& neighbours_;
  Random& random_;
  std::size_t n_;
  std::vector<City> tour_;
  std::vector<City> place_;
  std::vector<City> queue_;
  std::vector<bool> queued_;
  std::vector<Step> undo_;
};

}  // namespace changeover
