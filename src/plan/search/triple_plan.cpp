#include "plan/search/triple_plan.hpp"

#include <algorithm>
#include <utility>

#include "changeover/run/control.hpp"
#include "plan/search/lists/lists.hpp"
#include "plan/search/lists/lists_plan.hpp"

namespace changeover {
namespace {

class GreedyForTriples {
 public:
  GreedyForTriples(const Job& job, RunControl& control)
      : job_(&job),
        control_(&control),
        fitting_(job),
        v_(job.names.size()),
        missing_(v_ * v_ * v_, 0),
        pairs_(v_ * v_, 0),
        left_(v_, 0),
        bench_(job.start) {
    for (const Triple& t : job.triples) {
      set(t, 1);
    }
  }

  Start run() {
    Start start{"greedy list", "always the step that tests most triples for its cost", {}};
    for (const Triple& t : job_->triples) {
      while (missing(t[0], t[1], t[2])) {
        const bool hasty = control_->stop_wanted();
        Block next = hasty || fitting_.has_slots() ? Block() : best_step();
        if (next.empty()) {
          next = around(t);
        }
        test(next);
        start.setups.push_back(next);
        bench_ = std::move(next);
      }
    }
    return start;
  }

 private:
  [[nodiscard]] bool missing(Element x, Element y, Element z) const {
    return missing_[(x * v_ + y) * v_ + z] != 0;
  }

  void set(Triple t, std::uint8_t value) {
    const auto by = [&](std::uint32_t& count) { value != 0 ? ++count : --count; };
    std::sort(t.begin(), t.end());
    do {
      missing_[(t[0] * v_ + t[1]) * v_ + t[2]] = value;
      if (t[1] < t[2]) {
        by(left_[t[0]]);
      }
      by(pairs_[t[0] * v_ + t[1]]);  // counts each ordered pair once
    } while (std::next_permutation(t.begin(), t.end()));
  }

  void test(const Block& setup) {
    for (std::size_t i = 0; i < setup.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t l = 0; l < j; ++l) {
          if (missing(setup[i], setup[j], setup[l])) {
            set({setup[i], setup[j], setup[l]}, 0);
          }
        }
      }
    }
  }

  [[nodiscard]] bool joins(const Block& setup, Element y) const {
    return std::none_of(setup.begin(), setup.end(),
                        [&](Element z) { return z == y || job_->never.contains(y, z); });
  }

  // The triples that y would add, and those that become possible.
  [[nodiscard]] std::uint64_t worth(const Block& setup, Element y) const {
    std::uint64_t triples = 0;
    std::uint64_t hope = left_[y];
    for (std::size_t i = 0; i < setup.size(); ++i) {
      hope += pairs_[setup[i] * v_ + y];
      for (std::size_t j = 0; j < i; ++j) {
        triples += missing(y, setup[i], setup[j]) ? 1U : 0U;
      }
    }
    return triples << 32U | hope;
  }

  void fill(Block& setup) const {
    while (setup.size() < job_->room()) {
      Element best = no_part;
      std::uint64_t most = 0;
      for (Element y = 0; y < v_; ++y) {
        if (left_[y] == 0 || !joins(setup, y)) {
          continue;
        }
        if (const std::uint64_t value = worth(setup, y); value > most) {
          most = value;
          best = y;
        }
      }
      if (best == no_part) {
        break;
      }
      setup.push_back(best);
    }
  }

  [[nodiscard]] Block best_step() const {
    Block best;
    double most = 0;
    const std::uint64_t room = job_->room() - job_->mounted.size();
    for (const std::uint64_t j :
         {std::uint64_t{1}, std::uint64_t{2}, std::uint64_t{3}, room / 2, room}) {
      if (j == 0 || j > room) {
        continue;
      }
      Block setup = job_->mounted;
      Block staying = bench_;
      std::stable_sort(staying.begin(), staying.end(),
                       [&](Element x, Element y) { return left_[x] > left_[y]; });
      for (const Element x : staying) {
        if (setup.size() + j < job_->room() && left_[x] > 0 && joins(setup, x)) {
          setup.push_back(x);
        }
      }
      fill(setup);
      std::uint64_t triples = 0;
      double cost = static_cast<double>(job_->test_cost.millionths) + 1.0;
      for (std::size_t i = 0; i < setup.size(); ++i) {
        const bool there = std::find(bench_.begin(), bench_.end(), setup[i]) != bench_.end();
        cost += there ? 0.0 : static_cast<double>(job_->change_costs[setup[i]].millionths);
        for (std::size_t l = 0; l < i; ++l) {
          for (std::size_t h = 0; h < l; ++h) {
            triples += missing(setup[i], setup[l], setup[h]) ? 1U : 0U;
          }
        }
      }
      if (static_cast<double>(triples) / cost > most) {
        most = static_cast<double>(triples) / cost;
        best = std::move(setup);
      }
    }
    return best;
  }

  // A set-up with these three parts, completed.
  [[nodiscard]] Block around(const Triple& t) const {
    Block setup = with_mounted(*job_, {t[0], t[1], t[2]});
    if (fitting_.has_slots()) {
      return fitting_.completed(setup, bench_)
          .value_or(setup);  // there is one, since the job has no defects
    }
    for (const Element y : bench_) {
      if (setup.size() < job_->room() && left_[y] > 0 && joins(setup, y)) {
        setup.push_back(y);
      }
    }
    return setup;
  }

  const Job* job_;
  RunControl* control_;
  Fitting fitting_;
  std::size_t v_;
  std::vector<std::uint8_t> missing_;  // by three parts, in any order
  std::vector<std::uint32_t> pairs_;   // by two parts: number of missing triples with both
  std::vector<std::uint32_t> left_;    // by part: number of missing triples with it
  Block bench_;
};

}  // namespace

Start greedy_for_triples(const Job& job, RunControl& control) {
  return GreedyForTriples(job, control).run();
}

RunPlan plan_for_triples(const Job& job, const PlanOptions& options, RunControl& control) {
  return plan_by_lists(
      job, options, control,
      {.sure = [&] { return std::vector<Start>{greedy_for_triples(job, control)}; },
       .more = [&] { return design_starts(job, 0, control); }});
}

}  // namespace changeover
