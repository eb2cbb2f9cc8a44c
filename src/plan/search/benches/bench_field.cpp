#include "plan/search/benches/bench_field.hpp"

#include <algorithm>
#include <utility>

#include "core/checked.hpp"
#include "core/contains.hpp"
#include "plan/job/bench_jobs.hpp"
#include "plan/search/benches/step_costs.hpp"

namespace changeover {
namespace {

// The properties of a bench that determine its job.
Bench kind_of(const Bench& bench) {
  Bench kind = bench;
  kind.name.clear();
  kind.own.clear();
  kind.hours.reset();
  kind.tests_done = 0;
  kind.last_step = 0;
  kind.rest.clear();
  kind.places.clear();
  return kind;
}

// Removes the tests of these set-ups from a job.
void take_off(Job& job, const std::vector<Block>& setups) {
  if (setups.empty()) {
    return;
  }
  const Block start = job.start;
  const std::uint64_t done = job.tests_done;
  const std::uint64_t at_once = std::exchange(job.at_once, job.parts());
  mark_done(job, setups);
  job.at_once = at_once;
  job.start = start;
  job.tests_done = done;
}

}  // namespace

BenchField::BenchField(const Job& job, const std::vector<Bench>& benches, const BenchField* wider)
    : job_(&job), benches_(&benches), common_(job) {
  for (std::size_t i = 0; i < benches.size(); ++i) {
    if (!benches[i].down) {
      working_.push_back(i);
    }
  }
  if (wider != nullptr) {
    values_ = wider->values_;
  } else if (job.model != nullptr) {
    values_ = std::make_shared<const CompiledRules>(*job.model);
  }
  add_jobs(wider);
  set_rules();
}

Job BenchField::own_job(std::size_t w, const BenchField* wider) const {
  if (wider == nullptr) {
    return job_of_bench(*job_, bench(w));
  }
  const auto there = std::ranges::find(wider->working_, working_[w]) - wider->working_.begin();
  return job_of_bench(*job_, bench(w), wider->whole(static_cast<std::size_t>(there)).needed);
}

void BenchField::add_jobs(const BenchField* wider) {
  std::vector<Block> first;
  std::vector<std::vector<bool>> barred;
  for (std::size_t w = 0; w < size(); ++w) {
    barred.push_back(barred_parts(*job_, bench(w)));
    for (std::size_t other = 0; other < w && whole_.size() == w; ++other) {
      if (kind_of(bench(other)) == kind_of(bench(w)) && barred[other] == barred[w]) {
        whole_.push_back(whole_[other]);
      }
    }
    if (whole_.size() == w) {
      jobs_.push_back(own_job(w, wider));
      whole_.push_back(&jobs_.back());
    }
    const std::vector<Block>& own = whole(w).first;
    first.insert(first.end(), own.begin(), own.end());
  }
  common_.first.clear();
  take_off(common_, first);
  for (std::size_t w = 0; w < size(); ++w) {
    Amount& spent = spent_.emplace_back();
    for (const Amount cost : step_costs(whole(w), whole(w).first)) {
      spent += cost;
    }
    const auto same =
        std::find(whole_.begin(), whole_.begin() + static_cast<std::ptrdiff_t>(w), whole_[w]);
    const auto before = static_cast<std::size_t>(same - whole_.begin());
    if (before < w) {
      rest_.push_back(rest_[before]);
      continue;
    }
    Job rest = whole(w);
    rest.first.clear();
    rest.start = whole(w).first.empty() ? rest.start : whole(w).first.back();
    take_off(rest, first);
    jobs_.push_back(std::move(rest));
    rest_.push_back(&jobs_.back());
  }
}

void BenchField::set_rules() {
  holders_.assign(job_->names.size(), size());
  ClockRules rules;
  rules.quantity.assign(job_->names.size(), size());
  rules.shared.assign(size(), std::vector<bool>(job_->names.size(), false));
  bool matters = false;
  std::vector<std::vector<bool>> barred;
  for (std::size_t w = 0; w < size(); ++w) {
    barred.push_back(barred_parts(*job_, bench(w)));
  }
  for (Element x = 0; x < job_->parts(); ++x) {
    std::uint64_t sharing = 0;
    std::uint64_t owning = 0;
    for (std::size_t w = 0; w < size(); ++w) {
      const bool own = contains(bench(w).own, x);
      owning += own && !barred[w][x] ? 1U : 0U;
      sharing += !own && !barred[w][x] ? 1U : 0U;
    }
    const std::uint64_t quantity = job_->quantities.empty() ? size() : job_->quantities[x];
    holders_[x] = owning + std::min(sharing, quantity);
    if (sharing > quantity) {
      matters = true;
      rules.quantity[x] = quantity;
      for (std::size_t w = 0; w < size(); ++w) {
        rules.shared[w][x] = !contains(bench(w).own, x) && !barred[w][x];
      }
    }
  }
  const Amount hour = Amount{costs_of_hour(*job_) * 1'000'000};
  constexpr std::uint64_t night_and_day = 24;
  const Amount whole_day = hour * night_and_day;
  Amount day;
  for (std::size_t w = 0; w < size(); ++w) {
    const Amount hours = bench(w).hours ? *bench(w).hours * costs_of_hour(*job_) : whole_day;
    day = std::max(day, hours);
    matters = matters || hours < whole_day;
    rules.hours.push_back(hours < whole_day ? hours.millionths : 0);
    rules.first.push_back(whole(w).first);
    rules.start.push_back(whole(w).start);
  }
  rules.day = day.millionths;
  if (matters) {
    rules_ = std::move(rules);
  }
}

bool BenchField::has_single_parts() const {
  return size() > 1 && rules_ &&
         std::ranges::find(rules_->quantity, std::uint64_t{1}) != rules_->quantity.end();
}

ListsJob BenchField::lists_job(std::uint64_t tests, bool exact) const {
  ListsJob job{.common = &common_,
               .jobs = rest_,
               .weights = weights_of(rest_, tests),
               .spent = {},
               .clock = rules_ ? &*rules_ : nullptr,
               .rules = values_};
  for (std::size_t w = 0; w < size(); ++w) {
    job.spent.push_back(
        static_cast<std::int64_t>(ceil_div(spent_[w].millionths, job.weights[w].unit)));
    for (std::size_t x = 0; exact && x < rest(w).names.size(); ++x) {
      const bool is_free = rest(w).change_costs[x].millionths == 0;
      job.weights[w].change[x] = is_free ? 0 : job.weights[w].change[x];
    }
  }
  return job;
}

BenchSchedule BenchField::schedule(const BenchLists& lists) const {
  const std::size_t words = (job_->names.size() + 63) / 64;
  const auto bits_of = [&](const Block& block) {
    std::vector<std::uint64_t> bits(words, 0);
    for (const Element x : block) {
      bits[x / 64] |= std::uint64_t{1} << (x % 64);
    }
    return bits;
  };
  std::vector<std::vector<Block>> setups(size());
  std::vector<std::vector<std::vector<std::uint64_t>>> bits(size());
  std::vector<std::vector<Ticks>> change(size());
  std::vector<std::vector<std::uint64_t>> start(size());
  std::vector<std::vector<std::uint64_t>> shared(size());
  std::vector<std::vector<ClockStep>> steps(size());
  std::vector<ClockBench> courses(size());
  for (std::size_t w = 0; w < size(); ++w) {
    setups[w] = whole(w).first;
    setups[w].insert(setups[w].end(), lists[w].begin(), lists[w].end());
    const std::vector<Amount> costs = step_costs(whole(w), setups[w]);
    for (const Block& setup : setups[w]) {
      bits[w].push_back(bits_of(setup));
    }
    for (std::size_t i = 0; i < setups[w].size(); ++i) {
      steps[w].push_back({static_cast<Ticks>(costs[i].millionths), bits[w][i].data()});
    }
    for (const Amount cost : whole(w).change_costs) {
      change[w].push_back(static_cast<Ticks>(cost.millionths));
    }
    Block scarce;
    for (Element x = 0; rules_ && x < job_->parts(); ++x) {
      if (rules_->shared[w][x]) {
        scarce.push_back(x);
      }
    }
    shared[w] = bits_of(scarce);
    start[w] = bits_of(whole(w).start);
    courses[w].start = start[w].data();
    courses[w].shared = shared[w].data();
    courses[w].change = change[w];
    courses[w].hours = rules_ ? static_cast<Ticks>(rules_->hours[w]) : 0;
  }
  BenchClock clock(
      std::move(courses),
      rules_ ? rules_->quantity : std::vector<std::uint64_t>(job_->names.size(), size()),
      rules_ ? static_cast<Ticks>(rules_->day) : 1);
  for (std::size_t w = 0; w < size(); ++w) {
    clock.steps(w) = std::move(steps[w]);
  }
  ClockRecord record;
  (void)clock.run(&record);
  BenchSchedule schedule(benches_->size());
  for (std::size_t w = 0; w < size(); ++w) {
    for (std::size_t i = 0; i < setups[w].size(); ++i) {
      const ClockRecord::Time& time = record.times[w][i];
      schedule[working_[w]].push_back(
          {setups[w][i], Amount{static_cast<std::uint64_t>(time.begin)}, time.again});
    }
  }
  return schedule;
}

}  // namespace changeover
