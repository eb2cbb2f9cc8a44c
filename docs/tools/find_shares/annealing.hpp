// Base shares that are annealed until every two groups meet.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "shares.hpp"

namespace find_shares {

// Positions 0 … a−1 of each base share are held, a … a+s−1 streamed, the rest is nowhere.
class Annealing {
 public:
  Annealing(const Orbits& orbits, int bases, int held, int streamed, Dice& dice)
      : orbits_(orbits), held_(held), all_(held + streamed), dice_(dice) {
    times_.assign(static_cast<std::size_t>(orbits.count), 0);
    kept_.assign(static_cast<std::size_t>(orbits.step), 0);
    missing_ = orbits.count + orbits.step;
    for (int b = 0; b < bases; ++b) {
      Set order(static_cast<std::size_t>(orbits.n));
      std::iota(order.begin(), order.end(), 0);
      for (int i = orbits.n; i > 1; --i) {
        std::swap(order[static_cast<std::size_t>(i - 1)],
                  order[static_cast<std::size_t>(dice.below(i))]);
      }
      at_.push_back(std::move(order));
      Set& own = at_.back();
      for (int i = 0; i < held_; ++i) {
        keep(own[static_cast<std::size_t>(i)], 1);
        for (int j = i + 1; j < all_; ++j) {
          meet(own[static_cast<std::size_t>(i)], own[static_cast<std::size_t>(j)], 1);
        }
      }
    }
  }

  bool run(long moves) {
    constexpr double hot = 0.8;
    constexpr double cold = 0.13;
    constexpr long piece = 256;
    double heat = hot;
    for (long done = 0; missing_ > 0 && done < moves; ++done) {
      if (done % piece == 0) {
        const double phase =
            std::fmod(2.0 * static_cast<double>(done) / static_cast<double>(moves), 1.0);
        heat = hot * std::pow(cold / hot, phase);
      }
      Set& own = at_[static_cast<std::size_t>(dice_.below(static_cast<int>(at_.size())))];
      const int i = dice_.below(all_);
      const int j = dice_.below(orbits_.n);
      if (i == j || (i < held_ && j < held_) || (i >= held_ && j >= held_ && j < all_)) {
        continue;
      }
      const int before = missing_;
      exchange(own, i, j);
      const int worse = missing_ - before;
      if (worse > 0 && std::exp(-worse / heat) < dice_.part()) {
        exchange(own, i, j);
      }
    }
    return missing_ == 0;
  }

  /// From shares that are right to others that are, whose base shares have their own pairs in
  /// numbers that are more even.
  Shares even_out(long moves) {
    begin_amounts();
    constexpr double weight = 40;
    constexpr double hot = 0.5;
    constexpr double cold = 0.1;
    Shares best = result();
    double least = spread();
    double value = weight * least;
    for (long done = 0; done < moves; ++done) {
      const double heat =
          hot * std::pow(cold / hot, static_cast<double>(done) / static_cast<double>(moves));
      const std::size_t b = static_cast<std::size_t>(dice_.below(static_cast<int>(at_.size())));
      Set& own = at_[b];
      const int i = dice_.below(all_);
      const int j = dice_.below(orbits_.n);
      if (i == j || (i < held_ && j < held_) || (i >= held_ && j >= held_ && j < all_)) {
        continue;
      }
      exchange(own, i, j);
      const double uneven = spread();
      const double now = missing_ + weight * uneven;
      if (now > value && std::exp((value - now) / heat) < dice_.part()) {
        exchange(own, i, j);
        continue;
      }
      value = now;
      if (missing_ == 0 && uneven < least) {
        least = uneven;
        best = result();
      }
    }
    return best;
  }

  void begin_from(const Shares& shares) {
    for (std::size_t b = 0; b < at_.size(); ++b) {
      Set order = shares.base[b].first;
      order.insert(order.end(), shares.base[b].second.begin(), shares.base[b].second.end());
      for (int x = 0; x < orbits_.n; ++x) {
        if (std::find(order.begin(), order.end(), x) == order.end()) {
          order.push_back(x);
        }
      }
      for (int i = 0; i < orbits_.n; ++i) {
        const auto found =
            std::find(at_[b].begin(), at_[b].end(), order[static_cast<std::size_t>(i)]);
        const int j = static_cast<int>(found - at_[b].begin());
        if (i != j) {
          exchange(at_[b], i, j);
        }
      }
    }
  }

  Shares result() const {
    Shares shares;
    shares.groups = orbits_.n;
    shares.step = orbits_.step;
    for (const Set& own : at_) {
      Set a(own.begin(), own.begin() + held_);
      Set s(own.begin() + held_, own.begin() + all_);
      std::sort(a.begin(), a.end());
      std::sort(s.begin(), s.end());
      shares.base.emplace_back(std::move(a), std::move(s));
    }
    return shares;
  }

 private:
  void meet(int x, int y, int by) {
    int& times = times_[static_cast<std::size_t>(orbits_.at(x, y))];
    missing_ += by > 0 ? (times == 0 ? -1 : 0) : (times == 1 ? 1 : 0);
    times += by;
  }
  void keep(int x, int by) {
    int& times = kept_[static_cast<std::size_t>(x % orbits_.step)];
    missing_ += by > 0 ? (times == 0 ? -1 : 0) : (times == 1 ? 1 : 0);
    times += by;
  }
  // All that the group at a position meets, but what is at `other`.
  void place(const Set& own, int position, int other, int by) {
    const int x = own[static_cast<std::size_t>(position)];
    const int end = position < held_ ? all_ : position < all_ ? held_ : 0;
    for (int j = 0; j < end; ++j) {
      if (j != position && j != other) {
        meet(x, own[static_cast<std::size_t>(j)], by);
      }
    }
    if (position < held_) {
      keep(x, by);
    }
  }
  void exchange(Set& own, int i, int j) {
    place(own, i, j, -1);
    place(own, j, i, -1);
    std::swap(own[static_cast<std::size_t>(i)], own[static_cast<std::size_t>(j)]);
    place(own, i, j, 1);
    place(own, j, i, 1);  // the two meet, or not, as before
  }

  void begin_amounts() {
    amount_.assign(static_cast<std::size_t>(orbits_.count), 0);
    for (int x = 0; x < orbits_.n; ++x) {
      for (int y = 0; y < x; ++y) {
        amount_[static_cast<std::size_t>(orbits_.at(x, y))] += 1;
      }
    }
  }

  // The squares of how far base shares are from the mean, each amount in equal parts of those that
  // have it.
  double spread() const {
    double sum = 0;
    double squares = 0;
    for (const Set& own : at_) {
      double load = 0;
      for (int i = 0; i < held_; ++i) {
        for (int j = i + 1; j < all_; ++j) {
          const auto o = static_cast<std::size_t>(
              orbits_.at(own[static_cast<std::size_t>(i)], own[static_cast<std::size_t>(j)]));
          load += amount_[o] / times_[o];
        }
        const int g = own[static_cast<std::size_t>(i)] % orbits_.step;
        load += 0.5 * (orbits_.n / orbits_.step) / kept_[static_cast<std::size_t>(g)];
      }
      sum += load;
      squares += load * load;
    }
    const double mean = sum / static_cast<double>(at_.size());
    return squares / (mean * mean) - static_cast<double>(at_.size());
  }

  const Orbits& orbits_;
  int held_, all_;
  Dice& dice_;
  std::vector<double> amount_;  // pairs of groups in an orbit
  std::vector<Set> at_;
  std::vector<int> times_;
  std::vector<int> kept_;
  int missing_ = 0;
};

}  // namespace find_shares
