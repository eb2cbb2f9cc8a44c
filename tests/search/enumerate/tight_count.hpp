// Counts tight single-change designs in another way than the library: each introduction covers k−1
// pairs that no other introduction covers, and that is all it looks at.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "changeover/core/parameters.hpp"

namespace changeover::test {

// Standard forms: the first block is 0 … k−1, other elements enter in the order of their names, and
// of elements of the first block that never left the lowest leaves first.
class TightCount {
 public:
  TightCount(int v, int k, Kind kind)
      : v_(v), k_(k), circular_(kind == Kind::circular), names_(k), first_((Set{1} << k) - 1) {
    const int pairs = v * (v - 1) / 2 - (circular_ ? 0 : k * (k - 1) / 2);
    divides_ = pairs % (k - 1) == 0;
    b_ = pairs / (k - 1) + (circular_ ? 0 : 1);
    never_left_ = first_;
    for (int x = 0; x < k && !circular_; ++x) {
      met_[at(x)] = first_ & ~one(x);
    }
  }

  [[nodiscard]] int blocks() const { return b_; }

  std::uint64_t forms() {
    if (divides_) {
      go_on(first_, 1);
    }
    return forms_;
  }

 private:
  using Set = std::uint32_t;

  static Set one(int x) { return Set{1} << x; }
  static std::size_t at(int x) { return static_cast<std::size_t>(x); }

  void go_on(Set block, int blocks) {
    if (blocks == b_) {
      forms_ += !circular_ || closes(block) ? 1U : 0U;
      return;
    }
    bool tried = false;
    for (int out = 0; out < names_; ++out) {
      if ((block & ~stays_ & one(out)) == 0) {
        continue;
      }
      const bool is_twin = (never_left_ & one(out)) != 0;
      if (is_twin && tried) {
        continue;
      }
      tried = tried || is_twin;
      // It comes back k−1 pairs at a time.
      const int misses = v_ - 1 - std::popcount(met_[at(out)]);
      if (misses > 0 && misses < k_ - 1) {
        continue;
      }
      const Set rest = block & ~one(out);
      never_left_ &= rest;
      for (int in = 0; in < std::min(v_, names_ + 1); ++in) {
        if ((block & one(in)) == 0 && (met_[at(in)] & rest) == 0) {
          enter(rest, in, blocks);
        }
      }
      never_left_ |= is_twin ? one(out) : 0;
    }
  }

  void enter(Set rest, int in, int blocks) {
    const int names = names_;
    const Set stays = stays_;
    // Pairs of the first block that meet again stay together until it comes again.
    const Set again = circular_ && (first_ & one(in)) != 0 ? rest & first_ : 0;
    stays_ |= again == 0 ? 0 : again | one(in);
    names_ = std::max(names_, in + 1);
    meet(rest, in);
    if (v_ - names_ <= b_ - blocks - 1) {
      go_on(rest | one(in), blocks + 1);
    }
    meet(rest, in);
    names_ = names;
    stays_ = stays;
  }

  // They have met, or, said again, have not.
  void meet(Set rest, int in) {
    met_[at(in)] ^= rest;
    for (int x = 0; x < names_; ++x) {
      met_[at(x)] ^= (rest & one(x)) != 0 ? one(in) : 0;
    }
  }

  // From the last block to the first one element enters, and all pairs of the first have met then.
  [[nodiscard]] bool closes(Set block) const {
    const Set enters = first_ & ~block;
    const Set kept = first_ & block;
    if (std::popcount(enters) != 1) {
      return false;
    }
    for (int x = 0; x < k_; ++x) {
      const Set expected = (enters & one(x)) != 0 ? 0 : kept & ~one(x);
      if ((met_[at(x)] & first_) != expected) {
        return false;
      }
    }
    return true;
  }

  int v_;
  int k_;
  bool circular_;
  bool divides_ = false;
  int b_ = 0;
  int names_;  // elements that have been in a block
  Set first_;
  Set never_left_ = 0;
  Set stays_ = 0;
  std::array<Set, 32> met_{};
  std::uint64_t forms_ = 0;
};

}  // namespace changeover::test
