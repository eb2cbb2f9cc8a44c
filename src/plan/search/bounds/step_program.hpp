// The linear program of Theorems 18 and 28 (docs/theorems.md): how often each part comes, how many
// tests there are, and how often a step is of each kind. With costs by what is replaced, it also
// says how often each part takes the place of which.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "changeover/plan/job.hpp"
#include "plan/search/bounds/costliest_parts.hpp"
#include "plan/search/bounds/costly_walk.hpp"
#include "plan/search/bounds/job_numbers.hpp"
#include "plan/search/bounds/least_sum.hpp"
#include "plan/search/bounds/step_groups.hpp"

namespace changeover {

__extension__ using WholeCost = __int128;

/// A part that takes the place of another; by their numbers in JobNumbers::parts.
struct Exchange {
  std::size_t out = 0;
  std::size_t in = 0;
};

/// What the program says where costs depend on what is replaced, in millionths: Theorem 20.
struct ExchangePrices {
  struct Entry {
    std::vector<bool> parts;  // by number
    double price = 0;
  };
  std::vector<double> out;  // by number: what it costs more to take the place of a part
  std::vector<Entry> entries;
};

/// The `parts` most expensive parts come `times` times in all, those at the start not counted.
struct CostlyTimes {
  std::size_t parts = 0;
  std::uint64_t times = 0;
};

/// Columns: by part, how often it comes beyond once; tests beyond the least number; by block and
/// kind, steps; where costs depend on what is replaced, by exchange, how often there is one, and
/// by part, how often it comes to an empty place.
class StepProgram {
 public:
  /// Costs are one a part, those of `parts`; with `exchanges`, what the job says of these, and of
  /// what comes to an empty place. Not copied: `parts`.
  StepProgram(const Job& job, const JobNumbers& n, const CostliestParts& parts,
              std::uint64_t least_tests, std::vector<Exchange> exchanges = {})
      : q_(&parts),
        v_(parts.parts.size()),
        least_tests_(least_tests),
        counted_(job, n, parts),
        exchanges_(std::move(exchanges)) {
    set_costs(job);
    add_first_rows();
    add_exchanges(job);
    set_walks(job, n);
  }

  /// @throws Stopped
  void solve(double enough = 0) {
    constexpr int most_rounds = 60;
    for (int round = 0; round < most_rounds && !full_; ++round) {
      if (program_->solve(work_, enough) != LeastSum::End::solved || !add_violated()) {
        return;
      }
    }
    if (full_) {
      static_cast<void>(program_->solve(work_, enough));
    }
  }

  [[nodiscard]] double tests() const {
    return static_cast<double>(least_tests_) + program_->value(v_);
  }
  [[nodiscard]] double introductions() const {
    double all = static_cast<double>(v_ - starts_);
    for (std::size_t x = 0; x < v_; ++x) {
      all += program_->value(x);
    }
    return all;
  }
  /// Parts that come together, in the last table, a number of times that is not whole.
  struct Broken {
    std::vector<std::size_t> parts = {};
    double times = 0;
  };
  /// The parts of a group, or else a single part; nullopt if all these numbers are whole, and where
  /// there is one group.
  [[nodiscard]] std::optional<Broken> broken() const;
  void come_at_most(const std::vector<std::size_t>& parts, std::uint64_t times);
  void come_at_least(const std::vector<std::size_t>& parts, std::uint64_t times);
  /// The numbers in the table, as one pivot computes them.
  [[nodiscard]] std::uint64_t numbers() const { return rows_.size() * (counted_.columns() + 1); }
  void tests_at_most(std::uint64_t tests) { add({{v_, -1}}, -static_cast<std::int64_t>(tests)); }
  void tests_at_least(std::uint64_t tests) { add({{v_, 1}}, static_cast<std::int64_t>(tests)); }

  /// What the prices of the rows prove, in whole numbers; not with exchanges.
  /// @throws ImpossibleParameters if it overflows.
  [[nodiscard]] Amount proved() const;
  [[nodiscard]] ExchangePrices exchange_prices() const;
  /// What Theorem 28 adds to this, if it adds something.
  [[nodiscard]] std::optional<CostlyTimes> costly_times() const;
  /// This cost in the unit of the program.
  [[nodiscard]] double in_program(Amount cost) const {
    return (static_cast<double>(cost.millionths) - static_cast<double>(base_)) / unit_;
  }

 private:
  struct SavedRow {
    LeastSum::Row terms;
    std::int64_t least = 0;
  };

  // Parts that come at least so often together, and what that is more than they come.
  struct SideBySide {
    std::vector<std::size_t> parts = {};
    double open = 0;
    std::int64_t least = 0;
  };

  // The most expensive parts; `open` as long as it may be proved that they come more often.
  struct Costliest {
    std::vector<std::size_t> parts = {};
    CostlyWalk walk = {};
    std::uint64_t starts = 0;
    bool open = true;
    std::uint64_t times = 0;  // what the row says
    std::optional<std::size_t> row = {};
  };

  void set_costs(const Job& job);
  void set_walks(const Job& job, const JobNumbers& n);
  void add_first_rows();
  bool add_violated();
  bool add_staying(std::size_t a, std::size_t b);
  bool add_subsets(std::size_t a, std::size_t b);
  bool add_side_by_side();
  [[nodiscard]] SideBySide side_by_side(std::vector<std::vector<std::size_t>> sets);
  [[nodiscard]] std::vector<std::size_t> by_times(std::size_t group) const;
  bool add_occupied(const std::vector<std::size_t>& parts, std::uint64_t in_a_test);
  bool add_few_stays();
  bool add_costliest();
  void add_exchanges(const Job& job);
  bool add_entries();
  bool add_entry(std::size_t to);

  // A violated row, unless the table is full: a bound with fewer rows is one, too.
  bool add_if_room(LeastSum::Row terms, std::int64_t least);

  // A row in introductions, tests and steps: the columns count what is beyond the least.
  void add(LeastSum::Row terms, std::int64_t least) {
    for (const LeastSum::Term& term : terms) {
      least -= term.column < v_    ? term.factor
               : term.column == v_ ? term.factor * static_cast<std::int64_t>(least_tests_)
                                   : 0;
    }
    program_->add(terms, least);
    rows_.push_back({std::move(terms), least});
  }

  [[nodiscard]] double times(std::size_t x) const { return 1.0 + program_->value(x); }
  [[nodiscard]] std::size_t exchange_column(std::size_t exchange) const {
    return counted_.columns() + exchange;
  }
  [[nodiscard]] std::size_t empty_column(std::size_t x) const {
    return counted_.columns() + exchanges_.size() + x;
  }

  const CostliestParts* q_;
  std::size_t v_;
  std::uint64_t least_tests_;
  StepGroups counted_;
  std::uint64_t starts_ = 0;          // parts that are there at the start
  std::vector<std::uint64_t> costs_;  // by column that costs something
  WholeCost base_ = 0;                // of each part once and the least number of tests
  double unit_ = 1;                   // of the program, in millionths
  std::uint64_t most_times_ = 0;      // no column is larger
  std::uint64_t work_ = 1'500'000'000;
  std::optional<LeastSum> program_;
  std::vector<SavedRow> rows_;
  bool full_ = false;
  std::vector<Costliest> walks_;
  std::uint64_t walk_states_ = 20'000;
  std::vector<std::size_t> steps_rows_;  // by block: the row that counts its steps
  std::vector<Exchange> exchanges_;
  std::vector<std::size_t> out_rows_;                             // by part, if there are any
  std::vector<std::pair<std::vector<bool>, std::size_t>> entry_;  // parts, and the row
};

}  // namespace changeover
