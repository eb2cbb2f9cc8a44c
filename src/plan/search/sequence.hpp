// The state of the search for cheap lists of set-ups: a list, its cost and what it leaves uncovered,
// kept up to date under every move.
//
// Moves are made at once and can be taken back by their inverse, so a search makes one, looks at
// cost() and uncovered(), and keeps it or not. A move on a stretch of L set-ups costs O(L·at_once).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "changeover/plan/job.hpp"
#include "plan/job/fitting.hpp"
#include "run/random.hpp"

namespace changeover {

/// What an introduction and a test weigh in a search; not always what they cost.
struct Weights {
  std::uint64_t test = 0;
  std::vector<std::uint64_t> change;  ///< by part
  std::uint64_t unit = 1;             ///< how many millionths a weight of 1 stands for

  /// The true costs in millionths; a change that costs nothing weighs one millionth, so that no search
  /// wanders among lists of many changes. If `tests` tests could overflow, a larger unit is taken and the
  /// weights are rounded up: no list weighs less than it costs.
  static Weights of(const Job& job, std::uint64_t tests);
};

/// A run of set-ups, both ends included.
struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
};

class Sequence {
 public:
  /// Set-ups that break no constraint but may leave pairs uncovered. The job must outlive this.
  /// @throws Stopped if the scope of this thread (run/scope.hpp) wants to stop.
  Sequence(const Job& job, Weights weights, const std::vector<Block>& setups);

  [[nodiscard]] std::int64_t cost() const { return cost_; }
  [[nodiscard]] std::size_t uncovered() const { return uncovered_.size(); }
  [[nodiscard]] std::size_t size() const { return order_.size(); }
  [[nodiscard]] std::vector<Block> setups() const;
  [[nodiscard]] const Job& job() const { return *job_; }
  [[nodiscard]] const Weights& weights() const { return weights_; }

  /// Parts that a search may move: not mounted for good, and with a needed pair or of a slot that needs some.
  [[nodiscard]] const std::vector<Element>& movable() const { return movable_; }
  [[nodiscard]] bool is_movable(Element x) const { return is_movable_[x]; }
  /// Uncovered needed pair number `index`, index < uncovered().
  [[nodiscard]] std::pair<Element, Element> uncovered_pair(std::size_t index) const;
  [[nodiscard]] std::span<const Element> setup(std::size_t at) const {
    const Place& place = places_[order_[at]];
    return {place.elements.data(), place.elements.size()};
  }
  [[nodiscard]] bool holds(std::size_t at, Element x) const {
    return bit(places_[order_[at]].bits, x);
  }
  [[nodiscard]] bool full(std::size_t at) const {
    return places_[order_[at]].elements.size() >= room_;
  }
  /// Room left over all set-ups.
  [[nodiscard]] std::uint64_t slack() const { return size() * room_ - occupied_; }
  /// Whether y may be where `leaving` goes; pass y itself if none goes.
  [[nodiscard]] bool may_join(std::size_t at, Element y, Element leaving) const;
  /// Whether the slot of x has a part to spare here.
  [[nodiscard]] bool may_leave(std::size_t at, Element x) const {
    return !fitting_.has_slots() || has_to_spare(places_[order_[at]], x);
  }
  /// Whether the slot of y has no place left here.
  [[nodiscard]] bool slot_full(std::size_t at, Element y) const {
    return fitting_.has_slots() && !has_place(places_[order_[at]], y);
  }
  [[nodiscard]] const Fitting& fitting() const { return fitting_; }

  /// Exchanges x and y in a stretch whose set-ups hold exactly one of them, where may_join() allows it. Its
  /// own inverse.
  void exchange(Stretch where, Element x, Element y);
  /// Adds y to set-ups that have room for it and lack it; the inverse of remove().
  void add(Stretch where, Element y);
  void remove(Stretch where, Element y);
  /// Takes out a set-up and returns a handle by which put_back() inserts it again, before position `at`.
  [[nodiscard]] std::uint32_t take_out(std::size_t at);
  void put_back(std::size_t at, std::uint32_t handle);
  /// A new set-up before position `at`; forget() frees the handle of one that was taken out for good.
  void insert(std::size_t at, std::span<const Element> setup);
  void forget(std::uint32_t handle) { free_.push_back(handle); }
  /// Reverses a stretch; its own inverse.
  void reverse(Stretch where);
  /// What reverse() would add to the cost. O(at_once).
  [[nodiscard]] std::int64_t rise_of_reverse(Stretch where) const;
  /// Swaps two adjacent stretches [first, middle) and [middle, end).
  void rotate(std::size_t first, std::size_t middle, std::size_t end);
  /// What rotate() would add to the cost. O(at_once).
  [[nodiscard]] std::int64_t rise_of_rotate(std::size_t first, std::size_t middle,
                                            std::size_t end) const;

 private:
  using Bits = std::vector<std::uint64_t>;
  struct Place {
    Block elements;
    Bits bits;
    std::int64_t weight = 0;             // of all changes that mount it on an empty bench
    std::vector<std::uint32_t> of_slot;  // by slot of the job: its parts here; empty without slots
  };

  static bool bit(const Bits& bits, Element x) { return (bits[x >> 6] >> (x & 63) & 1) != 0; }
  [[nodiscard]] bool has_to_spare(const Place& place, Element x) const {
    const std::size_t s = fitting_.slot(x);
    return s == fitting_.slots() || place.of_slot[s] > fitting_.least(s);
  }
  [[nodiscard]] bool has_place(const Place& place, Element y) const {
    const std::size_t s = fitting_.slot(y);
    return s == fitting_.slots() || place.of_slot[s] < fitting_.most(s);
  }
  [[nodiscard]] const Place& place_before(std::size_t at) const {
    return at == 0 ? start_ : places_[order_[at - 1]];
  }
  /// Weight of the introductions from one set-up to the next.
  [[nodiscard]] std::int64_t step(const Place& from, const Place& to) const;
  [[nodiscard]] std::int64_t step_into(std::size_t at) const {
    return at >= size() ? 0 : step(place_before(at), places_[order_[at]]);
  }
  /// Weight of the introductions of x from position `first` to `last` + 1.
  [[nodiscard]] std::int64_t introductions(Element x, Stretch where) const;
  void put(Place& place, Element y);
  void drop(Place& place, Element x);
  void cover(Element x, Element y);
  void uncover(Element x, Element y);
  void cover_all(const Place& place);
  void uncover_all(const Place& place);
  [[nodiscard]] std::size_t pair_index(Element x, Element y) const {
    return x < y ? std::size_t{y} * parts_ + x : std::size_t{x} * parts_ + y;
  }

  const Job* job_;
  Fitting fitting_;
  Weights weights_;
  std::size_t parts_;
  std::size_t room_;
  bool one_weight_ = false;
  bool has_never_ = false;
  std::vector<Bits> never_;  // by part, if there are forbidden pairs
  std::vector<Element> movable_;
  std::vector<bool> is_movable_;
  std::vector<Place> places_;
  std::vector<std::uint32_t> free_;
  std::vector<std::uint32_t> order_;
  Place start_;
  std::vector<std::uint32_t> count_;  // by pair: set-ups that hold it, and one if it is not needed
  std::vector<std::uint32_t> uncovered_, place_;
  std::int64_t cost_ = 0;
  std::uint64_t occupied_ = 0;
};

}  // namespace changeover
