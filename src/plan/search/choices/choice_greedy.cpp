// Builds lists of set-ups of a model row by row.
#include <algorithm>
#include <optional>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/each.hpp"
#include "plan/search/choices/choice_search.hpp"

namespace changeover {
namespace {

class ChoiceGreedy {
 public:
  ChoiceGreedy(const ChoiceJob& choices, ChoiceList& list, GreedyAim aim, Random& random,
               RunControl& control)
      : choices_(choices),
        list_(list),
        aim_(aim),
        random_(random),
        control_(control),
        solver_(choices.job()),
        gains_(choices.parts()) {}

  void run() {
    while (list_.missing() > 0) {
      best_value_ = -1;
      if (control_.stop_wanted()) {  // one try per row: the list is complete soon, though not short
        improve(with_missing());
        list_.insert(list_.size(), best_);
        continue;
      }
      const std::size_t tries = aim_ == GreedyAim::tests ? many_tries : few_tries;
      for (std::size_t i = 0; i < tries; ++i) {
        if (i == 0 && list_.size() > 0) {
          improve(Block(list_.row(list_.size() - 1).begin(), list_.row(list_.size() - 1).end()));
        } else {
          improve(with_missing());
        }
      }
      list_.insert(list_.size(), best_);
    }
  }

 private:
  static constexpr std::size_t few_tries = 3;
  static constexpr std::size_t many_tries = 6;

  // A set-up that tests a missing tuple, similar to the last one, or to any, if that is easy.
  Block with_missing() {
    Element parts[3];
    choices_.parts_of(
        list_.missing_tuple(random_.below(static_cast<std::uint32_t>(list_.missing()))), parts);
    Block liked;
    if (list_.size() > 0 && aim_ == GreedyAim::cost) {
      liked.assign(list_.row(list_.size() - 1).begin(), list_.row(list_.size() - 1).end());
    } else {
      for (std::size_t s = 0; s < choices_.slots(); ++s) {
        const std::vector<Element>& values = choices_.values(s);
        liked.push_back(values[random_.below(static_cast<std::uint32_t>(values.size()))]);
      }
    }
    RunControl undisturbed({});
    const RunScope scope(undisturbed);
    auto setup = solver_.testing({parts, choices_.tuple_size()}, liked);
    if (!setup) {
      throw InternalError("what must meet cannot");
    }
    return *std::move(setup);
  }

  // The number of missing tuples of x with the row, outside its own parameter.
  [[nodiscard]] std::int64_t gain(const Block& row, std::size_t hiding, Element x) const {
    const std::size_t own = choices_.slot(x);
    const bool hidden = hiding < row.size() && hiding != own;
    std::int64_t found = 0;
    for (std::size_t s = 0; s < row.size(); ++s) {
      if (s == own) {
        continue;
      }
      if (!choices_.triples()) {
        found += (!hidden || s == hiding) && list_.is_missing(choices_.pair(x, row[s])) ? 1 : 0;
        continue;
      }
      for (std::size_t t = 0; t < s; ++t) {
        found += t != own && (!hidden || s == hiding || t == hiding) &&
                         list_.is_missing(choices_.triple(x, row[s], row[t]))
                     ? 1
                     : 0;
      }
    }
    return found;
  }

  [[nodiscard]] std::int64_t price_of(const Block& row) const {
    auto cost = static_cast<std::int64_t>(choices_.weights().test);
    for (std::size_t s = 0; s < row.size(); ++s) {
      const Element before =
          list_.size() > 0 ? list_.row(list_.size() - 1)[s] : choices_.start()[s];
      cost += choices_.price(before, row[s]);
    }
    return std::max<std::int64_t>(cost, 1);
  }

  [[nodiscard]] std::size_t hiding_slot(const Block& row) const {
    return static_cast<std::size_t>(
        std::ranges::find_if(row, [&](Element x) { return choices_.hides(x); }) - row.begin());
  }

  // Makes the best changes to the row, one after another, and returns the best state. A value that
  // hides the others stays.
  void improve(Block row) {
    const std::size_t hiding = hiding_slot(row);
    count_gains(row, hiding);
    std::int64_t brings = sum_of<std::int64_t>(row, [&](const Element x) { return gains_[x]; });
    brings = hiding < row.size() ? gains_[row[hiding]]
                                 : brings / static_cast<std::int64_t>(choices_.tuple_size());
    compare(row, brings);
    for (std::size_t step = 0; step < 2 * row.size(); ++step) {
      const Element best = best_change(row, hiding);
      if (best == no_choice) {
        break;
      }
      const Element old = std::exchange(row[choices_.slot(best)], best);
      brings += gains_[best] - gains_[old];
      recount_gains(row, hiding, old, best);
      compare(row, brings);
    }
  }

  void count_gains(const Block& row, std::size_t hiding) {
    for (std::size_t s = 0; s < row.size(); ++s) {
      for (const Element x : choices_.values(s)) {
        gains_[x] = gain(row, hiding, x);
      }
    }
  }

  void recount_gains(const Block& row, std::size_t hiding, Element old, Element now) {
    if (choices_.triples() || hiding < row.size()) {
      count_gains(row, hiding);
      return;
    }
    for (Element x = 0; x < choices_.parts(); ++x) {
      if (choices_.slot(x) != choices_.slot(now)) {
        gains_[x] += (list_.is_missing(choices_.pair(x, now)) ? 1 : 0) -
                     (list_.is_missing(choices_.pair(x, old)) ? 1 : 0);
      }
    }
  }

  // One of the best changes, at random.
  Element best_change(const Block& row, std::size_t hiding) {
    std::int64_t most = 0;
    std::uint32_t ties = 0;
    Element best = no_choice;
    for (std::size_t s = 0; s < row.size(); ++s) {
      if (s == hiding) {
        continue;
      }
      for (const Element x : choices_.values(s)) {
        const std::int64_t more = gains_[x] - gains_[row[s]];
        if (more < most || more <= 0 || choices_.hides(x)) {
          continue;
        }
        ties = more > most ? 0 : ties;
        if ((more > most || random_.below(++ties) == 0) && choices_.allows(row, x)) {
          best = x;
          most = more;
        }
      }
    }
    return best;
  }

  void compare(const Block& row, std::int64_t brings) {
    if (brings == 0) {
      return;
    }
    const double value = static_cast<double>(brings) /
                         (aim_ == GreedyAim::cost ? static_cast<double>(price_of(row)) : 1.0);
    if (value > best_value_) {
      best_value_ = value;
      best_ = row;
    }
  }

  const ChoiceJob& choices_;
  ChoiceList& list_;
  GreedyAim aim_;
  Random& random_;
  RunControl& control_;
  ChoiceSolver solver_;
  std::vector<std::int64_t> gains_;  // by part, for the current row
  Block best_;
  double best_value_ = -1;
};

}  // namespace

void complete_greedily(const ChoiceJob& choices, ChoiceList& list, GreedyAim aim, Random& random,
                       RunControl& control) {
  if (list.missing() == 0) {
    return;
  }
  std::optional<ChoiceGreedy> greedy;
  {
    RunControl undisturbed({});
    const RunScope without_limit(undisturbed);
    greedy.emplace(choices, list, aim, random, control);
  }
  greedy->run();
}

void prune_choices(const ChoiceJob& choices, ChoiceList& list) {
  for (std::size_t at = list.size(); at-- > 0;) {
    if (list.tested_only_by(at) > 0) {
      continue;
    }
    const std::int64_t cost = list.cost();
    const Block row(list.row(at).begin(), list.row(at).end());
    list.erase(at);
    if (list.cost() > cost) {
      list.insert(at, row);
    }
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t at = 0; at < list.size(); ++at) {
      for (std::size_t slot = 0; slot < choices.slots(); ++slot) {
        for (const std::size_t neighbour : {at - 1, at + 1}) {
          if (neighbour >= list.size()) {
            continue;
          }
          const Element x = list.row(neighbour)[slot];
          if (x == list.row(at)[slot] || !choices.allows(list.row(at), x)) {
            continue;
          }
          const Rise rise = list.rise_of_set({at, slot}, x);
          if (rise.cost < 0 && rise.uncovered <= 0) {
            list.set({at, slot}, x);
            changed = true;
          }
        }
      }
    }
  }
}

}  // namespace changeover
