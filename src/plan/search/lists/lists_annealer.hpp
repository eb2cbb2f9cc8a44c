// One annealing run over lists of set-ups on one bench or several: its moves and their acceptance.
//
// For the least cost and the least makespan, temperature and penalty are measured
// (plan/search/anneal/cooling.hpp). For the most weight, and for replacement costs, the penalty is
// fixed at the start, and moves are wider.
//
// The moves of plan/search/anneal/anneal.cpp have the same names but work differently: there the
// effect of a move on one list of pairs is computed first; here a move is made, evaluated by the
// objective, and undone if it is refused. On one list of pairs that makes less than half of the
// moves in the same time, and lists that cost more (bench/README.md, Run sheets against plain
// annealing).
#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "changeover/run/control.hpp"
#include "plan/search/anneal/cooling.hpp"
#include "plan/search/lists/lists.hpp"
#include "plan/search/lists/lists_search.hpp"
#include "run/random.hpp"

namespace changeover {

/// The order of states: lexicographic, smaller is better.
using Rank = std::tuple<std::uint64_t, std::int64_t, std::int64_t>;

/// Nullopt for a state that is no solution: something has not met, or the budget is exceeded.
[[nodiscard]] std::optional<Rank> rank_of(const Lists& lists, const ListsSearch& options);

/// Temperatures and penalties. With a penalty they are in the unit of the weights; otherwise in the
/// cost of a target that meets.
struct ListsSchedule {
  double penalty = 0;  ///< per millionth of weight, if it is fixed
  double hot = 0;
  double cold = 0;
  double over = 0;  ///< factor for costs above the budget
  /// The schedule ends after this time, even if steps are left.
  std::optional<std::chrono::duration<double>> time = {};
};

class ListsAnnealer {
 public:
  ListsAnnealer(Lists& lists, const ListsSearch& options, const ListsSchedule& schedule,
                Random& random);

  /// Returns the number of moves.
  std::uint64_t run(std::uint64_t steps, RunControl& control);

  [[nodiscard]] const std::optional<Rank>& best_rank() const { return best_rank_; }
  [[nodiscard]] const BenchLists& best() const { return best_; }

 private:
  [[nodiscard]] double energy() const;
  [[nodiscard]] double costs(const Lists::Rise& rise) const;
  [[nodiscard]] double least_energy(const Lists::Rise& rise) const;
  [[nodiscard]] bool refuses(double now);
  [[nodiscard]] bool refuses_unseen(const Lists::Rise& rise);
  void cool(double done);
  void record();
  void decide();
  void try_replacing(Spot where, Element out, Element in);
  std::size_t below(std::size_t limit) { return random_->below(static_cast<std::uint32_t>(limit)); }
  Spot some_spot() { return lists_->spot(below(lists_->tests())); }
  Element some_part() { return lists_->movable()[below(lists_->movable().size())]; }
  Element some_part_of(Spot where, std::span<const Element> staying);
  Element some_place_for(Element in, Spot where, std::span<const Element> staying);
  Element some_difference(std::span<const Element> in, Spot lacks, std::size_t bench);
  [[nodiscard]] std::optional<Spot> some_holder(std::span<const Element> parts);
  [[nodiscard]] std::vector<Element> some_target();
  [[nodiscard]] bool has_room(Spot where) const {
    return lists_->setup(where).size() < lists_->job(where.bench).room();
  }
  [[nodiscard]] bool replaceable(Spot where, Element out, Element in) const;
  void move();
  void move_widely();
  void shift();
  void replace_one();
  void replace_one_aimed();
  void exchange();
  void exchange_aimed();
  void replace_around(Spot where, Element out, Element in);
  void change_run();
  void take_out();
  void copy();
  void insert();
  bool bring(std::size_t bench, Block& setup, Element x, const std::vector<Element>& target);
  void reverse();
  void relocate();

  Lists* lists_;
  const ListsSearch* options_;
  ListsSchedule schedule_;
  Random* random_;
  std::size_t most_tests_;
  double everything_;  // what has to meet, as a number of targets of weight 1
  bool wide_;          // fixed penalty and wide moves
  Cooling cooling_;
  double penalty_ = 0;  // per millionth of weight
  double energy_ = 0;
  std::optional<double> most_rise_;  // of the move that is being decided
  std::optional<Rank> best_rank_;
  BenchLists best_;
};

}  // namespace changeover
