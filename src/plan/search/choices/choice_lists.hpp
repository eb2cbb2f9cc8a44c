// Lists of set-ups of a model (plan/model.hpp) for searches, with cost and missing tuples updated
// by every change.
//
//     const ChoiceJob choices(job);           // tables, shared by all searches
//     ChoiceList list(choices, setups);
//     list.set(4, 2, x);                      // set-up 4 has x as its value of parameter 2
//     list.missing();                         // needed pairs, or triples, that no set-up tests
//
// Changing a cell takes O(parameters), with triples O(parameters²); and as much as a set-up if a
// value out of range is set or replaced. Adding or removing a set-up takes O(parameters²), with
// triples O(parameters³).
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "changeover/plan/job.hpp"
#include "plan/model/compiled_rules.hpp"
#include "plan/search/anneal/sequence.hpp"

namespace changeover {

/// No value: an empty place at the start.
inline constexpr Element no_choice = std::numeric_limits<Element>::max();

/// What must meet and what must not, in tables.
class ChoiceJob {
 public:
  /// Needs a job of a model, which must outlive this.
  explicit ChoiceJob(const Job& job);

  [[nodiscard]] const Job& job() const { return *job_; }
  [[nodiscard]] const Weights& weights() const { return weights_; }
  [[nodiscard]] std::size_t slots() const { return values_.size(); }
  [[nodiscard]] std::size_t parts() const { return slot_.size(); }
  [[nodiscard]] std::size_t slot(Element x) const { return slot_[x]; }
  /// The values of a parameter that a set-up may have: only the mounted one, if there is one.
  [[nodiscard]] const std::vector<Element>& values(std::size_t slot) const { return values_[slot]; }
  /// Whether a value is out of range: in a set-up with it, only its own tuples are tested.
  [[nodiscard]] bool hides(Element x) const { return any_hides_ && hides_[x] != 0; }
  [[nodiscard]] bool any_hides() const { return any_hides_; }
  [[nodiscard]] bool triples() const { return triples_; }
  [[nodiscard]] std::size_t tuple_size() const { return triples_ ? 3 : 2; }
  [[nodiscard]] std::size_t needed() const { return needed_count_; }

  /// Indices of pairs, two for each, and of triples in any order.
  [[nodiscard]] std::size_t pair(Element x, Element y) const { return x * parts() + y; }
  [[nodiscard]] std::size_t triple(Element x, Element y, Element z) const;
  [[nodiscard]] std::size_t tuples() const { return needed_.size(); }
  [[nodiscard]] bool is_needed(std::size_t tuple) const { return needed_[tuple] != 0; }
  /// The parts of a tuple: the first tuple_size() entries.
  void parts_of(std::size_t tuple, Element out[3]) const;

  /// Whether `row`, which breaks no rule, may have x as its value of that parameter.
  [[nodiscard]] bool allows(std::span<const Element> row, Element x) const;
  /// Whether a row breaks no rule.
  [[nodiscard]] bool allows(std::span<const Element> row) const;
  /// The start as a row, with no_choice for parameters without a value.
  [[nodiscard]] const std::vector<Element>& start() const { return start_; }
  /// The cost of setting a value where another one, or no_choice, was.
  [[nodiscard]] std::int64_t price(Element before, Element x) const {
    return before == x                               ? 0
           : replace_.empty() || before == no_choice ? static_cast<std::int64_t>(weights_.change[x])
                                                     : replace_[before * parts() + x];
  }
  /// Whether costs depend on what is replaced.
  [[nodiscard]] bool replaces() const { return !replace_.empty(); }

 private:
  const Job* job_;
  CompiledRules rules_;
  Weights weights_;
  bool triples_;
  std::vector<std::size_t> slot_;             // by part
  std::vector<std::vector<Element>> values_;  // by parameter
  std::vector<std::uint8_t> hides_;           // by part
  bool any_hides_ = false;
  std::vector<std::uint8_t> needed_;  // by tuple
  std::size_t needed_count_ = 0;
  std::vector<std::uint8_t> never_;  // by pair; empty if there are none
  std::vector<Element> start_;
  std::vector<std::int64_t> replace_;  // by part out and part in
};

/// A cell of a list.
struct Cell {
  std::size_t at = 0;
  std::size_t slot = 0;
};

class ChoiceList {
 public:
  /// Each set-up has its values in the order of the parameters.
  ChoiceList(const ChoiceJob& choices, const std::vector<Block>& setups);

  [[nodiscard]] std::size_t size() const { return order_.size(); }
  [[nodiscard]] std::span<const Element> row(std::size_t at) const {
    return {cells_.data() + order_[at] * width_, width_};
  }
  [[nodiscard]] std::int64_t cost() const { return cost_; }
  [[nodiscard]] std::size_t missing() const { return missing_.size(); }
  /// Missing tuple number `index`.
  [[nodiscard]] std::size_t missing_tuple(std::size_t index) const { return missing_[index]; }
  [[nodiscard]] bool is_missing(std::size_t tuple) const { return count_[tuple] == 0; }
  /// Whether a row hides all tuples except those with one value.
  [[nodiscard]] bool is_hidden(std::size_t at) const { return hiding_[order_[at]] != nowhere; }

  /// The change of cost and of missing tuples by setting a cell to another value.
  [[nodiscard]] Rise rise_of_set(Cell cell, Element x) const;
  void set(Cell cell, Element x);
  /// The number of tuples that only this row tests.
  [[nodiscard]] std::size_t tested_only_by(std::size_t at) const;
  /// The change of cost and of missing tuples by insert() and by erase().
  [[nodiscard]] Rise rise_of_insert(std::size_t at, std::span<const Element> row) const;
  [[nodiscard]] Rise rise_of_erase(std::size_t at) const;
  /// Inserts a row before place `at`.
  void insert(std::size_t at, std::span<const Element> row);
  void erase(std::size_t at);
  /// Moves the rows of a stretch before the row that is now at `to` (outside of the stretch), or to
  /// the end; reversed if `turned`.
  [[nodiscard]] std::int64_t rise_of_move(Stretch rows, std::size_t to, bool turned) const;
  void move(Stretch rows, std::size_t to, bool turned);
  /// Reverses the rows of a stretch.
  [[nodiscard]] std::int64_t rise_of_reverse(Stretch rows) const;
  void reverse(Stretch rows);

  [[nodiscard]] std::vector<Block> setups() const;

 private:
  static constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

  // A pair in both orders; of a triple, the same index twice.
  struct Both {
    std::size_t tuple = 0;
    std::size_t twin = 0;
  };

  [[nodiscard]] const Element* cells(std::size_t at) const {
    return cells_.data() + order_[at] * width_;
  }
  // The row before place `at`; before the first one, the start.
  [[nodiscard]] const Element* before(std::size_t at) const {
    return at > 0 ? cells(at - 1) : choices_->start().data();
  }
  [[nodiscard]] std::int64_t step_cost(const Element* before, const Element* row) const;
  // The cost of the steps within a stretch, forwards or backwards.
  [[nodiscard]] std::int64_t cost_within(Stretch rows, bool turned) const;
  [[nodiscard]] std::uint32_t hiding_in(const Element* row) const;
  template <typename Visit>
  void for_tuples(const Element* row, std::uint32_t hiding, Visit&& visit) const;
  template <typename Visit>
  void for_tuples_of(const Element* row, std::size_t slot, Element x, std::uint32_t hiding,
                     Visit&& visit) const;
  // What the step before place `at` costs more if this row is inserted there.
  [[nodiscard]] std::int64_t cost_of_insert(std::size_t at, const Element* row) const;
  [[nodiscard]] std::int64_t saved_by_erase(std::size_t at) const;
  // A tuple, and the same pair the other way round.
  void met(Both tuple);
  void lost(Both tuple);
  void count_row(const Element* row, std::uint32_t hiding, bool comes);
  [[nodiscard]] std::int64_t cost_around(Cell cell, Element x) const;

  const ChoiceJob* choices_;
  std::size_t width_;
  std::vector<Element> cells_;         // by row number
  std::vector<std::uint32_t> hiding_;  // by row number: the parameter whose value is out of range
  std::vector<std::size_t> order_;     // by place: the number of its row
  std::vector<std::size_t> free_;      // unused rows
  std::vector<std::uint32_t>
      count_;  // by tuple: number of rows that test it, far from 0 if not needed; pairs both ways
  std::vector<std::uint32_t> where_;  // by tuple: its place in missing_
  std::vector<std::size_t> missing_;  // pairs with the lower part first
  std::int64_t cost_ = 0;
};

}  // namespace changeover
