// Searches for shares of workers who hold some groups of items and stream others past them, and
// writes the table of them.
//
//     find_shares < TABLE > NEW_TABLE            checks it, and leaves out what is of no use
//     find_shares 20000 7 < TABLE > NEW_TABLE    20,000 tries, seed 7
//
// TABLE is src/loadorder/shares/groups/share_table.inc (docs/tools/find_shares.sh compiles it and
// puts the new table in place.) A separate program: it includes nothing of the library, which
// reads each line of the table again.
//
// *A line* "n m | A / S | A / S …" has base shares (A, S) of Z_n, m a divisor of n; the workers are
// their translates by multiples of m. Two groups meet at a worker that holds both, or holds one and
// streams the other. Every two must meet, and every group be held.
//
// *A try* picks a case (items, room, workers) in which the best known share is far above the bound,
// and parameters n, m, |A|, |S| that would be better; then A and S are annealed: a move exchanges
// two groups of a base share, what counts is how many orbits of pairs do not meet. Results depend
// on the table that is read, the number of tries and the seed alone.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "annealing.hpp"
#include "shares.hpp"

namespace find_shares {
namespace {

// Loads of the busiest worker, from below: the least that sharing needs (docs/theorems.md, Theorem
// 17, in the limit of many items).
double most_items_of_a_load(int workers) {
  static const double small[] = {1, 1, 1, 1.5, 5.0 / 3, 1.8};
  if (workers <= 5) {
    return small[workers];
  }
  double best = 1e9;
  const double w = workers;
  for (double k = 1; (k - 1) * (k - 1) <= w; ++k) {
    const double twice = std::max(0.0, k * k * (w + k * k - 2 * k) / (w * (w - 1)) - 1) / (k + 1);
    double most = (k + twice * w) / (1 + twice * (k + 1));
    most = (k + 1) * most < w ? k : std::min(most, k);
    best = std::min(best, std::max({k - 1, 1.0, most, w / (k + 1)}));
  }
  return best;
}

double bound(double items, double room, double workers) {
  const double pairs = items * (items - 1) / 2 / workers;
  const double full = room * (room - 1) / 2;
  const double by_pairs =
      pairs <= full ? (1 + std::sqrt(1 + 8 * pairs)) / 2 : room + (pairs - full) / (room - 1);
  return std::max(by_pairs, items / most_items_of_a_load(static_cast<int>(workers)));
}

// About what stretches of an order take.
double stretch(double items, double room, double workers) {
  const double rho = items / room;
  const double c = std::max(2.0, std::ceil(rho / 2));
  const double all = rho <= 1   ? 1
                     : rho <= 2 ? 2 * rho - 1
                                : 1 + 2 * c * c - (2 * c - 1) * (2 * c - rho);
  return all * room / workers + room * (1 - 1 / workers);
}

double loads_of(int groups, int all, int items) {
  return std::ceil(static_cast<double>(all) * items / groups) + (items % groups != 0 ? 1 : 0);
}
bool fits(int groups, int held, bool streams, int items, int room) {
  return groups <= items && held * ((items + groups - 1) / groups) + (streams ? 1 : 0) <= room;
}

struct Case {
  int items, room, workers;
  double least;
  double best;  // loads of the busiest worker
  double even;  // the same where pairs are even, too
};

class Cases {
 public:
  Cases() {
    for (const int items : {256, 1024, 4096}) {
      for (int workers = 4; workers <= 64; ++workers) {
        for (int i = 0; i <= 40; ++i) {
          const int room = static_cast<int>(std::lround(items * std::pow(2.0, -i / 8.0)));
          const double stretches = stretch(items, room, workers);
          all.push_back({items, room, workers, bound(items, room, workers), stretches, stretches});
        }
      }
    }
    for (const int q : {2, 3, 4, 5, 7}) {
      use(q * q + q + 1, q * q + q + 1, q + 1, q + 1, true);
      use(q * q + q, q * q, q, q, true);
    }
  }
  void use(const Shares& shares, bool is_even) {
    use(shares.workers(), shares.groups, shares.held(), shares.all(), is_even);
  }
  void use(int workers, int groups, int held, int each, bool is_even) {
    for (Case& one : all) {
      if (one.workers >= workers && fits(groups, held, each > held, one.items, one.room)) {
        const double loads = loads_of(groups, each, one.items);
        one.best = std::min(one.best, loads);
        one.even = is_even ? std::min(one.even, loads) : one.even;
      }
    }
  }
  // More likely the further it is from the bound, or from what is known if pairs are uneven.
  const Case& pick(Dice& dice, bool for_even) const {
    const auto weight = [&](const Case& one) {
      const double over =
          for_even ? one.even / one.best - 1 : std::max(0.0, one.best / one.least - 1.03);
      return over * over * over;
    };
    double sum = 0;
    for (const Case& one : all) {
      sum += weight(one);
    }
    double at = dice.part() * sum;
    for (const Case& one : all) {
      at -= weight(one);
      if (at < 0) {
        return one;
      }
    }
    return all.back();
  }
  void report(long tries) const {
    double sum = 0;
    const Case* worst = &all[0];
    int above = 0;
    int uneven = 0;
    for (const Case& one : all) {
      sum += one.best / one.least;
      uneven += one.even > one.best * 1.03 ? 1 : 0;
      above += one.best / one.least > 1.15 ? 1 : 0;
      worst = one.best / one.least > worst->best / worst->least ? &one : worst;
    }
    std::fprintf(
        stderr,
        "%ld tries: %.4f of the bound on average, %.3f at (%d, %d, W = %d), %d of %zu above 1.15, "
        "%d uneven\n",
        tries, sum / static_cast<double>(all.size()), worst->best / worst->least, worst->items,
        worst->room, worst->workers, above, all.size(), uneven);
  }

  std::vector<Case> all;
};

class Search {
 public:
  Search(std::vector<Shares> table, std::uint64_t seed) : table_(std::move(table)), dice_(seed) {
    for (const Shares& shares : table_) {
      cases_.use(shares, is_even(shares));
    }
  }

  // Covers of all differences: sizes that are too large by one are tried again.
  void find_covers() {
    constexpr int largest = 200;
    constexpr long moves = 2'000'000;
    std::map<int, int> least;
    for (const Shares& shares : table_) {
      if (!shares.streams() && shares.step == 1 && shares.base.size() == 1) {
        int& size = least.try_emplace(shares.groups, shares.held()).first->second;
        size = std::min(size, shares.held());
      }
    }
    for (int n = 3; n <= largest; ++n) {
      const Orbits orbits(n, 1);
      const auto known = least.find(n);
      int size = known == least.end() ? static_cast<int>(std::sqrt(n)) : known->second - 1;
      for (; size * (size - 1) >= n - 1; ++size) {
        if (known != least.end() && size >= known->second) {
          break;
        }
        if (attempt(orbits, 1, size, 0, moves) || known != least.end()) {
          break;
        }
      }
      if (size * (size - 1) < n - 1 && known == least.end()) {
        while (!attempt(orbits, 1, ++size, 0, moves)) {
        }
      }
    }
  }

  // Lines with several base shares, whose pairs need not be even: they are changed, and where that
  // does not help, halves of their groups.
  void even_out() {
    constexpr int most_halves = 90;
    int above = 0;
    for (std::size_t i = 0; i < table_.size(); ++i) {
      const double before = even_out(table_[i]);
      if (before > enough && 2 * table_[i].groups <= most_halves) {
        Shares halves = in_halves(table_[i]);
        const double after = even_out(halves);
        if (after < before - 0.01) {
          table_.push_back(std::move(halves));
        }
      }
      above += before > enough ? 1 : 0;
    }
    std::fprintf(stderr, "%d of %zu lines have pairs more uneven than %.2f\n", above, table_.size(),
                 enough);
  }

  void run(long tries) {
    for (long i = 1; i <= tries; ++i) {
      try_one();
      if (i % 100 == 0) {
        cases_.report(i);
      }
    }
  }

  // What no case and no other line makes superfluous.
  std::vector<Shares> useful() {
    std::vector<Shares> kept;
    std::vector<double> uneven;
    for (const Shares& shares : table_) {
      uneven.push_back(unevenness(shares, orbits({shares.groups, shares.step, 0, 0, 0, 0})));
    }
    for (std::size_t i = 0; i < table_.size(); ++i) {
      bool beaten = false;
      for (std::size_t j = 0; j < table_.size() && !beaten; ++j) {
        beaten =
            j != i && uneven[j] <= std::max(uneven[i], 1.04) && beats(table_[j], table_[i], j < i);
      }
      if (!beaten) {
        kept.push_back(table_[i]);
      }
    }
    std::sort(kept.begin(), kept.end(), [](const Shares& a, const Shares& b) {
      return std::tuple(a.workers(), a.groups, a.held(), a.all(), a.base) <
             std::tuple(b.workers(), b.groups, b.held(), b.all(), b.base);
    });
    return kept;
  }

 private:
  // No worse for any items and room. Few groups are better where there are few items.
  static bool beats(const Shares& a, const Shares& b, bool if_equal) {
    const auto less = [](int x, int of, int y, int of_y) { return x * of_y <= y * of; };
    const bool no_worse = a.workers() <= b.workers() && a.groups <= std::max(b.groups, 32) &&
                          less(a.held(), a.groups, b.held(), b.groups) &&
                          less(a.all(), a.groups, b.all(), b.groups) &&
                          (b.streams() || !a.streams());
    const bool no_better = b.workers() <= a.workers() && b.groups <= std::max(a.groups, 32) &&
                           less(b.held(), b.groups, a.held(), a.groups) &&
                           less(b.all(), b.groups, a.all(), a.groups) &&
                           (a.streams() || !b.streams());
    return no_worse && (!no_better || if_equal);
  }

  static constexpr double enough = 1.03;

  bool is_even(const Shares& shares) {
    constexpr double most = 1.045;
    return unevenness(shares, orbits({shares.groups, shares.step, 0, 0, 0, 0})) <= most;
  }

  // How uneven they are then.
  double even_out(Shares& shares) {
    constexpr long moves = 200'000;
    const Orbits& own = orbits({shares.groups, shares.step, 0, 0, 0, 0});
    double value = unevenness(shares, own);
    for (int i = 0; i < 3 && value > enough; ++i) {
      Annealing annealing(own, static_cast<int>(shares.base.size()), shares.held(),
                          shares.all() - shares.held(), dice_);
      annealing.begin_from(shares);
      Shares now = annealing.even_out(moves);
      if (const double other = unevenness(now, own); is_right(now) && other < value) {
        shares = std::move(now);
        value = other;
      }
    }
    return value;
  }

  static Shares in_halves(const Shares& shares) {
    Shares halves;
    halves.groups = 2 * shares.groups;
    halves.step = 2 * shares.step;
    for (const auto& [a, s] : shares.base) {
      auto& [held, streamed] = halves.base.emplace_back();
      for (const int x : a) {
        held.insert(held.end(), {2 * x, 2 * x + 1});
      }
      for (const int x : s) {
        streamed.insert(streamed.end(), {2 * x, 2 * x + 1});
      }
    }
    return halves;
  }

  bool attempt(const Orbits& orbits, int bases, int held, int streamed, long moves) {
    Annealing annealing(orbits, bases, held, streamed, dice_);
    if (!annealing.run(moves)) {
      return false;
    }
    table_.push_back(annealing.result());
    if (!is_even(table_.back())) {
      even_out(table_.back());
    }
    cases_.use(table_.back(), is_even(table_.back()));
    return true;
  }

  struct Parameters {
    int groups = 0, step = 0, bases = 0, held = 0, streamed = 0;
    double slack = 0;  // meetings that there are, by those that there must be
  };

  // What would be better in this case, and is not impossible because there are too few meetings.
  Parameters some_parameters(const Case& one) {
    constexpr int most_bases = 24;
    constexpr int most_groups = 200;
    const int fewer = dice_.below(3) == 0 ? dice_.below(1 + one.workers / 8) : 0;
    const int workers = one.workers - fewer;
    std::vector<int> turns;  // workers of a base share
    for (int g = 1; g <= workers; ++g) {
      if (workers % g == 0 && workers / g <= most_bases) {
        turns.push_back(g);
      }
    }
    const int turn = turns[static_cast<std::size_t>(dice_.below(static_cast<int>(turns.size())))];
    const int wide = std::max(12, static_cast<int>(9 * std::sqrt(workers)));
    const int most = std::min({most_groups, one.items, std::max(wide, 3 * turn)});
    Parameters p;
    p.groups = turn * (1 + dice_.below(std::max(1, most / turn)));
    p.step = p.groups / turn;
    p.bases = workers / turn;
    int all = static_cast<int>(one.best * p.groups / one.items);
    while (all > 0 && loads_of(p.groups, all, one.items) >= one.best) {
      --all;
    }
    all = std::min(all, p.groups);
    while (p.held < all && fits(p.groups, p.held + 1, true, one.items, one.room)) {
      ++p.held;
    }
    if (p.held == all || (dice_.below(4) == 0 && fits(p.groups, all, false, one.items, one.room))) {
      p.held = all;
    } else if (p.held > 1 && dice_.below(4) == 0) {
      --p.held;
    }
    p.streamed = all - p.held;
    if (p.groups < 4 || p.held < 1 || p.held * p.bases < p.step) {
      return p;
    }
    p.slack = static_cast<double>(p.bases) * (p.held * (p.held - 1) / 2 + p.held * p.streamed) /
              orbits(p).count;
    return p;
  }

  const Orbits& orbits(const Parameters& p) {
    auto& known = orbits_[{p.groups, p.step}];
    if (!known) {
      known = std::make_unique<Orbits>(p.groups, p.step);
    }
    return *known;
  }

  void try_one() {
    constexpr int most_looks = 200;
    constexpr int choices = 3;
    const bool for_even = dice_.below(3) == 0;
    Case one = cases_.pick(dice_, for_even);
    one.best = for_even ? one.even : one.best;
    Parameters best;
    for (int look = 0, found = 0; look < most_looks && found < choices; ++look) {
      const Parameters p = some_parameters(one);
      if (p.slack >= 1) {
        ++found;
        best = p.slack > best.slack ? p : best;
      }
    }
    if (best.slack < 1) {
      return;
    }
    const long moves = 200'000'000L / (best.held + best.streamed + 8);
    while (best.streamed >= 0 &&
           attempt(orbits(best), best.bases, best.held, best.streamed, moves)) {
      --best.streamed;
    }
  }

  std::vector<Shares> table_;
  Dice dice_;
  Cases cases_;
  std::map<std::pair<int, int>, std::unique_ptr<Orbits>> orbits_;
};

}  // namespace
}  // namespace find_shares

int main(int count, char** words) {
  using namespace find_shares;
  const long tries = count > 1 ? std::atol(words[1]) : 0;
  Search search(read_table(std::cin),
                count > 2 ? static_cast<std::uint64_t>(std::atol(words[2])) : 1);
  if (tries > 0) {
    search.find_covers();
    search.run(tries);
    search.even_out();
  }
  std::puts(
      "// Written by docs/tools/find_shares.sh. Do not edit: a line that is wrong is refused by the "
      "tests.");
  for (const Shares& shares : search.useful()) {
    if (!is_right(shares)) {
      std::fprintf(stderr, "a share that was found is wrong\n");
      return 1;
    }
    std::printf("\"%s\",\n", line_of(shares).c_str());
  }
}
