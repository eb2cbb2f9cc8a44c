// Circular SCCD(v, k) with 3v − 4k + 2 blocks for 3k−2 ≤ v ≤ (10k−5)/3, one more than the bound of
// Theorem 5 [docs/theorems.md, Theorem 22].
//
// K = k−1, M = 2K+1. There are 2M places, numbered modulo 2M, and the window before place j is
// {j−K, …, j−1}. At j the element of place j+M visits it, and then that of place j comes to stay
// for K places: all pairs meet but those of places that are M apart. So let each of n = 2M−v *long*
// elements have two places, d and d+K: it stays from the one to the other and need not visit. At d
// the visitor stays while it comes, at d+K the visitor is with it already, and at d+2K the visitor
// comes after the element of that place. If these places are chosen so that i or i+M is one of them
// for each i, all pairs meet.
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"
#include "construct/tools/swaps.hpp"

namespace changeover::two_places_entry {
namespace {

class Places final : public ShortPlan {
 public:
  Places(std::uint64_t k, std::uint64_t long_ones)
      : big_(k - 1), half_(2 * big_ + 1), role_(static_cast<std::size_t>(2 * half_)) {
    choose(long_ones);
    name_.resize(role_.size());
    Element next = 0;
    for (std::uint64_t j = 0; j < role_.size(); ++j) {
      if (role(j) != Role::second) {
        name_[static_cast<std::size_t>(j)] = next++;
      }
    }
    for (std::uint64_t j = 0; j < role_.size(); ++j) {
      if (role(j) == Role::second) {
        name_[static_cast<std::size_t>(j)] = at(back(j));
      }
    }
  }

  // The window before place 0, and who makes room there.
  [[nodiscard]] Block start() const override {
    std::vector<Swap> swaps;
    Block block{static_cast<Element>(round(swaps))};
    for (std::uint64_t j = role_.size() - big_; j < role_.size(); ++j) {
      block.push_back(at(j));
    }
    return block;
  }

  // It has fewer than 5k steps.
  void add_all(std::vector<Swap>& swaps) const override {
    swaps.front().leaves = round(swaps);
    swaps.pop_back();  // it leads back to the first block
  }

 private:
  enum class Role : std::uint8_t { only, first, second };

  [[nodiscard]] Role role(std::uint64_t place) const {
    return role_[static_cast<std::size_t>(place % role_.size())];
  }
  [[nodiscard]] Element at(std::uint64_t place) const {
    return name_[static_cast<std::size_t>(place % role_.size())];
  }
  // The place K before.
  [[nodiscard]] std::uint64_t back(std::uint64_t place) const {
    return place + role_.size() - big_;
  }

  // Modulo M places are multiples tK. The t of long elements are 1, 2 or 3 apart, so that one of
  // three in a row is among them.
  void choose(std::uint64_t long_ones) {
    const bool many = long_ones > big_;
    const std::uint64_t threes = many ? 1 : half_ - 2 * long_ones;
    bool turn = many || threes % 4 == 3;  // to the other one of two places, so that it closes
    std::uint64_t place = 0;
    const auto go = [&](std::uint64_t steps) {
      role_[static_cast<std::size_t>(place % role_.size())] = Role::first;
      role_[static_cast<std::size_t>((place + big_) % role_.size())] = Role::second;
      place += steps;
    };
    const auto three = [&] {
      go(turn ? 3 * big_ : big_ - 1);
      turn = false;
    };
    if (many) {
      go(3 * big_ + 1);
      three();
      go(3 * big_ + 1);
    } else {
      for (std::uint64_t i = 0; i < threes; ++i) {
        three();
      }
    }
    for (std::uint64_t i = many ? 3 : threes; i < long_ones; ++i) {
      go(role_.size() - 1);
    }
  }

  // The steps once round; returns who makes room for the first of them.
  std::uint64_t round(std::vector<Swap>& swaps) const {
    std::uint64_t out = 0;
    const auto enters = [&](std::uint64_t place) {
      swaps.push_back({.leaves = out, .enters = at(place)});
      out = at(place);
    };
    for (std::uint64_t j = 0; j < role_.size(); ++j) {
      const auto visit = [&] {
        if (role(j + half_) == Role::only) {
          enters(j + half_);
        }
      };
      // The element of place j comes to stay, and that of place j−K need not stay.
      const auto come = [&] {
        enters(j);
        out = at(back(j));
      };
      if (role(j) == Role::second) {
        visit();
      } else if (role(j) == Role::first && role(j + half_) == Role::only) {
        visit();
        swaps.push_back({.leaves = at(back(j)), .enters = at(j)});
      } else if (role(back(j)) == Role::second) {
        come();
        visit();
      } else {
        visit();
        come();
      }
    }
    return out;
  }

  std::uint64_t big_;   // K
  std::uint64_t half_;  // M
  std::vector<Role> role_;
  std::vector<Element> name_;  // of the element, by place
};

constexpr Description description{
    .name = "two-places",
    .summary = "elements come and visit on a cycle of 4k-2 places, and some have two of them",
    .preconditions = "circular, m = 1, k >= 4, 3k-2 <= v <= (10k-5)/3",
    .guarantee = "b = 3v-4k+2",
    .place = "docs/theorems.md, Theorem 22",
};

class TwoPlaces final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    if (!asks_for_pairs(p, 1) || p.kind != Kind::circular || p.k < 4 || p.v + 2 < 3 * p.k ||
        3 * p.v + 5 > 10 * p.k) {
      return std::nullopt;
    }
    return Promise{.b = 3 * p.v - 4 * p.k + 2};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    return std::make_unique<SwapSource>(p, 3 * p.v - 4 * p.k + 2,
                                        std::make_unique<Places>(p.k, 4 * p.k - 2 - p.v));
  }

  std::string explanation(const Parameters& p) const override {
    return fmt::format(
        "On a cycle of {} places elements come, stay for {} places and visit the opposite one; {} "
        "of the {} elements have two places, stay twice as long and visit none.",
        4 * p.k - 2, p.k - 1, 4 * p.k - 2 - p.v, p.v);
  }
};

}  // namespace

const Construction& construction() { return only<TwoPlaces>(); }

}  // namespace changeover::two_places_entry
