// Shares of groups as the table has them: read, checked by definition, written.
#pragma once

#include <algorithm>
#include <cstdint>
#include <istream>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace find_shares {

using Set = std::vector<int>;

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15ULL + 1) {}
  std::uint64_t next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return state_ * 0x2545f4914f6cdd1dULL;
  }
  int below(int limit) {
    return static_cast<int>((next() >> 32) * static_cast<std::uint64_t>(limit) >> 32);
  }
  double part() { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

struct Shares {
  int groups = 0;
  int step = 0;
  std::vector<std::pair<Set, Set>> base;  // held, streamed

  int workers() const { return static_cast<int>(base.size()) * (groups / step); }
  int held() const { return static_cast<int>(base[0].first.size()); }
  int all() const { return held() + static_cast<int>(base[0].second.size()); }
  bool streams() const { return all() > held(); }
};

// Orbits of pairs of Z_n under translation by multiples of m.
struct Orbits {
  Orbits(int n, int m) : n(n), step(m), of(static_cast<std::size_t>(n) * n, -1) {
    for (int x = 0; x < n; ++x) {
      for (int y = x + 1; y < n; ++y) {
        if (at(x, y) >= 0) {
          continue;
        }
        for (int by = 0; by < n; by += m) {
          const int u = (x + by) % n;
          const int v = (y + by) % n;
          of[static_cast<std::size_t>(u) * n + v] = of[static_cast<std::size_t>(v) * n + u] = count;
        }
        ++count;
      }
    }
  }
  int at(int x, int y) const { return of[static_cast<std::size_t>(x) * n + y]; }

  int n, step, count = 0;
  std::vector<int> of;
};

// By definition: every two groups meet at some worker, every group is held.
inline bool is_right(const Shares& shares) {
  const int n = shares.groups;
  if (n < 1 || shares.step < 1 || n % shares.step != 0 || shares.base.empty()) {
    return false;
  }
  std::vector<bool> met(static_cast<std::size_t>(n) * n, false);
  std::vector<bool> held(static_cast<std::size_t>(n), false);
  for (const auto& [a, s] : shares.base) {
    if (a.size() != shares.base[0].first.size() || s.size() != shares.base[0].second.size()) {
      return false;
    }
    for (int by = 0; by < n; by += shares.step) {
      for (const int x : a) {
        held[static_cast<std::size_t>((x + by) % n)] = true;
        for (const Set* const others : {&a, &s}) {
          for (const int y : *others) {
            if (x < 0 || x >= n || y < 0 || y >= n) {
              return false;
            }
            const int u = (x + by) % n;
            const int v = (y + by) % n;
            met[static_cast<std::size_t>(std::max(u, v)) * n + std::min(u, v)] = true;
          }
        }
      }
    }
  }
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < x; ++y) {
      if (!met[static_cast<std::size_t>(x) * n + y]) {
        return false;
      }
    }
  }
  return std::find(held.begin(), held.end(), false) == held.end();
}

// Pairs of one worker by the mean, if they are spread as evenly as can be over the workers that
// have them; in the limit of large groups.
inline double unevenness(const Shares& shares, const Orbits& orbits) {
  const std::size_t bases = shares.base.size();
  if (bases == 1) {
    return 1;
  }
  // By orbit of pairs, then by orbit of groups: how much there is, and how often each base share
  // has it.
  const std::size_t all = static_cast<std::size_t>(orbits.count + orbits.step);
  std::vector<double> amount(all, 0);
  std::vector<std::vector<double>> part(all, std::vector<double>(bases, 0));
  for (int x = 0; x < orbits.n; ++x) {
    amount[static_cast<std::size_t>(orbits.count + x % orbits.step)] += 0.5;
    for (int y = 0; y < x; ++y) {
      amount[static_cast<std::size_t>(orbits.at(x, y))] += 1;
    }
  }
  for (std::size_t b = 0; b < bases; ++b) {
    const auto& [a, s] = shares.base[b];
    for (std::size_t i = 0; i < a.size(); ++i) {
      part[static_cast<std::size_t>(orbits.count + a[i] % orbits.step)][b] += 1;
      for (std::size_t j = 0; j < i; ++j) {
        part[static_cast<std::size_t>(orbits.at(a[i], a[j]))][b] += 1;
      }
      for (const int y : s) {
        part[static_cast<std::size_t>(orbits.at(a[i], y))][b] += 1;
      }
    }
  }
  std::vector<double> load(bases, 0);
  double sum = 0;
  for (std::size_t o = 0; o < all; ++o) {
    const double times = std::accumulate(part[o].begin(), part[o].end(), 0.0);
    sum += amount[o];
    for (std::size_t b = 0; b < bases; ++b) {
      part[o][b] *= amount[o] / times;
      load[b] += part[o][b];
    }
  }
  constexpr int rounds = 300;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t o = 0; o < all; ++o) {
      // What is there is poured again over those that have any of it.
      std::vector<std::pair<double, std::size_t>> who;
      for (std::size_t b = 0; b < bases; ++b) {
        if (part[o][b] > 0) {
          who.emplace_back(load[b] - part[o][b], b);
        }
      }
      if (who.size() < 2) {
        continue;
      }
      std::sort(who.begin(), who.end());
      double height = 0;
      double poured = amount[o];
      for (std::size_t k = 0; k < who.size(); ++k) {
        poured += who[k].first;
        height = poured / static_cast<double>(k + 1);
        if (k + 1 == who.size() || height <= who[k + 1].first) {
          break;
        }
      }
      for (const auto& [others, b] : who) {
        const double to = std::max(1e-9, height - others);  // it still has it
        load[b] = others + to;
        part[o][b] = to;
      }
    }
  }
  return *std::max_element(load.begin(), load.end()) * static_cast<double>(bases) / sum;
}

// The lines of a table between quotation marks.
inline std::vector<Shares> read_table(std::istream& in) {
  std::vector<Shares> table;
  for (std::string line; std::getline(in, line);) {
    const std::size_t first = line.find('"');
    const std::size_t last = line.rfind('"');
    if (line.compare(0, 2, "//") == 0 || line.compare(0, 1, "#") == 0 || first == last) {
      continue;
    }
    std::istringstream words(line.substr(first + 1, last - first - 1));
    Shares shares;
    words >> shares.groups >> shares.step;
    Set* set = nullptr;
    for (std::string word; words >> word;) {
      if (word == "|") {
        set = &shares.base.emplace_back().first;
      } else if (word == "/") {
        set = &shares.base.back().second;
      } else if (set != nullptr) {
        set->push_back(std::atoi(word.c_str()));
      }
    }
    if (!is_right(shares)) {
      std::fprintf(stderr, "this line is wrong: %s\n", line.c_str());
      std::exit(1);
    }
    table.push_back(std::move(shares));
  }
  return table;
}

inline std::string line_of(const Shares& shares) {
  std::string text = std::to_string(shares.groups) + " " + std::to_string(shares.step);
  for (const auto& [a, s] : shares.base) {
    text += " |";
    for (const int x : a) {
      text += " " + std::to_string(x);
    }
    text += " /";
    for (const int x : s) {
      text += " " + std::to_string(x);
    }
  }
  return text;
}

}  // namespace find_shares
