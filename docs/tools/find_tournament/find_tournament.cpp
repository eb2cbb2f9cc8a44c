// Lists of blocks of four points of five orbits, for tight circular DCCD(5n,4) and DCCD(5n+1,4)
// (docs/theorems.md, Theorem 32); docs/tools/find_tournament.sh compiles and runs it.
//
//     find_tournament FIXED TOTAL [SEED] [SECONDS] > LIST
//
// First the orbits: a chain of blocks of orbits, two kept at each step, in which each pair of
// orbits is new as often as it must be, whose last block can lead on to the first, and in which
// the two orbits that an orbit beats are kept together at some step. Then the residues: one point
// of each orbit is at 0, the others are chosen in the order in which they enter, while the
// differences of each pair of orbits are distinct and not too far apart. Results depend on the
// numbers and the seed, and on SECONDS only in when it gives up.
#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace find_tournament {
namespace {

using Clock = std::chrono::steady_clock;
using Random = std::mt19937_64;

constexpr int orbits = 5;
constexpr int fixed_orbit = 5;
constexpr int most_orbits = 6;
constexpr int farthest = 7;  // the most that a residue is away from 0

// The one of two orbits that beats the other.
int winner(int a, int b) {
  const int ahead = (b - a + orbits) % orbits;
  return ahead == 1 || ahead == 2 ? a : b;
}

// Points are named by the step and place at which they enter, 2t and 2t+1; −1 and −2 are the two
// points that are kept at step 0.
struct Step {
  std::array<int, 2> kept;
  std::array<int, 2> entering;
};

class Search {
 public:
  Search(int fixed, int total, std::uint64_t seed, double seconds)
      : fixed_(fixed),
        total_(total),
        steps_(total + 2 + fixed),
        orbit_(static_cast<std::size_t>(2 * steps_)),
        residue_(orbit_.size()),
        assigned_(orbit_.size()),
        random_(seed),
        end_(Clock::now() +
             std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))) {}

  // Whether there is a list; then print() writes it.
  bool run() {
    while (Clock::now() < end_) {
      begin();
      nodes_ = 0;
      if (chain(0, {-1, -2})) {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool print() const {
    std::printf("fixed %d, shift %d, x =", fixed_, shift_);
    for (const int x : x_) {
      std::printf(" %d", x);
    }
    for (const Step& step : chain_) {
      std::printf("%s", &step == chain_.data() ? "\n" : ", ");
      for (const int id : {step.kept[0], step.kept[1], step.entering[0], step.entering[1]}) {
        std::printf("%s%d%c", id == step.kept[0] ? "" : " ",
                    orbit(id) == fixed_orbit ? 0 : residue(id), "abcdef"[orbit(id)]);
      }
    }
    std::printf("\n");
    for (int c = 0; c < orbits; ++c) {
      const auto [before, centre] = station(c);
      std::printf("orbit %c passes before block %d, centre %d, from x = %d\n", "abcde"[c], before,
                  centre, x_[static_cast<std::size_t>(c)] + 1);
    }
    return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  }

  // The conditions of the theorem, from the blocks and nothing else.
  [[nodiscard]] bool holds() const {
    std::array<std::array<std::vector<int>, most_orbits>, most_orbits> apart;
    for (std::size_t t = 0; t < chain_.size(); ++t) {
      const std::vector<std::pair<int, int>> block = points(t);
      std::vector<std::pair<int, int>> before = points((t + chain_.size() - 1) % chain_.size());
      for (auto& [o, x] : before) {
        x -= t == 0 && o != fixed_orbit ? shift_ : 0;
      }
      const auto was_there = [&](const std::pair<int, int>& point) {
        return std::ranges::find(before, point) != before.end();
      };
      if (std::ranges::count_if(block, was_there) != 2) {
        return false;
      }
      for (std::size_t i = 0; i < block.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          if (was_there(block[i]) && was_there(block[j])) {
            continue;
          }
          const auto [a, x] = block[i];
          const auto [b, y] = block[j];
          if (a == fixed_orbit || b == fixed_orbit) {
            apart[fixed_orbit][static_cast<std::size_t>(std::min(a, b))].push_back(0);
          } else if (a == b) {
            apart[static_cast<std::size_t>(a)][static_cast<std::size_t>(a)].push_back(
                std::abs(x - y));
          } else {
            const bool first = winner(a, b) == a;
            apart[static_cast<std::size_t>(first ? a : b)][static_cast<std::size_t>(first ? b : a)]
                .push_back(first ? x - y : y - x);
          }
        }
      }
    }
    for (std::size_t c = 0; c < orbits; ++c) {
      auto& own = apart[c][c];
      std::ranges::sort(own);
      for (std::size_t i = 0; i < own.size(); ++i) {
        if (own[i] != 2 * static_cast<int>(i + 1)) {
          return false;
        }
      }
      if (static_cast<int>(own.size()) != x_[c] ||
          static_cast<int>(apart[fixed_orbit][c].size()) != fixed_) {
        return false;
      }
      for (const std::size_t o : {(c + 1) % orbits, (c + 2) % orbits}) {
        const std::set<int> distinct(apart[c][o].begin(), apart[c][o].end());
        if (static_cast<int>(apart[c][o].size()) != 2 * x_[c] + 1 ||
            distinct.size() != apart[c][o].size() ||
            *distinct.rbegin() - *distinct.begin() != 2 * x_[c]) {
          return false;
        }
      }
      if (station(static_cast<int>(c)).first < 0) {
        return false;
      }
    }
    return true;
  }

 private:
  static constexpr long most_nodes = 300'000;

  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }

  void begin() {
    x_ = {};
    for (int i = 0; i < total_; ++i) {
      ++x_[static_cast<std::size_t>(below(orbits))];
    }
    for (int a = 0; a < most_orbits; ++a) {
      for (int b = 0; b < most_orbits; ++b) {
        left(a, b) = a == fixed_orbit || b == fixed_orbit ? (a != b ? fixed_ : 0)
                     : a == b                             ? x_[static_cast<std::size_t>(a)]
                              : 2 * x_[static_cast<std::size_t>(winner(a, b))] + 1;
      }
    }
    chain_.clear();
  }

  int& left(int a, int b) {
    return left_[static_cast<std::size_t>(std::max(a, b))]
                [static_cast<std::size_t>(std::min(a, b))];
  }

  // ---- Orbits ----

  [[nodiscard]] int orbit(int id) const {
    return id < 0 ? -id : orbit_[static_cast<std::size_t>(id)];
  }

  // Takes the pairs of `entering` with each of `others`, or none of them.
  bool take(int entering, const std::vector<int>& others) {
    for (std::size_t i = 0; i < others.size(); ++i) {
      if (--left(entering, others[i]) < 0) {
        give_back(entering, others, i + 1);
        return false;
      }
    }
    return true;
  }
  void give_back(int entering, const std::vector<int>& others, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      ++left(entering, others[i]);
    }
  }

  // Continues the chain from `block`; true when a list is complete.
  bool chain(int t, const std::vector<int>& block) {
    if (++nodes_ > most_nodes || ((nodes_ & 4095) == 0 && Clock::now() >= end_)) {
      nodes_ = most_nodes;
      return false;
    }
    if (t == steps_) {
      return closes(block);
    }
    std::vector<std::pair<int, int>> pairs;
    for (std::size_t j = 0; j < block.size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        pairs.emplace_back(block[i], block[j]);
      }
    }
    std::ranges::shuffle(pairs, random_);
    for (const auto& [a, b] : pairs) {
      const int first = below(orbits + fixed_);
      for (int i = 0; i < orbits + fixed_; ++i) {
        const int x = (first + i) % (orbits + fixed_);
        const std::vector<int> kept{orbit(a), orbit(b)};
        if (!take(x, kept)) {
          continue;
        }
        for (int y = x; y < orbits + fixed_; ++y) {
          const std::vector<int> others{orbit(a), orbit(b), x};
          if (!take(y, others)) {
            continue;
          }
          orbit_[static_cast<std::size_t>(2 * t)] = x;
          orbit_[static_cast<std::size_t>(2 * t + 1)] = y;
          chain_.push_back({{a, b}, {2 * t, 2 * t + 1}});
          if (chain(t + 1, {a, b, 2 * t, 2 * t + 1})) {
            return true;
          }
          chain_.pop_back();
          give_back(y, others, others.size());
          if (nodes_ >= most_nodes) {
            return false;
          }
        }
        give_back(x, kept, kept.size());
      }
    }
    return false;
  }

  // Whether points of the orbits 1 and 2 of the last block can be those kept at step 0, each orbit
  // has a step at which it can pass, and there are residues.
  bool closes(const std::vector<int>& block) {
    std::array<bool, orbits> passes{};
    for (const Step& step : chain_) {
      for (int c = 0; c < orbits; ++c) {
        passes[static_cast<std::size_t>(c)] |= keeps_beaten(step, c);
      }
    }
    if (std::ranges::find(passes, false) != passes.end()) {
      return false;
    }
    for (const int one : block) {
      for (const int two : block) {
        if (one >= 0 && two >= 0 && orbit(one) == 1 && orbit(two) == 2) {
          last_ = {one, two};
          for (const int shift : {1, -1, 2, -2, 4, -4}) {
            shift_ = shift;
            if (with_residues()) {
              return true;
            }
          }
        }
      }
    }
    return false;
  }

  [[nodiscard]] bool keeps_beaten(const Step& step, int c) const {
    const std::pair beaten{(c + 1) % orbits, (c + 2) % orbits};
    const int a = orbit(step.kept[0]);
    const int b = orbit(step.kept[1]);
    return beaten == std::pair(a, b) || beaten == std::pair(b, a);
  }

  // ---- Residues ----

  // What is known of the differences of two orbits, the winner's less the other's.
  struct Differences {
    int least = 99;
    int most = -99;
    std::uint64_t there = 0;
  };
  using Known = std::array<std::array<Differences, orbits>, orbits>;

  [[nodiscard]] int residue(int id) const {
    return id < 0 ? residue_[static_cast<std::size_t>(last_[static_cast<std::size_t>(-1 - id)])] -
                        shift_
                  : residue_[static_cast<std::size_t>(id)];
  }

  bool with_residues() {
    assigned_.assign(assigned_.size(), false);
    std::array<bool, orbits> has_zero{};
    const auto to_zero = [&](int id) {
      const int o = orbit(id);
      if (o < orbits && !has_zero[static_cast<std::size_t>(o)]) {
        has_zero[static_cast<std::size_t>(o)] = assigned_[static_cast<std::size_t>(id)] = true;
        residue_[static_cast<std::size_t>(id)] = 0;
      }
    };
    to_zero(last_[0]);
    to_zero(last_[1]);
    for (int id = 0; id < 2 * steps_; ++id) {
      to_zero(id);
    }
    tries_ = 0;
    return assign(0, {}) && holds();
  }

  bool assign(int id, const Known& known) {
    constexpr long most_tries = 200'000;
    if (++tries_ > most_tries) {
      return false;
    }
    if (id == 2 * steps_) {
      known_ = known;
      for (int c = 0; c < orbits; ++c) {
        if (station(c).first < 0) {
          return false;
        }
      }
      return true;
    }
    const Step& step = chain_[static_cast<std::size_t>(id / 2)];
    const auto at = static_cast<std::size_t>(id);
    const bool settled = assigned_[at] || orbit(id) == fixed_orbit;
    const int first = below(2 * farthest + 1);
    for (int i = 0; i < (settled ? 1 : 2 * farthest + 1); ++i) {
      if (!assigned_[at]) {
        residue_[at] = settled ? 0 : (first + i) % (2 * farthest + 1) - farthest;
      }
      Known next = known;
      if (note(next, id, step.kept[0]) && note(next, id, step.kept[1]) &&
          (id % 2 == 0 || note(next, id, id - 1)) && assign(id + 1, next)) {
        return true;
      }
    }
    return false;
  }

  // Whether the difference of two points is one that is still wanted.
  bool note(Known& known, int one, int other) const {
    const int a = orbit(one);
    const int b = orbit(other);
    if (a == fixed_orbit || b == fixed_orbit) {
      return true;
    }
    const int c = a == b ? a : winner(a, b);
    Differences& of = known[static_cast<std::size_t>(c)][static_cast<std::size_t>(c == a ? b : a)];
    int d = residue(one) - residue(other);
    d = a == b ? std::abs(d) : c == a ? d : -d;
    const std::uint64_t bit = std::uint64_t{1} << (d + 31);
    const int reach = 2 * x_[static_cast<std::size_t>(c)];
    if (std::abs(d) > 30 || (of.there & bit) != 0 || (a == b && (d == 0 || d % 2 != 0))) {
      return false;
    }
    of.there |= bit;
    of.least = a == b ? 0 : std::min(of.least, d);
    of.most = std::max(of.most, d);
    return of.most - of.least <= reach;
  }

  // The step before which orbit c can pass, and its centre; −1 if there is none.
  [[nodiscard]] std::pair<int, int> station(int c) const {
    for (std::size_t t = 0; t < chain_.size(); ++t) {
      if (!keeps_beaten(chain_[t], c)) {
        continue;
      }
      std::array<int, 2> centres{};
      for (std::size_t i = 0; i < 2; ++i) {
        const int id = chain_[t].kept[i];
        centres[i] =
            known_[static_cast<std::size_t>(c)][static_cast<std::size_t>(orbit(id))].least +
            x_[static_cast<std::size_t>(c)] + residue(id);
      }
      if (centres[0] == centres[1]) {
        return {static_cast<int>(t), centres[0]};
      }
    }
    return {-1, 0};
  }

  // The points of block t as (orbit, residue).
  [[nodiscard]] std::vector<std::pair<int, int>> points(std::size_t t) const {
    std::vector<std::pair<int, int>> block;
    const Step& step = chain_[t];
    for (const int id : {step.kept[0], step.kept[1], step.entering[0], step.entering[1]}) {
      block.emplace_back(orbit(id), orbit(id) == fixed_orbit ? 0 : residue(id));
    }
    return block;
  }

  int fixed_;
  int total_;
  int steps_;
  std::array<int, orbits> x_{};
  std::array<std::array<int, most_orbits>, most_orbits> left_{};
  std::vector<int> orbit_;
  std::vector<int> residue_;
  std::vector<bool> assigned_;
  std::vector<Step> chain_;
  std::array<int, 2> last_{};
  int shift_ = 1;
  Known known_{};
  long nodes_ = 0;
  long tries_ = 0;
  Random random_;
  Clock::time_point end_;
};

template <typename T>
bool read(std::string_view text, T least, T most, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && value >= least &&
         value <= most;
}

}  // namespace
}  // namespace find_tournament

int main(int argc, char** argv) {
  using namespace find_tournament;
  int fixed = 0;
  int total = 0;
  std::uint64_t seed = 1;
  double seconds = 600;
  if (argc < 3 || argc > 5 || !read(argv[1], 0, 1, fixed) || !read(argv[2], 4, 20, total) ||
      (argc > 3 && !read(argv[3], std::uint64_t{0}, ~std::uint64_t{0}, seed)) ||
      (argc > 4 && !read(argv[4], 1.0, 1e6, seconds))) {
    std::fputs(
        "find_tournament: give FIXED, 0 or 1, TOTAL from 4 to 20, a SEED, SECONDS from 1 to "
        "1000000\n",
        stderr);
    return 2;
  }
  Search search(fixed, total, seed, seconds);
  if (!search.run()) {
    std::fprintf(stderr, "find_tournament: none found in %g s; try another seed or total\n",
                 seconds);
    return 1;
  }
  if (!search.print()) {
    std::fputs("find_tournament: the list could not be written\n", stderr);
    return 3;
  }
  return 0;
}
