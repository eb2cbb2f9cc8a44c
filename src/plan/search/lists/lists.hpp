// The state of the search for lists of set-ups on one bench or several, in which pairs or triples
// of parts have to meet: the lists, their costs, and the weight of what has not met, updated by
// every move.
//
// In a job of a model every set-up has one value of each parameter, in their order, and breaks no
// rule; of one with a value out of range only what has that value counts.
//
// Benches may differ in costs, room, slots and mounted parts. If parts are scarce or benches rest,
// a clock computes when everything is done, after every move, in O(tests after the first change).
//
// If costs depend on what is replaced, the cost of a step with j changes takes O(j³). For one list
// in which all pairs have the same weight and costs do not depend on replacement,
// plan/search/anneal/sequence.hpp does the same faster.
//
// Moves are recorded: keep() drops the records, undo() undoes all moves since. Adding or removing a
// part takes O(room) for pairs and O(room²) for triples; moving a set-up as a whole takes O(room).
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "changeover/plan/job.hpp"
#include "plan/job/fitting.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/search/anneal/sequence.hpp"
#include "plan/search/benches/bench_clock.hpp"
#include "plan/search/lists/value_rules.hpp"

namespace changeover {

/// The set-ups of each bench, in order.
using BenchLists = std::vector<std::vector<Block>>;

/// No part.
inline constexpr Element no_part = std::numeric_limits<Element>::max();

/// The place of a set-up.
struct Spot {
  std::size_t bench = 0;
  std::size_t at = 0;
};

/// Weights::of() for several jobs, with a common unit.
[[nodiscard]] std::vector<Weights> weights_of(const std::vector<const Job*>& jobs,
                                              std::uint64_t tests);

/// Scarce parts, and hours per day.
struct ClockRules {
  std::vector<std::uint64_t> quantity;    ///< by part
  std::vector<std::vector<bool>> shared;  ///< by bench and part: scarce, and not the bench's own
  std::vector<std::uint64_t> hours;       ///< by bench, in millionths; 0: it never rests
  std::uint64_t day = 0;                  ///< in millionths
  std::vector<std::vector<Block>> first = {};  ///< by bench: set-ups before its list
  std::vector<Block> start = {};               ///< by bench: mounted before these
};

/// The task of a search for lists: what must meet, and the benches. The data must outlive the
/// lists.
struct ListsJob {
  const Job* common = nullptr;  ///< defines needed pairs, triples, weights and forbidden pairs
  std::vector<const Job*> jobs = {};     ///< by bench; equal benches share one
  std::vector<Weights> weights = {};     ///< by bench
  std::vector<std::int64_t> spent = {};  ///< by bench: cost before its list; empty: 0
  const ClockRules* clock = nullptr;     ///< null if no bench waits or rests
  /// The rules of the model of the jobs; null for other jobs.
  std::shared_ptr<const CompiledRules> rules = {};
  /// In place of the clock: scarce parts may be on two benches at a time, but overlap() counts it.
  bool overlaps = false;

  /// A task for `benches` equal benches.
  static ListsJob alike(const Job& job, const Weights& weights, std::size_t benches);
};

class Lists {
 public:
  /// Starts with set-ups that break no constraint but may leave something unmet. Every bench begins
  /// with the start of its job. The job must outlive this. @throws Stopped if the scope of this
  /// thread (run/control.hpp) requests it.
  Lists(const ListsJob& job, const BenchLists& lists);
  /// For equal benches.
  Lists(const Job& job, const Weights& weights, const BenchLists& lists)
      : Lists(ListsJob::alike(job, weights, lists.size()), lists) {}
  Lists(const Lists&) = delete;
  Lists& operator=(const Lists&) = delete;
  Lists(Lists&&) = default;
  Lists& operator=(Lists&&) = default;

  /// Whether the parts are values of a model.
  [[nodiscard]] bool of_model() const { return job_->model != nullptr; }
  [[nodiscard]] const ValueRules& values(std::size_t bench) const { return view(bench).values; }
  /// The job that says what has to meet.
  [[nodiscard]] const Job& job() const { return *job_; }
  [[nodiscard]] const Job& job(std::size_t bench) const { return *view(bench).job; }
  [[nodiscard]] const Fitting& fitting(std::size_t bench) const { return view(bench).fitting; }
  /// The largest number of parts in a set-up of any bench.
  [[nodiscard]] std::uint64_t most_room() const { return most_room_; }
  /// Whether the same set-ups are allowed on both benches.
  [[nodiscard]] bool alike(std::size_t bench, std::size_t other) const {
    return view_of_[bench] == view_of_[other];
  }
  /// Whether a set-up is allowed on this bench.
  [[nodiscard]] bool allows(std::size_t bench, std::span<const Element> setup) const;
  [[nodiscard]] std::size_t benches() const { return order_.size(); }
  [[nodiscard]] std::size_t tests(std::size_t bench) const { return order_[bench].size(); }
  [[nodiscard]] std::size_t tests() const { return tests_; }
  /// The place of set-up number `index` of all benches, index < tests().
  [[nodiscard]] Spot spot(std::size_t index) const;
  /// The cost of all benches, including parts that are put in again.
  [[nodiscard]] std::int64_t total() const { return total_ + (clock_ ? clocked().again : 0); }
  /// The cost of the tests and changes of all benches.
  [[nodiscard]] std::int64_t work() const { return total_; }
  /// The makespan: the largest cost of a bench, if no bench waits or rests.
  [[nodiscard]] std::int64_t largest() const;
  [[nodiscard]] bool has_clock() const { return clock_.has_value(); }
  /// The end of the last test of a bench: its cost, if no bench waits or rests.
  [[nodiscard]] std::int64_t end(std::size_t bench) const {
    return clock_ ? clocked().ends[bench] : cost_[bench];
  }
  /// With ListsJob::overlaps: for how long parts of which there is one are on two benches at a
  /// time, if no bench waits. Moves leave the times of other tests as they are, until retime().
  [[nodiscard]] std::int64_t overlap() const { return overlap_; }
  void retime();
  /// The weight of what has not met, in millionths; 1 each by default.
  [[nodiscard]] std::uint64_t missing() const { return missing_; }
  [[nodiscard]] std::size_t open() const { return open_.size(); }
  /// What has not met, number index < open(): the last part is `no_part` for a pair.
  [[nodiscard]] std::array<Element, 3> open_target(std::size_t index) const;
  [[nodiscard]] bool of_triples() const { return triples_; }
  [[nodiscard]] const std::vector<Element>& movable() const { return movable_; }
  [[nodiscard]] bool is_movable(std::size_t bench, Element x) const {
    return is_movable_[x] && !view(bench).stays[x];
  }
  [[nodiscard]] std::span<const Element> setup(Spot where) const {
    return places_[order_[where.bench][where.at]].elements;
  }
  [[nodiscard]] bool holds(Spot where, Element x) const {
    return bit(places_[order_[where.bench][where.at]].bits, x);
  }
  /// The parts mounted before this set-up, which may be after the last one of its bench.
  [[nodiscard]] std::span<const Element> before_setup(Spot where) const {
    return before(where).elements;
  }
  /// Whether x was among them.
  [[nodiscard]] bool was_there(Spot where, Element x) const { return bit(before(where).bits, x); }
  [[nodiscard]] BenchLists lists() const;
  /// The part of a set-up, or of what is mounted at the start, of the slot of x; `no_part` if there
  /// is none.
  [[nodiscard]] Element rival_in(std::span<const Element> setup, Element x) const;
  /// Whether a set-up stays valid if `out` is removed and `in` added; `no_part` for neither.
  [[nodiscard]] bool may_replace(Spot where, Element out, Element in) const;
  /// Whether y may be together with all parts of a set-up.
  [[nodiscard]] bool joins(std::span<const Element> setup, Element y) const;

  /// Whether moves are evaluated before they are made: where pairs must meet, and costs do not
  /// depend on what is replaced, unless by parameters of a model.
  [[nodiscard]] bool foresees() const {
    return !triples_ && (of_model() || views_.front().replace.empty());
  }
  /// What the work of a bench, that of another and missing() would become more by a move, if
  /// foresees().
  struct Rise {
    std::size_t bench = 0;
    std::int64_t work = 0;
    std::int64_t missing = 0;
    std::size_t other = 0;
    std::int64_t other_work = 0;
    std::int64_t overlap = 0;
  };
  [[nodiscard]] Rise rise_of_replace(Spot where, Element out, Element in) const;
  [[nodiscard]] Rise rise_of_take_out(Spot where) const;
  [[nodiscard]] Rise rise_of_reverse(std::size_t bench, Stretch where) const;
  /// The rise by move(), and by reverse() there after it.
  [[nodiscard]] Rise rise_of_move(Spot from, std::size_t count, Spot to, bool reversed) const;

  /// Removes `out`, which is there, and adds `in`, which is not, where may_replace() allows it.
  void replace(Spot where, Element out, Element in);
  void take_out(Spot where);
  /// Inserts a set-up before this place.
  void insert(Spot where, std::span<const Element> setup);
  /// Moves `count` set-ups from `from` on before `to`, a place among the remaining ones.
  void move(Spot from, std::size_t count, Spot to);
  void reverse(std::size_t bench, Stretch where);
  void keep();
  void undo();

 private:
  using Bits = std::vector<std::uint64_t>;
  struct Place {
    Block elements;
    Bits bits;
    std::int64_t cost = 0;   // of the step into it, including its test
    std::int64_t begin = 0;  // for overlap()
    std::int64_t end = 0;
  };
  // A bench, or several equal ones.
  struct View {
    const Job* job;
    Fitting fitting;
    Weights weights;
    std::vector<std::int64_t>
        replace;  // by part out and part in, if costs depend on what is replaced
    ValueRules values;
    std::vector<bool> stays;  // by part: permanently mounted
    Place start;              // mounted before the list
  };
  // For the clock: what precedes the lists.
  struct Before {
    Place start;
    std::vector<Place> steps;
    Bits shared;
    std::vector<Ticks> change;
  };
  enum class Kind { replaced, taken_out, inserted, detached, attached, reversed };
  struct Note {
    Kind kind;
    Spot where;
    std::uint32_t a = 0;     // removed part, a handle, or the last one of a stretch
    std::uint32_t b = 0;     // added part
    std::int64_t begin = 0;  // when what was detached began and ended
    std::int64_t end = 0;
  };

  static constexpr std::uint64_t one = 1'000'000;  // the weight of what has none, in millionths

  static bool bit(const Bits& bits, Element x) { return (bits[x >> 6] >> (x & 63) & 1) != 0; }
  [[nodiscard]] const View& view(std::size_t bench) const { return views_[view_of_[bench]]; }
  [[nodiscard]] const Place& before(Spot where) const {
    return where.at == 0 ? view(where.bench).start : places_[order_[where.bench][where.at - 1]];
  }
  [[nodiscard]] std::int64_t step(const View& view, const Place& from, const Place& to) const;
  [[nodiscard]] std::int64_t replacing_step(const View& view, const Place& from,
                                            const Place& to) const;
  // The cost of setting a value in place of another one of its parameter, or of none.
  [[nodiscard]] std::int64_t price_of(const View& view, Element out, Element in) const {
    return out == in ? 0
           : out == no_part || view.replace.empty()
               ? static_cast<std::int64_t>(view.weights.change[in])
               : view.replace[out * parts_ + in];
  }
  [[nodiscard]] std::int64_t step_of_values(const View& view, const Place& from,
                                            const Place& to) const;
  [[nodiscard]] Rise rise_of_value(Spot where, Element out, Element in) const;
  [[nodiscard]] std::int64_t weight_with_count(std::span<const Element> setup,
                                               std::uint32_t times) const;
  [[nodiscard]] std::int64_t saved_within(std::size_t bench, Stretch where) const;
  // The cost of replacing parts by others, all of one slot.
  [[nodiscard]] std::int64_t replaced(const View& view, std::span<const Element> gone,
                                      std::span<const Element> come) const;
  // The cost of mounting all of a set-up on an empty bench.
  [[nodiscard]] std::int64_t mounting(const View& view, const Place& place) const;
  void price(Spot where);
  void fill(Place& place, std::span<const Element> setup) const;
  [[nodiscard]] Place place_of(std::span<const Element> setup) const;
  void add_views(const ListsJob& job);
  void set_clock(const ListsJob& job);
  void set_overlaps(const ListsJob& job);
  // For how long other benches have scarce parts of this set-up, or this part.
  [[nodiscard]] std::int64_t overlap_of(std::size_t bench, const Place& place) const;
  [[nodiscard]] std::int64_t overlap_of(std::size_t bench, const Place& place, Element x) const;
  template <typename Number>
  [[nodiscard]] std::int64_t sum_of_overlaps(std::size_t bench, const Place& place,
                                             Number&& number) const;
  void set_time(Spot where);
  [[nodiscard]] const BenchClock::Result& clocked() const;
  void changed(Spot where);
  [[nodiscard]] static std::size_t index(Element x, Element y) {
    return x < y ? choose_two(y) + x : choose_two(x) + y;
  }
  [[nodiscard]] std::size_t index(Element x, Element y, Element z) const;
  [[nodiscard]] std::int64_t weight_of(std::size_t index) const {
    return static_cast<std::int64_t>(weight_.empty() ? one : weight_[index]);
  }
  void meet(std::size_t index);
  void part(std::size_t index);
  template <bool coming>
  void count_with(const Block& others, Element x);
  template <bool coming>
  void count_all(const Block& setup);
  [[nodiscard]] Element hiding_in(std::span<const Element> setup) const;
  void replace_value(Place& place, Element out, Element in);
  void do_replace(Spot where, Element out, Element in);
  void attach(Spot where, std::uint32_t handle, bool timed = false);
  std::uint32_t detach(Spot where);
  void do_reverse(std::size_t bench, Stretch where);
  std::uint32_t new_place(std::span<const Element> setup);

  const Job* job_;
  std::vector<View> views_;
  std::vector<std::size_t> view_of_;  // by bench
  std::uint64_t most_room_ = 0;
  std::size_t parts_;
  bool triples_;
  std::vector<bool> hides_;  // by part: out of range; empty if none is
  std::vector<Bits> never_;  // by part, if there are forbidden pairs
  std::vector<Element> movable_;
  std::vector<bool> is_movable_;
  std::vector<Place> places_;
  std::vector<std::uint32_t> free_;
  std::vector<std::vector<std::uint32_t>> order_;  // by bench
  std::vector<std::int64_t> cost_;                 // by bench
  std::int64_t total_ = 0;
  std::size_t tests_ = 0;
  std::vector<std::uint32_t>
      count_;  // by index: number of set-ups with it, plus one if it is not needed
  std::vector<std::uint32_t> place_;   // by index: place in open_
  std::vector<std::uint64_t> weight_;  // by index; empty if all weigh the same
  std::vector<std::uint32_t> open_;
  std::uint64_t missing_ = 0;
  std::vector<Note> notes_;
  std::vector<Bits> scarce_;  // by bench: the parts that overlap() is about
  std::vector<std::int64_t> spent_;
  std::int64_t overlap_ = 0;
  std::int64_t longest_ = 0;  // no test takes longer
  mutable std::optional<BenchClock> clock_;
  std::vector<Before> before_;              // by bench, if there is a clock
  mutable std::vector<std::size_t> stale_;  // by bench: steps from here on the clock does not have
  mutable bool clocked_ = false;            // the clock's result is up to date
  mutable bool clock_kept_ = false;         // the clock has kept what keep() was last called with
  Block others_;                            // scratch memory
  // Scratch memory for const functions.
  mutable Block gone_;
  mutable Block come_;
  mutable std::vector<std::int64_t> table_;
};

}  // namespace changeover
