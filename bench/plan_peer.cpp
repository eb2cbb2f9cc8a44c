#include "plan_peer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <numeric>
#include <random>

namespace changeover::bench {
namespace {

using SetUp = std::vector<std::uint32_t>;

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class PlainAnnealer {
 public:
  PlainAnnealer(const std::vector<double>& prices, std::size_t room, double test_cost,
                std::uint64_t seed)
      : prices_(prices),
        v_(prices.size()),
        room_(std::min(room, prices.size())),
        test_(test_cost),
        random_(seed),
        met_(v_ * v_, 0),
        open_at_(v_ * v_, 0) {
    for (std::uint32_t x = 0; x < v_; ++x) {
      for (std::uint32_t y = 0; y < x; ++y) {
        open(x, y);
      }
    }
  }

  PlainPlan run(double seconds) {
    const double begin = processor_seconds();
    greedy();
    const double pairs = static_cast<double>(v_ * (v_ - 1)) / 2;
    const double per_pair = cost() / pairs;
    const double penalty = 2.0 * per_pair;
    const double hot = 0.5 * penalty;
    const double cold = 0.04 * penalty;
    keep_best();
    std::uint64_t moves = 0;
    for (double done = 0; done < 1; ++moves) {
      if (moves % 1024 == 0) {
        done = (processor_seconds() - begin) / seconds;
        temperature_ = hot * std::pow(cold / hot, done);
        penalty_ = penalty * (1.0 + 4.0 * std::max(0.0, done - 0.5));
      }
      move();
    }
    finish();
    return {best_, moves};
  }

 private:
  std::size_t below(std::size_t n) {
    return static_cast<std::size_t>((std::uint64_t{static_cast<std::uint32_t>(random_())} * n) >>
                                    32U);
  }
  double unit() { return (static_cast<double>(random_() >> 11U) + 0.5) * 0x1p-53; }

  static std::size_t index(std::size_t v, std::uint32_t x, std::uint32_t y) {
    return std::max(x, y) * v + std::min(x, y);
  }
  void open(std::uint32_t x, std::uint32_t y) {
    open_at_[index(v_, x, y)] = open_.size();
    open_.push_back({x, y});
  }
  void meet(std::uint32_t x, std::uint32_t y) {
    const std::size_t pair = index(v_, x, y);
    if (met_[pair]++ == 0) {
      const auto last = open_.back();
      open_[open_at_[pair]] = last;
      open_at_[index(v_, last[0], last[1])] = open_at_[pair];
      open_.pop_back();
    }
  }
  void part(std::uint32_t x, std::uint32_t y) {
    if (--met_[index(v_, x, y)] == 0) {
      open(x, y);
    }
  }

  // The set-up beside, or none at the ends.
  [[nodiscard]] bool in(std::size_t at, std::uint32_t x) const {
    return at < list_.size() && holds_[at][x] != 0;
  }
  [[nodiscard]] double step(std::size_t from, std::size_t to) const {
    double total = 0;
    if (to < list_.size()) {
      for (const std::uint32_t x : list_[to]) {
        total += in(from, x) ? 0 : prices_[x];
      }
    }
    return total;
  }
  [[nodiscard]] double cost() const {
    double total = test_ * static_cast<double>(list_.size());
    for (std::size_t i = 0; i < list_.size(); ++i) {
      total += step(i - 1, i);
    }
    return total;
  }

  void insert(std::size_t at, const SetUp& setup) {
    list_.insert(list_.begin() + static_cast<std::ptrdiff_t>(at), setup);
    std::vector<std::uint8_t> holds(v_, 0);
    for (std::size_t i = 0; i < setup.size(); ++i) {
      holds[setup[i]] = 1;
      for (std::size_t j = 0; j < i; ++j) {
        meet(setup[i], setup[j]);
      }
    }
    holds_.insert(holds_.begin() + static_cast<std::ptrdiff_t>(at), holds);
  }

  void greedy() {
    SetUp bench;
    while (!open_.empty()) {
      SetUp chosen;
      double most = -1;
      for (std::size_t j = bench.empty() ? room_ : 1; j <= room_; ++j) {
        SetUp next = bench;
        const auto left = [&](std::uint32_t x) {
          std::size_t n = 0;
          for (std::uint32_t y = 0; y < v_; ++y) {
            n += y != x && met_[index(v_, x, y)] == 0 ? 1U : 0U;
          }
          return n;
        };
        std::stable_sort(next.begin(), next.end(),
                         [&](auto x, auto y) { return left(x) > left(y); });
        next.resize(std::min(next.size(), room_ - j));
        std::size_t gain = 0;
        double price = test_;
        while (next.size() < room_) {
          std::uint32_t best = 0;
          double best_value = -1;
          std::size_t best_gain = 0;
          for (std::uint32_t y = 0; y < v_; ++y) {
            if (std::find(next.begin(), next.end(), y) != next.end()) {
              continue;
            }
            std::size_t brings = 0;
            for (const std::uint32_t x : next) {
              brings += met_[index(v_, x, y)] == 0 ? 1U : 0U;
            }
            const double value = (static_cast<double>(brings) + 0.01) / (0.1 + prices_[y]);
            if (value > best_value) {
              best = y;
              best_value = value;
              best_gain = brings;
            }
          }
          next.push_back(best);
          gain += best_gain;
          price += std::find(bench.begin(), bench.end(), best) == bench.end() ? prices_[best] : 0;
        }
        const double ratio = static_cast<double>(gain) / price;
        if (gain > 0 && ratio > most) {
          most = ratio;
          chosen = next;
        }
      }
      if (chosen.empty()) {  // The first open pair in place of two others.
        chosen = bench;
        for (const std::uint32_t x : open_.front()) {
          if (std::find(chosen.begin(), chosen.end(), x) == chosen.end()) {
            const auto victim = std::find_if(chosen.begin(), chosen.end(), [&](auto y) {
              return y != open_.front()[0] && y != open_.front()[1];
            });
            *victim = x;
          }
        }
      }
      bench = chosen;
      insert(list_.size(), chosen);
    }
  }

  // What has not met in the end meets in copies of set-ups that hold one of the two.
  void finish() {
    while (!open_.empty()) {
      const auto [x, y] = open_.front();
      std::size_t at = 0;
      while (!in(at, x)) {
        ++at;
      }
      SetUp copy = list_[at];
      copy[copy[0] == x ? 1 : 0] = y;
      insert(at + 1, copy);
    }
    keep_best();
  }

  bool accept(double rise) { return rise <= 0 || unit() < std::exp(-rise / temperature_); }

  void keep_best() {
    if (!open_.empty()) {
      return;
    }
    const double now = cost();
    if (best_.empty() || now < best_cost_ - 1e-9) {
      best_cost_ = now;
      best_ = list_;
    }
  }

  void move() {
    const std::size_t dice = below(100);
    if (dice < 90) {
      replace();
    } else if (dice < 94) {
      erase();
    } else if (dice < 96) {
      twice();
    } else if (dice < 98) {
      reverse(1);
    } else {
      reverse(below(list_.size()));
    }
  }

  // What x, present or not at a place, pays there and right after.
  [[nodiscard]] double stay(std::size_t at, std::uint32_t x, bool present) const {
    const bool before = at > 0 && in(at - 1, x);
    const bool after = in(at + 1, x);
    return (present && !before ? prices_[x] : 0) + (!present && after ? prices_[x] : 0);
  }

  void replace() {
    std::size_t at = below(list_.size());
    std::size_t i = below(room_);
    std::uint32_t y = 0;
    const std::size_t how = below(3);
    if (how == 0 && !open_.empty()) {
      const auto& pair = open_[below(open_.size())];
      const bool swap = below(2) == 0;
      y = pair[swap ? 1 : 0];
      for (std::size_t tries = 0; tries < list_.size() && !in(at, pair[swap ? 0 : 1]); ++tries) {
        at = at + 1 == list_.size() ? 0 : at + 1;
      }
      if (list_[at][i] == pair[swap ? 0 : 1]) {
        return;
      }
    } else if (how == 1 && list_.size() > 1) {
      const std::size_t beside = at == 0                                   ? 1
                                 : at + 1 == list_.size() || below(2) == 0 ? at - 1
                                                                           : at + 1;
      y = list_[beside][below(room_)];
    } else {
      y = static_cast<std::uint32_t>(below(v_));
    }
    if (in(at, y)) {
      return;
    }
    const std::uint32_t x = list_[at][i];
    double rise = stay(at, x, false) - stay(at, x, true) + stay(at, y, true) - stay(at, y, false);
    for (const std::uint32_t z : list_[at]) {
      if (z != x) {
        rise += met_[index(v_, x, z)] == 1 ? penalty_ : 0;
        rise -= met_[index(v_, y, z)] == 0 ? penalty_ : 0;
      }
    }
    if (!accept(rise)) {
      return;
    }
    list_[at][i] = y;
    holds_[at][x] = 0;
    holds_[at][y] = 1;
    for (const std::uint32_t z : list_[at]) {
      if (z != y) {
        part(x, z);
        meet(y, z);
      }
    }
    if (open_.empty() && rise < 0) {
      keep_best();
    }
  }

  void erase() {
    const std::size_t at = below(list_.size());
    const SetUp& setup = list_[at];
    if (list_.size() < 2) {
      return;
    }
    for (std::size_t i = 0; i < setup.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (met_[index(v_, setup[i], setup[j])] == 1) {
          return;
        }
      }
    }
    const double rise = (at == 0 ? step(list_.size(), 1) : step(at - 1, at + 1)) - test_ -
                        step(at == 0 ? list_.size() : at - 1, at) - step(at, at + 1);
    if (!accept(rise)) {
      return;
    }
    for (std::size_t i = 0; i < setup.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        part(setup[i], setup[j]);
      }
    }
    list_.erase(list_.begin() + static_cast<std::ptrdiff_t>(at));
    holds_.erase(holds_.begin() + static_cast<std::ptrdiff_t>(at));
    keep_best();
  }

  // A set-up comes once more right after itself: it costs a test only, and moves make something of
  // it.
  void twice() {
    const std::size_t at = below(list_.size());
    if (accept(test_)) {
      const SetUp copy = list_[at];
      insert(at, copy);
    }
  }

  void reverse(std::size_t most) {
    std::size_t first = below(list_.size());
    std::size_t last = std::min(list_.size() - 1, first + 1 + below(most + 1));
    if (first == last) {
      return;
    }
    const auto at = [&](std::size_t i) { return list_.begin() + static_cast<std::ptrdiff_t>(i); };
    const auto held = [&](std::size_t i) {
      return holds_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    const std::size_t none = list_.size();
    const auto price = [&](const SetUp& setup) {
      return std::accumulate(setup.begin(), setup.end(), 0.0,
                             [&](double sum, std::uint32_t x) { return sum + prices_[x]; });
    };
    const double rise = step(first == 0 ? none : first - 1, last) -
                        step(first == 0 ? none : first - 1, first) + step(first, last + 1) -
                        step(last, last + 1) + price(list_[first]) - price(list_[last]);
    if (accept(rise)) {
      std::reverse(at(first), at(last + 1));
      std::reverse(held(first), held(last + 1));
      if (rise < 0) {
        keep_best();
      }
    }
  }

  std::vector<double> prices_;
  std::size_t v_;
  std::size_t room_;
  double test_;
  std::mt19937_64 random_;
  std::vector<std::uint32_t> met_;
  std::vector<std::size_t> open_at_;
  std::vector<std::array<std::uint32_t, 2>> open_;
  std::vector<SetUp> list_;
  std::vector<std::vector<std::uint8_t>> holds_;
  double penalty_ = 0;
  double temperature_ = 0;
  double best_cost_ = 0;
  std::vector<SetUp> best_;
};

}  // namespace

PlainPlan anneal_plainly(const std::vector<double>& prices, std::size_t room, double test_cost,
                         double seconds, std::uint64_t seed) {
  return PlainAnnealer(prices, room, test_cost, seed).run(seconds);
}

}  // namespace changeover::bench
