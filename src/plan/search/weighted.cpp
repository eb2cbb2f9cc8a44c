#include "plan/search/weighted.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/each.hpp"
#include "plan/search/interchangeable.hpp"
#include "run/random.hpp"

namespace changeover {
namespace {

// A list with its cost and the time that its weight waits.
class Waiting {
 public:
  explicit Waiting(const Job& job)
      : job_(&job),
        parts_(job.names.size()),
        weight_(parts_ * parts_, 0.0),
        seen_(parts_ * parts_, 0),
        on_bench_(parts_, 0) {
    double typical = 0;  // so that tests count if nothing has a cost
    for (const Amount cost : job.change_costs) {
      typical = std::max(typical, static_cast<double>(cost.millionths));
    }
    a_test_ = std::max(static_cast<double>(job.test_cost.millionths), typical > 0 ? 0.0 : 1.0);
    job.needed.for_each(~std::uint64_t{0}, [&](Element x, Element y) {
      weight_[x * parts_ + y] = weight_[y * parts_ + x] =
          static_cast<double>(job.weights(x, y).millionths) * 1e-6;
    });
  }

  struct Figures {
    std::uint64_t cost = 0;  // of the changes, in millionths
    double waits = 0;
  };

  [[nodiscard]] Figures operator()(const std::vector<Block>& setups) {
    Figures figures;
    ++round_;
    double time = 0;
    // A part is mounted if its stamp is that of the set-up before.
    std::uint64_t stamp = ++stamp_;
    for (const Element x : job_->start) {
      on_bench_[x] = stamp;
    }
    for (std::size_t i = 0; i < setups.size(); ++i) {
      const Block& setup = setups[i];
      time += a_test_;
      coming_.clear();
      for (const Element x : setup) {
        if (on_bench_[x] != stamp) {
          coming_.push_back(x);
          figures.cost += job_->change_costs[x].millionths;
          time += static_cast<double>(job_->change_costs[x].millionths);
        }
      }
      for (const Element x : i == 0 ? setup : coming_) {
        for (const Element y : setup) {
          std::uint32_t& seen = seen_[x < y ? x * parts_ + y : y * parts_ + x];
          if (x != y && seen != round_) {
            seen = round_;
            figures.waits += time * weight_[x * parts_ + y];
          }
        }
      }
      stamp = ++stamp_;
      for (const Element x : setup) {
        on_bench_[x] = stamp;
      }
    }
    return figures;
  }

 private:
  const Job* job_;
  std::size_t parts_;
  double a_test_ = 0;
  std::vector<double> weight_;
  std::vector<std::uint32_t> seen_;  // by pair: the round in which it last met
  std::vector<std::uint64_t> on_bench_;
  std::uint64_t stamp_ = 0;
  std::uint32_t round_ = 0;
  Block coming_;
};

}  // namespace

std::vector<Block> heavy_first(const Job& job, const std::vector<Block>& setups,
                               RunControl& control) {
  if (setups.size() < 2) {
    return setups;
  }
  Waiting waiting(job);
  std::vector<std::vector<Element>> classes = interchangeable_parts(job);
  std::erase_if(classes, [](const std::vector<Element>& members) { return members.size() < 2; });
  const std::uint64_t places = sum_of(setups, [&](const Block& setup) { return setup.size(); });
  constexpr std::uint64_t work = 200'000'000;
  constexpr std::uint64_t most = 200'000;
  constexpr std::uint64_t each = 4;  // approximately, for each part of each set-up
  const std::uint64_t tries = std::min(most, work / (each * places * job.room()) + 1);
  Random random(control.seed(), 5'000'000);
  const auto below = [&](std::size_t n) { return random.below(static_cast<std::uint32_t>(n)); };
  std::vector<Block> best = setups;
  auto least = waiting(best);
  const std::uint64_t most_cost = least.cost;
  std::vector<Block> now;
  for (std::uint64_t i = 0; i < tries && !control.stop_wanted(); ++i) {
    now = best;
    const std::uint32_t kind = classes.empty() ? 1 + below(2) : below(4);
    if (kind == 1) {
      std::size_t first = below(now.size());
      std::size_t last = below(now.size());
      std::reverse(now.begin() + static_cast<std::ptrdiff_t>(std::min(first, last)),
                   now.begin() + static_cast<std::ptrdiff_t>(std::max(first, last)) + 1);
    } else if (kind == 2) {
      std::array<std::size_t, 3> cuts{below(now.size() + 1), below(now.size() + 1),
                                      below(now.size() + 1)};
      std::sort(cuts.begin(), cuts.end());
      std::rotate(now.begin() + static_cast<std::ptrdiff_t>(cuts[0]),
                  now.begin() + static_cast<std::ptrdiff_t>(cuts[1]),
                  now.begin() + static_cast<std::ptrdiff_t>(cuts[2]));
    } else {
      const std::vector<Element>& members = classes[below(classes.size())];
      const Element x = members[below(members.size())];
      const Element y = members[below(members.size())];
      for (Block& setup : now) {
        for (Element& z : setup) {
          z = z == x ? y : z == y ? x : z;
        }
      }
    }
    const auto figures = waiting(now);
    if (figures.cost <= most_cost && figures.waits <= least.waits) {
      least = figures;
      std::swap(best, now);
    }
  }
  for (Block& setup : best) {
    std::sort(setup.begin(), setup.end());
  }
  return best;
}

}  // namespace changeover
