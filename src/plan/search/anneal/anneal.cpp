#include "plan/search/anneal/anneal.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "changeover/core/error.hpp"
#include "plan/search/anneal/cooling.hpp"

namespace changeover {
namespace {

class Annealer {
 public:
  Annealer(Sequence& sequence, const Annealing& options, Random& random)
      : s_(&sequence),
        options_(options),
        random_(&random),
        cooling_(options.hot, options.cold, options.penalty) {
    constrained_ = s_->fitting().has_slots() || s_->job().never.size() > 0;
    constexpr std::size_t long_list = 20'000;
    note_seldom_ = s_->size() * s_->job().room() > long_list;
    constexpr std::size_t shortest = 100;
    constexpr std::size_t longest = 500;
    const std::size_t places = s_->size() * s_->job().room();
    swaps_ = s_->fitting().has_slots() && shortest <= places && places < longest;
  }

  AnnealedPlan run(RunControl& control) {
    record(true);
    constexpr std::uint64_t batch = 1024;
    // One move on a long list of large set-ups takes as long as thousands on a short one.
    constexpr std::uint64_t work = 1'000'000;
    const std::uint64_t room = s_->job().room();
    const std::uint64_t work_a_move = 1 + s_->size() / 8 + room * room;
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
        cool(share_done(step, options_.steps, time_gone));
        record(true);
        if (control.progress_due()) {
          control.tell({.phase = options_.phase, .steps = step, .missing = s_->uncovered()});
        }
      }
      move();
    }
    record(true);
    if (best_.uncovered != none_met) {
      best_.setups = Sequence::setups_of(best_list_);
    }
    best_.steps = step;
    return std::move(best_);
  }

 private:
  void cool(double done) {
    const auto needed = static_cast<double>(s_->job().needed.size());
    const auto open = static_cast<double>(s_->uncovered());
    const double met = std::max(1.0, needed - open);
    cooling_.cool(done, {needed, open, static_cast<double>(s_->cost()) / met});
  }

  [[nodiscard]] double energy(std::int64_t cost, std::int64_t uncovered) const {
    const double missing = cooling_.penalty() * static_cast<double>(uncovered);
    const auto paid = static_cast<double>(cost);
    if (!options_.budget) {
      return paid + missing;
    }
    const double over = std::max(0.0, paid - static_cast<double>(*options_.budget));
    return paid * 0.25 + over * 4.0 + missing;
  }

  struct Standing {
    std::int64_t cost = 0;
    std::int64_t uncovered = 0;
  };

  [[nodiscard]] Standing now() const {
    return {s_->cost(), static_cast<std::int64_t>(s_->uncovered())};
  }

  // Whether to make a move that adds this much to a list.
  [[nodiscard]] bool acceptable(const Rise& rise) { return acceptable(rise, now()); }
  [[nodiscard]] bool acceptable(const Rise& rise, const Standing& from) {
    const double higher = options_.budget
                              ? energy(from.cost + rise.cost, from.uncovered + rise.uncovered) -
                                    energy(from.cost, from.uncovered)
                              : energy(rise.cost, rise.uncovered);
    return cooling_.accepts(higher, *random_);
  }

  // Records the state of the list before a move that is made before it is evaluated.
  void begin() { before_ = now(); }

  // Whether to keep the move made since begin().
  bool keep() {
    const Standing after = now();
    if (!acceptable({after.cost - before_.cost, after.uncovered - before_.uncovered}, before_)) {
      return false;
    }
    record();
    return true;
  }

  // Long lists are not recorded at every improvement.
  void record(bool now = false) {
    if (note_seldom_ && !now) {
      return;
    }
    const bool better =
        options_.budget
            ? s_->cost() <= *options_.budget &&
                  (s_->uncovered() < best_.uncovered ||
                   (s_->uncovered() == best_.uncovered && s_->cost() < best_.cost))
            : s_->uncovered() == 0 && (best_.uncovered == none_met || s_->cost() < best_.cost);
    if (better) {
      s_->write_to(best_list_);
      best_.cost = s_->cost();
      best_.uncovered = s_->uncovered();
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
    if (swaps_ && below(8) == 0) {
      swap();
      return;
    }
    const std::size_t dice = below(128);
    if (dice < 74) {
      shift();
    } else if (dice < 90) {
      replace();
    } else if (dice < 104) {
      replace_aimed();
    } else if (dice < 109) {
      dice % 2 == 0 && s_->uncovered() > 0 ? exchange_aimed() : exchange();
    } else if (dice < 116) {
      take_out();
    } else if (dice < 120) {
      copy();
    } else if (dice < 122) {
      change_run();
    } else if (dice < 124) {
      below(constrained_ ? 2 : 16) == 0 ? insert() : copy();
    } else if (dice < 127) {
      reverse();
    } else {
      rotate();
    }
  }

  void try_replacing(std::size_t at, Element x, Element y) {
    if (constrained_ && !s_->may_join(at, y, x)) {
      return;
    }
    const Rise rise = s_->rise_of_replace(at, x, y);
    if (acceptable(rise)) {
      s_->replace(at, x, y, rise);
      record();
    }
  }

  // Two set-ups exchange parts of one slot, so that either part is in as many as before: where
  // every test is needed for the pairs of two slots, no change of one set-up alone keeps them.
  void swap() {
    const std::size_t i = below(s_->size());
    const std::size_t j = below(s_->size());
    const auto x = some_part(i, std::nullopt);
    if (!x || s_->holds(j, *x)) {
      return;
    }
    const auto y = replacement_for(j, *x, std::nullopt);
    if (!y || s_->holds(i, *y) || !s_->may_join(i, *y, *x) || !s_->may_join(j, *x, *y)) {
      return;
    }
    const auto both = [&](Element at_i, Element at_j) {
      s_->replace(i, at_i, at_j, s_->rise_of_replace(i, at_i, at_j));
      s_->replace(j, at_j, at_i, s_->rise_of_replace(j, at_j, at_i));
    };
    begin();
    both(*x, *y);
    if (!keep()) {
      both(*y, *x);
    }
  }

  // A part stays for one more set-up and its replacement comes later, or it leaves earlier.
  void shift() {
    const std::size_t at = below(s_->size());
    const std::size_t earlier = at == 0 ? s_->size() : at - 1;
    const auto coming = s_->some_difference(at, earlier, random_->next32());
    const auto leaving = s_->some_difference(earlier, at, random_->next32());
    const bool later = random_->one_in_two();
    if (coming && leaving) {
      if (later) {
        try_replacing(at, *coming, *leaving);
      } else if (at > 0) {
        try_replacing(at - 1, *leaving, *coming);
      }
    } else if (later && leaving) {
      add_at(at, *leaving);
    } else if (!later && coming && at > 0) {
      add_at(at - 1, *coming);
    }
  }

  void add_at(std::size_t at, Element y) {
    if (s_->full(at) || !s_->may_join(at, y, y)) {
      return;
    }
    begin();
    s_->add({at, at}, y);
    if (!keep()) {
      s_->remove({at, at}, y);
    }
  }

  void replace() {
    const std::size_t at = below(s_->size());
    const Element y = s_->movable()[below(s_->movable().size())];
    if (s_->holds(at, y)) {
      return;
    }
    if (const auto x = replacement_for(at, y, std::nullopt)) {
      try_replacing(at, *x, y);
    }
  }

  void replace_aimed() {
    if (s_->uncovered() == 0) {
      replace();
      return;
    }
    const auto [kept, coming] = aim();
    const auto at = some_holder(kept);
    if (!at || !s_->is_movable(coming)) {
      return;
    }
    if (const auto x = replacement_for(*at, coming, kept); x && *x != coming) {
      try_replacing(*at, *x, coming);
    }
  }

  // An uncovered pair, in either order.
  std::pair<Element, Element> aim() {
    auto [x, y] = s_->uncovered_pair(below(s_->uncovered()));
    return random_->one_in_two() ? std::pair(y, x) : std::pair(x, y);
  }

  // Repeats a set-up, sometimes with a part of an uncovered pair in place of another.
  void copy() {
    if (s_->size() >= options_.most_tests) {
      return;
    }
    std::optional<std::size_t> at = below(s_->size());
    Element x = 0;
    Element y = 0;
    if (s_->uncovered() > 0 && random_->one_in_two()) {
      const auto [kept, coming] = aim();
      at = some_holder(kept);
      if (!at || !s_->is_movable(coming)) {
        return;
      }
      const auto leaving = replacement_for(*at, coming, kept);
      if (!leaving || !s_->may_join(*at, coming, *leaving)) {
        return;
      }
      x = *leaving;
      y = coming;
    }
    if (!acceptable(s_->rise_of_copy(*at, x, y))) {
      return;
    }
    Block setup(s_->setup(*at).begin(), s_->setup(*at).end());
    if (x != y) {
      *std::find(setup.begin(), setup.end(), x) = y;
    }
    s_->insert(*at + 1, setup);
    record();
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

  // A movable part of a set-up other than `kept` that could be replaced by y: of its slot, if that
  // is full.
  std::optional<Element> replacement_for(std::size_t at, Element y, std::optional<Element> kept) {
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
    const auto x = replacement_for(at, y, std::nullopt);
    if (x && !s_->holds(at, y)) {
      exchange_around(at, *x, y);
    }
  }

  // Some set-up with x, searched for from a random place on.
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
    const auto [kept, coming] = aim();
    const auto at = some_holder(kept);
    if (!at || !s_->is_movable(coming)) {
      return;
    }
    if (!s_->full(*at) && random_->one_in_two()) {
      add_around(*at, coming);
      return;
    }
    if (const auto leaving = replacement_for(*at, coming, kept); leaving && *leaving != coming) {
      exchange_around(*at, *leaving, coming);
    }
  }

  // Whether x and y may be exchanged here.
  [[nodiscard]] bool exchangeable(std::size_t at, Element x, Element y) const {
    const bool has_x = s_->holds(at, x);
    if (has_x == s_->holds(at, y)) {
      return false;
    }
    return has_x ? s_->may_join(at, y, x) : s_->may_join(at, x, y);
  }

  // The longest stretch around `at` for which `good` holds, or a part of it.
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
    if (choice >= 4) {  // up to where the set-ups agree about x and y
      where = stretch(at, 0, [&](std::size_t i) { return exchangeable(i, x, y); });
    } else if (choice < 3) {  // in the run of x only, on both sides or on one
      where = stretch(at, choice,
                      [&](std::size_t i) { return s_->holds(i, x) && exchangeable(i, x, y); });
    }
    begin();
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
    begin();
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
    begin();
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
    if (acceptable(s_->rise_of_take_out(at))) {
      s_->forget(s_->take_out(at));
      record();
    }
  }

  // Inserts a set-up with an uncovered pair, otherwise like the one next to it.
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
    begin();
    s_->insert(at, setup);
    if (!keep()) {
      s_->forget(s_->take_out(at));
    }
  }

  // Mounts x in a set-up, in place of parts that it must not meet and, if there is no room, of one
  // more.
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
    if (acceptable({s_->rise_of_reverse(where), 0})) {
      s_->reverse(where);
      record();
    }
  }

  void rotate() {
    std::array<std::size_t, 3> cuts{below(s_->size() + 1), below(s_->size() + 1),
                                    below(s_->size() + 1)};
    std::sort(cuts.begin(), cuts.end());
    if (cuts[0] == cuts[1] || cuts[1] == cuts[2]) {
      return;
    }
    if (acceptable({s_->rise_of_rotate(cuts[0], cuts[1], cuts[2]), 0})) {
      s_->rotate(cuts[0], cuts[1], cuts[2]);
      record();
    }
  }

  Sequence* s_;
  Annealing options_;
  Random* random_;
  Cooling cooling_;
  static constexpr std::size_t none_met = std::numeric_limits<std::size_t>::max();

  bool note_seldom_ = false;
  bool constrained_ = false;  // by slots or forbidden pairs
  bool swaps_ = false;        // in other lists of slots they find less than other moves do
  Standing before_;
  AnnealedPlan best_{.setups = {}, .cost = 0, .uncovered = none_met, .steps = 0};
  std::vector<Element> best_list_;
  Block protected_;
};

}  // namespace

AnnealedPlan anneal(Sequence& sequence, const Annealing& options, Random& random,
                    RunControl& control) {
  AnnealedPlan best = Annealer(sequence, options, random).run(control);
  if (control.stop_wanted()) {
    return best;  // at once: run_sheet() counts the result
  }
  // A list that millions of moves have updated must equal one that is built from scratch.
  const Sequence rebuilt(sequence.job(), sequence.weights(), sequence.setups());
  if (rebuilt.cost() != sequence.cost() || rebuilt.uncovered() != sequence.uncovered()) {
    throw InternalError("the search for cheap lists lost count");
  }
  return best;
}

}  // namespace changeover
