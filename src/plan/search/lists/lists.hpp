// The state of the search for lists of set-ups on one bench or several, in which pairs or triples of parts have to meet:
// the lists, what each costs, and the weight of what has not met, kept up to date under every move.
//
// If costs ask what is replaced, a step that changes j parts takes O(j³) to price.
// Where all pairs of one list have the same weight and they do not, plan/search/anneal/sequence.hpp does the same in less time.
//
// Moves are noted as they are made: keep() forgets the notes, undo() takes back all moves since. A part that comes or goes
// costs O(room) for pairs and O(room²) for triples; moving a set-up as a whole costs O(room).
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "changeover/plan/job.hpp"
#include "plan/job/fitting.hpp"
#include "plan/search/anneal/sequence.hpp"

namespace changeover {

/// Set-ups in their order, by bench.
using BenchLists = std::vector<std::vector<Block>>;

/// No part.
inline constexpr Element no_part = std::numeric_limits<Element>::max();

/// A set-up by its place.
struct Spot {
  std::size_t bench = 0;
  std::size_t at = 0;
};

/// Weights::of(), with a unit that also suits what a change costs by what is replaced.
[[nodiscard]] Weights weights_of(const Job& job, std::uint64_t tests);

class Lists {
 public:
  /// Set-ups that break no constraint but may leave something unmet. Every bench begins with what the job has at its
  /// start. The job must outlive this. @throws Stopped if the scope of this thread (run/control.hpp) wants to stop.
  Lists(const Job& job, Weights weights, const BenchLists& lists);

  [[nodiscard]] const Job& job() const { return *job_; }
  [[nodiscard]] std::size_t benches() const { return order_.size(); }
  [[nodiscard]] std::size_t tests(std::size_t bench) const { return order_[bench].size(); }
  [[nodiscard]] std::size_t tests() const { return tests_; }
  /// Set-up number `index` of all benches, index < tests().
  [[nodiscard]] Spot spot(std::size_t index) const;
  [[nodiscard]] std::int64_t total() const { return total_; }
  [[nodiscard]] std::int64_t largest() const;
  /// The weight of what has not met, in millionths; 1 each where the job says nothing else.
  [[nodiscard]] std::uint64_t missing() const { return missing_; }
  [[nodiscard]] std::size_t open() const { return open_.size(); }
  /// What has not met, number index < open(): the last part is `no_part` if it is a pair.
  [[nodiscard]] std::array<Element, 3> open_target(std::size_t index) const;
  [[nodiscard]] bool of_triples() const { return triples_; }
  [[nodiscard]] const std::vector<Element>& movable() const { return movable_; }
  [[nodiscard]] bool is_movable(Element x) const { return is_movable_[x]; }
  [[nodiscard]] std::span<const Element> setup(Spot where) const {
    return places_[order_[where.bench][where.at]].elements;
  }
  [[nodiscard]] bool holds(Spot where, Element x) const {
    return bit(places_[order_[where.bench][where.at]].bits, x);
  }
  [[nodiscard]] BenchLists lists() const;
  [[nodiscard]] const Fitting& fitting() const { return fitting_; }
  /// Whether a set-up stays one that may be if `out` goes and `in` comes; `no_part` for neither.
  [[nodiscard]] bool may_replace(Spot where, Element out, Element in) const;
  /// Whether y may be with all parts of a set-up.
  [[nodiscard]] bool joins(std::span<const Element> setup, Element y) const;

  /// out, which is there, goes and in, which is not, comes, where may_replace() allows it.
  void replace(Spot where, Element out, Element in);
  void take_out(Spot where);
  /// A new set-up before this place.
  void insert(Spot where, std::span<const Element> setup);
  /// The set-ups from `from` on, so many, go before `to`, a place of what remains.
  void move(Spot from, std::size_t count, Spot to);
  void reverse(std::size_t bench, Stretch where);
  void keep();
  void undo();

 private:
  using Bits = std::vector<std::uint64_t>;
  struct Place {
    Block elements;
    Bits bits;
  };
  enum class Kind { replaced, taken_out, inserted, detached, attached, reversed };
  struct Note {
    Kind kind;
    Spot where;
    std::uint32_t a = 0;  // out, a handle, or the last of a stretch
    std::uint32_t b = 0;  // in
  };

  static bool bit(const Bits& bits, Element x) { return (bits[x >> 6] >> (x & 63) & 1) != 0; }
  [[nodiscard]] const Place& before(Spot where) const {
    return where.at == 0 ? start_ : places_[order_[where.bench][where.at - 1]];
  }
  [[nodiscard]] std::int64_t step(const Place& from, const Place& to) const;
  [[nodiscard]] std::int64_t replacing_step(const Place& from, const Place& to) const;
  // What it costs that some parts take the places of others, all of one slot.
  [[nodiscard]] std::int64_t replaced(std::span<const Element> gone,
                                      std::span<const Element> come) const;
  [[nodiscard]] std::int64_t step_into(Spot where) const;
  [[nodiscard]] std::size_t index(Element x, Element y) const;
  [[nodiscard]] std::size_t index(Element x, Element y, Element z) const;
  void meet(std::size_t index);
  void part(std::size_t index);
  template <bool coming>
  void count_with(const Block& others, Element x);
  template <bool coming>
  void count_all(const Block& setup);
  void add_cost(std::size_t bench, std::int64_t rise);
  void do_replace(Spot where, Element out, Element in);
  void attach(Spot where, std::uint32_t handle);
  std::uint32_t detach(Spot where);
  void do_reverse(std::size_t bench, Stretch where);
  std::uint32_t new_place(std::span<const Element> setup);

  const Job* job_;
  Fitting fitting_;
  Weights weights_;
  std::vector<std::int64_t> replace_;  // by part out and part in, if costs ask what is replaced
  std::size_t parts_;
  bool triples_;
  std::vector<Bits> never_;  // by part, if there are forbidden pairs
  std::vector<Element> movable_;
  std::vector<bool> is_movable_;
  Place start_;
  std::vector<Place> places_;
  std::vector<std::uint32_t> free_;
  std::vector<std::vector<std::uint32_t>> order_;  // by bench
  std::vector<std::int64_t> cost_;                 // by bench
  std::int64_t total_ = 0;
  std::size_t tests_ = 0;
  std::vector<std::uint32_t> count_;  // by index: set-ups that hold it, and one if it is not needed
  std::vector<std::uint32_t> place_;  // by index, in open_
  std::vector<std::uint64_t> weight_;  // by index; empty if all weigh the same
  std::vector<std::uint32_t> open_;
  std::uint64_t missing_ = 0;
  std::vector<Note> notes_;
  // Room to work for what is const.
  mutable Block gone_;
  mutable Block come_;
  mutable std::vector<std::int64_t> table_;
};

}  // namespace changeover
