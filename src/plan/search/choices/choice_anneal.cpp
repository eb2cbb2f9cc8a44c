// Simulated annealing of lists of set-ups of a model.
#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "plan/search/choices/choice_search.hpp"
#include "run/portable_math.hpp"

namespace changeover {
namespace {

class ChoiceAnnealer {
 public:
  ChoiceAnnealer(const ChoiceJob& choices, ChoiceList list, const ChoiceAnnealing& options,
                 Random& random, RunControl& control)
      : choices_(choices),
        list_(std::move(list)),
        options_(options),
        random_(random),
        control_(control),
        solver_(choices.job()) {}

  AnnealedChoices run() {
    begin();
    const double begun = control_.elapsed().count();
    while (done_ < options_.steps && list_.size() > 0) {
      if (done_ % between_looks == 0) {
        double part = static_cast<double>(done_) / static_cast<double>(options_.steps);
        if (options_.time) {
          part = std::max(part, (control_.elapsed().count() - begun) / options_.time->count());
        }
        if (part >= 1 || control_.stop_wanted()) {
          break;
        }
        adjust(part);
        tell();
      }
      ++done_;
      move();
      note();
    }
    finish();
    result_.steps = done_;
    return std::move(result_);
  }

 private:
  static constexpr std::uint64_t between_looks = 256;

  // The cost of a change and of a tuple set the scale.
  void begin() {
    const std::vector<std::uint64_t>& change = choices_.weights().change;
    double all = 0;
    for (const std::uint64_t price : change) {
      all += static_cast<double>(price);
    }
    const double a_change = all / static_cast<double>(change.size());
    const double a_tuple = static_cast<double>(list_.cost()) /
                           static_cast<double>(std::max<std::size_t>(1, choices_.needed()));
    const auto slots = static_cast<double>(choices_.slots());
    const double a_row = static_cast<double>(choices_.weights().test) + a_change * slots / 2;
    penalty_ = options_.budget ? 3 * std::max(a_tuple, 1.0)
                               : std::max({a_tuple, a_change / 2, a_row / slots});
    hot_ = options_.hot * 0.6 * std::max(std::min(a_change, penalty_), penalty_ / 2);
    cold_ = 0.06 * std::max(std::min(a_change, penalty_), penalty_ / 4);
    if (options_.budget) {
      hot_ = options_.hot * 0.3 * penalty_;
      cold_ = 0.1 * penalty_;
    }
    if (options_.fixed_tests) {
      penalty_ = options_.fixed_tests->penalty * a_change;
      hot_ = options_.fixed_tests->hot * a_change;
      cold_ = options_.fixed_tests->cold * a_change;
    }
    constexpr double costly =
        3;  // lists with few tests are rigid: more heat, and tuples weigh more
    if (!options_.budget && !options_.fixed_tests &&
        static_cast<double>(choices_.weights().test) >= costly * a_change) {
      penalty_ *= 1.5;
      hot_ *= 2;
    }
    hot_ = std::max(hot_, 2 * cold_);
    octaves_ = natural_log(hot_ / cold_) / natural_log(2.0);
    most_rows_ = options_.fixed_tests ? list_.size() : 2 * list_.size() + 8;
    note();
  }

  void adjust(double part) {
    temperature_ = hot_ * two_to_minus(part * octaves_);
    const double allowed =
        std::max(0.0, 0.9 - part) * 0.02 * static_cast<double>(choices_.needed());
    if (!options_.budget && part > 0.3 && static_cast<double>(list_.missing()) > allowed) {
      penalty_ *= 1.0 + 30.0 * (part - part_);
    }
    part_ = part;
  }

  void tell() {
    if (control_.progress_due()) {
      control_.tell({.phase = options_.phase, .steps = done_});
    }
  }

  [[nodiscard]] bool accepts(const Rise& rise) {
    if (options_.budget && list_.cost() + rise.cost > *options_.budget) {
      return false;
    }
    return accepts_energy(rise);
  }

  [[nodiscard]] bool accepts_energy(const Rise& rise) {
    const double energy =
        static_cast<double>(rise.cost) + penalty_ * static_cast<double>(rise.uncovered);
    return energy <= 0 ||
           energy < temperature_ *
                        log_table()[random_.below(static_cast<std::uint32_t>(log_table().size()))];
  }

  [[nodiscard]] std::size_t any(std::size_t limit) {
    return random_.below(static_cast<std::uint32_t>(limit));
  }

  void move() {
    const std::uint32_t kind = random_.below(1000);
    if (kind < 400) {
      copy_neighbour();
    } else if (kind < 640) {
      const std::size_t slot = any(choices_.slots());
      try_cell({any(list_.size()), slot}, random_value(slot));
    } else if (kind < 800 && list_.missing() > 0) {
      put_missing();
    } else if (kind < 900) {
      try_run();
    } else if (kind < 980 || options_.fixed_tests) {
      random_.one_in_two() ? try_move() : try_reverse();
    } else if (kind < 990) {
      try_erase();
    } else {
      try_insert();
    }
  }

  Element random_value(std::size_t slot) {
    const std::vector<Element>& values = choices_.values(slot);
    return values[any(values.size())];
  }

  void try_cell(Cell cell, Element x) {
    const std::span<const Element> row = list_.row(cell.at);
    if (row[cell.slot] == x || !choices_.allows(row, x)) {
      return;
    }
    if (accepts(list_.rise_of_set(cell, x))) {
      list_.set(cell, x);
    }
  }

  void copy_neighbour() {
    const Cell cell{any(list_.size()), any(choices_.slots())};
    const std::size_t from = random_.one_in_two() ? cell.at + 1 : cell.at - 1;
    if (from < list_.size()) {
      try_cell(cell, list_.row(from)[cell.slot]);
    } else if (cell.at == 0 && from + 1 == 0) {
      const std::vector<Element>& values = choices_.values(cell.slot);
      const Element start = choices_.start()[cell.slot];
      if (std::ranges::find(values, start) != values.end()) {  // otherwise it must not stay
        try_cell(cell, start);
      }
    }
  }

  // Sets cells so that this can be undone.
  void set(Cell cell, Element x) {
    const Element old = list_.row(cell.at)[cell.slot];
    if (old != x) {
      changes_.emplace_back(cell, old);
      list_.set(cell, x);
    }
  }

  [[nodiscard]] Rise rise_since(std::int64_t cost, std::size_t missing) const {
    return {list_.cost() - cost,
            static_cast<std::int64_t>(list_.missing()) - static_cast<std::int64_t>(missing)};
  }

  [[nodiscard]] bool settles(std::int64_t cost, std::size_t missing) {
    return (!options_.budget || list_.cost() <= *options_.budget) &&
           accepts_energy(rise_since(cost, missing));
  }

  void settle(std::int64_t cost, std::size_t missing) {
    if (!settles(cost, missing)) {
      for (; !changes_.empty(); changes_.pop_back()) {
        list_.set(changes_.back().first, changes_.back().second);
      }
    }
    changes_.clear();
  }

  void put_missing() {
    Element parts[3];
    const std::size_t size = choices_.tuple_size();
    choices_.parts_of(list_.missing_tuple(any(list_.missing())), parts);
    const std::size_t at = any(list_.size());
    Block row(list_.row(at).begin(), list_.row(at).end());
    bool fits = true;
    for (std::size_t i = 0; i < size; ++i) {
      row[choices_.slot(parts[i])] = parts[i];
    }
    for (std::size_t i = 0; i < size && fits; ++i) {
      fits = choices_.allows(row, parts[i]);
    }
    if (fits && choices_.any_hides()) {
      const bool shown =
          std::any_of(parts, parts + size, [&](Element x) { return choices_.hides(x); });
      fits = shown || std::ranges::none_of(row, [&](Element x) { return choices_.hides(x); });
    }
    if (!fits) {
      constexpr std::uint32_t seldom = 8;
      if (random_.below(seldom) != 0) {
        return;
      }
      RunControl undisturbed({});
      const RunScope scope(undisturbed);
      auto completed = solver_.testing({parts, size}, list_.row(at));
      if (!completed) {
        throw InternalError("what must meet cannot");
      }
      row = *std::move(completed);
    }
    const std::int64_t cost = list_.cost();
    const std::size_t missing = list_.missing();
    for (std::size_t s = 0; s < row.size(); ++s) {
      set({at, s}, row[s]);
    }
    settle(cost, missing);
  }

  // A run of cells of one parameter with the same value takes another value, often that of a
  // neighbour.
  void try_run() {
    const std::size_t slot = any(choices_.slots());
    std::size_t first = any(list_.size());
    std::size_t last = first;
    const Element old = list_.row(first)[slot];
    constexpr std::size_t longest = 12;
    while (first > 0 && last - first < longest && list_.row(first - 1)[slot] == old) {
      --first;
    }
    while (last + 1 < list_.size() && last - first < longest && list_.row(last + 1)[slot] == old) {
      ++last;
    }
    Element x = random_value(slot);
    switch (random_.below(4)) {
      case 0:
        x = first > 0 ? list_.row(first - 1)[slot] : x;
        break;
      case 1:
        x = last + 1 < list_.size() ? list_.row(last + 1)[slot] : x;
        break;
      default:
        break;
    }
    if (x == old) {
      return;
    }
    for (std::size_t at = first; at <= last; ++at) {
      if (!choices_.allows(list_.row(at), x)) {
        return;
      }
    }
    const std::int64_t cost = list_.cost();
    const std::size_t missing = list_.missing();
    for (std::size_t at = first; at <= last; ++at) {
      set({at, slot}, x);
    }
    settle(cost, missing);
  }

  void try_move() {
    constexpr std::size_t longest = 4;
    const std::size_t first = any(list_.size());
    const std::size_t last = std::min(list_.size() - 1, first + any(longest));
    const std::size_t to = any(list_.size() + 1);
    if (to >= first && to <= last + 1) {
      return;
    }
    const bool turned = last > first && random_.one_in_two();
    if (accepts({list_.rise_of_move({first, last}, to, turned), 0})) {
      list_.move({first, last}, to, turned);
    }
  }

  void try_reverse() {
    std::size_t first = any(list_.size());
    std::size_t last = any(list_.size());
    if (first > last) {
      std::swap(first, last);
    }
    constexpr std::size_t few = 50;
    if (choices_.replaces() && last - first > few) {
      last = first + 1 + any(few);
    }
    if (first < last && accepts({list_.rise_of_reverse({first, last}), 0})) {
      list_.reverse({first, last});
    }
  }

  void try_erase() {
    const std::size_t at = any(list_.size());
    if (accepts(list_.rise_of_erase(at))) {
      list_.erase(at);
    }
  }

  // Inserts a copy of a set-up with one value changed.
  void try_insert() {
    if (list_.size() >= most_rows_) {
      return;
    }
    const std::size_t at = any(list_.size());
    Block row(list_.row(at).begin(), list_.row(at).end());
    const std::size_t slot = any(choices_.slots());
    const Element x = random_value(slot);
    if (choices_.allows(row, x)) {
      row[slot] = x;
    }
    if (accepts(list_.rise_of_insert(at + 1, row))) {
      list_.insert(at + 1, row);
    }
  }

  [[nodiscard]] bool is_better() const {
    if (options_.budget) {
      return !result_.setups ||
             std::pair(list_.missing(), list_.cost()) < std::pair(result_.missing, result_.cost);
    }
    return list_.missing() == 0 && (!result_.setups || list_.cost() < result_.cost);
  }

  // Records an improvement; for long lists, not at every step.
  void note() {
    if (!is_better()) {
      return;
    }
    const std::uint64_t wait = list_.size() * choices_.slots() / 8;
    if (!result_.setups || done_ >= kept_at_ + wait) {
      keep();
    }
  }

  void keep() {
    result_.setups = list_.setups();
    result_.cost = list_.cost();
    result_.missing = list_.missing();
    kept_at_ = done_;
  }

  void finish() {
    if (is_better()) {
      keep();
    }
    if (options_.budget ||
        (list_.missing() > 0 && (control_.stop_wanted() || options_.fixed_tests))) {
      return;
    }
    complete_greedily(choices_, list_, GreedyAim::cost, random_, control_);
    prune_choices(choices_, list_);
    if (is_better()) {
      keep();
    }
  }

  const ChoiceJob& choices_;
  ChoiceList list_;
  const ChoiceAnnealing& options_;
  Random& random_;
  RunControl& control_;
  ChoiceSolver solver_;
  double penalty_ = 0;
  double hot_ = 0;
  double cold_ = 0;
  double octaves_ = 0;  // from hot to cold
  double temperature_ = 1;
  double part_ = 0;  // of the schedule that is over
  std::size_t most_rows_ = 0;
  std::uint64_t done_ = 0;
  std::uint64_t kept_at_ = 0;
  std::vector<std::pair<Cell, Element>> changes_;  // with the former values
  AnnealedChoices result_;
};

}  // namespace

AnnealedChoices anneal_choices(const ChoiceJob& choices, ChoiceList list,
                               const ChoiceAnnealing& options, Random& random,
                               RunControl& control) {
  return ChoiceAnnealer(choices, std::move(list), options, random, control).run();
}

}  // namespace changeover
