// Linear single-change designs in two lists of blocks, the second with a hole (docs/theorems.md,
// Theorem 13); docs/tools/find_with_hole.sh compiles and runs it.
//
//     find_with_hole K W NEW PARTS LACKING [SEED] [SECONDS] > DESIGN
//
// V is a list on W elements, without LACKING pairs of a *hole*: the elements beside PARTS disjoint
// unchanged subsets of K−1. P begins where V ends, and has the hole and NEW elements. V is looked
// for backwards, so that both begin with the same K−1 elements of the hole.
//
// Each list is annealed: a move exchanges two elements in a stretch of blocks in which one of them
// is and the other is not, half of the moves are aimed at a pair that is uncovered. An element has
// one bit for each block, so a list has at most 64. What comes out is verified here and again by
// the program that reads it. Results depend on the numbers and the seed, and on SECONDS only in
// when it gives up.
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

constexpr std::uint64_t moves_of_v = 60'000'000;
constexpr std::uint64_t moves_of_p = 100'000'000;
constexpr int tries = 3;      // of each list, before other pairs are taken
constexpr double hot = 0.28;  // in uncovered pairs
constexpr double cold = 0.20;
constexpr std::uint64_t levels = 400;
constexpr int most_blocks = 64;

int below(Random& random, std::size_t n) { return static_cast<int>((random() >> 32) * n >> 32); }

/// Blocks of k elements in which one changes at each step, the first one fixed, and the pairs that
/// are wanted.
class List {
 public:
  List(int elements, Set first, int blocks, const std::set<Pair>& unwanted)
      : elements_(elements), blocks_(static_cast<std::size_t>(blocks), first) {
    for (int x = 0; x < elements; ++x) {
      for (int y = x + 1; y < elements; ++y) {
        wanted_[x][y] = wanted_[y][x] = unwanted.contains({x, y}) ? 0 : ~std::uint64_t{0};
      }
    }
  }

  /// The blocks if nothing is uncovered at the end.
  std::optional<Blocks> annealed(std::uint64_t moves, Random& random, Clock::time_point end) {
    start(random);
    double temperature = hot;
    for (std::uint64_t level = 0; level < levels && Clock::now() < end; ++level) {
      std::array<std::uint64_t, 16> accepted{};
      for (std::size_t i = 0; i < accepted.size(); ++i) {
        accepted[i] = static_cast<std::uint64_t>(std::exp(-static_cast<double>(i) / temperature) *
                                                 4294967295.0);
      }
      for (std::uint64_t i = 0; i < moves / levels; ++i) {
        if (uncovered_.empty()) {
          return blocks_;
        }
        move(random, accepted);
      }
      temperature *= std::pow(cold / hot, 1.0 / static_cast<double>(levels));
    }
    return std::nullopt;
  }

 private:
  void start(Random& random) {
    rows_.fill(0);
    int last = -1;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      if (b > 0) {
        Set& block = blocks_[b] = blocks_[b - 1];
        int in = 0;
        do {
          in = below(random, static_cast<std::size_t>(elements_));
        } while (std::ranges::find(block, in) != block.end());
        int place = 0;
        do {
          place = below(random, block.size());
        } while (place == last);
        block[static_cast<std::size_t>(place)] = in;
        last = place;
      }
      for (const int x : blocks_[b]) {
        rows_[x] |= std::uint64_t{1} << b;
      }
    }
    find_uncovered();
  }

  void find_uncovered() {
    uncovered_.clear();
    for (int x = 0; x < elements_; ++x) {
      for (int y = x + 1; y < elements_; ++y) {
        if (wanted_[x][y] != 0 && (rows_[x] & rows_[y]) == 0) {
          uncovered_.emplace_back(x, y);
        }
      }
    }
  }

  void move(Random& random, const std::array<std::uint64_t, 16>& accepted) {
    int b = 0;
    int y = 0;
    int kept = -1;
    if (random() % 2 == 0) {
      b = 1 + below(random, blocks_.size() - 1);
      y = below(random, static_cast<std::size_t>(elements_));
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
    const int first = b - std::countl_one(one_of_them << (most_blocks - 1 - b)) + 1;
    const int end =
        std::min(b + std::countr_one(one_of_them >> b), static_cast<int>(blocks_.size()));
    if (first <= 0) {  // The first block is fixed.
      return;
    }
    const std::uint64_t run =
        (end == most_blocks ? ~std::uint64_t{0} : (std::uint64_t{1} << end) - 1) &
        ~((std::uint64_t{1} << first) - 1);
    const std::uint64_t old_x = std::exchange(rows_[x], 0);
    const std::uint64_t old_y = std::exchange(rows_[y], 0);
    int change = 0;
    for (int z = 0; z < elements_; ++z) {
      const std::uint64_t of_x = rows_[z] & wanted_[x][z];
      const std::uint64_t of_y = rows_[z] & wanted_[y][z];
      change +=
          static_cast<int>((of_x & old_x) != 0) - static_cast<int>((of_x & (old_x ^ run)) != 0);
      change +=
          static_cast<int>((of_y & old_y) != 0) - static_cast<int>((of_y & (old_y ^ run)) != 0);
    }
    const bool made = change <= 0 || (change < static_cast<int>(accepted.size()) &&
                                      random() >> 32 < accepted[static_cast<std::size_t>(change)]);
    rows_[x] = made ? old_x ^ run : old_x;
    rows_[y] = made ? old_y ^ run : old_y;
    if (!made) {
      return;
    }
    for (int i = first; i < end; ++i) {
      const bool had_x = (old_x >> i & 1) != 0;
      std::ranges::replace(blocks_[static_cast<std::size_t>(i)], had_x ? x : y, had_x ? y : x);
    }
    find_uncovered();
  }

  int elements_;
  Blocks blocks_;
  std::array<std::array<std::uint64_t, 64>, 64> wanted_{};
  std::array<std::uint64_t, 64> rows_{};
  std::vector<Pair> uncovered_;
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

bool is_design(const Blocks& list, int v) {
  std::set<Pair> met;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i > 0 && common(list[i - 1], list[i]).size() + 1 != list[i].size()) {
      return false;
    }
    for (const int x : list[i]) {
      for (const int y : list[i]) {
        if (x < y) {
          met.emplace(x, y);
        }
      }
    }
  }
  return met.size() == static_cast<std::size_t>(v * (v - 1) / 2);
}

int run(int k, int w, int added, int parts, int lacking, std::uint64_t seed, double seconds) {
  const bool small = k >= 3 && k <= 64 && w >= k && w <= 64 && added >= 1 && added <= 64 &&
                     parts >= 0 && parts <= 64 && lacking >= 0 && lacking <= 64 * 64;
  const int n = small ? k - 1 : 1;
  const int h = small ? w - parts * n : 0;
  const int of_v = small ? w * (w - 1) / 2 - k * (k - 1) / 2 - lacking : 0;
  const int of_p = small ? added * h + added * (added - 1) / 2 + lacking : 0;
  const int blocks_of_v = of_v / n + 1;
  const int blocks_of_p = (of_p + n - 1) / n;
  std::vector<Pair> inside;  // the hole, but not with both among the first k−1
  for (int y = n; y < h; ++y) {
    for (int x = 0; x < y; ++x) {
      inside.emplace_back(x, y);
    }
  }
  if (!small || h < n || h + added > 64 || of_v < 0 || of_v % n != 0 || blocks_of_v > most_blocks ||
      blocks_of_p > most_blocks || static_cast<std::size_t>(lacking) > inside.size()) {
    std::fprintf(stderr,
                 "find_with_hole: these numbers make no two lists of at most 64 blocks; the pairs "
                 "of V, C(W,2)-C(K,2)-LACKING, must be a multiple of K-1\n");
    return 2;
  }
  std::fprintf(stderr,
               "V: %d blocks on %d elements; P: %d blocks, a hole of %d, %d new; in all %d\n",
               blocks_of_v, w, blocks_of_p, h, added, blocks_of_v + blocks_of_p + parts * added);
  Random random(seed);
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(seconds));
  Set first(static_cast<std::size_t>(k));
  while (Clock::now() < end) {
    std::shuffle(inside.begin(), inside.end(), random);
    const std::set<Pair> lacks(inside.begin(), inside.begin() + lacking);
    std::set<Pair> known;
    for (int y = 0; y < h; ++y) {
      for (int x = 0; x < y; ++x) {
        if (!lacks.contains({x, y})) {
          known.emplace(x, y);
        }
      }
    }
    for (int x = 0; x < n; ++x) {
      first[static_cast<std::size_t>(x)] = x;
    }
    first.back() = h;  // of a part in V, new in P
    for (int i = 0; i < tries; ++i) {
      std::vector<std::size_t> positions;
      Set taken;
      const auto v = w > h ? List(w, first, blocks_of_v, lacks).annealed(moves_of_v, random, end)
                           : std::nullopt;
      if (!v || !find_parts(*v, h, static_cast<std::size_t>(parts), 0, taken, positions)) {
        continue;
      }
      std::fprintf(stderr, "V with its subsets found\n");
      for (int j = 0; j < tries; ++j) {
        auto p = List(h + added, first, blocks_of_p, known).annealed(moves_of_p, random, end);
        if (!p) {
          continue;
        }
        Blocks all;
        for (std::size_t place = v->size(); place > 0; --place) {
          all.push_back((*v)[place - 1]);
          if (std::ranges::find(positions, place - 1) != positions.end()) {
            Set block = common((*v)[place - 2], (*v)[place - 1]);
            block.push_back(w);
            for (int x = 0; x < added; ++x) {
              block.back() = w + x;
              all.push_back(block);
            }
          }
        }
        for (Set& block : *p) {
          for (int& x : block) {
            x = x < h ? x : x - h + w;
          }
          all.push_back(block);
        }
        if (!is_design(all, w + added)) {
          std::fprintf(stderr, "find_with_hole: what came out is no design\n");
          return 3;
        }
        std::printf("# changeover design v=%d k=%d change=1 kind=linear\n", w + added, k);
        for (Set& block : all) {
          std::ranges::sort(block);
          for (std::size_t x = 0; x < block.size(); ++x) {
            std::printf("%s%d", x == 0 ? "" : " ", block[x]);
          }
          std::printf("\n");
        }
        return 0;
      }
    }
  }
  std::fprintf(stderr, "find_with_hole: none found\n");
  return 1;
}

}  // namespace
}  // namespace find_with_hole

int main(int count, char** words) {
  std::vector<int> numbers{0, 0, 0, 0, 0, 1, 600};
  bool right = count >= 6 && count <= 8;
  for (int i = 1; right && i < count; ++i) {
    const std::string_view word = words[i];
    int& number = numbers[static_cast<std::size_t>(i - 1)];
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), number);
    right = fault == std::errc() && end == word.data() + word.size() && number >= 0;
  }
  if (!right || numbers.back() == 0) {
    std::fprintf(stderr,
                 "usage: find_with_hole K W NEW PARTS LACKING [SEED] [SECONDS], whole numbers\n");
    return 2;
  }
  return find_with_hole::run(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4],
                             static_cast<std::uint64_t>(numbers[5]), numbers[6]);
}
