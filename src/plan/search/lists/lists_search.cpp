#include "plan/search/lists/lists_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "run/portable_math.hpp"
#include "run/random.hpp"
#include "run/threads.hpp"

namespace changeover {
namespace {

// What makes one state better than another: less of the first that differs.
using Rank = std::tuple<std::uint64_t, std::int64_t, std::int64_t>;

std::optional<Rank> rank_of(const Lists& lists, const ListsSearch& options) {
  switch (options.aim) {
    case Aim::most_weight:
      return lists.total() <= options.budget
                 ? std::optional(Rank(lists.missing(), lists.total(), 0))
                 : std::nullopt;
    case Aim::least_largest:
      return lists.open() == 0 ? std::optional(Rank(0, lists.largest(), lists.total()))
                               : std::nullopt;
    case Aim::least_cost:
      break;
  }
  return lists.open() == 0 ? std::optional(Rank(0, lists.total(), lists.largest())) : std::nullopt;
}

// `over` is what money beyond the budget counts.
double energy_of(const Lists& lists, const ListsSearch& options, double over) {
  const auto total = static_cast<double>(lists.total());
  switch (options.aim) {
    case Aim::most_weight:
      return total * 0.25 + over * std::max(0.0, total - static_cast<double>(options.budget));
    case Aim::least_largest:
      return static_cast<double>(lists.largest()) +
             total / (2.0 * static_cast<double>(lists.benches()));
    case Aim::least_cost:
      break;
  }
  return total;
}

struct Schedule {
  double penalty = 0;  // of a millionth of weight
  double hot = 0;
  double cold = 0;
  double over = 0;
};

class ListsAnnealer {
 public:
  ListsAnnealer(Lists& lists, const ListsSearch& options, const Schedule& schedule, Random& random)
      : lists_(&lists),
        options_(&options),
        schedule_(schedule),
        random_(&random),
        most_tests_(lists.tests() + std::min<std::size_t>(lists.open() + 16, lists.tests() + 16)),
        energy_(energy()) {
    record();
  }

  std::uint64_t run(std::uint64_t steps, RunControl& control) {
    constexpr std::uint64_t batch = 256;
    std::uint64_t step = 0;
    for (; step < steps && !lists_->movable().empty(); ++step) {
      if (step % batch == 0) {
        if (control.stop_wanted()) {
          break;
        }
        const double left = 1.0 - static_cast<double>(step) / static_cast<double>(steps);
        temperature_ = schedule_.cold + (schedule_.hot - schedule_.cold) * left * left * left;
        if (control.progress_due()) {
          control.tell({.phase = options_->phase, .steps = step, .missing = lists_->open()});
        }
      }
      move();
    }
    return step;
  }

  [[nodiscard]] const std::optional<Rank>& best_rank() const { return best_rank_; }
  [[nodiscard]] const BenchLists& best() const { return best_; }

 private:
  [[nodiscard]] double energy() const {
    return energy_of(*lists_, *options_, schedule_.over) +
           schedule_.penalty * static_cast<double>(lists_->missing());
  }

  void record() {
    const auto rank = rank_of(*lists_, *options_);
    if (rank && (!best_rank_ || *rank < *best_rank_)) {
      best_rank_ = rank;
      best_ = lists_->lists();
    }
  }

  void decide() {
    const double now = energy();
    const double rise = now - energy_;
    if (rise > 0 && rise > temperature_ * log_table()[random_->next() >> 52]) {
      lists_->undo();
      return;
    }
    lists_->keep();
    energy_ = now;
    if (rise < 0) {
      record();
    }
  }

  std::size_t below(std::size_t limit) { return random_->below(static_cast<std::uint32_t>(limit)); }
  Spot some_spot() { return lists_->spot(below(lists_->tests())); }
  Element some_part() { return lists_->movable()[below(lists_->movable().size())]; }

  // A movable part of a set-up; `no_part` if it is none or one of those that are to stay.
  Element some_part_of(Spot where, std::span<const Element> staying) {
    const auto setup = lists_->setup(where);
    if (setup.empty()) {
      return no_part;
    }
    const Element x = setup[below(setup.size())];
    const bool stays = std::find(staying.begin(), staying.end(), x) != staying.end();
    return lists_->is_movable(x) && !stays ? x : no_part;
  }

  void move() {
    if (lists_->tests() == 0) {
      insert();
      return;
    }
    const std::size_t dice = below(64);
    if (dice < 42) {
      dice % 2 == 0 && lists_->open() > 0 ? exchange_aimed() : exchange();
    } else if (dice < 48) {
      change_run();
    } else if (dice < 52) {
      lists_->take_out(some_spot());
      decide();
    } else if (dice < 57) {
      insert();
    } else if (dice < 59) {
      reverse();
    } else {
      relocate();
    }
  }

  void exchange() {
    const Spot where = some_spot();
    const Element in = some_part();
    const Element out = some_part_of(where, {});
    if (out != no_part && !lists_->holds(where, in)) {
      replace_around(where, out, in);
    }
  }

  // A set-up that holds all of these, searched for from a random place on.
  std::optional<Spot> some_holder(std::span<const Element> parts) {
    const std::size_t tests = lists_->tests();
    const std::size_t begin = below(tests);
    for (std::size_t i = 0; i < tests; ++i) {
      const Spot where = lists_->spot(begin + i < tests ? begin + i : begin + i - tests);
      if (std::all_of(parts.begin(), parts.end(),
                      [&](Element x) { return lists_->holds(where, x); })) {
        return where;
      }
    }
    return std::nullopt;
  }

  // Something that has not met: the part that is to come last, those before it stay.
  std::vector<Element> some_target() {
    if (lists_->open() == 0) {  // Something that has met, to meet on another bench as well.
      const auto there = lists_->setup(some_spot());
      std::vector<Element> target(there.begin(), there.end());
      while (target.size() > (lists_->of_triples() ? 3 : 2)) {
        target.erase(target.begin() + static_cast<std::ptrdiff_t>(below(target.size())));
      }
      return target;
    }
    const auto found = lists_->open_target(below(lists_->open()));
    std::vector<Element> target(found.begin(), found.end() - (lists_->of_triples() ? 0 : 1));
    std::swap(target[below(target.size())], target.back());
    return target;
  }

  void exchange_aimed() {
    const std::vector<Element> target = some_target();
    const std::span<const Element> staying(target.data(), target.size() - 1);
    const Element in = target.back();
    const auto where = some_holder(staying);
    if (!where || !lists_->is_movable(in) || lists_->holds(*where, in)) {
      return;
    }
    if (lists_->setup(*where).size() < lists_->job().room() && random_->one_in_two()) {
      replace_around(*where, no_part, in);
    } else if (const Element out = some_part_of(*where, staying); out != no_part) {
      replace_around(*where, out, in);
    }
  }

  [[nodiscard]] bool replaceable(Spot where, Element out, Element in) const {
    return (out == no_part || lists_->holds(where, out)) &&
           (in == no_part || !lists_->holds(where, in)) && lists_->may_replace(where, out, in);
  }

  // Here, or also in set-ups before it, after it or both, as long as it goes.
  void replace_around(Spot where, Element out, Element in) {
    if (!replaceable(where, out, in)) {
      return;
    }
    const std::size_t choice = below(4);
    lists_->replace(where, out, in);
    for (Spot at = where; (choice & 1U) != 0 && at.at > 0;) {
      --at.at;
      if (!replaceable(at, out, in)) {
        break;
      }
      lists_->replace(at, out, in);
    }
    for (Spot at = where; (choice & 2U) != 0 && at.at + 1 < lists_->tests(at.bench);) {
      ++at.at;
      if (!replaceable(at, out, in)) {
        break;
      }
      lists_->replace(at, out, in);
    }
    decide();
  }

  void change_run() {
    const Spot where = some_spot();
    if (lists_->setup(where).size() < lists_->job().room() && random_->one_in_two()) {
      replace_around(where, no_part, some_part());
    } else if (const Element out = some_part_of(where, {}); out != no_part) {
      replace_around(where, out, no_part);
    }
  }

  // A set-up with something that has not met, otherwise like the one beside which it comes.
  void insert() {
    // Where nothing is open, another set-up helps only if what has met is to meet on another bench, or if going by way of
    // it is cheaper.
    const bool may_help = lists_->open() > 0 || lists_->benches() > 1 || lists_->job().replaces();
    if (!may_help || (lists_->open() == 0 && lists_->tests() == 0) ||
        lists_->tests() >= most_tests_) {
      return;
    }
    const std::vector<Element> target = some_target();
    Block setup = lists_->job().mounted;
    Spot at{below(lists_->benches()), 0};
    if (lists_->tests() > 0) {
      const std::span<const Element> first(target.data(), 1);
      const auto holder = below(8) == 0 ? std::nullopt : some_holder(first);
      at = holder.value_or(some_spot());
      const auto beside = lists_->setup(at);
      setup.assign(beside.begin(), beside.end());
      at.at += random_->one_in_two() ? 1U : 0U;
    }
    // By itself, on any bench: what grows from it costs as little as can be at first.
    if (below(lists_->benches() > 1 ? 3 : 12) == 0) {
      setup = lists_->job().mounted;
      at.bench = below(lists_->benches());
      at.at = below(lists_->tests(at.bench) + 1);
    }
    for (const Element x : target) {
      if (!bring(setup, x, target)) {
        return;
      }
    }
    if (lists_->fitting().has_slots()) {
      const auto whole = lists_->fitting().completed(setup, {});
      if (!whole) {
        return;
      }
      setup = *whole;
    }
    lists_->insert(at, setup);
    decide();
  }

  // Mounts x in place of what it must not meet, of what is too much in its slot, and of what has no room.
  bool bring(Block& setup, Element x, const std::vector<Element>& target) {
    if (std::find(setup.begin(), setup.end(), x) != setup.end()) {
      return true;
    }
    const Job& job = lists_->job();
    std::erase_if(setup, [&](Element z) { return job.never.contains(z, x); });
    const Fitting& fitting = lists_->fitting();
    const auto of_slot = [&](std::size_t slot) {
      return static_cast<std::uint64_t>(std::count_if(
          setup.begin(), setup.end(), [&](Element z) { return fitting.slot(z) == slot; }));
    };
    const std::size_t slot = fitting.slot(x);
    const bool crowded = slot < fitting.slots() && of_slot(slot) >= fitting.most(slot);
    if (!crowded && setup.size() < job.room()) {
      setup.push_back(x);
      return true;
    }
    const std::size_t begin = below(setup.size() + 1);
    for (std::size_t i = 0; i < setup.size(); ++i) {
      Element& z = setup[(begin + i) % setup.size()];
      const bool may_go = lists_->is_movable(z) &&
                          std::find(target.begin(), target.end(), z) == target.end() &&
                          (!crowded || fitting.slot(z) == slot);
      if (may_go) {
        z = x;
        return true;
      }
    }
    return false;
  }

  void reverse() {
    const Spot where = some_spot();
    Stretch stretch{where.at, below(lists_->tests(where.bench))};
    if (stretch.first > stretch.last) {
      std::swap(stretch.first, stretch.last);
    }
    constexpr std::size_t longest = 64;
    stretch.last = std::min(stretch.last, stretch.first + longest);
    lists_->reverse(where.bench, stretch);
    decide();
  }

  // A stretch goes elsewhere, also backwards; a long one between benches is a cut.
  void relocate() {
    const Spot from = some_spot();
    const std::size_t after = lists_->tests(from.bench) - from.at;
    const std::size_t longest = below(4) == 0 ? 16 : 3;
    const std::size_t count = 1 + below(std::min<std::size_t>(after, longest));
    Spot to{below(lists_->benches()), 0};
    const std::size_t places = lists_->tests(to.bench) - (to.bench == from.bench ? count : 0) + 1;
    to.at = below(places);
    if (to.bench == from.bench && to.at == from.at) {
      return;
    }
    lists_->move(from, count, to);
    if (count > 1 && random_->one_in_two()) {
      lists_->reverse(to.bench, {to.at, to.at + count - 1});
    }
    decide();
  }

  Lists* lists_;
  const ListsSearch* options_;
  Schedule schedule_;
  Random* random_;
  std::size_t most_tests_;
  double temperature_ = 0;
  double energy_ = 0;
  std::optional<Rank> best_rank_;
  BenchLists best_;
};

// How attempts differ, as multiples of what something that meets costs on average.
struct Style {
  double penalty;
  double hot;
  double cold;
  double over;
};
// Where some pairs weigh far more than others, going over the budget has to count far more, too.
constexpr std::array<Style, 4> styles{{{2.0, 0.25, 0.08, 4.0},
                                       {1.8, 0.25, 0.10, 30.0},
                                       {2.2, 0.60, 0.10, 8.0},
                                       {2.5, 0.30, 0.06, 100.0}}};

std::uint64_t suitable_steps(const Lists& lists) {
  const std::uint64_t room = lists.job().room();
  const std::uint64_t a_move = lists.of_triples() ? room * room : room;
  constexpr std::uint64_t least = 100'000;
  constexpr std::uint64_t most = 4'000'000;
  constexpr std::uint64_t work = 40'000'000;
  return std::clamp<std::uint64_t>(std::min(lists.tests() * room * 8'000, work / a_move), least,
                                   most);
}

struct Best {
  std::optional<Rank> rank;
  BenchLists lists;

  void take(const Lists& found, const ListsSearch& options) {
    const auto other = rank_of(found, options);
    if (other && (!rank || *other < *rank)) {
      rank = other;
      lists = found.lists();
    }
  }
};

}  // namespace

FoundLists search_lists(const Job& job, const Weights& weights,
                        const std::vector<BenchLists>& starts, const ListsSearch& options,
                        RunControl& control) {
  std::vector<Best> bests(options.attempts);
  std::vector<std::uint64_t> steps(options.attempts, 0);
  in_parallel(control, options.attempts, [&](std::size_t i) {
    Lists lists(job, weights, starts[i % starts.size()]);
    bests[i].take(lists, options);
    const Style& style = styles[i % styles.size()];
    const auto everything = static_cast<double>(Lists(job, weights, BenchLists(1)).missing());
    // What a millionth of weight costs, about; on several benches, of what they cost together.
    const double costs =
        options.aim == Aim::most_weight
            ? static_cast<double>(options.whole)
            : std::max(energy_of(lists, options, 0), static_cast<double>(lists.total()));
    const double a_millionth = std::max(1.0, costs) / std::max(1.0, everything);
    const double typical =
        everything / static_cast<double>(std::max<std::uint64_t>(
                         1, job.triples.empty() ? job.needed.size() : job.triples.size()));
    const double scale = options.aim == Aim::most_weight ? 1.5 : 1.0;
    const double unit = scale * style.penalty * a_millionth;
    const Schedule schedule{.penalty = unit,
                            .hot = style.hot * unit * typical,
                            .cold = style.cold * unit * typical,
                            .over = style.over};
    Random random(control.seed(), 4'000'000 + std::uint64_t{options.round} * options.attempts + i);
    ListsAnnealer annealer(lists, options, schedule, random);
    steps[i] = annealer.run(options.steps > 0 ? options.steps : suitable_steps(lists), control);
    if (annealer.best_rank()) {
      Lists best(job, weights, annealer.best());
      bests[i].take(best, options);
      prune(best, control);
      bests[i].take(best, options);
    }
    if (options.aim != Aim::most_weight && !control.stop_wanted() && complete(lists, control)) {
      prune(lists, control);
      bests[i].take(lists, options);
    }
    const Lists anew(job, weights, lists.lists());
    if (anew.total() != lists.total() || anew.missing() != lists.missing()) {
      throw InternalError("the search for lists lost count");
    }
  });
  FoundLists found;
  const Best* best = nullptr;
  for (const Best& each : bests) {
    if (each.rank && (best == nullptr || *each.rank < *best->rank)) {
      best = &each;
    }
  }
  if (best == nullptr) {
    if (control.stop_wanted()) {
      throw Stopped(control.why_stopped());  // before any list was counted
    }
    throw InternalError("no list to start from");
  }
  found.lists = best->lists;
  for (const std::uint64_t each : steps) {
    found.steps += each;
  }
  return found;
}

}  // namespace changeover
