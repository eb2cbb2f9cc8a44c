#include "plan/search/bounds/costly_walk.hpp"

#include <algorithm>
#include <bit>
#include <unordered_set>

#include "changeover/run/control.hpp"
#include "core/bit_number.hpp"
#include "core/checked.hpp"
#include "plan/job/pair_numbers.hpp"

namespace changeover {
namespace {

std::uint64_t count(std::uint32_t parts) { return number_of_bits(parts); }

// The least sum of numbers e_a, none below least[a], with across[a][b]·e_a + across[b][a]·e_b no
// less than open[a][b].
class LeastComing {
 public:
  explicit LeastComing(std::size_t groups) : n_(groups) {}

  void at_least(std::size_t a, std::uint64_t number) { least_[a] = number; }
  void together(std::size_t a, std::size_t b, std::uint64_t of_a, std::uint64_t of_b,
                std::uint64_t open) {
    across_[a][b] = of_a;
    across_[b][a] = of_b;
    open_[a][b] = open_[b][a] = open;
  }

  // Whether the sum is at most that.
  [[nodiscard]] bool fits(std::uint64_t most) {
    std::uint64_t sum = 0;
    for (std::size_t a = 0; a < n_; ++a) {
      sum += least_[a];
    }
    return sum <= most && look(0, most - sum);
  }

 private:
  // With so many left for what is more than the least.
  bool look(std::size_t a, std::uint64_t left) {
    if (a == n_) {
      return true;
    }
    std::uint64_t from = least_[a];
    for (std::size_t b = 0; b < a; ++b) {
      from = std::max(from, alone(a, b, taken_[b]));
    }
    std::uint64_t to = from;  // More than that helps no other group.
    for (std::size_t b = a + 1; b < n_; ++b) {
      to = std::max(to, alone(a, b, least_[b]));
    }
    for (std::uint64_t e = from; e <= std::min(to, least_[a] + left); ++e) {
      taken_[a] = e;
      if (look(a + 1, left - (e - least_[a]))) {
        return true;
      }
    }
    return false;
  }

  // What a must come, if b comes so often.
  [[nodiscard]] std::uint64_t alone(std::size_t a, std::size_t b, std::uint64_t of_b) const {
    const std::uint64_t met = across_[b][a] * of_b;
    return open_[a][b] <= met ? 0 : ceil_div(open_[a][b] - met, across_[a][b]);
  }

  template <typename T>
  using Table = std::array<std::array<T, CostlyWalk::most_groups>, CostlyWalk::most_groups>;

  std::size_t n_;
  std::array<std::uint64_t, CostlyWalk::most_groups> least_{};
  Table<std::uint64_t> across_{};
  Table<std::uint64_t> open_{};
  std::array<std::uint64_t, CostlyWalk::most_groups> taken_{};
};

}  // namespace

std::size_t CostlyWalk::Hash::operator()(const State& state) const {
  std::uint64_t mixed = state.there;
  for (const std::uint64_t word : state.met.words) {
    mixed = (mixed ^ word) * 0x9E3779B97F4A7C15U;
    mixed ^= mixed >> 29U;
  }
  return static_cast<std::size_t>(mixed * 0xBF58476D1CE4E5B9U >> 7U);
}

CostlyWalk::CostlyWalk(const Job& job, const JobNumbers& n, const StepGroups& groups,
                       const std::vector<std::uint64_t>& at_start, std::vector<std::size_t> chosen)
    : v_(chosen.size()), fits_(v_ <= most_parts) {
  if (!fits_) {
    return;
  }
  never_.assign(v_, 0);
  for (std::size_t x = 0; x < v_; ++x) {
    start_ |= at_start[chosen[x]] > 0 ? Parts{1} << x : 0;
    for (std::size_t y = 0; y < v_; ++y) {
      const bool apart = x != y && job.never.contains(n.parts[chosen[x]], n.parts[chosen[y]]);
      never_[x] |= apart ? Parts{1} << y : 0;
      if (x < y && groups.needed(chosen[x], chosen[y])) {
        pairs_.push_back({Parts{1} << x | Parts{1} << y, groups.groups().size()});
      }
    }
  }
  const std::size_t all = n.parts.size();
  for (const PartGroup& each : groups.groups()) {
    Group group{.places = each.in_a_test,
                .whole = each.parts.size() == all && groups.groups().size() > 1};
    for (std::size_t x = 0; x < v_; ++x) {
      const auto found = std::find(each.parts.begin(), each.parts.end(), chosen[x]);
      group.parts |= found != each.parts.end() ? Parts{1} << x : 0;
      const bool meets_others = std::any_of(each.parts.begin(), each.parts.end(), [&](auto y) {
        return groups.needed(chosen[x], y) &&
               std::find(chosen.begin(), chosen.end(), y) == chosen.end();
      });
      if (!group.whole && meets_others) {
        pairs_.push_back({Parts{1} << x, groups_.size()});
      }
    }
    groups_.push_back(group);
  }
  fits_ = pairs_.size() <= most_pairs && groups_.size() <= most_groups;
  if (!fits_) {
    return;
  }
  between_.assign(groups_.size(), std::vector<Pairs>(groups_.size()));
  for (std::size_t pair = 0; pair < pairs_.size(); ++pair) {
    all_.insert(pair);
    if (pairs_[pair].others < groups_.size()) {
      with_others_.insert(pair);
    }
    for (std::size_t a = 0; a < groups_.size(); ++a) {
      for (std::size_t b = 0; b <= a && pairs_[pair].others == groups_.size(); ++b) {
        const Parts of_a = pairs_[pair].parts & groups_[a].parts;
        const Parts of_b = pairs_[pair].parts & groups_[b].parts;
        if (a == b ? count(of_a) == 2 : count(of_a) == 1 && count(of_b) == 1 && of_a != of_b) {
          between_[a][b].insert(pair);
        }
      }
    }
  }
  of_part_.resize(v_);
  for (std::size_t pair = 0; pair < pairs_.size(); ++pair) {
    for (std::size_t x = 0; x < v_; ++x) {
      if ((pairs_[pair].parts >> x & 1U) != 0) {
        of_part_[x].insert(pair);
      }
    }
  }
  like_.assign(v_, 0);
  for (std::size_t x = 0; x < v_; ++x) {
    for (std::size_t y = 0; y < x; ++y) {
      like_[x] |= alike(x, y) ? Parts{1} << y : 0;
    }
  }
}

bool CostlyWalk::alike(std::size_t x, std::size_t y) const {
  const Parts two = Parts{1} << x | Parts{1} << y;
  const auto exchanged = [&](Parts parts) { return count(parts & two) == 1 ? parts ^ two : parts; };
  const bool same_groups = std::all_of(groups_.begin(), groups_.end(), [&](const Group& group) {
    return count(group.parts & two) != 1;
  });
  if (!same_groups || (start_ & two) != 0 || (never_[x] & ~two) != (never_[y] & ~two)) {
    return false;
  }
  return std::all_of(pairs_.begin(), pairs_.end(), [&](const Pair& pair) {
    return std::any_of(pairs_.begin(), pairs_.end(), [&](const Pair& other) {
      return other.others == pair.others && other.parts == exchanged(pair.parts);
    });
  });
}

bool CostlyWalk::allowed(Parts there) const {
  for (std::size_t x = 0; x < v_; ++x) {
    if ((there >> x & 1U) != 0 && (never_[x] & there) != 0) {
      return false;
    }
  }
  return std::all_of(groups_.begin(), groups_.end(), [&](const Group& group) {
    return count(group.parts & there) <= group.places;
  });
}

void CostlyWalk::meet(State& state, const Pairs& among) const {
  const bool room = std::all_of(groups_.begin(), groups_.end(), [&](const Group& group) {
    return !group.whole || count(group.parts & state.there) < group.places;
  });
  for (std::size_t word = 0; word < among.words.size(); ++word) {
    for (std::uint64_t rest = among.words[word] & ~state.met.words[word]; rest != 0;
         rest &= rest - 1) {
      const std::size_t pair = word * 64 + static_cast<std::size_t>(std::countr_zero(rest));
      const Pair& each = pairs_[pair];
      if ((each.parts & state.there) != each.parts) {
        continue;
      }
      const bool met =
          each.others == groups_.size() ||
          (room && count(groups_[each.others].parts & state.there) < groups_[each.others].places);
      if (met) {
        state.met.insert(pair);
      }
    }
  }
}

bool CostlyWalk::can_end(const State& state, std::uint64_t times) const {
  Parts missing = 0;  // They must come.
  Pairs left = all_;
  for (std::size_t word = 0; word < left.words.size(); ++word) {
    left.words[word] &= ~state.met.words[word];
    for (std::uint64_t rest = left.words[word]; rest != 0; rest &= rest - 1) {
      missing |= pairs_[word * 64 + static_cast<std::size_t>(std::countr_zero(rest))].parts;
    }
  }
  missing &= ~state.there;
  const Parts some = missing | state.there;
  LeastComing least(between_.size());
  std::uint64_t of_all = count(missing);
  std::array<std::uint64_t, most_groups> most{};
  std::array<std::uint64_t, most_groups> here{};
  for (std::size_t a = 0; a < groups_.size(); ++a) {
    here[a] = count(state.there & groups_[a].parts);
    most[a] = std::max(here[a], std::min(groups_[a].places, count(some & groups_[a].parts)));
    std::uint64_t comes = count(missing & groups_[a].parts);
    const std::uint64_t open = common(left, between_[a][a]);
    if (open > 0 && most[a] > 1) {
      const std::uint64_t all = open + choose_two(here[a]) + choose_two(most[a]);
      comes = std::max(comes, ceil_div(all - std::min(all, (most[a] - 1) * here[a]), most[a] - 1));
    }
    if (groups_[a].whole) {
      of_all = std::max(of_all, comes);
      continue;
    }
    least.at_least(a, comes);
    for (std::size_t b = 0; b < a; ++b) {
      const std::uint64_t apart = common(left, between_[a][b]);
      if (apart > 0) {
        least.together(a, b, most[b], most[a], apart + (most[a] - here[a]) * (most[b] - here[b]));
      }
    }
  }
  return of_all <= times && least.fits(times);
}

bool CostlyWalk::is_like_earlier(const State& state, std::size_t x) const {
  const auto is_new = [&](std::size_t y) {
    return (state.there >> y & 1U) == 0 && common(state.met, of_part_[y]) == 0;
  };
  if (like_[x] == 0 || !is_new(x)) {
    return false;
  }
  for (std::size_t y = 0; y < x; ++y) {
    if ((like_[x] >> y & 1U) != 0 && is_new(y)) {
      return true;
    }
  }
  return false;
}

bool CostlyWalk::comes_more_than(std::uint64_t times, std::uint64_t& states) const {
  std::unordered_set<State, Hash> known;
  std::vector<State> now{{start_, {}}};
  meet(now.front(), all_);
  known.insert(now.front());
  for (std::uint64_t come = 0; !now.empty(); ++come) {
    std::vector<State> next;
    std::unordered_set<State, Hash> known_next;
    for (std::size_t i = 0; i < now.size(); ++i) {
      stop_if_asked();
      const State state = now[i];
      if (state.met == all_ || states == 0) {
        return false;
      }
      --states;
      for (std::size_t x = 0; x < v_; ++x) {
        const bool goes = (state.there >> x & 1U) != 0;
        State other{state.there ^ Parts{1} << x, state.met};
        if (!goes && (!allowed(other.there) || is_like_earlier(state, x))) {
          continue;
        }
        // A part that comes takes room from others; one that goes makes some.
        meet(other, goes ? with_others_ : of_part_[x]);
        std::unordered_set<State, Hash>& seen = goes ? known : known_next;
        if (!seen.contains(other) && come + (goes ? 0 : 1) <= times &&
            can_end(other, times - come - (goes ? 0 : 1))) {
          seen.insert(other);
          (goes ? now : next).push_back(other);
        }
      }
    }
    now = std::move(next);
    known = std::move(known_next);
  }
  return true;
}

}  // namespace changeover
