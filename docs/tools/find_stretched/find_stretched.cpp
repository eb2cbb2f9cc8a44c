// Lists of base blocks over Z × {0, …, G−1} that can be stretched (docs/theorems.md, Theorem 30);
// docs/tools/find_stretched.sh compiles and runs it.
//
//     find_stretched G H N [SEED] [SECONDS] > LIST
//
// A list has q = (GN−1)/2H steps. In each of them a point enters and one leaves: at step t that of
// step leaves[t], which entered before; numbers below 0 and from q on mean the same steps of the
// translates before and after. So a list is q points and a permutation. It is annealed: a move
// gives a step another point, exchanges the points of two steps, or the steps at which two points
// leave. What counts is how many distances are not there yet, and how many points of A are not kept
// at step 0. What comes out is verified here, from its blocks, and again by the tests of the list
// that is kept. Results depend on the numbers and the seed, and on SECONDS only in when it gives
// up.
#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace find_stretched {
namespace {

using Clock = std::chrono::steady_clock;
using Random = std::mt19937_64;

struct Point {
  int orbit = 0;
  int residue = 0;

  auto operator<=>(const Point&) const = default;
};

using Block = std::vector<Point>;

struct Numbers {
  int g = 1;
  int h = 1;
  int n = 1;

  [[nodiscard]] int kept() const { return g * h; }
  [[nodiscard]] int farthest() const { return (n - 1) / 2; }
  [[nodiscard]] int steps() const { return (g * n - 1) / (2 * h); }
  [[nodiscard]] bool possible() const {
    return g >= 1 && h >= 1 && n >= 3 && g <= 26 && h <= 99 && n <= 999 && n % 2 == 1 &&
           (g * n - 1) % (2 * h) == 0 && steps() > kept() + 1;
  }
};

constexpr std::uint64_t moves = 40'000'000;
constexpr std::uint64_t moves_at_once = 4096;
constexpr double hot = 0.42;  // in distances that are not there
constexpr double cold = 0.20;

class List {
 public:
  explicit List(const Numbers& numbers)
      : q_(numbers),
        steps_(numbers.steps()),
        points_(static_cast<std::size_t>(steps_)),
        leaves_(points_.size()),
        until_(points_.size()),
        kept_(points_.size()),
        count_(static_cast<std::size_t>(numbers.g * numbers.g * width())) {}

  /// The blocks if nothing is missing at the end.
  std::optional<std::vector<Block>> annealed(Random& random, Clock::time_point end) {
    start(random);
    int missing = missing_now();
    std::array<std::uint64_t, 32> accepted{};
    for (std::uint64_t i = 0; i < moves && missing > 0; ++i) {
      if (i % moves_at_once == 0) {
        if (Clock::now() >= end) {
          return std::nullopt;
        }
        const double temperature =
            hot * std::pow(cold / hot, static_cast<double>(i) / static_cast<double>(moves));
        for (std::size_t more = 0; more < accepted.size(); ++more) {
          accepted[more] = static_cast<std::uint64_t>(
              std::exp(-static_cast<double>(more) / temperature) * 4294967295.0);
        }
      }
      const auto takes = [&](int now) {
        const int more = now - missing;
        if (more <= 0 || (more < static_cast<int>(accepted.size()) &&
                          random() >> 32 < accepted[static_cast<std::size_t>(more)])) {
          missing = now;
          return true;
        }
        return false;
      };
      const int kind = below(random, 10);
      if (kind < 6) {
        other_point(random, takes);
      } else if (kind < 8) {
        other_leaving(random, takes);
      } else {
        exchange_points(random, takes);
      }
    }
    return missing == 0 ? std::optional(blocks()) : std::nullopt;
  }

 private:
  static int below(Random& random, int n) {
    return static_cast<int>((random() >> 32) * static_cast<std::uint64_t>(n) >> 32);
  }
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  [[nodiscard]] int width() const { return q_.n; }

  // Of 0, …, q−1, and how many translates later.
  [[nodiscard]] std::pair<int, int> step_of(int t) const {
    const int translate = t >= 0 ? t / steps_ : -((steps_ - 1 - t) / steps_);
    return {t - translate * steps_, translate};
  }
  [[nodiscard]] Point point(int t) const {
    const auto [step, translate] = step_of(t);
    return {points_[at(step)].orbit, points_[at(step)].residue + translate};
  }

  // Where two points are counted; −1 if they are too far apart.
  [[nodiscard]] int place(Point a, Point b) const {
    if (a.orbit < b.orbit) {
      std::swap(a, b);
    }
    int apart = a.residue - b.residue;
    if (a.orbit == b.orbit) {
      apart = std::abs(apart);
      if (apart == 0) {
        return -1;
      }
    }
    return std::abs(apart) > q_.farthest()
               ? -1
               : (a.orbit * q_.g + b.orbit) * width() + apart + q_.farthest();
  }
  void add(int t, int u, int how_many) {
    const int where = place(point(t), point(u));
    if (where >= 0) {
      int& count = count_[at(where)];
      covered_ += how_many > 0 ? (count == 0 ? 1 : 0) : (count == 1 ? -1 : 0);
      count += how_many;
    }
  }

  void start(Random& random) {
    for (int t = 0; t < steps_; ++t) {
      points_[at(t)] = any_point(random);
      leaves_[at(t)] = t - q_.kept() - 1;
      until_[at(t)] = t + q_.kept() + 1;
    }
    covered_ = 0;
    std::ranges::fill(count_, 0);
    for (int t = 0; t < steps_; ++t) {
      kept_[at(t)].clear();
      for (int u = t - q_.kept(); u < t; ++u) {
        kept_[at(t)].push_back(u);
        add(t, u, 1);
      }
    }
  }
  [[nodiscard]] Point any_point(Random& random) const {
    return {below(random, q_.g), any_residue(random)};
  }
  [[nodiscard]] int any_residue(Random& random) const {
    return below(random, 2 * q_.farthest() + 3) - q_.farthest();
  }

  [[nodiscard]] int missing_now() const {
    std::set<Point> of_a;
    for (const int u : kept_.front()) {
      const Point kept = point(u);
      if (kept.residue >= 0 && kept.residue < q_.h) {
        of_a.insert(kept);
      }
    }
    return q_.kept() * steps_ - covered_ + q_.kept() - static_cast<int>(of_a.size());
  }

  // All that the point of step t meets, as it enters and while it stays.
  void count_meetings(int t, int how_many) {
    for (const int u : kept_[at(t)]) {
      add(t, u, how_many);
    }
    for (int later = t + 1; later < until_[at(t)]; ++later) {
      if ((later - t) % steps_ != 0) {
        add(later, t, how_many);
      }
    }
  }
  void give(int t, const Point& point) {
    count_meetings(t, -1);
    points_[at(t)] = point;
    count_meetings(t, 1);
  }

  template <typename Takes>
  void other_point(Random& random, const Takes& takes) {
    const int t = below(random, steps_);
    const Point before = points_[at(t)];
    Point now = before;
    switch (below(random, 4)) {
      case 0:
        now.orbit = below(random, q_.g);
        break;
      case 1:
        now.residue = any_residue(random);
        break;
      case 2:
        now = any_point(random);
        break;
      default:
        now.residue += random() % 2 == 0 ? 1 : -1;
        break;
    }
    if (now == before) {
      return;
    }
    give(t, now);
    if (!takes(missing_now())) {
      give(t, before);
    }
  }

  template <typename Takes>
  void exchange_points(Random& random, const Takes& takes) {
    const int t = below(random, steps_);
    const int u = below(random, steps_);
    const Point one = points_[at(t)];
    const Point other = points_[at(u)];
    if (one == other) {
      return;
    }
    give(t, other);
    give(u, one);
    if (!takes(missing_now())) {
      give(t, one);
      give(u, other);
    }
  }

  // Instead of `out`, `in` is kept at the steps from `from` up to, but not including, `to`.
  void keep(int from, int to, int out, int in) {
    for (int t = from; t < to; ++t) {
      const auto [step, translate] = step_of(t);
      std::vector<int>& kept = kept_[at(step)];
      const auto where = std::ranges::find(kept, out - translate * steps_);
      add(step, *where, -1);
      *where = in - translate * steps_;
      add(step, *where, 1);
    }
  }

  template <typename Takes>
  void other_leaving(Random& random, const Takes& takes) {
    const int first = below(random, steps_);
    const int second = first + 1 + below(random, q_.kept() + 1);
    const auto [step, translate] = step_of(second);
    const int early = leaves_[at(first)];
    const int late = leaves_[at(step)] + translate * steps_;
    const auto [early_step, early_translate] = step_of(early);
    const auto [late_step, late_translate] = step_of(late);
    if (step == first || second - first >= steps_ || late >= first || early_step == late_step) {
      return;
    }
    const auto leave = [&, step = step, translate = translate, early_step = early_step,
                        early_translate = early_translate, late_step = late_step,
                        late_translate = late_translate](bool exchanged) {
      leaves_[at(first)] = exchanged ? late : early;
      leaves_[at(step)] = (exchanged ? early : late) - translate * steps_;
      until_[at(early_step)] = (exchanged ? second : first) - early_translate * steps_;
      until_[at(late_step)] = (exchanged ? first : second) - late_translate * steps_;
    };
    keep(first, second, late, early);
    leave(true);
    if (!takes(missing_now())) {
      keep(first, second, early, late);
      leave(false);
    }
  }

  [[nodiscard]] std::vector<Block> blocks() const {
    std::vector<Block> all;
    for (int t = 0; t < steps_; ++t) {
      Block block{point(t)};
      for (const int u : kept_[at(t)]) {
        block.push_back(point(u));
      }
      std::ranges::sort(block);
      all.push_back(std::move(block));
    }
    return all;
  }

  Numbers q_;
  int steps_;
  std::vector<Point> points_;           // that enter
  std::vector<int> leaves_;             // the step of what leaves
  std::vector<int> until_;              // the step at which what enters here leaves
  std::vector<std::vector<int>> kept_;  // the steps of what is there when a point enters
  std::vector<int> count_;              // how often each distance is there
  int covered_ = 0;                     // distances that are there
};

/// The three conditions of Theorem 30.
bool right(const Numbers& q, const std::vector<Block>& list) {
  Block before = list.back();
  for (Point& point : before) {
    --point.residue;
  }
  const auto has = [](const Block& block, const Point& point) {
    return std::ranges::find(block, point) != block.end();
  };
  for (int orbit = 0; orbit < q.g; ++orbit) {
    for (int residue = 0; residue < q.h; ++residue) {
      if (!has(before, {orbit, residue}) || !has(list.front(), {orbit, residue})) {
        return false;
      }
    }
  }
  std::set<std::array<int, 3>> distances;
  std::size_t count = 0;
  for (const Block& block : list) {
    Block entering;
    std::ranges::copy_if(block, std::back_inserter(entering),
                         [&](const Point& point) { return !has(before, point); });
    if (entering.size() != 1 || block.size() != static_cast<std::size_t>(q.kept() + 1)) {
      return false;
    }
    for (const Point& point : block) {
      if (point == entering.front()) {
        continue;
      }
      const auto [low, high] = std::minmax(point, entering.front());
      const int apart = high.residue - low.residue;
      if (std::abs(apart) > q.farthest() || (low.orbit == high.orbit && apart == 0)) {
        return false;
      }
      distances.insert({low.orbit, high.orbit, apart});
      ++count;
    }
    before = block;
  }
  return distances.size() == count && count == static_cast<std::size_t>(q.g * (q.g * q.n - 1) / 2);
}

int run(const Numbers& numbers, std::uint64_t seed, double seconds) {
  if (!numbers.possible()) {
    std::fprintf(stderr,
                 "find_stretched: there is no list for these numbers: 2H must divide GN-1, N is "
                 "odd, G at most 26, and (GN-1)/2H more than GH+1\n");
    return 2;
  }
  Random random(seed);
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(seconds));
  List list(numbers);
  while (Clock::now() < end) {
    const auto found = list.annealed(random, end);
    if (!found || !right(numbers, *found)) {
      continue;
    }
    for (std::size_t i = 0; i < found->size(); ++i) {
      std::printf("%s", i == 0 ? "" : ",\n");
      for (std::size_t j = 0; j < (*found)[i].size(); ++j) {
        const Point& point = (*found)[i][j];
        std::printf("%s%d%c", j == 0 ? "" : " ", point.residue, 'a' + point.orbit);
      }
    }
    std::printf("\n");
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      std::fprintf(stderr, "find_stretched: the list could not be written\n");
      return 3;
    }
    return 0;
  }
  std::fprintf(stderr, "find_stretched: none found\n");
  return 1;
}

}  // namespace
}  // namespace find_stretched

int main(int count, char** words) {
  std::vector<int> numbers{0, 0, 0, 1, 600};
  bool right = count >= 4 && count <= 6;
  for (int i = 1; right && i < count; ++i) {
    const std::string_view word = words[i];
    int& number = numbers[static_cast<std::size_t>(i - 1)];
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), number);
    right = fault == std::errc() && end == word.data() + word.size() && number >= 0;
  }
  if (!right || numbers.back() == 0) {
    std::fprintf(stderr,
                 "usage: find_stretched G H N [SEED] [SECONDS], whole numbers, SECONDS at least "
                 "1\n");
    return 2;
  }
  return find_stretched::run({numbers[0], numbers[1], numbers[2]},
                             static_cast<std::uint64_t>(numbers[3]), numbers[4]);
}
