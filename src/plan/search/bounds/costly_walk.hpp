// How often some parts come at least, if all others come for nothing: docs/theorems.md, Theorem 28.
//
// The others of a group are a single part that is always at hand: it is with what is there while
// the group has a free place. So what is there of the chosen parts, and which pairs have been
// together, is all that counts. All ways are looked through, by how often chosen parts have come.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "changeover/plan/job.hpp"
#include "core/bit_number.hpp"
#include "plan/search/bounds/job_numbers.hpp"
#include "plan/search/bounds/step_groups.hpp"

namespace changeover {

class CostlyWalk {
 public:
  static constexpr std::size_t most_parts = 16;
  static constexpr std::size_t most_pairs = 128;
  static constexpr std::size_t most_groups = 8;

  CostlyWalk() = default;
  /// A walk of the parts with these numbers in JobNumbers::parts; at_start is by these numbers.
  CostlyWalk(const Job& job, const JobNumbers& n, const StepGroups& groups,
             const std::vector<std::uint64_t>& at_start, std::vector<std::size_t> chosen);

  /// Whether there are few enough parts and pairs.
  [[nodiscard]] bool fits() const { return fits_; }

  /// Whether it is proved that the parts come more than `times` times in all, those at the start
  /// not counted. Each state that is looked at takes one from `states`; false if none is left.
  /// Stopped if the scope of this thread (run/control.hpp) requests it.
  [[nodiscard]] bool comes_more_than(std::uint64_t times, std::uint64_t& states) const;

 private:
  using Parts = std::uint32_t;  // a bit each
  struct Pairs {
    std::array<std::uint64_t, most_pairs / 64> words{};
    friend bool operator==(const Pairs&, const Pairs&) = default;
    [[nodiscard]] bool has(std::size_t pair) const {
      return (words[pair / 64] >> pair % 64 & 1U) != 0;
    }
    void insert(std::size_t pair) { words[pair / 64] |= std::uint64_t{1} << pair % 64; }
  };
  [[nodiscard]] static std::uint64_t common(const Pairs& a, const Pairs& b) {
    std::uint64_t all = 0;
    for (std::size_t word = 0; word < a.words.size(); ++word) {
      all += number_of_bits(a.words[word] & b.words[word]);
    }
    return all;
  }
  struct State {
    Parts there = 0;
    Pairs met;  // among the pairs of the walk
    friend bool operator==(const State&, const State&) = default;
  };
  struct Hash {
    std::size_t operator()(const State& state) const;
  };
  struct Group {
    Parts parts = 0;
    std::uint64_t places = 0;
    bool whole = false;  // of all parts, beside others
  };
  // A pair of two chosen parts, or of one and the others of a group.
  struct Pair {
    Parts parts = 0;
    std::size_t others = 0;  // the group; groups_.size() if there are two parts
  };

  [[nodiscard]] bool allowed(Parts there) const;
  // Adds those of these pairs that meet now.
  void meet(State& state, const Pairs& among) const;
  // Whether it is not excluded that all meet if parts come only so often from here.
  [[nodiscard]] bool can_end(const State& state, std::uint64_t times) const;
  // A part that has met none, and another one before it that is like it and has met none.
  [[nodiscard]] bool is_like_earlier(const State& state, std::size_t x) const;
  [[nodiscard]] bool alike(std::size_t x, std::size_t y) const;

  std::size_t v_ = 0;
  bool fits_ = true;
  Parts start_ = 0;
  std::vector<Group> groups_;
  std::vector<Parts> never_;  // by part
  std::vector<Pair> pairs_;
  Pairs all_;
  Pairs with_others_;                        // those of one part and the others of a group
  std::vector<std::vector<Pairs>> between_;  // by two groups, the later one first
  std::vector<Pairs> of_part_;
  std::vector<Parts> like_;  // by part: those before it that are like it
};

}  // namespace changeover
