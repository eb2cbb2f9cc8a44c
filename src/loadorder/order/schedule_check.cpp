// Replays a schedule. It shares no code with what makes schedules.
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/schedule.hpp"
#include "changeover/run/control.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "loadorder/order/tracked.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t most_followed = 65'536;  // workers that can be tracked
constexpr std::uint64_t most_epochs_followed = 1'000'000;
}  // namespace

class ScheduleCheck::State {
 public:
  State(const ScheduleRules& rules, const CheckOptions& options)
      : rules_(rules),
        options_(options),
        by_worker_(options.by_worker && rules.lockstep == 0),
        workers_(static_cast<std::size_t>(std::max<std::uint64_t>(1, rules.lockstep))) {
    if (rules.items == 0 || rules.room == 0 || rules.fast_room == std::uint64_t{0}) {
      throw BadInput(fmt::format("a load order of {} with room for {}{}: give at least 1 of each",
                                 count_of(rules.items, "item"), rules.room,
                                 rules.fast_room ? " and for 0 on the accelerator" : ""));
    }
    if (rules.epochs == 0 || rules.epochs > most_epochs_followed) {
      throw BadInput(fmt::format("{} epochs of a load order: give 1 to {}", rules.epochs,
                                 most_epochs_followed));
    }
    if (!rules.wanted.are_all() && rules.wanted.items() != rules.items) {
      throw BadInput(fmt::format("pairs of {} are wanted of {}",
                                 count_of(rules.wanted.items(), "item"), rules.items));
    }
    if (rules.sizes && rules.sizes->bytes.size() != rules.items) {
      throw BadInput(fmt::format("{} of {}", count_of(rules.sizes->bytes.size(), "size"),
                                 count_of(rules.items, "item")));
    }
    const auto items = static_cast<std::size_t>(rules.items);
    memory_.place.assign(items, 0);
    if (rules.lockstep > 0) {
      owner_.assign(items, 0);
      round_.resize(workers_.size());
    }
    if (rules.fast_room) {
      fast_.place.assign(items, 0);
      came_.assign(items, 0);
    }
    epochs_.resize(static_cast<std::size_t>(rules.epochs));
    open(1);
    verdict_.watched_items = computed() != nullptr && computed()->upward ? rules.items : 0;
    if (rules.store) {
      changes_.emplace(items);
    }
  }

  void read(const Step& step) {
    if (!verdict_.fault.empty()) {
      return;
    }
    if (rules_.lockstep == 0) {
      if (step.worker != worker_) {
        if (step.worker >= most_followed) {
          return fail(step, fmt::format("is not of one of {} workers", most_followed));
        }
        if (rules_.epochs > 1 && !rules_.shares) {
          return fail(step, fmt::format("is not of worker {}, whose epochs these are", worker_));
        }
        begin(step.worker);
      }
      play({&step, 1});
      return;
    }
    if (step.worker != in_round_) {
      fail(step, fmt::format("comes where worker {} is next", in_round_));
      return;
    }
    round_[in_round_++] = step;
    if (in_round_ == round_.size()) {
      in_round_ = 0;
      play(round_);
    }
  }

  ScheduleVerdict finish() {
    if (in_round_ > 0 && verdict_.fault.empty()) {
      fail(round_[0],
           fmt::format("is of {}, not of {}", count_of(in_round_, "worker"), round_.size()));
    }
    end();
    count_met();
    ScheduleVerdict verdict = verdict_;
    const std::uint64_t last = verdict.fault.empty() ? rules_.epochs : epoch_;
    for (std::uint64_t epoch = rules_.shares ? 1 : epoch_; epoch <= last; ++epoch) {
      open(epoch);
      account(verdict);
      epochs_[static_cast<std::size_t>(epoch - 1)].reset();
    }
    return verdict;
  }

 private:
  // Pairs belong to this epoch from now on.
  void open(std::uint64_t epoch) {
    epoch_ = epoch;
    std::unique_ptr<Epoch>& its = epochs_[static_cast<std::size_t>(epoch - 1)];
    if (its == nullptr) {
      its = std::make_unique<Epoch>();
      if (rules_.compute) {
        its->computed.emplace(rules_, options_.all_pairs);
      } else {
        its->met.emplace(rules_, options_);
      }
    }
  }
  [[nodiscard]] MetPairs* met() const {
    std::optional<MetPairs>& met = epochs_[static_cast<std::size_t>(epoch_ - 1)]->met;
    return met ? &*met : nullptr;
  }
  [[nodiscard]] Computed* computed() const {
    std::optional<Computed>& computed = epochs_[static_cast<std::size_t>(epoch_ - 1)]->computed;
    return computed ? &*computed : nullptr;
  }

  // Adds the missing pairs of an epoch.
  void account(ScheduleVerdict& verdict) const {
    if (met() != nullptr) {
      ScheduleVerdict its;
      met()->report(its);
      verdict.missing += its.missing;
      verdict.watched_items = its.watched_items;
      verdict.example = verdict.example.empty() ? its.example : verdict.example;
      return;
    }
    for (const std::optional<SeenPairs>* const pairs :
         {&computed()->upward, &computed()->downward}) {
      verdict.missing += *pairs ? (*pairs)->missing() : 0;
    }
    for (std::size_t x = 0; x < rules_.items && rules_.compute->self; ++x) {
      verdict.missing += computed()->loaded[x] && !computed()->alone[x] ? 1U : 0U;
    }
  }

  // Items in memory when an epoch begins are together in it.
  void enter(std::uint64_t epoch) {
    count_met();
    for (std::size_t w = 0; met() != nullptr && w < workers_.size(); ++w) {
      met()->clear(w);
    }
    if (!rules_.shares) {
      account(verdict_);
      epochs_[static_cast<std::size_t>(epoch_ - 1)].reset();
    }
    open(epoch);
    const Held& held = rules_.fast_room ? fast_ : memory_;
    for (std::size_t w = 0; w < workers_.size(); ++w) {
      std::vector<Element> there;
      for (const Element x : rules_.fast_room ? workers_[w].accelerator : workers_[w].memory) {
        if (met() != nullptr) {
          met()->arrive(w, x, there, held.place);
        }
        there.push_back(x);
      }
      for (const Element x : workers_[w].memory) {
        if (computed() != nullptr) {
          computed()->loaded[x] = true;
        }
      }
    }
  }

  struct Worker {
    std::uint64_t number = 0;  // of its last step
    std::vector<Element> memory;
    std::uint64_t bytes = 0;  // in memory, if items have sizes
    std::vector<Element> accelerator;
    std::uint64_t fast_bytes = 0;   // there, if items have sizes
    std::vector<ItemPair> overlap;  // pairs of its last step that are not computed yet
  };

  void fail(const Step& step, const std::string& what) {
    if (verdict_.fault.empty()) {
      verdict_.fault = rules_.lockstep > 0 || step.worker > 0
                           ? fmt::format("step {} of worker {} {}", step.number, step.worker, what)
                           : fmt::format("step {} {}", step.number, what);
    }
  }

  [[nodiscard]] std::size_t place_of(const Step& step) const {
    return rules_.lockstep > 0 ? static_cast<std::size_t>(step.worker) : 0;
  }
  Worker& of(const Step& step) { return workers_[place_of(step)]; }

  [[nodiscard]] bool holds(const Step& step, Element x) const {
    return x < rules_.items && memory_.has(x) && (owner_.empty() || owner_[x] == step.worker);
  }
  [[nodiscard]] bool on_accelerator(Element x) const { return rules_.fast_room && fast_.has(x); }

  // The list of items that x meets when it arrives, for pairs that have to meet.
  void meet(const Step& step, Element x, const Held& held, const std::vector<Element>& list) {
    if (met() != nullptr) {
      met()->arrive(place_of(step), x, list, held.place);
    }
  }
  void part(const Step& step, Element x, std::uint32_t place) {
    if (met() != nullptr) {
      met()->leave(place_of(step), x, place);
    }
  }

  // All workers do one thing before any does the next.
  void play(std::span<const Step> steps) {
    ++verdict_.steps;
    std::uint64_t slowest = 0;
    std::uint64_t slowest_bytes = 0;
    for (const Step& step : steps) {
      if (step.epoch != steps.front().epoch || step.epoch < epoch_ || step.epoch > epoch_ + 1 ||
          step.epoch > rules_.epochs) {
        return fail(step, fmt::format("is of epoch {} of {} where epoch {} is", step.epoch,
                                      rules_.epochs, epoch_));
      }
      start(step);
      slowest = std::max<std::uint64_t>(slowest, step.load.size());
      if (rules_.sizes && verdict_.fault.empty()) {
        slowest_bytes = std::max(slowest_bytes, bytes_loaded(step));
      }
    }
    verdict_.span += slowest;
    verdict_.span_bytes += slowest_bytes;
    if (verdict_.fault.empty() && steps.front().epoch != epoch_) {
      enter(steps.front().epoch);
    }
    for (const Step& step : steps) {
      load(step);
    }
    if (rules_.compute) {
      for (const Step& step : steps) {
        compute(step, step.compute, false);
        of(step).overlap = step.overlap;
        verdict_.most_in_a_step = std::max<std::uint64_t>(
            verdict_.most_in_a_step, step.compute.size() + step.overlap.size());
      }
    }
  }

  void start(const Step& step) {
    Worker& worker = of(step);
    if (step.number != ++worker.number) {
      return fail(step, fmt::format("is numbered so where {} is next", worker.number));
    }
    for (const Element x : step.fast_evict) {
      if (!holds(step, x) || !on_accelerator(x)) {
        return fail(step, fmt::format("takes {} from the accelerator, where it is not", x));
      }
      part(step, x, fast_.take(x, worker.accelerator));
      worker.fast_bytes -= rules_.sizes ? rules_.sizes->bytes[x] : 0;
    }
    if (step.late > (rules_.overlap ? step.evict.size() : 0)) {
      return fail(step, fmt::format("evicts {} late, of {}", count_of(step.late, "item"),
                                    step.evict.size()));
    }
    const auto late = step.evict.end() - static_cast<std::ptrdiff_t>(step.late);
    const std::span<const Element> first(step.evict.begin(), late);
    const std::span<const Element> last(late, step.evict.end());
    stored_ = 0;
    evict(step, first);
    if (rules_.sizes) {
      require_bytes(step);
    }
    if (verdict_.fault.empty() && worker.memory.size() + step.load.size() > rules_.room) {
      fail(step, fmt::format("loads {} when memory is full",
                             step.load[rules_.room - worker.memory.size()]));
    }
    if (rules_.overlap) {
      compute(step, std::exchange(worker.overlap, {}), !step.load.empty());
      evict(step, last);
    }
    if (changes_ && stored_ < step.store.size()) {
      fail(step, fmt::format("stores {}, which it does not evict then", step.store[stored_]));
    }
  }

  // What is loaded fits beside all that is in memory while loads run, items that leave late too.
  void require_bytes(const Step& step) {
    std::uint64_t free = rules_.sizes->memory - of(step).bytes;
    for (const Element x : step.load) {
      if (!verdict_.fault.empty() || x >= rules_.items) {
        return;
      }
      const std::uint64_t size = rules_.sizes->bytes[x];
      if (size > free) {
        return fail(step, fmt::format("loads {} of {} bytes where {} are free", x, size, free));
      }
      free -= size;
    }
    verdict_.most_bytes = std::max(verdict_.most_bytes, rules_.sizes->memory - free);
  }

  // They fit, so their sum does.
  [[nodiscard]] std::uint64_t bytes_loaded(const Step& step) const {
    return sum_of(step.load,
                  [&](const Element x) { return x < rules_.items ? rules_.sizes->bytes[x] : 0; });
  }

  // Stored items are in the order of the evicted ones.
  void evict(const Step& step, std::span<const Element> items) {
    std::vector<Element>& memory = of(step).memory;
    for (const Element x : items) {
      if (!verdict_.fault.empty()) {
        return;
      }
      if (!holds(step, x) || on_accelerator(x)) {
        return fail(step, fmt::format("evicts {}, which is {}", x,
                                      holds(step, x) ? "on the accelerator" : "not in memory"));
      }
      const std::uint32_t place = memory_.take(x, memory);
      of(step).bytes -= rules_.sizes ? rules_.sizes->bytes[x] : 0;
      if (!rules_.fast_room) {
        part(step, x, place);
      }
      if (changes_) {
        leave_changed(step, x);
      }
    }
  }

  void leave_changed(const Step& step, Element x) {
    Changes& c = *changes_;
    if (stored_ < step.store.size() && step.store[stored_] == x) {
      ++stored_;
      ++verdict_.stores;
      if (c.in_memory[x] == c.on_disk[x]) {
        fail(step, fmt::format("stores {}, which has not changed", x));
      }
      c.on_disk[x] = c.in_memory[x];
    }
    c.in_memory[x] = absent;
    if (c.on_disk[x] != c.all[x]) {
      fail(step, fmt::format("evicts {} and loses what was changed", x));
    }
  }

  void load(const Step& step) {
    if (!verdict_.fault.empty()) {
      return;
    }
    Worker& worker = of(step);
    for (const Element x : step.load) {
      if (x >= rules_.items || memory_.has(x)) {
        return fail(
            step, fmt::format("loads {}, which is {}", x,
                              x >= rules_.items ? "not an item"
                              : owner_.empty()  ? "in memory"
                                               : fmt::format("in memory of worker {}", owner_[x])));
      }
      if (!rules_.fast_room) {
        meet(step, x, memory_, worker.memory);
      }
      if (computed() != nullptr) {
        computed()->loaded[x] = true;
      }
      memory_.put(x, worker.memory);
      if (rules_.fast_room) {
        came_[x] = step.number;
      }
      if (rules_.sizes) {
        take_bytes(step, x);
      }
      if (!owner_.empty()) {
        owner_[x] = static_cast<std::uint32_t>(step.worker);
      }
      if (changes_) {
        changes_->in_memory[x] = changes_->on_disk[x];
      }
    }
    verdict_.most_in_memory =
        std::max<std::uint64_t>(verdict_.most_in_memory, worker.memory.size());
    for (const Element x : step.fast_load) {
      if (!rules_.fast_room || !holds(step, x) || on_accelerator(x)) {
        return fail(step, fmt::format("transfers {}, which is not in memory, or has been", x));
      }
      if (worker.accelerator.size() == *rules_.fast_room) {
        return fail(step, fmt::format("transfers {} when the accelerator is full", x));
      }
      if (rules_.sizes && !take_fast_bytes(step, x)) {
        return;
      }
      verdict_.ahead += std::exchange(came_[x], ~std::uint64_t{0}) < step.number ? 1U : 0U;
      meet(step, x, fast_, worker.accelerator);
      fast_.put(x, worker.accelerator);
    }
    count_at(verdict_.worker_loads, step.worker) += step.load.size();
    verdict_.loads += step.load.size();
    verdict_.epoch_loads.resize(
        std::max<std::size_t>(verdict_.epoch_loads.size(), static_cast<std::size_t>(step.epoch)),
        0);
    verdict_.epoch_loads[static_cast<std::size_t>(step.epoch - 1)] += step.load.size();
    verdict_.transfers += step.fast_load.size();
  }

  // No sum in memory exceeds 64 bits, since it was compared before.
  void take_bytes(const Step& step, Element x) {
    Worker& worker = of(step);
    const std::uint64_t size = rules_.sizes->bytes[x];
    worker.bytes += size;
    verdict_.bytes += size;
    verdict_.most_bytes = std::max(verdict_.most_bytes, worker.bytes);
    count_at(verdict_.worker_bytes, step.worker) += size;
  }

  bool take_fast_bytes(const Step& step, Element x) {
    Worker& worker = of(step);
    const std::uint64_t size = rules_.sizes->bytes[x];
    const std::uint64_t most = rules_.sizes->fast_memory;
    if (size > most - std::min(most, worker.fast_bytes)) {
      fail(step, fmt::format("transfers {} of {} bytes where {} are free", x, size,
                             most - std::min(most, worker.fast_bytes)));
      return false;
    }
    worker.fast_bytes += size;
    verdict_.transfer_bytes += size;
    return true;
  }

  void compute(const Step& step, const std::vector<ItemPair>& pairs, bool overlapped) {
    for (const auto& [x, y] : pairs) {
      if (!verdict_.fault.empty()) {
        return;
      }
      const auto there = [&](Element z) {
        return holds(step, z) && (!rules_.fast_room || fast_.has(z));
      };
      if (!there(x) || !there(y)) {
        return fail(step, fmt::format("computes ({},{}), which are not both {}", x, y,
                                      rules_.fast_room ? "on the accelerator" : "in memory"));
      }
      if (x == y ? !rules_.compute->self
                 : (x > y && !rules_.compute->ordered) || !rules_.wanted.contains(x, y)) {
        return fail(step, fmt::format("computes ({},{}), which is not wanted", x, y));
      }
      bool is_new = !computed()->alone[x];
      if (x == y) {
        computed()->alone[x] = true;
      } else {
        is_new = computed()->insert(x, y);
      }
      constexpr std::uint64_t pairs_between_looks = std::uint64_t{1} << 16;  // a step can have 10^8
      if (++verdict_.computed % pairs_between_looks == 0) {
        stop_if_asked();
      }
      ++count_at(verdict_.worker_pairs, step.worker);
      verdict_.repeated += is_new ? 0U : 1U;
      verdict_.overlapped += overlapped ? 1U : 0U;
      for (const Element z : {x, y}) {
        if (changes_) {
          ++changes_->all[z];
          ++changes_->in_memory[z];
        }
      }
    }
  }

  // The workers have no more steps.
  void end() {
    for (std::size_t w = 0; w < workers_.size() && verdict_.fault.empty(); ++w) {
      Step last;
      last.worker = rules_.lockstep > 0 ? w : worker_;
      last.number = workers_[w].number;
      compute(last, std::exchange(workers_[w].overlap, {}), false);
      if (changes_ && !workers_[w].memory.empty()) {
        fail(last, fmt::format("is the last, and {} is still held at the end",
                               workers_[w].memory.front()));
      }
    }
  }

  // Starts the next worker with an empty memory.
  void begin(std::uint64_t worker) {
    end();
    for (const Element x : workers_[0].memory) {
      memory_.place[x] = 0;
    }
    for (const Element x : workers_[0].accelerator) {
      fast_.place[x] = 0;
    }
    workers_[0] = {};
    if (met() != nullptr) {
      met()->clear(0);
      count_met();
    }
    open(1);
    worker_ = worker;
  }

  // Counts the pairs that met at the worker that ends.
  void count_met() {
    if (met() != nullptr && by_worker_) {
      count_at(verdict_.worker_pairs, worker_) += met()->take_count();
    }
  }

  static std::uint64_t& count_at(std::vector<std::uint64_t>& counts, std::uint64_t worker) {
    if (worker >= counts.size()) {
      counts.resize(static_cast<std::size_t>(worker) + 1, 0);
    }
    return counts[static_cast<std::size_t>(worker)];
  }

  ScheduleRules rules_;
  CheckOptions options_;
  bool by_worker_;  // pairs are counted by the worker where they meet
  ScheduleVerdict verdict_;
  std::vector<Worker> workers_;  // one, if workers follow one another
  std::uint64_t worker_ = 0;     // the current one then
  Held memory_;
  Held fast_;                         // on the accelerator, if there is one
  std::vector<std::uint64_t> came_;   // by item: the step that loaded it, until it is there
  std::vector<std::uint32_t> owner_;  // by item: its worker; empty unless in lockstep
  std::vector<std::unique_ptr<Epoch>> epochs_;  // those whose pairs are tracked now
  std::uint64_t epoch_ = 1;
  std::optional<Changes> changes_;
  std::size_t stored_ = 0;   // number of stores of the step so far
  std::vector<Step> round_;  // steps of all workers, as they arrive
  std::size_t in_round_ = 0;
};

ScheduleCheck::ScheduleCheck(const ScheduleRules& rules, const CheckOptions& options)
    : state_(std::make_unique<State>(rules, options)) {}
ScheduleCheck::~ScheduleCheck() = default;
ScheduleCheck::ScheduleCheck(ScheduleCheck&&) noexcept = default;

void ScheduleCheck::read(const Step& step) { state_->read(step); }

ScheduleVerdict ScheduleCheck::finish() { return state_->finish(); }

ScheduleVerdict check_schedule(StepSource& steps, const ScheduleRules& rules,
                               const CheckOptions& options) {
  ScheduleCheck check(rules, options);
  Step step;
  constexpr std::uint64_t steps_between_looks = 4096;
  for (std::uint64_t count = 0; steps.next(step); ++count) {
    check.read(step);
    if (count % steps_between_looks == 0) {
      stop_if_asked();
      if (progress_due()) {
        report_progress({.phase = "checking the load order", .steps = count, .unit = "steps"});
      }
    }
  }
  return check.finish();
}

}  // namespace changeover
