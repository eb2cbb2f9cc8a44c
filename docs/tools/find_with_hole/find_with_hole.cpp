// Single-change lists of blocks found in two parts, the second with a hole (docs/theorems.md,
// Theorem 13); docs/tools/find_with_hole.sh compiles and runs it.
//
//     find_with_hole [open] K W NEW PARTS LACKING [SEED] [SECONDS] > DESIGN
//
// V is a list on W elements, in which PARTS disjoint unchanged subsets of K−1 elements hold all but
// the *hole*. P has the hole and NEW elements; K−1 elements U of the hole are in its first block
// and in V's last. P is looked for first: it meets LACKING pairs of the hole, which ones is its
// choice. V then covers all pairs of its elements but these. Both make a linear design or, with
// `open`, a list with open ends: U_1, K−1 more elements of the hole, are in V's first block, U_2,
// K−1 new ones, in P's last, and no pair of the one with the other is asked for.
//
// Each list is annealed: a move exchanges two elements in a stretch of blocks in which one of them
// is and the other is not, half of the moves are aimed at a pair that is uncovered. The unchanged
// subsets of V are at places drawn for each try, and no move touches them. An element has one bit
// for each block, so a list has at most 64. What comes out is verified here and again by the
// program that reads it. Results depend on the numbers and the seed, and on SECONDS only in when it
// gives up.
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

namespace find_with_hole {
namespace {

using Set = std::vector<int>;
using Blocks = std::vector<Set>;
using Pair = std::pair<int, int>;
using Random = std::mt19937_64;
using Clock = std::chrono::steady_clock;

constexpr std::uint64_t moves_of_v = 8'000'000;
constexpr std::uint64_t moves_of_p = 100'000'000;
constexpr int tries_of_v = 40;  // before another P is taken
constexpr double hot_v = 0.32;  // in uncovered pairs
constexpr double cold_v = 0.20;
constexpr double hot_p = 0.25;
constexpr double cold_p = 0.18;
constexpr std::uint64_t levels = 400;
constexpr int most_blocks = 64;
constexpr int gap = 5;  // blocks between two unchanged subsets, at least

int below(Random& random, std::size_t n) { return static_cast<int>((random() >> 32) * n >> 32); }

bool has(const Set& set, int x) { return std::ranges::find(set, x) != set.end(); }

/// What a list is asked for.
struct Wish {
  int k;
  int elements;
  int blocks;
  Set first = {};  ///< in the first block
  Set last = {};   ///< in the last one
  int parts = 0;   ///< unchanged subsets of k−1, of the elements from `of_parts` on
  int of_parts = 0;
  std::set<Pair> unwanted = {};  ///< pairs that need not meet; smaller element first
  std::set<Pair> welcome = {};   ///< such of them of which `enough` are to meet
  int enough = 0;
};

/// Blocks of k elements in which one changes at each step.
class List {
 public:
  explicit List(const Wish& wish) : wish_(wish) {
    for (int x = 0; x < wish.elements; ++x) {
      for (int y = 0; y < x; ++y) {
        const std::uint64_t wanted = wish.unwanted.contains({y, x}) ? 0 : ~std::uint64_t{0};
        const std::uint64_t welcome = wish.welcome.contains({y, x}) ? ~std::uint64_t{0} : 0;
        wanted_[x][y] = wanted_[y][x] = wanted;
        welcome_[x][y] = welcome_[y][x] = welcome;
      }
    }
  }

  /// The blocks if all that is asked for is there at the end.
  std::optional<Blocks> annealed(std::uint64_t moves, double hot, double cold, Random& random,
                                 Clock::time_point end) {
    while (!start(random)) {
      if (Clock::now() >= end) {
        return std::nullopt;
      }
    }
    double temperature = hot;
    for (std::uint64_t level = 0; level < levels && Clock::now() < end; ++level) {
      std::array<std::uint64_t, 16> accepted{};
      for (std::size_t i = 0; i < accepted.size(); ++i) {
        accepted[i] = static_cast<std::uint64_t>(std::exp(-static_cast<double>(i) / temperature) *
                                                 4294967295.0);
      }
      for (std::uint64_t i = 0; i < moves / levels; ++i) {
        if (uncovered_.empty() && met_ >= wish_.enough) {
          return blocks_;
        }
        move(random, accepted);
      }
      temperature *= std::pow(cold / hot, 1.0 / static_cast<double>(levels));
    }
    return std::nullopt;
  }

 private:
  /// Random blocks with what is locked; false if these places do not fit.
  bool start(Random& random) {
    std::vector<Set> locked(static_cast<std::size_t>(wish_.blocks));
    locked.front() = wish_.first;
    locked.back().insert(locked.back().end(), wish_.last.begin(), wish_.last.end());
    if (!place_parts(locked, random)) {
      return false;
    }
    rows_.fill(0);
    locks_.fill(0);
    blocks_.assign(1, locked.front());
    while (blocks_.front().size() < static_cast<std::size_t>(wish_.k)) {
      const int x = below(random, static_cast<std::size_t>(wish_.elements));
      if (!has(blocks_.front(), x)) {
        blocks_.front().push_back(x);
      }
    }
    for (std::size_t b = 1; b < locked.size(); ++b) {
      if (!step(locked, random)) {
        return false;
      }
    }
    for (std::size_t b = 0; b < locked.size(); ++b) {
      for (const int x : blocks_[b]) {
        rows_[static_cast<std::size_t>(x)] |= std::uint64_t{1} << b;
      }
      for (const int x : locked[b]) {
        locks_[static_cast<std::size_t>(x)] |= std::uint64_t{1} << b;
      }
    }
    find_uncovered();
    return true;
  }

  bool place_parts(std::vector<Set>& locked, Random& random) {
    const auto n = static_cast<std::size_t>(wish_.k - 1);
    Set of_parts;
    for (int x = wish_.of_parts; x < wish_.elements && wish_.parts > 0; ++x) {
      of_parts.push_back(x);
    }
    std::shuffle(of_parts.begin(), of_parts.end(), random);
    const int room = wish_.blocks - gap * (wish_.parts + 1);
    if (wish_.parts > 0 && room < 1) {
      return false;
    }
    Set places;
    for (int i = 0; i < wish_.parts; ++i) {
      places.push_back(below(random, static_cast<std::size_t>(room)));
    }
    std::ranges::sort(places);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto b = static_cast<std::size_t>(places[i]) + static_cast<std::size_t>(gap) * (i + 1);
      const auto part = std::span(of_parts).subspan(i * n, n);
      locked[b - 1].assign(part.begin(), part.end());
      locked[b].assign(part.begin(), part.end());
    }
    return true;
  }

  /// One block more, on the way to the next one that has locked elements.
  bool step(const std::vector<Set>& locked, Random& random) {
    const std::size_t b = blocks_.size();
    std::size_t goal = b;
    while (goal + 1 < locked.size() && locked[goal].empty()) {
      ++goal;
    }
    Set block = blocks_.back();
    Set lacking;
    for (const int x : locked[goal]) {
      if (!has(block, x)) {
        lacking.push_back(x);
      }
    }
    const std::size_t left = goal - b + 1;
    if (lacking.size() > left) {
      return false;
    }
    int in = 0;
    if (lacking.size() == left) {
      in = lacking[static_cast<std::size_t>(below(random, lacking.size()))];
    } else {
      do {
        in = below(random, static_cast<std::size_t>(wish_.elements));
      } while (has(block, in));
    }
    Set out;
    for (std::size_t i = 0; i < block.size(); ++i) {
      if (!has(locked[goal], block[i])) {
        out.push_back(static_cast<int>(i));
      }
    }
    if (out.empty()) {
      return false;
    }
    block[static_cast<std::size_t>(out[static_cast<std::size_t>(below(random, out.size()))])] = in;
    blocks_.push_back(block);
    return b < goal || std::ranges::all_of(locked[b], [&](int x) { return has(block, x); });
  }

  void find_uncovered() {
    uncovered_.clear();
    met_ = 0;
    for (int x = 0; x < wish_.elements; ++x) {
      for (int y = x + 1; y < wish_.elements; ++y) {
        const bool together = (rows_[x] & rows_[y]) != 0;
        met_ += together && welcome_[x][y] != 0 ? 1 : 0;
        if (wanted_[x][y] != 0 && !together) {
          uncovered_.emplace_back(x, y);
        }
      }
    }
  }

  void move(Random& random, const std::array<std::uint64_t, 16>& accepted) {
    int b = 0;
    int y = 0;
    int kept = -1;
    if (random() % 2 == 0 || uncovered_.empty()) {
      b = below(random, blocks_.size());
      y = below(random, static_cast<std::size_t>(wish_.elements));
    } else {
      std::tie(kept, y) = uncovered_[static_cast<std::size_t>(below(random, uncovered_.size()))];
      if (random() % 2 == 0) {
        std::swap(kept, y);
      }
      std::uint64_t with = rows_[kept];
      if (with == 0) {
        return;
      }
      for (int skip = below(random, static_cast<std::size_t>(std::popcount(with))); skip > 0;
           --skip) {
        with &= with - 1;
      }
      b = std::countr_zero(with);
    }
    const Set& block = blocks_[static_cast<std::size_t>(b)];
    const int x = block[static_cast<std::size_t>(below(random, block.size()))];
    if (x != kept && (rows_[y] >> b & 1) == 0) {
      exchange(x, y, b, random, accepted);
    }
  }

  void exchange(int x, int y, int b, Random& random,
                const std::array<std::uint64_t, 16>& accepted) {
    const std::uint64_t one_of_them = rows_[x] ^ rows_[y];
    const int first = std::max(0, b - std::countl_one(one_of_them << (most_blocks - 1 - b)) + 1);
    const int end =
        std::min(b + std::countr_one(one_of_them >> b), static_cast<int>(blocks_.size()));
    const std::uint64_t run =
        (end == most_blocks ? ~std::uint64_t{0} : (std::uint64_t{1} << end) - 1) &
        ~((std::uint64_t{1} << first) - 1);
    if ((((rows_[x] & locks_[x]) | (rows_[y] & locks_[y])) & run) != 0) {
      return;
    }
    const std::uint64_t old_x = std::exchange(rows_[x], 0);
    const std::uint64_t old_y = std::exchange(rows_[y], 0);
    const std::uint64_t new_x = old_x ^ run;
    const std::uint64_t new_y = old_y ^ run;
    std::int64_t lost = 0;
    std::int64_t more = 0;
    for (std::size_t z = 0; z < rows_.size(); ++z) {
      const std::uint64_t of_x = rows_[z] & wanted_[x][z];
      const std::uint64_t of_y = rows_[z] & wanted_[y][z];
      lost += static_cast<std::int64_t>((of_x & old_x) != 0) -
              static_cast<std::int64_t>((of_x & new_x) != 0);
      lost += static_cast<std::int64_t>((of_y & old_y) != 0) -
              static_cast<std::int64_t>((of_y & new_y) != 0);
    }
    if (wish_.enough > 0) {
      for (std::size_t z = 0; z < rows_.size(); ++z) {
        const std::uint64_t of_x = rows_[z] & welcome_[x][z];
        const std::uint64_t of_y = rows_[z] & welcome_[y][z];
        more += static_cast<std::int64_t>((of_x & new_x) != 0) -
                static_cast<std::int64_t>((of_x & old_x) != 0);
        more += static_cast<std::int64_t>((of_y & new_y) != 0) -
                static_cast<std::int64_t>((of_y & old_y) != 0);
      }
    }
    const int after = met_ + static_cast<int>(more);
    const int change = static_cast<int>(lost) + std::max(0, wish_.enough - after) -
                       std::max(0, wish_.enough - met_);
    const bool made = change <= 0 || (change < static_cast<int>(accepted.size()) &&
                                      random() >> 32 < accepted[static_cast<std::size_t>(change)]);
    rows_[x] = made ? new_x : old_x;
    rows_[y] = made ? new_y : old_y;
    if (!made) {
      return;
    }
    for (int i = first; i < end; ++i) {
      const bool had_x = (old_x >> i & 1) != 0;
      std::ranges::replace(blocks_[static_cast<std::size_t>(i)], had_x ? x : y, had_x ? y : x);
    }
    find_uncovered();
  }

  Wish wish_;
  Blocks blocks_;
  std::array<std::array<std::uint64_t, 64>, 64> wanted_{};
  std::array<std::array<std::uint64_t, 64>, 64> welcome_{};
  std::array<std::uint64_t, 64> rows_{};
  std::array<std::uint64_t, 64> locks_{};
  std::vector<Pair> uncovered_;
  int met_ = 0;  // pairs that are welcome
};

Set common(const Set& one, const Set& other) {
  Set a = one;
  Set b = other;
  Set both;
  std::ranges::sort(a);
  std::ranges::sort(b);
  std::ranges::set_intersection(a, b, std::back_inserter(both));
  return both;
}

/// Positions of disjoint unchanged subsets without elements of the hole, 0, …, h−1.
bool find_parts(const Blocks& list, int h, std::size_t left, std::size_t from, Set& taken,
                std::vector<std::size_t>& positions) {
  if (left == 0) {
    return true;
  }
  for (; from + 1 < list.size(); ++from) {
    const Set part = common(list[from], list[from + 1]);
    if (part.size() + 1 != list[from].size() || part.front() < h || !common(part, taken).empty()) {
      continue;
    }
    const std::size_t before = taken.size();
    taken.insert(taken.end(), part.begin(), part.end());
    positions.push_back(from + 1);
    if (find_parts(list, h, left - 1, from + 1, taken, positions)) {
      return true;
    }
    taken.resize(before);
    positions.pop_back();
  }
  return false;
}

struct Numbers {
  bool open = false;
  int k = 0;
  int w = 0;
  int added = 0;
  int parts = 0;
  int lacking = 0;

  [[nodiscard]] bool small() const {
    return k >= 3 && k <= 64 && w >= k && w <= 64 && added >= 1 && added <= 64 && parts >= 0 &&
           parts <= 64 && lacking >= 0 && lacking <= 64 * 64;
  }
  [[nodiscard]] int hole() const { return w - parts * (k - 1); }
  [[nodiscard]] int all() const { return w + added; }
};

/// x, …, x+n−1.
Set row(int x, int n) {
  Set set;
  for (int i = 0; i < n; ++i) {
    set.push_back(x + i);
  }
  return set;
}

std::set<Pair> pairs_between(int from, int to, int from_2, int to_2) {
  std::set<Pair> pairs;
  for (int x = from; x < to; ++x) {
    for (int y = std::max(from_2, x + 1); y < to_2; ++y) {
      pairs.emplace(x, y);
    }
  }
  return pairs;
}

/// The hole is 0, …, h−1. U is its last K−1 elements, U_1 its first, U_2 the last of all.
class Looking {
 public:
  explicit Looking(const Numbers& numbers)
      : q_(numbers), n_(q_.k - 1), h_(q_.hole()), welcome_(pairs_between(0, h_, 0, h_)) {
    std::erase_if(welcome_, [this](const Pair& pair) { return pair.first >= h_ - n_; });
    int apart = 0;  // pairs that no list is asked for
    if (q_.open) {
      std::erase_if(welcome_, [this](const Pair& pair) { return pair.second < n_; });
      apart = n_ * n_;
    }
    of_v_ = q_.w * (q_.w - 1) / 2 - q_.k * (q_.k - 1) / 2 - q_.lacking;
    of_p_ = q_.added * h_ + q_.added * (q_.added - 1) / 2 + q_.lacking - apart;
  }

  [[nodiscard]] int blocks_of_v() const { return (of_v_ + n_ - 1) / n_ + 1; }
  [[nodiscard]] int blocks_of_p() const { return (of_p_ + n_ - 1) / n_; }
  [[nodiscard]] int blocks() const { return blocks_of_v() + blocks_of_p() + q_.parts * q_.added; }
  [[nodiscard]] bool possible() const {
    return h_ >= (q_.open ? 2 * n_ : n_) && (!q_.open || q_.added >= n_) && h_ + q_.added <= 64 &&
           of_v_ >= 0 && of_p_ > 0 && blocks_of_v() <= most_blocks &&
           blocks_of_p() <= most_blocks &&
           static_cast<std::size_t>(q_.lacking) <= welcome_.size() &&
           (q_.parts == 0 || blocks_of_v() > gap * (q_.parts + 1)) &&
           (!q_.open || blocks_of_v() >= n_);  // From U_1 to U.
  }

  std::optional<Blocks> found(std::uint64_t seed, double seconds) const {
    Random random(seed);
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                        std::chrono::duration<double>(seconds));
    while (Clock::now() < end) {
      const auto p = List(wish_of_p()).annealed(moves_of_p, hot_p, cold_p, random, end);
      if (!p) {
        continue;
      }
      std::fprintf(stderr, "P found\n");
      List v(wish_of_v(*p));
      for (int i = 0; i < tries_of_v && Clock::now() < end; ++i) {
        if (const auto list = v.annealed(moves_of_v, hot_v, cold_v, random, end)) {
          if (auto all = put_together(*list, *p)) {
            return all;
          }
        }
      }
    }
    return std::nullopt;
  }

  /// One change at each step, and all pairs that are asked for.
  [[nodiscard]] bool right(const Blocks& list) const {
    std::set<Pair> lacking = pairs_between(0, q_.all(), 0, q_.all());
    if (q_.open) {
      for (const Pair& pair : pairs_between(0, n_, q_.all() - n_, q_.all())) {
        lacking.erase(pair);
      }
      if (common(list.front(), row(0, n_)).size() < static_cast<std::size_t>(n_) ||
          common(list.back(), row(q_.all() - n_, n_)).size() < static_cast<std::size_t>(n_) ||
          !common(list.front(), row(q_.all() - n_, n_)).empty() ||
          !common(list.back(), row(0, n_)).empty()) {
        return false;
      }
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (std::set<int>(list[i].begin(), list[i].end()).size() != static_cast<std::size_t>(q_.k) ||
          list[i].size() != static_cast<std::size_t>(q_.k) ||
          (i > 0 && common(list[i - 1], list[i]).size() != static_cast<std::size_t>(n_))) {
        return false;
      }
      for (const int x : list[i]) {
        for (const int y : list[i]) {
          lacking.erase({x, y});
        }
      }
    }
    return lacking.empty();
  }

 private:
  [[nodiscard]] Wish wish_of_p() const {
    const int all = h_ + q_.added;
    Wish wish{.k = q_.k, .elements = all, .blocks = blocks_of_p(), .first = row(h_ - n_, n_)};
    wish.unwanted = pairs_between(0, h_, 0, h_);
    wish.welcome = welcome_;
    wish.enough = q_.lacking;
    if (q_.open) {
      wish.last = row(all - n_, n_);
      wish.unwanted.merge(pairs_between(0, n_, all - n_, all));
    }
    return wish;
  }

  [[nodiscard]] Wish wish_of_v(const Blocks& p) const {
    std::set<Pair> met;
    for (const Set& block : p) {
      for (const int x : block) {
        for (const int y : block) {
          met.emplace(x, y);
        }
      }
    }
    std::erase_if(met, [this](const Pair& pair) { return !welcome_.contains(pair); });
    Wish wish{.k = q_.k, .elements = q_.w, .blocks = blocks_of_v()};
    wish.first = q_.open ? row(0, n_) : Set{};
    wish.last = row(h_ - n_, n_);
    wish.parts = q_.parts;
    wish.of_parts = h_;
    wish.unwanted = std::move(met);
    return wish;
  }

  [[nodiscard]] std::optional<Blocks> put_together(const Blocks& v, const Blocks& p) const {
    std::vector<std::size_t> positions;
    Set taken;
    if (!find_parts(v, h_, static_cast<std::size_t>(q_.parts), 0, taken, positions)) {
      return std::nullopt;
    }
    Blocks all;
    for (std::size_t place = 0; place < v.size(); ++place) {
      if (std::ranges::find(positions, place) != positions.end()) {
        Set block = common(v[place - 1], v[place]);
        block.push_back(q_.w);
        for (int x = 0; x < q_.added; ++x) {
          block.back() = q_.w + x;
          all.push_back(block);
        }
      }
      all.push_back(v[place]);
    }
    for (Set block : p) {
      for (int& x : block) {
        x = x < h_ ? x : x - h_ + q_.w;
      }
      all.push_back(block);
    }
    return right(all) ? std::optional(all) : std::nullopt;
  }

  Numbers q_;
  int n_;
  int h_;
  std::set<Pair> welcome_;
  int of_v_ = 0;
  int of_p_ = 0;
};

int run(const Numbers& numbers, std::uint64_t seed, double seconds) {
  if (!numbers.small() || !Looking(numbers).possible()) {
    std::fprintf(stderr,
                 "find_with_hole: these numbers make no two lists of at most 64 blocks; the hole, "
                 "W-PARTS*(K-1) elements, needs K-1, with open 2(K-1), and with open NEW is K-1 "
                 "or more; V needs 5 blocks for each subset and 6 more\n");
    return 2;
  }
  const Looking looking(numbers);
  std::fprintf(stderr,
               "V: %d blocks on %d elements; P: %d blocks, a hole of %d, %d new; in all %d\n",
               looking.blocks_of_v(), numbers.w, looking.blocks_of_p(), numbers.hole(),
               numbers.added, looking.blocks());
  const auto list = looking.found(seed, seconds);
  if (!list) {
    std::fprintf(stderr, "find_with_hole: none found\n");
    return 1;
  }
  std::printf(numbers.open ? "# list with open ends v=%d k=%d change=1\n"
                           : "# changeover design v=%d k=%d change=1 kind=linear\n",
              numbers.all(), numbers.k);
  for (Set block : *list) {
    std::ranges::sort(block);
    for (std::size_t x = 0; x < block.size(); ++x) {
      std::printf("%s%d", x == 0 ? "" : " ", block[x]);
    }
    std::printf("\n");
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    std::fprintf(stderr, "find_with_hole: the list could not be written\n");
    return 3;
  }
  return 0;
}

}  // namespace
}  // namespace find_with_hole

int main(int count, char** words) {
  const bool open = count > 1 && std::string_view(words[1]) == "open";
  std::vector<int> numbers{0, 0, 0, 0, 0, 1, 600};
  const int from = open ? 2 : 1;
  bool right = count - from >= 5 && count - from <= 7;
  for (int i = from; right && i < count; ++i) {
    const std::string_view word = words[i];
    int& number = numbers[static_cast<std::size_t>(i - from)];
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), number);
    right = fault == std::errc() && end == word.data() + word.size() && number >= 0;
  }
  if (!right || numbers.back() == 0) {
    std::fprintf(stderr,
                 "usage: find_with_hole [open] K W NEW PARTS LACKING [SEED] [SECONDS], whole "
                 "numbers, SECONDS at least 1\n");
    return 2;
  }
  return find_with_hole::run({open, numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]},
                             static_cast<std::uint64_t>(numbers[5]), numbers[6]);
}
