// Makes of a double-change design one with more parts, which is what concatenation with groups
// wants (docs/theorems.md, Theorem 15); docs/tools/find_parts.sh compiles and runs it.
//
//     find_parts V K KIND PLACE PARTS [TRIES] [SEED] < DESIGN > NEW_DESIGN
//
// DESIGN is as `changeover design --format text` writes it. *Parts* are disjoint unchanged subsets
// of k−2 elements, disjoint from a *hinge* as well: another unchanged subset (PLACE is "step") or
// k−2 elements of the last block of a linear design ("end"; it may be read backwards).
//
// *A try* takes as many parts as a walk finds, locks them and the hinge where they are, and puts
// one more, of elements that are left, into two neighbouring blocks by exchanges that keep all
// steps. Pairs that are then uncovered are annealed away: a move exchanges two elements in a
// stretch of blocks in which one of them is and the other is not. What comes out is verified here
// and again by the program that reads it. Results depend on the design, the numbers and the seed
// alone.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace find_parts {
namespace {

using Set = std::vector<int>;

constexpr long moves_a_try = 1'500'000;
constexpr double hot = 0.32;  // in uncovered pairs
constexpr double cold = 0.17;
constexpr long piece = 1000;   // moves at one temperature
constexpr long walk = 20'000;  // steps for each element
constexpr int change = 2;

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(0x9E3779B97F4A7C15U * (seed + 1)) {
    for (int i = 0; i < 20; ++i) {
      next();
    }
  }
  int below(std::size_t limit) { return static_cast<int>(((next() >> 32U) * limit) >> 32U); }
  double unit() { return static_cast<double>(next() >> 11U) * 0x1p-53; }
  template <typename Range>
  void shuffle(Range& range) {
    for (std::size_t i = range.size(); i > 1; --i) {
      std::swap(range[i - 1], range[static_cast<std::size_t>(below(i))]);
    }
  }

 private:
  std::uint64_t next() {
    state_ ^= state_ << 13U;
    state_ ^= state_ >> 7U;
    return state_ ^= state_ << 17U;
  }
  std::uint64_t state_;
};

struct List {
  int v = 0, k = 0;
  bool circular = false;
  std::vector<Set> blocks;

  [[nodiscard]] std::size_t b() const { return blocks.size(); }
  [[nodiscard]] std::size_t steps() const { return circular ? b() : b() - 1; }
};

Set sorted(Set set) {
  std::ranges::sort(set);
  return set;
}

Set common(const Set& one, const Set& other) {
  Set both;
  std::ranges::set_intersection(sorted(one), sorted(other), std::back_inserter(both));
  return both;
}

bool is_design(const List& list) {
  std::vector<bool> met(static_cast<std::size_t>(list.v * list.v));
  for (std::size_t i = 0; i < list.b(); ++i) {
    const Set block = sorted(list.blocks[i]);
    const bool fits = block.size() == static_cast<std::size_t>(list.k) && block.front() >= 0 &&
                      block.back() < list.v && std::ranges::adjacent_find(block) == block.end();
    if (!fits || (i < list.steps() &&
                  common(block, list.blocks[(i + 1) % list.b()]).size() != block.size() - change)) {
      return false;
    }
    for (const int x : block) {
      for (const int y : block) {
        met[static_cast<std::size_t>(x * list.v + y)] = true;
      }
    }
  }
  return std::ranges::find(met, false) == met.end();
}

/// The unchanged subsets of a design, each with one of its steps.
class Unchanged {
 public:
  Unchanged(const List& list, Dice& dice) : v_(list.v), with_(static_cast<std::size_t>(list.v)) {
    std::map<Set, std::size_t> known;
    for (std::size_t i = 0; i < list.steps(); ++i) {
      const Set set = common(list.blocks[i], list.blocks[(i + 1) % list.b()]);
      const auto [at, is_new] = known.try_emplace(set, sets.size());
      if (is_new) {
        for (const int x : set) {
          with_[static_cast<std::size_t>(x)].push_back(static_cast<int>(sets.size()));
        }
        sets.push_back(set);
        step_of.push_back(i);
      } else if (dice.below(2) == 0) {
        step_of[at->second] = i;
      }
    }
  }

  /// Numbers of as many as are found that meet neither each other nor the hinge, at most `most`.
  std::vector<int> disjoint(const Set& hinge, std::size_t most, Dice& dice) const {
    constexpr int none = -1;
    constexpr int never = -2;
    std::vector<int> holder(static_cast<std::size_t>(v_), none);
    for (const int x : hinge) {
      holder[static_cast<std::size_t>(x)] = never;
    }
    std::vector<long> back(sets.size(), 0);
    std::vector<int> best;
    std::size_t size = 0;
    for (long step = 0; step < walk * v_ && best.size() < most; ++step) {
      const auto x = static_cast<std::size_t>(dice.below(holder.size()));
      if (holder[x] != none || with_[x].empty()) {
        continue;
      }
      const int come = with_[x][static_cast<std::size_t>(dice.below(with_[x].size()))];
      const Set& set = sets[static_cast<std::size_t>(come)];
      int gone = none;
      bool fits = back[static_cast<std::size_t>(come)] <= step;
      for (const int y : set) {
        const int other = holder[static_cast<std::size_t>(y)];
        fits = fits && other != never && (other == none || gone == none || other == gone);
        gone = other == none ? gone : other;
      }
      if (!fits) {
        continue;
      }
      if (gone != none) {
        for (const int y : sets[static_cast<std::size_t>(gone)]) {
          holder[static_cast<std::size_t>(y)] = none;
        }
        back[static_cast<std::size_t>(gone)] = step + 10 + dice.below(20);
        --size;
      }
      for (const int y : set) {
        holder[static_cast<std::size_t>(y)] = come;
      }
      if (++size > best.size()) {
        best.clear();
        std::ranges::copy_if(holder, std::back_inserter(best), [](int i) { return i >= 0; });
        std::ranges::sort(best);
        best.erase(std::ranges::unique(best).begin(), best.end());
      }
    }
    return best;
  }

  std::vector<Set> sets;
  std::vector<std::size_t> step_of;

 private:
  int v_;
  std::vector<std::vector<int>> with_;  // by element
};

/// A list whose steps change two elements each, with how often each pair is in a block.
class Annealing {
 public:
  Annealing(List list, Dice& dice) : list_(std::move(list)), dice_(dice) {
    const auto v = static_cast<std::size_t>(list_.v);
    in_.assign(list_.b(), std::vector<char>(v, 0));
    locked_ = in_;
    times_.assign(v, std::vector<int>(v, 0));
    place_.assign(v, std::vector<int>(v, -1));
    for (std::size_t i = 0; i < list_.b(); ++i) {
      for (const int x : list_.blocks[i]) {
        in_[i][at(x)] = 1;
        for (const int y : list_.blocks[i]) {
          times_[at(x)][at(y)] += x == y ? 0 : 1;
        }
      }
    }
    for (int x = 0; x < list_.v; ++x) {
      for (int y = x + 1; y < list_.v; ++y) {
        if (times_[at(x)][at(y)] == 0) {
          add_uncovered(x, y);
        }
      }
    }
  }

  [[nodiscard]] const List& list() const { return list_; }
  [[nodiscard]] bool has(std::size_t block, int x) const { return in_[block][at(x)] != 0; }
  void lock(std::size_t block, int x) { locked_[block][at(x)] = 1; }

  /// Brings the elements of the set into the block and locks them; false if none of some tries did.
  bool bring(std::size_t block, const Set& set) {
    for (const int y : set) {
      for (int i = 0; i < 60 && !has(block, y); ++i) {
        const int x = any_of(block);
        const auto stretch = free_stretch(block, x, y);
        if (std::ranges::find(set, x) == set.end() && stretch) {
          exchange(x, y, *stretch);
        }
      }
      if (!has(block, y)) {
        return false;
      }
      lock(block, y);
    }
    return true;
  }

  bool run(long moves) {
    const double slower =
        std::pow(cold / hot, static_cast<double>(piece) / static_cast<double>(moves));
    double heat = hot;
    for (long done = 0; done < moves && !uncovered_.empty(); ++done) {
      heat *= done % piece == 0 ? slower : 1;
      if (const auto move = drawn()) {
        const auto [block, x, y] = *move;
        if (const auto stretch = free_stretch(block, x, y)) {
          const std::size_t before = uncovered_.size();
          exchange(x, y, *stretch);
          const double worse = static_cast<double>(uncovered_.size()) - static_cast<double>(before);
          if (worse > 0 && dice_.unit() >= std::exp(-worse / heat)) {
            exchange(x, y, *stretch);
          }
        }
      }
    }
    return uncovered_.empty();
  }

 private:
  struct Move {
    std::size_t block;
    int x, y;  // in it, and not in it
  };
  struct Stretch {
    std::size_t from, length;
  };

  static std::size_t at(int x) { return static_cast<std::size_t>(x); }
  int any_of(std::size_t block) {
    const Set& set = list_.blocks[block];
    return set[at(dice_.below(set.size()))];
  }

  // Every other one would cover a pair.
  std::optional<Move> drawn() {
    if (dice_.below(2) == 0) {
      const std::size_t block = at(dice_.below(list_.b()));
      const int y = dice_.below(at(list_.v));
      return has(block, y) ? std::nullopt : std::optional(Move{block, any_of(block), y});
    }
    auto [stays, comes] = uncovered_[at(dice_.below(uncovered_.size()))];
    if (dice_.below(2) == 0) {
      std::swap(stays, comes);
    }
    for (int i = 0; i < 50; ++i) {
      const std::size_t block = at(dice_.below(list_.b()));
      if (has(block, stays)) {
        const int goes = any_of(block);
        return goes == stays ? std::nullopt : std::optional(Move{block, goes, comes});
      }
    }
    return std::nullopt;
  }

  // The blocks around this one that hold just one of x and y; nullopt if too many or locked.
  std::optional<Stretch> free_stretch(std::size_t block, int x, int y) const {
    const std::size_t b = list_.b();
    const auto most = std::min(b - 1, static_cast<std::size_t>(4 * list_.k + 20));
    const auto differ = [&](std::size_t i) { return has(i, x) != has(i, y); };
    Stretch found{block, 1};
    while (list_.circular || found.from > 0) {
      const std::size_t before = (found.from + b - 1) % b;
      if (!differ(before)) {
        break;
      }
      found.from = before;
      if (++found.length > most) {
        return std::nullopt;
      }
    }
    while (list_.circular || found.from + found.length < b) {
      if (!differ((found.from + found.length) % b)) {
        break;
      }
      if (++found.length > most) {
        return std::nullopt;
      }
    }
    for (std::size_t i = 0; i < found.length; ++i) {
      const std::size_t each = (found.from + i) % b;
      if (locked_[each][at(has(each, x) ? x : y)] != 0) {
        return std::nullopt;
      }
    }
    return found;
  }

  void exchange(int x, int y, const Stretch& stretch) {
    for (std::size_t i = 0; i < stretch.length; ++i) {
      const std::size_t block = (stretch.from + i) % list_.b();
      has(block, x) ? replace(block, x, y) : replace(block, y, x);
    }
  }

  void replace(std::size_t block, int goes, int comes) {
    Set& set = list_.blocks[block];
    for (int& z : set) {
      if (z == goes) {
        z = comes;
        continue;
      }
      times_[at(z)][at(goes)] = --times_[at(goes)][at(z)];
      if (times_[at(z)][at(goes)] == 0) {
        add_uncovered(goes, z);
      }
      if (times_[at(z)][at(comes)] == 0) {
        remove_uncovered(comes, z);
      }
      times_[at(z)][at(comes)] = ++times_[at(comes)][at(z)];
    }
    in_[block][at(goes)] = 0;
    in_[block][at(comes)] = 1;
  }

  void add_uncovered(int x, int y) {
    place_[at(std::min(x, y))][at(std::max(x, y))] = static_cast<int>(uncovered_.size());
    uncovered_.emplace_back(x, y);
  }

  void remove_uncovered(int x, int y) {
    const int place = place_[at(std::min(x, y))][at(std::max(x, y))];
    const auto last = uncovered_.back();
    uncovered_[at(place)] = last;
    place_[at(std::min(last.first, last.second))][at(std::max(last.first, last.second))] = place;
    uncovered_.pop_back();
  }

  List list_;
  Dice& dice_;
  std::vector<std::vector<char>> in_, locked_;  // by block and element
  std::vector<std::vector<int>> times_, place_;
  std::vector<std::pair<int, int>> uncovered_;
};

// One try; nullopt if it came to nothing. `have`: how many parts there are.
std::optional<List> with_one_more(const List& list, const Unchanged& unchanged,
                                  const std::vector<int>& parts, const Set& hinge, Dice& dice) {
  Annealing annealing(list, dice);
  std::vector<bool> used(static_cast<std::size_t>(list.v));
  std::vector<bool> taken(list.b());
  const auto lock = [&](std::size_t block, const Set& set) {
    for (const int x : set) {
      annealing.lock(block, x);
      used[static_cast<std::size_t>(x)] = true;
    }
    taken[block] = true;
  };
  if (!hinge.empty()) {
    lock(list.b() - 1, hinge);
  }
  for (const int i : parts) {
    const std::size_t step = unchanged.step_of[static_cast<std::size_t>(i)];
    lock(step, unchanged.sets[static_cast<std::size_t>(i)]);
    lock((step + 1) % list.b(), unchanged.sets[static_cast<std::size_t>(i)]);
  }
  Set more;
  for (int x = 0; x < list.v; ++x) {
    if (!used[static_cast<std::size_t>(x)]) {
      more.push_back(x);
    }
  }
  const auto size = static_cast<std::size_t>(list.k - change);
  if (more.size() < size) {
    return std::nullopt;
  }
  dice.shuffle(more);
  more.resize(size);
  // Where some of them are already, if possible.
  std::optional<std::size_t> place;
  int most = -1;
  for (int i = 0; i < 30; ++i) {
    const auto step = static_cast<std::size_t>(dice.below(list.steps()));
    const std::size_t next = (step + 1) % list.b();
    if (taken[step] || taken[next]) {
      continue;
    }
    int there = dice.below(6);
    for (const int x : more) {
      there += 4 * (annealing.has(step, x) ? 1 : 0) + 4 * (annealing.has(next, x) ? 1 : 0);
    }
    if (there > most) {
      most = there;
      place = step;
    }
  }
  if (!place || !annealing.bring(*place, more) || !annealing.bring((*place + 1) % list.b(), more) ||
      !annealing.run(moves_a_try)) {
    return std::nullopt;
  }
  return annealing.list();
}

std::optional<List> searched(List list, bool at_end, std::size_t wanted, int tries, Dice& dice) {
  const std::size_t needed = wanted + (at_end ? 0 : 1);  // sets; at a step one is the hinge
  std::size_t most = 0;
  for (int i = 0; i < tries; ++i) {
    if (at_end && dice.below(2) == 0) {
      std::ranges::reverse(list.blocks);
    }
    Set hinge;
    if (at_end) {
      hinge = list.blocks.back();
      dice.shuffle(hinge);
      hinge.resize(static_cast<std::size_t>(list.k - change));
    }
    const Unchanged unchanged(list, dice);
    const std::vector<int> parts = unchanged.disjoint(hinge, needed, dice);
    if (parts.size() >= needed) {
      return list;
    }
    if (parts.size() > most) {
      most = parts.size();
      std::cerr << most - (at_end ? 0 : 1) << " parts\n";
    }
    if (auto better = with_one_more(list, unchanged, parts, hinge, dice)) {
      list = *std::move(better);
    }
  }
  return std::nullopt;
}

List read(std::istream& in, int v, int k, bool circular) {
  List list{v, k, circular, {}};
  std::map<std::string, int> numbers;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') {
      continue;
    }
    std::istringstream words(line);
    Set block;
    for (std::string word; words >> word;) {
      block.push_back(numbers.try_emplace(word, static_cast<int>(numbers.size())).first->second);
    }
    list.blocks.push_back(std::move(block));
  }
  return list;
}

void write(const List& list, const std::string& command) {
  const char* kind = list.circular ? "circular" : "linear";
  std::cout << "# changeover design v=" << list.v << " k=" << list.k << " change=" << change
            << " kind=" << kind << "\n# recipe: {\"construction\":\"literal\",\"v\":" << list.v
            << ",\"k\":" << list.k << ",\"change\":" << change << ",\"kind\":\"" << kind
            << "\",\"arguments\":{},\"inputs\":[],\"blocks\":[";
  const auto each = [&](const char* open, const char* between, const char* close,
                        const char* next) {
    for (std::size_t i = 0; i < list.b(); ++i) {
      std::cout << open;
      const Set block = sorted(list.blocks[i]);
      for (std::size_t j = 0; j < block.size(); ++j) {
        std::cout << (j == 0 ? "" : between) << block[j];
      }
      std::cout << close << (i + 1 < list.b() ? next : "");
    }
  };
  each("[", ",", "]", ",");
  std::cout << "],\"provenance\":\"" << command << "\"}\n";
  each("", " ", "\n", "");
}

int run(int count, char** words) {
  if (count < 6) {
    std::cerr << "usage: find_parts V K linear|circular step|end PARTS [TRIES] [SEED] < DESIGN\n";
    return 2;
  }
  const auto number = [&](int i, int otherwise) {
    return i < count ? std::atoi(words[i]) : otherwise;
  };
  const bool circular = std::string(words[3]) == "circular";
  const bool at_end = std::string(words[4]) == "end";
  const List list = read(std::cin, number(1, 0), number(2, 0), circular);
  if ((circular && at_end) || list.b() < 6 || list.k <= change || !is_design(list)) {
    std::cerr << "find_parts: that is no double-change design, or has no such place\n";
    return 3;
  }
  Dice dice(static_cast<std::uint64_t>(number(7, 1)));
  const auto found =
      searched(list, at_end, static_cast<std::size_t>(number(5, 0)), number(6, 200), dice);
  if (!found || !is_design(*found)) {
    std::cerr << "not found\n";
    return 1;
  }
  std::string command = "docs/tools/find_parts.sh";
  for (int i = 1; i < count; ++i) {
    command += std::string(" ") + words[i];
  }
  write(*found, command);
  return 0;
}

}  // namespace
}  // namespace find_parts

int main(int count, char** words) { return find_parts::run(count, words); }
