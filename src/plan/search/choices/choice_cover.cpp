// Reduces the set-ups of a model that test everything.
#include <algorithm>

#include "changeover/core/error.hpp"
#include "plan/search/choices/choice_search.hpp"

namespace changeover {
namespace {

class TestRemover {
 public:
  TestRemover(const ChoiceJob& choices, ChoiceList& list, Random& random, RunControl& control)
      : choices_(choices),
        list_(list),
        random_(random),
        control_(control),
        solver_(choices.job()) {}

  std::uint64_t run(std::size_t least, std::uint64_t moves) {
    std::vector<Block> complete = list_.setups();
    while (list_.size() > least && list_.size() > 1 && !control_.stop_wanted()) {
      erase_one();
      changed_.assign(list_.size() * choices_.slots(), 0);
      best_ = list_.missing();
      const std::uint64_t until = done_ + moves;
      while (list_.missing() > 0 && done_ < until) {
        if (done_ % between_looks == 0 && control_.stop_wanted()) {
          break;
        }
        ++done_;
        move();
      }
      if (list_.missing() > 0) {
        break;
      }
      complete = list_.setups();
    }
    if (list_.missing() > 0) {
      list_ = ChoiceList(choices_, complete);
    }
    return done_;
  }

 private:
  static constexpr std::uint64_t between_looks = 64;

  // Removes the row that tests least on its own.
  void erase_one() {
    std::size_t best = 0;
    std::size_t fewest = ~std::size_t{0};
    std::uint32_t ties = 0;
    for (std::size_t at = 0; at < list_.size(); ++at) {
      const std::size_t only = list_.tested_only_by(at);
      ties = only < fewest ? 0 : ties;
      if (only < fewest || (only == fewest && random_.below(++ties + 1) == 0)) {
        fewest = only;
        best = at;
      }
    }
    list_.erase(best);
  }

  // Puts a missing tuple into a row that has all of it but one value, at the least loss; cells that
  // were changed recently stay.
  void move() {
    Element parts[3];
    const std::size_t size = choices_.tuple_size();
    choices_.parts_of(
        list_.missing_tuple(random_.below(static_cast<std::uint32_t>(list_.missing()))), parts);
    constexpr std::uint32_t seldom = 400;
    if (random_.below(seldom) != 0 && put_at_least_loss(parts, size)) {
      return;
    }
    rebuild(parts, size);
  }

  bool put_at_least_loss(const Element* parts, std::size_t size) {
    const bool hidden_tuple =
        std::any_of(parts, parts + size, [&](Element x) { return choices_.hides(x); });
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    std::uint32_t ties = 0;
    Cell best;
    Element value = no_choice;
    for (std::size_t at = 0; at < list_.size(); ++at) {
      const std::span<const Element> row = list_.row(at);
      std::size_t lacks = 0;
      Element x = no_choice;
      for (std::size_t i = 0; i < size; ++i) {
        if (row[choices_.slot(parts[i])] != parts[i]) {
          ++lacks;
          x = parts[i];
        }
      }
      if (lacks != 1) {
        continue;
      }
      const Cell cell{at, choices_.slot(x)};
      // A row that hides the tuple does not test it, for any value.
      if (choices_.any_hides() && !hidden_tuple && list_.is_hidden(at) &&
          !choices_.hides(row[cell.slot])) {
        continue;
      }
      if (!choices_.allows(row, x)) {
        continue;
      }
      const Rise rise = list_.rise_of_set(cell, x);
      const bool improves = static_cast<std::int64_t>(list_.missing()) + rise.uncovered <
                            static_cast<std::int64_t>(best_);
      if (is_tabu(cell) && !improves) {
        continue;
      }
      ties = rise.uncovered < least ? 0 : ties;
      if (rise.uncovered < least || (rise.uncovered == least && random_.below(++ties + 1) == 0)) {
        least = rise.uncovered;
        best = cell;
        value = x;
      }
    }
    if (value == no_choice) {
      return false;
    }
    set(best, value);
    return true;
  }

  // Rewrites any row to contain all of the tuple, and values that it needs.
  void rebuild(const Element* parts, std::size_t size) {
    const std::size_t at = random_.below(static_cast<std::uint32_t>(list_.size()));
    RunControl undisturbed({});
    const RunScope scope(undisturbed);
    auto row = solver_.testing({parts, size}, list_.row(at));
    if (!row) {
      throw InternalError("what must meet cannot");
    }
    for (std::size_t s = 0; s < row->size(); ++s) {
      if (list_.row(at)[s] != (*row)[s]) {
        set({at, s}, (*row)[s]);
      }
    }
  }

  [[nodiscard]] bool is_tabu(Cell cell) const {
    return changed_[cell.at * choices_.slots() + cell.slot] > done_;
  }

  void set(Cell cell, Element x) {
    list_.set(cell, x);
    changed_[cell.at * choices_.slots() + cell.slot] = done_ + 3 + random_.below(8);
    best_ = std::min(best_, list_.missing());
  }

  const ChoiceJob& choices_;
  ChoiceList& list_;
  Random& random_;
  RunControl& control_;
  ChoiceSolver solver_;
  std::vector<std::uint64_t> changed_;  // by cell: the move until which it stays
  std::size_t best_ = 0;                // fewest missing tuples with this number of rows
  std::uint64_t done_ = 0;
};

}  // namespace

std::uint64_t remove_tests(const ChoiceJob& choices, ChoiceList& list, std::size_t least,
                           std::uint64_t moves, Random& random, RunControl& control) {
  return TestRemover(choices, list, random, control).run(least, moves);
}

}  // namespace changeover
