// The independent check of plans for several benches: it reads the job, the benches and the
// schedule, counts in the plainest way, and shares no code with the planner.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "changeover/core/error.hpp"
#include "changeover/plan/benches.hpp"
#include "core/checked.hpp"
#include "core/contains.hpp"
#include "core/each.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

Amount times_factor(Amount cost, Amount factor) {
  constexpr std::uint64_t one = 1'000'000;
  const Wide product = Wide{cost.millionths} * factor.millionths;
  if (product % one != 0 || product / one > Wide{1} << 62U) {
    throw InternalError("a change cost times the factor of a bench is not an amount");
  }
  return Amount{static_cast<std::uint64_t>(product / one)};
}

// The task of one bench, with what is left to be tested.
Job question_of(const Job& left, const Bench& bench) {
  Job own = left;
  own.at_once = bench.at_once.value_or(left.at_once);
  own.test_cost = bench.test_cost.value_or(left.test_cost);
  for (Amount& cost : own.change_costs) {
    cost = times_factor(cost, bench.change_factor);
  }
  for (Amount& cost : own.replace_costs) {
    cost = times_factor(cost, bench.change_factor);
  }
  for (const Slot& limit : bench.slots) {
    for (Slot& slot : own.slots) {
      slot = slot.name == limit.name ? limit : slot;
    }
  }
  own.mounted = bench.mounted.value_or(left.mounted);
  own.start = bench.start.value_or(left.start);
  own.first = bench.first.value_or(left.first);
  own.tests_done = bench.tests_done;
  own.last_step = bench.last_step;
  return own;
}

// A part on a bench, with begin and end.
struct Held {
  Element part = 0;
  std::size_t bench = 0;
  Amount from;
  Amount to;
};

class BenchReferee {
 public:
  BenchReferee(const Job& job, const std::vector<Bench>& benches, const BenchSchedule& schedule)
      : job_(&job), benches_(&benches), schedule_(&schedule), left_(job) {
    if (schedule.size() != benches.size()) {
      throw BadInput(fmt::format("{} for {}", count_of(schedule.size(), "list"),
                                 count_of(benches.size(), "bench", "benches")));
    }
    for (const Bench& bench : benches) {
      day_ = bench.down ? day_ : std::max(day_, hours_of(bench));
    }
  }

  BenchCount run() {
    count_.benches = *benches_;
    count_.schedule = *schedule_;
    count_.pairs_needed = job_->needed.size();
    count_.triples_needed = job_->triples.size();
    job_->needed.for_each(~std::uint64_t{0}, [&](Element x, Element y) {
      count_.weight_needed += job_->weights.empty() ? Amount{} : job_->weights(x, y);
    });
    for (std::size_t bench = 0; bench < benches_->size(); ++bench) {
      count_bench(bench);
    }
    check_stock();
    return std::move(count_);
  }

 private:
  static constexpr Amount whole_day{24'000'000};

  [[nodiscard]] Amount hours_of(const Bench& bench) const {
    return cost_of(bench.hours.value_or(whole_day));
  }

  // The cost of a number of hours.
  [[nodiscard]] Amount cost_of(Amount hours) const {
    const std::uint64_t unit = job_->cost_unit == CostUnit::minutes   ? 60
                               : job_->cost_unit == CostUnit::seconds ? 3600
                                                                      : 1;
    return hours * unit;
  }

  [[nodiscard]] std::string name(std::size_t bench) const { return name_of(*benches_, bench); }

  void fault(std::size_t bench, const std::string& what) {
    count_.faults.push_back(fmt::format("{}: {}", name(bench), what));
  }

  void count_bench(std::size_t number) {
    const Bench& bench = (*benches_)[number];
    const std::vector<BenchStep>& steps = (*schedule_)[number];
    if (bench.down && !steps.empty()) {
      fault(number, "it is down, and has tests");
    }
    const Job own = question_of(left_, bench);
    const std::vector<Block> setups = each_of<Block>(steps, &BenchStep::setup);
    RunSheet sheet = run_sheet(own, setups);
    for (const std::string& what : sheet.faults) {
      const bool needs_none = bench.down && steps.empty();  // not even the first ones
      if (!needs_none) {
        fault(number, what);
      }
    }
    check_parts(number, sheet);
    put_in_again(number, own, sheet);
    set_times(number, sheet);
    hold(number, own, sheet);
    forget_tested(sheet);
    count_.tests += sheet.steps.size();
    count_.changes += sheet.changes;
    count_.cost += sheet.cost;
    count_.pairs_tested += sheet.pairs_tested;
    count_.triples_tested += sheet.triples_tested;
    count_.weight_tested += sheet.weight_tested;
    count_.sheets.push_back(std::move(sheet));
  }

  // Checks for parts that the bench cannot have.
  void check_parts(std::size_t number, const RunSheet& sheet) {
    const Bench& bench = (*benches_)[number];
    for (std::size_t i = 0; i < sheet.steps.size(); ++i) {
      for (const Element x : sheet.steps[i].setup) {
        const bool there_is_none =
            x < job_->quantities.size() && job_->quantities[x] == 0 && !contains(bench.own, x);
        if (contains(bench.without, x) || there_is_none) {
          fault(number, fmt::format("set-up {} has {}, which the bench cannot have",
                                    i + 1 + bench.steps_before(), job_->names[x]));
        }
      }
    }
  }

  // Parts that were given up during a wait are taken out and put in once more.
  void put_in_again(std::size_t number, const Job& own, RunSheet& sheet) {
    Amount more;
    Block before = own.start;
    for (std::size_t i = 0; i < sheet.steps.size(); ++i) {
      RunStep& step = sheet.steps[i];
      for (const Element x : (*schedule_)[number][i].again) {
        if (!contains(before, x) || !contains(step.setup, x) || contains(step.put_in, x)) {
          fault(number, fmt::format("set-up {} puts in again what did not stay",
                                    i + 1 + own.steps_before()));
          continue;
        }
        step.put_in.push_back(x);
        step.take_out.push_back(x);
        step.cost += own.change_costs[x];
        more += own.change_costs[x];
        sheet.change_cost += own.change_costs[x];
        sheet.cost += own.change_costs[x];
        ++sheet.changes;
      }
      std::ranges::sort(step.put_in);
      std::ranges::sort(step.take_out);
      step.cost_so_far += more;
      before = step.setup;
    }
  }

  // Sets times: each step after the one before, within the hours of the bench.
  void set_times(std::size_t number, const RunSheet& sheet) {
    const Bench& bench = (*benches_)[number];
    const std::uint64_t day = day_.millionths;
    const std::uint64_t hours = hours_of(bench).millionths;
    const bool rests = hours < cost_of(whole_day).millionths;
    std::vector<StepTime>& times = count_.times.emplace_back();
    Amount free;
    for (std::size_t i = 0; i < sheet.steps.size(); ++i) {
      const Amount begin = (*schedule_)[number][i].begin;
      Amount left = sheet.steps[i].cost;
      const auto step = [&] { return fmt::format("step {}", i + 1 + bench.steps_before()); };
      if (begin < free) {
        fault(number, fmt::format("{} begins at {}, before the one before it ends at {}", step(),
                                  to_string(begin), to_string(free)));
      }
      Amount end = begin + left;
      if (rests && left.millionths > hours) {
        if (begin.millionths % day != 0) {
          fault(number, step() + ", longer than a day, does not begin in the morning");
        }
        const std::uint64_t days = (left.millionths - 1) / hours;  // full days
        left = left - Amount{hours} * days;
        end = begin + Amount{day} * days + left;
      } else if (rests && begin.millionths % day + left.millionths > hours) {
        const std::string length = to_string(bench.hours.value_or(Amount{}));
        fault(number, fmt::format("{} ends after the {} hour{} of a day", step(), length,
                                  length == "1" ? "" : "s"));
      }
      times.push_back({begin, end});
      free = end;
      count_.makespan = std::max(count_.makespan, end);
    }
  }

  // Records when a part is on a bench: while it stays and is not given up.
  void hold(std::size_t number, const Job& own, const RunSheet& sheet) {
    const std::vector<StepTime>& times = count_.times[number];
    for (std::size_t i = 0; i < sheet.steps.size(); ++i) {
      for (const Element x : sheet.steps[i].setup) {
        const bool stays = !contains(sheet.steps[i].put_in, x);
        Held* const before = stays ? last_hold(number, x) : nullptr;
        if (before != nullptr) {
          before->to = times[i].end;
        } else {
          // Parts that stay from the start are held from the beginning.
          const bool from_start = stays && i == 0 && contains(own.start, x);
          held_.push_back({x, number, from_start ? Amount{} : times[i].begin, times[i].end});
        }
      }
    }
  }

  Held* last_hold(std::size_t bench, Element x) {
    for (auto held = held_.rbegin(); held != held_.rend(); ++held) {
      if (held->bench == bench && held->part == x) {
        return &*held;
      }
    }
    return nullptr;
  }

  void forget_tested(const RunSheet& sheet) {
    PairSet met(job_->parts());
    for (const RunStep& step : sheet.steps) {
      for (const auto& [x, y] : step.new_pairs) {
        met.insert(x, y);
      }
      for (const Triple& t : step.new_triples) {
        left_.triples.erase(std::ranges::find(left_.triples, t));
      }
    }
    drop_needed(left_, met);
  }

  // Checks, whenever a bench gets a part, how many hold it.
  void check_stock() {
    for (Element x = 0; x < job_->quantities.size(); ++x) {
      std::vector<Held> shared;
      std::ranges::copy_if(held_, std::back_inserter(shared), [&](const Held& h) {
        return h.part == x && h.from < h.to && !contains((*benches_)[h.bench].own, x);
      });
      for (const Held& one : shared) {
        const auto there =
            static_cast<std::uint64_t>(std::ranges::count_if(shared, [&](const Held& other) {
              return other.from <= one.from && one.from < other.to;
            }));
        if (there > job_->quantities[x]) {
          fault(one.bench,
                fmt::format("at {} {} is on {}, but there {} {}", to_string(one.from),
                            job_->names[x], count_of(there, "bench", "benches"),
                            job_->quantities[x] == 1 ? "is" : "are", job_->quantities[x]));
        }
      }
    }
  }

  const Job* job_;
  const std::vector<Bench>* benches_;
  const BenchSchedule* schedule_;
  Job left_;  // what the benches so far have not tested
  Amount day_;
  BenchCount count_;
  std::vector<Held> held_;
};

}  // namespace

BenchCount count_benches(const Job& job, const std::vector<Bench>& benches,
                         const BenchSchedule& schedule) {
  return BenchReferee(job, benches, schedule).run();
}

BenchCount count_benches(const Job& job, const std::vector<std::vector<Block>>& lists) {
  Job plain = job;
  plain.quantities.clear();
  BenchSchedule schedule;
  for (const std::vector<Block>& list : lists) {
    std::vector<BenchStep>& steps = schedule.emplace_back();
    const RunSheet sheet = run_sheet(plain, list);
    for (std::size_t i = 0; i < list.size(); ++i) {
      steps.push_back({list[i], sheet.steps[i].cost_so_far - sheet.steps[i].cost});
    }
  }
  return BenchReferee(plain, std::vector<Bench>(lists.size()), schedule).run();
}

}  // namespace changeover
