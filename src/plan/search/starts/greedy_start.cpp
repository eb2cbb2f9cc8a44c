#include <algorithm>
#include <cstring>

#include "changeover/core/error.hpp"
#include "plan/job/fitting.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/search/listener.hpp"
#include "plan/search/starts/starts.hpp"

namespace changeover {
namespace {

class Greedy {
 public:
  Greedy(const Job& job, RunControl& control, bool by_price)
      : job_(&job),
        fitting_(job),
        listener_(control),
        parts_(job.names.size()),
        room_(job.room()),
        missing_(parts_ * parts_, 0),
        left_(parts_, 0),
        on_bench_(parts_, false),
        gains_(parts_),
        blocked_(parts_) {
    if (by_price) {
      double total = 0;
      for (const Amount cost : job.change_costs) {
        total += static_cast<double>(cost.millionths);
      }
      constexpr double little =
          0.02;  // of the mean, so that free parts are not preferred absolutely
      const double least = std::max(1.0, little * total / static_cast<double>(parts_));
      for (const Amount cost : job.change_costs) {
        worth_.push_back(1.0 / (least + static_cast<double>(cost.millionths)));
      }
    }
    job.needed.for_each(all_of_them, [&](Element x, Element y) {
      missing_[x * parts_ + y] = missing_[y * parts_ + x] = 1;
      ++left_[x];
      ++left_[y];
      ++missing_pairs_;
    });
    if (job.never.size() > 0) {
      never_.assign(parts_ * parts_, 0);
      job.never.for_each(all_of_them, [&](Element x, Element y) {
        never_[x * parts_ + y] = never_[y * parts_ + x] = 1;
      });
    }
    for (Element x = 0; x < parts_; ++x) {
      slotless_ += fitting_.slot(x) == fitting_.slots() ? 1U : 0U;
    }
    put_on_bench(job.start);
  }

  Start run() {
    Start start{"greedy list", "always the step that tests most pairs for its cost", {}};
    if (!worth_.empty()) {
      start.how += ", of cheap parts where it can";
    }
    while (missing_pairs_ > 0) {
      const bool in_haste = listener_.stop_wanted(parts_ * room_);
      Block next = in_haste ? Block() : best_step();
      if (next.empty()) {
        next = forced_step(in_haste);
      }
      test(next);
      put_on_bench(next);
      start.setups.push_back(std::move(next));
    }
    if (listener_.stop_wanted(0)) {
      start.how = "steps that test most pairs for their cost, and in the end any that test some";
    }
    return start;
  }

 private:
  [[nodiscard]] const std::uint8_t* missing_with(Element x) const { return &missing_[x * parts_]; }
  [[nodiscard]] bool missing(Element x, Element y) const { return missing_with(x)[y] != 0; }

  void put_on_bench(const Block& setup) {
    for (const Element x : bench_) {
      on_bench_[x] = false;
    }
    bench_ = setup;
    for (const Element x : bench_) {
      on_bench_[x] = true;
    }
  }

  // Excludes x and the parts that it must not meet from now on.
  void block_around(Element x) {
    blocked_[x] = 1;
    if (!never_.empty()) {
      for (std::size_t y = 0; y < parts_; ++y) {
        blocked_[y] |= never_[x * parts_ + y];
      }
    }
  }

  void block_around_all(const Block& setup) {
    std::fill(blocked_.begin(), blocked_.end(), std::uint8_t{0});
    for (const Element x : setup) {
      block_around(x);
    }
  }

  void test(const Block& setup) {
    Block open;  // the others have met all their partners
    std::copy_if(setup.begin(), setup.end(), std::back_inserter(open),
                 [&](Element x) { return left_[x] > 0; });
    for (const Element x : open) {
      for (const Element y : open) {
        if (missing(x, y)) {
          missing_[x * parts_ + y] = missing_[y * parts_ + x] = 0;
          --left_[x];
          --left_[y];
          --missing_pairs_;
        }
      }
    }
  }

  // Counts the parts of each slot in the current set-up, and how many it lacks.
  void count_slots(const Block& setup) {
    in_slot_.assign(fitting_.slots() + 1, 0);
    lacking_ = 0;
    for (const Element x : setup) {
      ++in_slot_[fitting_.slot(x)];
    }
    for (std::size_t s = 0; s < fitting_.slots(); ++s) {
      lacking_ += fitting_.least(s) - std::min(fitting_.least(s), in_slot_[s]);
    }
  }

  // Whether y can join a set-up of this size so that there is room left for what its slots lack.
  [[nodiscard]] bool slots_allow(std::size_t size, Element y) const {
    if (!fitting_.has_slots()) {
      return true;
    }
    const std::size_t s = fitting_.slot(y);
    const bool fills = in_slot_[s] < fitting_.least(s);
    return (s == fitting_.slots() || in_slot_[s] < fitting_.most(s)) &&
           (fills || size + 1 + lacking_ <= room_);
  }

  void note_joined(Element y) {
    if (fitting_.has_slots()) {
      const std::size_t s = fitting_.slot(y);
      lacking_ -= in_slot_[s]++ < fitting_.least(s) ? 1U : 0U;
    }
  }

  // The same, and whether y is neither there nor excluded by a part.
  [[nodiscard]] bool may_join(const Block& setup, Element y) const {
    return slots_allow(setup.size(), y) && std::none_of(setup.begin(), setup.end(), [&](Element x) {
             return x == y || (!never_.empty() && never_[x * parts_ + y] != 0);
           });
  }

  // The most parts that can join a set-up of this size, given the limits of its slots.
  [[nodiscard]] std::uint64_t most_more(std::size_t size) const {
    std::uint64_t more = slotless_;
    for (std::size_t s = 0; s < fitting_.slots(); ++s) {
      more += fitting_.most(s) - std::min(fitting_.most(s), in_slot_[s]);
    }
    return std::min<std::uint64_t>(room_ - std::min<std::uint64_t>(room_, size), more);
  }

  // The parts to keep when there must be room for j more: the mounted parts, and those with the
  // most pairs left.
  [[nodiscard]] Block kept(std::uint64_t j) {
    Block candidates = bench_;
    std::stable_sort(candidates.begin(), candidates.end(),
                     [&](Element x, Element y) { return left_[x] > left_[y]; });
    Block setup = job_->mounted;
    block_around_all(setup);
    count_slots(setup);
    for (const Element x : candidates) {
      if (setup.size() + j < room_ && left_[x] > 0 && blocked_[x] == 0 &&
          slots_allow(setup.size(), x)) {
        setup.push_back(x);
        note_joined(x);
        block_around(x);
      }
    }
    return setup;
  }

  void count_gains_of(Element x) {
    const std::uint8_t* const row = missing_with(x);
    for (std::size_t y = 0; y < parts_; ++y) {
      gains_[y] += row[y];
    }
  }

  // Adds parts while there is room, always the one that meets most, and those that the slots lack;
  // returns the number of pairs tested, 0 if the slots cannot be filled.
  std::uint64_t fill(Block& setup) {
    const std::uint64_t pairs = fill_up(setup);
    if (lacking_ == 0) {
      return pairs;
    }
    const auto whole = fitting_.completed(setup, bench_);
    setup = whole.value_or(Block{});
    return whole ? pairs : 0;
  }

  std::uint64_t fill_up(Block& setup) {
    std::fill(gains_.begin(), gains_.end(), 0U);
    block_around_all(setup);
    count_slots(setup);
    for (const Element x : setup) {
      if (left_[x] > 0) {
        count_gains_of(x);
      }
    }
    std::uint64_t pairs = 0;  // each pair is counted at both ends
    for (const Element x : setup) {
      pairs += gains_[x];
    }
    pairs /= 2;
    while (setup.size() < room_) {
      // Largest gain first (per cost or not), then most pairs left, then the first.
      Element best = 0;
      double most = 0;
      for (Element y = 0; y < parts_; ++y) {
        const double value = value_of(y);
        if (value > most && blocked_[y] == 0 && left_[y] > 0 && slots_allow(setup.size(), y)) {
          best = y;
          most = value;
        }
      }
      if (most == 0 || (gains_[best] == 0 && pairs > 0)) {
        break;
      }
      pairs += gains_[best];
      setup.push_back(best);
      note_joined(best);
      block_around(best);
      count_gains_of(best);
    }
    return pairs;
  }

  // The value of a part for the current set-up: positive if it has a pair left.
  [[nodiscard]] double value_of(Element y) const {
    constexpr double more_than_any_left = 4096;
    const double value = static_cast<double>(gains_[y]) * more_than_any_left + left_[y];
    return worth_.empty() ? value : value * worth_[y];
  }

  [[nodiscard]] double cost(const Block& setup) const {
    double total = static_cast<double>(job_->test_cost.millionths) + 1.0;
    for (const Element x : setup) {
      if (!on_bench_[x]) {
        total += static_cast<double>(job_->change_costs[x].millionths);
      }
    }
    return total;
  }

  // The step with the most new pairs for its cost; empty if the examined steps have none, or if
  // stopped.
  [[nodiscard]] Block best_step() {
    // Prices need a closer examination, as long as that is fast.
    constexpr std::size_t few_parts = 300;
    const std::uint64_t small = !worth_.empty() && parts_ <= few_parts ? 16 : 4;
    Block best;
    double best_ratio = 0;
    const std::uint64_t room = room_ - job_->mounted.size();
    for (std::uint64_t j = 0; j <= room; ++j) {
      if (j > small && j != room && j != room / 2) {
        continue;
      }
      if (listener_.stop_wanted(room_ * parts_)) {
        break;
      }
      Block setup = kept(j);
      const std::uint64_t pairs = fill(setup);
      const double ratio = static_cast<double>(pairs) / cost(setup);
      if (pairs > 0 && ratio > best_ratio) {
        best_ratio = ratio;
        best = std::move(setup);
      }
    }
    return best;
  }

  // The first missing pair, completed to a set-up.
  [[nodiscard]] Block forced_step(bool in_haste) {
    while (left_[first_open_] == 0) {
      ++first_open_;
    }
    const std::uint8_t* const row = missing_with(first_open_);
    const auto other =
        static_cast<Element>(static_cast<const std::uint8_t*>(std::memchr(row, 1, parts_)) - row);
    auto whole = fitting_.completed(with_mounted(*job_, {first_open_, other}), bench_);
    if (!whole) {
      throw InternalError("a pair that can meet, for the job was checked, is in no set-up");
    }
    Block setup = *std::move(whole);
    // If one more part fits, there are many set-ups; examining all parts for each of them would
    // take too long after a request to stop.
    count_slots(setup);
    if (in_haste && most_more(setup.size()) == 1) {
      add_open_partners(setup, other);
    } else if (setup.size() < room_) {
      fill(setup);
    }
    return setup;
  }

  // Adds parts that the first open part still has to meet, while there is room; preferably those
  // that the last one still has to meet, too. O(parts), and far less on average.
  void add_open_partners(Block& setup, Element last) {
    const std::uint8_t* const row = missing_with(first_open_);
    for (const bool both : {true, false}) {
      for (Element y = last + 1; y < parts_ && setup.size() < room_; ++y) {
        if (row[y] != 0 && (!both || missing(last, y)) && may_join(setup, y)) {
          setup.push_back(y);
          note_joined(y);
          last = y;
        }
      }
    }
  }

  const Job* job_;
  Fitting fitting_;
  Listener listener_;
  std::size_t parts_;
  std::uint64_t room_;
  std::vector<std::uint8_t> missing_;  // a row per part: the parts that it still has to meet
  std::vector<std::uint8_t> never_;    // likewise; empty if there are no forbidden pairs
  std::vector<std::uint32_t> left_;    // by part: number of pairs left
  std::uint64_t missing_pairs_ = 0;
  Element first_open_ = 0;  // no part before it has a missing pair
  Block bench_;
  std::vector<bool> on_bench_;
  std::vector<double> worth_;           // by part, if prices count: less for expensive parts
  std::vector<std::uint32_t> gains_;    // by part: missing pairs with the current set-up
  std::vector<std::uint64_t> in_slot_;  // by slot, in the current set-up
  std::uint64_t slotless_ = 0;          // parts in no slot
  std::uint64_t lacking_ = 0;           // in the slots of the current set-up
  std::vector<std::uint8_t> blocked_;   // by part: in the current set-up, or excluded from it
};

// The rounded cost of a list: for comparisons, not for output.
double weight(const Job& job, const Start& start) {
  double total =
      static_cast<double>(job.test_cost.millionths) * static_cast<double>(start.setups.size());
  std::vector<std::size_t> last(job.names.size(),
                                0);  // by part: number of the last set-up with it
  for (const Element x : job.start) {
    last[x] = 1;
  }
  for (std::size_t i = 0; i < start.setups.size(); ++i) {
    for (const Element x : start.setups[i]) {
      total += last[x] == i + 1 ? 0.0 : static_cast<double>(job.change_costs[x].millionths);
      last[x] = i + 2;
    }
  }
  return total;
}

}  // namespace

Start greedy_start(const Job& job, RunControl& control) {
  Start plain = Greedy(job, control, false).run();
  const bool one_price = std::all_of(job.change_costs.begin(), job.change_costs.end(),
                                     [&](Amount cost) { return cost == job.change_costs.front(); });
  if (one_price || control.stop_wanted()) {
    return plain;
  }
  Start priced = Greedy(job, control, true).run();
  return weight(job, priced) < weight(job, plain) ? priced : plain;
}

}  // namespace changeover
