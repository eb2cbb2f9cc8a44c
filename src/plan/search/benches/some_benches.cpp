#include "plan/search/benches/some_benches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "changeover/run/control.hpp"
#include "core/bit_number.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "plan/job/pair_numbers.hpp"

namespace changeover {
namespace {

using Set = std::size_t;  // of working benches: bit w is bench w

class SomeBenches {
 public:
  SomeBenches(const BenchField& field, BenchBounds& bounds)
      : field_(&field),
        bounds_(&bounds),
        all_((Set{1} << field.size()) - 1),
        costs_(all_ + 1),
        reasons_(all_ + 1) {}

  void raise() {
    try {
      for (std::size_t size = field_->size() - 1; size > 0; --size) {
        for (Set set = 1; set < all_; ++set) {
          if (number_of_bits(set) == size) {
            stop_if_asked();
            look_at(set);
          }
        }
      }
    } catch (const Stopped&) {
      // the bounds so far are valid
    }
    add_up();
  }

 private:
  [[nodiscard]] bool has(Set set, std::size_t w) const { return (set >> w & 1U) != 0; }

  [[nodiscard]] std::string names(Set set) const {
    std::vector<std::string> all;
    for (std::size_t w = 0; w < field_->size(); ++w) {
      if (has(set, w)) {
        all.push_back(name_of(field_->benches(), number(w)));
      }
    }
    return joined(all, " and ");
  }

  [[nodiscard]] std::size_t number(std::size_t w) const {
    return static_cast<std::size_t>(&field_->bench(w) - field_->benches().data());
  }

  // The pairs that only benches of the set can test.
  [[nodiscard]] PairSet only_there(Set set) const {
    PairSet only(field_->asked().parts());
    field_->common().needed.for_each(all_of_them, [&](Element x, Element y) {
      bool elsewhere = false;
      for (std::size_t w = 0; w < field_->size(); ++w) {
        elsewhere = elsewhere || (!has(set, w) && field_->rest(w).needed.contains(x, y));
      }
      if (!elsewhere) {
        only.insert(x, y);
      }
    });
    return only;
  }

  void look_at(Set set) {
    Job job = field_->asked();
    job.needed = only_there(set);
    if (job.needed.size() == 0) {
      return;
    }
    std::vector<Bench> benches = field_->benches();
    for (std::size_t w = 0; w < field_->size(); ++w) {
      benches[number(w)].down = !has(set, w);
    }
    const BenchField there(job, benches, *field_);
    const BenchBounds found = bench_bounds(there);
    costs_[set] = found.cost.cost;
    reasons_[set] = fmt::format("{} can be tested by {} only, which costs at least {}: {}",
                                count_of(job.needed.size(), "pair"), names(set),
                                to_string(found.cost.cost), found.cost.reason);
    // The length of a day depends on all benches.
    const auto rests = [](const Bench& bench) { return bench.hours.has_value(); };
    if (found.makespan > bounds_->makespan && std::ranges::none_of(benches, rests)) {
      bounds_->makespan = found.makespan;
      bounds_->makespan_reason =
          fmt::format("{} can be tested by {} only: {}", count_of(job.needed.size(), "pair"),
                      names(set), found.makespan_reason);
    }
  }

  // The most that sets without a common bench cost together.
  void add_up() {
    for (Set set = 1; set <= all_; ++set) {
      for (Set part = (set - 1) & set; part > 0; part = (part - 1) & set) {
        if (const Amount sum = costs_[part] + costs_[set ^ part]; sum > costs_[set]) {
          costs_[set] = sum;
          const std::string& one = reasons_[part];
          const std::string& other = reasons_[set ^ part];
          reasons_[set] = one + (one.empty() || other.empty() ? "" : "; ") + other;
        }
      }
    }
    if (costs_[all_] > bounds_->cost.cost) {
      bounds_->cost.cost = costs_[all_];
      bounds_->cost.reason = reasons_[all_];
    }
  }

  const BenchField* field_;
  BenchBounds* bounds_;
  Set all_;
  std::vector<Amount> costs_;         // by set
  std::vector<std::string> reasons_;  // by set
};

}  // namespace

void raise_by_some_benches(const BenchField& field, BenchBounds& bounds) {
  constexpr std::size_t most_benches = 4;
  const Job& job = field.asked();
  if (job.model != nullptr && job.triples.empty() && !field.alike() && field.size() > 1 &&
      field.size() <= most_benches) {
    SomeBenches(field, bounds).raise();
  }
}

}  // namespace changeover
