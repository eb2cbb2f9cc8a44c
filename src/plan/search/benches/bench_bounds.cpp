#include "plan/search/benches/bench_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/contains.hpp"
#include "core/least_number.hpp"
#include "core/words.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/job/prices.hpp"
#include "plan/job/setups/setup_list.hpp"
#include "plan/search/benches/benches_at_work.hpp"
#include "plan/search/benches/easiest_job.hpp"
#include "plan/search/benches/fullest_bench.hpp"
#include "plan/search/bounds/costliest_parts.hpp"
#include "plan/search/bounds/job_numbers.hpp"
#include "plan/search/valid_job.hpp"
#include "plan/search/weighted.hpp"

namespace changeover {
namespace {

__extension__ using Huge = unsigned __int128;

// The first time from which a monotone condition holds.
Amount earliest(const std::function<bool(std::uint64_t)>& holds) {
  constexpr std::uint64_t latest = std::uint64_t{1} << 61U;
  std::uint64_t high = 1;
  while (high < latest && !holds(high)) {
    stop_if_asked();
    high *= 2;
  }
  return Amount{least_number(0, high, [&](std::uint64_t time) {
    stop_if_asked();
    return holds(time);
  })};
}

class BenchBounder {
 public:
  explicit BenchBounder(const BenchField& field) : field_(&field) {}

  BenchBounds run() {
    unit_ = unit_of_times();
    std::uint64_t first_tests = 0;
    for (std::size_t w = 0; w < field_->size(); ++w) {
      spent_ += field_->spent(w);
      first_tests += field_->whole(w).first.size();
    }
    bounds_.makespan_reason = bounds_.cost.reason = "nothing is left to test";
    for (std::size_t w = 0; w < field_->size(); ++w) {
      raise(by(w, field_->spent(w).millionths), [&] {
        return "the first set-ups of " + name_of(field_->benches(), number(w)) + " take so long";
      });
    }
    const std::string of_first = bounds_.makespan_reason;
    if (field_->size() > 0 && field_->common().needed.size() > 0) {
      easiest_ = easiest_job(*field_);
      bound_costs();
      set_ratios();
      try {
        bound_shared();
        bound_one_pair();
        bound_scarce();
        bound_whole_tests();
        bound_pairs();
        bound_fullest();
      } catch (const Stopped&) {
        bound_costs_shared();  // the bound so far is valid, too
      }
    }
    bounds_.cost.tests += first_tests;
    if (spent_.millionths > 0) {
      bounds_.cost.cost += spent_;
      const auto after_first = [&](const std::string& reason) {
        return fmt::format("the first set-ups cost {}; after them, {}", to_string(spent_), reason);
      };
      bounds_.cost.reason = after_first(bounds_.cost.reason);
      if (bounds_.makespan_reason != of_first) {
        bounds_.makespan_reason = after_first(bounds_.makespan_reason);
      }
    }
    return std::move(bounds_);
  }

 private:
  [[nodiscard]] std::size_t number(std::size_t w) const {
    return static_cast<std::size_t>(&field_->bench(w) - field_->benches().data());
  }

  // All times are sums of costs, of days and of their hours: multiples of what divides these.
  void raise(Amount makespan, const std::function<std::string()>& reason) {
    if (makespan > bounds_.makespan) {
      bounds_.makespan =
          unit_ == 0 ? makespan : Amount{unit_} * ceil_div(makespan.millionths, unit_);
      bounds_.makespan_reason = reason();
    }
  }

  [[nodiscard]] std::uint64_t unit_of_times() const {
    std::uint64_t unit = 0;
    for (std::size_t w = 0; w < field_->size(); ++w) {
      unit = std::gcd(unit, unit_of_costs(field_->rest(w)));
      if (const auto& rules = field_->rules(); rules && rules->hours[w] > 0) {
        unit = std::gcd(std::gcd(unit, rules->hours[w]), rules->day);
      }
    }
    return unit;
  }

  // u_w(M).
  [[nodiscard]] std::uint64_t work(std::size_t w, std::uint64_t time) const {
    const auto& rules = field_->rules();
    if (!rules || rules->hours[w] == 0) {
      return time;
    }
    const std::uint64_t hours = rules->hours[w];
    return time / rules->day * hours + std::min(hours, time % rules->day);
  }

  // The first time by which a bench can have worked this long.
  [[nodiscard]] Amount by(std::size_t w, std::uint64_t hours) const {
    const auto& rules = field_->rules();
    if (hours == 0 || !rules || rules->hours[w] == 0) {
      return Amount{hours};
    }
    const std::uint64_t days = (hours - 1) / rules->hours[w];
    return Amount{days} * rules->day + Amount{hours - days * rules->hours[w]};
  }

  // Parts at the start of a bench are charged once more.
  [[nodiscard]] bool has_start(std::size_t w) const { return !field_->rest(w).start.empty(); }

  void bound_costs() {
    std::size_t starts = 0;
    std::size_t first = 0;
    for (std::size_t w = 0; w < field_->size(); ++w) {
      first = starts == 0 && has_start(w) ? w : first;
      starts += has_start(w) ? 1U : 0U;
    }
    Job one = easiest_;
    one.start = field_->rest(first).start;
    Amount once_more;
    bool fits = true;
    for (std::size_t w = 0; w < field_->size(); ++w) {
      if (w == first || !has_start(w)) {
        continue;
      }
      Block start = field_->rest(w).start;
      fits = fits && !setup_defect(one, start);
      once_more += easiest_.test_cost;
      for (const Element x : start) {
        once_more += easiest_.change_costs[x];
      }
    }
    if (!fits) {  // set-ups outside the job are put in between: then any are allowed
      one.model.reset();
      one.barred.clear();
      one.never = PairSet(one.parts());
      one.slots.clear();
      one.slot_of.clear();
      one.mounted.clear();
    }
    bounds_.cost = bound_of_valid_job(one);
    const Amount known = bounds_.cost.cost;
    bounds_.cost.cost = known - std::min(known, once_more);
    if (once_more.millionths > 0) {
      bounds_.cost.reason += fmt::format(
          "; that is with what is at the start of the other benches put in once more, for {}",
          to_string(once_more));
    }
    count_costliest();
    if (one_list_ && one_list_->cost > bounds_.cost.cost) {
      bounds_.cost.cost = one_list_->cost;
      bounds_.cost.reason = fmt::format(
          "the most expensive parts must meet among themselves (docs/plan.md, The lower bound): "
          "{} with "
          "{} cost least",
          count_of(one_list_->tests, "test"), count_of(one_list_->introductions, "change"));
    }
    if (field_->alike() && !field_->rest(0).replaces()) {
      bounds_.cost.cost = rounded_up(field_->rest(0), bounds_.cost.cost);
    }
  }

  // b_n including parts that stay mounted; that of one list if it is unknown.
  [[nodiscard]] CostliestCost lists_cost(std::uint64_t lists) const {
    CostliestCost cost = cost_of_costliest(*costliest_, lists);
    cost.cost += mounted_on(lists, mounting_);
    return cost;
  }

  // Prepares the bound by the most expensive parts.
  void count_costliest() {
    try {
      Amount mounting;
      std::optional<CostliestParts> question = costliest_parts_of(easiest_, mounting);
      if (!question || question->parts.size() > most_costliest_parts) {
        return;
      }
      for (std::size_t w = 0; w < field_->size(); ++w) {
        std::uint64_t there = 0;
        for (std::size_t i = 0; i < question->parts.size(); ++i) {
          const bool is_there = contains(field_->rest(w).start, question->parts[i]);
          question->at_start[i] += is_there ? 1U : 0U;
          there += is_there ? 1U : 0U;
        }
        question->starts += there > 0 ? 1U : 0U;
        question->room = std::max(question->room, there);
        question->first = there > 0 ? 1 : question->first;
      }
      costliest_ = std::move(question);
      mounting_ = mounting;
      one_list_ = lists_cost(1);
    } catch (const Stopped&) {
      // the bound so far is valid
    }
  }

  // Each list mounts the parts that stay, unless they are there; `mounting` is the cost for one
  // list, including what slots need.
  [[nodiscard]] Amount mounted_on(std::uint64_t lists, Amount mounting) const {
    Amount all;
    for (const Element m : easiest_.mounted) {
      std::uint64_t there = 0;
      for (std::size_t w = 0; w < field_->size(); ++w) {
        there += contains(field_->rest(w).start, m) ? 1U : 0U;
      }
      all += easiest_.change_costs[m] * (lists - std::min(lists, there));
      mounting = mounting - std::min(mounting, easiest_.change_costs[m]);
    }
    return any_bench([&](std::size_t w) { return has_start(w); }) ? all : all + mounting;
  }

  // φ_w as a fraction.
  void set_ratios() {
    for (std::size_t w = 0; w < field_->size(); ++w) {
      const Job own = at_prices(field_->rest(w), Price::least);
      Ratio least{1, 1};
      bool any = false;
      const auto look_at = [&](Amount cost, Amount base) {
        const bool less = Huge{cost.millionths} * least.under < Huge{least.over} * base.millionths;
        if (base.millionths > 0 && (!any || less)) {
          const std::uint64_t common = std::gcd(cost.millionths, base.millionths);
          least = {cost.millionths / common, base.millionths / common};
          any = true;
        }
      };
      look_at(own.test_cost, easiest_.test_cost);
      for (std::size_t x = 0; x < own.change_costs.size(); ++x) {
        look_at(own.change_costs[x], easiest_.change_costs[x]);
      }
      ratios_.push_back(least);
    }
  }

  // Benches that take turns, one of which works longer a day, may do more than the best ones alone
  // if their ratios differ.
  void make_ratios_equal() {
    const Ratio least =
        *std::min_element(ratios_.begin(), ratios_.end(), [](const Ratio& a, const Ratio& b) {
          return Huge{a.over} * b.under < Huge{b.over} * a.under;
        });
    std::fill(ratios_.begin(), ratios_.end(), least);
  }

  // A lower bound on what a bench can do by this time, at the least costs, besides its first
  // set-ups.
  [[nodiscard]] std::uint64_t can_do(std::size_t w, std::uint64_t time) const {
    const std::uint64_t hours = work(w, time);
    const std::uint64_t left = hours - std::min(hours, field_->spent(w).millionths);
    const Huge done = (Huge{left} * ratios_[w].under + ratios_[w].over - 1) / ratios_[w].over;
    constexpr Huge most = std::uint64_t{1} << 62U;
    return static_cast<std::uint64_t>(std::min(done, most));
  }

  // Whether `lists` benches can do work of this cost; the most productive ones are taken.
  [[nodiscard]] bool can_share(std::uint64_t lists, Huge cost, std::uint64_t time) const {
    std::vector<std::uint64_t> each;
    for (std::size_t w = 0; w < field_->size(); ++w) {
      each.push_back(can_do(w, time));
    }
    std::sort(each.begin(), each.end(), std::greater<>());
    const auto last = each.begin() + static_cast<std::ptrdiff_t>(lists);
    return std::accumulate(each.begin(), last, Huge{0}) >= cost;
  }

  // (1) with what one list costs, which takes little time: so there is some bound always.
  void bound_costs_shared() {
    RunControl undisturbed({});
    const RunScope scope(undisturbed);
    const Amount cost = bounds_.cost.cost;
    const auto can = [&](std::uint64_t t) { return can_share(field_->size(), cost.millionths, t); };
    raise(earliest(can),
          [&] { return "every plan costs at least " + to_string(cost) + " together"; });
  }

  // (1) and (2).
  void bound_shared() {
    const std::uint64_t benches = field_->size();
    const auto [together, why] = most_at_a_time(*field_, easiest_);
    if (together < benches && field_->rules()) {
      make_ratios_equal();
    }
    std::optional<Amount> least;
    std::uint64_t used = 1;
    Amount cost;
    const auto done_by = [&](std::uint64_t n, Amount all) {
      return earliest([&](std::uint64_t time) {
        return can_share(std::min(n, together), all.millionths, time);
      });
    };
    // With fewer benches, each has more to do; more lists cost no less than one.
    for (std::uint64_t n = benches; n > 0; --n) {
      Amount all = bounds_.cost.cost;
      if (least && done_by(n, all) >= *least) {
        break;
      }
      all = one_list_ ? std::max(all, lists_cost(n).cost) : all;
      const Amount found = done_by(n, all);
      if (!least || found < *least) {
        least = found;
        used = n;
        cost = all;
      }
    }
    raise(least.value_or(Amount{}), [&] {
      const std::string each =
          benches == 1 ? "every plan costs so much"
          : used == 1
              ? "a list of tests costs at least " + to_string(cost)
              : fmt::format("{} lists of tests together cost at least {}", used, to_string(cost));
      return together <= used && together < benches ? fmt::format("{}, and {}", each, why) : each;
    });
  }

  // (3)
  void bound_scarce() {
    for (Element x = 0; x < easiest_.parts(); ++x) {
      const std::uint64_t holders = field_->most_holders(x);
      if (holders >= field_->size() || holders == 0 || contains(easiest_.mounted, x)) {
        continue;
      }
      const Amount held = least_held(x);
      if (held.millionths == 0) {
        continue;
      }
      const Amount found = earliest([&](std::uint64_t time) {
        std::vector<std::uint64_t> each;
        for (std::size_t w = 0; w < field_->size(); ++w) {
          each.push_back(work(w, time));
        }
        std::sort(each.begin(), each.end(), std::greater<>());
        Huge all = 0;
        for (std::size_t i = 0; i < holders; ++i) {
          all += each[i];
        }
        return all >= held.millionths;
      });
      raise(found, [&] {
        return fmt::format("{} is on some bench for at least {}, and {} can have it at a time",
                           easiest_.names[x], to_string(held),
                           count_of(holders, "bench", "benches"));
      });
    }
  }

  // The shortest time for which a part is on benches.
  [[nodiscard]] Amount least_held(Element x) const {
    std::vector<Amount> others;  // partners of the part, the cheapest first
    for (Element y = 0; y < easiest_.parts(); ++y) {
      if (y != x && !contains(easiest_.mounted, y) && easiest_.needed.contains(x, y)) {
        others.push_back(easiest_.change_costs[y]);
      }
    }
    const std::uint64_t room = easiest_.room() - easiest_.mounted.size();
    if (others.empty() || room < 2) {
      return {};
    }
    std::sort(others.begin(), others.end());
    std::uint64_t starts = 0;
    std::uint64_t at_start = 0;  // the most partners that are there before the first test
    for (std::size_t w = 0; w < field_->size(); ++w) {
      const Block& start = field_->rest(w).start;
      if (contains(start, x)) {
        ++starts;
        at_start = std::max<std::uint64_t>(at_start, start.size());
      }
    }
    const std::uint64_t each = std::max(room, at_start) - 1;
    const std::uint64_t tests = ceil_div(others.size(), each);
    std::optional<Amount> least;
    for (std::uint64_t stays = 1; stays <= others.size(); ++stays) {
      const std::uint64_t there = std::min<std::uint64_t>(others.size(), stays * each);
      Amount held = easiest_.test_cost * std::max(tests, stays) +
                    easiest_.change_costs[x] * (stays - std::min(stays, starts));
      for (std::size_t i = 0; i < others.size() - there; ++i) {
        held += others[i];
      }
      least = least ? std::min(*least, held) : held;
      if (there == others.size()) {
        break;  // more stays only take longer
      }
    }
    return *least;
  }

  // (4)
  void bound_one_pair() {
    std::vector<Job> jobs;
    for (std::size_t w = 0; w < field_->size(); ++w) {
      jobs.push_back(at_prices(field_->rest(w), Price::least));
    }
    field_->common().needed.for_each(all_of_them, [&](Element x, Element y) {
      stop_if_asked();
      std::optional<Amount> least;
      for (std::size_t w = 0; w < jobs.size(); ++w) {
        const Job& own = jobs[w];
        if (!own.needed.contains(x, y)) {
          continue;
        }
        Amount pair = field_->spent(w) + own.test_cost;
        const auto put_in = [&](Element z) {
          pair += contains(own.start, z) ? Amount{} : own.change_costs[z];
        };
        std::for_each(own.mounted.begin(), own.mounted.end(), put_in);
        for (const Element z : {x, y}) {
          if (!contains(own.mounted, z)) {
            put_in(z);
          }
        }
        const Amount found = by(w, pair.millionths);
        least = least ? std::min(*least, found) : found;
      }
      raise(least.value_or(Amount{}), [&] {
        return fmt::format("a test of {} and {} takes so long", easiest_.names[x],
                           easiest_.names[y]);
      });
    });
  }

  // (5)
  void bound_pairs() {
    constexpr std::uint64_t most_parts = 150;
    if (easiest_.parts() > most_parts) {
      return;
    }
    std::vector<Job> jobs;  // one per kind
    std::vector<std::size_t> kind;
    for (std::size_t w = 0; w < field_->size(); ++w) {
      std::size_t same = 0;
      while (same < w && &field_->rest(same) != &field_->rest(w)) {
        ++same;
      }
      kind.push_back(same < w ? kind[same] : jobs.size());
      if (same == w) {
        jobs.push_back(at_prices(field_->rest(w), Price::least));
      }
    }
    std::uint64_t inner = 0;
    field_->common().needed.for_each(all_of_them, [&](Element x, Element y) {
      const bool outside = std::any_of(jobs.begin(), jobs.end(), [&](const Job& own) {
        return contains(own.mounted, x) || contains(own.mounted, y);
      });
      inner += outside ? 0U : 1U;
    });
    const Amount found = earliest([&](std::uint64_t time) {
      if (time < bounds_.makespan.millionths) {
        return false;  // known already
      }
      std::uint64_t pairs = 0;
      std::vector<std::pair<std::size_t, std::uint64_t>> known;  // by kind and time
      std::vector<std::uint64_t> numbers;
      for (std::size_t w = 0; w < field_->size(); ++w) {
        const std::uint64_t hours = work(w, time);
        const std::uint64_t left = hours - std::min(hours, field_->spent(w).millionths);
        const std::pair key(kind[w], left);
        const auto same = std::find(known.begin(), known.end(), key);
        if (same == known.end()) {
          known.push_back(key);
          numbers.push_back(most_pairs_within(jobs[kind[w]], Amount{left}));
          pairs += numbers.back();
        } else {
          pairs += numbers[static_cast<std::size_t>(same - known.begin())];
        }
      }
      return pairs >= inner;
    });
    raise(found, [&] {
      return field_->size() == 1 ? fmt::format("for less, no more than {} can be tested",
                                               count_of(inner - 1, "pair"))
                                 : fmt::format("for less, {} cannot test {} together",
                                               count_of(field_->size(), "bench", "benches"),
                                               count_of(inner, "pair"));
    });
  }

  // (6)
  void bound_whole_tests() {
    const auto& rules = field_->rules();
    if (!rules) {
      return;
    }
    const std::uint64_t tests = bounds_.cost.tests;
    std::vector<std::uint64_t> shortest;
    for (std::size_t w = 0; w < field_->size(); ++w) {
      const Job own = at_prices(field_->rest(w), Price::least);
      Amount cheapest{std::numeric_limits<std::uint64_t>::max()};
      for (Element x = 0; x < own.parts(); ++x) {
        cheapest = contains(own.mounted, x) ? cheapest : std::min(cheapest, own.change_costs[x]);
      }
      // A first set-up may be mounted already, and if all parts stay mounted none is put in.
      const bool changes = !has_start(w) && own.mounted.size() < own.parts();
      shortest.push_back(own.test_cost.millionths + (changes ? cheapest.millionths : 0));
    }
    const auto number = [&](std::size_t w, std::uint64_t time) -> std::uint64_t {
      const std::uint64_t hours = rules->hours[w];
      const std::uint64_t each = shortest[w];
      if (each == 0) {
        return tests;
      }
      if (hours == 0 || each > hours) {
        return work(w, time) / each;
      }
      return time / rules->day * (hours / each) + std::min(hours, time % rules->day) / each;
    };
    const Amount found = earliest([&](std::uint64_t time) {
      std::uint64_t all = 0;
      for (std::size_t w = 0; w < field_->size(); ++w) {
        all += number(w, time);
      }
      return all >= tests;
    });
    raise(found, [&] {
      return fmt::format("at least {} are needed, and a day has hours for only so many",
                         count_of(tests, "test"));
    });
  }

  // (7)
  void bound_fullest() {
    const JobNumbers n = numbers_of(easiest_);
    std::vector<Amount> most;  // what each bench can do by now
    for (std::size_t w = 0; w < field_->size(); ++w) {
      most.push_back(Amount{can_do(w, bounds_.makespan.millionths)});
    }
    const auto cost = cost_of_fullest(shared_parts(easiest_, n,
                                                   [&](Element x) {
                                                     return any_bench([&](std::size_t w) {
                                                       return contains(field_->rest(w).start, x);
                                                     });
                                                   }),
                                      field_->size(), *std::max_element(most.begin(), most.end()));
    if (!cost) {
      return;
    }
    const Amount found = earliest([&](std::uint64_t time) {
      return any_bench([&](std::size_t w) { return can_do(w, time) >= cost->millionths; });
    });
    raise(found, [&] {
      return fmt::format(
          "parts that must meet need a bench in common, so what some bench must put "
          "in costs at least {} with its tests",
          to_string(*cost));
    });
  }

  [[nodiscard]] bool any_bench(const std::function<bool(std::size_t)>& holds) const {
    for (std::size_t w = 0; w < field_->size(); ++w) {
      if (holds(w)) {
        return true;
      }
    }
    return false;
  }

  const BenchField* field_;
  Job easiest_;
  Amount spent_;
  std::optional<CostliestParts> costliest_;
  Amount mounting_;  // for one list
  std::optional<CostliestCost> one_list_;
  std::vector<Ratio> ratios_;
  BenchBounds bounds_;
  std::uint64_t unit_ = 0;
};

}  // namespace

BenchBounds bench_bounds(const BenchField& field) { return BenchBounder(field).run(); }

}  // namespace changeover
