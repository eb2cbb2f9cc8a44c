#include "plan/search/anneal.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "changeover/core/error.hpp"

namespace changeover {
namespace {

// −ln of evenly spread numbers in (0,1), rounded so that every machine has the same.
const std::array<double, 4096>& log_table() {
  static const auto table = [] {
    std::array<double, 4096> values{};
    constexpr double steps = 1 << 20;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(values.size());
      values[i] = std::round(-std::log(u) * steps) / steps;
    }
    return values;
  }();
  return table;
}

class Annealer {
 public:
  Annealer(Sequence& sequence, const Annealing& options, Random& random)
      : s_(&sequence), options_(options), random_(&random), penalty_(options.penalty) {
    energy_ = energy();
  }

  AnnealedPlan run(RunControl& control) {
    record();
    constexpr std::uint64_t batch = 1024;
    // A move on a long list of large set-ups takes as long as thousands on a short one.
    constexpr std::uint64_t work = 1'000'000;
    const std::uint64_t room = s_->job().room();
    const std::uint64_t work_a_move = 1 + s_->size() + room * room;
    const std::uint64_t look = std::clamp<std::uint64_t>(work / work_a_move, 1, batch);
    std::uint64_t step = 0;
    const auto began = control.elapsed();
    double time_gone = 0;
    for (; step < options_.steps && time_gone < 1; ++step) {
      if ((step % batch) % look == 0 && control.stop_wanted()) {
        break;
      }
      if (step % batch == 0) {
        time_gone = options_.time ? (control.elapsed() - began) / *options_.time : 0.0;
        // Steps alone decide as long as they may do: then the result is the same again.
        const double steps = static_cast<double>(step) / static_cast<double>(options_.steps);
        constexpr double early = 0.1;
        cool(std::min(1.0, time_gone < early ? steps : std::max(time_gone, steps)));
        if (control.progress_due()) {
          control.tell({.phase = options_.phase, .steps = step, .missing = s_->uncovered()});
        }
      }
      move();
    }
    best_.steps = step;
    return std::move(best_);
  }

 private:
  // Sets temperature and penalty for the moment when so much is done.
  void cool(double done) {
    constexpr double higher = 1.7;
    constexpr double lower = 0.3;
    const double search = 1.0 - options_.finish;
    const bool finishing = options_.finish > 0 && done >= search;
    const double left = finishing ? (1.0 - done) / options_.finish : 1.0 - done / search;
    const double from = finishing ? options_.cold : options_.hot;
    const double to = finishing ? lower * options_.cold : options_.cold;
    temperature_ = to + (from - to) * left * left * left;
    const double penalty = finishing ? higher * options_.penalty : options_.penalty;
    if (penalty > penalty_) {
      penalty_ = penalty;
      energy_ = energy();
    }
  }

  [[nodiscard]] double energy() const {
    const auto cost = static_cast<double>(s_->cost());
    const double missing = penalty_ * static_cast<double>(s_->uncovered());
    if (!options_.budget) {
      return cost + missing;
    }
    const double over = std::max(0.0, cost - static_cast<double>(*options_.budget));
    return cost * 0.25 + over * 4.0 + missing;
  }

  // Whether to keep the move that was just made.
  bool keep() {
    const double now = energy();
    const double rise = now - energy_;
    if (rise > 0 && rise > temperature_ * log_table()[random_->next() >> 52]) {
      return false;
    }
    energy_ = now;
    if (rise < 0) {
      record();
    }
    return true;
  }

  void record() {
    const bool better = options_.budget
                            ? s_->cost() <= *options_.budget &&
                                  (!best_.setups || s_->uncovered() < best_.uncovered ||
                                   (s_->uncovered() == best_.uncovered && s_->cost() < best_.cost))
                            : s_->uncovered() == 0 && (!best_.setups || s_->cost() < best_.cost);
    if (better) {
      best_ = {s_->setups(), s_->cost(), s_->uncovered(), 0};
    }
  }

  std::size_t below(std::size_t limit) { return random_->below(static_cast<std::uint32_t>(limit)); }

  void move() {
    if (s_->movable().empty()) {
      return;
    }
    if (s_->size() == 0) {
      insert();
      return;
    }
    const std::size_t dice = below(64);
    if (dice < 44) {
      dice % 2 == 0 && s_->uncovered() > 0 ? exchange_aimed() : exchange();
    } else if (dice < 50) {
      change_run();
    } else if (dice < 54) {
      take_out();
    } else if (dice < 60) {
      insert();
    } else if (dice < 62) {
      reverse();
    } else {
      rotate();
    }
  }

  // A movable part of a set-up other than `kept`.
  std::optional<Element> some_part(std::size_t at, std::optional<Element> kept) {
    const auto setup = s_->setup(at);
    if (setup.empty()) {
      return std::nullopt;
    }
    const Element x = setup[below(setup.size())];
    return s_->is_movable(x) && x != kept ? std::optional(x) : std::nullopt;
  }

  // A movable part of a set-up other than `kept` that could leave for y: of its slot, if that is full.
  std::optional<Element> someone_for(std::size_t at, Element y, std::optional<Element> kept) {
    if (!s_->slot_full(at, y)) {
      return some_part(at, kept);
    }
    const auto setup = s_->setup(at);
    const std::size_t begin = below(setup.size());
    for (std::size_t i = 0; i < setup.size(); ++i) {
      const Element x = setup[(begin + i) % setup.size()];
      if (s_->fitting().slot(x) == s_->fitting().slot(y)) {
        return s_->is_movable(x) && x != kept ? std::optional(x) : std::nullopt;
      }
    }
    return std::nullopt;
  }

  void exchange() {
    const std::size_t at = below(s_->size());
    const Element y = s_->movable()[below(s_->movable().size())];
    const auto x = someone_for(at, y, std::nullopt);
    if (x && !s_->holds(at, y)) {
      exchange_around(at, *x, y);
    }
  }

  // Some set-up that holds x, searched for from a random place on.
  std::optional<std::size_t> some_holder(Element x) {
    const std::size_t begin = below(s_->size());
    for (std::size_t i = 0; i < s_->size(); ++i) {
      const std::size_t at = begin + i < s_->size() ? begin + i : begin + i - s_->size();
      if (s_->holds(at, x)) {
        return at;
      }
    }
    return std::nullopt;
  }

  void exchange_aimed() {
    auto [kept, coming] = s_->uncovered_pair(below(s_->uncovered()));
    if (random_->one_in_two()) {
      std::swap(kept, coming);
    }
    const auto at = some_holder(kept);
    if (!at || !s_->is_movable(coming)) {
      return;
    }
    if (!s_->full(*at) && random_->one_in_two()) {
      add_around(*at, coming);
      return;
    }
    if (const auto leaving = someone_for(*at, coming, kept); leaving && *leaving != coming) {
      exchange_around(*at, *leaving, coming);
    }
  }

  // Whether x and y may change places here.
  [[nodiscard]] bool exchangeable(std::size_t at, Element x, Element y) const {
    const bool has_x = s_->holds(at, x);
    if (has_x == s_->holds(at, y)) {
      return false;
    }
    return has_x ? s_->may_join(at, y, x) : s_->may_join(at, x, y);
  }

  // The longest stretch around `at` for which `good` holds, or some part of it.
  template <typename Good>
  Stretch stretch(std::size_t at, std::size_t choice, Good&& good) {
    Stretch where{at, at};
    if (choice != 1) {
      while (where.first > 0 && good(where.first - 1)) {
        --where.first;
      }
    }
    if (choice != 2) {
      while (where.last + 1 < s_->size() && good(where.last + 1)) {
        ++where.last;
      }
    }
    return where;
  }

  void exchange_around(std::size_t at, Element x, Element y) {
    if (!exchangeable(at, x, y)) {
      return;
    }
    const std::size_t choice = below(8);
    Stretch where{at, at};
    if (choice >= 4) {  // Up to where the set-ups agree about x and y.
      where = stretch(at, 0, [&](std::size_t i) { return exchangeable(i, x, y); });
    } else if (choice < 3) {  // In the run of x only, on both sides or on one.
      where = stretch(at, choice,
                      [&](std::size_t i) { return s_->holds(i, x) && exchangeable(i, x, y); });
    }
    s_->exchange(where, x, y);
    if (!keep()) {
      s_->exchange(where, x, y);
    }
  }

  void add_around(std::size_t at, Element y) {
    if (s_->full(at) || s_->holds(at, y) || !s_->may_join(at, y, y)) {
      return;
    }
    const std::size_t choice = below(4);
    const Stretch where = choice == 3 ? Stretch{at, at} : stretch(at, choice, [&](std::size_t i) {
      return !s_->full(i) && !s_->holds(i, y) && s_->may_join(i, y, y);
    });
    s_->add(where, y);
    if (!keep()) {
      s_->remove(where, y);
    }
  }

  // Mounts a part where there is room, or takes one out.
  void change_run() {
    const std::size_t at = below(s_->size());
    if (s_->slack() > 0 && random_->one_in_two()) {
      add_around(at, s_->movable()[below(s_->movable().size())]);
      return;
    }
    const auto x = some_part(at, std::nullopt);
    if (!x || s_->setup(at).size() < 2 || !s_->may_leave(at, *x)) {
      return;
    }
    const Stretch where = stretch(at, below(3), [&](std::size_t i) {
      return s_->holds(i, *x) && s_->setup(i).size() > 1 && s_->may_leave(i, *x);
    });
    s_->remove(where, *x);
    if (!keep()) {
      s_->add(where, *x);
    }
  }

  void take_out() {
    if (s_->size() < 2 && !options_.budget) {
      return;
    }
    const std::size_t at = below(s_->size());
    const std::uint32_t handle = s_->take_out(at);
    if (keep()) {
      s_->forget(handle);
    } else {
      s_->put_back(at, handle);
    }
  }

  // A set-up with an uncovered pair, otherwise like the one beside which it comes.
  void insert() {
    if (s_->uncovered() == 0 || s_->size() >= options_.most_tests) {
      return;
    }
    auto [x, y] = s_->uncovered_pair(below(s_->uncovered()));
    if (random_->one_in_two()) {
      std::swap(x, y);
    }
    const bool before = random_->one_in_two();
    const auto beside = random_->below(8) == 0 || s_->size() == 0 ? std::nullopt : some_holder(x);
    Block setup;
    std::size_t at = 0;
    if (beside) {
      setup.assign(s_->setup(*beside).begin(), s_->setup(*beside).end());
      at = before ? *beside : *beside + 1;
    } else if (s_->size() > 0) {
      at = below(s_->size() + 1);
      const auto neighbour = s_->setup(at == 0 ? 0 : at - 1);
      setup.assign(neighbour.begin(), neighbour.end());
    } else {
      setup = s_->job().mounted;
    }
    protected_.clear();
    if (!bring(setup, x) || !bring(setup, y)) {
      return;
    }
    if (s_->fitting().has_slots()) {
      const auto whole = s_->fitting().completed(setup, {});
      if (!whole) {
        return;
      }
      setup = *whole;
    }
    s_->insert(at, setup);
    if (!keep()) {
      s_->forget(s_->take_out(at));
    }
  }

  // Mounts x in a set-up, in place of what it must not meet and, if there is no room, of one more.
  bool bring(Block& setup, Element x) {
    protected_.push_back(x);
    if (std::find(setup.begin(), setup.end(), x) != setup.end()) {
      return true;
    }
    const Job& job = s_->job();
    std::erase_if(setup, [&](Element z) { return job.never.contains(z, x); });
    const Fitting& fitting = s_->fitting();
    const auto in_slot_of = [&](Element z) {
      return static_cast<std::uint64_t>(
          std::count_if(setup.begin(), setup.end(),
                        [&](Element other) { return fitting.slot(other) == fitting.slot(z); }));
    };
    const bool slots = fitting.has_slots();
    const bool slot_full = slots && fitting.slot(x) < fitting.slots() &&
                           in_slot_of(x) >= fitting.most(fitting.slot(x));
    const auto may_go = [&](Element z) {
      return s_->is_movable(z) && !is_protected(z) &&
             (!slots || fitting.slot(z) == fitting.slot(x) ||
              (!slot_full && in_slot_of(z) > fitting.least(fitting.slot(z))));
    };
    for (bool first = true; (first && slot_full) || setup.size() >= job.room(); first = false) {
      std::size_t most = 32;
      std::size_t victim = below(setup.size());
      while (most-- > 0 && !may_go(setup[victim])) {
        victim = below(setup.size());
      }
      if (!may_go(setup[victim])) {
        return false;
      }
      setup[victim] = setup.back();
      setup.pop_back();
    }
    setup.push_back(x);
    return true;
  }

  [[nodiscard]] bool is_protected(Element x) const {
    return std::find(protected_.begin(), protected_.end(), x) != protected_.end();
  }

  void reverse() {
    Stretch where{below(s_->size()), below(s_->size())};
    if (where.first > where.last) {
      std::swap(where.first, where.last);
    }
    s_->reverse(where);
    if (!keep()) {
      s_->reverse(where);
    }
  }

  void rotate() {
    std::array<std::size_t, 3> cuts{below(s_->size() + 1), below(s_->size() + 1),
                                    below(s_->size() + 1)};
    std::sort(cuts.begin(), cuts.end());
    if (cuts[0] == cuts[1] || cuts[1] == cuts[2]) {
      return;
    }
    s_->rotate(cuts[0], cuts[1], cuts[2]);
    if (!keep()) {
      s_->rotate(cuts[0], cuts[0] + cuts[2] - cuts[1], cuts[2]);
    }
  }

  Sequence* s_;
  Annealing options_;
  Random* random_;
  double penalty_;
  double temperature_ = 0;
  double energy_ = 0;
  AnnealedPlan best_;
  Block protected_;
};

}  // namespace

AnnealedPlan anneal(Sequence& sequence, const Annealing& options, Random& random,
                    RunControl& control) {
  AnnealedPlan best = Annealer(sequence, options, random).run(control);
  if (control.stop_wanted()) {
    return best;  // At once: the referee counts what becomes of it.
  }
  // What millions of moves kept up to date must be what a list built anew says.
  const Sequence anew(sequence.job(), sequence.weights(), sequence.setups());
  if (anew.cost() != sequence.cost() || anew.uncovered() != sequence.uncovered()) {
    throw InternalError("the search for cheap lists lost count");
  }
  return best;
}

}  // namespace changeover
