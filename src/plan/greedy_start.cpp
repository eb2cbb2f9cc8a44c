#include <algorithm>
#include <limits>
#include <numeric>

#include "plan/starts.hpp"

namespace changeover::plan_detail {
namespace {

class Greedy {
 public:
  explicit Greedy(const Job& job) : job_(&job), parts_(job.names.size()), left_(parts_, 0) {
    missing_.assign(parts_ * parts_, false);
    job.needed.for_each(std::numeric_limits<std::uint64_t>::max(), [&](Element x, Element y) {
      missing_[x * parts_ + y] = missing_[y * parts_ + x] = true;
      ++left_[x];
      ++left_[y];
      ++missing_pairs_;
    });
    bench_ = job.start;
  }

  std::vector<Block> run() {
    std::vector<Block> setups;
    while (missing_pairs_ > 0) {
      Block next = best_step();
      if (next.empty()) {
        next = forced_step();
      }
      test(next);
      setups.push_back(next);
      bench_ = next;
    }
    return setups;
  }

 private:
  [[nodiscard]] bool missing(Element x, Element y) const { return missing_[x * parts_ + y]; }
  [[nodiscard]] bool fits(const Block& setup, Element x) const {
    return std::none_of(setup.begin(), setup.end(),
                        [&](Element z) { return z == x || job_->never.contains(z, x); });
  }
  [[nodiscard]] std::uint64_t gain(const Block& setup, Element x) const {
    std::uint64_t pairs = 0;
    for (const Element z : setup) {
      pairs += missing(z, x) ? 1U : 0U;
    }
    return pairs;
  }

  void test(const Block& setup) {
    for (const Element x : setup) {
      for (const Element y : setup) {
        if (missing(x, y)) {
          missing_[x * parts_ + y] = missing_[y * parts_ + x] = false;
          --left_[x];
          --left_[y];
          --missing_pairs_;
        }
      }
    }
  }

  // What is kept when room for j more is wanted: the mounted parts and those with most left to meet.
  [[nodiscard]] Block kept(std::uint64_t j) const {
    Block candidates = bench_;
    std::stable_sort(candidates.begin(), candidates.end(),
                     [&](Element x, Element y) { return left_[x] > left_[y]; });
    Block setup = job_->mounted;
    for (const Element x : candidates) {
      if (setup.size() + j < job_->at_once && left_[x] > 0 && fits(setup, x)) {
        setup.push_back(x);
      }
    }
    return setup;
  }

  // Adds parts while there is room, always the one that meets most; returns the pairs tested.
  std::uint64_t fill(Block& setup, std::uint64_t room) const {
    std::vector<std::uint64_t> gains(parts_, 0);
    std::uint64_t pairs = 0;
    for (std::size_t i = 0; i < setup.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        pairs += missing(setup[i], setup[j]) ? 1U : 0U;
      }
      for (Element y = 0; y < parts_; ++y) {
        gains[y] += missing(setup[i], y) ? 1U : 0U;
      }
    }
    for (; room > 0 && setup.size() < job_->at_once; --room) {
      Element best = 0;
      bool found = false;
      for (Element y = 0; y < parts_; ++y) {
        const bool better =
            !found || gains[y] > gains[best] || (gains[y] == gains[best] && left_[y] > left_[best]);
        if (left_[y] > 0 && better && fits(setup, y)) {
          best = y;
          found = true;
        }
      }
      if (!found || (gains[best] == 0 && pairs > 0)) {
        break;
      }
      pairs += gains[best];
      setup.push_back(best);
      for (Element y = 0; y < parts_; ++y) {
        gains[y] += missing(best, y) ? 1U : 0U;
      }
    }
    return pairs;
  }

  [[nodiscard]] double cost(const Block& setup) const {
    double total = static_cast<double>(job_->test_cost.millionths) + 1.0;
    for (const Element x : setup) {
      if (std::find(bench_.begin(), bench_.end(), x) == bench_.end()) {
        total += static_cast<double>(job_->change_costs[x].millionths);
      }
    }
    return total;
  }

  // The step with most new pairs for its cost; empty if those that are looked at have none.
  [[nodiscard]] Block best_step() const {
    constexpr std::uint64_t small = 4;
    Block best;
    double best_ratio = 0;
    const std::uint64_t room = job_->at_once - job_->mounted.size();
    for (std::uint64_t j = 0; j <= room; ++j) {
      if (j > small && j != room && j != room / 2) {
        continue;
      }
      Block setup = kept(j);
      const std::uint64_t pairs = fill(setup, job_->at_once - setup.size());
      const double ratio = static_cast<double>(pairs) / cost(setup);
      if (pairs > 0 && ratio > best_ratio) {
        best_ratio = ratio;
        best = setup;
      }
    }
    return best;
  }

  // The first missing pair, with what else fits.
  [[nodiscard]] Block forced_step() const {
    const auto place = static_cast<std::size_t>(std::find(missing_.begin(), missing_.end(), true) -
                                                missing_.begin());
    Block setup = job_->mounted;
    for (const std::size_t x : {place / parts_, place % parts_}) {
      if (std::find(setup.begin(), setup.end(), x) == setup.end()) {
        setup.push_back(static_cast<Element>(x));
      }
    }
    fill(setup, job_->at_once - setup.size());
    return setup;
  }

  const Job* job_;
  std::size_t parts_;
  std::vector<bool> missing_;
  std::vector<std::uint64_t> left_;  // by part: pairs it has yet to meet
  std::uint64_t missing_pairs_ = 0;
  Block bench_;
};

}  // namespace

Start greedy_start(const Job& job) {
  return {"greedy list", "always the step that tests most pairs for its cost", Greedy(job).run()};
}

}  // namespace changeover::plan_detail
